#include "panels/single_move_page.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>
#include <cmath>
#include <limits>

#include "models/law_names.h"
#include "models/problem_model.h"
#include "models/remedy_text.h"
#include "models/units.h"
#include "panels/move_plot.h"
#include "theme/control_name.h"

namespace toolpace::ui {
namespace {

constexpr int kFormWidth = 360;
constexpr double kLargest = 1e30;

struct FigureValue {
  const char* key;
  double value;
  std::optional<MoveQuantity> quantity;
};

std::vector<FigureValue> values_of(const SingleMove& m) {
  using enum MoveQuantity;
  return {{"fmax", m.peak, speed},
          {"sa", m.up.length, length},
          {"sb", m.down.length, length},
          {"t_acc", m.up.time, time},
          {"t_cruise", m.cruise_time, time},
          {"t_dec", m.down.time, time},
          {"t_total", m.total_time(), time},
          {"j_acc", m.up.peak_jerk, jerk},
          {"j_dec", m.down.peak_jerk, jerk},
          {"a_peak", m.up.peak_acceleration, acceleration},
          {"d_peak", m.down.peak_acceleration, acceleration}};
}

}  // namespace

SingleMovePage::SingleMovePage(QWidget* parent) : QWidget(parent), form_(move_presets().front().form) {
  setObjectName("singleMovePage");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 8, 8, 8);
  row->setSpacing(16);
  auto* column = new QVBoxLayout;
  column->setSpacing(8);
  column->addWidget(buildForm());
  verdict_ = new QLabel(this);
  verdict_->setObjectName("moveVerdict");
  verdict_->setWordWrap(true);
  column->addWidget(verdict_);
  column->addWidget(buildFigures());
  column->addStretch(1);
  row->addLayout(column);
  plot_ = new MovePlot(this);
  row->addWidget(plot_, 1);
  fillCombos();
  retranslate();
  showForm();
  update();
}

QWidget* SingleMovePage::buildForm() {
  using enum MoveQuantity;
  grid_ = new FormGrid(this);
  grid_->setMinimumWidth(kFormWidth);
  preset_ = new QComboBox(grid_);
  preset_->setObjectName("movePreset");
  law_ = new QComboBox(grid_);
  law_->setObjectName("moveLaw");
  units_ = new QComboBox(grid_);
  units_->setObjectName("moveUnits");
  preset_label_ = grid_->addWide(0, preset_);
  law_label_ = grid_->addWide(1, law_);
  units_label_ = grid_->addWide(2, units_);
  addEntry(3, 0, "moveLength", &form_.move.length, length);
  addEntry(3, 1, "moveFeed", &form_.move.feed, speed);
  addEntry(4, 0, "moveStart", &form_.move.start, speed);
  addEntry(4, 1, "moveEnd", &form_.move.end, speed);
  addEntry(5, 0, "moveTacc", &form_.t_acc, time, LawParameter::time);
  addEntry(5, 1, "moveTdec", &form_.t_dec, time, LawParameter::time);
  addEntry(6, 0, "moveAm", &form_.acceleration, acceleration, LawParameter::acceleration);
  addEntry(6, 1, "moveDm", &form_.deceleration, acceleration, LawParameter::acceleration);
  addEntry(7, 0, "moveJm", &form_.jerk, jerk, LawParameter::jerk);
  addEntry(7, 1, "moveJd", &form_.jerk_deceleration, jerk, LawParameter::jerk);
  connect(law_, &QComboBox::activated, this, [this](int index) {
    form_.law = static_cast<LawKind>(index);
    showForm();
    update();
  });
  connect(units_, &QComboBox::activated, this, [this](int index) {
    form_.units = static_cast<MoveUnits>(index);
    showForm();
    update();
  });
  connect(preset_, &QComboBox::activated, this, [this](int index) {
    if (index > 0) setForm(move_presets()[static_cast<std::size_t>(index - 1)].form);
    preset_->setCurrentIndex(index);
  });
  return grid_;
}

void SingleMovePage::addEntry(int row, int side, const char* name, double* value, MoveQuantity quantity,
                              std::optional<LawParameter> parameter) {
  const bool may_be_zero =
      quantity == MoveQuantity::length || (quantity == MoveQuantity::speed && value != &form_.move.feed);
  const NumberField::Range range{may_be_zero ? 0.0 : 1e-30, kLargest};
  auto* field = new NumberField(name, name, Quantity::length, range, grid_);
  QLabel* label = grid_->add(row, side, field);
  entries_.push_back({field, label, value, quantity, parameter});
  connect(field, &NumberField::edited, this, [this, value](double entered) {
    *value = entered;
    preset_->setCurrentIndex(0);
    update();
  });
}

FigureList* SingleMovePage::buildFigures() {
  figures_ = new FigureList(this);
  figures_->setMinimumWidth(kFormWidth);
  for (const FigureValue& f : values_of({})) figures_->add(QString("moveResult_") + f.key);
  return figures_;
}

