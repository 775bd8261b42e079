#include "panels/tuning_panel.h"

#include <QEvent>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "models/law_names.h"
#include "models/option_names.h"
#include "models/parameter_tips.h"
#include "panels/key_range.h"

namespace toolpace::ui {
namespace {

const DisplayUnit kMilliseconds = {1e3, "ms"};
const DisplayUnit kPercent = {100.0, "%"};
enum Row {
  kLawRow,
  kTimeRow,
  kAccelerationRow,
  kJerkRow,
  kSpeedRow,
  kLookaheadRow,
  kRampsRow,
  kCornerRow,
  kToleranceRow,
  kOverrideRow
};

void select(QComboBox* box, int data) {
  const QSignalBlocker quiet(box);
  box->setCurrentIndex(box->findData(data));
}

QComboBox* combo(const char* name, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  return box;
}

}  // namespace

TuningPanel::TuningPanel(TuningModel& model, QWidget* parent) : QScrollArea(parent), model_(model) {
  setObjectName("tuningPanel");
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* body = new QWidget(this);
  body->setProperty("role", "surface");
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(8, 4, 8, 2);
  column->setSpacing(4);
  form_ = new FormGrid(body);
  column->addWidget(form_);
  buildLaw();
  buildLimits();
  buildCorner();
  buildJob();
  program_note_ = secondary_label({}, body);
  program_note_->setObjectName("programTolerance");
  program_note_->setWordWrap(true);
  column->addWidget(program_note_);
  auto* rule = new QFrame(body);
  rule->setProperty("role", "line");
  column->addWidget(rule);
  axes_ = new AxesGrid(body);
  column->addWidget(axes_);
  column->addStretch(1);
  setWidget(body);

  connect(axes_, &AxesGrid::gestureStarted, &model_, &TuningModel::beginGesture);
  connect(axes_, &AxesGrid::gestureFinished, &model_, &TuningModel::endGesture);
  connect(axes_, &AxesGrid::edited, this, [this](int axis, int limit, double value) {
    const QString key = QString("axis%1.%2").arg(axis).arg(limit);
    model_.edit(tr("Axis limit"), key, [=](Tuning& tuning) {
      auto& limits = tuning.machine.axes[static_cast<std::size_t>(axis)];
      (limit == AxesGrid::kSpeed          ? limits.speed
       : limit == AxesGrid::kAcceleration ? limits.acceleration
                                          : limits.jerk) = value;
    });
  });
  connect(&model_, &TuningModel::changed, this, &TuningPanel::showValues);
  retranslate();
  showValues();
}

NumberField* TuningPanel::addNumber(const char* name, int row, int side, Quantity quantity, NumberField::Range range) {
  last_ = new NumberField(name, {}, quantity, range, form_);
  last_label_ = form_->add(row, side, last_);
  connectGestures(last_);
  return last_;
}

void TuningPanel::describe(std::function<double(const Tuning&)> read, std::function<void(Tuning&, double)> write,
                           std::function<QString()> title, std::function<QString()> symbol) {
  const std::size_t index = entries_.size();
  entries_.push_back({last_, last_label_, std::move(read), std::move(write), std::move(title), std::move(symbol)});
  connect(last_, &NumberField::edited, this, [this, index](double value) {
    const Entry& entry = entries_[index];
    model_.edit(entry.title(), entry.field->objectName(), [&](Tuning& tuning) { entry.write(tuning, value); });
  });
}

void TuningPanel::connectGestures(NumberField* field) {
  connect(field, &NumberField::gestureStarted, &model_, &TuningModel::beginGesture);
  connect(field, &NumberField::gestureFinished, &model_, &TuningModel::endGesture);
}

void TuningPanel::buildLaw() {
  law_ = combo("lawBox", form_);
  law_label_ = form_->addWide(kLawRow, law_);
  for (const LawRow& row : law_table()) law_->addItem({}, static_cast<int>(row.kind));
  connect(law_, &QComboBox::activated, this, [this](int index) {
    const auto kind = static_cast<LawKind>(law_->itemData(index).toInt());
    model_.edit(tr("Law"), "law", [kind](Tuning& tuning) { tuning.options.law = kind; });
  });
  t_acc_ = addNumber("taccEdit", kTimeRow, 0, Quantity::time, range_of_key("law", "tacc_ms"));
  t_acc_->setUnit(kMilliseconds);
  describe([](const Tuning& t) { return t.options.t_acc; }, [](Tuning& t, double v) { t.options.t_acc = v; },
           [] { return tr("Acceleration time"); }, [] { return QString("Tacc"); });
  t_dec_ = addNumber("tdecEdit", kTimeRow, 1, Quantity::time, range_of_key("law", "tdec_ms"));
  t_dec_->setUnit(kMilliseconds);
  describe([](const Tuning& t) { return t.options.t_dec; }, [](Tuning& t, double v) { t.options.t_dec = v; },
           [] { return tr("Deceleration time"); }, [] { return QString("Tdec"); });
}

void TuningPanel::buildLimits() {
  addNumber("amEdit", kAccelerationRow, 0, Quantity::acceleration, range_of_key("path", "max_acceleration_mm_s2"));
  describe([](const Tuning& t) { return t.machine.path.acceleration; },
           [](Tuning& t, double v) { t.machine.path.acceleration = v; },
           [] { return tr("Acceleration along the path"); }, [] { return QString("Am"); });
  addNumber("dmEdit", kAccelerationRow, 1, Quantity::acceleration, range_of_key("path", "max_deceleration_mm_s2"));
  describe([](const Tuning& t) { return t.machine.path.deceleration; },
           [](Tuning& t, double v) { t.machine.path.deceleration = v; },
           [] { return tr("Deceleration along the path"); }, [] { return QString("Dm"); });
  jerk_ = addNumber("jmEdit", kJerkRow, 0, Quantity::jerk, range_of_key("path", "max_jerk_mm_s3"));
  describe([](const Tuning& t) { return t.machine.path.jerk; }, [](Tuning& t, double v) { t.machine.path.jerk = v; },
           [] { return tr("Jerk along the path, speeding up"); }, [] { return QString("Jm"); });
  jerk_deceleration_ =
      addNumber("jdEdit", kJerkRow, 1, Quantity::jerk, range_of_key("path", "max_jerk_deceleration_mm_s3"));
  describe([](const Tuning& t) { return t.machine.path.jerk_deceleration; },
           [](Tuning& t, double v) { t.machine.path.jerk_deceleration = v; },
           [] { return tr("Jerk along the path, slowing down"); }, [] { return QString("Jd"); });
  addNumber("vmaxEdit", kSpeedRow, 0, Quantity::speed, range_of_key("path", "max_speed_mm_s"));
  describe([](const Tuning& t) { return t.machine.path.speed; }, [](Tuning& t, double v) { t.machine.path.speed = v; },
           [] { return tr("Top speed along the path"); }, [] { return QString("Vmax"); });
  addNumber("periodEdit", kSpeedRow, 1, Quantity::time, range_of_key("machine", "period_ms"))->setUnit(kMilliseconds);
  describe([](const Tuning& t) { return t.machine.period; }, [](Tuning& t, double v) { t.machine.period = v; },
           [] { return tr("Interpolation period"); }, [] { return QString("Ts"); });
}

void TuningPanel::buildCorner() {
  lookahead_ = new LookaheadField(form_);
  lookahead_label_ = form_->addWide(kLookaheadRow, lookahead_);
  connect(lookahead_, &LookaheadField::gestureStarted, &model_, &TuningModel::beginGesture);
  connect(lookahead_, &LookaheadField::gestureFinished, &model_, &TuningModel::endGesture);
  connect(lookahead_, &LookaheadField::edited, this, [this](std::optional<std::size_t> depth) {
    model_.edit(tr("Look-ahead"), "lookahead", [depth](Tuning& tuning) { tuning.options.lookahead = depth; });
  });
  ramps_ = combo("rampsBox", form_);
  ramps_label_ = form_->addWide(kRampsRow, ramps_);
  for (auto ramps : {Ramps::block, Ramps::span}) ramps_->addItem({}, static_cast<int>(ramps));
  connect(ramps_, &QComboBox::activated, this, [this](int index) {
    const auto ramps = static_cast<Ramps>(ramps_->itemData(index).toInt());
    model_.edit(tr("Ramps"), "ramps", [ramps](Tuning& tuning) { tuning.options.ramps = ramps; });
  });
  corner_ = combo("cornerBox", form_);
  corner_label_ = form_->addWide(kCornerRow, corner_);
  for (auto rule : {CornerRule::stop, CornerRule::servo, CornerRule::junction, CornerRule::blend, CornerRule::smooth}) {
    corner_->addItem({}, static_cast<int>(rule));
  }
  connect(corner_, &QComboBox::activated, this, [this](int index) {
    const auto rule = static_cast<CornerRule>(corner_->itemData(index).toInt());
    model_.edit(tr("Corner rule"), "corner", [rule](Tuning& tuning) {
      tuning.options.corner.rule = rule;
      tuning.options.corner.step.reset();
    });
  });
}

void TuningPanel::buildJob() {
  NumberField::Range hold = range_of_key("", "hold_at_s");
  hold.may_be_unlimited = true;  // no hold
  addNumber("holdEdit", kToleranceRow, 0, Quantity::time, hold)->setUnlimitedText("–");
  describe([](const Tuning& t) { return t.options.hold_at.value_or(kUnlimited); },
           [](Tuning& t, double v) { t.options.hold_at = v < kUnlimited ? std::optional(v) : std::nullopt; },
           [] { return tr("Feed hold at; empty = none"); }, [] { return tr("Hold"); });
  tolerance_ =
      addNumber("toleranceEdit", kToleranceRow, 1, Quantity::length, range_of_key("lookahead", "tolerance_mm"));
  describe([](const Tuning& t) { return t.options.corner.tolerance; },
           [](Tuning& t, double v) { t.options.corner.tolerance = v; },
           [] { return tr("Tolerance of rounded corners"); }, [] { return tr("Toler."); });
  deviation_ = addNumber("deviationEdit", kToleranceRow, 1, Quantity::length,
                         range_of_key("lookahead", "junction_deviation_mm"));
  describe([](const Tuning& t) { return t.options.corner.junction_deviation; },
           [](Tuning& t, double v) { t.options.corner.junction_deviation = v; },
           [] { return tr("Junction deviation"); }, [] { return QString("δ"); });
  addNumber("feedOverrideEdit", kOverrideRow, 0, Quantity::time, range_of_key("", "override_percent"))
      ->setUnit(kPercent);
  describe([](const Tuning& t) { return t.options.feed_override; },
           [](Tuning& t, double v) { t.options.feed_override = v; }, [] { return tr("Feed override"); },
           [] { return tr("Feed"); });
  addNumber("rapidOverrideEdit", kOverrideRow, 1, Quantity::time, range_of_key("", "rapid_percent"))->setUnit(kPercent);
  describe([](const Tuning& t) { return t.options.rapid_override; },
           [](Tuning& t, double v) { t.options.rapid_override = v; }, [] { return tr("Rapid override"); },
           [] { return tr("Rapid"); });
}

void TuningPanel::setUnits(Units unit) {
  for (auto& entry : entries_) entry.field->setUnits(unit);
  axes_->setUnits(unit);
  units_ = unit;
  showProgramTolerance();
}

void TuningPanel::showPlans(const Planned& plan, const Planned&) {
  if (!plan) return;
  const Outcome& outcome = *plan.timeline->outcome();
  lookahead_->setBlockCount(outcome.summary.blocks);
  ignored_ = outcome.ignored;
  ignored_rule_ = outcome.job->options.corner.rule;
  if (outcome.job->program != program_) program_tolerance_ = tolerances_of((program_ = outcome.job->program)->moves);
  showRelevant();
}

void TuningPanel::setRotaryAxes(const std::array<bool, 3>& turned) {
  turned_ = turned;
  showValues();
}

void TuningPanel::setHead(QWidget* head) { static_cast<QVBoxLayout*>(widget()->layout())->insertWidget(0, head); }

int TuningPanel::wholeHeight() const { return widget()->sizeHint().height() + 2 * frameWidth(); }

QSize TuningPanel::minimumSizeHint() const {
  const int bar = verticalScrollBar()->sizeHint().width();
  return {widget()->minimumSizeHint().width() + bar + 2 * frameWidth(), QScrollArea::minimumSizeHint().height()};
}

bool TuningPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

void TuningPanel::showValues() {
  const Tuning& tuning = model_.value();
  for (auto& entry : entries_) entry.field->setValue(entry.read(tuning));
  select(law_, static_cast<int>(tuning.options.law));
  select(ramps_, static_cast<int>(tuning.options.ramps));
  select(corner_, static_cast<int>(tuning.options.corner.rule));
  lookahead_->setValue(tuning.options.lookahead);
  axes_->setMachine(tuning.machine);
  axes_->setRotaryAxes(rotary_axes(tuning.machine, turned_));
  showRelevant();
}

void TuningPanel::showRelevant() {
  const auto& options = model_.value().options;
  const LawRow& law = law_row(options.law);
  const auto rule = options.corner.rule;
  const auto is_ignored = [&](Setting setting) { return rule == ignored_rule_ && ignored_.has(setting); };
  const bool has_law = !is_ignored(Setting::law);
  const QString useless = tr("This law has no use for it");
  for (auto* field : {t_acc_, t_dec_}) form_->setRowUseless(field, law.uses_time && has_law ? QString() : useless);
  for (auto* field : {jerk_, jerk_deceleration_})
    form_->setRowUseless(field, law.bounds_jerk || !has_law ? QString() : useless);
  const auto enable = [&](QWidget* field, QLabel* label, Setting setting) {
    const QString reason = is_ignored(setting) ? tr("The motion through the tolerance has no use for it") : QString();
    for (QWidget* widget : {field, static_cast<QWidget*>(label)}) {
      widget->setEnabled(reason.isEmpty());
      widget->setToolTip(reason.isEmpty() ? parameter_tip(field->objectName()) : reason);
    }
  };
  for (QWidget* widget : {static_cast<QWidget*>(corner_), static_cast<QWidget*>(corner_label_)}) {
    widget->setToolTip(parameter_tip(corner_->objectName()));
  }
  enable(law_, law_label_, Setting::law);
  enable(ramps_, ramps_label_, Setting::ramps);
  enable(lookahead_, lookahead_label_, Setting::lookahead);
  form_->setRowVisible(tolerance_, rule == CornerRule::blend || rule == CornerRule::smooth);
  form_->setRowVisible(deviation_, rule == CornerRule::junction);
  showProgramTolerance();
}

/// Where the program names a tolerance, it comes before the one of the field.
void TuningPanel::showProgramTolerance() {
  const ProgramTolerance& p = program_tolerance_;
  program_note_->setVisible(p.blocks > 0);
  if (p.blocks == 0) return tolerance_->setEnabled(true);
  const auto text = [this](double mm) { return value_text(mm, Quantity::length, units_, 4); };
  const QString values = p.least < p.most ? text(p.least) + " … " + text(p.most) : text(p.most);
  program_note_->setText(p.blocks == p.all ? tr("G64 P of the program rules: %1").arg(values)
                                           : tr("G64 P of the program rules in %1 of %2 blocks: %3")
                                                 .arg(number_text(static_cast<double>(p.blocks), 9),
                                                      number_text(static_cast<double>(p.all), 9), values));
  program_note_->setToolTip(tr("The tolerance of the job holds where the program names none"));
  const QString useless = tr("G64 P of the program rules in every block");
  form_->setRowUseless(tolerance_, p.blocks == p.all ? useless : QString());
}

void TuningPanel::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  if (!hasFocus() && !isAncestorOf(focusWidget())) verticalScrollBar()->setValue(0);
}

void TuningPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QScrollArea::changeEvent(event);
}

void TuningPanel::retranslate() {
  setAccessibleName(tr("Tuning"));
  law_label_->setText(tr("Law"));
  law_->setAccessibleName(tr("Velocity law"));
  for (const LawRow& row : law_table()) law_->setItemText(law_->findData(static_cast<int>(row.kind)), law_title(row));
  lookahead_label_->setText(tr("Look-ahead"));
  lookahead_->retranslate();
  ramps_label_->setText(tr("Ramps"));
  ramps_->setAccessibleName(tr("Ramps"));
  for (int i = 0; i < ramps_->count(); ++i) {
    ramps_->setItemText(i, ramps_title(static_cast<Ramps>(ramps_->itemData(i).toInt())));
  }
  corner_label_->setText(tr("Corners"));
  corner_->setAccessibleName(tr("Corner rule"));
  for (int i = 0; i < corner_->count(); ++i) {
    corner_->setItemText(i, corner_title(static_cast<CornerRule>(corner_->itemData(i).toInt())));
  }
  for (auto& entry : entries_) {
    entry.label->setText(entry.symbol ? entry.symbol() : entry.title());
    const QString tip = parameter_tip(entry.field->objectName());
    entry.label->setToolTip(entry.title() + (tip.isEmpty() ? QString() : "\n" + tip));
    entry.field->setAccessibleName(entry.title());
  }
  axes_->retranslate();
  showValues();
}

}  // namespace toolpace::ui
