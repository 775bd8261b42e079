#include "commands.h"

namespace toolpace::cli {

void add_commands(CommandLine& line) {
  add_plan_command(line);
  add_blocks_command(line);
  add_move_command(line);
  add_steps_command(line);
  add_verify_command(line);
  add_simulate_command(line);
  add_compare_command(line);
  add_identify_command(line);
  add_report_command(line);
  add_predict_command(line);
  add_rewrite_command(line);
  add_tune_command(line);
}

}  // namespace toolpace::cli
