#pragma once
/// One program holds all tests of the window: linking Qt and the core for each would take longer than running it.

#include <QObject>
#include <memory>

namespace toolpace::ui {

using MakeTest = std::unique_ptr<QObject> (*)();

/// Makes a test class known to the program under its name. @return true
bool add_ui_test(const char* name, MakeTest make);

}  // namespace toolpace::ui

/// Stands below a test class, which `ui_tests CLASS [ARGUMENTS OF QTEST…]` runs.
#define TOOLPACE_UI_TEST(Class)                 \
  [[maybe_unused]] static const bool k##Class = \
      toolpace::ui::add_ui_test(#Class, [] { return std::unique_ptr<QObject>(std::make_unique<Class>()); });
