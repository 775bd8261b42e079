#pragma once
/// Which lines of a program may be written anew.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "toolpace/nc/reading.h"
#include "toolpace/rewrite/program_lines.h"

namespace toolpace::detail::rewrite {

/// Consecutive lines, each of which is one feed move and nothing else, and is run once. Their rows follow each other, too.
///
/// Lines are left out wherever text and motion do not tell the same: under G91, G90.1, G7, G16, cutter compensation, scaling and
/// rotation, in feed modes other than G94, where A, B or C turn, in what loops and calls repeat. Of each line it is checked that
/// the axes went where its words say, and that the other axes stayed.
struct Run {
  std::size_t line = 0;   ///< first one, from 1
  std::size_t count = 0;  ///< of lines, and of rows, ≥ 2
  std::size_t row = 0;    ///< first one of the moves
  int plane = 17;
  double unit = 1.0;                                 ///< [mm] of the program's unit of length
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< [mm] of the machine's coordinates from the program's
  std::array<std::uint32_t, 3> named = {};  ///< first row of the run that names X, Y, Z; `count` where none does
};

/// Whether numbers without a decimal point may count least increments.
bool counts_integers(Dialect dialect);

/// Whether the program runs its lines one after the other, none again.
bool is_in_order(const Moves& moves);

/// In the order of lines.
std::vector<Run> find_runs(const ProgramLines& lines, const Reading& reading);

}  // namespace toolpace::detail::rewrite
