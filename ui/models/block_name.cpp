#include "models/block_name.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <cmath>

namespace toolpace::ui {
namespace {

/// The number that a line begins with; empty where it has none.
QString number_of(const Document& document, std::uint32_t line) {
  static const QRegularExpression number(R"(^[\s/]*[Nn]\s*(\d+))");
  return number.match(document.line(static_cast<qsizetype>(line))).captured(1);
}

std::optional<Place> block_numbered(const Document& document, const QString& digits) {
  const auto plain = [](const QString& text) { return text.toULongLong(); };
  const auto last = static_cast<std::uint32_t>(document.line_count());
  for (std::uint32_t line = 1; line <= last; ++line) {
    const QString number = number_of(document, line);
    if (!number.isEmpty() && plain(number) == plain(digits)) return Place{line, std::nullopt};
  }
  return std::nullopt;
}

}  // namespace

QString block_name(const Document& document, std::uint32_t line) {
  if (line == 0) return QStringLiteral("–");
  const QString number = number_of(document, line);
  return number.isEmpty() ? QCoreApplication::translate("BlockName", "line %1").arg(line) : "N" + number;
}

std::optional<Place> place_named(const Document& document, const QString& text) {
  static const QRegularExpression block(R"(^\s*([Nn]?)\s*(\d{1,9})\s*$)"), time(R"(^\s*(\d*[.,]?\d+|\d+[.,])\s*s\s*$)");
  if (const auto found = block.match(text); found.hasMatch()) {
    if (!found.captured(1).isEmpty()) return block_numbered(document, found.captured(2));
    const std::uint32_t line = found.captured(2).toUInt();
    if (line < 1 || line > document.line_count()) return std::nullopt;
    return Place{line, std::nullopt};
  }
  if (const auto found = time.match(text); found.hasMatch()) {
    return Place{std::nullopt, QLocale::c().toDouble(found.captured(1).replace(',', '.'))};
  }
  return std::nullopt;
}

}  // namespace toolpace::ui
