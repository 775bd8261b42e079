#pragma once
/// Parameter files as LinuxCNC keeps them: lines of "number value".

#include <functional>
#include <string_view>

#include "toolpace/nc/fault.h"
#include "toolpace/nc/text/parameters.h"

namespace toolpace::nc {

void read_parameter_file(std::string_view text, Parameters& parameters,
                         const std::function<void(std::size_t line, Fault)>& on_fault);

}  // namespace toolpace::nc
