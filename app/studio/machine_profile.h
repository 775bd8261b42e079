#pragma once
/// The machine file in use: where it came from, and opening, saving and importing.

#include <QString>
#include <QStringList>

#include "toolpace/base/result.h"
#include "toolpace/machine/setup.h"

namespace toolpace::studio {

struct MachineProfile {
  QString path;  ///< empty: built in or never saved
  QString name;  ///< shown to people
};

/// A machine that comes with the program.
struct BuiltInMachine {
  QString path;  ///< in the resources
  QString name;
};
std::vector<BuiltInMachine> built_in_machines();

/// Reads a machine file, also from the resources, or settings of another controller.
Result<Setup> load_machine(const QString& path);

/// Writes the setup as a machine file, whole or not at all; into one that is there only what differs.
Result<void> store_machine(const QString& path, const Setup& setup);

}  // namespace toolpace::studio
