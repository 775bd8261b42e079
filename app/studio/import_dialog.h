#pragma once
/// Shows what of another controller's settings would be taken, before it is.

#include <QDialog>

#include "toolpace/machine/setup.h"

namespace toolpace::studio {

/// Accepted: a person wants this machine.
class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param name  of the file
  ImportDialog(const QString& name, const Setup& setup, QWidget* parent = nullptr);
};

}  // namespace toolpace::studio
