#include "trace_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <limits>

#include "models/units.h"
#include "panels/number_field.h"
#include "theme/control_name.h"
#include "theme/role.h"
#include "toolpace/base/axes.h"

namespace toolpace::studio {
namespace {

constexpr QSize kTraceDialogSize = {720, 460};
constexpr int kTraceRowHeight = 36, kUnitWidth = 84;  // px
constexpr qsizetype kShownValues = 6;
constexpr double kShortestStep = 1e-7, kLongestStep = 10;  // [s]
constexpr std::array kTimeUnits = {"s", "ms", "us", "ns", "min"};
constexpr std::array kLengthUnits = {"mm", "um", "nm", "m", "in"};
constexpr std::array kAngleUnits = {"deg", "rad"};
enum Column { kName, kMeaning, kUnit, kValues, kColumns };

/// A meaning as the data of a list: role and axis.
int coded(TraceRole role, std::size_t axis) { return static_cast<int>(role) * 16 + static_cast<int>(axis); }
TraceRole role_of(int code) { return static_cast<TraceRole>(code / 16); }
std::size_t axis_of(int code) { return static_cast<std::size_t>(code % 16); }

int code_of(const TraceColumn& column) {
  switch (column.role) {
    case TraceRole::time: return coded(TraceRole::time, 0);
    case TraceRole::commanded: return coded(TraceRole::commanded, column.axis);
    case TraceRole::actual:
    case TraceRole::position: return coded(TraceRole::actual, column.axis);
    case TraceRole::sample:
    case TraceRole::ignored: break;
  }
  return coded(TraceRole::ignored, 0);
}

}  // namespace

TraceDialog::TraceDialog(const QString& name, TracePreview preview, QWidget* parent)
    : QDialog(parent),
      preview_(std::move(preview)),
      table_(new QTableWidget(static_cast<int>(preview_.columns.size()), kColumns, this)),
      step_(new ui::NumberField("traceStep", {}, ui::Quantity::time, {kShortestStep, kLongestStep, true}, this)),
      state_(new QLabel(this)) {
  setObjectName("traceDialog");
  setWindowTitle(tr("Columns of the trace"));
  auto* column = new QVBoxLayout(this);
  auto* head = new QLabel(tr("What the columns of %1 mean:").arg(name), this);
  head->setWordWrap(true);
  column->addWidget(head);
  buildTable();
  column->addWidget(table_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Without a column for the time, from row to row"), this));
  step_->setUnit({1e3, "ms"});
  step_->setUnlimitedText("–");
  step_->setValue(std::numeric_limits<double>::infinity());
  ui::name_control(step_, tr("Time from row to row"), tr("Of a trace without times"));
  row->addWidget(step_);
  row->addWidget(new QLabel("ms", this));
  row->addStretch(1);
  column->addLayout(row);
  state_->setObjectName("traceState");
  state_->setWordWrap(true);
  column->addWidget(state_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  use_ = buttons->button(QDialogButtonBox::Ok);
  use_->setText(tr("Compare"));
  use_->setObjectName("traceUse");
  buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
  buttons->button(QDialogButtonBox::Cancel)->setObjectName("traceCancel");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(step_, &ui::NumberField::edited, this, &TraceDialog::showState);
  column->addWidget(buttons);
  resize(kTraceDialogSize);
  showState();
}

void TraceDialog::buildTable() {
  table_->setObjectName("traceTable");
  table_->setAccessibleName(tr("Columns of the trace"));
  table_->setHorizontalHeaderLabels({tr("Column"), tr("Means"), tr("Unit"), tr("First values")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kTraceRowHeight);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kValues, QHeaderView::Stretch);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->setWordWrap(false);
  table_->setShowGrid(false);
  for (int row = 0; row < table_->rowCount(); ++row) buildRow(row);
}

void TraceDialog::buildRow(int row) {
  const TraceColumn& column = preview_.columns[static_cast<std::size_t>(row)];
  auto *meaning = new QComboBox(table_), *unit = new QComboBox(table_);
  rows_.push_back({meaning, unit});
  meaning->setObjectName(QString("traceMeaning%1").arg(row + 1));
  unit->setObjectName(QString("traceUnit%1").arg(row + 1));
  meaning->addItem(tr("nothing"), coded(TraceRole::ignored, 0));
  meaning->addItem(tr("time"), coded(TraceRole::time, 0));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis)
    meaning->addItem(tr("%1, actual").arg(QLatin1Char(kAxisNames[axis])), coded(TraceRole::actual, axis));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis)
    meaning->addItem(tr("%1, commanded").arg(QLatin1Char(kAxisNames[axis])), coded(TraceRole::commanded, axis));
  meaning->setCurrentIndex(std::max(0, meaning->findData(code_of(column))));
  const QString name = QString::fromStdString(column.name);
  ui::name_control(meaning, tr("Meaning of %1").arg(name));
  ui::name_control(unit, tr("Unit of %1").arg(name));
  unit->setMinimumWidth(kUnitWidth);
  fillUnits(row, column.unit_name);
  table_->setItem(row, kName, new QTableWidgetItem(name));
  table_->setCellWidget(row, kMeaning, meaning);
  table_->setCellWidget(row, kUnit, unit);
  QStringList values;
  for (const auto& line : preview_.rows) {
    if (values.size() == kShownValues) break;
    if (static_cast<std::size_t>(row) < line.size()) values << ui::number_text(line[static_cast<std::size_t>(row)], 7);
  }
  table_->setItem(row, kValues, new QTableWidgetItem(values.join("   ")));
  connect(meaning, &QComboBox::activated, this, [this, row] {
    fillUnits(row, rows_[static_cast<std::size_t>(row)].unit->currentText().toStdString());
    showState();
  });
}

/// Those of the kind that the column has now; the one it had where it is among them.
void TraceDialog::fillUnits(int row, const std::string& unit) {
  const auto [meaning, list] = rows_[static_cast<std::size_t>(row)];
  const int code = meaning->currentData().toInt();
  list->clear();
  const auto add = [list = list](const auto& units) {
    for (const char* name : units) list->addItem(name);
  };
  std::optional<double> factor;
  if (role_of(code) == TraceRole::time) {
    add(kTimeUnits);
    factor = time_unit(unit);
  } else if (role_of(code) != TraceRole::ignored) {
    is_rotary(axis_of(code)) ? add(kAngleUnits) : add(kLengthUnits);
    factor = position_unit(unit, axis_of(code));
  }
  list->setEnabled(list->count() > 0);
  for (int i = 0; factor && i < list->count(); ++i) {
    const std::string name = list->itemText(i).toStdString();
    const auto other = role_of(code) == TraceRole::time ? time_unit(name) : position_unit(name, axis_of(code));
    if (other == factor) return list->setCurrentIndex(i);
  }
}

TraceOptions TraceDialog::options() const {
  TraceOptions options;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const int code = rows_[i].meaning->currentData().toInt();
    if (role_of(code) == TraceRole::ignored) continue;
    const std::string unit = rows_[i].unit->currentText().toStdString();
    options.columns.push_back({role_of(code), axis_of(code), std::to_string(i + 1) + "[" + unit + "]"});
  }
  if (std::isfinite(step_->value())) options.step = step_->value();
  return options;
}

void TraceDialog::showState() {
  std::vector<int> codes;
  for (const Row& row : rows_) codes.push_back(row.meaning->currentData().toInt());
  const auto count = [&](TraceRole role) {
    return std::count_if(codes.begin(), codes.end(), [role](int code) { return role_of(code) == role; });
  };
  bool twice = false;
  for (const int code : codes) {
    twice |= role_of(code) != TraceRole::ignored && std::count(codes.begin(), codes.end(), code) > 1;
  }
  const bool has_step = std::isfinite(step_->value());
  const QString trouble = twice                                      ? tr("Two columns mean the same.")
                          : count(TraceRole::actual) == 0            ? tr("No column tells where an axis was.")
                          : count(TraceRole::time) == 0 && !has_step ? tr("No column is the time.")
                                                                     : QString();
  state_->setText(trouble.isEmpty() ? tr("Where an axis was commanded helps to find its lag, but is not needed.")
                                    : trouble);
  ui::set_role(state_, trouble.isEmpty() ? "secondary" : "warning");
  use_->setEnabled(trouble.isEmpty());
}

}  // namespace toolpace::studio
