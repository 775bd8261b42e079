#include "panels/drives_page.h"

#include <QEvent>
#include <QVBoxLayout>

#include "panels/form_grid.h"
#include "panels/key_range.h"

namespace toolpace::ui {
namespace {

struct DriveParameter {
  const char* id;   ///< of the fields
  const char* key;  ///< of machine files; of backlash the beginning, its unit is the axis'
  double ServoAxis::*value;
  const char* unit;
  const char* title;
  const char* tip;
};

constexpr std::array kDriveParameters = {
    DriveParameter{"kv", "kv_1_s", &ServoAxis::position_gain, "1/s",
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Kv"),
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Gain of the position loop: the lag is about v / Kv")},
    DriveParameter{"velocityFeedForward", "velocity_feed_forward", &ServoAxis::velocity_feed_forward, "",
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Velocity feed-forward"),
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage",
                                     "Share of the commanded speed that is passed on: the lag is (1 − kv) v / Kv")},
    DriveParameter{"accelerationFeedForward", "acceleration_feed_forward", &ServoAxis::acceleration_feed_forward, "",
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Acceleration feed-forward"),
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage",
                                     "Share of the drive's lag at constant acceleration that is made up")},
    DriveParameter{"bandwidth", "bandwidth_hz", &ServoAxis::bandwidth, "Hz",
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Bandwidth"),
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Natural frequency of the velocity loop")},
    DriveParameter{"damping", "damping", &ServoAxis::damping, "",
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Damping"),
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Of the velocity loop; 0.7 overshoots hardly at all")},
    DriveParameter{"backlash", "backlash_", &ServoAxis::backlash, nullptr,
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Backlash"),
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Full play between motor and slide")},
    DriveParameter{
        "resonance", "resonance_hz", &ServoAxis::resonance, "Hz",
        QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Resonance"),
        QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "First natural frequency of the slide on its drive; 0 = stiff")},
    DriveParameter{"resonanceDamping", "resonance_damping", &ServoAxis::resonance_damping, "",
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Its damping"),
                   QT_TRANSLATE_NOOP("toolpace::ui::DrivesPage", "Damping of the resonance; 0.05 is usual for steel")}};

NumberField::Range drive_range(const DriveParameter& parameter, std::size_t axis) {
  const std::string key = parameter.unit ? parameter.key : parameter.key + std::string(is_rotary(axis) ? "deg" : "mm");
  return range_of_key(std::string("servo.") + kAxisNames[axis], key);
}

}  // namespace

DrivesPage::DrivesPage(TuningModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      grid_(new QGridLayout),
      errors_(new QLabel(this)),
      calm_(new CalmPanel(model, this)) {
  static_assert(kDriveParameters.size() == kParameters);
  setObjectName("drivesPage");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(8);
  grid_->setHorizontalSpacing(4);
  grid_->setVerticalSpacing(4);
  column->addLayout(grid_);
  errors_->setObjectName("drivesErrors");
  errors_->setWordWrap(true);
  column->addWidget(errors_);
  column->addWidget(calm_, 1);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    heads_[axis] = secondary_label(QString(QLatin1Char(kAxisNames[axis])), this);
    heads_[axis]->setAlignment(Qt::AlignRight);
    grid_->addWidget(heads_[axis], 0, static_cast<int>(axis) + 1);
    grid_->setColumnStretch(static_cast<int>(axis) + 1, 1);
  }
  for (std::size_t i = 0; i < kParameters; ++i) {
    const int row = static_cast<int>(i) + 1;
    titles_[i] = new QLabel(this);
    units_[i] = secondary_label({}, this);
    grid_->addWidget(titles_[i], row, 0);
    grid_->addWidget(units_[i], row, static_cast<int>(kAxisCount) + 1);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      fields_[i][axis] = makeField(i, axis);
      grid_->addWidget(fields_[i][axis], row, static_cast<int>(axis) + 1);
    }
  }
  connect(&model_, &TuningModel::changed, this, &DrivesPage::showValues);
  retranslate();
  setRotaryAxes({});
  showValues();
}

NumberField* DrivesPage::makeField(std::size_t index, std::size_t axis) {
  const DriveParameter& parameter = kDriveParameters[index];
  const QString name = QString("drive%1%2").arg(QLatin1Char(kAxisNames[axis])).arg(parameter.id);
  const Quantity quantity = is_rotary(axis) ? Quantity::angle : Quantity::length;
  auto* field = new NumberField(name, {}, quantity, drive_range(parameter, axis), this);
  if (parameter.unit) field->setUnit({1.0, parameter.unit});
  connect(field, &NumberField::gestureStarted, &model_, &TuningModel::beginGesture);
  connect(field, &NumberField::gestureFinished, &model_, &TuningModel::endGesture);
  connect(field, &NumberField::edited, this, [this, axis, value = parameter.value, name](double now) {
    model_.edit(tr("Drive"), name, [&](Tuning& t) { t.machine.servo[axis].*value = now; });
  });
  return field;
}

void DrivesPage::setRotaryAxes(const std::array<bool, 3>& shown) {
  for (std::size_t i = 0; i < shown.size(); ++i) {
    heads_[3 + i]->setVisible(shown[i]);
    grid_->setColumnStretch(static_cast<int>(3 + i) + 1, shown[i] ? 1 : 0);
    for (auto& row : fields_) row[3 + i]->setVisible(shown[i]);
  }
}

void DrivesPage::showPlans(const Planned& plan, const Planned&) {
  plan_ = plan;
  calm_->setJob(plan ? plan.timeline->outcome()->job : nullptr);
  showErrors();
}

void DrivesPage::setUnits(Units unit) {
  unit_ = unit;
  calm_->setUnits(unit);
  for (auto& row : fields_) {
    for (auto* field : row) field->setUnits(unit);
  }
  retranslate();
}

void DrivesPage::showValues() {
  for (std::size_t i = 0; i < kParameters; ++i) {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
      fields_[i][axis]->setValue(model_.value().machine.servo[axis].*kDriveParameters[i].value);
  }
}

void DrivesPage::showErrors() {
  if (!plan_ || !plan_.proof) return errors_->setText(plan_ ? tr("Contour error: …") : tr("No plan"));
  const DisplayUnit unit = error_unit(unit_);
  const auto text = [&unit](double error) { return number_text(error * unit.factor, 4) + " " + unit.text; };
  errors_->setText(tr("Contour error: %1 cutting, %2 in rapids")
                       .arg(text(plan_.proof->contour.cutting), text(plan_.proof->contour.rapid)));
}

void DrivesPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void DrivesPage::retranslate() {
  setAccessibleName(tr("Drives"));
  calm_->retranslate();
  for (std::size_t i = 0; i < kParameters; ++i) {
    const DriveParameter& parameter = kDriveParameters[i];
    titles_[i]->setText(tr(parameter.title));
    titles_[i]->setToolTip(tr(parameter.tip));
    units_[i]->setText(parameter.unit ? parameter.unit : fields_[i][0]->unitText());
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      fields_[i][axis]->setAccessibleName(
          tr("Drive of %1, %2").arg(QLatin1Char(kAxisNames[axis])).arg(tr(parameter.title)));
    }
  }
  showErrors();
}

}  // namespace toolpace::ui
