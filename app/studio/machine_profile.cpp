#include "machine_profile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "toolpace/io/output_file.h"
#include "toolpace/machine/read_machine.h"

namespace toolpace::studio {

std::vector<BuiltInMachine> built_in_machines() {
  std::vector<BuiltInMachine> machines;
  for (const QFileInfo& info : QDir(":/machines").entryInfoList({"*.toml"}, QDir::Files, QDir::Name)) {
    machines.push_back({info.filePath(), info.completeBaseName()});
  }
  return machines;
}

Result<Setup> load_machine(const QString& path) {
  if (!path.startsWith(":/")) return read_machine(path.toStdString());
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    return tl::unexpected(Error{ErrorKind::io, "cannot-open", file.errorString().toStdString(), {}, {}, {}});
  }
  return parse_setup(file.readAll().toStdString(), path.toStdString());
}

Result<void> store_machine(const QString& path, const Setup& setup) {
  const std::string name = path.toStdString();
  auto text = format_setup(setup);
  if (const auto old = QFileInfo::exists(path) ? read_settings_text(name) : std::string(); old && !old->empty()) {
    // What is no machine is replaced, since a person chose to.
    if (auto edited = edit_setup(*old, name, setup)) text = std::move(edited);
  }
  if (!text) return tl::unexpected(text.error());
  return write_whole_file(name, *text);
}

}  // namespace toolpace::studio
