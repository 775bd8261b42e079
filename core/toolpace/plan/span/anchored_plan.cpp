#include "toolpace/plan/span/anchored_plan.h"

#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
#include "toolpace/plan/block/block_profile.h"
#include "toolpace/plan/block/node_speeds.h"
#include "toolpace/plan/increasing_root.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/span/anchor_sites.h"

namespace toolpace::detail {
namespace {

/// Share of a cap by which a ramp may pass it: rounding.
constexpr double kRounding = 1e-9;
/// Sweeps of removing anchors, each followed by a scan that lets the others rise.
constexpr int kSweeps = 8;
/// Share of the time that a sweep must save for the next one to be made.
constexpr double kWorthwhile = 1e-6;
/// Repairs after a scan: caps that the risen ramps pass become anchors again.
constexpr int kRepairs = 12;
/// Removed anchors under one span, at most; each one costs a look at every other.
constexpr std::size_t kMostUnderSpan = 512;

/// What a trial to remove an anchor depends on.
struct Trial {
  double entry = -1.0, exit = -1.0, before = 0.0, after = 0.0;  ///< speeds beside it, lengths on either side
  bool operator==(const Trial&) const = default;
};

/// Which places are anchors, and how fast they are crossed.
struct Layout {
  std::vector<std::size_t> place;  ///< ascending
  std::vector<double> speed;       ///< [mm/s]
  std::vector<Span> span;          ///< from anchor i to i + 1
  std::vector<double> span_time;   ///< [s]
  std::vector<Trial> trial;        ///< of each anchor, the last one to remove it in vain
  double time = 0.0;               ///< [s]
};

template <class Law>
class AnchorPlanner {
 public:
  AnchorPlanner(const Anchors& anchors, const Monitor& monitor) : anchors_(anchors), monitor_(monitor) {}

  /// With every anchor that there may be.
  Layout run_once() {
    Layout all;
    for (std::size_t i = 0; i < anchors_.node.size(); ++i) all.place.push_back(i);
    all.trial.resize(all.place.size());
    settle(all);
    return all;
  }

  Layout run() {
    Layout best = run_once();
    for (int sweep = 0; sweep < kSweeps && !monitor_.is_cancelled(); ++sweep) {
      Layout next = remove_some(best);
      if (next.place.size() == best.place.size()) break;
      if (!settle_within_caps(next) || !(next.time < best.time * (1 + kTouch))) {
        // What the sweep found holds with the speeds that it found it for.
        next = remove_some(best);
        sum_up(next);
        if (!(next.time < best.time)) break;
        best = std::move(next);
        break;
      }
      const bool is_worthwhile = next.time < best.time * (1 - kWorthwhile);
      best = std::move(next);
      if (!is_worthwhile) break;
    }
    return best;
  }

 private:
  static Stretch stretch(const Span& s, double v0, double v1) {
    return {s.length, std::max({s.cap(), v0, v1}), v0, v1};
  }

  void sum_up(Layout& l) const {
    l.time = 0;
    l.span_time.resize(l.span.size());
    for (std::size_t i = 0; i < l.span.size(); ++i) {
      l.span_time[i] = stretch_time(stretch(l.span[i], l.speed[i], l.speed[i + 1]), l.span[i].terms);
      l.time += l.span_time[i];
    }
  }

  /// Scans the anchors' speeds.
  void settle(Layout& l) const {
    l.span.clear();
    std::vector<double> length, cap;
    std::vector<std::uint32_t> ramp;
    std::vector<Dynamics> dynamics;
    for (std::size_t i = 0; i < l.place.size(); ++i) {
      cap.push_back(anchors_.cap[l.place[i]]);
      if (i + 1 == l.place.size()) break;
      Span s = anchors_.span[l.place[i]];
      for (std::size_t p = l.place[i] + 1; p < l.place[i + 1]; ++p) s.include(anchors_.span[p]);
      cap[i] = std::min(cap[i], s.cap());
      if (i > 0) cap[i] = std::min(cap[i], l.span.back().cap());
      length.push_back(s.length);
      if (dynamics.empty() || !(dynamics.back() == s.dynamics)) dynamics.push_back(s.dynamics);
      ramp.push_back(static_cast<std::uint32_t>(dynamics.size() - 1));
      s.prepare<Law>();
      l.span.push_back(s);
    }
    l.speed = speeds_of_whole_chain<Law>({length, ramp, dynamics, terms_of<Law>(dynamics), cap});
    sum_up(l);
  }

  /// Whether the profile of a span stays below the caps of the places under it; the first one that it passes.
  std::size_t first_broken(const Stretch& s, const Drive& drive, std::size_t from, std::size_t to) {
    if (to <= from + 1) return to;
    phases_.clear();
    PhaseWriter writer(phases_);
    append_stretch<Law>(s, drive, writer);
    std::size_t k = 0;
    for (std::size_t p = from + 1; p < to; ++p) {
      const double at = anchors_.position.between(anchors_.node[from], anchors_.node[p]);
      while (k + 1 < phases_.size() && phases_[k + 1].distance <= at) ++k;
      const double cap = anchors_.cap[p] * (1 + kRounding);
      const double ends = evaluate(phases_[k], phases_[k].duration).speed;
      // Speeds rise or fall all through a phase of a ramp.
      if (std::max(phases_[k].speed, ends) <= cap) continue;
      if (speed_at(phases_[k], at) > cap) return p;
    }
    return to;
  }

