#include "models/problem_action.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace toolpace::ui {
namespace {

struct Remedied {
  const char* code;
  ProblemAction action;
};

constexpr std::array kRemedied = {Remedied{"arc-radius-differs", ProblemAction::arc_tolerance},
                                  Remedied{"axis-not-there", ProblemAction::machine},
                                  Remedied{"parameter-undefined", ProblemAction::parameters},
                                  Remedied{"pocket-tool-unknown", ProblemAction::tool_table},
                                  Remedied{"sub-program-missing", ProblemAction::sub_folder},
                                  Remedied{"sub-program-unknown", ProblemAction::sub_folder},
                                  Remedied{"tool-table-missing", ProblemAction::tool_table},
                                  Remedied{"tool-unknown", ProblemAction::tool_table}};

}  // namespace

ProblemAction action_for(const std::string& code) {
  const auto found =
      std::find_if(kRemedied.begin(), kRemedied.end(), [&](const Remedied& r) { return code == r.code; });
  return found == kRemedied.end() ? ProblemAction::none : found->action;
}

QString action_text(ProblemAction action) {
  switch (action) {
    case ProblemAction::tool_table: return QCoreApplication::translate("ProblemAction", "Tool table…");
    case ProblemAction::parameters: return QCoreApplication::translate("ProblemAction", "Parameters…");
    case ProblemAction::sub_folder: return QCoreApplication::translate("ProblemAction", "Folder…");
    case ProblemAction::arc_tolerance: return QCoreApplication::translate("ProblemAction", "Arc tolerance…");
    case ProblemAction::machine: return QCoreApplication::translate("ProblemAction", "Machine…");
    case ProblemAction::none: break;
  }
  return {};
}

}  // namespace toolpace::ui
