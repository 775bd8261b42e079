#pragma once
/// The parts of an NC line that are drawn differently.

#include <QString>
#include <vector>

namespace toolpace::ui {

enum class NcSpanKind { code, quiet };  ///< quiet: comments, line numbers, block delete and percent signs

struct NcSpan {
  qsizetype begin, length;
  NcSpanKind kind;
};

/// Consecutive spans that cover the line.
std::vector<NcSpan> nc_spans(const QString& line);

}  // namespace toolpace::ui
