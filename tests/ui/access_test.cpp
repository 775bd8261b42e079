/// Everything has a name, everything is reached by keys, everything is large enough for a finger.

#include <QAbstractButton>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QSet>
#include <QSlider>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QToolBar>

#include "opened.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr int kFinger = 48;  // px
const std::array kTabs = {"resultsDock", "limitsDock", "lossDock", "sweepDock", "circleDock", "problemsDock"};

/// What a person can put the focus on or click at, leaving out the parts that Qt makes inside its own widgets.
bool is_control(const QWidget& widget) {
  if (widget.objectName().startsWith("qt_") || widget.inherits("QScrollBar") || widget.inherits("QHeaderView"))
    return false;
  if (widget.inherits("QToolBarExtension") || widget.inherits("QTableCornerButton") ||
      widget.inherits("QComboBoxListView")) {
    return false;
  }
  const QWidget* parent = widget.parentWidget();
  if (parent &&
      (parent->inherits("QTabBar") || parent->inherits("QDockWidget") || parent->inherits("QTableView") ||
       parent->inherits("QLineEdit") || parent->inherits("QComboBox") || parent->inherits("QComboBoxListView"))) {
    return parent->inherits("QDockWidget") && !widget.inherits("QAbstractButton") &&
           widget.focusPolicy() != Qt::NoFocus;
  }
  if (qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
      qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QSlider*>(&widget) ||
      qobject_cast<const QTableView*>(&widget)) {
    return true;
  }
  return widget.focusPolicy() != Qt::NoFocus && !widget.inherits("QMenu") && !widget.inherits("QScrollArea") &&
         !widget.inherits("QMenuBar") && !widget.inherits("QTabBar") && !widget.inherits("QComboBoxPrivateContainer") &&
         !widget.isWindow() && widget.objectName() != "qt_scrollarea_viewport";
}

QString described(const QWidget& widget) {
  return QString("%1 \"%2\"").arg(widget.metaObject()->className(), widget.objectName());
}

std::vector<QWidget*> controls_of(QWidget& window) {
  std::vector<QWidget*> controls;
  for (auto* widget : window.findChildren<QWidget*>()) {
    if (is_control(*widget)) controls.push_back(widget);
  }
  return controls;
}

}  // namespace

class AccessTest : public QObject {
  Q_OBJECT

 private slots:
  void every_control_has_a_name_of_its_own_for_tests_and_one_for_people() {
    Opened window;
    window.openButterfly();
    for (const char* language : {"en", "zh_CN"}) {
      window.setLanguage(language);
      studio::settle(window);
      QSet<QString> names;
      QStringList troubles;
      for (auto* control : controls_of(window)) {
        auto* button = qobject_cast<QToolButton*>(control);
        const QString name =
            button && button->defaultAction() ? button->defaultAction()->objectName() : control->objectName();
        if (name.isEmpty()) troubles << "no object name: " + described(*control);
        if (!(button && button->defaultAction()) && names.contains(name)) troubles << "twice: " + described(*control);
        names.insert(name);
        auto* spoken = QAccessible::queryAccessibleInterface(control);
        if (!spoken || spoken->text(QAccessible::Name).trimmed().isEmpty())
          troubles << "no spoken name: " + described(*control);
      }
      QVERIFY(names.size() > 80);
      QVERIFY2(troubles.isEmpty(), qPrintable(troubles.join('\n')));
    }
  }

  void the_tab_key_reaches_every_control_that_is_seen() {
    Opened window;
    window.openButterfly();
    window.activateWindow();
    for (const char* tab : kTabs) {
      window.the<QDockWidget>(tab).raise();
      studio::settle(window);
      window.the<QWidget>("ncView").setFocus();
      QSet<QWidget*> visited;
      for (int i = 0; i < 400; ++i) {
        auto* now = QApplication::focusWidget();
        if (now) visited.insert(now);
        QTest::keyClick(now ? now : &window, Qt::Key_Tab);
      }
      QStringList missed;
      for (auto* control : controls_of(window)) {
        const bool wanted = control->isVisible() && control->isEnabled() && (control->focusPolicy() & Qt::TabFocus) &&
                            !control->visibleRegion().isEmpty() && !control->focusProxy();
        if (wanted && !visited.contains(control)) missed << described(*control);
      }
      QVERIFY2(missed.isEmpty(), qPrintable(QString(tab) + ": " + missed.join('\n')));
    }
  }

  void every_action_has_words_stands_in_a_menu_and_no_key_means_two_things() {
    Opened window;
    QSet<QAction*> in_menus;
    for (auto* menu : window.findChildren<QMenu*>()) {
      emit menu->aboutToShow();  // some fill themselves when they are opened
      for (auto* action : menu->actions()) in_menus.insert(action);
    }
    QSet<QKeySequence> keys;
    for (auto* action : window.actions().findChildren<QAction*>()) {
      QVERIFY2(!action->text().isEmpty() && !action->toolTip().isEmpty(), qPrintable(action->objectName()));
      QVERIFY2(in_menus.contains(action), qPrintable(action->objectName() + " is in no menu"));
      for (const QKeySequence& key : action->shortcuts()) {
        QVERIFY2(!keys.contains(key), qPrintable(key.toString()));
        keys.insert(key);
      }
    }
    QVERIFY(keys.size() > 25);
  }

  void fingers_find_every_control_large_enough() {
    Opened window({1600, 1200});
    window.openButterfly();
    window.setTouch(true);
    for (const char* page : {"tuneDock", "traceDock"}) window.the<QDockWidget>(page).show();
    studio::settle(window);
    QStringList troubles;
    for (const char* tab : kTabs) {
      window.the<QDockWidget>(tab).raise();
      studio::settle(window);
      for (auto* control : controls_of(window)) {
        if (!control->isVisible() || control->visibleRegion().isEmpty()) continue;
        const bool touched = qobject_cast<QAbstractButton*>(control) || qobject_cast<QComboBox*>(control) ||
                             qobject_cast<QLineEdit*>(control) || qobject_cast<QSlider*>(control);
        if (touched && control->height() < kFinger) {
          troubles << QString("%1: %2 px").arg(described(*control)).arg(control->height());
        }
        if (auto* table = qobject_cast<QTableView*>(control); table && table->model()->rowCount() > 0) {
          for (int row = 0; row < std::min(table->model()->rowCount(), 5); ++row) {
            if (!table->isRowHidden(row) && table->rowHeight(row) < kFinger) troubles << described(*table) + " rows";
          }
        }
      }
      for (auto* bar : window.findChildren<QTabBar*>()) {
        if (bar->isVisible() && bar->count() > 1 && bar->tabRect(0).height() < kFinger) {
          troubles << QString("tabs: %1 px").arg(bar->tabRect(0).height());
        }
      }
    }
    troubles.removeDuplicates();
    screenshot(window, "touch");
    QVERIFY2(troubles.isEmpty(), qPrintable(troubles.join('\n')));
  }
};

TOOLPACE_UI_TEST(AccessTest)
#include "access_test.moc"
