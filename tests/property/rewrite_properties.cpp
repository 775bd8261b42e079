/// Random programs of chords, curves and events, written again: the same path within the tolerance, the same events.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case_count.h"
#include "frechet.h"
#include "random_numbers.h"
#include "toolpace/nc/reader.h"
#include "toolpace/path/build_path.h"
#include "toolpace/rewrite/rewrite.h"

namespace toolpace {
namespace {

using namespace testing;

/// Writes curves as CAM does, in chords, with what stands between them.
class ChordProgram {
 public:
  explicit ChordProgram(Random& random) : random_(random), inch_(one_in(random, 4)), spaced_(!one_in(random, 4)) {
    text_ = fmt::format("{} G90 G94 G1{}\nF{}\n", inch_ ? "G20" : "G21", plane_ = 7 + static_cast<int>(random() % 3),
                        inch_ ? 40 : 1200);
    noise_ = one_in(random, 2) ? 0.0 : spread(random, 1e-4, 0.02);
  }

  void add() {
    switch (random_() % 12) {
      case 0: text_ += "G0 " + go(10 * random_step(), 0.0, 0.0) + "\n"; break;
      case 1: text_ += fmt::format("G4 P{:.2f}\n", between(random_, 0, 0.1)); break;
      case 2: text_ += one_in(random_, 2) ? "M3 S1000\n" : "M8 (on)\n"; break;
      case 3: text_ += fmt::format("F{:.0f}\n", between(random_, 100, 2000)); break;
      case 4: text_ += fmt::format("G1{}\n", plane_ = 7 + static_cast<int>(random_() % 3)); break;
      case 5: text_ += "T1 M6\n"; break;
      case 6: arc(); break;
      default: curve(); break;
    }
  }

  std::string finish() { return text_ + "M2\n"; }

 private:
  double random_step() { return spread(random_, 0.02, 1); }

  std::string words(bool all) {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
      const double rounded = std::round(at_[axis] * (inch_ ? 1e5 : 1e4) / unit()) / (inch_ ? 1e5 : 1e4);
      if (!all && rounded == written_[axis]) continue;
      written_[axis] = rounded;
      if (!text.empty() && spaced_) text += ' ';
      text += fmt::format("{}{:.{}f}", "XYZ"[axis], rounded, inch_ ? 5 : 4);
    }
    return text;
  }
  double unit() const { return inch_ ? 25.4 : 1.0; }
  std::string go(double u, double v, double w) {
    const int first = plane_ == 7 ? 0 : plane_ == 8 ? 2 : 1;
    at_[first] += u, at_[(first + 1) % 3] += v, at_[(first + 2) % 3] += w;
    return words(true);
  }

  /// Chords along a curve whose curvature and slope change with the way.
  void curve() {
    const double step = random_step(), bend = spread(random_, 0.002, 1) * (one_in(random_, 2) ? 1 : -1);
    const double more = between(random_, -1, 1) * 0.01, rise = one_in(random_, 2) ? 0.0 : between(random_, -0.3, 0.3);
    const double straight = one_in(random_, 4) ? 0.0 : 1.0;
    for (std::size_t k = 0, count = 3 + random_() % 60; k < count; ++k) {
      const double length = step * between(random_, 0.7, 1.3);
      heading_ += straight * length * (bend + more * static_cast<double>(k));
      const auto off = [&] { return between(random_, -1, 1) * noise_; };
      at_[0] += length * std::cos(heading_) + off();
      at_[1] += length * std::sin(heading_) + off();
      at_[2] += length * rise + off();
      const std::string text = words(false);
      if (text.empty()) continue;
      text_ += fmt::format("{}{}{}\n", k == 0 || one_in(random_, 20) ? (spaced_ ? "G1 " : "G1") : "", text,
                           one_in(random_, 60) ? fmt::format(" F{:.0f}", between(random_, 100, 2000)) : "");
      if (one_in(random_, 100)) text_ += "(here)\n";
      if (one_in(random_, 40)) heading_ += between(random_, -2, 2);
    }
  }

  void arc() {
    const int first = plane_ == 7 ? 0 : plane_ == 8 ? 2 : 1, second = (first + 1) % 3;
    words(true);
    for (std::size_t k = 0, count = 1 + random_() % 6; k < count; ++k) {
      const double radius = spread(random_, 0.2, 20), from = between(random_, -3, 3), sweep = spread(random_, 0.05, 3);
      const double p = -radius * std::cos(from), q = -radius * std::sin(from);
      at_[first] = written_[first] * unit() + p + radius * std::cos(from + sweep);
      at_[second] = written_[second] * unit() + q + radius * std::sin(from + sweep);
      const char letters[] = {"IJK"[first], "IJK"[second]};
      const std::string end = words(true);
      text_ += fmt::format("G3 {} {}{:.5f} {}{:.5f}\n", end, letters[0], p / unit(), letters[1], q / unit());
    }
  }

