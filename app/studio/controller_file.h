#pragma once
/// The settings file of the controller that is chosen: opening, saving in place, changes by other programs.

#include <QObject>
#include <QString>
#include <map>
#include <optional>

#include "jobs/file_watcher.h"
#include "jobs/regular_file.h"
#include "models/controller_model.h"

namespace toolpace::studio {

/// What stands on the disk, and whether the model holds more than that. Undo may go back to settings of another file, which is
/// then the one that counts.
class ControllerFile : public QObject {
  Q_OBJECT

 public:
  explicit ControllerFile(ui::ControllerModel& model, QObject* parent = nullptr);

  const QString& path() const { return path_; }  ///< empty: the program runs on Toolpace's plan
  bool isModified() const { return modified_; }  ///< saving would write something that is nowhere yet
  /// False where another program wrote to the file since it was read or written here.
  bool isFileKnown() const;

  /// The program runs on this controller from now on, as an undo step. Errors: io, those of read_controller_settings().
  Result<void> open(const QString& path);
  /// It runs on Toolpace's own plan, as an undo step.
  void leave();
  /// Writes the text, whole or not at all, and to another path as that file's from now on. Into what another program left there, only
  /// what was changed here. Errors: io.
  Result<void> save(const QString& path);

  void takeFile();          ///< what another program wrote replaces the settings, as an undo step
  Result<void> keepMine();  ///< what was edited here is put into what the other program wrote, as an undo step

 signals:
  void modifiedChanged();
  void pathChanged();     ///< another file counts, by choice or by undo
  void changedOutside();  ///< takeFile() or keepMine() is for a person to choose
  void takenOver();       ///< another program's change is in the settings; nothing of a person's was in its way
  void unreadable(
      const toolpace::Error& error);  ///< another program left something that is no settings of a controller

 private:
  /// A file as it was read or written last.
  struct Held {
    ui::SharedControllerText text;
    std::optional<ui::FileStamp> stamp;
  };
  static Result<Held> read(const QString& path);
  ui::SharedControllerText textFor(const QString& path) const;
  void follow();
  void look();
  void compare();

  ui::ControllerModel& model_;
  ui::FileWatcher watcher_;
  QString path_;
  std::map<QString, Held> held_;  ///< by path; undo may come back to any of them
  std::optional<Held> outside_;   ///< another program's, until a person has chosen
  bool modified_ = false;
};

}  // namespace toolpace::studio
