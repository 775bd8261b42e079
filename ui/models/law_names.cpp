#include "models/law_names.h"

#include <QCoreApplication>
#include <string>

namespace toolpace::ui {
namespace {

[[maybe_unused]] constexpr const char* kTranslatedTitles[] = {QT_TRANSLATE_NOOP("laws", "Trapezoid"),
                                                              QT_TRANSLATE_NOOP("laws", "Five-phase by time"),
                                                              QT_TRANSLATE_NOOP("laws", "Five-phase by jerk"),
                                                              QT_TRANSLATE_NOOP("laws", "Seven-phase"),
                                                              QT_TRANSLATE_NOOP("laws", "Quintic"),
                                                              QT_TRANSLATE_NOOP("laws", "Time-optimal")};

}  // namespace

QString law_title(const LawRow& row) { return QCoreApplication::translate("laws", std::string(row.title).c_str()); }

}  // namespace toolpace::ui
