#pragma once
/// The plan on paper.

#include <vector>

#include "report.h"
#include "theme/picture_file.h"

class QPrinter;

namespace toolpace::studio {

/// The report's figures and settings on as many pages as they take, then a page for each drawing, as large as fits. False:
/// the printer cannot be written to.
bool print_pages(QPrinter& printer, const ReportParts& parts, const std::vector<ui::Drawing>& drawings);

}  // namespace toolpace::studio
