/// What the window writes: setpoints, pulses, pictures, reports, and never over what is open.

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QPrinter>
#include <QSettings>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "export_dialog.h"
#include "main_window.h"
#include "panels/stepper_page.h"
#include "plots/profile_plot.h"
#include "preferences.h"
#include "preview/contour_view.h"
#include "screenshot.h"
#include "support/files.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::studio;
using ui::kSquare;
using ui::write;

class ExportTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString in(const QString& name) const { return folder_.filePath(name); }

 private slots:
  void initTestCase() { QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path()); }

  void setpoints_are_saved_in_every_format() {
    MainWindow window(false);
    window.show();
    window.openExample();
    settle(window);
    for (const char* name : {"out.csv", "out.npy", "out.npz", "out.halstream", "out.semicolon.csv"}) {
      window.saveSetpoints(in(name));
      settle(window);
      QVERIFY2(QFileInfo(in(name)).size() > 10000, name);
    }
    QFile csv(in("out.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QVERIFY(csv.readLine().startsWith("t_s,x_mm,y_mm,z_mm,v_mm_s,a_mm_s2,j_mm_s3,line"));
  }

  void the_export_menu_names_every_format_and_what_else_is_asked_for_is_in_the_file() {
    MainWindow window(false);
    window.setLanguage("en");
    window.show();
    window.workspace().openText(kSquare, "square.ngc");
    settle(window);
    QStringList names;
    for (const auto* action : window.findChildren<QAction*>()) names << action->objectName();
    for (const char* format : {"export.csv", "export.npy", "export.npz", "export.halstream", "export.semicolon.csv"}) {
      QVERIFY2(names.contains(format), format);
    }
    window.actions().axis_derivatives->trigger();
    window.actions().decimal_comma->trigger();
    for (const char* name : {"axes.csv", "comma.semicolon.csv"}) {
      window.saveSetpoints(in(name));
      settle(window);
    }
    QFile csv(in("axes.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QVERIFY(csv.readLine().contains(",v_x_mm_s"));
    QFile comma(in("comma.semicolon.csv"));
    QVERIFY(comma.open(QIODevice::ReadOnly));
    comma.readLine();
    QVERIFY(comma.readLine().contains(';'));
    QVERIFY(comma.readLine().contains("0,001;"));
  }

  void step_pulses_of_a_whole_program_are_saved_and_a_machine_without_steppers_says_so() {
    MainWindow window(false);
    window.setLanguage("en");
    window.show();
    window.workspace().openText(kSquare, "square.ngc");
    settle(window);
    const QString file = in("square.pulses.csv");
    window.saveSetpoints(file);
    settle(window);
    QVERIFY(!QFile::exists(file));
    auto& problems = *window.findChild<QTableView*>("problemTable");
    QVERIFY(problems.model()->rowCount() > 0);
    window.workspace().tuning().edit("steps", "steps", [](ui::Tuning& t) {
      for (std::size_t axis = 0; axis < 3; ++axis) t.machine.axes[axis].steps_per_unit = 100;
    });
    settle(window);
    window.setTimerFrequency(1e6);
    window.saveSetpoints(file);
    settle(window);
    QFile csv(file);
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QCOMPARE(csv.readLine().trimmed(), QByteArray("t_ticks,axis,direction"));
    // 10 mm there and back in X and in Y at 100 steps a millimetre.
    int rows = 0;
    while (!csv.atEnd()) rows += csv.readLine().isEmpty() ? 0 : 1;
    QCOMPARE(rows, 4000);
  }

  void the_colour_map_and_the_export_choices_are_remembered() {
    {
      MainWindow window(true);
      window.show();
      window.findChild<ui::ContourView*>("contourView")->setColourMap(ui::ColourMap::turbo);
      window.actions().axis_derivatives->setChecked(false);
      window.actions().axis_derivatives->trigger();
      window.close();
    }
    MainWindow window(true);
    window.show();
    QCOMPARE(window.findChild<ui::ContourView*>("contourView")->colourMap(), ui::ColourMap::turbo);
    QVERIFY(window.actions().axis_derivatives->isChecked());
  }

  void pictures_are_saved_as_png_svg_and_pdf() {
    MainWindow window(false);
    window.show();
    window.openExample();
    settle(window);
    using Picture = MainWindow::Picture;
    for (const char* ending : {".png", ".svg", ".pdf"}) {
      QVERIFY(window.savePicture(Picture::contour, in(QString("contour") + ending)));
      QVERIFY(window.savePicture(Picture::plots, in(QString("plots") + ending)));
      QVERIFY(QFileInfo(in(QString("contour") + ending)).size() > 1000);
      QVERIFY(QFileInfo(in(QString("plots") + ending)).size() > 1000);
    }
    QVERIFY(window.savePicture(Picture::window, in("window.png")));
    QVERIFY(!window.savePicture(Picture::window, in("no/such/folder.png")));
  }

  void vector_graphics_have_one_scale() {
    MainWindow window(false);
    window.show();
    window.openExample();
    settle(window);
    QVERIFY(window.savePicture(MainWindow::Picture::plots, in("scale.svg")));
    QSvgRenderer svg(in("scale.svg"));
    QImage image(svg.viewBox().size(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    svg.render(&painter);
    const auto& plot = *window.findChild<ui::ProfilePlot*>("profilePlot");
    QCOMPARE(image.width(), plot.width());
    // Left and right end of what is drawn in a row of pixels.
    const auto ends = [&](int y) {
      int left = image.width(), right = -1;
      for (int x = 0; x < image.width(); ++x) {
        if (qGray(image.pixel(x, y)) > 250) continue;
        left = std::min(left, x);
        right = std::max(right, x);
      }
      return std::pair(left, right);
    };
    const auto [left, right] = ends(plot.height() + 9);  // the ribbon: from the begin of the plan to its end
    const double end = window.workspace().timeline()->duration();
    QVERIFY2(std::abs(left - plot.xOf(0)) <= 2, qPrintable(QString("%1, not %2").arg(left).arg(plot.xOf(0))));
    QVERIFY2(std::abs(right - plot.xOf(end)) <= 2, qPrintable(QString("%1, not %2").arg(right).arg(plot.xOf(end))));
    const int middle = plot.axisRects().front()->rect().center().y();
    const int frame = ends(middle).second;
    QVERIFY2(std::abs(frame - plot.edges().second) <= 2,
             qPrintable(QString("%1, not %2").arg(frame).arg(plot.edges().second)));
  }

  void an_exported_preview_has_its_title_and_its_legend() {
    MainWindow window(false);
    window.show();
    window.openExample();
    settle(window);
    QVERIFY(window.savePicture(MainWindow::Picture::contour, in("whole.png")));
    const QImage image(in("whole.png"));
    const auto& canvas = *window.findChild<QWidget*>("contourCanvas");
    const auto& legend = *window.findChild<QWidget*>("contourLegend");
    QCOMPARE(image.width(), 2 * canvas.width());
    QVERIFY(image.height() > 2 * (canvas.height() + legend.height()));
  }

  void a_report_as_pdf_is_one() {
    MainWindow window(false);
    window.show();
    window.openExample();
    settle(window);
    QVERIFY(window.saveReport(in("report.pdf")));
    QFile file(in("report.pdf"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(5) == "%PDF-" && file.size() > 20'000);
  }

  void a_report_holds_the_figures_and_the_pictures() {
    MainWindow window(false);
    window.setLanguage("en");
    window.show();
    window.openExample();
    settle(window);
    QVERIFY(window.saveReport(in("report.html")));
    QFile file(in("report.html"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray html = file.readAll();
    QVERIFY(html.contains("Cycle time"));
    QVERIFY(html.contains("max_acceleration_mm_s2"));
    QCOMPARE(html.count("data:image/png;base64,"), 2);
  }

  void nothing_that_is_open_is_written_over() {
    write(in("main.ngc"), "G21 G90 G94\nG1 F1200 X10\nO<sub> call\nM2\n");
    write(in("sub.ngc"), "O<sub> sub\nG1 X20\nO<sub> endsub\n");
    write(in("open.toml"), "[path]\nmax_speed_mm_s = 50\n");
    MainWindow window(false);
    window.show();
    QVERIFY(window.openMachine(in("open.toml")));
    window.openProgram(in("main.ngc"));
    settle(window);
    QSignalSpy saved(&window.workspace(), &ui::Workspace::saved);
    auto* stepper = window.findChild<ui::StepperPage*>();
    QVERIFY(stepper);
    QSignalSpy exported(stepper, &ui::StepperPage::exported);
    for (const char* name : {"main.ngc", "sub.ngc", "open.toml"}) {
      QFile file(in(name));
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QByteArray before = file.readAll();
      if (name != QByteArray("main.ngc")) window.storeProgramAs(in(name));
      QVERIFY(!window.workspace().isSaving());
      QCOMPARE(window.storeMachineAs(in(name)), name == QByteArray("open.toml"));
      QVERIFY(!window.saveReport(in(name)));
      window.saveSetpoints(in(name));
      stepper->exportTo(in(name));
      QCOMPARE(exported.takeFirst()[1].toBool(), false);
      const auto picture = take_screenshot(window, in(name));
      QVERIFY(!picture);
      QCOMPARE(QString::fromStdString(picture.error().code), QString("output-is-input"));
      file.seek(0);
      QCOMPARE(file.readAll(), before);
    }
    QCOMPARE(saved.size(), 0);
  }

  // The head of the file is written once, the rows of the first seconds stand for all: digits differ a little on the way.
  void the_dialog_says_how_large_a_file_gets() {
    MainWindow window(false);
    window.show();
    window.openExample();
    settle(window);
    const auto outcome = window.workspace().timeline()->outcome();
    for (const char* suffix : {".csv", ".npy", ".npz", ".halstream", ".semicolon.csv"}) {
      window.saveSetpoints(in(QString("size") + suffix));
      settle(window);
      const double real = static_cast<double>(QFileInfo(in(QString("size") + suffix)).size());
      const auto about = about_size(*outcome, suffix, {});
      QVERIFY(about);
      QVERIFY2(std::abs(*about - real) < 0.1 * real,
               qPrintable(QString("%1: %2 of %3").arg(suffix).arg(*about).arg(real)));
    }
    // Of a long job only a part is written to know it.
    window.workspace().openText("G21 G90 G94\nG1 F60 X30 Y5\nX0 Y0\nM2\n", "slow.ngc");
    settle(window);
    window.saveSetpoints(in("slow.csv"));
    settle(window);
    const double real = static_cast<double>(QFileInfo(in("slow.csv")).size());
    const auto about = about_size(*window.workspace().timeline()->outcome(), ".csv", {});
    QVERIFY2(about && std::abs(*about - real) < 0.15 * real,
             qPrintable(QString("%1 of %2").arg(about.value_or(0)).arg(real)));
  }

  void the_dialog_of_options_says_what_will_be_written() {
    MainWindow window(false);
    window.setLanguage("en");
    window.show();
    window.openExample();
    settle(window);
    ExportDialog dialog(window.workspace().timeline()->outcome(), {}, &window);
    dialog.show();
    const auto* contents = dialog.findChild<QLabel*>("exportContents");
    auto* format = dialog.findChild<QComboBox*>("exportFormat");
    auto* comma = dialog.findChild<QCheckBox*>("exportComma");
    auto* derivatives = dialog.findChild<QCheckBox*>("exportDerivatives");
    QCOMPARE(dialog.suffix(), QString(".csv"));
    QVERIFY2(contents->text().startsWith("4028 setpoints, one each 1 ms, over 4.026 s."), qPrintable(contents->text()));
    const QString before = contents->text();
    QVERIFY(!comma->isEnabled() && derivatives->isEnabled());
    derivatives->click();
    QVERIFY(contents->text() != before);
    QVERIFY(dialog.options().axis_derivatives);
    format->setCurrentIndex(format->findData(".semicolon.csv"));
    QVERIFY(comma->isEnabled());
    format->setCurrentIndex(format->findData(".halstream"));
    QVERIFY(!derivatives->isEnabled());
    ui::screenshot(dialog, "export-dialog");
  }

  void report_preview_and_plots_are_printed() {
    for (const bool dark : {false, true}) {
      MainWindow window(false);
      window.setDark(dark);
      window.show();
      window.openExample();
      settle_with_proof(window);
      QPrinter printer(QPrinter::HighResolution);
      printer.setOutputFormat(QPrinter::PdfFormat);
      printer.setOutputFileName(in("print.pdf"));
      QVERIFY(window.printTo(printer));
      QCOMPARE(printer.logicalDpiY(), ui::kDotsPerInch);  // so that texts are as large beside the lines as on the screen
      QFile file(in("print.pdf"));
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QByteArray pdf = file.readAll();
      QVERIFY(pdf.startsWith("%PDF"));
      QVERIFY2(pdf.count("/Type /Page\n") >= 3, "a page of figures, the preview, the plots");
      QCOMPARE(window.findChild<ui::ContourView*>("contourView")->canvas().theme().dark, dark);
    }
  }

  void vector_pictures_of_the_preview_have_the_band_and_the_drives() {
    MainWindow window(false);
    window.show();
    window.openExample();
    window.workspace().tuning().edit("", "", [](ui::Tuning& t) {
      t.options.corner.rule = CornerRule::smooth;
      t.options.corner.tolerance = 0.5;
      for (auto& axis : t.machine.axes) axis = {500, 5000, 1e6};
    });
    settle_with_proof(window);
    auto& view = *window.findChild<ui::ContourView*>("contourView");
    const auto picture = [&](const char* name) {
      if (!view.exportPicture(in(name))) qFatal("cannot write %s", name);
      QImage image(600, 500, QImage::Format_RGB32);
      image.fill(Qt::white);
      QPainter painter(&image);
      QSvgRenderer(in(name)).render(&painter);
      return image;
    };
    view.setEnlargement(10);
    const QImage band = picture("band.svg");
    view.setBandShown(false);
    const QImage drives = picture("drives.svg");
    view.setEnlargement(1);
    const QImage path = picture("path.svg");
    QVERIFY(band != path);
    QVERIFY(drives != path);
    const auto count = [](const QImage& image, const QColor& colour) {
      int found = 0;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          const QColor c = image.pixelColor(x, y);
          found += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                               std::abs(c.blue() - colour.blue()) <
                           60
                       ? 1
                       : 0;
        }
      }
      return found;
    };
    const ui::Theme theme = ui::light_theme();
    QVERIFY2(count(drives, theme.error) > count(path, theme.error) + 50, "the drives are red");
  }
};

TOOLPACE_UI_TEST(ExportTest)
#include "export_test.moc"
