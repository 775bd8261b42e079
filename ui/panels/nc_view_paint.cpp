/// How the lines of the NC program are drawn.

#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "panels/nc_syntax.h"
#include "panels/nc_view.h"
#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

constexpr int kTextMargin = 8;
constexpr int kLossWidth = 16;  // of the bar of the worst line
constexpr int kSpeedWidth = 4;
constexpr int kTimeMargin = 4, kTimeDigits = 5;  // of the column of times

/// Three digits, from "0.001" to "9999": what is less is nothing to a person.
QString time_text(double seconds) {
  constexpr double kLeast = 5e-4;
  if (seconds < kLeast) return {};
  return QString::number(seconds, 'f', seconds < 9.9995 ? 3 : seconds < 99.995 ? 2 : seconds < 999.95 ? 1 : 0);
}

}  // namespace

QColor NcView::lossColour(const Theme& theme) { return mixed(theme.surface, theme.warning, 0.55); }

NcView::Gutter NcView::gutter() const {
  const auto digits = std::max<qsizetype>(QString::number(lineCount()).size(), 3);
  Gutter g;
  g.number_end = kTextMargin + static_cast<int>(digits) * fontMetrics().horizontalAdvance('0');
  g.loss_begin = g.number_end + 4;
  g.loss_end = g.loss_begin + kLossWidth;
  g.speed_begin = g.loss_end + 2;
  g.time_end = g.speed_begin + kSpeedWidth;
  if (has_times_) g.time_end += kTimeMargin + fontMetrics().horizontalAdvance(QString(kTimeDigits, '0'));
  g.text_begin = g.time_end + kTextMargin;
  return g;
}

void NcView::paintEvent(QPaintEvent*) {
  QPainter painter(viewport());
  painter.fillRect(viewport()->rect(), theme_.surface);
  if (lineCount() == 0) {
    painter.setPen(theme_.secondary);
    painter.drawText(viewport()->rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, empty_hint_);
    return;
  }
  const Gutter g = gutter();
  const int first = verticalScrollBar()->value() + 1;
  const int last = std::min(first + visibleLines() + 1, lineCount());
  for (int line = first; line <= last; ++line) paintLine(painter, line, g);
}

void NcView::paintLine(QPainter& painter, int line, const Gutter& g) const {
  const QRect row = lineRect(line);
  if (line == current_) {
    painter.fillRect(row, mixed(theme_.surface, theme_.accent, theme_.dark ? 0.22 : 0.10));
    painter.fillRect(QRect(0, row.top(), 2, row.height()), theme_.accent);
  } else if (line >= std::min(current_, anchor_) && line <= std::max(current_, anchor_)) {
    painter.fillRect(row, mixed(theme_.surface, theme_.accent, theme_.dark ? 0.16 : 0.06));
  }
  paintGutter(painter, line, row, g);
  paintText(painter, line, row, g);
}

void NcView::paintGutter(QPainter& painter, int line, const QRect& row, const Gutter& g) const {
  const Diagnostic* problem = problemOf(line);
  painter.setPen(!problem                                 ? (line == current_ ? theme_.text : theme_.secondary)
                 : problem->severity == Severity::error   ? theme_.error
                 : problem->severity == Severity::warning ? theme_.warning
                                                          : theme_.secondary);
  painter.drawText(QRect(0, row.top(), g.number_end, row.height()), Qt::AlignRight | Qt::AlignVCenter,
                   QString::number(line));
  if (has_times_) {
    painter.setPen(theme_.secondary);
    painter.drawText(QRect(0, row.top(), g.time_end, row.height()), Qt::AlignRight | Qt::AlignVCenter,
                     time_text(timeOf(line)));
  }
  if (!timeline_ || static_cast<std::size_t>(line) >= timeline_->lines().size()) return;
  const LineStats& stats = timeline_->lines()[static_cast<std::size_t>(line)];
  if (!(stats.length > 0)) return;
  if (fastest_ > 0) {
    const auto level = static_cast<std::size_t>(std::clamp(stats.mean_speed() / fastest_, 0.0, 1.0) * 255);
    painter.fillRect(QRect(g.speed_begin, row.top(), kSpeedWidth, row.height()), QColor(colours_[level]));
  }
  if (worst_loss_ > 0 && stats.loss() > 0) {
    const int width = static_cast<int>(stats.loss() / worst_loss_ * kLossWidth + 0.5);
    const int height = row.height() / 2;
    painter.fillRect(QRect(g.loss_end - width, row.top() + (row.height() - height) / 2, width, height),
                     lossColour(theme_));
  }
}

void NcView::paintText(QPainter& painter, int line, const QRect& row, const Gutter& g) const {
  const QString text =
      Document::shown_line(text_, line).replace('\t', ' ');  // columns stay columns, and the words in sight
  painter.save();
  painter.setClipRect(QRect(g.text_begin, row.top(), row.width() - g.text_begin, row.height()));
  const int left = g.text_begin - horizontalScrollBar()->value();
  const int advance = fontMetrics().horizontalAdvance('0');
  const int base = row.top() + (row.height() + fontMetrics().ascent() - fontMetrics().descent()) / 2;
  int x = left;
  for (const NcSpan& span : nc_spans(text)) {
    const QString part = text.mid(span.begin, span.length);
    painter.setPen(span.kind == NcSpanKind::code ? theme_.text : theme_.secondary);
    painter.drawText(x, base, part);
    x += fontMetrics().horizontalAdvance(part);
  }
  const Diagnostic* problem = problemOf(line);
  if (problem && problem->where.column > 0) {
    const auto before = text.left(static_cast<qsizetype>(problem->where.column) - 1);
    const int from = left + fontMetrics().horizontalAdvance(before);
    const int width = std::max<int>(advance * static_cast<int>(problem->excerpt.size()), advance * 2);
    painter.setPen(QPen(problem->severity == Severity::error ? theme_.error : theme_.warning, 2, Qt::DotLine));
    painter.drawLine(from, row.bottom() - 1, from + width, row.bottom() - 1);
  }
  painter.restore();
}

}  // namespace toolpace::ui
