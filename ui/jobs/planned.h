#pragma once
/// A plan with everything that the views draw from it, made ready by the worker.

#include <memory>

#include "jobs/proof_service.h"
#include "models/timeline.h"
#include "plots/profile_series.h"
#include "preview/contour_scene.h"

namespace toolpace::ui {

/// All null, or none but the proof.
struct Planned {
  std::shared_ptr<const Timeline> timeline;
  std::shared_ptr<const ContourScene> scene;
  std::shared_ptr<const ProfileSeries> series;
  std::shared_ptr<const Proof> proof;  ///< comes later than the rest

  explicit operator bool() const { return timeline != nullptr; }
};

}  // namespace toolpace::ui
