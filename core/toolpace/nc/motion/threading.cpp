#include "toolpace/nc/motion/threading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/motion/spindle.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr int kMostPasses = 10000;

bool find_pitch(Context& context, const Block& block, char letter, Feedrate& feed) {
  const State& state = context.state;
  const double pitch = block.has(letter) ? length_of(state, block, letter) : 0.0;
  if (!(pitch > 0.0)) {
    return fail(context, block, "pitch-missing",
                fmt::format("a thread without a positive {}", static_cast<char>(letter - 32)), "give the pitch");
  }
  const double speed = spindle_turns(state, state.position[0], state.position[0]);
  if (speed == 0.0 || std::isinf(speed) || (state.modal.spindle_direction == 0 && context.rules.refuses_doubtful)) {
    return fail(context, block, "spindle-stopped", "a thread while the spindle stands still",
                "give S and M3 or M4 before");
  }
  feed.linear = pitch * speed;
  return true;
}

// A threading cycle, X and Z of a lathe.
struct Thread {
  Position start;
  Feedrate feed, taper_feed;
  double side;          // +1: the crest lies towards smaller X (outside threads), −1: inside
  double crest_offset;  // |I|
  double first_cut, full_depth, degression, angle;
  double end_z, taper_length;
  bool taper_entry, taper_exit;
  int spring_passes;
};

class ThreadRun {
 public:
  ThreadRun(Context& context, const Thread& thread) : context_(context), thread_(thread) {}

  /// One pass at `depth` below the start; `cut_depth` of it lies in the thread, `whole` is the depth of the last pass.
  void pass(double depth, double cut_depth, double whole) {
    const double slide = std::tan(thread_.angle);
    const double z0 = thread_.start[2] - cut_depth * slide,
                 z1 = thread_.end_z + (thread_.full_depth - cut_depth) * slide;
    const double target = thread_.start[0] - thread_.side * depth;
    const double safe = target + thread_.side * whole;
    // A taper climbs from the full depth of thread to its crest over the taper's length, at its own pitch.
    const double taper_top = target + thread_.side * thread_.full_depth;
    const double taper = thread_.taper_length;
    go(MoveKind::rapid, safe, z0);
    if (thread_.taper_entry) {
      cut(taper_top, z0, thread_.taper_feed);
      cut(target, z0 - taper, thread_.taper_feed);
    } else {
      go(MoveKind::rapid, target, z0);
    }
    if (thread_.taper_exit) {
      cut(target, z1 + taper, thread_.feed);
      cut(taper_top, z1, thread_.taper_feed);
    } else {
      cut(target, z1, thread_.feed);
    }
    go(MoveKind::rapid, safe, z1);
  }
  void go(MoveKind kind, double x, double z, const Feedrate& feed = {}) {
    Position end = context_.state.position;
    end[0] = x;
    end[2] = z;
    context_.out.line(kind, context_.state.offsets, end, feed);
    context_.state.position = end;
  }

 private:
  void cut(double x, double z, const Feedrate& feed) {
    context_.out.set_mode(context_.state.modal, false, true);
    go(MoveKind::feed, x, z, feed);
    context_.out.set_mode(context_.state.modal);
  }

  Context& context_;
  const Thread& thread_;
};

