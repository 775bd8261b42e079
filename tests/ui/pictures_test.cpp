/// Pictures as files: whole or not at all, and what is wrong is said.

#include <signal.h>
#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>

#include "opened.h"
#include "support/files.h"
#include "support/ui_test.h"
#include "theme/picture_file.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

Drawing drawing() {
  const QSize size(200, 100);
  return {size,
          [size] {
            QImage image(size, QImage::Format_RGB32);
            for (int y = 0; y < size.height(); ++y) {
              for (int x = 0; x < size.width(); ++x) image.setPixel(x, y, static_cast<uint>(x * 7919 + y * 104729));
            }
            return image;
          },
          [](QPainter& painter) { painter.drawLine(0, 0, 200, 100); }};
}

/// Files cannot grow beyond this, as on a full disk.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit little{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &little);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;
  ~FileLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_ = {};
};

}  // namespace

class PicturesTest : public QObject {
  Q_OBJECT

 private slots:
  void the_extension_chooses_the_format_whatever_its_case() {
    QTemporaryDir folder;
    const std::pair<const char*, QByteArray> formats[] = {
        {"a.PNG", "\x89PNG"}, {"a.Svg", "<?xml"}, {"a.pDF", "%PDF"}, {"none", "\x89PNG"}};
    for (const auto& [name, begin] : formats) {
      QVERIFY(save_picture(folder.filePath(name), drawing()));
      QVERIFY2(content(folder.filePath(name)).startsWith(begin), name);
    }
  }

  void an_unknown_extension_is_told_with_the_known_ones() {
    QTemporaryDir folder;
    const auto saved = save_picture(folder.filePath("a.bmp"), drawing());
    QVERIFY(!saved);
    QCOMPARE(saved.error().kind, ErrorKind::usage);
    QCOMPARE(saved.error().code, std::string("picture-format-unknown"));
    QCOMPARE(saved.error().remedy, std::string("use one of .png, .svg, .pdf"));
    const auto pixels_alone = save_picture(folder.filePath("a.svg"), {drawing().size, drawing().pixels});
    QVERIFY(!pixels_alone);
    QCOMPARE(pixels_alone.error().remedy, std::string("use one of .png"));
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void a_file_that_cannot_be_written_whole_stays_as_it_was() {
    QTemporaryDir folder;
    for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
      const QString path = folder.filePath(name);
      QVERIFY(save_picture(path, drawing()));
      const QByteArray before = content(path);
      {
        const FileLimit limit(100);
        const auto saved = save_picture(path, drawing());
        QVERIFY(!saved);
        QCOMPARE(saved.error().kind, ErrorKind::io);
        QCOMPARE(saved.error().code, std::string("file-too-large"));
      }
      QCOMPARE(content(path), before);
    }
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 3);
  }

  void a_full_device_is_said_with_the_reason() {
    const auto saved = save_picture("/dev/full", drawing());
    QVERIFY(!saved);
    QCOMPARE(saved.error().code, std::string("disk-full"));
    QVERIFY(!saved.error().remedy.empty());
  }

  void the_window_shows_the_writers_own_error() {
    QTemporaryDir folder;
    Opened window;
    window.openButterfly();
    using Picture = studio::MainWindow::Picture;
    for (const auto picture : {Picture::contour, Picture::plots, Picture::window}) {
      const auto saved = window.savePicture(picture, folder.filePath("no/such/folder.png"));
      QVERIFY(!saved);
      QCOMPARE(saved.error().code, std::string("file-not-found"));
      const FileLimit limit(100);
      QCOMPARE(window.savePicture(picture, folder.filePath("a.png")).error().code, std::string("file-too-large"));
    }
    QVERIFY(QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden));
  }
};

TOOLPACE_UI_TEST(PicturesTest)
#include "pictures_test.moc"
