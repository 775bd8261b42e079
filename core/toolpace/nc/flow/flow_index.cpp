#include "toolpace/nc/flow/flow_index.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace toolpace::nc {
namespace {

struct Keyword {
  std::string_view word;
  Control control;
};
// Longer words first where one begins another.
constexpr Keyword kKeywords[] = {{"sub", Control::sub},
                                 {"endsub", Control::endsub},
                                 {"call", Control::call},
                                 {"return", Control::return_},
                                 {"while", Control::while_},
                                 {"endwhile", Control::endwhile},
                                 {"do", Control::do_},
                                 {"if", Control::if_},
                                 {"elseif", Control::elseif},
                                 {"else", Control::else_},
                                 {"endif", Control::endif},
                                 {"break", Control::break_},
                                 {"continue", Control::continue_},
                                 {"repeat", Control::repeat},
                                 {"endrepeat", Control::endrepeat}};

// Steps over '/', and an N number.
void skip_prefix(Scanner& text) {
  if (text.peek() == '/') text.take();
  if (text.peek() == 'n') {
    text.take();
    double number = 0.0;
    text.take_number(number);
  }
}

void skip_brackets(Scanner& text) {
  int depth = 0;
  for (char c = text.peek(); c != '\0'; c = text.peek()) {
    if (c == '[') ++depth;
    if (c == ']') --depth;
    text.take();
    if (depth == 0) return;
  }
}

// The label behind the O, empty where it has to be computed.
bool read_label(Scanner& text, std::string& label) {
  const char c = text.peek();
  label.clear();
  if (c == '<') {
    text.take();
    for (char d = text.peek(); d != '>' && d != '\0'; d = text.peek()) {
      label.push_back(d);
      text.take();
    }
    text.take();
    return true;
  }
  if (c == '[') {
    skip_brackets(text);
    return true;
  }
  if (c == '#') {
    text.take();
    double ignored = 0.0;
    if (text.peek() == '<') {
      std::string name;
      read_label(text, name);
    } else {
      text.take_number(ignored);
    }
    return true;
  }
  double number = 0.0;
  if (text.take_number(number) != NumberStatus::ok) return false;
  label = label_of(number);
  return true;
}

}  // namespace

std::string label_of(double number) {
  const auto whole = static_cast<long long>(std::clamp(std::round(number), -1e15, 1e15));
  return std::to_string(whole);
}

Control read_control(Scanner& text) {
  if (!is_letter(text.peek())) return Control::none;
  for (const auto& keyword : kKeywords) {
    if (text.take_word(keyword.word)) return keyword.control;
  }
  return Control::unknown;
}

FlowIndex::FlowIndex(std::string_view text, bool fanuc) : text_(text), fanuc_(fanuc) {
  scan();
  match();
}

void FlowIndex::scan() {
  std::size_t begin = 0;
  std::size_t number = 0;
  bool seen_percent = false;
  while (begin < text_.size()) {
    const void* found = std::memchr(text_.data() + begin, '\n', text_.size() - begin);
    const std::size_t end =
        found ? static_cast<std::size_t>(static_cast<const char*>(found) - text_.data()) : text_.size();
    const std::size_t next = std::min(end + 1, text_.size());
    ++number;
    const std::string_view line = text_.substr(begin, end - begin);
    if (!fanuc_ && Scanner(line).peek() == '%' && std::exchange(seen_percent, true)) return;  // nothing behind is read
    scan_line(line, begin, next, number);
    begin = next;
  }
}

void FlowIndex::scan_line(std::string_view line, std::size_t begin, std::size_t next, std::size_t number) {
  Scanner text(line);
  skip_prefix(text);
  const char c = text.peek();
  ControlLine entry;
  entry.begin = begin;
  entry.next = next;
  entry.line = number;
  if (c == 'o' || (fanuc_ && (c == ':' || c == '<'))) {
    if (c != '<') text.take();
    if (!read_label(text, entry.label)) return;
    entry.control = read_control(text);
    if (entry.control == Control::unknown && fanuc_) entry.control = Control::none;
  } else if (fanuc_ && (c == 'w' || c == 'd' || c == 'e')) {
    const bool ends = text.take_word("end") || text.take_word("en");
    if (!ends && (text.take_word("while") || text.take_word("wh"))) {
      while (is_letter(text.peek())) text.take();
      skip_brackets(text);
    }
    double which = 0.0;
    if (!ends && !text.take_word("do")) return;
    if (text.take_number(which) != NumberStatus::ok) return;
    entry.control = ends ? Control::fanuc_end : Control::fanuc_while;
    entry.label = "do" + label_of(which);
  } else {
    return;
  }
  lines_.push_back(std::move(entry));
}

