#include "models/remedy_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <vector>

#include "models/window_words.h"

namespace toolpace::ui {
namespace {

QString translated(const char* sentence) { return QCoreApplication::translate("remedies", sentence); }

/// A sentence with something that varies in it, as what it matches.
struct Pattern {
  const char* sentence;
  QRegularExpression expression;
};

const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> all = [] {
    std::vector<Pattern> made;
    for (const char* sentence : remedy_sentences()) {
      QString text = QRegularExpression::escape(QString::fromUtf8(sentence));
      if (!text.contains("\\%1")) continue;
      text.replace("\\%1", "(.+)").replace("\\%2", "(.+)");
      made.push_back({sentence, QRegularExpression(QRegularExpression::anchoredPattern(text))});
    }
    return made;
  }();
  return all;
}

QString words_of(const std::string& english) {
  const QString text = QString::fromStdString(english);
  const QString exact = translated(english.c_str());
  if (english.empty() || exact != text) return exact;
  for (const Pattern& pattern : patterns()) {
    const auto match = pattern.expression.match(text);
    if (!match.hasMatch()) continue;
    QString words = translated(pattern.sentence);
    for (int i = 1; i <= match.lastCapturedIndex(); ++i) words.replace('%' + QString::number(i), match.captured(i));
    return words;
  }
  return text;
}

}  // namespace

QString remedy_text(const std::string& english) { return in_words_of_window(words_of(english)); }

}  // namespace toolpace::ui
