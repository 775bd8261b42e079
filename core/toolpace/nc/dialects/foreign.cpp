#include "toolpace/nc/dialects/foreign.h"

#include <algorithm>
#include <string>

namespace toolpace::nc {
namespace {

constexpr std::size_t kLinesLookedAt = 400;
constexpr std::size_t kLongestForeignLine = 300;

constexpr const char* kHeidenhain = "a conversational program for Heidenhain controllers";
constexpr const char* kHeidenhainIso = "a DIN/ISO program for Heidenhain controllers";
constexpr const char* kSiemens = "a program for Siemens controllers (Sinumerik)";
constexpr const char* kOkuma = "a program for Okuma controllers (OSP)";
constexpr const char* kApt = "an APT or cutter location file";
constexpr const char* kGerber = "a Gerber drawing";
constexpr const char* kExcellon = "an Excellon drill file";
constexpr const char* kPlotter = "a plotter file (HPGL)";
constexpr const char* kShopBot = "a part file for ShopBot";
constexpr const char* kSyntec = "a macro program for Syntec controllers";
constexpr const char* kAnilam = "a conversational program for Anilam controllers";
constexpr const char* kTrumpf = "a program for TRUMPF lasers";
constexpr const char* kFagor = "a program for Fagor controllers";
constexpr const char* kFadal = "a program with the sub-programs of Fadal controllers (L and M17)";
constexpr const char* kWood = "a program of a woodworking machine";

struct Mark {
  const char* text;  // in capitals, without comments
  const char* language;
  bool begins_line;
};
constexpr Mark kMarks[] = {{"BEGIN PGM", kHeidenhain, false},
                           {"TOOL CALL ", kHeidenhain, false},
                           {"BLK FORM ", kHeidenhain, false},
                           {"CYCL DEF", kHeidenhain, false},
                           {"%_N_", kSiemens, true},
                           {"CYCLE800(", kSiemens, false},
                           {"CYCLE8", kSiemens, false},
                           {"MCALL ", kSiemens, false},
                           {"T=\"", kSiemens, false},
                           {"CR=", kSiemens, false},
                           {"=IC(", kSiemens, false},
                           {"=AC(", kSiemens, false},
                           {"DEF REAL ", kSiemens, false},
                           {"DEF INT ", kSiemens, false},
                           {"MSG(\"", kSiemens, false},
                           {"WORKPIECE(", kSiemens, false},
                           {"SUPA ", kSiemens, false},
                           {"TRAORI", kSiemens, false},
                           {"GOTOF ", kSiemens, false},
                           {"GOTOB ", kSiemens, false},
                           {"STOPRE", kSiemens, false},
                           {"LIMS=", kSiemens, false},
                           {"SPOS=", kSiemens, false},
                           {"ROT ", kSiemens, true},
                           {"TRANS ", kSiemens, true},
                           {"ATRANS ", kSiemens, true},
                           {"AROT ", kSiemens, true},
                           {"CALL O", kOkuma, false},
                           {"VC1=", kOkuma, false},
                           {"PARTNO", kApt, true},
                           {"LOADTL/", kApt, false},
                           {"GOTO/", kApt, false},
                           {"%FSLA", kGerber, true},
                           {"METRIC,TZ", kExcellon, true},
                           {"METRIC,LZ", kExcellon, true},
                           {"INCH,TZ", kExcellon, true},
                           {"INCH,LZ", kExcellon, true},
                           {"IN;", kPlotter, true},
                           {"NAT0", kOkuma, true},
                           {"NAT1", kOkuma, true},
                           {"NLAP", kOkuma, true},
                           {"'SHOPBOT", kShopBot, true},
                           {"J2,", kShopBot, true},
                           {"J3,", kShopBot, true},
                           {"M2,", kShopBot, true},
                           {"M3,", kShopBot, true},
                           {"JZ,", kShopBot, true},
                           {"MZ,", kShopBot, true},
                           {"%@MACRO", kSyntec, true},
                           {"DIM ABS", kAnilam, true},
                           {"DIM INC", kAnilam, true},
                           {"TC_LASER_ON(", kTrumpf, false},
                           {"BEGIN ID CID3", kWood, true},
                           {"VERSION=\"4.0", kWood, true}};

// CYCLE81( and MSG( open no comment: words of three letters and more stand before the parenthesis.
bool ends_in_function(const std::string& text) {
  std::size_t begin = text.size();
  while (begin > 0 &&
         ((text[begin - 1] >= 'A' && text[begin - 1] <= 'Z') || (text[begin - 1] >= '0' && text[begin - 1] <= '9')))
    --begin;
  std::size_t letters = begin;
  while (letters < text.size() && text[letters] >= 'A') ++letters;
  return letters - begin >= 3;
}

std::string without_comments(std::string_view line) {
  std::string text;
  int depth = 0;
  for (const char c : line) {
    if (c == ';' && depth == 0 && !text.empty() && text != "IN") break;
    if (c == '(' && (depth > 0 || !ends_in_function(text))) ++depth;
    if (depth == 0) text.push_back(static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c));
    if (c == ')' && depth > 0) --depth;
  }
  return text;
}

bool is_iso_of_heidenhain(const std::string& text) {
  const std::size_t last = text.find_last_not_of(" \t\r");
  return last != std::string::npos && text[last] == '*' && text[0] == '%' && text.find(" G7") != std::string::npos;
}

/// "(IF P0 GT 5 GOTO N20)", "(RPT N10,N20)", "(CALL 5)", "(P1=P2+3)": what stands in parentheses acts.
bool acts_in_parentheses(std::string_view line) {
  std::string text;
  for (const char c : line) {
    if (static_cast<unsigned char>(c) > ' ') text.push_back(static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c));
  }
  const std::size_t open = text.find('('), close = text.find(')');
  if (open == std::string::npos || close == std::string::npos || close < open) return false;
  const std::string inside = text.substr(open + 1, close - open - 1);
  const auto begins = [&](std::string_view word) {
    return inside.size() > word.size() && inside.compare(0, word.size(), word) == 0 && inside[word.size()] >= '0' &&
           inside[word.size()] <= '9';
  };
  const auto has_only = [&](std::size_t from, const char* characters) {
    return inside.find_first_not_of(characters, from) == std::string::npos;
  };
  if (begins("IFP")) return inside.find("GOTON") != std::string::npos;
  if (begins("RPTN")) return has_only(4, "0123456789,N");
  if (begins("GOTON")) return has_only(5, "0123456789");
  if (begins("CALL")) return has_only(4, "0123456789");
  return begins("P") && inside.find('=') != std::string::npos && has_only(1, "0123456789P=+-*/.");
}

