/// toolpace: plans the motion of NC programs from the command line.

#include <cstdio>
#include <exception>

#include "commands.h"
#include "interrupt.h"
#include "report.h"
#include "usage_error.h"

namespace {

/// What was printed may still wait in the buffer: a full disk or a closed pipe shows only here.
int after_flushing(int code) {
  using namespace toolpace;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return cli::report(Error{ErrorKind::io,
                           "stdout-unwritable",
                           "standard output cannot be written",
                           "check that the disk is not full and that the reader of the pipe is still there",
                           {},
                           {}});
}

}  // namespace

int main(int argc, char** argv) {
  using namespace toolpace::cli;
  CLI::App app{"Plans the motion of CNC machines: NC programs in, proven setpoints out.", "toolpace"};
  app.set_version_flag("--version", "toolpace " TOOLPACE_VERSION);
  app.require_subcommand(1);
  Action action;
  add_plan_command(app, action);
  add_blocks_command(app, action);
  add_move_command(app, action);
  add_steps_command(app, action);
  add_verify_command(app, action);
  add_simulate_command(app, action);
  add_report_command(app, action);
  catch_interrupts();

  try {
    app.parse(argc, argv);
    return after_flushing(action ? action() : kFine);
  } catch (const CLI::ParseError& e) {
    return report_usage(app, e);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "toolpace: internal error: %s\n", e.what());
    return kBadInput;
  }
}
