#pragma once
/// Pictures of views as files.

#include <QImage>
#include <QSize>
#include <QString>
#include <functional>

class QPainter;

namespace toolpace::ui {

/// Writes .svg and .pdf by what paints vectors, anything else as the PNG that `pixels` gives. The file appears whole or
/// not at all. False if it cannot be written.
/// @param size  logical pixels, at 96 a inch
bool save_picture(const QString& file, const QSize& size, const std::function<void(QPainter&)>& vectors,
                  const std::function<QImage()>& pixels);

}  // namespace toolpace::ui
