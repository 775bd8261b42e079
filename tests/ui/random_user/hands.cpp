#include "random_user/hands.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QTest>
#include <QUrl>

#include "support/events.h"

namespace toolpace::ui {
namespace {

/// What people can see and use.
template <class T>
QList<T*> usable(const QWidget& window) {
  QList<T*> found;
  for (T* widget : window.findChildren<T*>()) {
    if (widget->isVisible() && widget->isEnabled() && !widget->visibleRegion().isEmpty()) found << widget;
  }
  return found;
}

template <class T>
T* some(const QWidget& window, Chance& chance) {
  const auto all = usable<T>(window);
  return all.isEmpty() ? nullptr : one_of(chance, all);
}

QPoint point_in(const QWidget& widget, Chance& chance) {
  return {pick(chance, widget.width()), pick(chance, widget.height())};
}

QString name_of(const QWidget& widget) {
  return QString("%1 %2").arg(widget.metaObject()->className(), widget.objectName());
}

Qt::KeyboardModifiers modifiers(Chance& chance) {
  static const std::vector<Qt::KeyboardModifiers> all = {Qt::NoModifier,    Qt::NoModifier,
                                                         Qt::NoModifier,    Qt::ControlModifier,
                                                         Qt::ShiftModifier, Qt::ControlModifier | Qt::ShiftModifier,
                                                         Qt::AltModifier};
  return one_of(chance, all);
}

// What an answer opens asks in its turn; a timer does not fire again before it comes back. So answers are left to the event loop.

void answer_files(QFileDialog& dialog, const Desk& desk, Chance& chance) {
  if (happens(chance, 25)) return dialog.reject();
  const bool saves = dialog.acceptMode() == QFileDialog::AcceptSave;
  const QString path = one_of(chance, saves ? desk.targets() : happens(chance, 50) ? desk.programs() : desk.machines());
  if (auto* name = dialog.findChild<QLineEdit*>("fileNameEdit")) name->setText(path);
  QMetaObject::invokeMethod(&dialog, "accept", Qt::QueuedConnection);
}

void answer_menu(QMenu& menu, Chance& chance) {
  const auto actions = menu.actions();
  QAction* const chosen = actions.isEmpty() || happens(chance, 40) ? nullptr : one_of(chance, actions);
  menu.close();
  if (chosen && chosen->isEnabled() && !chosen->menu())
    QMetaObject::invokeMethod(chosen, "trigger", Qt::QueuedConnection);
}

}  // namespace

Answers::Answers(const Desk& desk, Chance& chance) : desk_(desk), chance_(chance) {
  QObject::connect(&timer_, &QTimer::timeout, [this] { answer(); });
  timer_.start(0);
}

void Answers::answer() {
  if (QWidget* const popup = QApplication::activePopupWidget()) {
    if (auto* menu = qobject_cast<QMenu*>(popup)) return answer_menu(*menu, chance_);
    popup->close();
    return;
  }
  QWidget* const asking = QApplication::activeModalWidget();
  if (auto* files = qobject_cast<QFileDialog*>(asking)) return answer_files(*files, desk_, chance_);
  if (auto* box = qobject_cast<QMessageBox*>(asking)) {
    QMetaObject::invokeMethod(one_of(chance_, box->buttons()), "click", Qt::QueuedConnection);
    return;
  }
  if (auto* dialog = qobject_cast<QDialog*>(asking)) {
    return dialog->done(happens(chance_, 60) ? QDialog::Accepted : QDialog::Rejected);
  }
  if (asking) asking->close();
}

QString click_somewhere(QWidget& window, Chance& chance) {
  QWidget* const widget = happens(chance, 50) ? some<QAbstractButton>(window, chance) : some<QWidget>(window, chance);
  if (!widget) return "clicks nothing";
  const QString did = "clicks " + name_of(*widget);
  static const std::vector<Qt::MouseButton> buttons = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton};
  const QPoint at = point_in(*widget, chance);
  const Qt::MouseButton button = one_of(chance, buttons);
  if (happens(chance, 20)) {
    QTest::mouseDClick(widget, button, modifiers(chance), at);
  } else {
    QTest::mouseClick(widget, button, modifiers(chance), at);
  }
  return did;
}

