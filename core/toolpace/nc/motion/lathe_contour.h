#pragma once
/// Reads the contour of a lathe cycle from the blocks of its sub-program: G0 to G3 with X Z, U W, I K or R, and corners A C.

#include <optional>
#include <vector>

#include "toolpace/nc/context.h"
#include "toolpace/nc/motion/lathe_profile.h"

namespace toolpace::nc {

class LatheContourReader {
 public:
  /// @param start  of the cycle: the first element leads from it to the contour
  LatheContourReader(Context& context, const Position& start);

  /// Takes a block of the sub-program, which nothing else executes. Moves the program's position along.
  bool add(const Block& block, std::uint32_t line);

  /// The contour, its corners rounded and broken. Leaves the reader empty.
  bool finish(std::vector<ContourElement>& contour);

  /// The motion code that the contour ends with; it goes on behind the cycle.
  Code motion() const { return motion_; }

 private:
  enum class CornerKind : std::uint8_t { none, fillet, chamfer, legs };
  struct Corner {
    CornerKind kind = CornerKind::none;
    double size = 0.0;  // [mm] radius of a fillet or of the circle in a chamfer, length of legs
  };

  struct OpenLine {
    double angle;  // [deg]
    Corner corner;
    std::uint32_t line;
  };

  bool add_plain(const Block& block, std::uint32_t line);
  bool find_end_by_angle(const Block& block, std::uint32_t line, const Corner& corner, Point& end);
  bool fail_open();
  void push(const ContourElement& element, const Corner& corner);
  bool find_motion(const Block& block);
  void warn_of_unused(const Block& block);
  bool find_end(const Block& block, Point& end);
  bool find_relative(const Block& block, char letter, char axis, double& value);
  bool find_centre(const Block& block, ContourElement& arc);
  bool find_centre_by_radius(const Block& block, ContourElement& arc);
  bool find_corner(const Block& block, Corner& corner);
  bool finish_corner(ContourElement& before, ContourElement& after, const Corner& corner, ContourElement& between);
  double unit() const { return context_.state.modal.unit(); }

  Context& context_;
  std::vector<ContourElement> elements_;
  std::vector<Corner> corners_;  // at the end of each element
  std::optional<OpenLine> open_;
  Point at_;
  Code motion_;
  double feed_ = 0.0;
  bool unused_told_ = false;
};

}  // namespace toolpace::nc
