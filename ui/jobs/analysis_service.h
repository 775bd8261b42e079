#pragma once
/// Analyses a plan's motion in a worker; a newer request replaces an older one, whose result never arrives.

#include <QObject>

#include "drawing/spectrum.h"
#include "jobs/background.h"

namespace toolpace::ui {

class AnalysisService : public QObject {
  Q_OBJECT

 public:
  explicit AnalysisService(QObject* parent = nullptr);

  void analyse(const AnalysisRequest& request);
  void cancel();
  bool isRunning() const { return worker_.isBusy() || next_; }

 signals:
  void analysed(const std::shared_ptr<const toolpace::ui::MotionAnalysis>& analysis);
  void failed(const toolpace::Error& error);

 private:
  void start(const AnalysisRequest& request);

  Background worker_;
  std::optional<AnalysisRequest> next_;
  quint64 latest_ = 0;
};

}  // namespace toolpace::ui
