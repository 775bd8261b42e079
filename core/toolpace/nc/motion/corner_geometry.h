#pragma once
/// Corners of a contour, rounded or broken.

#include "toolpace/nc/motion/offset_geometry.h"

namespace toolpace::nc {

/// False where the elements go on smoothly: there is no corner to finish.
bool is_corner(const OffsetElement& before, const OffsetElement& after);

/// Puts an arc of `radius` between two elements that meet, tangent to both, and shortens them.
/// @return false where it does not fit between them; all stay as they were
bool round_corner(OffsetElement& before, OffsetElement& after, double radius, OffsetElement& between);

/// Puts a line between them that begins and ends at `length` from where they meet.
bool break_corner(OffsetElement& before, OffsetElement& after, double length, OffsetElement& between);

/// Where two lines meet, given a point and an angle [deg] of each; false where they are parallel.
bool find_meeting_of_lines(Point a, double angle_of_a, Point b, double angle_of_b, Point& meeting);

}  // namespace toolpace::nc
