#pragma once
/// The whole window with a program in it, for tests that drive it as a person would.

#include <QTest>

#include "main_window.h"
#include "screenshot.h"
#include "support/find.h"
#include "support/patience.h"

namespace toolpace::ui {

class Opened : public studio::MainWindow {
 public:
  explicit Opened(const QSize& size = {1280, 800}) : MainWindow(false) {
    setLanguage("en");
    resize(size);
    show();
  }
  void open(const QByteArray& text, const QString& name = "program.ngc") {
    workspace().openText(text, name);
    studio::settle(*this);
  }
  void openButterfly() {
    openExample();
    studio::settle(*this);
  }
  /// Until the setpoints are proven and the drives simulated.
  void waitForProof() { studio::settle_with_proof(*this); }
  template <class T>
  T& the(const char* name) {
    return ui::find<T>(*this, name);
  }
};

}  // namespace toolpace::ui
