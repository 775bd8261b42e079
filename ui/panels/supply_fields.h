#pragma once
/// How blocks come to a controller: by what link, and how long it reads each.

#include "panels/number_field.h"
#include "toolpace/controller/prediction.h"

namespace toolpace::ui {

/// Two fields for somebody else's layout, and what they are called there.
class SupplyFields : public QObject {
  Q_OBJECT

 public:
  /// @param prefix  of the fields' object names: "…Baud", "…BlockTime"
  SupplyFields(const QString& prefix, QWidget* parent);

  NumberField* baud() const { return baud_; }
  NumberField* blockTime() const { return block_time_; }
  static QString baudTitle() { return tr("Serial link"); }
  static QString blockTimeTitle() { return tr("A block takes"); }

  void setValue(const PredictOptions& options);
  PredictOptions value() const;  ///< none where there is no link, and where a block takes no time
  void setEnabled(bool enabled);
  void retranslate();

 signals:
  void edited();

 private:
  NumberField *baud_, *block_time_;
};

}  // namespace toolpace::ui
