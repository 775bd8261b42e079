#pragma once
/// The settings of the controller that is chosen, by its own names, to be edited in the tuning panel.

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <string>
#include <vector>

#include "models/controller_model.h"
#include "panels/number_field.h"

namespace toolpace::ui {

/// Hidden while the program runs on Toolpace's own plan.
class ControllerSection : public QWidget {
  Q_OBJECT

 public:
  explicit ControllerSection(ControllerModel& model, QWidget* parent = nullptr);

  void setModified(bool modified);  ///< the file does not say the same

 signals:
  void saveRequested();
  void refused(const toolpace::Error& error);  ///< a value that the text cannot hold
  void resized();                              ///< has other rows than before

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Row {
    std::string key;
    QLabel *label, *unit;
    NumberField* field;
  };
  void showSettings();
  void rebuild(const std::vector<ControllerParameter>& shown);
  void addHeading(const QString& text);
  void addRow(const ControllerParameter& parameter);
  void edit(const std::string& key, double value);
  void retranslate();

  ControllerModel& model_;
  QLabel* title_;
  QToolButton* save_;
  QWidget* body_ = nullptr;
  QGridLayout* grid_ = nullptr;
  std::vector<Row> rows_;
  bool modified_ = false;
};

}  // namespace toolpace::ui
