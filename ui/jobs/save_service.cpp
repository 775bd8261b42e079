#include "jobs/save_service.h"

#include <algorithm>

#include "toolpace/io/output_file.h"

namespace toolpace::ui {
namespace {

constexpr std::size_t kPieceWritten = std::size_t{1} << 22;  // bytes between two looks at the monitor

Result<void> write_text(const ProgramText& text, const QString& path, const Monitor& monitor) {
  auto file = OutputFile::create(path.toStdString());
  if (!file) return tl::unexpected(file.error());
  Result<void> done;
  text.for_each_piece([&](std::string_view bytes) {
    for (; done && !bytes.empty(); bytes.remove_prefix(std::min(kPieceWritten, bytes.size()))) {
      done = monitor.is_cancelled() ? Result<void>(tl::unexpected(cancelled_error()))
                                    : file->write(bytes.substr(0, kPieceWritten));
    }
    return done.has_value();
  });
  return done ? file->commit() : done;
}

}  // namespace

SaveService::SaveService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::finished, this, [this] { emit busyChanged(false); });
}

void SaveService::start(const ProgramText& text, quint64 state, const QString& path) {
  const auto write = [this, text, state, path](const Monitor& monitor) {
    const auto written = write_text(text, path, monitor);
    return [this, written, state, path, stamp = stamp_of(path)] {
      if (written) {
        emit saved(path, state, stamp);
      } else {
        emit failed(written.error(), path);
      }
    };
  };
  worker_.start(write, [this, path](const Error& error) { emit failed(error, path); });
  emit busyChanged(true);
}

}  // namespace toolpace::ui