void SingleMovePage::fillCombos() {
  for (const LawRow& row : law_table())
    law_->addItem(QString::fromUtf8(row.title.data()), QString::fromUtf8(row.id.data()));
  units_->addItems({"", ""});
  preset_->addItem("");
  for (std::size_t i = 0; i < move_presets().size(); ++i) preset_->addItem("");
  preset_->setCurrentIndex(1);
}

void SingleMovePage::setForm(const MoveForm& form) {
  form_ = form;
  preset_->setCurrentIndex(0);
  showForm();
  update();
}

void SingleMovePage::showForm() {
  const LawRow& row = law_row(form_.law);
  law_->setCurrentIndex(static_cast<int>(form_.law));
  units_->setCurrentIndex(static_cast<int>(form_.units));
  for (const Entry& entry : entries_) {
    entry.field->setUnit({1.0, move_unit_text(entry.quantity, form_.units)});
    entry.field->setValue(*entry.value);
    const bool shown = !entry.parameter || std::find(row.parameters.begin(), row.parameters.end(), *entry.parameter) !=
                                               row.parameters.end();
    grid_->setRowVisible(entry.field, shown);
  }
  plot_->setUnits(form_.units);
}

void SingleMovePage::update() {
  const auto move = single_move(form_.law, form_.move, form_.dynamics());
  if (!move) {
    preview_.reset();
    plot_->clearMove();
    showTrouble(move.error());
  } else {
    preview_ = preview_move(*move);
    plot_->setMove(*preview_, form_.move.feed);
    set_role(verdict_, "good");
    verdict_->setText(move->reaches_feed ? tr("The feed is reached.") : tr("The feed is not reached."));
  }
  showFigures();
}

void SingleMovePage::showTrouble(const Error& error) {
  set_role(verdict_, "error");
  QString text = message_text(error.code, error.message);
  if (!error.remedy.empty()) text += "\n" + remedy_text(error.remedy);
  verdict_->setText(text);
}

void SingleMovePage::showFigures() {
  const std::vector<FigureValue> values = values_of(preview_ ? preview_->move : SingleMove{});
  for (std::size_t i = 0; i < figures_->size(); ++i) {
    figures_->setValue(i, preview_ ? number_text(values[i].value, 8) : QString("–"));
    figures_->setUnit(i, move_unit_text(*values[i].quantity, form_.units));
    figures_->setTip(i, values[i].key);  // as `toolpace move --json` names it
  }
}

void SingleMovePage::setTheme(const Theme& theme) { plot_->setTheme(theme); }

void SingleMovePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    showForm();
    update();
  }
  QWidget::changeEvent(event);
}

void SingleMovePage::retranslate() {
  const std::array labels{tr("L"),    tr("F"), tr("fs"), tr("fe"), tr("Tacc"),
                          tr("Tdec"), tr("A"), tr("D"),  tr("J"),  tr("J dec")};
  const std::array names{tr("Length"),
                         tr("Feed"),
                         tr("Start speed"),
                         tr("End speed"),
                         tr("Acceleration time"),
                         tr("Deceleration time"),
                         tr("Acceleration limit"),
                         tr("Deceleration limit"),
                         tr("Jerk limit"),
                         tr("Jerk limit while slowing down")};
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    entries_[i].label->setText(labels[i]);
    entries_[i].label->setToolTip(names[i]);
    name_control(entries_[i].field, names[i]);
  }
  const std::array figures{tr("peak speed"),        tr("length speeding up"), tr("length slowing down"),
                           tr("time speeding up"),  tr("time at the peak"),   tr("time slowing down"),
                           tr("total time"),        tr("jerk speeding up"),   tr("jerk slowing down"),
                           tr("peak acceleration"), tr("peak deceleration")};
  for (std::size_t i = 0; i < figures_->size(); ++i) figures_->setName(i, figures[i]);
  preset_label_->setText(tr("Preset"));
  name_control(preset_, tr("Preset"), tr("Fill the form with a known move"));
  preset_->setItemText(0, tr("own values"));
  const std::array presets{tr("Zheng, move 1 (feed reached)"), tr("Zheng, move 2 (feed not reached)"),
                           tr("S-curve from rest to rest"), tr("Quintic, 20 to 40 mm/s")};
  for (std::size_t i = 0; i < presets.size(); ++i) preset_->setItemText(static_cast<int>(i) + 1, presets[i]);
  law_label_->setText(tr("Law"));
  name_control(law_, tr("Velocity law"));
  for (const LawRow& row : law_table()) law_->setItemText(static_cast<int>(row.kind), law_title(row));
  units_label_->setText(tr("Units"));
  units_->setAccessibleName(tr("Units"));
  units_->setToolTip(tr("Names of the units; the numbers stay as they are"));
  units_->setItemText(0, tr("mm, s"));
  units_->setItemText(1, tr("pulse, cycle"));
  plot_->retranslate();
}

}  // namespace toolpace::ui
