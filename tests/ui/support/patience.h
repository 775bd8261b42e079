#pragma once
/// Waiting for what must come, however much else the machine has to do.

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

namespace toolpace::ui {

/// After this a test says that something never came [ms].
inline constexpr int kPatience = 240'000;

/// Runs the event loop until the condition holds; false where it never does. It looks after each round of events, where QTest
/// sleeps in between, and now and then without any, for what threads, files and other processes do.
template <class Condition>
bool eventually(const Condition& condition) {
  constexpr int kLook = 20;  // ms
  QTimer look;
  look.start(kLook);
  for (const QDeadlineTimer end(kPatience); !condition();) {
    if (end.hasExpired()) return false;
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  return true;
}

/// Until the signal has come, which it may have by now; false where it never does.
inline bool eventually(QSignalSpy& signal) { return signal.count() > 0 || signal.wait(kPatience); }

}  // namespace toolpace::ui

/// QVERIFY of what will hold.
#define TOOLPACE_EVENTUALLY(condition) QVERIFY(toolpace::ui::eventually([&] { return static_cast<bool>(condition); }))
/// QCOMPARE of what will be equal.
#define TOOLPACE_EVENTUALLY_EQUAL(actual, expected)                   \
  do {                                                                \
    toolpace::ui::eventually([&] { return (actual) == (expected); }); \
    QCOMPARE(actual, expected);                                       \
  } while (false)
