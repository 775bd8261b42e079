#include "panels/supply_fields.h"

#include <cmath>
#include <limits>

#include "theme/control_name.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastBaud = 1, kMostBaud = 1e9;  // [bit/s]
constexpr double kMostBlockTime = 10;              // [s]

}  // namespace

SupplyFields::SupplyFields(const QString& prefix, QWidget* parent)
    : QObject(parent),
      baud_(new NumberField(prefix + "Baud", {}, Quantity::time, {kLeastBaud, kMostBaud, true, true}, parent)),
      block_time_(new NumberField(prefix + "BlockTime", {}, Quantity::time, {0, kMostBlockTime}, parent)) {
  block_time_->setUnit({1e3, "ms"});
  retranslate();
  setValue({});
  for (const NumberField* field : {baud_, block_time_})
    connect(field, &NumberField::edited, this, &SupplyFields::edited);
}

void SupplyFields::setValue(const PredictOptions& options) {
  baud_->setValue(options.baud.value_or(std::numeric_limits<double>::infinity()));
  block_time_->setValue(options.block_time.value_or(0.0));
}

PredictOptions SupplyFields::value() const {
  PredictOptions options;
  if (std::isfinite(baud_->value())) options.baud = baud_->value();
  if (block_time_->value() > 0) options.block_time = block_time_->value();
  return options;
}

void SupplyFields::setEnabled(bool enabled) {
  for (NumberField* field : {baud_, block_time_}) field->setEnabled(enabled);
}

void SupplyFields::retranslate() {
  baud_->setUnit({1.0, tr("bit/s")});
  baud_->setUnlimitedText(tr("no link"));
  name_control(baud_, baudTitle(), tr("Bits a second that blocks come at; empty: they are always there"));
  name_control(block_time_, blockTimeTitle(), tr("What the controller needs to read a block"));
}

}  // namespace toolpace::ui
