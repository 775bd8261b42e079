#pragma once
/// Icons in the colour of the theme.

#include <QIcon>
#include <QString>

#include "theme/theme.h"

namespace toolpace::ui {

/// The icon `:/icons/<name>.svg`, drawn in `tokens.text` (disabled: faint; checked: accent), sharp at every scale.
QIcon icon(const QString& name, const Theme& tokens);

}  // namespace toolpace::ui
