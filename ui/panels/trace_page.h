#pragma once
/// The page "Trace": what a scope recorded beside what was commanded, by axis and by NC line.

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <memory>

#include "drawing/plan_view.h"

namespace toolpace::ui {

class TracePage : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit TracePage(QWidget* parent = nullptr);

  void showTrace(const std::shared_ptr<const MeasuredTrace>& trace) override;
  void setUnits(Units units) override;
  /// A trace is being read or compared.
  void setBusy(bool busy);
  /// Why there is nothing to show.
  void showFailure(const QString& why);

 signals:
  void lineRequested(int line);
  void columnsRequested();  ///< what the columns mean is to be told anew
  void openRequested();
  void closeRequested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showVerdict();
  void fillAxes();
  void fillLines();
  void retranslate();
  QString errorText(double mm) const;

  QLabel* verdict_;
  QPushButton *open_, *columns_, *close_;
  QTableWidget *axes_, *lines_;
  std::shared_ptr<const MeasuredTrace> trace_;
  QString trouble_;
  bool busy_ = false;
  Units units_;
};

}  // namespace toolpace::ui
