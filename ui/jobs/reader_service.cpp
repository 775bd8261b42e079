#include "jobs/reader_service.h"

#include <QFile>
#include <QFileInfo>

namespace toolpace::ui {
namespace {

using DocumentResult = Result<std::shared_ptr<const Document>>;

DocumentResult make_document(QByteArray text, const QString& name, const QString& path, const Monitor& monitor) {
  auto document = std::make_shared<Document>();
  document->path = path;
  document->name = name;
  document->text = std::move(text);
  document->line_starts = find_line_starts(document->text);
  ReadOptions options;
  if (!path.isEmpty()) options.sub_paths.push_back(QFileInfo(path).absolutePath().toStdString());
  const std::string_view view(document->text.constData(), static_cast<std::size_t>(document->text.size()));
  auto reading = toolpace::read_text(view, name.toStdString(), options, monitor);
  if (!reading) return tl::unexpected(reading.error());
  document->reading = std::make_shared<const Reading>(std::move(*reading));
  document->turned = turned_axes(document->reading->moves);
  return document;
}

/// Its text with another one in a line.
QByteArray with_line(const Document& document, int line, const QString& text) {
  const QByteArray& old = document.text;
  const qsizetype begin = document.line_starts[static_cast<std::size_t>(line - 1)];
  qsizetype end = begin;
  while (end < old.size() && old[end] != '\n' && old[end] != '\r') ++end;
  QByteArray edited = old;
  return edited.replace(begin, end - begin, text.toUtf8());
}

DocumentResult load(const QString& path, const Monitor& monitor) {
  QFile file(path);
  const QFileInfo info(path);
  if (info.isDir() || !file.open(QIODevice::ReadOnly)) {
    const QString why = info.isDir() ? QObject::tr("is a folder") : file.errorString();
    return tl::unexpected(Error{ErrorKind::io,
                                "cannot-open",
                                (path + ": " + why).toStdString(),
                                "check the name and the permissions",
                                {path.toStdString(), 0, 0},
                                {}});
  }
  return make_document(file.readAll(), info.fileName(), path, monitor);
}

}  // namespace

ReaderService::ReaderService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &ReaderService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!pending_) return emit busyChanged(false);
    worker_.start(std::exchange(pending_, nullptr));
  });
}

void ReaderService::readFile(const QString& path) {
  const quint64 number = ++latest_;
  submit([this, path, number](const Monitor& monitor) { return deliver(load(path, monitor), path, number); });
}

void ReaderService::readText(const QByteArray& text, const QString& name, const QString& path) {
  const quint64 number = ++latest_;
  submit([this, text, name, path, number](const Monitor& monitor) {
    return deliver(make_document(text, name, path, monitor), path, number);
  });
}

void ReaderService::readEdited(std::shared_ptr<const Document> document, int line, const QString& text) {
  const quint64 number = ++latest_;
  submit([this, document = std::move(document), line, text, number](const Monitor& monitor) {
    auto edited = make_document(with_line(*document, line, text), document->name, document->path, monitor);
    return deliver(std::move(edited), document->path, number);
  });
}

void ReaderService::cancel() {
  ++latest_;
  pending_ = nullptr;
  worker_.cancel();
}

void ReaderService::submit(Request request) {
  if (worker_.isBusy()) {
    pending_ = std::move(request);
    worker_.cancel();
    return;
  }
  worker_.start(std::move(request));
  emit busyChanged(true);
}

Background::Delivery ReaderService::deliver(DocumentResult result, const QString& path, quint64 number) {
  return [this, result = std::move(result), path, number] {
    if (number != latest_) return;
    if (result) {
      emit read(*result);
    } else {
      emit failed(result.error(), path);
    }
  };
}

}  // namespace toolpace::ui
