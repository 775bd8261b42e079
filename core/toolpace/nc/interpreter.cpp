#include "toolpace/nc/interpreter.h"

#include <fmt/format.h>

#include <algorithm>

#include "toolpace/base/file_name.h"
#include "toolpace/nc/flow/main_program.h"
#include "toolpace/nc/last_warnings.h"
#include "toolpace/nc/motion/corners.h"
#include "toolpace/nc/motion/increments.h"
#include "toolpace/nc/program_limits.h"
#include "toolpace/nc/settings.h"
#include "toolpace/nc/text/line_kinds.h"

namespace toolpace::nc {
namespace {

constexpr std::size_t kLongestLine = 65536;

}  // namespace

Interpreter::Interpreter(ProgramFiles& files, const ReadOptions& options, const DialectRules& rules,
                         std::size_t most_blocks, Reading& reading)
    : out_(reading.moves, most_blocks),
      context_{state_, parameters_, out_, faults_, rules, rules.arc},
      reader_(parameters_, faults_, rules),
      flow_(files, parameters_, faults_, reader_, options.limits),
      log_(reading.diagnostics, options.strict),
      recorder_(reading.modal),
      values_(state_, flow_, rules),
      contours_(context_, flow_, log_, [this] { return run_next_line(); }),
      executor_(context_, flow_, contours_),
      files_(files),
      options_(options),
      rules_(rules),
      reading_(reading) {
  parameters_.numbered_state = [this](int index) { return values_.numbered(index); };
  parameters_.named_state = [this](std::string_view name) { return values_.named(name); };
  if (options.arc_tolerance) {
    context_.arc.metric = context_.arc.inch = *options.arc_tolerance;
    context_.arc.relative = 0.0;
  }
  reader_.delete_blocks(options.block_delete);
  state_.tip.kinematics = options.kinematics;
  state_.tip.travel = options.travel;
  if (rules.macro_statements) parameters_.use_macro_variables();
  state_.modal.motion = rules.first_motion;
  state_.modal.retract = rules.first_retract;
  state_.modal.plane = rules.first_plane;
  state_.modal.feed_mode = rules.first_feed_mode;
  state_.modal.lathe_diameter = rules.first_lathe_diameter;
  state_.modal.feed = state_.modal.feed_linear = rules.first_feed;
}

bool Interpreter::run(const Monitor& monitor) {
  monitor_ = &monitor;
  recorder_.record(state_, flow_);
  if (!rules_.refuses_doubtful) start_at_main_program();
  while (run_next_line()) {
  }
  if (end_ == End::cancelled) return false;
  for (std::size_t i = reading_.moves.files.size(); i < files_.size(); ++i)
    reading_.moves.files.push_back(files_.at(i).name);
  const ReadingEnd end{rules_, state_, reading_.moves, files_, log_};
  warn_at_the_end(end);
  if (executor_.has_ended() && flow_.depth() == 0) warn_of_text_behind_end(end, flow_.line_number(), flow_.rest());
  log_.finish(files_.at(0).name);
  reading_.refused = log_.has_errors();
  return true;
}

// Sub-programs may stand before the program that calls them.
void Interpreter::start_at_main_program() {
  const auto found = find_main_program(files_.at(0).text);
  if (!found) return;
  percent_seen_ = files_.at(0).text.substr(0, found->offset).find('%') != std::string_view::npos;
  flow_.go_to({0, found->offset, found->line - 1});
  log_.add({"main-program-behind",
            fmt::format("{} is run, which alone ends with M2 or M30: what stands before it are its sub-programs",
                        found->name),
            "", 0, Severity::warning},
           files_.at(0).name, found->line, {});
}

// @return false where there is nothing more to run
bool Interpreter::run_next_line() {
  if (end_ != End::running || flow_.is_lost()) return false;
  std::string_view line;
  if (!flow_.next_line(line)) {
    end_of_text();
    return true;
  }
  if (++lines_run_ % kReportEvery == 0) {
    if (monitor_->is_cancelled()) end_ = End::cancelled;
    if (flow_.depth() == 0 && flow_.turns() == 0) {
      const std::string_view text = files_.at(0).text;
      monitor_->report(static_cast<double>(line.data() - text.data()) / static_cast<double>(text.size()));
    }
  }
  if (!run_line(line) || !faults_.empty()) report_faults(line);
  if (!check_bounds()) report_faults(line);
  return true;
}

bool Interpreter::check_bounds() {
  if (out_.take_too_far()) {
    return faults_.fail("coordinate-too-large", fmt::format("a move to more than {:g} mm away", kFarthest),
                        "check the numbers and the offsets");
  }
  if (out_.is_full()) {
    end_ = End::ended;
    if (out_.has_all_modes()) {
      return faults_.fail("too-many-modes", "more than 65536 combinations of plane, feed mode, G64 P Q and limits",
                          "give fewer different tolerances and limits");
    }
    return faults_.fail("too-many-blocks",
                        fmt::format("loops, calls and cycles make more than {} motion blocks", options_.limits.blocks),
                        "check that its loops end; --max-blocks raises the bound");
  }
  if (flow_.work() > options_.limits.lines && flow_.work() > options_.limits.lines + files_.work()) {
    end_ = End::ended;
    return faults_.fail("too-many-lines",
                        fmt::format("loops and calls run more than {} lines again", options_.limits.lines),
                        "check that its loops end; --max-lines raises the bound");
  }
  if (log_.is_full()) end_ = End::ended;
  return true;
}

void Interpreter::report_faults(std::string_view line) {
  bool error = false;
  const Place& place = flow_.place_of_fault();
  if (!line.empty()) {  // the line taken last, or that of an elseif it led to
    const std::string_view text = files_.at(place.file).text.substr(place.offset);
    line = text.substr(0, text.find('\n'));
  }
  for (auto& fault : faults_.list()) {
    if (fault.column == 0) fault.column = std::min(line.find_first_not_of(" \t\r"), line.size()) + 1;
    error = log_.add(std::move(fault), files_.at(place.file).name, place.line, line) || error;
  }
  faults_.clear();
  if (!error || !out_.is_enabled()) return;
  // A compensated row is settled only when the next one is known.
  if (state_.compensation.open_row) out_.truncate(*state_.compensation.open_row);
  state_.compensation.open_row.reset();
  out_.stop();
}

void Interpreter::end_of_text() {
  if (flow_.return_from_call()) return;  // a sub-program file without an end of its own
  end_ = End::ended;
  release_corner(context_);
  // Senders and printers stream their programs: those end where the text ends.
  if (rules_.ends_with_text) {
    out_.note(MoveKind::end, "");
    return;
  }
  const char* const what = "the program ends without M2, M30 or a second %";
  const char* const remedy = "end it with M2 or M30";
  if (must_end()) {
    faults_.fail("program-without-end", what, remedy);
  } else {
    faults_.warn("program-without-end", what, remedy);
    out_.note(MoveKind::end, "");
  }
  report_faults({});
}

// LinuxCNC refuses what has no end, where it is LinuxCNC that the program is meant for.
bool Interpreter::must_end() {
  if (!rules_.refuses_doubtful) return false;
  return options_.dialect == rules_.dialect || extension_of(files_.at(0).name) == ".ngc";
}

bool Interpreter::run_percent() {
  if (flow_.depth() > 0) {
    at_percent_end_ = true;
    return true;
  }
  if (percent_seen_ || anything_read_) {
    end_ = End::ended;
    release_corner(context_);
    out_.set_place(flow_.line_number(), flow_.file());
    out_.note(MoveKind::end, "");
    if (!percent_seen_) warn_of_text_behind();
  }
  percent_seen_ = true;
  return true;
}

// A % that no other one stands before is rather a slip than the end.
void Interpreter::warn_of_text_behind() {
  const std::string_view rest = flow_.rest();
  if (rest.find_first_not_of(" \t\r\n%") == std::string_view::npos) return;
  const std::size_t first = flow_.line_number() + 1;
  const std::string_view upto = rest.substr(0, rest.find_last_not_of(" \t\r\n") + 1);
  const auto more = static_cast<std::size_t>(std::count(upto.begin(), upto.end(), '\n'));
  const std::string what =
      fmt::format("% ends the program; lines {} to {} behind it are not read", first, first + more);
  const char* const remedy = "remove the %, or begin the program with one, too";
  if (must_end()) {
    faults_.fail("text-behind-percent", what, remedy);
  } else {
    faults_.warn("text-behind-percent", what, remedy);
  }
}

bool Interpreter::run_sender_command(Scanner& text) {
  const std::size_t column = text.column();
  if (text.take_word("$j") || text.take_word("$h")) {
    faults_.warn("sender-command", "this command of a sender moves the machine, but is no part of the program's path",
                 "jog and home before the program begins", column);
  }
  return true;
}

bool Interpreter::run_line(std::string_view line) {
  if (line.size() > kLongestLine) {
    return faults_.fail("line-too-long", fmt::format("a line of {} bytes", line.size()),
                        fmt::format("lines may have {} bytes; is this an NC program?", kLongestLine));
  }
  Scanner text(line);
  char c = text.peek();
  if (c == '\0') return reader_.is_at_end(text);
  if (c == '%' && !rules_.refuses_doubtful && is_sender_macro(text)) {
    faults_.warn("sender-macro", "a macro of the sender is not followed; it is taken to move nothing", "",
                 text.column());
    return true;
  }
  if (c == '%') return run_percent();
  if (rules_.sender_lines && (c == '$' || c == '{' || c == '[')) return run_sender_command(text);
  if (c == '/') {
    if (options_.block_delete) return true;
    text.take();
    if (!rules_.refuses_doubtful && is_digit(text.peek())) text.take();
    c = text.peek();
  }
  while (c == 'n' || (c == ':' && numbers_line(text))) {
    const std::size_t column = text.column();
    text.take();
    double number = 0.0;
    if (text.take_number(number) != NumberStatus::ok || number < 0.0) {
      return faults_.fail("bad-line-number", "N without a line number", "write N and a number from 0", column);
    }
    c = text.peek();
  }
  if (rules_.sender_lines) {
    while (is_real_time(c)) {
      text.take();
      c = text.peek();
    }
  }
  if (rules_.texts_without_quotes && c == 's' && run_velocity_limit(context_, text)) return true;
  if (rules_.texts_without_quotes && is_macro_line(text)) {
    faults_.warn("sender-macro", "a macro of the sender is not followed; it is taken to move nothing", "",
                 text.column());
    return true;
  }
  if (c == '<' && rules_.macro_statements && is_program_name(text)) return true;
  if (is_digit(c) && !anything_read_ && !rules_.refuses_doubtful && is_number_alone(text)) {
    faults_.warn("program-number", "a number alone at the head of the program is taken for its number",
                 "write O before it", text.column());
    return true;
  }
  if (!rules_.refuses_doubtful && is_message(text)) {
    faults_.warn("sender-macro", "a macro of the sender is not followed; it is taken to move nothing", "",
                 text.column());
    return true;
  }
  if (rules_.macro_statements && begins_channel(text)) {
    return faults_.fail("several-channels", "here begins or waits a channel of a machine with several of them",
                        "read the part of each channel as a program of its own", text.column());
  }
  anything_read_ = anything_read_ || (c != '(' && c != ';' && c != '\0' && !begins_program_number(text));
  if (c == 'o' || (c == ':' && rules_.macro_statements)) {
    text.take();
    const bool good = flow_.run_o_word(text);
    if (const auto modal = flow_.take_restored()) restore_modal(context_, *modal);
    return good;
  }
  constexpr std::string_view kFirstOfStatements = "bdegipsw";
  if (rules_.macro_statements && kFirstOfStatements.find(c) != std::string_view::npos) {
    bool good = true;
    if (flow_.run_fanuc_statement(text, good)) return good;
  }
  return run_block(text);
}

// ":0030 T1 M6": posts number the lines of tool changes so. Alone it may be the head of a program.
bool Interpreter::numbers_line(const Scanner& text) const {
  if (rules_.refuses_doubtful) return false;
  return !rules_.macro_statements || !begins_program_number(text);
}

bool Interpreter::read_block(Scanner& text) {
  if (!reader_.read(text, block_)) return false;
  if (block_.counted != 0 && options_.integers == IntegerWords::increments) count_increments(block_, state_);
  return true;
}

bool Interpreter::run_block(Scanner& text) {
  if (LatheContourReader* const contour = contours_.reader()) {
    return read_block(text) && contour->add(block_, static_cast<std::uint32_t>(flow_.line_number()));
  }
  out_.set_place(flow_.line_number(), flow_.file());
  const bool read = read_block(text);
  if (reader_.take_aborted()) end_ = End::ended;
  if (!read) return false;
  const bool executed = executor_.run(block_);
  if (executor_.has_ended()) end_ = End::ended;
  if (!executed) return false;
  constexpr std::uint32_t kModalWords = word_bit('f') | word_bit('s') | word_bit('t');
  if ((block_.g_groups | block_.m_groups | (block_.words & kModalWords)) != 0 || flow_.take_jumped())
    recorder_.record(state_, flow_);
  return true;
}

}  // namespace toolpace::nc
