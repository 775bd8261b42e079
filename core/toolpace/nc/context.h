#pragma once
/// What every part of the interpreter works on, passed down by reference.

#include "toolpace/nc/dialects/rules.h"
#include "toolpace/nc/fault.h"
#include "toolpace/nc/move_writer.h"
#include "toolpace/nc/state.h"
#include "toolpace/nc/text/parameters.h"

namespace toolpace::nc {

struct Context {
  State& state;
  Parameters& parameters;
  MoveWriter& out;
  FaultSink& faults;
  const DialectRules& rules;
  ArcTolerance arc;
};

/// Stores lengths of `position` (mm) in parameters first … first+5 (machine units, which are mm and degrees).
void store_position(Parameters& parameters, int first, const Position& position);
Position load_position(const Parameters& parameters, int first);

}  // namespace toolpace::nc
