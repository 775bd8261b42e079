#include "toolpace/nc/dialects/signs.h"

#include <fmt/format.h>

#include <algorithm>

namespace toolpace::nc {
namespace {

std::string fold(std::string_view line) {
  std::string text;
  int depth = 0;
  for (const char c : line) {
    if (c == ';') break;
    if (c == '(') ++depth;
    if (depth == 0 && static_cast<unsigned char>(c) > ' ')
      text.push_back(static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c));
    if (c == ')' && depth > 0) --depth;
  }
  return text;
}

bool contains(const std::string& text, const char* what) { return text.find(what) != std::string::npos; }

std::size_t skip_number(std::string_view text, std::size_t at) {
  while (at < text.size() && ((text[at] >= '0' && text[at] <= '9') || text[at] == '.')) ++at;
  return at;
}

// Codes of 3D printers that machine tools do not have.
bool is_printing(const std::string& text) {
  for (const char* marlin : {"m104s", "m109s", "m140s", "m190s", "m106", "m107", "m110", "m117", "m82", "m83", "m201",
                             "m203", "m204", "m205", "m420", "m600", "m84", "g92e"}) {
    const std::size_t length = std::string_view(marlin).size();
    if (text.compare(0, length, marlin) != 0) continue;
    const char before = marlin[length - 1];
    if (before > '9' || text.size() == length || text[length] < '0' || text[length] > '9') return true;
  }
  return false;
}

// "…*82" at the end of a line, outside of expressions.
bool has_checksum(const std::string& text) {
  const std::size_t star = text.rfind('*');
  return star != std::string::npos && star + 1 < text.size() && skip_number(text, star + 1) == text.size() &&
         text.find_first_of("[#=") == std::string::npos;
}

bool is_offset_tool(std::string_view number) {
  if (number.size() == 3 && number[0] == number[2] && number[1] == '0') return true;
  return number.size() == 4 && std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
         number.substr(2) != "00" && number.substr(0, 2) != "00";
}

}  // namespace

void SignReader::add(Dialect dialect, int weight, std::string_view what) {
  Sign& sign = signs_.emplace_back();
  sign.dialect = dialect;
  sign.weight = weight;
  sign.what = what;
}

bool SignReader::has(char letter) const {
  return std::any_of(words_.begin(), words_.end(), [&](const Word& w) { return w.letter == letter; });
}

// Leading zeros do not count.
bool SignReader::has(char letter, std::string_view number) const {
  return std::any_of(words_.begin(), words_.end(), [&](const Word& w) {
    std::string_view n = w.number;
    while (n.size() > 1 && n.front() == '0' && n[1] != '.') n.remove_prefix(1);
    return w.letter == letter && n == number;
  });
}

void SignReader::look_at_comments(std::string_view line) {
  const std::size_t open = line.find('(');
  if (open == std::string_view::npos) return;
  std::string comment(line.substr(open));
  for (char& c : comment) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  for (const char* model : {"(vf-", "(vf2", " vf-", "(st-", " st-", "umc-"}) {
    if (contains(comment, model)) add(Dialect::haas, 1, "a comment names a model of Haas");
  }
  if (contains(comment, "haas")) add(Dialect::haas, 3, "a comment names Haas");
  if (contains(comment, "mach3") || contains(comment, "mach 3") || contains(comment, "mach4"))
    add(Dialect::mach3, 3, "a comment names Mach3");
  if (contains(comment, "grbl")) add(Dialect::grbl, 1, "a comment names grbl");
  for (const char* active : {"(debug,", "(print,", "(probeopen", "(abort,", "(logopen"}) {
    if (contains(comment, active)) add(Dialect::linuxcnc, 3, fmt::format("a comment {}…) acts", active));
  }
}

// O-words with a keyword and <names> are LinuxCNC's alone.
void SignReader::look_at_o_word() {
  std::size_t at = 1;
  if (at < text_.size() && (text_[at] == '<' || text_[at] == '#' || text_[at] == '[')) {
    add(Dialect::linuxcnc, 3, "an O word with a name");
    return;
  }
  at = skip_number(text_, at);
  for (const char* word : {"sub", "endsub", "call", "if", "else", "endif", "while", "do", "endwhile", "repeat",
                           "endrepeat", "return", "break", "continue"}) {
    if (text_.compare(at, std::string_view(word).size(), word) != 0) continue;
    add(Dialect::linuxcnc, 3, fmt::format("an O word with \"{}\"", word));
    return;
  }
  if (!seen_block_) add(Dialect::fanuc, 3, "a program number O");
}

