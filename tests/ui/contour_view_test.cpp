#include "preview/contour_view.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "support/planned.h"
#include "support/screenshot.h"

using namespace toolpace;
using namespace toolpace::ui;

class ContourViewTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<const ContourScene> butterfly_;

 private slots:
  void initTestCase() { butterfly_ = make_contour_scene(planned_butterfly()); }

  void pictures_in_both_themes() {
    for (const bool dark : {false, true}) {
      const Theme theme = dark ? dark_theme() : light_theme();
      wear(theme);
      ContourView view;
      view.resize(660, 480);
      view.setTheme(theme);
      view.setScene(butterfly_);
      view.setCursorTime(1.0);
      view.setHighlightedLine(200);
      view.show();
      const QString suffix = dark ? "-dark" : "-light";
      QVERIFY(colours_in(screenshot(view, "contour-speed" + suffix)) > 60);
      view.setColourBy(ColourBy::limit);
      screenshot(view, "contour-limit" + suffix);
      view.setColourBy(ColourBy::acceleration);
      view.setView(View::iso);
      screenshot(view, "contour-acceleration-iso" + suffix);
    }
  }
};

QTEST_MAIN(ContourViewTest)
#include "contour_view_test.moc"
