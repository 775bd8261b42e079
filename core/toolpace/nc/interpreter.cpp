#include "toolpace/nc/interpreter.h"

#include <fmt/format.h>

#include <algorithm>

#include "toolpace/nc/settings.h"

namespace toolpace::nc {
namespace {

constexpr std::size_t kLongestLine = 65536;

}  // namespace

Interpreter::Interpreter(ProgramFiles& files, const ReadOptions& options, Dialect dialect, std::size_t most_blocks,
                         Reading& reading)
    : out_(reading.moves, most_blocks),
      context_{state_, parameters_, out_, faults_, dialect},
      reader_(parameters_, faults_, dialect),
      flow_(files, parameters_, faults_, reader_, options.limits),
      log_(reading.diagnostics, options.strict),
      recorder_(reading.modal),
      values_(state_, flow_, dialect),
      contours_(context_, flow_, log_, [this] { return run_next_line(); }),
      executor_(context_, flow_, contours_),
      files_(files),
      options_(options),
      dialect_(dialect),
      reading_(reading) {
  parameters_.numbered_state = [this](int index) { return values_.numbered(index); };
  parameters_.named_state = [this](std::string_view name) { return values_.named(name); };
  if (dialect == Dialect::fanuc) parameters_.set_dialect(kFanucLocals, true);
  context_.dwells_in_milliseconds =
      dialect == Dialect::fanuc || (dialect == Dialect::grbl && looks_like_printing(files.at(0).text));
  if (dialect != Dialect::linuxcnc) state_.modal.motion = 0;
}

bool Interpreter::run(const Monitor& monitor) {
  monitor_ = &monitor;
  recorder_.record(state_, flow_);
  while (run_next_line()) {
  }
  if (end_ == End::cancelled) return false;
  for (std::size_t i = reading_.moves.files.size(); i < files_.size(); ++i)
    reading_.moves.files.push_back(files_.at(i).name);
  log_.finish(files_.at(0).name);
  reading_.refused = log_.has_errors();
  return true;
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
      return faults_.fail("too-many-modes", "more than 65536 combinations of plane, feed mode and G64 P Q",
                          "give fewer different tolerances");
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
  // Senders and printers stream their programs: those end where the text ends.
  if (dialect_ == Dialect::grbl) {
    out_.note(MoveKind::end, "");
    return;
  }
  faults_.fail("program-without-end", "the program ends without M2, M30 or a second %", "end it with M2 or M30");
  report_faults({});
}

bool Interpreter::run_percent() {
  if (flow_.depth() > 0) {
    at_percent_end_ = true;
    return true;
  }
  if (percent_seen_ || anything_read_) {
    end_ = End::ended;
    out_.set_place(flow_.line_number(), flow_.file());
    out_.note(MoveKind::end, "");
  }
  percent_seen_ = true;
  return true;
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
  if (c == '%') return run_percent();
  if (dialect_ == Dialect::grbl && is_sender_command(text)) return run_sender_command(text);
  if (c == '/') {
    if (options_.block_delete) return true;
    text.take();
    if (dialect_ == Dialect::fanuc && is_digit(text.peek())) text.take();
    c = text.peek();
  }
  while (c == 'n') {
    const std::size_t column = text.column();
    text.take();
    double number = 0.0;
    if (text.take_number(number) != NumberStatus::ok || number < 0.0) {
      return faults_.fail("bad-line-number", "N without a line number", "write N and a number from 0", column);
    }
    c = text.peek();
  }
  anything_read_ = anything_read_ || (c != '(' && c != ';' && c != '\0');
  if (c == 'o' || (c == ':' && dialect_ == Dialect::fanuc)) {
    text.take();
    const bool good = flow_.run_o_word(text);
    if (const auto modal = flow_.take_restored()) restore_modal(context_, *modal);
    return good;
  }
  if (dialect_ == Dialect::fanuc && (c == 'i' || c == 'w' || c == 'd' || c == 'e' || c == 'g')) {
    bool good = true;
    if (flow_.run_fanuc_statement(text, good)) return good;
  }
  return run_block(text);
}

bool Interpreter::run_block(Scanner& text) {
  if (LatheContourReader* const contour = contours_.reader()) {
    return reader_.read(text, block_) && contour->add(block_, static_cast<std::uint32_t>(flow_.line_number()));
  }
  out_.set_place(flow_.line_number(), flow_.file());
  const bool read = reader_.read(text, block_);
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
