#include "toolpace/law/law_table.h"

#include <array>

namespace toolpace {
namespace {

using enum LawParameter;
constexpr std::array kAcceleration{acceleration};
constexpr std::array kTime{time};
constexpr std::array kBoth{acceleration, jerk};

struct Traits {
  std::string_view id, title;
  bool needs_acceleration, needs_jerk, uses_time, bounds_jerk;
  std::span<const LawParameter> parameters;
};

template <VelocityLaw Law>
constexpr LawRow row(const Traits& t) {
  return {Law::kKind,
          t.id,
          t.title,
          t.needs_acceleration,
          t.needs_jerk,
          t.uses_time,
          t.bounds_jerk,
          t.parameters,
          &Law::duration,
          &Law::reach,
          &Law::peak_acceleration,
          &Law::peak_jerk,
          &Law::template append_ramp<std::vector<Phase>>};
}

constexpr std::array kTable{
    row<Trapezoid>({"trapezoid", "Trapezoid", true, false, false, false, kAcceleration}),
    row<FivePhaseTime>({"five-phase-time", "Five-phase by time", false, false, true, true, kTime}),
    row<FivePhaseJerk>({"five-phase-jerk", "Five-phase by jerk", false, true, false, true, kBoth}),
    row<SevenPhase>({"seven-phase", "Seven-phase", true, true, false, true, kBoth}),
    row<Quintic>({"quintic", "Quintic", true, true, false, true, kBoth}),
    row<TimeOptimal>({"time-optimal", "Time-optimal", true, true, false, true, kBoth}),
};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    if (static_cast<std::size_t>(kTable[i].kind) != i) return false;
  }
  return true;
}
static_assert(is_in_order(), "law_row() looks rows up by kind");

}  // namespace

std::span<const LawRow> law_table() { return kTable; }

const LawRow& law_row(LawKind kind) { return kTable.at(static_cast<std::size_t>(kind)); }

std::optional<LawKind> find_law(std::string_view id) {
  for (const LawRow& r : kTable) {
    if (r.id == id) return r.kind;
  }
  return std::nullopt;
}

std::string law_ids() {
  std::string text;
  for (const LawRow& r : kTable) {
    if (!text.empty()) text += ", ";
    text += r.id;
  }
  return text;
}

}  // namespace toolpace
