#include <QFile>
#include <QTest>

#include "models/block_name.h"
#include "models/document.h"
#include "models/problem_model.h"
#include "models/timeline.h"
#include "models/units.h"
#include "panels/nc_syntax.h"
#include "places.h"
#include "support/planned.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

class ModelsTest : public QObject {
  Q_OBJECT

 private slots:
  void numbers_are_grouped_and_keep_their_digits() {
    QCOMPARE(number_text(1000), QString("1000"));
    QCOMPARE(number_text(1e6), QString("1\u2009000\u2009000"));
    QCOMPARE(number_text(-12345.5), QString("-12\u2009345.5"));
    QCOMPARE(number_text(0.001), QString("0.001"));
    QCOMPARE(number_text(kUnlimited), QString("∞"));
    QCOMPARE(number_text(0), QString("0"));
  }

  void durations_are_read_as_people_say_them() {
    QCOMPARE(duration_text(12.3456), QString("12.346 s"));
    QCOMPARE(duration_text(63.6), QString("1 min 03.6 s"));
    QCOMPARE(duration_text(3720), QString("1 h 02 min"));
  }

  void icons_of_problems_are_drawn_once_and_not_for_each_row() {
    ProblemModel model;
    model.setProblems({{Severity::warning, "a", "a", {}, {}, {}},
                       {Severity::warning, "b", "b", {}, {}, {}},
                       {Severity::error, "c", "c", {}, {}, {}}});
    const auto icon_of = [&](int row) {
      return model.index(row, ProblemModel::kPlace).data(Qt::DecorationRole).value<QIcon>().cacheKey();
    };
    QCOMPARE(icon_of(0), icon_of(1));
    QCOMPARE(icon_of(0), icon_of(0));
    QVERIFY(icon_of(0) != icon_of(2));
  }

  void blocks_are_named_by_their_number_or_else_by_their_line() {
    Document document;
    document.text = ProgramText("N103 G1 X1\nG1 N5 X2\n/ n7G0\n(N9)\n");
    QCOMPARE(block_name(document, 1), QString("N103"));
    QCOMPARE(block_name(document, 2), QString("line 2"));
    QCOMPARE(block_name(document, 3), QString("N7"));
    QCOMPARE(block_name(document, 4), QString("line 4"));
    QCOMPARE(block_name(document, 0), QString("–"));
  }

  void places_are_named_by_line_block_number_or_time() {
    Document document;
    document.text = ProgramText("N10 G1 X1\n(N20)\n/N020 X2\nN20 X3\n");
    QCOMPARE(place_named(document, " 2 ")->line, std::optional<std::uint32_t>(2));
    QCOMPARE(place_named(document, "n20")->line, std::optional<std::uint32_t>(3));
    QCOMPARE(place_named(document, "12.5 s")->time, std::optional(12.5));
    QCOMPARE(place_named(document, "3,25s")->time, std::optional(3.25));
    for (const char* nowhere : {"", "0", "5", "N30", "X1", "12.5", "-1 s", "s", "99999999999"}) {
      QVERIFY2(!place_named(document, nowhere), nowhere);
    }
  }

  void comments_and_line_numbers_are_quiet() {
    const auto spans = nc_spans("N10 G1 (fast) X1 ; end");
    QCOMPARE(spans.size(), std::size_t{5});
    QCOMPARE(spans[0].kind, NcSpanKind::quiet);  // N10
    QCOMPARE(spans[1].kind, NcSpanKind::code);   // G1
    QCOMPARE(spans[2].kind, NcSpanKind::quiet);  // (fast)
    QCOMPARE(spans[4].kind, NcSpanKind::quiet);  // ; end
  }

