#include <QComboBox>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "main_window.h"
#include "panels/number_field.h"
#include "screenshot.h"
#include "support/events.h"
#include "support/find.h"
#include "support/patience.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::studio;

class TuningTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> window_;

  template <class T>
  T& the(const char* name) {
    return ui::find<T>(*window_, name);
  }
  const ui::Tuning& tuning() { return window_->workspace().tuning().value(); }
  QUndoStack& undo() { return window_->workspace().tuning().undoStack(); }

  void type(const char* field, const QString& text) {
    auto& edit = the<ui::NumberField>(field);
    edit.setFocus();
    edit.selectAll();
    QTest::keyClicks(&edit, text);
    QTest::keyClick(&edit, Qt::Key_Return);
  }

 private slots:
  void init() {
    window_ = std::make_unique<MainWindow>(false);
    window_->setLanguage("en");
    window_->resize(1280, 800);
    window_->show();
    window_->openExample();
    settle(*window_);
  }
  void cleanup() { window_.reset(); }

  void an_exact_entry_replans_at_once() {
    const double before = window_->workspace().timeline()->duration();
    type("amEdit", "500");
    QCOMPARE(tuning().machine.path.acceleration, 500.0);
    QVERIFY(window_->workspace().isStale());
    settle(*window_);
    QVERIFY(!window_->workspace().isStale());
    QVERIFY(window_->workspace().timeline()->duration() > before);
  }

  void a_wheel_over_a_control_without_the_focus_changes_nothing() {
    window_->setFocus();
    for (const char* name : {"lawBox", "rampsBox", "cornerBox"}) {
      auto& list = the<QComboBox>(name);
      const int before = list.currentIndex();
      for (const int delta : {-120, 120}) ui::wheel(list, list.rect().center(), delta);
      QCOMPARE(list.currentIndex(), before);
    }
    auto& slider = the<QSlider>("lookaheadSlider");
    const int before = slider.value();
    ui::wheel(slider, slider.rect().center(), -120);
    QCOMPARE(slider.value(), before);
    slider.setFocus();
    ui::wheel(slider, slider.rect().center(), -120);
    QVERIFY(slider.value() != before);
  }

  void what_is_no_number_or_out_of_range_is_marked_and_not_taken() {
    type("amEdit", "-5");
    QCOMPARE(tuning().machine.path.acceleration, 3000.0);
    QVERIFY(the<ui::NumberField>("amEdit").property("wrong").toBool());
    type("amEdit", "fast");
    QCOMPARE(tuning().machine.path.acceleration, 3000.0);
    QTest::keyClick(&the<ui::NumberField>("amEdit"), Qt::Key_Escape);
    QCOMPARE(the<ui::NumberField>("amEdit").text(), QString("3000"));
    QVERIFY(!the<ui::NumberField>("amEdit").property("wrong").toBool());
    QVERIFY(!undo().canUndo());
  }

  void an_empty_limit_means_none() {
    type("axisXSpeed", "25");
    QCOMPARE(tuning().machine.axes[0].speed, 25.0);
    type("axisXSpeed", " ");
    QCOMPARE(tuning().machine.axes[0].speed, kUnlimited);
  }

  void times_and_percentages_are_entered_in_their_units() {
    type("periodEdit", "2.5");
    QCOMPARE(tuning().machine.period, 0.0025);
    type("feedOverrideEdit", "150");
    QCOMPARE(tuning().options.feed_override, 1.5);
  }

  void a_decimal_comma_is_understood() {
    type("periodEdit", "0,5");
    QCOMPARE(tuning().machine.period, 0.0005);
  }

  void the_fields_follow_the_law() {
    auto& law = the<QComboBox>("lawBox");
    QVERIFY(!the<QWidget>("taccEdit").isEnabled());
    law.setCurrentIndex(law.findData(static_cast<int>(LawKind::five_phase_time)));
    emit law.activated(law.currentIndex());
    QVERIFY(the<QWidget>("taccEdit").isEnabled());
    QVERIFY(the<QWidget>("tdecEdit").isEnabled());
    law.setCurrentIndex(law.findData(static_cast<int>(LawKind::trapezoid)));
    emit law.activated(law.currentIndex());
    QVERIFY(!the<QWidget>("jmEdit").isEnabled());
    QCOMPARE(tuning().options.law, LawKind::trapezoid);
    settle(*window_);
    ui::screenshot(*window_, "window-trapezoid");
  }

  void what_a_motion_through_the_tolerance_has_no_use_for_is_disabled_and_says_why() {
    auto& corner = the<QComboBox>("cornerBox");
    const auto choose = [&](CornerRule rule) {
      corner.setCurrentIndex(corner.findData(static_cast<int>(rule)));
      emit corner.activated(corner.currentIndex());
      settle(*window_);
    };
    choose(CornerRule::smooth);
    const bool is_through_tube = !window_->workspace().timeline()->outcome()->plan.splines.empty();
    QVERIFY(is_through_tube);
    for (const char* name : {"lawBox", "rampsBox"}) {
      QVERIFY2(!the<QWidget>(name).isEnabled(), name);
      QVERIFY2(the<QWidget>(name).toolTip().contains("has no use for it"), name);
    }
    QVERIFY(!the<QSlider>("lookaheadSlider").isEnabled());
    choose(CornerRule::servo);
    for (const char* name : {"lawBox", "rampsBox"}) {
      QVERIFY2(the<QWidget>(name).isEnabled(), name);
      QVERIFY2(!the<QWidget>(name).toolTip().contains("has no use for it"), name);
    }
    QVERIFY(the<QSlider>("lookaheadSlider").isEnabled());
  }

  void one_drag_of_the_slider_is_one_undo_step() {
    auto& slider = the<QSlider>("lookaheadSlider");
    QCOMPARE(undo().count(), 0);
    emit slider.sliderPressed();
    for (int position = 900; position >= 200; position -= 20) slider.setValue(position);
    emit slider.sliderReleased();
    QCOMPARE(undo().count(), 1);
    QVERIFY(tuning().options.lookahead.has_value());
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!tuning().options.lookahead.has_value());
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(tuning().options.lookahead.has_value());
    settle(*window_);
    QVERIFY(!window_->workspace().isStale());
  }

  void slider_entry_and_all_are_one_value() {
    type("lookaheadEdit", "8");
    QCOMPARE(tuning().options.lookahead, std::optional<std::size_t>(8));
    QVERIFY(!the<QToolButton>("lookaheadAll").isChecked());
    QTest::mouseClick(&the<QToolButton>("lookaheadAll"), Qt::LeftButton);
    QVERIFY(!tuning().options.lookahead);
    QCOMPARE(the<QSlider>("lookaheadSlider").value(), the<QSlider>("lookaheadSlider").maximum());
    QTest::mouseClick(&the<QToolButton>("lookaheadAll"), Qt::LeftButton);
    QCOMPARE(tuning().options.lookahead, std::optional<std::size_t>(8));
  }

  void a_long_drag_shows_pictures_on_the_way() {
    // An edit comes with every turn of the event loop: a planner that began anew with each would never show a plan.
    int shown = 0, edits = 0;
    connect(&window_->workspace(), &ui::Workspace::planChanged, this, [&shown] { ++shown; });
    auto& slider = the<QSlider>("lookaheadSlider");
    emit slider.sliderPressed();
    QTimer hand;
    connect(&hand, &QTimer::timeout, this, [&] { slider.setValue(100 + 2 * (++edits % 400)); });
    hand.start(0);
    QVERIFY(ui::eventually([&] { return shown >= 10; }));
    hand.stop();
    emit slider.sliderReleased();
    settle(*window_);
    QVERIFY(edits >= shown - 1);
    QVERIFY(!window_->workspace().isStale());
    QCOMPARE(undo().count(), 1);
  }

  void of_many_edits_at_once_the_first_and_the_last_are_planned() {
    std::vector<std::optional<std::size_t>> planned;
    connect(&window_->workspace(), &ui::Workspace::planChanged, this,
            [&] { planned.push_back(window_->workspace().timeline()->outcome()->job->options.lookahead); });
    for (std::size_t depth = 1; depth <= 20; ++depth) {
      window_->workspace().tuning().edit("N", "lookahead", [&](ui::Tuning& t) { t.options.lookahead = depth; });
    }
    settle(*window_);
    QCOMPARE(planned, (std::vector<std::optional<std::size_t>>{1, 20}));
  }

  void impossible_parameters_are_a_problem_in_the_list_not_a_dialog() {
    type("vmaxEdit", " ");
    type("amEdit", " ");
    type("dmEdit", " ");
    settle(*window_);
    QVERIFY(!window_->workspace().problems().empty());
    QVERIFY(QApplication::activeModalWidget() == nullptr);
    ui::screenshot(*window_, "window-problem");
  }
};

TOOLPACE_UI_TEST(TuningTest)
#include "tuning_test.moc"