void FlowIndex::match() {
  std::unordered_map<std::string, Label> labels;
  std::string scope;
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
    ControlLine& line = lines_[static_cast<std::size_t>(i)];
    if (line.control == Control::sub || line.control == Control::none) {
      scope = line.label;
      if (!line.label.empty()) subs_.emplace(line.label, i);
    }
    match_line(i, labels, scope);
    if (line.control == Control::endsub) scope.clear();
  }
}

void FlowIndex::match_line(int index, std::unordered_map<std::string, Label>& labels, const std::string& scope) {
  ControlLine& line = lines_[static_cast<std::size_t>(index)];
  Label& label = labels[scope + '\n' + line.label];
  std::vector<Open>& stack = label.open;
  const auto entry = [&](int i) -> ControlLine& { return lines_[static_cast<std::size_t>(i)]; };
  const auto open = [&](ControlLine& opener) {
    opener.head = index;
    opener.duplicate = label.used && opener.control != Control::fanuc_while;
    label.used = true;
    stack.push_back({index, index});
  };
  const auto close = [&](std::initializer_list<Control> openers) {
    if (stack.empty() || std::find(openers.begin(), openers.end(), entry(stack.back().head).control) == openers.end())
      return;
    line.head = stack.back().head;
    // Every member of the structure learns its end.
    for (int i = line.head; i != kNoMatch; i = entry(i).after) entry(i).tail = index;
    line.tail = index;
    stack.pop_back();
  };
  switch (line.control) {
    case Control::sub:
    case Control::do_:
    case Control::if_:
    case Control::repeat:
    case Control::fanuc_while: open(line); break;
    case Control::while_:
      if (!stack.empty() && entry(stack.back().head).control == Control::do_) {
        line.closes_do = true;
        close({Control::do_});
      } else {
        open(line);
      }
      break;
    case Control::elseif:
    case Control::else_:
      if (!stack.empty() && entry(stack.back().head).control == Control::if_) {
        line.head = stack.back().head;
        entry(stack.back().last).after = index;
        stack.back().last = index;
      }
      break;
    case Control::break_:
    case Control::continue_:
      for (auto loop = stack.rbegin(); loop != stack.rend() && line.head == kNoMatch; ++loop) {
        const Control opener = entry(loop->head).control;
        if (opener == Control::while_ || opener == Control::do_) line.head = loop->head;
      }
      break;
    case Control::endif: close({Control::if_}); break;
    case Control::endwhile: close({Control::while_}); break;
    case Control::endrepeat: close({Control::repeat}); break;
    case Control::endsub: close({Control::sub}); break;
    case Control::fanuc_end: close({Control::fanuc_while}); break;
    default: break;
  }
}

int FlowIndex::find(std::size_t offset) const {
  const auto found = std::lower_bound(lines_.begin(), lines_.end(), offset,
                                      [](const ControlLine& line, std::size_t at) { return line.begin < at; });
  return found != lines_.end() && found->begin == offset ? static_cast<int>(found - lines_.begin()) : kNoMatch;
}

int FlowIndex::find_sub(const std::string& label) const {
  const auto found = subs_.find(label);
  return found == subs_.end() ? kNoMatch : found->second;
}

void FlowIndex::index_numbers() {
  has_numbers_ = true;
  std::size_t begin = 0;
  std::size_t number = 0;
  while (begin < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', begin), text_.size());
    ++number;
    Scanner text(text_.substr(begin, end - begin));
    if (text.peek() == '/') text.take();
    double value = 0.0;
    if (text.peek() == 'n') {
      text.take();
      if (text.take_number(value) == NumberStatus::ok) numbers_.push_back({value, begin, number});
    }
    begin = end + 1;
  }
  std::stable_sort(numbers_.begin(), numbers_.end(),
                   [](const Numbered& a, const Numbered& b) { return a.number < b.number; });
}

bool FlowIndex::find_number_before(double number, std::size_t offset_limit, std::size_t& offset, std::size_t& line) {
  if (!has_numbers_) index_numbers();
  const Numbered* best = nullptr;
  for (const Numbered& n : numbers_) {
    if (n.number == number && (best == nullptr || n.offset < offset_limit)) best = &n;
  }
  if (best == nullptr) return false;
  offset = best->offset;
  line = best->line;
  return true;
}

bool FlowIndex::find_number(double number, std::size_t from, std::size_t& offset, std::size_t& line) {
  if (!has_numbers_) index_numbers();
  const auto before = [](const Numbered& a, const Numbered& b) {
    return a.number < b.number || (a.number == b.number && a.offset < b.offset);
  };
  const auto find = [&](std::size_t at) {
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), Numbered{number, at, 0}, before);
    return found != numbers_.end() && found->number == number ? found : numbers_.end();
  };
  // The next one forward, else the first of the program.
  auto chosen = find(from);
  if (chosen == numbers_.end()) chosen = find(0);
  if (chosen == numbers_.end()) return false;
  offset = chosen->offset;
  line = chosen->line;
  return true;
}

}  // namespace toolpace::nc