  Random& random_;
  bool inch_, spaced_;
  int plane_ = 7;
  double noise_ = 0.0, heading_ = 0.0;
  double at_[3] = {0, 0, 0}, written_[3] = {0, 0, 0};
  std::string text_;
};

bool feeds(const Moves& moves, std::size_t row) {
  return moves.kind[row] == MoveKind::feed || moves.kind[row] == MoveKind::arc;
}

/// Points of the rows first … last − 1, arcs by chords of at most 1e-5 mm.
test::Points points_of(const Moves& moves, std::size_t first, std::size_t last) {
  test::Points points{moves.begin_of(first).head<3>()};
  for (std::size_t row = first; row < last; ++row) {
    if (moves.kind[row] == MoveKind::arc) {
      const ArcCurve arc = make_arc(moves.begin_of(row), moves.end[row], moves.arcs[moves.detail[row]]);
      const double chords = std::ceil(arc.sweep * std::sqrt(arc.start_radius / 8e-5)) + 1;
      for (double k = 1; k < chords; ++k) points.push_back(arc_point(arc, arc.sweep * k / chords).head<3>());
    }
    points.push_back(moves.end[row].head<3>());
  }
  return points;
}

std::size_t end_of_feeds(const Moves& moves, std::size_t row) {
  while (row < moves.size() && feeds(moves, row)) ++row;
  return row;
}

/// All rows but feed moves are the same, and between them the paths are, within the tolerance.
void expect_the_same(const Moves& a, const Moves& b, double tolerance, const std::string& what) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!feeds(a, i) || !feeds(b, j)) {
      ASSERT_EQ(a.kind[i], b.kind[j]) << what;
      ASSERT_EQ(a.end[i], b.end[j]) << what;
      ++i, ++j;
      continue;
    }
    const std::size_t i_end = end_of_feeds(a, i), j_end = end_of_feeds(b, j);
    ASSERT_EQ(a.end[i_end - 1], b.end[j_end - 1]) << what;
    ASSERT_EQ(a.feed[i_end - 1], b.feed[j_end - 1]) << what;
    ASSERT_TRUE(test::frechet_within(points_of(a, i, i_end), points_of(b, j, j_end), tolerance + 2e-5)) << what;
    i = i_end, j = j_end;
  }
  ASSERT_EQ(i, a.size()) << what;
  ASSERT_EQ(j, b.size()) << what;
}

struct Totals {
  std::size_t before = 0, once = 0, twice = 0;
};

void try_program(std::uint64_t seed, Totals& totals) {
  Random random(seed);
  ChordProgram program(random);
  for (std::size_t parts = 1 + random() % 12; parts > 0; --parts) program.add();
  const std::string text = program.finish();
  constexpr Dialect kDialects[] = {Dialect::linuxcnc, Dialect::grbl, Dialect::fanuc, Dialect::mach3, Dialect::marlin};
  ReadOptions read;
  read.dialect = kDialects[random() % std::size(kDialects)];
  const RewriteOptions options{spread(random, 0.002, 0.05), !one_in(random, 5), {}};
  const std::string what =
      fmt::format("seed {}, tolerance {}, {}\n{}", seed, options.tolerance, dialect_name(read.dialect), text);
  const auto reading = read_text(text, "random.nc", read);
  ASSERT_TRUE(reading && !reading->refused) << what;
  const auto once = rewrite(text, "random.nc", *reading, read, options);
  ASSERT_TRUE(once) << what;
  const auto again = read_text(once->text, "random.nc", read);
  ASSERT_TRUE(again && !again->refused) << what << once->text;
  EXPECT_LE(once->max_deviation, options.tolerance) << what;
  EXPECT_EQ(once->unproven, 0u) << what;
  expect_the_same(reading->moves, again->moves, options.tolerance, what + once->text);
  const auto twice = rewrite(once->text, "random.nc", *again, read, options);
  ASSERT_TRUE(twice) << what;
  totals.before += reading->moves.size();
  totals.once += again->moves.size();
  totals.twice += twice->reading.moves.size();
}

TEST(RandomProgramsWrittenAgain, GoTheSameWay) {
  Totals totals;
  const std::size_t cases = test::case_count(2000);
  for (std::uint64_t seed = 1; seed <= cases && !::testing::Test::HasFatalFailure(); ++seed) try_program(seed, totals);
  EXPECT_LT(totals.once, totals.before * 7 / 10);
  EXPECT_LE(totals.once - totals.twice, totals.once / 100) << "once " << totals.once << ", twice " << totals.twice;
}

}  // namespace
}  // namespace toolpace