void SignReader::look_at_words() {
  if (contains(text_, "goto") || text_.rfind("if[", 0) == 0 || text_.rfind("while[", 0) == 0)
    add(Dialect::fanuc, 3, "IF, WHILE and GOTO of macros");
  if (contains(text_, "g65p") || contains(text_, "g66p")) add(Dialect::fanuc, 3, "a macro call G65 or G66");
  if (contains(text_, ",c") || contains(text_, ",r")) add(Dialect::fanuc, 3, "a corner ,C or ,R");
  if (contains(text_, "g54.1p")) add(Dialect::fanuc, 3, "G54.1");
  if (has('g', "7")) add(Dialect::linuxcnc, 3, "G7, diameters by a code");
  if (is_printing(text_)) add(Dialect::marlin, 3, "a code of 3D printers");
  for (const char* macro : {"set_velocity", "exclude_object", "start_print", "end_print", "print_start", "print_end"}) {
    if (text_.rfind(macro, 0) == 0) add(Dialect::marlin, 3, "a macro of Klipper");
  }
  if (text_ == "g28x" || text_ == "g28xy" || text_ == "g28xyz" || text_ == "g28z")
    add(Dialect::marlin, 3, "G28 with letters alone");
  const bool moves = (has('x') || has('y')) && !has('s') && !has('m') && (has('g', "1") || has('g', "0"));
  if (has_extruder_ && has('e') && moves) add(Dialect::marlin, 3, "an extruder E");
  if (has_checksum(text_)) add(Dialect::marlin, 3, "a checksum at the end of the line");
  look_at_haas_words();
  const bool no_spindle = !has('s') && !has('x') && !has('z');
  if (has('g', "40.1") || (has('g', "50") && has('g', "90") && no_spindle))
    add(Dialect::mach3, 3, "a header of Mach3 (G40.1, G50)");
  const bool only_codes =
      std::all_of(words_.begin(), words_.end(), [](const Word& w) { return w.letter == 'g' || w.letter == 'm'; });
  if ((has('g', "70") || has('g', "71")) && only_codes)
    add(Dialect::mach3, 3, "G70 and G71 without words: inch and mm");
  if (has('g', "12") || has('g', "13")) {
    if (has('i')) add(has('z') || has('k') || has('d') ? Dialect::haas : Dialect::mach3, 2, "a pocket G12 or G13");
  }
}

void SignReader::look_at_haas_words() {
  if (has('g', "154") || has('g', "187") || has('g', "103") || has('m', "97"))
    add(Dialect::haas, 3, "a code of Haas (G154, G187, G103, M97)");
  const bool pattern = has('g', "70") || has('g', "71") || has('g', "72");
  if (pattern && has('i') && has('l') && !has('p')) add(Dialect::haas, 3, "a pattern of holes G70, G71 or G72");
  for (const char* offset : {"110", "111", "112", "113", "129"}) {
    if (has('g', offset) && (has('x') || has('y')) && !has('c')) add(Dialect::haas, 2, "a work offset G110 to G129");
  }
}

// What grbl takes and LinuxCNC refuses.
void SignReader::look_at_sender_words() {
  if (has('g', "90")) incremental_ = false;
  if (has('g', "91")) incremental_ = true;
  if (has('g', "53") && incremental_) add(Dialect::grbl, 1, "G53 under G91");
  const bool arc = has('g', "2") || has('g', "3");
  if (arc && has('i') && has('j') && has('k')) add(Dialect::grbl, 1, "an arc with I, J and K");
}

// Lathes have no Y, offsets in their T words, and increments U W.
void SignReader::look_at_lathe_words() {
  const auto lathe = [this](int weight, std::string_view what) { add(Dialect::fanuc_lathe, weight, what); };
  const bool motion = has('x') || has('z') || has('u') || has('w');
  bool has_offset_tool = false;
  for (const Word& word : words_) {
    if (word.letter != 't' || !is_offset_tool(word.number)) continue;
    has_offset_tool = true;
    lathe(2, fmt::format("a tool with its offset, T{}", word.number));
  }
  if (has('m', "6") && !has_offset_tool) lathe(-3, "M6");
  if (has('g', "65") || has('g', "66") || has('g', "10")) return;
  if (has('g', "50") && has('s')) lathe(3, "G50 S");
  if (has('g', "96") && has('s') && !has('d')) lathe(3, "G96");
  const bool contour = has('g', "70") || has('g', "71") || has('g', "72") || has('g', "73");
  if (contour && has('p') && has('q')) lathe(has('u') || has('w') ? 7 : 4, "a turning cycle with P and Q");
  if ((has('g', "28") || has('g', "30")) && (has('u') || has('w'))) lathe(3, "home by U and W");
  if (contour && has('q') && !has('p') && !has('x') && !has('y') && !has('u') && !has('w') && !has('f'))
    add(Dialect::linuxcnc, 3, "a turning cycle with Q");
  if (has('g', "32")) lathe(2, "G32");
  if (has('g', "50") && has('s')) add(Dialect::fanuc_lathe_b, -6, "G50 S");
  if (has('g', "92") && has('s') && !has('x')) add(Dialect::fanuc_lathe_b, 3, "G92 S");
  if ((has('g', "77") || has('g', "78") || has('g', "79")) && (has('x') || has('u')) && has('z'))
    add(Dialect::fanuc_lathe_b, 3, "a cycle G77, G78 or G79");
  if ((has('u') || has('w')) && !has('g', "4") && !contour && motion) lathe(2, "increments U and W");
}