/// The line without its number and blanks.
std::string statement(const std::string& words) {
  std::string text;
  for (const char c : words) {
    if (static_cast<unsigned char>(c) > ' ') text.push_back(c);
  }
  if (!text.empty() && text.front() == 'N')
    text.erase(0, std::min(text.find_first_not_of("0123456789", 1), text.size()));
  return text;
}

/// T1.1 is tool 1 with offset 1, and I of a cycle its depth, which begins at Z.
bool is_of_fagor(const std::string& statement) {
  if (statement.empty() || statement.front() == 'M' || statement.find_first_of("[#<") != std::string::npos)
    return false;
  const std::size_t tool = statement.find('T');
  const auto digit_at = [&](std::size_t at) {
    return at < statement.size() && statement[at] >= '0' && statement[at] <= '9';
  };
  if (tool != std::string::npos && (tool == 0 || digit_at(tool - 1)) && digit_at(tool + 1)) {
    const std::size_t point = statement.find_first_not_of("0123456789", tool + 1);
    if (point < statement.size() && statement[point] == '.' && digit_at(point + 1)) return true;
  }
  const std::size_t cycle = statement.find("G8");
  if (cycle == std::string::npos || !digit_at(cycle + 2) || statement[cycle + 2] == '0' || statement[cycle + 2] == '7')
    return false;
  const auto has = [&](char letter) { return statement.find(letter) != std::string::npos; };
  return !digit_at(cycle + 3) && has('Z') && has('I') && !has('R') && !has('Q');
}

/// Siemens' words have '=' where a number does not follow at once, Y=12+10; DIAMON stands without one. Lines of printers' macros begin with a name.
bool speaks_siemens(const std::string& statement) {
  const auto is_capital = [&](std::size_t at) { return statement[at] >= 'A' && statement[at] <= 'Z'; };
  if (statement.size() < 3 || (is_capital(0) && is_capital(1) && statement.rfind("DIAM", 0) != 0) ||
      statement.rfind("M11", 0) == 0)
    return false;
  for (const std::string_view word : {"DIAMON", "DIAMOF"}) {
    if (statement.size() >= word.size() && statement.compare(statement.size() - word.size(), word.size(), word) == 0)
      return true;
  }
  for (std::size_t at = statement.find('='); at != std::string::npos; at = statement.find('=', at + 1)) {
    if (at > 0 && std::string_view("XYZABCIJKFH").find(statement[at - 1]) != std::string_view::npos &&
        (at == 1 || !is_capital(at - 2)))
      return statement.find_first_of("#<[_@\"{") == std::string::npos;
  }
  return false;
}

/// "L100" alone: where a sub-program begins, or its call.
bool is_label(const std::string& statement) {
  return statement.size() > 1 && statement.front() == 'L' &&
         statement.find_first_not_of("0123456789", 1) == std::string::npos;
}

/// R1=10: Siemens' variables.
bool assigns_r_parameter(const std::string& text) {
  for (std::size_t at = text.find('R'); at != std::string::npos; at = text.find('R', at + 1)) {
    if (at > 0 && text[at - 1] != ' ' && text[at - 1] != '\t') continue;
    const std::size_t behind = text.find_first_not_of("0123456789", at + 1);
    if (behind != std::string::npos && behind > at + 1 && text[behind] == '=') return true;
  }
  return false;
}

}  // namespace

std::optional<ForeignLanguage> find_foreign_language(std::string_view text) {
  std::size_t label = 0;
  for (std::size_t line = 1; line <= kLinesLookedAt && !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const std::string_view whole = text.substr(0, std::min(length, kLongestForeignLine));
    const std::string words = without_comments(whole);
    if (acts_in_parentheses(whole)) return ForeignLanguage{kFagor, line, 1};
    text.remove_prefix(std::min(length + 1, text.size()));
    if (words.empty() || words.front() == ';') continue;
    const std::string said = statement(words);
    if (speaks_siemens(said)) return ForeignLanguage{kSiemens, line, 1};
    if (is_of_fagor(said)) return ForeignLanguage{kFagor, line, 1};
    if (label == 0 && is_label(said)) label = line;
    if (label != 0 && said == "M17") return ForeignLanguage{kFadal, label, 1};
    if (is_iso_of_heidenhain(words)) return ForeignLanguage{kHeidenhainIso, line, 1};
    if (assigns_r_parameter(words)) return ForeignLanguage{kSiemens, line, words.find('R') + 1};
    for (const Mark& mark : kMarks) {
      const std::size_t at = words.find(mark.text);
      if (at == std::string::npos || (mark.begins_line && at != 0)) continue;
      return ForeignLanguage{mark.language, line, at + 1};
    }
  }
  return std::nullopt;
}

}  // namespace toolpace::nc
