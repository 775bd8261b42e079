#pragma once
/// Which line comes next: O-words, sub-program calls, loops, and Fanuc's GOTO and WHILE.

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "toolpace/nc/flow/program_files.h"
#include "toolpace/nc/read_options.h"
#include "toolpace/nc/state.h"
#include "toolpace/nc/text/block_reader.h"

namespace toolpace::nc {

/// A place in the texts: the line that begins at `offset`.
struct Place {
  std::size_t file = 0;
  std::size_t offset = 0;
  std::size_t line = 0;  ///< number of lines before it
};

class Flow {
 public:
  Flow(ProgramFiles& files, Parameters& parameters, FaultSink& faults, BlockReader& reader, const ReadLimits& limits);

  /// Takes the next line. @return false at the end of the text
  bool next_line(std::string_view& line);

  std::size_t file() const { return here_.file; }
  std::size_t line_number() const { return here_.line; }
  /// The line taken last, or the one whose condition was looked at last: where a fault lies, jumps or not.
  const Place& place_of_fault() const { return taken_; }
  std::size_t depth() const { return calls_.size(); }
  std::size_t turns() const { return turns_; }
  /// Lines read so far, each time they are; long lines count as several (ReadLimits::lines).
  std::size_t work() const { return work_; }
  /// True once after each jump.
  bool take_jumped() { return std::exchange(jumped_, false); }
  /// A fault after which the place to go on from is unknown.
  bool is_lost() const { return lost_; }

  /// An O-word line; the cursor stands behind the O.
  bool run_o_word(Scanner& text);
  /// Fanuc's IF WHILE DO END GOTO. @return true if the line is one; `good` = no fault
  bool run_fanuc_statement(Scanner& text, bool& good);
  /// M98 and G65. `arguments` none: the caller's #1… are shared or copied as the dialect does.
  bool call_numbered(const std::string& label, int repeats, std::size_t column,
                     const std::optional<std::vector<double>>& arguments);
  /// Whether the text has a program of this number or name.
  bool has_program(const std::string& label);
  /// M97 of Haas: calls the lines from N<number> on, up to M99.
  bool call_line(double number, int repeats, std::size_t column);
  /// Calls the sub O<number>, without arguments, as "O… call" does.
  bool call_sub(int number, std::size_t column);
  /// Faults are told at `place` from here to the next line taken.
  void blame(const Place& place) { taken_ = place; }
  /// Counts a calculation as so many lines run again.
  void add_work(std::size_t lines) { work_ += lines; }
  /// M99 and the end of a sub-program file. @return false if no call is running
  bool return_from_call(std::optional<double> to_number = {});

  /// M99 P of a program itself: goes on at line N<number>.
  bool go_to_number(double number, std::size_t column);
  /// Where the contour N<first> … N<last> of a lathe cycle stands: behind this line, or else before it.
  bool find_contour(double first, double last, bool before, Place& begin, std::size_t& last_line);
  /// The line after the one taken last.
  const Place& here() const { return here_; }
  void go_to(const Place& place) {
    here_ = place;
    jumped_ = true;
  }
  /// What stands behind the line taken last, in its file.
  std::string_view rest() { return files_.at(here_.file).text.substr(here_.offset); }

  double returned_value() const { return returned_value_; }
  bool has_returned_value() const { return has_returned_value_; }

  /// M70 … M73: the state saved at this call level.
  std::optional<SavedModal>& saved_modal() { return calls_.empty() ? saved_ : calls_.back().saved; }
  /// State to restore because a call that asked for it (M73) has ended.
  std::optional<Modal> take_restored() { return std::exchange(restored_, std::nullopt); }

 private:
  struct Call {
    Place back;   ///< the line after the call
    Place start;  ///< first line of the sub-program
    int repeats = 1;
    std::optional<std::vector<double>> arguments;  ///< of G65, given anew at each repeat
    bool is_numbered = false;                      ///< by M98 or G65
    std::unordered_map<int, int> counters;         ///< of repeat loops, by head
    std::optional<SavedModal> saved;
  };

  FlowIndex& index() { return files_.at(here_.file).flow(reader_.rules().macro_statements); }
  const ControlLine* current_line(int& at);
  bool lose(const char* code, std::string what, std::string remedy, std::size_t column = 0);
  void jump(std::size_t offset, std::size_t line);
  void jump_after(int index) { jump(this->index().at(index).next, this->index().at(index).line); }
  void jump_to(int index) { jump(this->index().at(index).begin, this->index().at(index).line - 1); }
  bool jump_after_end(int at);
  bool count_turn();
  void count_work(std::size_t length) { work_ += 1 + length / kLengthOfALine; }
  bool read_condition(Scanner& text, bool& holds);
  bool end_of_line(Scanner& text);
  bool read_label(Scanner& text, std::string& label, bool& computed);
  bool run_control(Control control, const std::string& label, Scanner& text, std::size_t column);
  bool run_loop(Control control, int at, Scanner& text);
  bool run_if(int at, Scanner& text);
  bool run_repeat(int at, Scanner& text);
  bool leave_or_continue(Control control, const std::string& label, int at);
  bool call_label(const std::string& label, Scanner& text, std::size_t column);
  bool enter(const std::string& label, std::size_t column, int repeats, bool is_numbered);
  bool finish_sub(Scanner& text);
  bool run_goto(Scanner& text);
  bool name_variables(Scanner& text);
  std::unordered_map<int, int>& counters() { return calls_.empty() ? counters_ : calls_.back().counters; }

  ProgramFiles& files_;
  Parameters& parameters_;
  FaultSink& faults_;
  BlockReader& reader_;
  ReadLimits limits_;
  Place taken_;
  Place here_;             ///< line = number of the line taken last
  std::size_t begin_ = 0;  ///< offset of the line taken last
  std::vector<Call> calls_;
  std::unordered_map<int, int> counters_;
  std::optional<SavedModal> saved_;
  std::optional<Modal> restored_;
  std::size_t turns_ = 0;
  std::size_t work_ = 0;
  double returned_value_ = 0.0;
  bool has_returned_value_ = false;
  bool jumped_ = false;
  bool lost_ = false;
  bool was_missing_ = false;  ///< the sub-program called last
};

}  // namespace toolpace::nc
