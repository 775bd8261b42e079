/// F1 opens the handbook, in the language of the window; where there is none, the window says where it comes from.

#include <QAction>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "handbook.h"
#include "opened.h"
#include "support/dialogs.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

class HandbookTest : public QObject {
  Q_OBJECT

 private:
  QList<QUrl> opened_;

  static void write(const QString& file) {
    QVERIFY(QDir().mkpath(QFileInfo(file).path()));
    QFile page(file);
    QVERIFY(page.open(QIODevice::WriteOnly));
    page.write("<html></html>");
  }

 private slots:
  void take(const QUrl& url) { opened_ << url; }

  void its_page_is_beside_an_installed_program_or_in_the_checkout() {
    const QTemporaryDir folder;
    const QString root = folder.path();
    QCOMPARE(studio::handbook_page(root + "/bin", "en"), QString());
    write(root + "/handbook/html/index.html");
    QVERIFY(QDir(root).mkpath("release/bin"));
    QCOMPARE(studio::handbook_page(root + "/release/bin", "en"), root + "/handbook/html/index.html");
    QCOMPARE(studio::handbook_page(root + "/release/bin", "zh_CN"), QString());
    QVERIFY(QDir(root).mkpath("bin"));
    write(root + "/share/doc/toolpace/html/index.html");
    write(root + "/share/doc/toolpace/html/handbook/machinist-zh.html");
    QCOMPARE(studio::handbook_page(root + "/bin", "en"), root + "/share/doc/toolpace/html/index.html");
    QCOMPARE(studio::handbook_page(root + "/bin", "zh_CN"),
             root + "/share/doc/toolpace/html/handbook/machinist-zh.html");
  }

  void f1_opens_it_or_says_where_it_comes_from() {
    QDesktopServices::setUrlHandler("file", this, "take");
    Opened window;
    const QString page = studio::handbook_page(QCoreApplication::applicationDirPath(), "en");
    NextDialog told([](QWidget& dialog) { dialog.close(); });
    auto& action = window.the<QAction>("handbookAction");
    QCOMPARE(action.shortcut(), QKeySequence(Qt::Key_F1));
    action.trigger();
    QDesktopServices::unsetUrlHandler("file");
    QCOMPARE(opened_, page.isEmpty() ? QList<QUrl>() : QList<QUrl>{QUrl::fromLocalFile(page)});
    QCOMPARE(told.shown(), page.isEmpty() ? QString("handbookBox") : QString());
  }

  void shift_f1_lists_the_keys() {
    Opened window;
    NextDialog told([](QWidget& dialog) { dialog.close(); });
    auto& action = window.the<QAction>("keysAction");
    QCOMPARE(action.shortcut(), QKeySequence("Shift+F1"));
    action.trigger();
    QCOMPARE(told.shown(), QString("keysBox"));
  }
};

TOOLPACE_UI_TEST(HandbookTest)
#include "handbook_test.moc"
