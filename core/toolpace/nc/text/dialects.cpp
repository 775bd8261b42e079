#include "toolpace/nc/text/dialects.h"

#include <algorithm>
#include <string>

namespace toolpace::nc {
namespace {

constexpr std::size_t kDetectionBytes = std::size_t{256} * 1024;

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

std::size_t skip_number(const std::string& text, std::size_t at) {
  while (at < text.size() && ((text[at] >= '0' && text[at] <= '9') || text[at] == '.')) ++at;
  return at;
}

struct Hints {
  bool linuxcnc = false, fanuc = false, grbl = false, program_number = false, seen_block = false;
};

// Codes of 3D printers that machine tools do not have.
bool is_printing(const std::string& text) {
  for (const char* marlin : {"m104s", "m109s", "m140s", "m190s", "m106", "m107", "m110", "m117", "m82", "m83", "m201",
                             "m203", "m204", "m205", "m420", "m600", "g92e"}) {
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

// O-words with a keyword and <names> are LinuxCNC's alone.
void look_at_o_word(const std::string& text, Hints& hints) {
  std::size_t at = 1;
  if (at < text.size() && (text[at] == '<' || text[at] == '#' || text[at] == '[')) {
    hints.linuxcnc = true;
    return;
  }
  at = skip_number(text, at);
  for (const char* word : {"sub", "endsub", "call", "if", "else", "endif", "while", "do", "endwhile", "repeat",
                           "endrepeat", "return", "break", "continue"}) {
    if (text.compare(at, std::string_view(word).size(), word) == 0) hints.linuxcnc = true;
  }
  if (!hints.linuxcnc && !hints.seen_block) hints.program_number = true;
}

void look_at_line(std::string_view line, Hints& hints) {
  std::string text = fold(line);
  if (text.empty() || text.front() == '%') return;
  if (text.front() == '$') hints.grbl = true;
  if (text.front() == ':') hints.program_number = hints.program_number || !hints.seen_block;
  if (text.front() == 'n') text.erase(0, skip_number(text, 1));
  if (text.empty()) return;
  if (text.front() == 'o') {
    look_at_o_word(text, hints);
  } else {
    if (contains(text, "goto") || contains(text, "g65p") || contains(text, "g66p") || text.rfind("if[", 0) == 0 ||
        text.rfind("while[", 0) == 0) {
      hints.fanuc = true;
    }
    if (is_printing(text)) hints.grbl = true;
    if (has_checksum(text)) hints.grbl = true;
  }
  if (contains(text, "#<")) hints.linuxcnc = true;
  hints.seen_block = true;
}

bool is_one_of(int code, std::initializer_list<int> list) {
  return std::find(list.begin(), list.end(), code) != list.end();
}

// Codes of every dialect that this reader follows.
std::optional<GGroup> common_group(int code) {
  if (is_one_of(code, {40, 100, 280, 281, 300, 301, 520, 530, 920, 921, 922, 923})) return GGroup::once;
  if (is_one_of(code, {0,   10,  20,  30,  50,  51,  52,  53,  330, 331, 382, 383, 384, 385,
                       730, 740, 760, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890})) {
    return GGroup::motion;
  }
  if (is_one_of(code, {170, 180, 190})) return GGroup::plane;
  if (is_one_of(code, {900, 910})) return GGroup::distance;
  if (is_one_of(code, {901, 911})) return GGroup::arc_distance;
  if (is_one_of(code, {930, 940, 950})) return GGroup::feed_mode;
  if (is_one_of(code, {200, 210})) return GGroup::units;
  if (is_one_of(code, {400, 410, 411, 420, 421})) return GGroup::compensation;
  if (is_one_of(code, {430, 431, 432, 490})) return GGroup::tool_length;
  if (is_one_of(code, {980, 990})) return GGroup::retract;
  if (is_one_of(code, {540, 550, 560, 570, 580, 590, 591, 592, 593})) return GGroup::system;
  if (is_one_of(code, {610, 611, 640})) return GGroup::path_control;
  if (is_one_of(code, {960, 970})) return GGroup::spindle_mode;
  if (is_one_of(code, {70, 80})) return GGroup::lathe_diameter;
  return std::nullopt;
}

bool is_turning(int code) { return is_one_of(code, {700, 710, 711, 712, 720, 721, 722}); }

std::optional<GGroup> fanuc_group(int code) {
  if (is_one_of(code, {650, 660, 670})) return GGroup::macro;
  if (is_one_of(code, {680, 690})) return GGroup::turn_plane;
  if (is_one_of(code, {50, 51, 80, 90, 150, 270, 500, 620, 630, 641})) return GGroup::ignored;
  return std::nullopt;
}

bool grbl_has(int code) {
  return is_one_of(code,
                   {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 281, 300, 301, 382, 383, 384, 385,
                    400, 431, 490, 530, 540, 550, 560, 570, 580, 590, 610, 800, 900, 910, 911, 920, 921, 930, 940});
}

}  // namespace

const char* dialect_name(Dialect dialect) {
  switch (dialect) {
    case Dialect::fanuc: return "fanuc";
    case Dialect::grbl: return "grbl";
    case Dialect::automatic:
    case Dialect::linuxcnc: break;
  }
  return "linuxcnc";
}

Dialect detect_dialect(std::string_view text) {
  text = text.substr(0, kDetectionBytes);
  Hints hints;
  while (!text.empty() && !hints.linuxcnc) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    look_at_line(text.substr(0, std::min<std::size_t>(length, 1000)), hints);
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  if (hints.linuxcnc) return Dialect::linuxcnc;
  if (hints.fanuc || hints.program_number) return Dialect::fanuc;
  return hints.grbl ? Dialect::grbl : Dialect::linuxcnc;
}

bool looks_like_printing(std::string_view text) {
  text = text.substr(0, kDetectionBytes);
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string line = fold(text.substr(0, std::min<std::size_t>(length, 1000)));
    if (!line.empty() && line.front() == 'n') line.erase(0, skip_number(line, 1));
    if (is_printing(line)) return true;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return false;
}

bool is_sender_command(Scanner text) {
  const char c = text.peek();
  if (c == '$') return true;
  if (c != '?' && c != '!' && c != '~') return false;
  text.take();
  return text.peek() == '\0';
}

std::optional<CodeUse<GGroup>> g_code_use(Code tenths, Dialect dialect) {
  if (dialect == Dialect::fanuc) {
    if (const auto group = fanuc_group(tenths)) return CodeUse<GGroup>{*group, true};
  }
  if (dialect == Dialect::linuxcnc && is_turning(tenths)) return CodeUse<GGroup>{GGroup::motion, true};
  if (const auto group = common_group(tenths)) {
    return CodeUse<GGroup>{*group, dialect != Dialect::grbl || grbl_has(tenths)};
  }
  // Codes of printers and senders that move nothing that a program's path depends on.
  if (dialect == Dialect::grbl && is_one_of(tenths, {290})) return CodeUse<GGroup>{GGroup::ignored, true};
  if (const auto group = fanuc_group(tenths)) return CodeUse<GGroup>{*group, false};
  return std::nullopt;
}

const char* unfollowed_code(Code tenths, Dialect dialect) {
  if (dialect != Dialect::fanuc) return nullptr;
  switch (tenths) {
    case 700:
    case 710:
    case 720:
    case 750: return "turns a contour given by its line numbers";
    case 71: return "wraps the path around a cylinder";
    case 121:
    case 1120: return "interpolates in polar coordinates";
    case 160: return "begins polar coordinates";
    case 310: return "moves until a signal comes";
    case 501:
    case 511: return "mirrors the path";
    case 510: return "scales the path";
    default: return nullptr;
  }
}

std::optional<CodeUse<MGroup>> m_code_use(int number, Dialect dialect) {
  if (is_one_of(number, {0, 1, 2, 30, 60})) return CodeUse<MGroup>{MGroup::stop};
  if (number == 198 && dialect == Dialect::fanuc) return CodeUse<MGroup>{MGroup::subprogram};
  if (is_one_of(number, {98, 99})) return CodeUse<MGroup>{MGroup::subprogram, dialect != Dialect::grbl};
  if (is_one_of(number, {3, 4, 5, 19})) return CodeUse<MGroup>{MGroup::spindle};
  if (is_one_of(number, {6, 61})) return CodeUse<MGroup>{MGroup::tool};
  if (is_one_of(number, {7, 8, 9})) return CodeUse<MGroup>{MGroup::coolant};
  if (number >= 48 && number <= 53) return CodeUse<MGroup>{MGroup::override_, dialect == Dialect::linuxcnc};
  if (number >= 62 && number <= 68) return CodeUse<MGroup>{MGroup::io, dialect == Dialect::linuxcnc};
  if (number >= 70 && number <= 73) return CodeUse<MGroup>{MGroup::state, dialect == Dialect::linuxcnc};
  if (number >= 100 && number <= 199 && dialect == Dialect::linuxcnc) return CodeUse<MGroup>{MGroup::user};
  if (dialect != Dialect::linuxcnc && number >= 0 && number < 10000) return CodeUse<MGroup>{MGroup::ignored};
  return std::nullopt;
}

}  // namespace toolpace::nc
