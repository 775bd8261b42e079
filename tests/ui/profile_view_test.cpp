#include "plots/profile_view.h"

#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "plots/profile_plot.h"
#include "support/planned.h"
#include "support/screenshot.h"

using namespace toolpace;
using namespace toolpace::ui;

class ProfileViewTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<const ProfileSeries> butterfly_, slow_;

 private slots:
  void initTestCase() {
    butterfly_ = make_profile_series(planned_butterfly());
    PlanOptions options;
    options.lookahead = 3;
    slow_ = make_profile_series(planned_butterfly(options));
  }

  void pictures_in_both_themes() {
    for (const bool dark : {false, true}) {
      const Theme theme = dark ? dark_theme() : light_theme();
      wear(theme);
      ProfileView view;
      view.resize(960, 380);
      view.setTheme(theme);
      view.setSeries(butterfly_);
      view.setGhost(slow_);
      view.setCursorTime(1.0);
      view.show();
      const QString suffix = dark ? "-dark" : "-light";
      QVERIFY(colours_in(screenshot(view, "profile-whole" + suffix)) > 20);
      view.setVisibleRange(0.9, 1.2);
      view.setMeasuring(true);
      screenshot(view, "profile-zoomed" + suffix);
    }
  }
};

QTEST_MAIN(ProfileViewTest)
#include "profile_view_test.moc"
