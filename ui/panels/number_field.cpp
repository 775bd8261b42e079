#include "panels/number_field.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace toolpace::ui {
namespace {

constexpr int kGestureMs = 600;  // steps closer together than this are one undo step
constexpr int kDigits = 7, kLeastDigits = 3;
constexpr int kMostCharacters = 9;  // of a number as it is shown
constexpr int kInnerMargin = 2;     // px, that a QLineEdit keeps on both sides of its text

QString plain_text(double value, int digits = kDigits) {
  if (std::isinf(value)) return "∞";
  return QString::number(value, 'g', digits + 2).contains('e') ? QString::number(value, 'g', digits)
                                                               : number_text(value, digits).remove(QChar(0x2009));
}

/// Rounded, where the value has more digits than there is room for.
QString short_text(double value) {
  for (int digits = kDigits; digits > kLeastDigits; --digits) {
    if (const QString text = plain_text(value, digits); text.size() <= kMostCharacters) return text;
  }
  return QString::number(value, 'g', kLeastDigits);
}

std::optional<double> parsed(QString text) {
  text = text.trimmed().remove(' ').remove(QChar(0x2009));
  if (text.count(',') == 1 && !text.contains('.')) text.replace(',', '.');
  bool fine = false;
  const double value = QLocale::c().toDouble(text, &fine);
  if (!fine || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

NumberField::NumberField(const QString& object_name, const QString& accessible_name, Quantity quantity, Range range,
                         QWidget* parent)
    : QLineEdit(parent), quantity_(quantity), range_(range), unit_(display_unit(quantity, {})) {
  setObjectName(object_name);
  setAccessibleName(accessible_name);
  setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  gesture_end_.setSingleShot(true);
  gesture_end_.setInterval(kGestureMs);
  connect(&gesture_end_, &QTimer::timeout, this, &NumberField::gestureFinished);
  connect(this, &QLineEdit::editingFinished, this, &NumberField::commit);
  connect(this, &QLineEdit::textEdited, this, [this] { mark({}); });
  show_value();
}

void NumberField::setValue(double core_value) {
  if (core_value == value_ && !isModified()) return;
  value_ = core_value;
  show_value();
}

void NumberField::setUnit(const DisplayUnit& unit) {
  own_unit_ = true;
  unit_ = unit;
  show_value();
  emit unitChanged();
}

void NumberField::setUnlimitedText(const QString& text) {
  unlimited_ = text;
  show_value();
}

void NumberField::setUnits(Units unit) {
  units_ = unit;
  if (!own_unit_) unit_ = display_unit(quantity_, unit);
  show_value();
  emit unitChanged();
}

void NumberField::show_value() {
  setText(std::isinf(value_) ? unlimited_ : short_text(value_ * unit_.factor));
  setModified(false);
  setCursorPosition(0);
  mark({});
}

QString NumberField::range_text() const {
  const auto end = [this](double v) { return plain_text(v * unit_.factor); };
  if (std::isinf(range_.most)) return tr("at least %1 %2").arg(end(range_.least), unit_.text);
  return tr("%1 to %2 %3").arg(end(range_.least), end(range_.most), unit_.text);
}

/// All digits of a value that is shown with fewer.
QString NumberField::whole_text() const {
  const double shown = value_ * unit_.factor;
  if (!std::isfinite(shown) || isModified() || parsed(text()) == shown) return {};
  const QString whole = QString::number(shown, 'g', std::numeric_limits<double>::digits10);
  return whole == text() ? QString() : "\n= " + whole + ' ' + unit_.text;
}

void NumberField::mark(const QString& trouble) {
  setToolTip(trouble.isEmpty() ? accessibleName() + "  ·  " + range_text() + whole_text() : trouble);
  if (property("wrong").toBool() == !trouble.isEmpty()) return;
  setProperty("wrong", !trouble.isEmpty());
  style()->unpolish(this);
  style()->polish(this);
}

void NumberField::commit() {
  if (!isModified()) return;
  const QString entered = text().trimmed();
  double next = std::numeric_limits<double>::infinity();
  if (!(range_.may_be_unlimited &&
        (entered.isEmpty() || entered == "∞" || entered == unlimited_ || entered.toLower() == "inf"))) {
    const auto number = parsed(entered);
    if (!number) return mark(tr("Not a number"));
    next = *number / unit_.factor;
    if (range_.whole) next = std::round(next);
    const double slack = 1e-9 * std::abs(next);  // of converting to inches and back
    if (next < range_.least - slack || next > range_.most + slack) return mark(tr("Must be %1").arg(range_text()));
  }
  const bool differs = next != value_;
  value_ = next;
  show_value();
  if (differs) emit edited(value_);
}

void NumberField::step(double direction, bool large) {
  if (std::isinf(value_)) return;
  const double shown = value_ * unit_.factor;
  const double size = shown == 0 ? 1.0 : std::abs(shown);
  double unit = std::pow(10.0, std::floor(std::log10(size))) / 10;  // two leading digits
  if (range_.whole) unit = std::max(unit, 1.0);
  if (large) unit *= 10;
  const double next = (std::round(shown / unit) + direction) * unit / unit_.factor;
  if (next < range_.least || next > range_.most) return;
  if (!gesture_end_.isActive()) emit gestureStarted();
  gesture_end_.start();
  value_ = next;
  show_value();
  emit edited(value_);
}

int NumberField::most_characters() const {
  if (!range_.whole || !std::isfinite(range_.most)) return kMostCharacters;
  return static_cast<int>(std::min<qsizetype>(short_text(range_.most * unit_.factor).size(), kMostCharacters));
}

QSize NumberField::minimumSizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  const int digits = metrics.horizontalAdvance(QString(most_characters(), '0')) + 1;  // and the cursor
  QSize size = QLineEdit::minimumSizeHint();
  size.rwidth() += digits - metrics.maxWidth();
  return size;
}

QSize NumberField::sizeHint() const { return {minimumSizeHint().width(), QLineEdit::sizeHint().height()}; }

void NumberField::paintEvent(QPaintEvent* event) {
  QStyleOptionFrame panel;
  initStyleOption(&panel);
  const QRect room =
      style()->subElementRect(QStyle::SE_LineEditContents, &panel, this).adjusted(kInnerMargin, 0, -kInnerMargin, 0);
  if (hasFocus() || fontMetrics().horizontalAdvance(text()) <= room.width()) return QLineEdit::paintEvent(event);
  QPainter painter(this);
  style()->drawPrimitive(QStyle::PE_PanelLineEdit, &panel, &painter, this);
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text));
  painter.drawText(room, static_cast<int>(alignment()), fontMetrics().elidedText(text(), Qt::ElideRight, room.width()));
}

/// What is being typed is undone here; what is done already, in the window.
bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !isModified()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return QLineEdit::event(event);
}

void NumberField::changeEvent(QEvent* event) {
  if (event->type() == QEvent::EnabledChange) mark({});  // whoever said why it was of no use is wrong now
  QLineEdit::changeEvent(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  const bool large = event->modifiers() & Qt::ControlModifier;
  switch (event->key()) {
    case Qt::Key_Up: return commit(), step(+1, large);
    case Qt::Key_Down: return commit(), step(-1, large);
    case Qt::Key_Escape:
      show_value();
      selectAll();
      return;
    default: QLineEdit::keyPressEvent(event);
  }
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  if (event->angleDelta().y() != 0) {
    commit();
    step(event->angleDelta().y() > 0 ? 1 : -1, event->modifiers() & Qt::ControlModifier);
  }
  event->accept();
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  if (event->reason() != Qt::MouseFocusReason) selectAll();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (gesture_end_.isActive()) {
    gesture_end_.stop();
    emit gestureFinished();
  }
}

}  // namespace toolpace::ui
