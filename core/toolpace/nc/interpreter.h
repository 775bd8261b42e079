#pragma once
/// Runs a program: takes its lines in order, executes each block in the fixed order of RS-274/NGC, appends rows to Moves.

#include <unordered_set>

#include "toolpace/base/monitor.h"
#include "toolpace/nc/context.h"
#include "toolpace/nc/diagnostic_log.h"
#include "toolpace/nc/flow/flow.h"
#include "toolpace/nc/motion/lathe_contour.h"
#include "toolpace/nc/motion/lathe_cycles.h"
#include "toolpace/nc/reader.h"
#include "toolpace/nc/text/block_reader.h"

namespace toolpace::nc {

class Interpreter {
 public:
  /// @param most_blocks  more are an error
  /// @param reading      receives moves, modal log and diagnostics
  Interpreter(ProgramFiles& files, const ReadOptions& options, Dialect dialect, std::size_t most_blocks,
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
  bool run_block(Scanner& text);
  void end_of_text();
  bool check_bounds();
  void report_faults(std::string_view line);

  // execute.cpp: the order of execution within a block
  bool execute(const Block& block);
  bool find_motion(const Block& block, Code& motion);
  bool check_words(const Block& block, Code motion);
  bool set_feed_mode(const Block& block);
  bool set_feed(const Block& block);
  bool set_speed(const Block& block);
  bool run_machine_codes(const Block& block);
  bool run_saved_state(Code code);
  bool run_dwell(const Block& block);
  bool run_settings(const Block& block);
  bool set_units(const Block& block);
  bool set_plane(const Block& block);
  bool set_path_control(const Block& block);
  bool set_spindle_mode(const Block& block);
  bool run_stop(const Block& block);
  bool run_subprogram_code(const Block& block);
  void restore(const Modal& modal);

  // contour_calls.cpp: lathe cycles
  bool turn_contour(const Block& block, Code code);
  bool read_contour(const Block& block, const LatheCycle& cycle, std::vector<ContourElement>& contour);

  // macro_calls.cpp
  bool run_macro_code(const Block& block);
  bool run_alarm(const Block& block);

  // machine_values.cpp: parameters that mirror the state
  std::optional<double> numbered_value(int index) const;
  std::optional<double> named_value(std::string_view name) const;
  void log_modal();

  State state_;
  Parameters parameters_;
  FaultSink faults_;
  MoveWriter out_;
  Context context_;
  BlockReader reader_;
  Flow flow_;
  DiagnosticLog log_;
  ProgramFiles& files_;
  ReadOptions options_;
  Dialect dialect_;
  Reading& reading_;
  Block block_;
  End end_ = End::running;
  const Monitor* monitor_ = nullptr;
  LatheContourReader* contour_ = nullptr;  ///< takes the blocks while the contour of a lathe cycle is read
  bool percent_seen_ = false;
  bool anything_read_ = false;
  bool at_percent_end_ = false;
  bool is_for_printers_ = false;  ///< dwells in ms, as printers count them
  bool extruder_told_ = false;
  std::size_t lines_run_ = 0;
  std::optional<Modal> logged_modal_;  ///< the state at the last entry of the modal log, and the tool
  int logged_tool_ = 0;
  std::unordered_set<std::uint64_t> logged_;  ///< places in the modal log, once lines are run out of order
  struct ModalCall {
    bool active = false;
    double program = 0.0;
    std::vector<double> arguments;
  } modal_call_;
};

}  // namespace toolpace::nc
