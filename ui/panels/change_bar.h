#pragma once
/// Asks, without getting in the way, whether what stands in the window or what stands in its file shall stay.

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace toolpace::ui {

class ChangeBar : public QWidget {
  Q_OBJECT

 public:
  enum class Reason { reload, changed_outside, machine_changed_outside, settings_changed_outside };

  /// @param name  of the bar, and with TakeFile and KeepMine behind it of its buttons
  explicit ChangeBar(const QString& name, QWidget* parent = nullptr);

  /// Hidden until somebody asks.
  void ask(Reason reason);

 signals:
  void takeFileRequested();
  void keepMineRequested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  Reason reason_ = Reason::reload;
  QLabel* text_;
  QPushButton *take_file_, *keep_mine_;
};

}  // namespace toolpace::ui
