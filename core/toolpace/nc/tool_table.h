#pragma once
/// The tool table (LinuxCNC's format) and the tool words of a program.

#include <functional>
#include <string_view>

#include "toolpace/nc/context.h"

namespace toolpace::nc {

inline constexpr int kHighestTool = 99999999;
inline constexpr int kHighestOrientation = 9;

/// Reads lines like "T1 P1 D6 Z50 X0 I10 J20 Q2 ;remark" (mm, deg). Faults carry the line in `on_fault`.
void read_tool_table(std::string_view text, State& state, const std::function<void(std::size_t line, Fault)>& on_fault);

/// @return false (with a fault) if the table does not know the tool. Without a table every tool has no size.
bool find_tool(Context& context, int number, std::size_t column, Tool& tool);

/// Says once that lengths and radii are not known, where a tool's are asked for and there is no table of them.
void miss_tool_table(Context& context, int number, std::size_t column);

/// T: selects. M6: loads the selected tool and appends a tool row. M61 Q: declares the loaded tool.
bool select_tool(Context& context, const Block& block);
bool change_tool(Context& context, const Block& block);

/// G43 G43.1 G43.2 G49
bool set_tool_length(Context& context, const Block& block);

/// Fanuc's G10 L10 P R: length, L11 its wear, L12 radius, L13 its wear.
bool write_tool_offset(Context& context, const Block& block, int form);

/// G10 L1 L10 L11: writes the tool table.
bool write_tool_entry(Context& context, const Block& block, int form);

}  // namespace toolpace::nc
