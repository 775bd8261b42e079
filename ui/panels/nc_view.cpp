#include "panels/nc_view.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <limits>

#include "models/problem_model.h"
#include "models/remedy_text.h"
#include "models/units.h"
#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

constexpr qreal kFontPoints = 9;
constexpr int kLeading = 4;  // between lines [px]

}  // namespace

NcView::NcView(QWidget* parent) : QAbstractScrollArea(parent), colours_(colour_table(map_, Ground::light)) {
  setObjectName("ncView");
  setAccessibleName(tr("NC program"));
  setFont(monospace_font(kFontPoints));
  setFocusPolicy(Qt::StrongFocus);
  setFrameShape(QFrame::NoFrame);
  viewport()->setCursor(Qt::IBeamCursor);
}

void NcView::setDocument(std::shared_ptr<const Document> document, bool another) {
  if (another) finishEdit(false);
  document_ = std::move(document);
  text_ = document_ ? document_->text : ProgramText();
  if (another) {
    current_ = anchor_ = 1;
    verticalScrollBar()->setValue(0);
    horizontalScrollBar()->setValue(0);
  }
  current_ = std::clamp(current_, 1, std::max(lineCount(), 1));
  anchor_ = current_;
  emit currentLineChanged(current_);
  updateScrollBars();
  placeEditor();
  viewport()->update();
}

void NcView::setText(const ProgramText& text, int line) {
  text_ = text;
  updateScrollBars();
  setCurrentLine(line);
  placeEditor();
  viewport()->update();
}

void NcView::setTimeline(std::shared_ptr<const Timeline> timeline, double full_speed) {
  timeline_ = std::move(timeline);
  fastest_ = full_speed;
  worst_loss_ = timeline_ ? timeline_->worst_loss() : 0;
  viewport()->update();
}

void NcView::setTimes(bool shown, std::shared_ptr<const std::vector<double>> times) {
  has_times_ = shown;
  times_ = std::move(times);
  updateScrollBars();
  placeEditor();
  viewport()->update();
}

double NcView::timeOf(int line) const {
  const auto number = static_cast<std::size_t>(line);
  if (times_) return number < times_->size() ? (*times_)[number] : 0.0;
  if (!timeline_ || number >= timeline_->lines().size()) return 0.0;
  const LineStats& stats = timeline_->lines()[number];
  return stats.time + stats.rest;
}

void NcView::setProblems(const Diagnostics& problems) {
  problems_ = problems;
  std::stable_sort(problems_.begin(), problems_.end(),
                   [](const auto& a, const auto& b) { return a.where.line < b.where.line; });
  viewport()->update();
}

void NcView::setTheme(const Theme& theme) {
  theme_ = theme;
  setColourMap(map_);
}

void NcView::setColourMap(ColourMap map) {
  map_ = map;
  colours_ = colour_table(map, theme_.dark ? Ground::dark : Ground::light);
  viewport()->update();
}

void NcView::setEmptyHint(const QString& text) {
  empty_hint_ = text;
  viewport()->update();
}

int NcView::lineCount() const { return document_ ? static_cast<int>(text_.line_count()) : 0; }

int NcView::lineHeight() const { return fontMetrics().height() + kLeading; }

int NcView::visibleLines() const { return std::max(viewport()->height() / lineHeight(), 1); }

int NcView::lineAt(int y) const {
  const int line = verticalScrollBar()->value() + y / lineHeight() + 1;
  return std::clamp(line, 1, std::max(lineCount(), 1));
}

QRect NcView::lineRect(int line) const {
  return {0, (line - 1 - verticalScrollBar()->value()) * lineHeight(), viewport()->width(), lineHeight()};
}

