#include "toolpace/nc/dialects/detect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "toolpace/nc/dialects/rules.h"
#include "toolpace/nc/dialects/signs.h"

namespace toolpace::nc {
namespace {

constexpr std::size_t kDetectionBytes = std::size_t{256} * 1024;
constexpr std::size_t kLongestLookedAt = 1000;
constexpr std::size_t kDialects = static_cast<std::size_t>(Dialect::marlin) + 1;
constexpr std::size_t kMostReasons = 4;
constexpr int kCertain = 6;  // by strong signs: two of them, or one and weak ones
constexpr int kStrong = 3;   // a sign that decides; less makes no lathe of a mill

// Each sign counts once, however often it comes.
class Evidence {
 public:
  void add(const Sign& sign, std::size_t line) {
    Found& of = found_[static_cast<std::size_t>(sign.dialect)];
    if (std::find(of.seen.begin(), of.seen.end(), sign.what) != of.seen.end()) return;
    of.seen.push_back(sign.what);
    of.score += sign.weight;
    if (sign.weight > 0 && of.reasons.size() < kMostReasons)
      of.reasons.push_back(line == 0 ? sign.what : fmt::format("line {}: {}", line, sign.what));
  }
  int score(Dialect dialect) const { return found_[static_cast<std::size_t>(dialect)].score; }
  std::vector<std::string>& reasons(Dialect dialect) { return found_[static_cast<std::size_t>(dialect)].reasons; }

 private:
  struct Found {
    int score = 0;
    std::vector<std::string> seen, reasons;
  };
  std::array<Found, kDialects> found_;
};

bool is_named_as_linuxcnc(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  std::string extension(dot == std::string_view::npos ? std::string_view() : name.substr(dot + 1));
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return extension == "ngc";
}

// Haas and the lathes are of Fanuc's kind: what speaks for them speaks for it, too.
Dialect choose(const Evidence& evidence, bool named_as_linuxcnc, Dialect& other) {
  other = Dialect::automatic;
  const int linuxcnc = evidence.score(Dialect::linuxcnc), grbl = evidence.score(Dialect::grbl);
  const int fanuc = evidence.score(Dialect::fanuc), lathe = evidence.score(Dialect::fanuc_lathe);
  const int haas = evidence.score(Dialect::haas), mach3 = evidence.score(Dialect::mach3);
  if (linuxcnc > 0) return Dialect::linuxcnc;
  if (evidence.score(Dialect::marlin) > 0 && fanuc <= 0) return Dialect::marlin;
  // X and Z alone, without another sign, are of no lathe. Mach3 and LinuxCNC turn, too.
  const bool may_be_other = (mach3 > 0 || named_as_linuxcnc) && fanuc <= 0;
  if (lathe >= (may_be_other ? kCertain : kStrong)) {
    if (lathe < kCertain && fanuc <= 0) other = Dialect::linuxcnc;
    return evidence.score(Dialect::fanuc_lathe_b) >= kStrong ? Dialect::fanuc_lathe_b : Dialect::fanuc_lathe;
  }
  if (haas > 0) return Dialect::haas;
  if (mach3 > 0 && mach3 >= fanuc) return Dialect::mach3;
  if (fanuc > 0) {
    if (lathe > 1) other = Dialect::fanuc_lathe;
    return Dialect::fanuc;
  }
  return grbl >= (named_as_linuxcnc ? kStrong : 1) ? Dialect::grbl : Dialect::linuxcnc;
}

}  // namespace

DialectGuess detect_dialect(std::string_view text, std::string_view name) {
  text = text.substr(0, kDetectionBytes);
  Evidence evidence;
  SignReader reader;
  for (std::size_t line = 1; !text.empty() && evidence.score(Dialect::linuxcnc) <= 0; ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const std::string_view content = text.substr(0, std::min(length, kLongestLookedAt));
    if (!reader.is_plain(content)) {
      for (const Sign& sign : reader.look_at(content)) evidence.add(sign, line);
    }
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  const bool named = is_named_as_linuxcnc(name);
  for (const Sign& sign : reader.look_at_axes(named)) evidence.add(sign, 0);
  DialectGuess guess;
  guess.dialect = choose(evidence, named, guess.other);
  guess.reasons = std::move(evidence.reasons(guess.dialect));
  if (guess.dialect == Dialect::fanuc_lathe_b) {
    for (auto& reason : evidence.reasons(Dialect::fanuc_lathe)) guess.reasons.push_back(std::move(reason));
  }
  if (rules_of(guess.dialect).macro_statements && guess.dialect != Dialect::fanuc) {
    for (auto& reason : evidence.reasons(Dialect::fanuc)) guess.reasons.push_back(std::move(reason));
  }
  if (guess.reasons.empty() && named) guess.reasons.emplace_back("the file is named .ngc, as LinuxCNC's are");
  guess.marked = !guess.reasons.empty();
  if (guess.reasons.empty()) guess.reasons.emplace_back("nothing in the text is of another dialect");
  return guess;
}

}  // namespace toolpace::nc
