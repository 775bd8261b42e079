#include "models/diagnostic_text.h"

#include <QCoreApplication>

#include "models/window_words.h"

namespace toolpace::ui {

QString message_text(const std::string& code, const std::string& english) {
  const QString message = in_words_of_window(QString::fromStdString(english));
  const QString translated = QCoreApplication::translate("codes", code.c_str());
  return translated == QString::fromStdString(code) ? message : translated + "  ·  " + message;
}

}  // namespace toolpace::ui
