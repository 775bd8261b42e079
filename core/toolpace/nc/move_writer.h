#pragma once
/// Appends rows to Moves: from work coordinates in mm and degrees to machine coordinates in mm and rad.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "toolpace/nc/moves.h"
#include "toolpace/nc/state.h"

namespace toolpace::nc {

/// How fast a row goes: lengths in mm/min, or deg/min where only A, B, C move.
struct Feedrate {
  double linear = 0.0;
  double angular = 0.0;
};

inline constexpr double kFarthest = 1e9;  ///< [mm, rad] rows that lead farther are refused: no machine goes there

class MoveWriter {
 public:
  MoveWriter(Moves& moves, std::size_t most_rows) : moves_(moves), most_rows_(most_rows) {
    for (std::size_t i = 0; i < moves.modes.size(); ++i) known_modes_.emplace(moves.modes[i], i);
    for (std::size_t i = 0; i < moves.ceilings.size(); ++i) known_ceilings_.emplace(moves.ceilings[i], i);
  }

  /// After the first error of a program nothing more is written.
  void stop() { enabled_ = false; }
  bool is_enabled() const { return enabled_; }
  bool is_full() const { return full_; }
  /// True where what is full is the table of modes, or that of ceilings.
  bool has_all_modes() const { return has_all_modes_; }
  /// True once after a row that led farther than kFarthest, and was not written.
  bool take_too_far() { return std::exchange(too_far_, false); }

  void set_place(std::size_t line, std::size_t file) {
    line_ = static_cast<std::uint32_t>(line);
    file_ = static_cast<std::uint16_t>(file);
  }
  std::size_t line_number() const { return line_; }
  std::size_t file() const { return file_; }
  /// Rows to come are about the tip of this chain, once a mode is set. No axis moves.
  void set_chain(const toolpace::Chain& chain);
  void set_mode(const Modal& modal, bool exact_path = false, bool synchronised = false);
  /// What the program lowers the machine's limits to in rows of modes that are set from now on, and in travels of printers.
  void set_ceilings(const MotionCeiling& feeding, const MotionCeiling& travelling);
  /// Whether the rows to come are such travels.
  void set_travelling(bool travels) { travels_ = travels; }

  /// Straight rows and rows without motion. `feed` is ignored for rapids.
  void line(MoveKind kind, const Offsets& offsets, const Position& end, const Feedrate& feed = {},
            std::uint32_t detail = kNoDetail);
  void arc(const Offsets& offsets, const Position& end, const ArcDetail& arc, double feed_mm_min);
  void spline(const Offsets& offsets, const Position& end, SplineDetail spline, double feed_mm_min);
  void dwell(double seconds);
  void note(MoveKind kind, std::string text);

  Moves& moves() { return moves_; }
  std::size_t size() const { return moves_.size(); }
  /// Drops rows from `first` on.
  void truncate(std::size_t first);

 private:
  struct ModeOrder {
    bool operator()(const MoveMode& a, const MoveMode& b) const;
  };
  struct CeilingOrder {
    bool operator()(const MotionCeiling& a, const MotionCeiling& b) const;
  };

  bool begin_row();
  bool find_ceiling(bool holds_overrides, std::uint16_t& index);
  void append(MoveKind kind, const AxisVector& end, double feed, std::uint32_t detail);
  AxisVector last_end() const;

  Moves& moves_;
  std::size_t most_rows_;
  bool enabled_ = true;
  bool full_ = false;
  bool has_all_modes_ = false;
  bool too_far_ = false;
  std::uint32_t line_ = 0;
  std::uint16_t file_ = 0;
  std::uint16_t mode_ = 0;
  std::uint16_t chain_ = 0;  ///< among the moves' chains
  std::map<MoveMode, std::size_t, ModeOrder> known_modes_;

  // What is lowered, of feeding and of travelling moves; by that and by held overrides: where it is among the ceilings.
  MotionCeiling ceilings_[2];
  std::optional<std::uint16_t> known_[2][2] = {};
  bool travels_ = false;
  std::map<MotionCeiling, std::size_t, CeilingOrder> known_ceilings_;
};

/// Machine coordinates in mm and rad.
AxisVector machine_vector(const Offsets& offsets, const Position& work);

}  // namespace toolpace::nc
