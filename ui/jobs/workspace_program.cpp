/// The program of a workspace: opening, editing, reading again, saving.

#include <algorithm>
#include <utility>

#include "jobs/workspace.h"
#include "toolpace/limits/travel.h"

namespace toolpace::ui {
namespace {

/// Whether it is about the tool's tip, or was to be.
bool asks_for_kinematics(const Reading& reading) {
  return reading.moves.has_tip() ||
         std::any_of(reading.diagnostics.begin(), reading.diagnostics.end(), [](const Diagnostic& d) {
           return d.code == "kinematics-missing" || d.code == "tool-length-missing";
         });
}

}  // namespace

void Workspace::connectProgram() {
  connect(&reader_, &ReaderService::read, this, &Workspace::takeDocument);
  connect(&reader_, &ReaderService::failed, this, [this](const Error& error, const QString& path) {
    emit openFailed(error, path);
    giveUpOpening();
  });
  connect(&reader_, &ReaderService::progressed, this, &Workspace::progressed);
  connect(&saver_, &SaveService::saved, this, &Workspace::takeSaved);
  connect(&saver_, &SaveService::failed, this, [this](const Error& error, const QString& path) {
    watcher_.release();
    emit saveFailed(error, path);
  });
  connect(&program_, &ProgramModel::edited, this, [this](qsizetype line) {
    setStale(true);
    emit textChanged(line);
    readText();
  });
  connect(&watcher_, &FileWatcher::changed, this, &Workspace::takeOutsideChange);
  const auto busy = [this] { emit busyChanged(isBusy()); };
  connect(&reader_, &ReaderService::busyChanged, this, busy);
  connect(&saver_, &SaveService::busyChanged, this, busy);
}

void Workspace::openFile(const QString& path) {
  opening_ = true;
  reader_.readFile(path);
}

void Workspace::openText(const QByteArray& text, const QString& name) {
  opening_ = true;
  reader_.readText(text, name);
}

/// The program that was to go stays: what happened to it meanwhile counts.
void Workspace::giveUpOpening() {
  if (!std::exchange(opening_, false)) return;
  const bool text_waits = std::exchange(text_waits_, false);
  if (std::exchange(change_waits_, false)) takeOutsideChange();
  if (text_waits && !reader_.isBusy()) readText();
}

void Workspace::readText() {
  if (opening_) {
    text_waits_ = true;
    return;
  }
  reader_.readEdited({program_.path(), program_.name(), program_.text(), program_.state()});
}

void Workspace::setReadOptions(const ReadOptions& options) {
  read_options_ = options;
  reader_.setOptions(readOptions());
  if (document_) readText();
}

ReadOptions Workspace::readOptions() const {
  ReadOptions options = read_options_;
  options.kinematics = tuning_.value().kinematics;
  options.travel = rotary_travel(tuning_.value().machine);
  return options;
}

/// Another machine may read the same program another way.
void Workspace::followMachine() {
  const ReadOptions before = reader_.options(), now = readOptions();
  if (before.kinematics == now.kinematics && before.travel == now.travel) return;
  reader_.setOptions(now);
  if (document_ && asks_for_kinematics(*document_->reading)) readText();
}

void Workspace::reload() {
  if (!document_) return;
  emit editsWanted();
  if (program_.path().isEmpty()) return readText();
  if (program_.isModified()) return setConflict(Conflict::reload);
  reader_.readFile(program_.path());
}

void Workspace::takeOutsideChange() {
  if (opening_) {
    change_waits_ = true;
    return;
  }
  emit editsWanted();
  if (program_.isModified()) return setConflict(Conflict::changed_outside);
  reader_.readFile(program_.path());
}

void Workspace::takeFile() {
  setConflict(Conflict::none);
  reader_.readFile(program_.path());
}

void Workspace::keepMine() {
  if (conflict_ == Conflict::changed_outside) {
    program_.forgetSaved();
    known_ = stamp_of(program_.path());
  }
  setConflict(Conflict::none);
  if (read_state_ != program_.state()) readText();  // reading it had been cancelled
}

void Workspace::setConflict(Conflict conflict) {
  if (conflict == conflict_) return;
  conflict_ = conflict;
  emit conflictChanged(conflict);
}

bool Workspace::isFileKnown() const {
  const auto now = stamp_of(program_.path());
  return !now || now == known_;
}

void Workspace::save(const QString& path) {
  watcher_.hold();
  saving_this_program_ = true;
  saver_.start(program_.text(), program_.state(), path);
}

void Workspace::takeSaved(const QString& path, quint64 state, std::optional<FileStamp> stamp) {
  if (std::exchange(saving_this_program_, false)) {
    const bool elsewhere = path != program_.path();
    known_ = stamp;
    program_.setSaved(path, state);
    setConflict(Conflict::none);
    watcher_.watch(path, stamp);
    if (elsewhere) readText();  // another folder has other sub-programs, another extension may be another format
  }
  emit saved(path);
}

/// @return whether it is another program than before
bool Workspace::takeText(const Document& document, std::optional<FileStamp> stamp) {
  if (document.edited_state) {
    read_state_ = *document.edited_state;
    return false;
  }
  opening_ = text_waits_ = change_waits_ = false;
  const bool another = !document_ || program_.path() != document.path || program_.name() != document.name;
  if (another) {
    saving_this_program_ = false;
    program_.open(document.path, document.name, document.text);
  } else {
    program_.takeFile(document.text);
  }
  read_state_ = program_.state();
  known_ = stamp;
  setConflict(Conflict::none);
  watcher_.watch(document.path, stamp);
  return another;
}

void Workspace::takeDocument(std::shared_ptr<const Document> document, std::optional<FileStamp> stamp) {
  const bool another = takeText(*document, stamp);
  document_ = std::move(document);
  if (another) {
    playback_.pause();
    pinned_ = {};
    plan_ = {};
    forgetController();
    cursor_ = 0;
  }
  collectProblems({});
  emit documentChanged(another);
  if (another) {
    emit pinnedChanged();
    emit planChanged();
    emit cursorChanged(cursor_);
  }
  runOnController();
  if (another && tuning_.value().options.hold_at) {  // a moment of the other program
    return tuning_.edit(tr("Feed hold"), "hold", [](Tuning& t) { t.options.hold_at.reset(); });
  }
  replan();
}

}  // namespace toolpace::ui