  static double speed_at(const Phase& p, double distance) {
    const auto miss = [&](double t) { return evaluate(p, t).distance - distance; };
    const double at_end = miss(p.duration);
    if (at_end <= 0) return evaluate(p, p.duration).speed;
    const double at_begin = miss(0);
    if (at_begin >= 0) return p.speed;
    return evaluate(p, increasing_root(0.0, p.duration, at_begin, at_end, miss)).speed;
  }

  /// One sweep from left to right; the speeds of what remains stay as they are.
  Layout remove_some(const Layout& l) {
    Layout r;
    r.place.push_back(l.place[0]);
    r.speed.push_back(l.speed[0]);
    r.trial.push_back(l.trial[0]);
    for (std::size_t i = 0; i < l.span.size(); ++i) {
      Piece last{l.span[i], l.span_time[i], l.place[i + 1], l.speed[i + 1]};
      // Takes the anchor before this span away as long as that is no loss.
      while (r.place.size() > 1 && merge(r, last)) {
        r.place.pop_back();
        r.speed.pop_back();
        r.trial.pop_back();
        r.span.pop_back();
        r.span_time.pop_back();
      }
      r.span.push_back(last.span);
      r.span_time.push_back(last.time);
      r.place.push_back(last.to);
      r.speed.push_back(last.exit);
      r.trial.push_back(l.trial[i + 1]);
    }
    return r;
  }

  /// A span, and the anchor at its end.
  struct Piece {
    Span span;
    double time;  ///< [s]
    std::size_t to;
    double exit;  ///< [mm/s]
  };

  /// Joins the piece with the last span, if that saves time and breaks nothing.
  bool merge(Layout& r, Piece& last) {
    const std::size_t n = r.place.size(), from = r.place[n - 2];
    if (last.to - from > kMostUnderSpan || anchors_.cap[r.place[n - 1]] == 0) return false;
    const double entry = r.speed[n - 2], before = r.span_time.back() + last.time;
    const Trial trial{entry, last.exit, r.span.back().length, last.span.length};
    if (r.trial.back() == trial) return false;
    Span merged = r.span.back();
    merged.include(last.span);
    const bool may_fit =
        merged.cap() >= std::max(entry, last.exit) && merged.length <= before * merged.cap() * (1 + kTouch);
    if (may_fit) merged.prepare<Law>();
    if (may_fit && fits(entry, last.exit, merged.length, merged.terms)) {
      const Stretch s = stretch(merged, entry, last.exit);
      const double time = stretch_time(s, merged.terms);
      if (time <= before * (1 + kTouch) && first_broken(s, merged.drive(), from, last.to) == last.to) {
        last.span = merged;
        last.time = time;
        return true;
      }
    }
    r.trial.back() = trial;
    return false;
  }

  /// Scans, and brings anchors back whose caps are passed then; false where that has no end.
  bool settle_within_caps(Layout& l) {
    for (int round = 0; round < kRepairs; ++round) {
      settle(l);
      std::vector<std::size_t> place;
      std::vector<Trial> trial;
      for (std::size_t i = 0; i < l.span.size(); ++i) {
        place.push_back(l.place[i]);
        trial.push_back(l.trial[i]);
        const Stretch s = stretch(l.span[i], l.speed[i], l.speed[i + 1]);
        const std::size_t broken = first_broken(s, l.span[i].drive(), l.place[i], l.place[i + 1]);
        if (broken == l.place[i + 1]) continue;
        place.push_back(broken);
        trial.emplace_back();
      }
      place.push_back(l.place.back());
      trial.push_back(l.trial.back());
      if (place.size() == l.place.size()) return true;
      l.place = std::move(place);
      l.trial = std::move(trial);
    }
    return false;
  }

  const Anchors& anchors_;
  const Monitor& monitor_;
  std::vector<Phase> phases_;
};

template <class Law>
MotionPlan write_plan(const Anchors& anchors, const Layout& l) {
  MotionPlan plan;
  PhaseWriter writer(plan.phases);
  for (std::size_t i = 0; i < l.span.size(); ++i) {
    const double cap = std::max({l.span[i].cap(), l.speed[i], l.speed[i + 1]});
    writer.count_from(anchors.node[l.place[i]]);
    append_stretch<Law>({l.span[i].length, cap, l.speed[i], l.speed[i + 1]}, l.span[i].drive(), writer);
  }
  return plan;
}

}  // namespace

MotionPlan plan_anchored_ramps(const SpeedLimits& limits, const std::vector<double>& cap, const AnchoredLaw& anchored,
                               const Monitor& monitor) {
  const Anchors anchors = find_anchors(limits, cap, anchored.seam_ratio);
  return visit_law(anchored.law, [&](auto chosen) {
    using Law = decltype(chosen);
    AnchorPlanner<Law> planner(anchors, monitor);
    const Layout l = anchored.may_remove ? planner.run() : planner.run_once();
    return monitor.is_cancelled() ? MotionPlan{} : write_plan<Law>(anchors, l);
  });
}

std::vector<double> settle_seams(const SpeedLimits& limits, const std::vector<double>& cap, double seam_ratio) {
  const Monitor monitor;
  const Anchors anchors = find_anchors(limits, cap, seam_ratio);
  const Layout l = AnchorPlanner<SevenPhase>(anchors, monitor).run_once();
  std::vector<double> settled = cap;
  for (std::size_t p = 0; p < l.place.size(); ++p) {
    const std::size_t node = anchors.node[l.place[p]];
    if (node > 0 && node < limits.size() && is_seam(limits, node, seam_ratio)) settled[node] = l.speed[p];
  }
  return settled;
}

}  // namespace toolpace::detail
