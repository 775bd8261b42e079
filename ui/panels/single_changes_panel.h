#pragma once
/// What helps most: each setting changed alone, with the seconds that it saves and the contour error that it adds.

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <memory>
#include <vector>

#include "jobs/tune_service.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

class SingleChangesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SingleChangesPanel(QWidget* parent = nullptr);

  /// The job whose settings are changed; null = none. What was found for another one stays, but says so.
  void setJob(std::shared_ptr<const Job> job);
  void compute();
  bool isComputing() const { return service_.isRunning(); }
  void setUnits(Units units);
  void setTheme(const Theme& theme);
  void retranslate();

 signals:
  void chosen(std::shared_ptr<const toolpace::Job> job);  ///< somebody wants this change
  void computed();

 private:
  void show(const SingleChanges& found);
  void fill();
  void fillRow(int row, const SingleChange& change);
  void showState();
  void take(int row);

  TuneService service_;
  QLabel *title_, *hint_;
  QPushButton* button_;
  QTableWidget* table_;
  std::shared_ptr<const Job> job_, trying_, tried_;  // what is tried next, now; what was tried
  SingleChanges found_;
  std::vector<std::size_t> rows_;  // changes that are shown
  QString trouble_;
  bool stale_ = false;
  Units units_;
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
