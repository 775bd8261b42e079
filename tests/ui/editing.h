#pragma once
/// The whole window with a program from a file in it, to be edited.

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "opened.h"
#include "panels/change_bar.h"
#include "panels/nc_view.h"
#include "support/files.h"

namespace toolpace::ui {

class Editing : public Opened {
 public:
  explicit Editing(const QString& path) { openFile(path); }
  void openFile(const QString& path) {
    openProgram(path);
    studio::settle(*this);
  }
  ProgramModel& program() { return workspace().program(); }
  QString text() { return QString::fromUtf8(program().text().bytes()); }
  NcView& view() { return the<NcView>("ncView"); }
  /// Where a line is being written; one that was left lives on for a moment.
  QLineEdit& field() {
    for (auto* field : findChildren<QLineEdit*>("ncLineEditor")) {
      if (field->isVisible()) return *field;
    }
    qFatal("no line is being edited");
  }
  ChangeBar& bar() { return the<ChangeBar>("changeBar"); }
  double length() { return workspace().timeline()->outcome()->summary.path_length; }
  void save() {
    QSignalSpy saved(&workspace(), &Workspace::saved);
    actions().save_program->trigger();
    TOOLPACE_EVENTUALLY_EQUAL(saved.count(), 1);
    TOOLPACE_EVENTUALLY(!workspace().isSaving());
  }
};

}  // namespace toolpace::ui
