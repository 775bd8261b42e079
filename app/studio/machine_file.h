#pragma once
/// The machine in use and the file behind it: opening, saving in place, changes by other programs.

#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "jobs/file_watcher.h"
#include "models/tuning_model.h"
#include "toolpace/base/result.h"

namespace toolpace::studio {

/// A machine that comes with the program.
struct BuiltInMachine {
  QString path;  ///< in the resources
  QString name;
};
std::vector<BuiltInMachine> built_in_machines();

/// Where the machine in use came from, and whether the tuning holds more than that place does. Machines of other
/// controllers are never written back: they have no file until they are saved as one of ours.
class MachineFile : public QObject {
  Q_OBJECT

 public:
  explicit MachineFile(ui::TuningModel& tuning, QObject* parent = nullptr);

  const QString& path() const { return path_; }  ///< the file that saving writes; empty: there is none yet
  const QString& source() const {
    return source_;
  }  ///< file or built-in machine to open at the next start; may be empty
  /// What is on the disk of it: path(), or the settings of another controller that were read; empty: nothing.
  const QString& input() const { return input_; }
  const QString& name() const { return name_; }  ///< shown to people; empty: the default limits
  /// Saving would write something that is nowhere yet. Overrides and holds are of a job, not of the machine.
  bool isModified() const { return modified_; }
  /// What the settings of another controller left open, until the machine is saved as one of ours.
  const Diagnostics& warnings() const { return held_.setup.warnings; }
  /// False where another program wrote to the file since it was read or written here.
  bool isFileKnown() const;

  /// Takes the place of the tuning, as an undo step. Errors: io, those of parse_machine().
  Result<void> open(const QString& path);
  void openDefaults();
  /// Writes what differs into the file, whole or not at all; it becomes the machine's. Errors: io, those of edit_setup().
  Result<void> save(const QString& path);

  void takeFile();  ///< what another program wrote replaces the tuning, as an undo step
  void keepMine();  ///< the tuning stays, and saving puts it into what the other program wrote

 signals:
  void modifiedChanged();
  void changedOutside();  ///< takeFile() or keepMine() is for a person to choose
  void takenOver();       ///< another program's change is in the tuning; nothing of a person's was in its way
  void unreadable(const toolpace::Error& error);  ///< another program left something that is no machine

 private:
  struct Content {
    std::string text;
    Setup setup;
    std::optional<ui::FileStamp> stamp;
  };
  Result<Content> read(const QString& path) const;
  Result<std::string> textFor(const QString& path) const;
  void settle(const QString& path, Content content);
  void look();
  void compare();

  ui::TuningModel& tuning_;
  ui::FileWatcher watcher_;
  QString path_, source_, input_, name_;
  Content held_;                    ///< the file as it was read or written; no text: none of ours
  std::optional<Content> outside_;  ///< another program's, until a person has chosen
  bool imported_ = false;           ///< in no file of ours yet
  bool modified_ = false;
};

}  // namespace toolpace::studio
