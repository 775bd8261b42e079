#pragma once
/// Programs made by hand and planned for real, for the tests of the window.

#include <memory>
#include <string>

#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// Puts a program together, move by move. Feeds in mm/s, lengths in mm.
class Program {
 public:
  explicit Program(const AxisVector& start = AxisVector::Zero());

  Program& rapid(double x, double y, double z = 0);
  Program& feed(double x, double y, double z, double feed);
  /// Full or part circle in the XY plane about (cx, cy), counter-clockwise for a positive sweep [rad].
  Program& arc(double x, double y, double z, double cx, double cy, double sweep, double feed);
  Program& dwell(double seconds);

  std::shared_ptr<const Reading> reading() const;
  const Moves& moves() const { return moves_; }

 private:
  void add(MoveKind kind, const AxisVector& end, double feed, std::uint32_t detail = kNoDetail);
  Moves moves_;
};

/// The X, Y and F words of an RS-274 program of straight moves, as the examples have them.
Program read_simple(const std::string& file);

/// Plans it; throws std::runtime_error with the message of the error.
std::shared_ptr<const Outcome> planned(const Program& program, const PlanOptions& options = {}, Machine machine = {});

/// 588 blocks; the same curve as examples/nc/butterfly.ngc.
std::shared_ptr<const Outcome> planned_butterfly(const PlanOptions& options = {});

/// Many short blocks that wind over a plate: `blocks` of about 0.3 mm.
Program winding(std::size_t blocks);

}  // namespace toolpace::ui
