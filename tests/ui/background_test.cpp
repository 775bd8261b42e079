/// A worker whose task throws tells so, and works on.

#include <QDockWidget>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <new>
#include <optional>
#include <stdexcept>

#include "jobs/background.h"
#include "opened.h"
#include "panels/sweep_panel.h"
#include "panels/tune_page.h"
#include "support/memory_limit.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

/// A program of many blocks, so that what is made of it is large.
QByteArray winding_text(int blocks) {
  QByteArray text = "G21 G90 G94 F6000\n";
  for (int i = 0; i < blocks; ++i) {
    text += "G1 X" + QByteArray::number(0.1 * i) + " Y" + QByteArray::number(i % 2) + "\n";
  }
  return text + "M2\n";
}

bool has_problem(Workspace& workspace, const std::string& code) {
  const auto& all = workspace.problems();
  return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) { return d.code == code; });
}

constexpr int kBlocks = 4000;
constexpr std::size_t kLittle = 20'000;  // bytes; less than a number a block

}  // namespace

class BackgroundTest : public QObject {
  Q_OBJECT

 private:
  std::vector<Error> errors_;
  int delivered_ = 0;

  void run(Background& worker, Background::Task task) {
    QSignalSpy finished(&worker, &Background::finished);
    worker.start(std::move(task), [this](const Error& error) { errors_.push_back(error); });
    QVERIFY(worker.isBusy());
    TOOLPACE_EVENTUALLY_EQUAL(finished.count(), 1);
    QVERIFY(!worker.isBusy());
  }

 private slots:
  void init() {
    errors_.clear();
    delivered_ = 0;
  }

  void a_task_that_throws_is_told_as_an_error_and_the_next_one_runs() {
    Background worker;
    run(worker, [](const Monitor&) -> Background::Delivery { throw std::bad_alloc(); });
    run(worker, [](const Monitor&) -> Background::Delivery { throw std::runtime_error("why"); });
    run(worker, [](const Monitor&) -> Background::Delivery { throw 7; });
    QCOMPARE(errors_.size(), std::size_t{3});
    QCOMPARE(errors_[0].code, std::string("out-of-memory"));
    QCOMPARE(errors_[1].code, std::string("internal"));
    QCOMPARE(errors_[1].message, std::string("internal error: why"));
    QCOMPARE(errors_[2].code, std::string("internal"));
    run(worker, [this](const Monitor&) -> Background::Delivery { return [this] { ++delivered_; }; });
    QCOMPARE(delivered_, 1);
    QCOMPARE(errors_.size(), std::size_t{3});
  }

  void a_delivery_that_throws_is_told_too() {
    Background worker;
    run(worker, [](const Monitor&) -> Background::Delivery { return [] { throw std::bad_alloc(); }; });
    QCOMPARE(errors_.size(), std::size_t{1});
    QCOMPARE(errors_[0].code, std::string("out-of-memory"));
  }

  void reading_without_memory_is_an_error_in_the_window_and_what_was_open_stays() {
    Opened window;
    window.open("G21 G90 F600\nG1 X10\nM2\n");
    QSignalSpy failed(&window, &studio::MainWindow::failed);
    {
      const MemoryLimit limit(kLittle);
      window.workspace().openText(winding_text(kBlocks), "long.ngc");
      TOOLPACE_EVENTUALLY(!window.workspace().isBusy());
    }
    QCOMPARE(failed.count(), 1);
    QCOMPARE(failed[0][0].value<Error>().code, std::string("out-of-memory"));
    QCOMPARE(window.workspace().document()->name, QString("program.ngc"));
    QVERIFY(window.the<QTableView>("problemTable").model()->rowCount() > 0);
    window.open(winding_text(kBlocks), "long.ngc");
    QVERIFY(window.workspace().plan());
  }

  void planning_without_memory_is_a_problem_and_the_plan_is_called_stale() {
    Opened window;
    window.open(winding_text(kBlocks));
    window.waitForProof();
    {
      const MemoryLimit limit(kLittle);
      window.workspace().tuning().edit("a", "a", [](Tuning& t) { t.machine.path.acceleration = 1500; });
      TOOLPACE_EVENTUALLY(!window.workspace().isBusy());
    }
    QVERIFY(has_problem(window.workspace(), "out-of-memory"));
    QVERIFY(window.workspace().isStale());
    window.actions().undo->trigger();
    studio::settle(window);
    QVERIFY(!window.workspace().isStale());
    QVERIFY(!has_problem(window.workspace(), "out-of-memory"));
  }

  void proving_without_memory_is_a_problem_beside_the_plan() {
    Opened window;
    auto& workspace = window.workspace();
    const int before = MemoryLimit::refusals();
    {
      std::optional<MemoryLimit> limit;  // from the plan on, which is what is proven
      const QObject scope;
      connect(&workspace, &Workspace::planChanged, &scope, [&] {
        if (workspace.plan() && !limit) limit.emplace(kLittle);
      });
      workspace.openText(winding_text(kBlocks), "long.ngc");
      TOOLPACE_EVENTUALLY(has_problem(workspace, "out-of-memory"));
    }
    QVERIFY(MemoryLimit::refusals() > before);
    QVERIFY(has_problem(window.workspace(), "out-of-memory"));
    QVERIFY(window.workspace().plan());
  }

  void sweeps_and_savings_without_memory_say_so_and_can_be_asked_again() {
    Opened window;
    window.open(winding_text(kBlocks));
    window.waitForProof();
    auto& sweep = window.the<SweepPanel>("sweepPanel");
    auto& page = window.the<TunePage>("tunePage");
    window.the<QDockWidget>("tuneDock").show();
    studio::settle(window);
    QSignalSpy swept(&sweep, &SweepPanel::computed), tried(&page.changes(), &SingleChangesPanel::computed),
        searched(&page, &TunePage::searched);
    {
      const MemoryLimit limit(kLittle);
      sweep.compute();
      page.changes().compute();
      page.search();
      TOOLPACE_EVENTUALLY_EQUAL(swept.count() + tried.count() + searched.count(), 3);
    }
    QCOMPARE(window.the<QLabel>("sweepVerdict").text(), QString("there is not enough memory for this"));
    QVERIFY(window.the<QPushButton>("sweepButton").isEnabled());
    QCOMPARE(window.the<QLabel>("changesHint").text(), QString("there is not enough memory for this"));
    QCOMPARE(window.the<QLabel>("tuneVerdict").text(), QString("there is not enough memory for this"));
  }

  void an_export_without_memory_leaves_no_file() {
    QTemporaryDir folder;
    Opened window;
    window.open(winding_text(kBlocks));
    window.waitForProof();
    QSignalSpy failed(&window, &studio::MainWindow::failed);
    {
      const MemoryLimit limit(kLittle);
      window.saveSetpoints(folder.filePath("out.csv"));
      TOOLPACE_EVENTUALLY(window.isSettled());
    }
    QCOMPARE(failed.count(), 1);
    QVERIFY(QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden));
  }
};

TOOLPACE_UI_TEST(BackgroundTest)
#include "background_test.moc"
