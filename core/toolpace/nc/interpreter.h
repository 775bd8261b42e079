#pragma once
/// Runs a program: takes its lines in order, reads their blocks, has them executed, and records their faults.

#include "toolpace/base/monitor.h"
#include "toolpace/nc/context.h"
#include "toolpace/nc/contour_calls.h"
#include "toolpace/nc/diagnostic_log.h"
#include "toolpace/nc/executor.h"
#include "toolpace/nc/flow/flow.h"
#include "toolpace/nc/machine_values.h"
#include "toolpace/nc/modal_recorder.h"
#include "toolpace/nc/read_options.h"
#include "toolpace/nc/reading.h"
#include "toolpace/nc/text/block_reader.h"

namespace toolpace::nc {

class Interpreter {
 public:
  /// @param most_blocks  more are an error
  /// @param reading      receives moves, modal log and diagnostics
  Interpreter(ProgramFiles& files, const ReadOptions& options, const DialectRules& rules, std::size_t most_blocks,
              Reading& reading);

  /// @return false if it was cancelled
  bool run(const Monitor& monitor);

  State& state() { return state_; }
  Parameters& parameters() { return parameters_; }
  Context& context() { return context_; }
  DiagnosticLog& log() { return log_; }

 private:
  enum class End : std::uint8_t { running, ended, cancelled };

  bool run_next_line();
  bool run_line(std::string_view line);
  bool run_percent();
  bool run_sender_command(Scanner& text);
  bool numbers_line(const Scanner& text) const;
  bool read_block(Scanner& text);
  bool run_block(Scanner& text);
  void start_at_main_program();
  void end_of_text();
  bool must_end();
  void warn_of_text_behind();
  bool check_bounds();
  void report_faults(std::string_view line);

  State state_;
  Parameters parameters_;
  FaultSink faults_;
  MoveWriter out_;
  Context context_;
  BlockReader reader_;
  Flow flow_;
  DiagnosticLog log_;
  ModalRecorder recorder_;
  MachineValues values_;
  ContourCalls contours_;
  Executor executor_;
  ProgramFiles& files_;
  ReadOptions options_;
  const DialectRules& rules_;
  Reading& reading_;
  Block block_;
  End end_ = End::running;
  const Monitor* monitor_ = nullptr;
  bool percent_seen_ = false;
  bool anything_read_ = false;
  bool at_percent_end_ = false;
  std::size_t lines_run_ = 0;
};

}  // namespace toolpace::nc
