/// toolpace: plans the motion of NC programs from the command line.

#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "commands.h"
#include "interrupt.h"
#include "report.h"
#include "usage_error.h"

namespace {

using namespace toolpace;
using namespace toolpace::cli;

/// What was printed may still wait in the buffer: a full disk or a closed pipe shows only here.
Done flush_output(Done done) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return done;
  return tl::unexpected(Error{ErrorKind::io,
                              "stdout-unwritable",
                              "standard output cannot be written",
                              "check that the disk is not full and that the reader of the pipe is still there",
                              {},
                              {}});
}

Done run_command(CLI::App& app, const Action& action, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return flush_output(action());
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0) return tl::unexpected(explain_usage(app, e));
    app.exit(e);  // help or version
    return flush_output(kFine);
  } catch (const std::bad_alloc&) {
    return tl::unexpected(Error{ErrorKind::input,
                                "out-of-memory",
                                "there is not enough memory for this",
                                "split the program, or give more memory",
                                {},
                                {}});
  } catch (const std::exception& e) {
    return tl::unexpected(
        Error{ErrorKind::input, "internal", std::string("internal error: ") + e.what(), "please report it", {}, {}});
  }
}

/// Asked on the command line itself: it may be what is wrong elsewhere on it that has to be told.
bool wants_json(int argc, char** argv) {
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    if (std::string_view(argv[i]) == "--json") return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plans the motion of CNC machines: NC programs in, proven setpoints out.", "toolpace"};
  app.set_version_flag("--version", "toolpace " TOOLPACE_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.get_formatter()->column_width(34);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->label("Subcommands", "Commands");
  app.get_formatter()->label("Positionals", "Arguments");
  app.require_subcommand(1);
  app.footer(
      "toolpace COMMAND --help lists the flags of a command, with examples.\n"
      "Exit codes: 0 fine; 1 a limit check failed; 2 bad usage; 3 bad input; 4 a file could not be read or written;\n"
      "130 interrupted. Results go to standard output, everything else to standard error.");
  Action action;
  add_plan_command(app, action);
  add_blocks_command(app, action);
  add_move_command(app, action);
  add_steps_command(app, action);
  add_verify_command(app, action);
  add_simulate_command(app, action);
  add_report_command(app, action);
  catch_interrupts();

  const Done done = run_command(app, action, argc, argv);
  if (done) return *done;
  end_progress();
  const int code = report(done.error().error);
  if (wants_json(argc, argv)) {
    print_json(to_json(done.error()));
    std::fflush(stdout);
  }
  return code;
}
