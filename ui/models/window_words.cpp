#include "models/window_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <array>

namespace toolpace::ui {
namespace {

struct Field {
  const char* flag;
  const char* context;  ///< of the field's own name; none: the name is a symbol
  const char* name;
};

// What begins like another flag stands before it.
constexpr std::array kFields = {Field{"--vmax", nullptr, "Vmax"},
                                Field{"--tacc-ms", nullptr, "Tacc"},
                                Field{"--tdec-ms", nullptr, "Tdec"},
                                Field{"--am", nullptr, "Am"},
                                Field{"--dm", nullptr, "Dm"},
                                Field{"--jm", nullptr, "Jm"},
                                Field{"--jd", nullptr, "Jd"},
                                Field{"--hold-at-s", "toolpace::ui::TuningPanel", "Hold"},
                                Field{"--corner servo", "OptionNames", "servo step (a·Ts)"},
                                Field{"--dialect", "toolpace::ui::ReadingPage", "Dialect"},
                                Field{"--integers lengths", "toolpace::ui::ReadingPage", "X100 is 100 mm"},
                                Field{"--integers increments", "toolpace::ui::ReadingPage", "X100 is 0.1 mm"},
                                Field{"--arc-tolerance-mm", "toolpace::ui::ReadingPage", "Arc tolerance"},
                                Field{"--sub-path", "toolpace::ui::ReadingPage", "Sub-programs"},
                                Field{"--tools", "toolpace::ui::ReadingPage", "Tool table"}};

}  // namespace

QString in_words_of_window(QString sentence) {
  if (!sentence.contains("--")) return sentence;
  for (const Field& field : kFields) {
    const QString name =
        field.context ? "“" + QCoreApplication::translate(field.context, field.name) + "”" : QString(field.name);
    // Not the beginning of a longer flag.
    sentence.replace(QRegularExpression(QRegularExpression::escape(field.flag) + "(?![\\w-])"), name);
  }
  return sentence;
}

}  // namespace toolpace::ui
