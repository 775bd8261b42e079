#pragma once
/// A page that tells the plan to others: figures, pictures, proof and parameters.

#include <QString>

#include "drawing/planned.h"
#include "models/units.h"

namespace toolpace::studio {

struct ReportParts {
  ui::Planned plan, pinned;
  QString program, machine;
  QByteArray contour_png, plots_png;
  ui::Units unit;
};

/// One HTML page with its pictures inside, in the language of the window. Precondition: there is a plan.
QString report_html(const ReportParts& parts);

/// The same on pages of A4.
QByteArray report_pdf(const ReportParts& parts);

}  // namespace toolpace::studio
