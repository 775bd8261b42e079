/// toolpace: plans the motion of NC programs from the command line.

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <new>
#include <string_view>
#include <system_error>

#include "commands.h"
#include "interrupt.h"
#include "report.h"
#include "toolpace/base/exception_error.h"

namespace {

using namespace toolpace;
using namespace toolpace::cli;

/// A descriptor that the shell closed must not become a file's, into which messages would go. What is opened here can be
/// neither read (standard input) nor written (the others), as is true of what is closed.
void occupy_standard_descriptors() {
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(standard, F_GETFD) < 0) open("/dev/null", standard == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

/// What was printed may still wait in the buffer: a full disk or a closed pipe shows only here.
Done flush_output(Done done) {
  const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_interrupted() && (!is_written || std::ferror(stderr) != 0)) return tl::unexpected(cancelled_error());
  if (is_written) return done;
  return tl::unexpected(Error{ErrorKind::io,
                              "stdout-unwritable",
                              "standard output cannot be written",
                              "check that the disk is not full and that the reader of the pipe is still there",
                              {},
                              {}});
}

/// All that takes memory is inside: a command line is made of thousands of pieces.
Done run_command(int argc, char** argv) {
  try {
    catch_interrupts();
    CommandLine line;
    add_commands(line);
    const auto action = line.parse(argc, argv);
    return action ? flush_output((*action)()) : tl::unexpected<Failure>(action.error());
  } catch (const std::system_error&) {  // of fmt::print
    if (std::ferror(stdout) != 0) return flush_output(kFine);
    return tl::unexpected(caught_error());
  } catch (...) {
    return tl::unexpected(caught_error());
  }
}

/// Asked on the command line itself: it may be what is wrong elsewhere on it that has to be told.
bool wants_json(int argc, char** argv) {
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    if (std::string_view(argv[i]) == "--json") return true;
  }
  return false;
}

/// Tells people, and scripts that asked for JSON.
int report_failure(const Failure& failure, bool json) {
  end_progress();
  const int code = report(failure.error);
  if (json) {
    print_json(to_json(failure));
    std::fflush(stdout);
  }
  return code;
}

/// The same where there is no memory left for words.
int report_no_memory(bool json) {
  std::fputs("error: there is not enough memory for this [out-of-memory]\n  split the program, or give more memory\n",
             stderr);
  if (json) {
    std::fputs(R"({"error": {"code": "out-of-memory", "message": "there is not enough memory for this", )"
               R"("remedy": "split the program, or give more memory", "file": null, "line": 0, "column": 0, )"
               R"("attainable": null}, "exit_code": 3, "diagnostics": []})"
               "\n",
               stdout);
    std::fflush(stdout);
  }
  return kBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_descriptors();
  const bool json = wants_json(argc, argv);
  try {
    const Done done = run_command(argc, argv);
    return done ? *done : report_failure(done.error(), json);
  } catch (const std::bad_alloc&) {
    return report_no_memory(json);
  }
}
