#pragma once
/// The handbook, as the window opens it.

#include <QString>

namespace toolpace::studio {

/// The page with which the handbook begins for a language ("en", "zh_CN"): of an installation, or of the checkout in which the
/// program was built. Empty where there is none.
/// @param program_folder  in which the program lies
QString handbook_page(const QString& program_folder, const QString& language);

}  // namespace toolpace::studio
