#pragma once
/// The page "Reading": how the program is understood, and the files and folders that this takes.

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

#include "panels/number_field.h"
#include "toolpace/nc/read_options.h"

namespace toolpace::ui {

/// Shows options and tells of every change of them; reads nothing itself.
class ReadingPage : public QWidget {
  Q_OBJECT

 public:
  explicit ReadingPage(QWidget* parent = nullptr);

  const ReadOptions& options() const { return options_; }
  void setOptions(const ReadOptions& options);  ///< shows them; emits nothing
  void setUnits(Units unit);
  /// Where dialogs begin to look for files.
  void setFolder(const QString& folder) { folder_ = folder; }
  void chooseTools();
  void chooseParameters();
  void chooseFolder();
  void focusArcTolerance();

 signals:
  void optionsChanged();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// A file that may be none.
  struct FileField {
    QLabel* label;
    QLineEdit* path;
    QToolButton* choose;
    std::filesystem::path* target;  ///< in options_
  };

  void buildFiles(class QGridLayout* grid);
  void buildFolders(QGridLayout* grid);
  FileField makeFile(QGridLayout* grid, int row, const char* name, std::filesystem::path* target);
  void choose(FileField& field, const QString& title);
  void setFile(FileField& field, const QString& path);
  void takeFolders();
  void retranslate();

  ReadOptions options_;
  QString folder_;
  QLabel *dialect_label_, *integers_label_, *arc_label_, *folders_label_;
  QComboBox *dialect_, *integers_;
  NumberField* arc_tolerance_;
  FileField tools_ = {}, parameters_ = {};
  QListWidget* folders_;
  QPushButton *add_folder_, *remove_folder_;
  QCheckBox *block_delete_, *strict_;
};

}  // namespace toolpace::ui
