/// Haas mills: of Fanuc's kind, with codes of their own.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {
namespace {

std::optional<CodeUse<GGroup>> haas_g_code(Code code) {
  if (code == 1540) return CodeUse<GGroup>{GGroup::system, true, 541};  // G154 P is G54.1 P
  // Smoothness, limiting of look-ahead, coordinates of other pallets' fixtures.
  if (is_listed(code, {1030, 1870})) return CodeUse<GGroup>{GGroup::ignored};
  return fanuc_g_code(code);
}

std::optional<CodeUse<MGroup>> haas_m_code(int number) {
  if (number == 97) return CodeUse<MGroup>{MGroup::subprogram};
  return fanuc_m_code(number);
}

const char* haas_unfollowed(Code code) {
  switch (code) {
    case 120:
    case 130: return "mills a circular pocket";
    case 1500: return "mills a pocket";
    case 470: return "engraves text";
    default: return fanuc_unfollowed(code);
  }
}

}  // namespace

constinit const DialectRules kHaasRules = [] {
  DialectRules rules = fanuc_kind(Dialect::haas);
  rules.repeats_by_k = rules.repeats_within_p = false;  // L repeats
  rules.g_code = haas_g_code;
  rules.m_code = haas_m_code;
  rules.unfollowed = haas_unfollowed;
  return rules;
}();

}  // namespace toolpace::nc
