#include "random_user/user.h"

#include <QApplication>
#include <QDockWidget>
#include <QTest>
#include <QUndoStack>
#include <ctime>

#include "random_user/hands.h"
#include "screenshot.h"
#include "toolpace/machine/setup.h"

namespace toolpace::ui {
namespace {

// What is not done by then hangs. It counts what this process gets of the machine, which may have much else to do.
constexpr double kPatience = 120;   // s of CPU
constexpr int kLook = 10'000;       // ms
constexpr int kMostLooks = 6 * 60;  // of a process that waits for nothing

double used_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string text_of(const Setup& setup) {
  const auto text = format_setup(setup);
  return text ? *text : text.error().message;
}

}  // namespace

RandomUser::RandomUser(std::uint64_t seed) : chance_(seed), window_(std::make_unique<studio::MainWindow>(false)) {
  window_->setLanguage("en");
  window_->resize(1280, 800);
  window_->show();
  window_->openExample();
}

QString RandomUser::act() {
  const Answers answers(desk_, chance_);
  QString did;
  switch (pick(chance_, 12)) {
    case 0: did = use_files(); break;
    case 1:
    case 2: did = use_actions(); break;
    case 3: did = use_workspace(); break;
    case 4: did = use_window(); break;
    case 5:
    case 6: did = click_somewhere(*window_, chance_); break;
    case 7: did = drag_somewhere(*window_, chance_); break;
    case 8: did = turn_the_wheel(*window_, chance_); break;
    case 9: did = press_a_key(*window_, chance_); break;
    case 10: did = type_into_a_field(*window_, chance_); break;
    default: did = choose_in_a_list(*window_, chance_);
  }
  for (int turns = pick(chance_, 4); turns > 0; --turns) QApplication::processEvents();
  if (happens(chance_, 5) && !comes_to_rest()) qFatal("it never comes to rest");
  if (!window_->isVisible()) window_->show();  // it was closed
  return did;
}

QString RandomUser::use_files() {
  const QString target = one_of(chance_, desk_.targets());
  switch (pick(chance_, 9)) {
    case 0: desk_.disturb(chance_); return "changes a file on the disk";
    case 1: return drop_a_file(*window_, one_of(chance_, happens(chance_, 70) ? desk_.programs() : desk_.machines()));
    case 2: window_->openProgram(one_of(chance_, desk_.programs())); return "opens a program";
    case 3: window_->openMachine(one_of(chance_, desk_.machines())); return "opens a machine";
    case 4: window_->saveSetpoints(target); return "exports to " + target;
    case 5: window_->saveReport(target); return "saves a report to " + target;
    case 6: window_->storeMachineAs(target); return "saves the machine as " + target;
    case 7: window_->openExample(); return "opens the example";
    default: {
      using Picture = studio::MainWindow::Picture;
      window_->savePicture(static_cast<Picture>(pick(chance_, 3)), target);
      return "saves a picture to " + target;
    }
  }
}

QString RandomUser::use_actions() {
  const auto all = window_->QWidget::actions();
  QAction* const action = one_of(chance_, all);
  if (!action->isEnabled()) return "finds disabled: " + action->objectName();
  action->trigger();
  return "triggers " + action->objectName();
}

QString RandomUser::use_workspace() {
  Workspace& workspace = window_->workspace();
  switch (pick(chance_, 6)) {
    case 0: {
      const auto lines = workspace.document() ? workspace.document()->line_count() : 1;
      const int line = pick(chance_, lines + 2);
      const QString text = one_of(chance_, typed_lines());
      workspace.program().replaceLine(line, text);
      return QString("types '%1' as line %2").arg(text).arg(line);
    }
    case 1: workspace.setCursorTime(pick(chance_, 100) * 0.1); return "moves the cursor";
    case 2: workspace.cancel(); return "cancels";
    case 3: workspace.swap(); return "swaps";
    case 4: workspace.pin(); return "pins";
    default: workspace.reload(); return "reloads";
  }
}

QString RandomUser::use_window() {
  switch (pick(chance_, 5)) {
    case 0: {
      const QSize size(640 + pick(chance_, 1400), 400 + pick(chance_, 800));
      window_->resize(size);
      return QString("resizes to %1 x %2").arg(size.width()).arg(size.height());
    }
    case 1: window_->setDark(happens(chance_, 50)); return "changes the theme";
    case 2: window_->setLanguage(happens(chance_, 50) ? "en" : "zh_CN"); return "changes the language";
    case 3: window_->setInch(happens(chance_, 50)); return "changes the unit";
    default: {
      auto* const dock = one_of(chance_, window_->findChildren<QDockWidget*>());
      dock->setVisible(happens(chance_, 85));
      dock->raise();
      return "raises " + dock->objectName();
    }
  }
}

std::string RandomUser::tuning() const { return text_of(window_->workspace().tuning().value()); }

QString RandomUser::trouble() {
  Workspace& workspace = window_->workspace();
  const auto& document = workspace.document();
  if (workspace.plan() && !document) return "there is a plan and no program";
  if (workspace.plan() && !workspace.isStale() && !workspace.isBusy()) {
    const Job& job = *workspace.timeline()->outcome()->job;
    if (job.program != document->reading) return "the plan that counts as fresh is of another program";
    if (workspace.refinement() == Refiner::State::idle && text_of({job.machine, job.options}) != tuning())
      return "the plan that counts as fresh has other parameters";
  }
  const QUndoStack& undo = workspace.tuning().undoStack();
  if (undo.index() < 0 || undo.index() > undo.count()) return "the place in the undo stack is outside of it";
  if (window_->actions().undo->isEnabled() != undo.canUndo())
    return "Undo is enabled where nothing can be undone, or not";
  if (window_->actions().redo->isEnabled() != undo.canRedo())
    return "Redo is enabled where nothing can be redone, or not";
  if (!(workspace.cursorTime() >= 0)) return "the cursor is at no time";
  return {};
}

bool RandomUser::comes_to_rest() {
  window_->workspace().playback().pause();
  const auto rests = [this] { return window_->isSettled() && !window_->workspace().isProving(); };
  const double begin = used_seconds();
  for (int look = 0; look < kMostLooks && used_seconds() - begin < kPatience; ++look) {
    if (QTest::qWaitFor(rests, kLook)) return true;
  }
  return false;
}

QString RandomUser::deep_trouble() {
  const Answers answers(desk_, chance_);
  if (!comes_to_rest()) return "it never comes to rest";
  if (const QString wrong = trouble(); !wrong.isEmpty()) return wrong;
  if (const QStringList left = desk_.leftovers(); !left.isEmpty()) return "left over: " + left.join(", ");
  return undo_trouble();
}

QString RandomUser::undo_trouble() {
  QUndoStack& undo = window_->workspace().tuning().undoStack();
  const std::string before = tuning();
  const int place = undo.index(), count = undo.count();
  while (undo.canUndo()) undo.undo();
  undo.setIndex(place);
  if (undo.count() != count || undo.index() != place) return "undoing and redoing changes the undo stack";
  if (tuning() != before) return "undoing and redoing changes the parameters";
  if (!comes_to_rest()) return "it never comes to rest after undoing";
  return trouble();
}

}  // namespace toolpace::ui
