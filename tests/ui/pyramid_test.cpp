#include "drawing/pyramid.h"

#include <QTest>
#include <random>

#include "drawing/cause_times.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

class PyramidTest : public QObject {
  Q_OBJECT

  static Extent scanned(const std::vector<float>& row, std::size_t first, std::size_t last) {
    Extent extent;
    for (std::size_t i = first; i < last; ++i) extent.add(row[i]);
    return extent;
  }

 private slots:
  void any_stretch_has_the_extremes_of_a_plain_scan() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(-100, 100);
    for (const std::size_t count : {1u, 63u, 64u, 65u, 512u, 513u, 4097u, 70'001u}) {
      std::vector<float> row(count);
      for (auto& v : row) v = value(random);
      std::size_t most = 0;
      const auto scan = [&](std::size_t first, std::size_t last) {
        most = std::max(most, last - first);
        return scanned(row, first, last);
      };
      const Pyramid<Extent> pyramid(count, scan);
      QCOMPARE(pyramid.size(), count);
      for (int trial = 0; trial < 500; ++trial) {
        std::size_t first = random() % (count + 1), last = random() % (count + 1);
        if (first > last) std::swap(first, last);
        const Extent found = pyramid.query(first, last, scan), wanted = scanned(row, first, last);
        QCOMPARE(found.is_empty(), wanted.is_empty());
        if (wanted.is_empty()) continue;
        QVERIFY2(found.low == wanted.low && found.high == wanted.high,
                 qPrintable(QString("%1: [%2, %3)").arg(count).arg(first).arg(last)));
      }
      QVERIFY(most <= 126);
    }
  }

  void nothing_has_no_extremes() {
    const Pyramid<Extent> none(0, [](std::size_t, std::size_t) { return Extent{}; });
    QVERIFY(none.query(0, 10, [](std::size_t, std::size_t) { return Extent{1, 2}; }).is_empty());
    QVERIFY(Pyramid<Extent>().query(0, 1, [](std::size_t, std::size_t) { return Extent{1, 2}; }).is_empty());
  }

  void it_takes_little_memory() {
    const std::vector<float> row(1'000'000, 1.0f);
    const Pyramid<Extent> pyramid(row.size(),
                                  [&](std::size_t first, std::size_t last) { return scanned(row, first, last); });
    // 8 B an extent, 1/64 · 8/7 extents an element.
    QVERIFY(static_cast<double>(pyramid.memory()) / 1e6 < 0.15);
  }

  void times_of_causes_add_up_between_any_two_instants() {
    std::mt19937 random(11);
    std::vector<Restraint> list;
    double time = 0;
    for (int i = 0; i < 1000; ++i) {
      const double length = 0.001 + 0.0001 * static_cast<double>(random() % 100);
      list.push_back({time, time + length, 0, static_cast<Cause>(random() % kCauseCount)});
      time += length;
    }
    const CauseTimes times(list);
    for (int trial = 0; trial < 300; ++trial) {
      double a = time * static_cast<double>(random() % 1000) / 999,
             b = time * static_cast<double>(random() % 1000) / 999;
      if (a > b) std::swap(a, b);
      const CauseShares shares = times.between(a, b);
      CauseShares wanted = {};
      for (const auto& r : list) {
        wanted[index_of(r.cause)] += std::max(std::min(r.end, b) - std::max(r.begin, a), 0.0);
      }
      for (std::size_t i = 0; i < kCauseCount; ++i) QVERIFY(std::abs(shares[i] - wanted[i]) < 1e-9);
    }
    QVERIFY(times.at(-1.0) == nullptr);
    QVERIFY(times.at(time + 1) == nullptr);
    QCOMPARE(times.at(list[500].begin + 1e-6)->begin, list[500].begin);
  }
};

TOOLPACE_UI_TEST(PyramidTest)
#include "pyramid_test.moc"
