#pragma once
/// Answers to questions that a window asks in a dialog of its own event loop.

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QTest>
#include <QTimer>
#include <functional>
#include <memory>

namespace toolpace::ui {

/// Does something to the next modal dialog as soon as it is there, while it lives.
class NextDialog {
 public:
  explicit NextDialog(std::function<void(QWidget&)> act) {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, act = std::move(act)] {
      auto* const dialog = QApplication::activeModalWidget();
      if (!dialog) return;
      timer_.stop();
      shown_ = dialog->objectName();
      act(*dialog);
    });
    timer_.start(1);
  }
  /// Presses a button of it.
  explicit NextDialog(const char* button)
      : NextDialog([button](QWidget& dialog) {
          auto* const found = dialog.findChild<QAbstractButton*>(button);
          if (!found) qFatal("no button %s in %s", button, qPrintable(dialog.objectName()));
          QTest::mouseClick(found, Qt::LeftButton);
        }) {}

  /// Name of the dialog that was answered; empty while there was none.
  const QString& shown() const { return shown_; }

 private:
  QTimer timer_;
  QString shown_;
};

/// Types a name into the next file dialog and accepts it.
inline NextDialog file_named(const QString& name) {
  return NextDialog([name](QWidget& dialog) {
    auto& files = dynamic_cast<QFileDialog&>(dialog);
    auto* field = files.findChild<QLineEdit*>("fileNameEdit");
    field->setText(name);
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Return);
  });
}

}  // namespace toolpace::ui
