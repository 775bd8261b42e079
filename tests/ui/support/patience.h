#pragma once
/// Waiting for what must come, however much else the machine has to do.

#include <QSignalSpy>
#include <QTest>

namespace toolpace::ui {

/// After this a test says that something never came [ms].
inline constexpr int kPatience = 240'000;

/// Runs the event loop until the condition holds; false where it never does.
template <class Condition>
bool eventually(const Condition& condition) {
  return QTest::qWaitFor(condition, kPatience);
}

/// Until the signal has come, which it may have by now; false where it never does.
inline bool eventually(QSignalSpy& signal) { return signal.count() > 0 || signal.wait(kPatience); }

}  // namespace toolpace::ui
