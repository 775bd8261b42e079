#include "jobs/reader_service.h"

#include <QFileInfo>

#include "toolpace/nc/reader.h"

namespace toolpace::ui {
namespace {

/// Nothing was understood, for this reason.
Reading refused(const Error& error) {
  Reading reading;
  reading.moves.files = {error.where.file};
  reading.diagnostics = {{Severity::error, error.code, error.message, error.remedy, error.where, {}}};
  reading.refused = true;
  return reading;
}

}  // namespace

ReaderService::ReaderService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &ReaderService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!pending_) return emit busyChanged(false);
    std::exchange(pending_, nullptr)();
  });
}

Result<ReaderService::Found> ReaderService::understand(const ProgramSource& source, ReadOptions options,
                                                       const Monitor& monitor) {
  auto document = std::make_shared<Document>();
  document->path = source.path;
  document->name = source.name;
  document->text = source.text;
  document->edited_state = source.edited_state;
  if (!source.path.isEmpty()) options.sub_paths.push_back(QFileInfo(source.path).absolutePath().toStdString());
  const QByteArray bytes = source.text.bytes();
  const std::string_view view(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  auto reading = toolpace::read_text(view, source.name.toStdString(), options, monitor);
  if (!reading && (!source.edited_state || reading.error().kind == ErrorKind::cancelled)) {
    return tl::unexpected(reading.error());
  }
  document->reading = std::make_shared<const Reading>(reading ? std::move(*reading) : refused(reading.error()));
  document->turned = turned_axes(document->reading->moves);
  return Found{document, {}};
}

Result<ReaderService::Found> ReaderService::load(const QString& path, const ReadOptions& options,
                                                 const Monitor& monitor) {
  auto content = read_regular_file(path, monitor);
  if (!content) return tl::unexpected(content.error());
  const QString name = QFileInfo(path).fileName();
  auto found = understand({path, name, ProgramText(std::move(content->bytes))}, options, monitor);
  if (found) found->stamp = content->stamp;
  return found;
}

void ReaderService::readFile(const QString& path) {
  submit(path, [path, options = options_](const Monitor& monitor) { return load(path, options, monitor); });
}

void ReaderService::readText(const QByteArray& text, const QString& name) {
  submit({}, [text, name, options = options_](const Monitor& monitor) {
    return understand({{}, name, ProgramText(text)}, options, monitor);
  });
}

void ReaderService::readEdited(const ProgramSource& source) {
  submit(source.path,
         [source, options = options_](const Monitor& monitor) { return understand(source, options, monitor); });
}

void ReaderService::cancel() {
  ++latest_;
  pending_ = nullptr;
  worker_.cancel();
}

void ReaderService::submit(const QString& path, Read read_it) {
  const auto fail = [this, path, number = ++latest_](const Error& error) {
    if (number == latest_) emit failed(error, path);
  };
  const auto task = [this, fail, number = latest_, read_it = std::move(read_it)](const Monitor& monitor) {
    auto found = read_it(monitor);
    return [this, fail, number, found = std::move(found)] {
      if (!found) return fail(found.error());
      if (number == latest_) emit read(found->document, found->stamp);
    };
  };
  const auto start = [this, task, fail] { worker_.start(task, fail); };
  if (worker_.isBusy()) {
    pending_ = start;
    worker_.cancel();
    return;
  }
  start();
  emit busyChanged(true);
}

}  // namespace toolpace::ui
