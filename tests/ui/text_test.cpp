/// No text is cut off: every visible label, button, field, tab and table cell is measured against the room it has.

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTextDocument>
#include <cmath>

#include "opened.h"
#include "panels/controller_panel.h"
#include "support/files.h"
#include "support/legible.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr int kSlack = 1;        // px, of rounding at fractional scales
constexpr int kCellPadding = 8;  // px, that a cell needs beside its text

/// Collects what does not fit.
class TextCheck {
 public:
  explicit TextCheck(QWidget& window) {
    for (auto* widget : window.findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->visibleRegion().isEmpty()) continue;
      if (auto* label = qobject_cast<QLabel*>(widget)) check(*label);
      if (auto* button = qobject_cast<QAbstractButton*>(widget)) check(*button);
      if (auto* box = qobject_cast<QComboBox*>(widget)) check(*box);
      if (auto* field = qobject_cast<QLineEdit*>(widget)) check(*field);
      if (auto* bar = qobject_cast<QTabBar*>(widget)) check(*bar);
      if (auto* table = qobject_cast<QTableView*>(widget)) check(*table);
    }
  }
  const QStringList& troubles() const { return troubles_; }

 private:
  void need(const QWidget& widget, const QString& text, int wanted, int given) {
    if (wanted <= given + kSlack) return;
    troubles_ << QString("%1 \"%2\" wants %3 px, has %4").arg(widget.objectName(), text).arg(wanted).arg(given);
  }

  void check(const QLabel& label) {
    if (label.text().isEmpty()) return;
    const QRect room = label.contentsRect();
    if (label.wordWrap()) {
      QTextDocument text;
      text.setDefaultFont(label.font());
      text.setDocumentMargin(0);
      text.setTextWidth(room.width());
      Qt::mightBeRichText(label.text()) ? text.setHtml(label.text()) : text.setPlainText(label.text());
      return need(label, label.text() + " (height)", static_cast<int>(text.size().height()),
                  label.contentsRect().height());
    }
    if (label.textFormat() == Qt::RichText) {
      QTextDocument text;
      text.setDefaultFont(label.font());
      text.setDocumentMargin(0);
      text.setHtml(label.text());
      return need(label, text.toPlainText(), static_cast<int>(std::ceil(text.idealWidth())), room.width());
    }
    for (const QString& line : label.text().split('\n')) {
      need(label, line, label.fontMetrics().horizontalAdvance(line), room.width());
    }
  }

  void check(const QAbstractButton& button) {
    if (!shows_text(button)) return;
    need(button, button.text(), button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width(),
         button.width() - 8);
  }

  void check(const QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.subControls = QStyle::SC_All;
    const int room =
        box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width();
    for (int i = 0; i < box.count(); ++i) {
      need(box, box.itemText(i), box.fontMetrics().horizontalAdvance(box.itemText(i)), room);
    }
  }

  void check(const QLineEdit& field) {
    constexpr int kFrame = 2 * (1 + 6);
    need(field, field.text(), field.fontMetrics().horizontalAdvance(field.text()), field.width() - kFrame);
  }

  void check(const QTabBar& bar) {
    int right = 0;
    for (int i = 0; i < bar.count(); ++i) {
      if (!bar.isTabVisible(i)) continue;
      need(bar, bar.tabText(i), bar.fontMetrics().horizontalAdvance(bar.tabText(i)) + kCellPadding,
           bar.tabRect(i).width());
      right = std::max(right, bar.tabRect(i).right());
    }
    need(bar, "all tabs", right, bar.width());
  }

  void check(const QTableView& table) {
    const QHeaderView& head = *table.horizontalHeader();
    const QAbstractItemModel& model = *table.model();
    if (table.isVisible()) need(table, "all columns", head.length(), table.viewport()->width());
    for (int column = 0; column < model.columnCount(); ++column) {
      if (table.isColumnHidden(column)) continue;
      const int room = head.sectionSize(column);
      if (head.isVisible()) {
        const QString title = model.headerData(column, Qt::Horizontal).toString();
        for (const QString& line : title.split('\n')) {
          need(head, line, head.fontMetrics().horizontalAdvance(line) + kCellPadding, room);
        }
      }
      for (int row = 0; row < std::min(model.rowCount(), 40); ++row) {
        const QModelIndex index = model.index(row, column);
        const QVariant font = index.data(Qt::FontRole);
        const QFontMetrics metrics =
            font.isValid() ? QFontMetrics(font.value<QFont>().resolve(table.font())) : table.fontMetrics();
        const QString text = index.data().toString();
        int wide = room;
        for (int more = 1; more < table.columnSpan(row, column); ++more) wide += head.sectionSize(column + more);
        need(table, text, metrics.horizontalAdvance(text) + kCellPadding, wide);
      }
    }
  }

  QStringList troubles_;
};

