#pragma once
/// Programs about the tool's tip: G43.4 and G43.5 of Fanuc's kind, and programs that are so from end to end.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

inline constexpr Code kTipByAngles = 434, kTipByVector = 435;

constexpr bool begins_tip(Code code) { return code == kTipByAngles || code == kTipByVector; }

/// G43.4 H, G43.5 H: X Y Z tell where the tip is from here on, the rotary axes where they stand, or, where G43.5 gives I J K,
/// which way the tool points: from its tip to the spindle, in the workpiece. No axis moves.
///
/// The tool's length is that of [kinematics], or else the tool's.
/// Faults: kinematics-missing; tool-length-missing, where a head swings the tool
bool begin_tip(Context& context, const Block& block);

/// G49, and any other tool length: by the axes again. No axis moves.
void end_tip(Context& context);

/// The whole program is about the tip: a tool length is that of the chain, G49 changes nothing, and coordinates of the machine are
/// the workpiece's. @return false (with a fault), see begin_tip()
bool begin_tip_everywhere(Context& context);

/// G43 and its kind, where the whole program is about the tip.
void take_tip_length(Context& context, double length);

/// I J K of a straight move under G43.5: the rotary axes of `end` that point the tool so, the nearest ones inside their travel. An axis
/// that turns about the tool itself stays as it is.
/// Faults: tool-vector-zero, tool-vector-with-angles, those of rotary_solutions(); a warning rotary-unwinds where the travel lets
/// an axis go the longer way only.
bool point_tool(Context& context, const Block& block, Position& end);
bool points_tool(const Context& context, const Block& block);

/// Codes that lead by the machine's own coordinates are refused while G43.4 or G43.5 hold.
bool refuse_under_tip(Context& context, const Block& block);

}  // namespace toolpace::nc
