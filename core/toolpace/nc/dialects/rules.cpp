#include "toolpace/nc/dialects/rules.h"

#include <algorithm>

namespace toolpace {
namespace {

struct Name {
  Dialect dialect;
  std::string_view name;
};
constexpr Name kNames[] = {{Dialect::automatic, "auto"},
                           {Dialect::linuxcnc, "linuxcnc"},
                           {Dialect::fanuc, "fanuc"},
                           {Dialect::fanuc_lathe, "fanuc-lathe"},
                           {Dialect::fanuc_lathe_b, "fanuc-lathe-b"},
                           {Dialect::haas, "haas"},
                           {Dialect::mach3, "mach3"},
                           {Dialect::grbl, "grbl"},
                           {Dialect::marlin, "marlin"}};
constexpr Dialect kAll[] = {Dialect::automatic,   Dialect::linuxcnc,      Dialect::fanuc,
                            Dialect::fanuc_lathe, Dialect::fanuc_lathe_b, Dialect::haas,
                            Dialect::mach3,       Dialect::grbl,          Dialect::marlin};

}  // namespace

std::string_view dialect_name(Dialect dialect) {
  return std::find_if(std::begin(kNames), std::end(kNames), [&](const Name& n) { return n.dialect == dialect; })->name;
}

std::optional<Dialect> dialect_named(std::string_view name) {
  const auto found = std::find_if(std::begin(kNames), std::end(kNames), [&](const Name& n) { return n.name == name; });
  return found == std::end(kNames) ? std::nullopt : std::optional(found->dialect);
}

std::span<const Dialect> all_dialects() { return kAll; }

}  // namespace toolpace

namespace toolpace::nc {

const DialectRules& rules_of(Dialect dialect) {
  for (const DialectRules* rules :
       {&kFanucRules, &kFanucLatheRules, &kFanucLatheBRules, &kHaasRules, &kMach3Rules, &kGrblRules, &kMarlinRules}) {
    if (rules->dialect == dialect) return *rules;
  }
  return kLinuxcncRules;
}

const DialectRules& rules_of_unmarked_text() { return kUnmarkedRules; }

bool is_listed(int code, std::initializer_list<int> list) {
  return std::find(list.begin(), list.end(), code) != list.end();
}

std::optional<GGroup> common_g_group(Code code) {
  if (is_listed(code, {40, 100, 280, 281, 300, 301, 520, 530, 920, 921, 922, 923})) return GGroup::once;
  if (is_listed(code, {0,   10,  20,  30,  50,  51,  52,  53,  330, 331, 382, 383, 384, 385,
                       730, 740, 760, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890})) {
    return GGroup::motion;
  }
  if (is_listed(code, {170, 180, 190})) return GGroup::plane;
  if (is_listed(code, {900, 910})) return GGroup::distance;
  if (is_listed(code, {901, 911})) return GGroup::arc_distance;
  if (is_listed(code, {930, 940, 950})) return GGroup::feed_mode;
  if (is_listed(code, {200, 210})) return GGroup::units;
  if (is_listed(code, {400, 410, 411, 420, 421})) return GGroup::compensation;
  if (is_listed(code, {430, 431, 432, 490})) return GGroup::tool_length;
  if (is_listed(code, {980, 990})) return GGroup::retract;
  if (is_listed(code, {540, 550, 560, 570, 580, 590, 591, 592, 593})) return GGroup::system;
  if (is_listed(code, {610, 611, 640})) return GGroup::path_control;
  if (is_listed(code, {960, 970})) return GGroup::spindle_mode;
  if (is_listed(code, {70, 80})) return GGroup::lathe_diameter;
  return std::nullopt;
}

std::optional<MGroup> common_m_group(int number) {
  if (is_listed(number, {0, 1, 2, 30, 60})) return MGroup::stop;
  if (is_listed(number, {98, 99})) return MGroup::subprogram;
  if (is_listed(number, {3, 4, 5, 19})) return MGroup::spindle;
  if (is_listed(number, {6, 61})) return MGroup::tool;
  if (is_listed(number, {7, 8, 9})) return MGroup::coolant;
  return std::nullopt;
}

const char* nothing_unfollowed(Code) { return nullptr; }

}  // namespace toolpace::nc