/// With settings to edit, what each of them gives, and axes that turn in the line below.
QStringList troubles_on_controller(Opened& window, const QString& name) {
  QTemporaryDir folder;
  write(folder.filePath("grbl.txt"), "$11=0.01\n$110=5000\n$111=5000\n$112=500\n$120=200\n$121=200\n$122=50\n");
  window.openController(folder.filePath("grbl.txt"));
  window.open("G21 G90 G94\nG1 X-1000.5 Y-200.25 Z-33.125 A-123.4 B-45.6 C-350.1 F6000\nG3 X0 I500\nM2\n", "p.nc");
  auto& panel = window.the<ControllerPanel>("controllerPanel");
  QSignalSpy computed(&panel, &ControllerPanel::computed);
  window.workspace().setCursorTime(1e300);
  window.actions().try_settings->trigger();
  if (!eventually(computed)) return {"nothing was tried"};
  studio::settle(window);
  const TextCheck check(window);
  screenshot(window, name + "-controller");
  return check.troubles();
}

}  // namespace

class TextTest : public QObject {
  Q_OBJECT

 private slots:
  void no_text_is_cut_off_in_any_language_theme_and_size_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<bool>("dark");
    QTest::addColumn<bool>("touch");
    QTest::addColumn<bool>("inch");
    QTest::addColumn<QSize>("size");
    const QSize small(1024, 700), least(1280, 800), large(3840, 2160);
    for (const char* language : {"en", "zh_CN"}) {
      const auto add = [&](const char* what, bool dark, bool touch, bool inch, const QSize& size) {
        const QString name = QString("%1 %2 %3").arg(language, what).arg(size.width());
        QTest::newRow(qPrintable(name)) << language << dark << touch << inch << size;
      };
      add("inch", false, false, true, small);
      add("mm", false, false, false, least);
      if (qApp->devicePixelRatio() > 1) continue;  // all that scales is in these
      add("dark", true, false, false, least);
      add("touch", false, true, true, small);
      add("mm", false, false, false, large);
    }
  }

  void no_text_is_cut_off_in_any_language_theme_and_size() {
    QFETCH(QString, language);
    QFETCH(bool, dark);
    QFETCH(bool, touch);
    QFETCH(bool, inch);
    QFETCH(QSize, size);
    Opened window(size);
    window.setLanguage(language);
    window.setDark(dark);
    window.setTouch(touch);
    window.setInch(inch);
    window.openButterfly();
    window.waitForProof();
    window.workspace().pin();
    window.workspace().tuning().edit("corner", "corner", [](Tuning& t) { t.options.corner.rule = CornerRule::blend; });
    window.waitForProof();
    window.workspace().setCursorTime(2.0);
    QStringList troubles;
    for (const char* tab : {"resultsDock", "limitsDock", "lossDock", "sweepDock", "circleDock", "problemsDock"}) {
      window.the<QDockWidget>(tab).raise();
      studio::settle(window);
      const TextCheck check(window);
      for (const QString& trouble : check.troubles()) {
        if (!troubles.contains(trouble)) troubles << trouble;
      }
    }
    const double scale = window.devicePixelRatioF();
    const QString name = QString("text-%1-%2%3-%4x%5")
                             .arg(language, dark ? "dark" : "light", touch ? "-touch" : "")
                             .arg(size.width())
                             .arg(scale);
    window.the<QDockWidget>("resultsDock").raise();
    screenshot(window, name);
    troubles += illegible_in(window);
    troubles += troubles_on_controller(window, name);
    QVERIFY2(troubles.isEmpty(), qPrintable(troubles.join('\n')));
    QCOMPARE(window.size(), size);
  }

  void the_pages_beside_the_program_have_room_for_their_texts() {
    for (const char* language : {"en", "zh_CN"}) {
      Opened window;
      window.setLanguage(language);
      for (const char* page : {"singleMoveDock", "stepperDock", "spectrumDock", "tuneDock", "traceDock"}) {
        auto& dock = window.the<QDockWidget>(page);
        dock.show();
        studio::settle(window);
        const TextCheck check(dock);
        const QStringList troubles = check.troubles();
        screenshot(dock, QString("text-%1-%2").arg(page, language));
        QVERIFY2(troubles.isEmpty(), qPrintable(troubles.join('\n')));
        dock.hide();
      }
    }
  }
};

TOOLPACE_UI_TEST(TextTest)
#include "text_test.moc"
