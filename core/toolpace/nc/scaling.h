#pragma once
/// Scaling and mirroring of Fanuc's kind: G50 and G51, G50.1 and G51.1.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// G51 X Y Z P, or I J K one an axis; G50 ends it.
bool set_scale(Context& context, const Block& block);

/// G51.1 X Y Z: mirrors the named axes, each at its value; G50.1 ends it, of all axes where none is named.
bool set_mirror(Context& context, const Block& block);

/// By how much the lengths along an axis are multiplied on their way into the machine; > 0.
double scale_of(const Offsets& offsets, std::size_t axis);

/// Whether circles in the plane stay circles.
bool scales_evenly(const Offsets& offsets, const PlaneAxes& plane);

/// −1 where the plane is mirrored: what turned left turns right.
double turn_of(const Offsets& offsets, const PlaneAxes& plane);

}  // namespace toolpace::nc
