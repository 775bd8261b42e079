#include "handbook.h"

#include <QDir>
#include <QFileInfo>

namespace toolpace::studio {

QString handbook_page(const QString& program_folder, const QString& language) {
  const QString page = language.startsWith("zh") ? "handbook/machinist-zh.html" : "index.html";
  for (const char* folder : {"../share/doc/toolpace/html", "../../handbook/html"}) {
    const QFileInfo file(QDir(program_folder).filePath(QString(folder) + "/" + page));
    if (file.isFile()) return QDir::cleanPath(file.absoluteFilePath());
  }
  return {};
}

}  // namespace toolpace::studio
