#include "application.h"

#include "memory_policy.h"

namespace toolpace::bench {

QApplication& application() {
  static int argument_count = 1;
  static char name[] = "ui_bench";
  static char* arguments[] = {name, nullptr};
  static QApplication* app = nullptr;
  if (app == nullptr) {
    studio::keep_memory_between_plans();
    app = new QApplication(argument_count, arguments);
  }
  return *app;
}

}  // namespace toolpace::bench
