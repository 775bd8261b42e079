#include "jobs/analysis_service.h"

#include <utility>

namespace toolpace::ui {

AnalysisService::AnalysisService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::finished, this, [this] {
    if (next_) start(*std::exchange(next_, std::nullopt));
  });
}

void AnalysisService::analyse(const AnalysisRequest& request) {
  ++latest_;
  if (!worker_.isBusy()) return start(request);
  next_ = request;
  worker_.cancel();
}

void AnalysisService::cancel() {
  ++latest_;
  next_.reset();
  worker_.cancel();
}

void AnalysisService::start(const AnalysisRequest& request) {
  const quint64 number = latest_;
  worker_.start(
      [this, request, number](const Monitor& monitor) -> Background::Delivery {
        auto result = analyse_motion(request, monitor);
        if (!result) {
          return [this, number, error = result.error()] {
            if (number == latest_) emit failed(error);
          };
        }
        auto analysis = std::make_shared<const MotionAnalysis>(std::move(*result));
        return [this, number, analysis] {
          if (number == latest_) emit analysed(analysis);
        };
      },
      [this, number](const Error& error) {
        if (number == latest_) emit failed(error);
      });
}

}  // namespace toolpace::ui
