#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "models/diagnostic_codes.h"

namespace {

const QString kSource = TOOLPACE_SOURCE_DIR;
const QString kMessages = kSource + "/resources/translations/toolpace_zh_CN.ts";

QString text_of(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) qFatal("cannot read %s", qPrintable(path));
  return QString::fromUtf8(file.readAll());
}

/// Source texts of messages that nobody has translated.
QStringList unfinished(const QString& messages) {
  static const QRegularExpression message("<source>(.*?)</source>(.*?)</message>",
                                          QRegularExpression::DotMatchesEverythingOption);
  QStringList texts;
  for (auto found = message.globalMatch(messages); found.hasNext();) {
    const auto match = found.next();
    if (match.captured(2).contains("unfinished") || !match.captured(2).contains("<translation"))
      texts << match.captured(1);
  }
  return texts;
}

}  // namespace

class TranslationTest : public QObject {
  Q_OBJECT

 private slots:
  void every_text_of_the_window_is_in_the_messages_and_translated() {
    QVERIFY(unfinished(text_of(kMessages)).isEmpty());
    // What the sources say today, put beside what has been translated.
    QTemporaryDir folder;
    const QString fresh = folder.filePath("fresh.ts");
    QVERIFY(QFile::copy(kMessages, fresh));
    QProcess update;
    update.start(TOOLPACE_LUPDATE, {"-silent", "-disable-heuristic", "sametext", "-disable-heuristic", "similartext",
                                    kSource + "/ui", kSource + "/app/studio", "-ts", fresh});
    QVERIFY2(update.waitForFinished(60000) && update.exitCode() == 0, update.readAllStandardError().constData());
    const QStringList missing = unfinished(text_of(fresh));
    QVERIFY2(missing.isEmpty(), qPrintable("not translated: " + missing.join(" | ")));
  }

  void errors_of_the_core_have_words_in_every_language() {
    static const QRegularExpression error(
        "(?:ErrorKind::[a-z_]+,|Severity::[a-z]+,|\\b(?:fail|warn)\\(|input_error\\([a-z_]+,)\\s*\"([a-z0-9-]+)\"");
    const auto known = toolpace::ui::diagnostic_codes();
    QStringList missing;
    for (QDirIterator files(kSource + "/core/toolpace", {"*.cpp", "*.h"}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext();) {
      for (auto found = error.globalMatch(text_of(files.next())); found.hasNext();) {
        const QString code = found.next().captured(1);
        if (std::none_of(known.begin(), known.end(), [&](const char* k) { return code == QLatin1String(k); }))
          missing << code;
      }
    }
    missing.removeDuplicates();
    QVERIFY2(missing.isEmpty(), qPrintable("without words: " + missing.join(' ')));
  }
};

QTEST_APPLESS_MAIN(TranslationTest)
#include "translation_test.moc"
