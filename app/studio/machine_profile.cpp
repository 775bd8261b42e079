#include "machine_profile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "toolpace/io/output_file.h"

namespace toolpace::studio {

std::vector<BuiltInMachine> built_in_machines() {
  std::vector<BuiltInMachine> machines;
  for (const QFileInfo& info : QDir(":/machines").entryInfoList({"*.toml"}, QDir::Files, QDir::Name)) {
    machines.push_back({info.filePath(), info.completeBaseName()});
  }
  return machines;
}

Result<Setup> load_machine(const QString& path) {
  if (!path.startsWith(":/")) return read_setup(path.toStdString());
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    return tl::unexpected(Error{ErrorKind::io, "cannot-open", file.errorString().toStdString(), {}, {}, {}});
  }
  return parse_setup(file.readAll().toStdString(), path.toStdString());
}

Result<void> store_machine(const QString& path, const Setup& setup) {
  return write_whole_file(path.toStdString(), format_setup(setup));
}

}  // namespace toolpace::studio