void NcView::updateScrollBars() {
  verticalScrollBar()->setRange(0, std::max(lineCount() - visibleLines(), 0));
  verticalScrollBar()->setPageStep(visibleLines());
  const int width = fontMetrics().horizontalAdvance('0') * 120;
  horizontalScrollBar()->setRange(0, std::max(width + gutter().text_begin - viewport()->width(), 0));
  horizontalScrollBar()->setPageStep(viewport()->width());
  horizontalScrollBar()->setSingleStep(fontMetrics().horizontalAdvance('0') * 4);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void NcView::setCurrentLine(int line) {
  line = std::clamp(line, 1, std::max(lineCount(), 1));
  if (line == current_ && anchor_ == current_) return;
  current_ = anchor_ = line;
  emit currentLineChanged(line);
  const int top = verticalScrollBar()->value() + 1;
  const int shown = visibleLines();
  if (line < top || line >= top + shown) verticalScrollBar()->setValue(line - 1 - shown / 3);
  viewport()->update();
}

void NcView::activate(int line, bool extend) {
  line = std::clamp(line, 1, std::max(lineCount(), 1));
  const int anchor = extend ? anchor_ : line;
  current_ = line;
  anchor_ = anchor;
  emit currentLineChanged(line);
  const int top = verticalScrollBar()->value() + 1;
  if (line < top) verticalScrollBar()->setValue(line - 1);
  if (line >= top + visibleLines()) verticalScrollBar()->setValue(line - visibleLines());
  viewport()->update();
  emit lineActivated(line);
}

bool NcView::findNext(const QString& text, bool backwards) {
  const int count = lineCount();
  if (text.isEmpty() || count == 0) return false;
  for (int i = 1; i <= count; ++i) {
    const int offset = backwards ? -i : i;
    const int line = ((current_ - 1 + offset) % count + count) % count + 1;
    if (!text_.line(line).contains(text, Qt::CaseInsensitive)) continue;
    setCurrentLine(line);
    emit lineActivated(line);
    return true;
  }
  return false;
}

void NcView::copySelection() const {
  QStringList lines;
  for (int line = std::min(current_, anchor_); line <= std::max(current_, anchor_); ++line) lines << text_.line(line);
  QGuiApplication::clipboard()->setText(lines.join('\n') + '\n');
}

const Diagnostic* NcView::problemOf(int line) const {
  const auto number = static_cast<std::size_t>(line);
  const auto at = std::lower_bound(problems_.begin(), problems_.end(), number,
                                   [](const Diagnostic& d, std::size_t l) { return d.where.line < l; });
  const Diagnostic* worst = nullptr;
  for (auto it = at; it != problems_.end() && it->where.line == number; ++it) {
    if (!worst || it->severity > worst->severity) worst = &*it;
  }
  return worst;
}

QString NcView::tipOf(int line) const {
  QStringList lines;
  for (const auto& problem : problems_) {
    if (problem.where.line != static_cast<std::size_t>(line)) continue;
    lines << message_text(problem.code, problem.message);
    if (!problem.remedy.empty()) lines << remedy_text(problem.remedy);
  }
  if (timeline_ && static_cast<std::size_t>(line) < timeline_->lines().size()) {
    const auto& stats = timeline_->lines()[static_cast<std::size_t>(line)];
    if (stats.begin >= 0) lines << tr("from %1 on").arg(duration_text(stats.begin));
    if (stats.rest > 0) lines << tr("rests for %1 s").arg(stats.rest, 0, 'f', 3);
    if (stats.length > 0) {
      lines << tr("mean %1, programmed %2")
                   .arg(value_text(stats.mean_speed(), Quantity::speed, unit_, 4),
                        value_text(stats.asked_speed(), Quantity::speed, unit_, 4));
      lines << tr("%1 s, of which %2 s lost").arg(stats.time, 0, 'f', 3).arg(stats.loss(), 0, 'f', 3);
    }
  }
  if (times_ && timeOf(line) > 0) lines << tr("%1 s on the controller").arg(timeOf(line), 0, 'f', 3);
  return lines.join('\n');
}

bool NcView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip && lineCount() > 0) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tipOf(lineAt(help->pos().y())), viewport());
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

void NcView::resizeEvent(QResizeEvent*) {
  updateScrollBars();
  if (current_ <= visibleLines() && verticalScrollBar()->value() < current_) verticalScrollBar()->setValue(0);
}

