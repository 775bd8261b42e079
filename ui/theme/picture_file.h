#pragma once
/// Pictures of views as files.

#include <QImage>
#include <QSize>
#include <QString>
#include <functional>

#include "toolpace/base/result.h"

class QPainter;

namespace toolpace::ui {

/// At which logical pixels and points are of one scale.
inline constexpr int kDotsPerInch = 96;

/// How a view is drawn into a file.
struct Drawing {
  QSize size;                                   ///< logical pixels, at 96 a inch
  std::function<QImage()> pixels;               ///< for .png
  std::function<void(QPainter&)> vectors = {};  ///< for .svg and .pdf; none: the view knows pixels alone
};

/// Errors (usage): "picture-format-unknown" where the extension is none that such a drawing can have. Upper and lower case are
/// the same; none at all is a PNG.
Result<void> check_picture_name(const QString& file, bool has_vectors);

/// Writes the drawing; the file appears whole or not at all. Errors: those of check_picture_name and of OutputFile, and
/// "out-of-memory".
Result<void> save_picture(const QString& file, const Drawing& drawing);

}  // namespace toolpace::ui