// Feeds of a turn are small: 0.2 mm, 0.01 in.
void SignReader::note_feed(std::string_view number) {
  number.remove_prefix(std::min(number.find_first_not_of(" 0"), number.size()));
  const std::size_t digits = std::min(number.find_first_not_of("0123456789"), number.size());
  if (digits > 1 || (digits == 1 && number.front() > '2')) has_large_feed_ = true;
  if (digits == 0 && !number.empty() && number.front() == '.') has_small_feed_ = true;
}

bool SignReader::is_plain(std::string_view line) {
  bool x = false, y = false, z = false, i_or_j = false, k = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const char folded = static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c);
    x = x || folded == 'X';
    y = y || folded == 'Y';
    z = z || folded == 'Z';
    i_or_j = i_or_j || folded == 'I' || folded == 'J';
    k = k || folded == 'K';
    if (folded == 'G') {
      std::size_t at = i + 1;
      while (at < line.size() && line[at] == '0') ++at;
      if (at < line.size() && line[at] >= '1' && line[at] <= '3') ++at;
      if (at == i + 1 || (at < line.size() && ((line[at] >= '0' && line[at] <= '9') || line[at] == '.'))) return false;
    } else if (folded >= 'A' && folded <= 'Z') {
      if (folded == 'F') note_feed(line.substr(i + 1));
      if (std::string_view("XYZIJKFN").find(folded) == std::string_view::npos) return false;
    } else if (std::string_view("0123456789.-+ \r\t").find(c) == std::string_view::npos) {
      return false;
    }
  }
  if (k && i_or_j) return false;
  turns_in_xz_ = turns_in_xz_ || (k && !y);
  has_x_ = has_x_ || x;
  has_y_ = has_y_ || y;
  has_z_ = has_z_ || z;
  seen_block_ = seen_block_ || !line.empty();
  return true;
}

const std::vector<Sign>& SignReader::look_at_axes(bool may_be_linuxcnc) {
  signs_.clear();
  if (turns_in_xz_ && !has_plane_ && has_x_ && has_z_ && !has_y_ && !may_be_linuxcnc)
    add(Dialect::fanuc_lathe, 5, "arcs with K, and nowhere Y or a plane");
  if (has_y_) add(Dialect::fanuc_lathe, -3, "Y");
  if (has_x_ && has_z_ && !has_y_) add(Dialect::fanuc_lathe, 1, "X and Z, and nowhere Y");
  if (has_small_feed_ && !has_large_feed_ && has_x_ && has_z_ && !has_y_ && !may_be_linuxcnc)
    add(Dialect::fanuc_lathe, 2, "feeds below 1, as of a turn");
  return signs_;
}

const std::vector<Sign>& SignReader::look_at(std::string_view line) {
  signs_.clear();
  words_.clear();
  look_at_comments(line);
  text_ = fold(line);
  has_extruder_ = line.find(" E") != std::string_view::npos;  // and no exponent: X1e5
  if (text_.rfind("%wait", 0) == 0 || text_.rfind("%msg", 0) == 0) add(Dialect::grbl, 1, "a macro of a sender, %");
  if (text_.empty() || text_.front() == '%') return signs_;
  if (text_.front() == '<' && !seen_block_ && text_.back() == '>') add(Dialect::fanuc, 3, "a program name <>");
  if (text_.front() == '$') add(Dialect::grbl, 3, "a command of a sender, $");
  if (text_ == "?" || text_ == "!" || text_ == "~") add(Dialect::grbl, 1, "a real-time character");
  if (text_.front() == ':' && !seen_block_) add(Dialect::fanuc, 3, "a program number :");
  if (text_.front() == '/') text_.erase(0, 1);
  if (!text_.empty() && text_.front() == 'n') text_.erase(0, skip_number(text_, 1));
  if (text_.empty()) return signs_;
  if (contains(text_, "#<")) add(Dialect::linuxcnc, 3, "a named parameter");
  if (text_.front() == 'o') {
    look_at_o_word();
  } else {
    for (std::size_t at = 0; at < text_.size();) {
      const char c = text_[at];
      std::size_t end = at + 1;
      if (c >= 'a' && c <= 'z') {
        if (end < text_.size() && (text_[end] == '-' || text_[end] == '+')) ++end;
        end = skip_number(text_, end);
        if (end > at + 1) words_.push_back({c, std::string_view(text_).substr(at + 1, end - at - 1)});
      }
      at = end;
    }
    for (const Word& word : words_) {
      if (word.letter == 'f') note_feed(word.number);
    }
    has_x_ = has_x_ || has('x');
    has_y_ = has_y_ || has('y');
    has_z_ = has_z_ || has('z');
    has_plane_ = has_plane_ || has('g', "17") || has('g', "18") || has('g', "19");
    const bool may_turn = has('g', "2") || has('g', "3") || (has('i') && !has('g'));
    turns_in_xz_ = turns_in_xz_ || (may_turn && has('k') && !has('y') && !has('j'));
    look_at_words();
    look_at_sender_words();
    look_at_lathe_words();
  }
  seen_block_ = true;
  return signs_;
}

}  // namespace toolpace::nc
