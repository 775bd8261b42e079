#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileDialog>
#include <QLibraryInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <algorithm>

#include "main_window.h"
#include "models/diagnostic_codes.h"
#include "models/remedy_text.h"
#include "places.h"
#include "support/ui_test.h"

namespace {

const QString kSource = QString::fromStdString(toolpace::test::source_dir().string());
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

/// The arguments from a place inside a call or an initialiser on, strings joined as a compiler joins them.
QStringList arguments_from(const QString& text, qsizetype at) {
  QStringList found = {QString()};
  bool in_string = false;
  for (int depth = 0; at < text.size(); ++at) {
    const QChar c = text[at];
    if (in_string) {
      in_string = c != '"' || text[at - 1] == '\\';
    } else if (c == '"') {
      in_string = true;
    } else if (QString("([{").contains(c)) {
      ++depth;
    } else if (QString(")]};").contains(c)) {
      if (--depth < 0) break;
    } else if (c == ',' && depth == 0) {
      found << QString();
      continue;
    }
    found.last() += c;
  }
  static const QRegularExpression joint("\"\\s+\"");
  for (QString& argument : found) argument = argument.trimmed().remove(joint);
  return found;
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
        "(?:ErrorKind::[a-z_]+,|Severity::[a-z]+,|\\b(?:fail|warn)\\(|input_error\\([a-z_]+,)\\s*\"([a-z0-9.-]+)\"");
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

  // A remedy is the second argument behind a code; a flag there goes into a sentence.
  void remedies_of_the_core_have_words_in_every_language() {
    QSet<QString> known;
    for (const char* sentence : toolpace::ui::remedy_sentences()) known << QString::fromUtf8(sentence);
    static const QRegularExpression literal("^\"(?!--)([^\"]+)\"$");
    QStringList missing;
    int seen = 0;
    for (QDirIterator files(kSource + "/core/toolpace", {"*.cpp", "*.h"}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext();) {
      const QString text = text_of(files.next());
      for (const char* code : toolpace::ui::diagnostic_codes()) {
        const QString quoted = '"' + QString(code) + '"';
        for (qsizetype at = text.indexOf(quoted); at >= 0; at = text.indexOf(quoted, at + 1)) {
          const auto remedy = literal.match(arguments_from(text, at).value(2));
          if (!remedy.hasMatch()) continue;
          ++seen;
          if (!known.contains(remedy.captured(1))) missing << remedy.captured(1);
        }
      }
    }
    QVERIFY2(seen > 150, qPrintable(QString::number(seen)));
    QVERIFY2(missing.isEmpty(), qPrintable("without words: " + missing.join(" | ")));
  }

  void remedies_are_said_with_what_varies_in_them() {
    using toolpace::ui::remedy_text;
    // The window has fields where the command line has flags.
    QCOMPARE(remedy_text("give --am, or an acceleration for each axis that moves"),
             QString("give Am, or an acceleration for each axis that moves"));
    QCOMPARE(remedy_text("choose the dialect with --dialect"), QString("choose the dialect with “Dialect”"));
    QCOMPARE(remedy_text("check that its loops end; --max-blocks raises the bound"),
             QString("check that its loops end; --max-blocks raises the bound"));
    QTranslator translator;
    QVERIFY(translator.load(":/translations/toolpace_zh_CN.qm"));
    QCOMPARE(remedy_text("rows need 3 values"), QString("rows need 3 values"));
    QVERIFY(QCoreApplication::installTranslator(&translator));
    QCOMPARE(remedy_text("rows need 3 values"), QString("每行需要 3 个值"));
    QCOMPARE(remedy_text("did you mean 'speed'?"), QString("是否想写“speed”？"));
    QCOMPARE(remedy_text("write [condition]"), QString("写成 [条件]"));
    QCOMPARE(remedy_text("take an end speed of 3, or a length of at least 0.5"),
             QString("终点速度取 3，或长度至少为 0.5"));
    QCOMPARE(remedy_text("choose the dialect with --dialect"), QString("用 “方言” 选择方言"));
    QCOMPARE(remedy_text("nobody ever said this"), QString("nobody ever said this"));
    QCOMPARE(remedy_text(""), QString());
    QCoreApplication::removeTranslator(&translator);
  }

  // Qt's own dialogs speak the window's language where Qt's catalogues are installed.
  void file_dialogs_are_chinese_too() {
    const QString catalogue = QLibraryInfo::path(QLibraryInfo::TranslationsPath) + "/qtbase_zh_CN.qm";
    if (!QFile::exists(catalogue)) QSKIP("Qt's translations are not installed (Debian: qt6-translations-l10n)");
    toolpace::studio::MainWindow window(false);
    window.setLanguage("zh_CN");
    QCOMPARE(QFileDialog::tr("File &name:"), QString("文件名称(&N)："));
    window.setLanguage("en");
    QCOMPARE(QFileDialog::tr("File &name:"), QString("File &name:"));
  }
};

TOOLPACE_UI_TEST(TranslationTest)
#include "translation_test.moc"
