#include "models/diagnostic_text.h"

#include <QCoreApplication>
#include <array>

namespace toolpace::ui {
namespace {

// Listed for the translators; looked up by code.
[[maybe_unused]] constexpr std::array kCodes = {QT_TRANSLATE_NOOP("codes", "no-feed"),
                                                QT_TRANSLATE_NOOP("codes", "feed-zero"),
                                                QT_TRANSLATE_NOOP("codes", "feed-negative"),
                                                QT_TRANSLATE_NOOP("codes", "g-code-unknown"),
                                                QT_TRANSLATE_NOOP("codes", "m-code-unknown"),
                                                QT_TRANSLATE_NOOP("codes", "g-code-ignored"),
                                                QT_TRANSLATE_NOOP("codes", "m-code-ignored"),
                                                QT_TRANSLATE_NOOP("codes", "modal-group-twice"),
                                                QT_TRANSLATE_NOOP("codes", "word-twice"),
                                                QT_TRANSLATE_NOOP("codes", "word-unused"),
                                                QT_TRANSLATE_NOOP("codes", "number-expected"),
                                                QT_TRANSLATE_NOOP("codes", "number-too-large"),
                                                QT_TRANSLATE_NOOP("codes", "number-not-finite"),
                                                QT_TRANSLATE_NOOP("codes", "bad-number"),
                                                QT_TRANSLATE_NOOP("codes", "bad-character"),
                                                QT_TRANSLATE_NOOP("codes", "bracket-missing"),
                                                QT_TRANSLATE_NOOP("codes", "comment-not-closed"),
                                                QT_TRANSLATE_NOOP("codes", "comment-nested"),
                                                QT_TRANSLATE_NOOP("codes", "arc-radius-too-small"),
                                                QT_TRANSLATE_NOOP("codes", "arc-radius-zero"),
                                                QT_TRANSLATE_NOOP("codes", "arc-radius-differs"),
                                                QT_TRANSLATE_NOOP("codes", "arc-radius-and-centre"),
                                                QT_TRANSLATE_NOOP("codes", "arc-same-point"),
                                                QT_TRANSLATE_NOOP("codes", "arc-incomplete"),
                                                QT_TRANSLATE_NOOP("codes", "arc-centre-incomplete"),
                                                QT_TRANSLATE_NOOP("codes", "axes-without-motion"),
                                                QT_TRANSLATE_NOOP("codes", "axes-missing"),
                                                QT_TRANSLATE_NOOP("codes", "dwell-negative"),
                                                QT_TRANSLATE_NOOP("codes", "dwell-without-time"),
                                                QT_TRANSLATE_NOOP("codes", "program-without-end"),
                                                QT_TRANSLATE_NOOP("codes", "empty-program"),
                                                QT_TRANSLATE_NOOP("codes", "not-text"),
                                                QT_TRANSLATE_NOOP("codes", "no-points"),
                                                QT_TRANSLATE_NOOP("codes", "header-missing"),
                                                QT_TRANSLATE_NOOP("codes", "column-unknown"),
                                                QT_TRANSLATE_NOOP("codes", "line-too-long"),
                                                QT_TRANSLATE_NOOP("codes", "tool-unknown"),
                                                QT_TRANSLATE_NOOP("codes", "spindle-stopped"),
                                                QT_TRANSLATE_NOOP("codes", "division-by-zero"),
                                                QT_TRANSLATE_NOOP("codes", "parameter-undefined"),
                                                QT_TRANSLATE_NOOP("codes", "sub-program-unknown"),
                                                QT_TRANSLATE_NOOP("codes", "calls-too-deep"),
                                                QT_TRANSLATE_NOOP("codes", "too-many-turns"),
                                                QT_TRANSLATE_NOOP("codes", "compensation-gouge"),
                                                QT_TRANSLATE_NOOP("codes", "cycle-without-depth"),
                                                QT_TRANSLATE_NOOP("codes", "inverse-time-without-feed"),
                                                QT_TRANSLATE_NOOP("codes", "code-not-in-dialect"),
                                                QT_TRANSLATE_NOOP("codes", "value-missing"),
                                                QT_TRANSLATE_NOOP("codes", "travel-min"),
                                                QT_TRANSLATE_NOOP("codes", "travel-max"),
                                                QT_TRANSLATE_NOOP("codes", "no-speed-limit"),
                                                QT_TRANSLATE_NOOP("codes", "no-acceleration-limit"),
                                                QT_TRANSLATE_NOOP("codes", "limits-unbounded"),
                                                QT_TRANSLATE_NOOP("codes", "bad-limit"),
                                                QT_TRANSLATE_NOOP("codes", "machine-value"),
                                                QT_TRANSLATE_NOOP("codes", "machine-key"),
                                                QT_TRANSLATE_NOOP("codes", "machine-syntax"),
                                                QT_TRANSLATE_NOOP("codes", "cannot-open"),
                                                QT_TRANSLATE_NOOP("codes", "cannot-write"),
                                                QT_TRANSLATE_NOOP("codes", "file-not-found"),
                                                QT_TRANSLATE_NOOP("codes", "no-permission"),
                                                QT_TRANSLATE_NOOP("codes", "disk-full"),
                                                QT_TRANSLATE_NOOP("codes", "import-empty"),
                                                QT_TRANSLATE_NOOP("codes", "violation-axis-speed"),
                                                QT_TRANSLATE_NOOP("codes", "violation-axis-acceleration"),
                                                QT_TRANSLATE_NOOP("codes", "violation-axis-jerk"),
                                                QT_TRANSLATE_NOOP("codes", "violation-path-speed"),
                                                QT_TRANSLATE_NOOP("codes", "violation-path-acceleration"),
                                                QT_TRANSLATE_NOOP("codes", "violation-path-deceleration"),
                                                QT_TRANSLATE_NOOP("codes", "violation-path-jerk"),
                                                QT_TRANSLATE_NOOP("codes", "violation-deviation"),
                                                QT_TRANSLATE_NOOP("codes", "violation-travel-min"),
                                                QT_TRANSLATE_NOOP("codes", "violation-travel-max")};

}  // namespace

QString message_text(const std::string& code, const std::string& english) {
  const QString message = QString::fromStdString(english);
  const QString translated = QCoreApplication::translate("codes", code.c_str());
  return translated == QString::fromStdString(code) ? message : translated + "  ·  " + message;
}

}  // namespace toolpace::ui
