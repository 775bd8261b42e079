#include "machine_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <utility>

#include "jobs/regular_file.h"
#include "toolpace/io/output_file.h"
#include "toolpace/machine/read_machine.h"

namespace toolpace::studio {
namespace {

bool is_built_in(const QString& path) { return path.startsWith(":/"); }

}  // namespace

std::vector<BuiltInMachine> built_in_machines() {
  std::vector<BuiltInMachine> machines;
  for (const QFileInfo& info : QDir(":/machines").entryInfoList({"*.toml"}, QDir::Files, QDir::Name)) {
    machines.push_back({info.filePath(), info.completeBaseName()});
  }
  return machines;
}

MachineFile::MachineFile(ui::TuningModel& tuning, QObject* parent) : QObject(parent), tuning_(tuning) {
  held_.setup = tuning.value();
  connect(&tuning_, &ui::TuningModel::changed, this, &MachineFile::compare);
  connect(&watcher_, &ui::FileWatcher::changed, this, &MachineFile::look);
}

bool MachineFile::isFileKnown() const {
  const auto now = ui::stamp_of(path_);
  return !now || now == held_.stamp;
}

Result<MachineFile::Content> MachineFile::read(const QString& path) const {
  Content content;
  if (is_built_in(path)) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
      return tl::unexpected(Error{ErrorKind::io, "cannot-open", file.errorString().toStdString(), {}, {}, {}});
    }
    content.text = file.readAll().toStdString();
  } else {
    const auto file = ui::read_regular_file(path);
    if (!file) return tl::unexpected(file.error());
    content.text = file->bytes.toStdString();
    content.stamp = file->stamp;
  }
  auto setup = parse_machine(content.text, path.toStdString());
  if (!setup) return tl::unexpected(setup.error());
  content.setup = std::move(*setup);
  return content;
}

Result<void> MachineFile::open(const QString& path) {
  auto content = read(path);
  if (!content) return tl::unexpected(content.error());
  const bool ours = machine_format(path.toStdString(), content->text) == MachineFormat::toml;
  imported_ = !ours;
  if (!ours) *content = {{}, content->setup, {}};
  tuning_.replace(tr("Open machine"), content->setup);
  name_ = QFileInfo(path).completeBaseName();
  source_ = imported_ ? QString() : is_built_in(path) ? path : QFileInfo(path).absoluteFilePath();
  input_ = is_built_in(path) ? QString() : QFileInfo(path).absoluteFilePath();
  settle(is_built_in(path) ? QString() : source_, std::move(*content));
  return {};
}

void MachineFile::openDefaults() {
  imported_ = false;
  tuning_.replace(tr("Default limits"), default_setup());
  name_.clear();
  source_.clear();
  input_.clear();
  settle({}, {{}, default_setup(), {}});
}

/// What the file shall hold: its own text with the values that differ, be it the one on the disk or, where another program
/// left no machine there, the one that was read.
Result<std::string> MachineFile::textFor(const QString& path) const {
  const Setup& setup = tuning_.value();
  if (path == path_ && !isFileKnown()) {
    const auto now = ui::read_regular_file(path);
    if (now) {
      if (auto text = edit_setup(now->bytes.toStdString(), path.toStdString(), setup)) return text;
    }
  }
  return held_.text.empty() ? format_setup(setup) : edit_setup(held_.text, path.toStdString(), setup);
}

Result<void> MachineFile::save(const QString& path) {
  const QString target = QFileInfo(path).absoluteFilePath();
  const auto text = textFor(target);
  if (!text) return tl::unexpected(text.error());
  watcher_.hold();
  const auto written = write_whole_file(target.toStdString(), *text);
  watcher_.release();
  if (!written) return written;
  imported_ = false;
  name_ = QFileInfo(target).completeBaseName();
  source_ = target;
  input_ = target;
  Setup saved = tuning_.value();
  saved.warnings.clear();
  settle(target, {*text, std::move(saved), ui::stamp_of(target)});
  return {};
}

void MachineFile::takeFile() {
  if (!outside_) return;
  tuning_.replace(tr("Machine file changed"), outside_->setup);
  settle(path_, *std::exchange(outside_, std::nullopt));
}

void MachineFile::keepMine() {
  if (!outside_) return;
  held_ = *std::exchange(outside_, std::nullopt);
  compare();
}

void MachineFile::settle(const QString& path, Content content) {
  path_ = path;
  held_ = std::move(content);
  outside_.reset();
  watcher_.watch(path_, held_.stamp);
  if (!imported_) tuning_.setClean();
  compare();
}

void MachineFile::look() {
  auto now = read(path_);
  if (!now) {
    emit unreadable(now.error());
    return;
  }
  if (now->text == held_.text) {
    held_.stamp = now->stamp;
    outside_.reset();
    return;
  }
  outside_ = std::move(*now);
  if (modified_) {
    emit changedOutside();
    return;
  }
  takeFile();
  emit takenOver();
}

void MachineFile::compare() {
  const bool differs = imported_ || !is_same_file(tuning_.value(), held_.setup);
  if (std::exchange(modified_, differs) != differs) emit modifiedChanged();
}

}  // namespace toolpace::studio
