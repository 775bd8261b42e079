#pragma once
/// The commands of the command line, one file each.

#include "command_line.h"

namespace toolpace::cli {

void add_plan_command(CommandLine& line);
void add_blocks_command(CommandLine& line);
void add_compare_command(CommandLine& line);
void add_identify_command(CommandLine& line);
void add_move_command(CommandLine& line);
void add_report_command(CommandLine& line);
void add_predict_command(CommandLine& line);
void add_rewrite_command(CommandLine& line);
void add_simulate_command(CommandLine& line);
void add_steps_command(CommandLine& line);
void add_tune_command(CommandLine& line);
void add_verify_command(CommandLine& line);

/// All of them, in the order in which --help lists them.
void add_commands(CommandLine& line);

}  // namespace toolpace::cli
