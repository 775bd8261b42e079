#pragma once
/// The commands of the command line, one file each. A command adds its flags to the parser and, when it is the one that
/// was named, sets `action`; main runs the action after parsing.

#include <CLI/CLI.hpp>
#include <functional>

#include "failure.h"

namespace toolpace::cli {

using Action = std::function<Done()>;

void add_plan_command(CLI::App& app, Action& action);
void add_blocks_command(CLI::App& app, Action& action);
void add_move_command(CLI::App& app, Action& action);
void add_report_command(CLI::App& app, Action& action);
void add_simulate_command(CLI::App& app, Action& action);
void add_steps_command(CLI::App& app, Action& action);
void add_verify_command(CLI::App& app, Action& action);

}  // namespace toolpace::cli