QString drag_somewhere(QWidget& window, Chance& chance) {
  QPointer<QWidget> widget = some<QWidget>(window, chance);
  if (!widget) return "drags nothing";
  const QString did = "drags over " + name_of(*widget);
  const QPoint from = point_in(*widget, chance), to = point_in(*widget, chance);
  const Qt::MouseButton button = happens(chance, 70) ? Qt::LeftButton : Qt::MiddleButton;
  QTest::mousePress(widget, button, {}, from);
  for (int step = 1; step <= 3 && widget; ++step) {
    const QPoint at = from + (to - from) * step / 3;
    QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button, Qt::NoModifier);
    QApplication::sendEvent(widget, &move);
    if (happens(chance, 30)) QApplication::processEvents();
  }
  if (widget) QTest::mouseRelease(widget, button, {}, to);
  return did;
}

QString turn_the_wheel(QWidget& window, Chance& chance) {
  QWidget* const widget = some<QWidget>(window, chance);
  if (!widget) return "turns nothing";
  const QString did = "turns the wheel over " + name_of(*widget);
  wheel(*widget, point_in(*widget, chance), 120 * (pick(chance, 7) - 3), modifiers(chance));
  return did;
}

QString press_a_key(QWidget& window, Chance& chance) {
  static const std::vector<int> keys = {
      Qt::Key_Space,   Qt::Key_Left,   Qt::Key_Right,     Qt::Key_Up,     Qt::Key_Down,   Qt::Key_Home,
      Qt::Key_End,     Qt::Key_PageUp, Qt::Key_PageDown,  Qt::Key_Return, Qt::Key_Escape, Qt::Key_Tab,
      Qt::Key_Backtab, Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_F2,     Qt::Key_F5,     Qt::Key_F8,
      Qt::Key_F9,      Qt::Key_A,      Qt::Key_B,         Qt::Key_C,      Qt::Key_E,      Qt::Key_F,
      Qt::Key_H,       Qt::Key_I,      Qt::Key_L,         Qt::Key_M,      Qt::Key_R,      Qt::Key_S,
      Qt::Key_T,       Qt::Key_U,      Qt::Key_X,         Qt::Key_Y,      Qt::Key_Z,      Qt::Key_1,
      Qt::Key_9,       Qt::Key_Period};
  QWidget* target = QApplication::focusWidget();
  if (!target || happens(chance, 30)) target = some<QWidget>(window, chance);
  if (!target) target = &window;
  const auto key = static_cast<Qt::Key>(one_of(chance, keys));
  const Qt::KeyboardModifiers with = modifiers(chance);
  const QString did = QString("presses %1 in %2").arg(QKeySequence(key | with).toString(), name_of(*target));
  QTest::keyClick(target, key, with);
  return did;
}

QString type_into_a_field(QWidget& window, Chance& chance) {
  static const QStringList texts = {"1",    "0",   "-5",  "100", "3000",  "1e6",  "1e-9", "1e300", "nan", "inf",
                                    "0.01", "0,5", "abc", "",    "99999", "1e18", "12.5", "2",     "4",   "G1"};
  QPointer<QLineEdit> field = some<QLineEdit>(window, chance);
  if (!field) return "types nothing";
  const QString text = one_of(chance, texts);
  const QString did = QString("types '%1' into %2").arg(text, name_of(*field));
  field->setFocus();
  field->selectAll();
  for (const QChar letter : text) {
    if (field) QTest::keyClick(field, letter.toLatin1());
  }
  if (field)
    QTest::keyClick(field, happens(chance, 80) ? Qt::Key_Return : happens(chance, 50) ? Qt::Key_Tab : Qt::Key_Escape);
  return did;
}

QString choose_in_a_list(QWidget& window, Chance& chance) {
  auto* const list = some<QComboBox>(window, chance);
  if (!list || list->count() == 0) return "chooses nothing";
  const int row = pick(chance, list->count());
  const QString did = QString("chooses %1 in %2").arg(list->itemText(row), name_of(*list));
  list->setCurrentIndex(row);
  emit list->activated(row);
  return did;
}

QString drop_a_file(QWidget& window, const QString& path) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  const QPoint at = window.rect().center();
  QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  if (enter.isAccepted()) {
    QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
  }
  return "drops " + path;
}

}  // namespace toolpace::ui
