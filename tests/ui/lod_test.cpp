#include "drawing/lod.h"

#include <QImage>
#include <QTest>
#include <cmath>
#include <random>

#include "preview/raster.h"
#include "support/ui_test.h"

using namespace toolpace::ui;

class LodTest : public QObject {
  Q_OBJECT

  static SceneLine wobbly(std::size_t count) {
    SceneLine line;
    std::mt19937 random(3);
    std::normal_distribution<float> step(0, 0.1f);
    Eigen::Vector3f at = Eigen::Vector3f::Zero();
    for (std::size_t i = 0; i < count; ++i) {
      at += Eigen::Vector3f(0.05f + step(random), step(random), 0.2f * step(random));
      line.vertex.push_back(at);
    }
    line.style.assign(count - 1, 0);
    return line;
  }

  static float distance(const Eigen::Vector3f& p, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    const Eigen::Vector3f d = b - a;
    const float length = d.squaredNorm();
    const float t = length > 0 ? std::clamp((p - a).dot(d) / length, 0.0f, 1.0f) : 0.0f;
    return (p - a - t * d).norm();
  }

 private slots:
  void no_dropped_vertex_is_further_than_the_tolerance() {
    const SceneLine line = wobbly(20'000);
    const LodPyramid pyramid = build_lod(line, 0.05, 50);
    QVERIFY(pyramid.levels.size() >= 4);
    for (std::size_t k = 1; k < pyramid.levels.size(); ++k) {
      const auto& level = pyramid.levels[k];
      QVERIFY(level.tolerance > pyramid.levels[k - 1].tolerance);
      QCOMPARE(level.vertex.front(), 0u);
      QCOMPARE(static_cast<std::size_t>(level.vertex.back()), line.vertex.size() - 1);
      for (std::size_t j = 0; j + 1 < level.vertex.size(); ++j) {
        for (std::uint32_t i = level.vertex[j] + 1; i < level.vertex[j + 1]; ++i) {
          const float gap = distance(line.vertex[i], line.vertex[level.vertex[j]], line.vertex[level.vertex[j + 1]]);
          QVERIFY2(gap <= level.tolerance * 1.001f, qPrintable(QString("level %1, vertex %2").arg(k).arg(i)));
        }
      }
    }
  }

  void colours_of_merged_pieces_are_means_and_majorities() {
    const SceneLine line = wobbly(20'000);
    std::vector<std::uint8_t> shade(line.pieces()), category(line.pieces());
    for (std::size_t i = 0; i < line.pieces(); ++i) {
      shade[i] = static_cast<std::uint8_t>(i % 256);
      category[i] = i % 10 < 7 ? 2 : 5;
    }
    const LodPyramid pyramid = build_lod(line, 0.5, 50);
    const auto& level = pyramid.levels.back();
    const auto means = merged_means(line, level, shade), majorities = merged_majorities(line, level, category);
    double sum = 0, weight = 0;
    for (std::uint32_t i = level.vertex[0]; i < level.vertex[1]; ++i) {
      const double length = (line.vertex[i + 1] - line.vertex[i]).norm();
      sum += length * shade[i];
      weight += length;
    }
    QVERIFY(std::abs(means[0] - sum / weight) <= 0.51);
    for (std::size_t j = 0; j + 1 < level.vertex.size(); ++j) {
      double twos = 0, fives = 0;
      for (std::uint32_t i = level.vertex[j]; i < level.vertex[j + 1]; ++i) {
        (category[i] == 2 ? twos : fives) += (line.vertex[i + 1] - line.vertex[i]).norm();
      }
      if (std::abs(twos - fives) > 1e-4) QCOMPARE(majorities[j], twos > fives ? std::uint8_t{2} : std::uint8_t{5});
    }
  }

  void pieces_of_another_style_are_kept_apart() {
    SceneLine line = wobbly(5000);
    for (std::size_t i = 2000; i < 2003; ++i) line.style[i] = 1;
    const LodPyramid pyramid = build_lod(line, 1, 100);
    for (std::size_t k = 1; k < pyramid.levels.size(); ++k) {
      const auto& kept = pyramid.levels[k].vertex;
      QVERIFY(std::binary_search(kept.begin(), kept.end(), 2000u));
      QVERIFY(std::binary_search(kept.begin(), kept.end(), 2003u));
    }
  }

  void the_level_follows_the_size_of_a_pixel() {
    const LodPyramid pyramid = build_lod(wobbly(20'000), 0.05, 50);
    QCOMPARE(pyramid.level_for(0.0), 0u);
    QCOMPARE(pyramid.level_for(1e9), pyramid.levels.size() - 1);
    for (std::size_t k = 1; k < pyramid.levels.size(); ++k) {
      QCOMPARE(pyramid.level_for(pyramid.levels[k].tolerance * 1.01), k);
    }
  }

  void lines_far_outside_and_nonsense_leave_the_picture_alone() {
    QImage image(64, 48, QImage::Format_RGB32);
    image.fill(Qt::white);
    const QImage before = image;
    for (const bool smooth : {false, true}) {
      LineRaster raster(image, 2, smooth);
      raster.draw(-1e12, -50, 1e12, -60, qRgb(0, 0, 0));
      raster.draw(std::nan(""), 0, 10, 10, qRgb(0, 0, 0));
      raster.draw(0, 0, INFINITY, 10, qRgb(0, 0, 0));
      raster.draw_dashed(1e9, 1e9, 2e9, 2e9, qRgb(0, 0, 0), 5, 4, 0);
    }
    QCOMPARE(image, before);
  }

  void a_line_through_the_picture_is_drawn_from_edge_to_edge() {
    for (const bool smooth : {false, true}) {
      QImage image(64, 48, QImage::Format_RGB32);
      image.fill(Qt::white);
      LineRaster(image, 2, smooth).draw(-1e6, 24, 1e6, 24, qRgb(0, 0, 0));
      for (int x = 0; x < 64; ++x) QVERIFY(qGray(image.pixel(x, 24)) < 140 || qGray(image.pixel(x, 23)) < 140);
      QCOMPARE(image.pixel(10, 10), qRgb(255, 255, 255));
    }
  }

  void a_point_is_a_dot() {
    for (const bool smooth : {false, true}) {
      QImage image(20, 20, QImage::Format_RGB32);
      image.fill(Qt::white);
      LineRaster(image, 3, smooth).draw(10.5, 10.5, 10.5, 10.5, qRgb(0, 0, 0));
      QVERIFY(qGray(image.pixel(10, 10)) < 100);
    }
  }

  void dashes_go_on_from_piece_to_piece() {
    QImage image(200, 3, QImage::Format_RGB32), whole(200, 3, QImage::Format_RGB32);
    image.fill(Qt::white);
    whole.fill(Qt::white);
    LineRaster pieces(image, 1, false), one(whole, 1, false);
    double phase = 0;
    for (int x = 0; x < 200; x += 10) phase = pieces.draw_dashed(x, 1, x + 10, 1, qRgb(0, 0, 0), 7, 6, phase);
    one.draw_dashed(0, 1, 200, 1, qRgb(0, 0, 0), 7, 6, 0);
    int differ = 0;
    for (int x = 0; x < 200; ++x) differ += image.pixel(x, 1) != whole.pixel(x, 1);
    // A dash that is cut at a piece's end may be a pixel longer.
    QVERIFY(differ <= 20);
    QVERIFY(qAbs(phase - std::fmod(200.0, 13.0)) < 1e-9);
  }
};

TOOLPACE_UI_TEST(LodTest)
#include "lod_test.moc"
