#include "models/block_name.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace toolpace::ui {

QString block_name(const Document& document, std::uint32_t line) {
  if (line == 0) return QStringLiteral("–");
  static const QRegularExpression number(R"(^[\s/]*[Nn]\s*(\d+))");
  const auto found = number.match(document.line(static_cast<qsizetype>(line)));
  return found.hasMatch() ? "N" + found.captured(1) : QCoreApplication::translate("BlockName", "line %1").arg(line);
}

}  // namespace toolpace::ui
