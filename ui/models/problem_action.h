#pragma once
/// What the window itself can do about a problem.

#include <QString>
#include <string>

namespace toolpace::ui {

enum class ProblemAction { none, tool_table, parameters, sub_folder, arc_tolerance, machine };

/// By the code of a diagnostic.
ProblemAction action_for(const std::string& code);

/// "Choose a tool table…", in the language of the window; empty for none.
QString action_text(ProblemAction action);

}  // namespace toolpace::ui