bool read_thread(Context& context, const Block& block, Thread& thread) {
  State& state = context.state;
  for (const char letter : {'i', 'j', 'k', 'p', 'z'}) {
    if (!block.has(letter)) {
      return fail(context, block, "thread-words", fmt::format("G76 without {}", static_cast<char>(letter - 32)),
                  "G76 needs P Z I J K");
    }
  }
  if (state.modal.plane != 180) return fail(context, block, "thread-plane", "G76 outside the XZ plane", "use G18");
  if (block.has('x') && length_of(state, block, 'x') != state.position[0]) {
    return fail(context, block, "thread-words", "G76 moves Z alone", "leave X out");
  }
  if (!find_pitch(context, block, 'p', thread.feed)) return false;
  Position end;
  if (!find_end(context, block, end)) return false;
  thread.start = state.position;
  thread.end_z = end[2];
  const double i = length_of(state, block, 'i');
  thread.side = i > 0.0 ? -1.0 : 1.0;
  thread.crest_offset = std::fabs(i);
  thread.first_cut = length_of(state, block, 'j');
  thread.full_depth = length_of(state, block, 'k');
  if (state.modal.lathe_diameter == 70) {
    thread.first_cut /= 2.0;
    thread.full_depth /= 2.0;
    thread.crest_offset /= 2.0;
  }
  if (!(thread.first_cut > 0.0) || !(thread.full_depth > 0.0) || thread.full_depth < thread.first_cut) {
    return fail(context, block, "thread-words", "J and K of G76 do not make a thread",
                "J is the first cut, K the full depth, both positive, K the larger");
  }
  thread.degression = std::max(1.0, block.of('r', 1.0));
  const double angle = block.of('q', 0.0);
  if (!(angle >= 0.0 && angle <= 80.0))
    return fail(context, block, "thread-words", "Q of G76 is not from 0 to 80", "Q is the slide angle in degrees");
  thread.angle = angle * kRadiansPerDegree;
  const auto springs = whole_number(block.of('h', 0.0), 0, kMostPasses);
  if (!springs)
    return fail(context, block, "thread-words", "H of G76 is no number of passes",
                "H is a whole number from 0 to 10000");
  thread.spring_passes = *springs;
  const auto tapers = whole_number(block.of('l', 0.0), 0, 3);
  if (!tapers)
    return fail(context, block, "thread-words", "L of G76 is not 0, 1, 2 or 3",
                "L: 1 entry taper, 2 exit taper, 3 both");
  thread.taper_entry = (*tapers & 1) != 0;
  thread.taper_exit = (*tapers & 2) != 0;
  thread.taper_length = block.has('e') ? length_of(state, block, 'e') : 0.0;
  if (!(thread.taper_length > 0.0)) thread.taper_entry = thread.taper_exit = false;
  if (thread.taper_entry || thread.taper_exit) {
    thread.taper_feed.linear =
        thread.feed.linear * std::hypot(thread.taper_length, thread.full_depth) / thread.taper_length;
  }
  return true;
}

}  // namespace

bool run_synchronised(Context& context, const Block& block) {
  State& state = context.state;
  Feedrate feed;
  Position end;
  if (!find_pitch(context, block, 'k', feed) || !find_end(context, block, end)) return false;
  context.out.set_mode(state.modal, false, true);
  context.out.line(MoveKind::feed, state.offsets, end, feed);
  context.out.set_mode(state.modal);
  state.position = end;
  return true;
}

bool run_rigid_tap(Context& context, const Block& block) {
  State& state = context.state;
  Feedrate feed;
  Position end;
  if (!find_pitch(context, block, 'k', feed) || !find_end(context, block, end)) return false;
  const Position start = state.position;
  context.out.set_mode(state.modal, false, true);
  context.out.line(MoveKind::tap, state.offsets, end, feed);
  context.out.line(MoveKind::tap, state.offsets, start, feed, kTapReturn);
  context.out.set_mode(state.modal);
  return true;
}

bool run_threading(Context& context, const Block& block) {
  Thread thread;
  if (!read_thread(context, block, thread)) return false;
  ThreadRun run(context, thread);
  const double full = thread.full_depth + thread.crest_offset;
  const double first = thread.first_cut + thread.crest_offset;
  double depth = first;
  for (int passes = 1; depth < full && !context.out.is_full(); ++passes) {
    if (passes > kMostPasses)
      return fail(context, block, "thread-words", "too many passes of a thread", "give a deeper first cut J");
    run.pass(depth, depth - thread.crest_offset, full);
    depth = thread.crest_offset + thread.first_cut * std::pow(passes + 1, 1.0 / thread.degression);
  }
  for (int i = 0; i <= thread.spring_passes; ++i) run.pass(full, thread.full_depth, full);
  run.go(MoveKind::rapid, thread.start[0], context.state.position[2]);
  return true;
}

}  // namespace toolpace::nc
