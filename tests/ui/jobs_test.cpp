/// Workers and what they hand over, without a window. Under ThreadSanitizer this is the proof that nothing is shared without a
/// lock.

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <numeric>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "jobs/export_service.h"
#include "jobs/mailbox.h"
#include "jobs/tune_service.h"
#include "jobs/workspace.h"
#include "support/patience.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

const QByteArray kSquare = "G21 G90 G94\nG1 F1200 X10\nY10\nX0\nY0\nM2\n";
const QByteArray kTurn = "G21 G90 G94\nG1 F600 X5 A90\nG2 X10 I2.5\nG4 P0.1\nG1 Y3\nM2\n";
const QByteArray kWrong = "G21 G90\nG2 X10 R1\nG1 X5 F100\nM2\n";

/// Somebody who edits faster than workers plan.
class Hurry {
 public:
  explicit Hurry(Workspace& workspace) : workspace_(workspace) {}

  void act() {
    switch (pick(9)) {
      case 0: return workspace_.openText(pick(2) == 0 ? kSquare : kTurn, "square.ngc");
      case 1: return workspace_.openText(kWrong, "wrong.ngc");
      case 2: return workspace_.program().replaceLine(2, QString("G1 F%1 X%2").arg(100 + pick(3000)).arg(1 + pick(20)));
      case 3: return workspace_.cancel();
      case 4: return workspace_.reload();
      case 5: return workspace_.setShownAxes({pick(2) == 0, pick(2) == 0, pick(2) == 0, false, pick(2) == 0, false});
      case 6: return pick(2) == 0 ? workspace_.pin() : workspace_.swap();
      default: return edit();
    }
  }
  int pick(int end) { return static_cast<int>(chance_() % static_cast<unsigned>(end)); }

 private:
  void edit() {
    workspace_.tuning().edit("edit", "key", [this](Tuning& t) {
      constexpr std::array kRules = {CornerRule::servo, CornerRule::blend, CornerRule::smooth};
      t.options.corner.rule = kRules[static_cast<std::size_t>(pick(3))];
      t.options.law = pick(2) == 0 ? LawKind::quintic : LawKind::seven_phase;
      t.machine.path.speed = 10 + pick(100);
      if (t.options.corner.rule == CornerRule::smooth) {
        for (auto& axis : t.machine.axes) axis.speed = 100, axis.acceleration = 1000, axis.jerk = 1e5;
      }
    });
  }

  Workspace& workspace_;
  std::mt19937 chance_{1};
};

bool comes_to_rest(const Workspace& workspace) {
  return eventually([&] { return !workspace.isBusy() && !workspace.isProving(); });
}

}  // namespace

class JobsTest : public QObject {
  Q_OBJECT

 private slots:
  void letters_of_two_threads_are_done_here_each_threads_in_its_order() {
    constexpr int kLetters = 1000;
    Mailbox mailbox;
    std::vector<int> done[2];
    int elsewhere = 0;
    const auto here = std::this_thread::get_id();
    std::vector<std::thread> writers;
    for (auto& mine : done) {
      writers.emplace_back([&] {
        for (int i = 0; i < kLetters; ++i) {
          mailbox.post([&, i] {
            mine.push_back(i);
            if (std::this_thread::get_id() != here) ++elsewhere;
          });
        }
      });
    }
    const auto is_done = [&] { return done[0].size() + done[1].size() == 2 * kLetters; };
    QVERIFY(eventually(is_done));
    for (auto& writer : writers) writer.join();
    std::vector<int> in_order(kLetters);
    std::iota(in_order.begin(), in_order.end(), 0);
    QCOMPARE(done[0], in_order);
    QCOMPARE(done[1], in_order);
    QCOMPARE(elsewhere, 0);
  }

  void a_letter_that_waits_for_the_next_one_gets_it() {
    Mailbox mailbox;
    bool is_next_done = false, has_waited = false;
    mailbox.post([&] { has_waited = eventually([&] { return is_next_done; }); });
    mailbox.post([&] { is_next_done = true; });
    QVERIFY(eventually([&] { return has_waited; }));
  }

  void letters_that_are_left_when_the_mailbox_goes_are_never_done() {
    std::optional<Mailbox> mailbox(std::in_place);
    int done = 0;
    mailbox->post([&] {
      ++done;
      mailbox.reset();
    });
    mailbox->post([&] { ++done; });
    QVERIFY(eventually([&] { return !mailbox; }));
    Mailbox later;
    bool is_later = false;
    later.post([&] { is_later = true; });
    QVERIFY(eventually([&] { return is_later; }));
    QCOMPARE(done, 1);
  }

  void however_fast_somebody_edits_the_plan_at_rest_is_the_one_of_what_is_there() {
    Workspace workspace;
    Hurry hurry(workspace);
    for (int step = 0; step < 300; ++step) {
      hurry.act();
      if (hurry.pick(3) == 0) QCoreApplication::processEvents();
      if (hurry.pick(20) == 0) QVERIFY(comes_to_rest(workspace));
    }
    workspace.openText(kSquare, "square.ngc");
    QVERIFY(comes_to_rest(workspace));
    QVERIFY(workspace.plan() && !workspace.isStale());
    QCOMPARE(workspace.timeline()->outcome()->job->program, workspace.document()->reading);
    QVERIFY(workspace.plan().proof);
  }

  void a_workspace_that_goes_away_while_its_workers_work_takes_them_along() {
    for (int turn = 0; turn < 20; ++turn) {
      Workspace workspace;
      workspace.openText(turn % 2 == 0 ? kSquare : kTurn, "program.ngc");
      for (int events = 0; events < turn; ++events) QCoreApplication::processEvents();
      workspace.tuning().edit("edit", "key", [](Tuning& t) { t.machine.path.speed = 20; });
      for (int events = 0; events < turn; ++events) QCoreApplication::processEvents();
    }
  }

  void plans_are_swept_searched_and_exported_beside_each_other() {
    Workspace workspace;
    workspace.openText(kSquare, "square.ngc");
    QVERIFY(comes_to_rest(workspace));
    TuneService sweeps, savings, searches;
    ExportService exporter;
    QTemporaryDir folder;
    QSignalSpy swept(&sweeps, &TuneService::swept), found(&savings, &TuneService::changesTried),
        best(&searches, &TuneService::tuned), saved(&exporter, &ExportService::saved);
    const auto job = workspace.job();
    sweeps.sweep(job);
    savings.trySingleChanges(job);
    TuneOptions few;
    few.plans = 20;
    searches.search(job, few);
    exporter.start(workspace.timeline()->outcome(), folder.filePath("out.npz"));
    workspace.tuning().edit("edit", "key", [](Tuning& t) { t.machine.path.speed = 30; });
    TOOLPACE_EVENTUALLY(!swept.isEmpty() && !found.isEmpty() && !best.isEmpty() && !saved.isEmpty());
    QVERIFY(comes_to_rest(workspace));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{"out.npz"});
  }
};

TOOLPACE_UI_TEST(JobsTest)
#include "jobs_test.moc"
