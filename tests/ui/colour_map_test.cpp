#include "drawing/colour_map.h"

#include <QTest>

#include "drawing/cause_style.h"
#include "support/ui_test.h"
#include "theme/theme.h"

using namespace toolpace;
using namespace toolpace::ui;

class ColourMapTest : public QObject {
  Q_OBJECT

 private slots:
  void ends_are_the_published_colours() {
    QCOMPARE(map_colour(ColourMap::cividis, 0.0), qRgb(0, 32, 76));
    QCOMPARE(map_colour(ColourMap::cividis, 1.0), qRgb(255, 233, 69));
    QCOMPARE(map_colour(ColourMap::viridis, 0.0), qRgb(68, 1, 84));
    QCOMPARE(map_colour(ColourMap::viridis, 1.0), qRgb(253, 231, 37));
    QCOMPARE(map_colour(ColourMap::turbo, 1.0), qRgb(122, 4, 2));
    QCOMPARE(map_colour(ColourMap::turbo, 7.0), map_colour(ColourMap::turbo, 1.0));
  }

  // Black on white is 21 by definition, and a colour against itself 1.
  void contrast_is_that_of_the_web_guidelines() {
    QVERIFY(qAbs(contrast(qRgb(0, 0, 0), qRgb(255, 255, 255)) - 21.0) < 1e-9);
    QVERIFY(qAbs(contrast(qRgb(90, 10, 200), qRgb(90, 10, 200)) - 1.0) < 1e-12);
    QVERIFY(qAbs(contrast(qRgb(0x77, 0x77, 0x77), qRgb(255, 255, 255)) - 4.48) < 0.01);
  }

  void signed_values_are_grey_at_zero_and_can_be_seen_everywhere() {
    for (const bool dark : {false, true}) {
      const QRgb ground = (dark ? dark_theme() : light_theme()).surface.rgb();
      const auto table = diverging_table(dark ? Ground::dark : Ground::light);
      QCOMPARE(table[127], table[128]);
      const QColor zero(table[128]);
      QVERIFY2(zero.saturation() < 40, "zero is neutral");
      for (std::size_t level = 0; level < table.size(); ++level) QVERIFY(contrast(table[level], ground) >= 2.0);
      // Further from zero, further from the ground: of two levels the outer one stands out more.
      constexpr std::size_t kStep = 8;  // one level alone is lost in rounding
      for (std::size_t level = kStep; level < 128; ++level) {
        QVERIFY(contrast(table[level - kStep], ground) > contrast(table[level], ground));
        QVERIFY(contrast(table[255 + kStep - level], ground) > contrast(table[255 - level], ground));
      }
      QVERIFY(qBlue(table[0]) > qRed(table[0]) && qRed(table[255]) > qBlue(table[255]));
    }
  }

  void every_level_can_be_seen_on_its_ground() {
    for (const bool dark : {false, true}) {
      const QRgb ground = (dark ? dark_theme() : light_theme()).surface.rgb();
      for (const auto map : {ColourMap::cividis, ColourMap::viridis, ColourMap::turbo}) {
        const auto table = colour_table(map, dark ? Ground::dark : Ground::light);
        for (std::size_t level = 0; level < table.size(); ++level) {
          QVERIFY2(contrast(table[level], ground) >= 2.0, qPrintable(QString("map %1, level %2, dark %3: %4")
                                                                         .arg(static_cast<int>(map))
                                                                         .arg(level)
                                                                         .arg(dark)
                                                                         .arg(contrast(table[level], ground))));
        }
      }
    }
  }

  void lightness_of_the_sequential_maps_rises() {
    for (const auto ground : {Ground::light, Ground::dark}) {
      for (const auto map : {ColourMap::cividis, ColourMap::viridis}) {
        const auto table = colour_table(map, ground);
        for (std::size_t level = 8; level < table.size(); level += 8) {
          QVERIFY2(luminance(table[level]) > luminance(table[level - 8]),
                   qPrintable(QString("map %1, level %2").arg(static_cast<int>(map)).arg(level)));
        }
      }
    }
  }

  void causes_differ_from_each_other_and_from_the_ground() {
    for (const bool dark : {false, true}) {
      const Ground ground = dark ? Ground::dark : Ground::light;
      const QColor surface = (dark ? dark_theme() : light_theme()).surface;
      for (std::size_t i = 0; i < kCauseCount; ++i) {
        const QColor a = cause_colour(static_cast<Cause>(i), ground);
        QVERIFY2(contrast(a.rgb(), surface.rgb()) >= 1.9, qPrintable(cause_title(static_cast<Cause>(i))));
        QVERIFY(!cause_title(static_cast<Cause>(i)).isEmpty());
        for (std::size_t k = 0; k < i; ++k) {
          const QColor b = cause_colour(static_cast<Cause>(k), ground);
          const int distance = qAbs(a.red() - b.red()) + qAbs(a.green() - b.green()) + qAbs(a.blue() - b.blue());
          QVERIFY2(distance > 60,
                   qPrintable(cause_title(static_cast<Cause>(i)) + " " + cause_title(static_cast<Cause>(k))));
        }
      }
    }
  }
};

TOOLPACE_UI_TEST(ColourMapTest)
#include "colour_map_test.moc"