void NcView::changeEvent(QEvent* event) {
  QAbstractScrollArea::changeEvent(event);
  if (event->type() == QEvent::FontChange) updateScrollBars();
}

void NcView::scrollContentsBy(int dx, int dy) {
  QAbstractScrollArea::scrollContentsBy(dx, dy);
  placeEditor();
}

void NcView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || lineCount() == 0) return;
  finishEdit(true);
  activate(lineAt(static_cast<int>(event->position().y())), event->modifiers() & Qt::ShiftModifier);
}

void NcView::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton) || lineCount() == 0) return;
  const int line = lineAt(static_cast<int>(event->position().y()));
  if (line != current_) activate(line, true);
}

void NcView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) editCurrentLine();
}

void NcView::keyPressEvent(QKeyEvent* event) {
  const bool extend = event->modifiers() & Qt::ShiftModifier;
  if (event->matches(QKeySequence::Copy)) return document_ ? copySelection() : void();
  if (event->matches(QKeySequence::Find)) return emit findRequested();
  switch (event->key()) {
    case Qt::Key_Up: return activate(current_ - 1, extend);
    case Qt::Key_Down: return activate(current_ + 1, extend);
    case Qt::Key_PageUp: return activate(current_ - visibleLines(), extend);
    case Qt::Key_PageDown: return activate(current_ + visibleLines(), extend);
    case Qt::Key_Home: return activate(1, extend);
    case Qt::Key_End: return activate(lineCount(), extend);
    case Qt::Key_F2:
    case Qt::Key_Return:
    case Qt::Key_Enter: return editCurrentLine();
    default: event->ignore();
  }
}

void NcView::editCurrentLine() {
  if (lineCount() == 0) return;
  finishEdit(true);
  editor_ = new QLineEdit(viewport());
  editor_line_ = current_;
  editor_->setObjectName("ncLineEditor");
  editor_->setAccessibleName(tr("Text of line %1").arg(current_));
  editor_->setFont(font());
  editor_->setMaxLength(std::numeric_limits<int>::max());  // a line that is cut off would be saved like that
  editor_->setText(text_.line(current_));
  editor_->setStyleSheet("min-height: 0; padding: 0 5px;");
  placeEditor();
  editor_->installEventFilter(this);
  connect(editor_, &QLineEdit::editingFinished, this, &NcView::commitEdit);
  editor_->show();
  editor_->setFocus();
}

// A field passes these keys on to what it stands in, where Enter would begin to edit again.
bool NcView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != editor_.data() || event->type() != QEvent::KeyPress)
    return QAbstractScrollArea::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
  if (!enter && key != Qt::Key_Escape) return false;
  finishEdit(enter);
  return true;
}

void NcView::placeEditor() {
  if (!editor_) return;
  if (editor_line_ > lineCount()) return finishEdit(false);
  const QRect row = lineRect(editor_line_);
  const int left = gutter().text_begin - 7;  // border and padding of the field, so that the text stays in place
  editor_->setGeometry(left, row.top() - 1, viewport()->width() - left, row.height() + 2);
}

void NcView::commitEdit() { finishEdit(true); }

void NcView::finishEdit(bool take) {
  if (!editor_) return;
  auto* editor = editor_.data();
  const bool focused = editor->hasFocus();  // else somebody has gone elsewhere
  editor_ = nullptr;                        // losing the focus must not come back here
  editor->deleteLater();
  editor->hide();
  if (take && editor->isModified()) emit lineEdited(editor_line_, editor->text());
  if (focused) setFocus();
}

void NcView::insertLine() {
  if (lineCount() == 0) return;
  commitEdit();
  const int line = current_ + 1;
  emit lineInserted(current_);
  setCurrentLine(line);
  editCurrentLine();
}

void NcView::removeLines() {
  if (lineCount() == 0) return;
  commitEdit();
  const int first = std::min(current_, anchor_);
  emit linesRemoved(first, std::max(current_, anchor_) - first + 1);
}

}  // namespace toolpace::ui
