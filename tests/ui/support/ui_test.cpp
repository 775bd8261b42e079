#include "support/ui_test.h"

#include <QApplication>
#include <QTest>
#include <cstdio>
#include <map>
#include <string>

namespace toolpace::ui {
namespace {

std::map<std::string, MakeTest>& tests() {
  static std::map<std::string, MakeTest> all;
  return all;
}

}  // namespace

bool add_ui_test(const char* name, MakeTest make) { return tests().emplace(name, make).second; }

}  // namespace toolpace::ui

int main(int argc, char** argv) {
  const auto& all = toolpace::ui::tests();
  const auto chosen = argc > 1 ? all.find(argv[1]) : all.end();
  if (chosen == all.end()) {
    std::fprintf(stderr, "usage: ui_tests CLASS [ARGUMENTS OF QTEST…], with one of these classes:\n");
    for (const auto& [name, make] : all) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  argv[1] = argv[0];
  --argc, ++argv;
  QApplication application(argc, argv);
  application.setAttribute(Qt::AA_Use96Dpi, true);  // as QTEST_MAIN does
  return QTest::qExec(chosen->second().get(), argc, argv);
}
