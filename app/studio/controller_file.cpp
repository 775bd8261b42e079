#include "controller_file.h"

#include <QFileInfo>
#include <utility>

#include "toolpace/io/output_file.h"
#include "toolpace/machine/settings_includes.h"

namespace toolpace::studio {

ControllerFile::ControllerFile(ui::ControllerModel& model, QObject* parent) : QObject(parent), model_(model) {
  connect(&model_, &ui::ControllerModel::changed, this, &ControllerFile::follow);
  connect(&watcher_, &ui::FileWatcher::changed, this, &ControllerFile::look);
}

bool ControllerFile::isFileKnown() const {
  const auto now = ui::stamp_of(path_);
  const auto held = held_.find(path_);
  return !now || (held != held_.end() && now == held->second.stamp);
}

/// The file, with those that it includes: later edits read these no more.
Result<ControllerFile::Held> ControllerFile::read(const QString& path) {
  const auto file = ui::read_regular_file(path);
  if (!file) return tl::unexpected(file.error());
  const Monitor monitor;
  IncludedFiles files(path.toStdString(), monitor);
  auto texts = std::make_shared<ui::IncludedTexts>();
  const ReadIncluded keep = [&, from = files.reader()](std::string_view name) {
    return texts->insert_or_assign(std::string(name), from(name)).first->second;
  };
  // Once to find all that is included, once with what was found.
  std::string text = file->bytes.toStdString();
  const auto settings = parse_controller_settings(text, path.toStdString(), {}, keep);
  if (files.error()) return tl::unexpected(*files.error());
  if (!settings) return tl::unexpected(settings.error());
  auto parsed = ui::parse_controller_text(path, std::move(text), std::move(texts));
  if (!parsed) return tl::unexpected(parsed.error());
  return Held{std::move(*parsed), file->stamp};
}

Result<void> ControllerFile::open(const QString& path) {
  const QString whole = QFileInfo(path).absoluteFilePath();
  auto held = read(whole);
  if (!held) return tl::unexpected(held.error());
  const auto text = held->text;
  held_[whole] = std::move(*held);
  model_.replace(tr("Choose a controller"), text);
  return {};
}

void ControllerFile::leave() { model_.replace(tr("Run on Toolpace's plan"), nullptr); }

/// What the file shall hold: where another program wrote to it meanwhile, its text with what was changed here.
ui::SharedControllerText ControllerFile::textFor(const QString& path) const {
  const auto held = held_.find(path);
  if (path != path_ || isFileKnown() || held == held_.end()) return model_.text();
  const auto now = read(path);
  if (!now) return model_.text();
  const auto carried = ui::carried_over(*now->text, *model_.text(), *held->second.text);
  return carried ? *carried : model_.text();
}

Result<void> ControllerFile::save(const QString& path) {
  if (!model_.text()) return {};
  const QString target = QFileInfo(path).absoluteFilePath();
  const auto text = textFor(target);
  watcher_.hold();
  const auto written = write_whole_file(target.toStdString(), text->text);
  watcher_.release();
  if (!written) return written;
  auto saved = text;
  if (target != text->path) {
    auto moved = ui::parse_controller_text(target, text->text, text->included);
    if (!moved) return tl::unexpected(moved.error());
    saved = std::move(*moved);
  }
  held_[target] = {saved, ui::stamp_of(target)};
  outside_.reset();
  if (saved != model_.text()) model_.replace(tr("Save settings"), saved);
  watcher_.watch(target, held_[target].stamp);
  compare();
  return {};
}

void ControllerFile::takeFile() {
  if (!outside_) return;
  Held now = *std::exchange(outside_, std::nullopt);
  const auto text = now.text;
  held_[path_] = std::move(now);
  model_.replace(tr("Settings file changed"), text);
  compare();
}

Result<void> ControllerFile::keepMine() {
  if (!outside_ || !model_.text()) return {};
  auto mine = ui::carried_over(*outside_->text, *model_.text(), *held_[path_].text);
  if (!mine) return tl::unexpected(mine.error());
  held_[path_] = *std::exchange(outside_, std::nullopt);
  model_.replace(tr("Settings file changed"), *mine);
  compare();
  return {};
}

/// Whatever was done or undone: which file counts, and whether it says the same.
void ControllerFile::follow() {
  const QString path = model_.text() ? model_.text()->path : QString();
  if (path != path_) {
    path_ = path;
    outside_.reset();
    watcher_.watch(path_, path_.isEmpty() ? std::nullopt : held_[path_].stamp);
    emit pathChanged();
  }
  compare();
}

void ControllerFile::look() {
  auto now = read(path_);
  if (!now) {
    emit unreadable(now.error());
    return;
  }
  Held& held = held_[path_];
  if (now->text->text == held.text->text) {
    held.stamp = now->stamp;
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

void ControllerFile::compare() {
  const auto held = held_.find(path_);
  const bool differs = model_.text() && (held == held_.end() || held->second.text->text != model_.text()->text);
  if (std::exchange(modified_, differs) != differs) emit modifiedChanged();
}

}  // namespace toolpace::studio