  void every_text_has_a_chinese_translation() {
    QFile file(test::source_dir() / "resources/translations/toolpace_zh_CN.ts");
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.count("<message") > 300);
    QCOMPARE(text.count("unfinished"), 0);
  }

  void a_timeline_finds_state_line_and_loss() {
    // 100 mm at 50 mm/s in a line: 2 s if the feed were kept all along; the rest is lost to the ramps at the ends.
    const auto outcome = planned(Program().feed(100, 0, 0, 50));
    const Timeline timeline(outcome);
    const double whole = timeline.duration();
    QVERIFY(whole > 2.0);
    QCOMPARE(timeline.at(0).state.speed, 0.0);
    QVERIFY(std::abs(timeline.at(whole / 2).state.speed - 50) < 1e-9);
    QVERIFY(std::abs(timeline.at(whole / 2).position.x() - 50) < 1e-6);
    QVERIFY(std::abs(timeline.at(1e9).position.x() - 100) < 1e-9);
    const auto line = timeline.at(whole / 2).line;
    QVERIFY(std::abs(timeline.lines()[line].loss() - (whole - 2.0)) < 1e-9);
    QCOMPARE(timeline.worst_lines().size(), std::size_t{1});
  }

  void a_dwell_before_a_line_is_not_lost_by_it() {
    const auto plain = planned(Program().feed(10, 0, 0, 50).feed(0, 0, 0, 50));
    const auto resting = planned(Program().feed(10, 0, 0, 50).dwell(2).feed(0, 0, 0, 50));
    const Timeline a(plain), b(resting);
    QVERIFY(b.duration() > a.duration() + 1.99);
    QVERIFY(std::abs(a.total_loss() - b.total_loss()) < 0.02);  // stopping fully at the corner costs a little
    QVERIFY(b.lines()[3].begin > 2.0);
  }

  void a_rest_belongs_to_the_line_that_asks_for_it() {
    // Lines 1, 3 and 5 move, 2 and 4 rest, the last one at the end.
    const auto outcome = planned(Program().feed(10, 0, 0, 50).dwell(2).feed(0, 0, 0, 50).dwell(3));
    const Timeline timeline(outcome);
    const auto& lines = timeline.lines();
    const std::uint32_t first = timeline.at(0).line;
    QCOMPARE(lines[first + 1].rest, 2.0);
    QCOMPARE(lines[first + 1].begin, outcome->node_time[1]);
    QVERIFY(std::abs(lines[first + 2].begin - outcome->node_time[1] - 2) < 1e-9);
    QCOMPARE(timeline.at(outcome->node_time[1] + 1).line, first + 1);
    QCOMPARE(timeline.at(outcome->node_time[1] + 2.001).line, first + 2);
    QCOMPARE(timeline.at(timeline.duration() - 1).line, first + 3);
    QCOMPARE(timeline.time_of_line(first + 3), std::optional(outcome->node_time[2]));
    // Stepping stands at each of them.
    std::vector<std::uint32_t> on, back;
    double time = 0;
    for (int i = 0; i < 3; ++i) on.push_back(timeline.at(time = timeline.next_line(time)).line);
    QCOMPARE(on, (std::vector<std::uint32_t>{first + 1, first + 2, first + 3}));
    for (int i = 0; i < 3; ++i) back.push_back(timeline.at(time = timeline.previous_line(time)).line);
    QCOMPARE(back, (std::vector<std::uint32_t>{first + 2, first + 1, first}));
  }

  void the_worst_lines_come_first_and_the_sums_agree() {
    Program program;
    for (int i = 1; i <= 40; ++i) program.feed(i % 2 ? i * 3.0 : 0.0, i * 0.5, 0, 80);
    const Timeline timeline(planned(program));
    const auto& worst = timeline.worst_lines();
    QCOMPARE(worst.size(), timeline.losing_lines());
    double sum = 0;
    for (std::size_t i = 0; i < worst.size(); ++i) {
      const double loss = timeline.lines()[worst[i]].loss();
      if (i > 0) QVERIFY(loss <= timeline.lines()[worst[i - 1]].loss());
      sum += loss;
    }
    QVERIFY(std::abs(sum - timeline.total_loss()) < 1e-9);
    QCOMPARE(timeline.lines()[worst.front()].loss(), timeline.worst_loss());
  }

  void stepping_goes_from_line_to_line_and_stops_at_the_ends() {
    const auto outcome = planned(Program().feed(10, 0, 0, 50).feed(10, 10, 0, 50).feed(0, 10, 0, 50));
    const Timeline timeline(outcome);
    double time = 0;
    time = timeline.next_line(time);
    QCOMPARE(time, outcome->node_time[1]);
    time = timeline.next_line(time);
    QCOMPARE(time, outcome->node_time[2]);
    QCOMPARE(timeline.previous_line(time), outcome->node_time[1]);
    QCOMPARE(timeline.previous_line(0), 0.0);
    QCOMPARE(timeline.next_line(timeline.duration()), timeline.duration());
  }
};

TOOLPACE_UI_TEST(ModelsTest)
#include "models_test.moc"
