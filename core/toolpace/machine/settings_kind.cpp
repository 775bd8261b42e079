#include "toolpace/machine/settings_kind.h"

#include <algorithm>
#include <array>

#include "toolpace/machine/importer.h"

namespace toolpace {
namespace {

constexpr std::string_view kReprapfirmware = "a config.g of RepRapFirmware";

struct Sign {
  std::string_view begin;  ///< of a line
  std::string_view kind;
};

// Surer ones first.
constexpr std::array<Sign, 15> kSigns = {{{"max_rate_mm_per_min:", "a config.yaml of FluidNC"},
                                          {"alpha_steps_per_mm", "a config of Smoothieware"},
                                          {"alpha_max_rate", "a config of Smoothieware"},
                                          {"#define DEFAULT_MAX_", "a header of Marlin's sources"},
                                          {"<profile", "a profile of Mach3"},
                                          {"<?xml", "an XML file"},
                                          {"<!DOCTYPE", "a page of HTML"},
                                          {"<html", "a page of HTML"},
                                          {"[machine]", "a machine file, which --machine takes"},
                                          {"[path]", "a machine file, which --machine takes"},
                                          {"[axes.", "a machine file, which --machine takes"},
                                          {"G0", "an NC program"},
                                          {"G1", "an NC program"},
                                          {"G2", "an NC program"},
                                          {"G90", "an NC program"}}};

bool is_command(std::string_view line, std::string_view code) {
  return line.starts_with(code) && line.size() > code.size() && line[code.size()] == ' ';
}

}  // namespace

bool is_reprapfirmware(std::string_view text) {
  bool is = false;
  for_each_line(text, [&](std::string_view line, std::size_t) {
    is = is || is_command(line, "M566") || is_command(line, "M584");
  });
  return is;
}

std::string_view kind_of_other_text(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return "an empty file";
  if (text.find('\0') != std::string_view::npos) return "no text, or one in UTF-16: save it as UTF-8";
  if (is_reprapfirmware(text)) return kReprapfirmware;
  std::size_t best = kSigns.size();
  for_each_line(text, [&](std::string_view line, std::size_t) {
    const auto* const sign = std::find_if(kSigns.begin(), kSigns.begin() + static_cast<std::ptrdiff_t>(best),
                                          [&](const Sign& s) { return line.starts_with(s.begin); });
    best = std::min(best, static_cast<std::size_t>(sign - kSigns.begin()));
  });
  return best < kSigns.size() ? kSigns[best].kind : std::string_view();
}

}  // namespace toolpace
