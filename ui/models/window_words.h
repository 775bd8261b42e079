#pragma once
/// Messages of the core name flags of the command line; people at the window have fields.

#include <QString>

namespace toolpace::ui {

/// The same sentence with the names of fields in place of flags. Flags that the window has no field for stay.
QString in_words_of_window(QString sentence);

}  // namespace toolpace::ui
