/// Fanuc mills, and what all of Fanuc's kind share.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {
namespace {

constexpr Code kFirstMachineCode = 1000;  // from G100 on machines define codes of their own, or call macros by them

}  // namespace

std::optional<CodeUse<GGroup>> fanuc_g_code(Code code) {
  if (fanuc_unfollowed(code) != nullptr) return std::nullopt;
  switch (code) {
    case 310: return CodeUse<GGroup>{GGroup::motion, true, 383};  // a skip: to its end, if no signal comes
    case 760: return CodeUse<GGroup>{GGroup::motion, true, kFineBoring};
    case 842: return CodeUse<GGroup>{GGroup::motion, true, 840};  // rigid tapping
    case 843: return CodeUse<GGroup>{GGroup::motion, true, 740};
    case 870: return CodeUse<GGroup>{GGroup::motion, true, kBackBoring};
    case 120: return CodeUse<GGroup>{GGroup::once, true, kPocketRight};
    case 130: return CodeUse<GGroup>{GGroup::once, true, kPocketLeft};
    case 270: return CodeUse<GGroup>{GGroup::once, true, kToReference};
    case 290: return CodeUse<GGroup>{GGroup::once, true, kFromReference};
    case 1000: return CodeUse<GGroup>{GGroup::once, true, kToolMove};
    case 434:
    case 435:
    case 440: return CodeUse<GGroup>{GGroup::tool_length};
    case 541: return CodeUse<GGroup>{GGroup::system};
    case 1540: return CodeUse<GGroup>{GGroup::system, true, 541};  // Haas: G154 P is G54.1 P
    case 1030: return CodeUse<GGroup>{GGroup::ignored};            // look-ahead
    case 51: return CodeUse<GGroup>{GGroup::path_control, true, kContourControl};
    case kSmoothness: return CodeUse<GGroup>{GGroup::path_control};
    default: break;
  }
  if (is_listed(code, {650, 660, 670})) return CodeUse<GGroup>{GGroup::macro};
  if (is_listed(code, {680, 690})) return CodeUse<GGroup>{GGroup::turn_plane};
  if (is_listed(code, {150, 160})) return CodeUse<GGroup>{GGroup::polar};
  if (is_listed(code, {500, 510})) return CodeUse<GGroup>{GGroup::scale};
  if (is_listed(code, {501, 511})) return CodeUse<GGroup>{GGroup::mirror};
  // Smoothing, data entry, exact stops and cutting modes, single-direction positioning, and ends of what has not begun.
  if (is_listed(code, {50,  54,  80,  90,  106, 110, 131, 230, 390, 401, 502, 542, 544,
                       600, 611, 612, 620, 630, 641, 691, 801, 961, 962, 963, 964, 1130})) {
    return CodeUse<GGroup>{GGroup::ignored};
  }
  // Stroke limits, measuring of tools and work: the axis words are theirs.
  if (is_listed(code, {220, 350, 360, 370, 371, 372, 373, 1360})) return CodeUse<GGroup>{GGroup::kept};
  if (const auto group = common_g_group(code)) return CodeUse<GGroup>{*group};
  if (code >= kFirstMachineCode && code % 10 == 0) return CodeUse<GGroup>{GGroup::machine};
  return std::nullopt;
}

std::optional<CodeUse<GGroup>> foreign_g_code(Code code) {
  auto use = fanuc_g_code(code);
  if (!use || use->group == GGroup::machine) return std::nullopt;
  use->by_dialect = false;
  return use;
}

const char* fanuc_unfollowed(Code code) {
  switch (code) {
    case 700:
    case 710:
    case 720:
    case 750: return "turns a contour given by its line numbers";
    case 22:
    case 32: return "cuts an involute";
    case 24:
    case 34: return "cuts an arc in space";
    case 62: return "cuts a NURBS curve";
    case 71:
    case 1070: return "wraps the path around a cylinder";
    case 121:
    case 1120: return "interpolates in polar coordinates (X and C as a plane on the turning work)";
    case 450:
    case 460:
    case 470:
    case 480: return "lengthens the move by a tool's offset";
    case 512: return "turns a polygon";
    case 531:
    case 682:
    case 683:
    case 684: return "tilts the work plane";
    case 721:
    case 722: return "copies a figure";
    default: return nullptr;
  }
}

std::optional<CodeUse<MGroup>> fanuc_m_code(int number) {
  if (const auto group = common_m_group(number)) return CodeUse<MGroup>{*group};
  if (number == 48 || number == 49) return CodeUse<MGroup>{MGroup::override_};
  if (number == 198) return CodeUse<MGroup>{MGroup::subprogram};
  if (number >= 0 && number < 10000) return CodeUse<MGroup>{MGroup::ignored};
  return std::nullopt;
}

constinit const DialectRules kFanucRules = fanuc_kind(Dialect::fanuc);

}  // namespace toolpace::nc
