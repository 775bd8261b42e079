#include "models/presets.h"

#include <QCoreApplication>

namespace toolpace::ui {
namespace {

constexpr const char* kContext = "PlanPresets";

QString preset_text(const char* source) { return QCoreApplication::translate(kContext, source); }

void choose(PlanOptions& options, LawKind law, Ramps ramps, std::optional<std::size_t> lookahead, CornerRule rule) {
  options.law = law;
  options.ramps = ramps;
  options.lookahead = lookahead;
  options.corner.rule = rule;
  options.corner.step.reset();
}

}  // namespace

const std::array<PlanPreset, 4>& plan_presets() {
  static const std::array<PlanPreset, 4> presets = {
      {{"zheng", [] { return preset_text(QT_TRANSLATE_NOOP("PlanPresets", "Zheng 2014")); },
        [] {
          return preset_text(QT_TRANSLATE_NOOP("PlanPresets", "Five-phase ramps of fixed times inside their blocks"));
        },
        [](PlanOptions& o) { choose(o, LawKind::five_phase_time, Ramps::block, std::nullopt, CornerRule::servo); }},
       {"ning", [] { return preset_text(QT_TRANSLATE_NOOP("PlanPresets", "Ning 2014, N = 8")); },
        [] {
          return preset_text(
              QT_TRANSLATE_NOOP("PlanPresets", "Quintic ramps inside their blocks, look-ahead over eight of them"));
        },
        [](PlanOptions& o) { choose(o, LawKind::quintic, Ramps::block, 8, CornerRule::servo); }},
       {"path", [] { return preset_text(QT_TRANSLATE_NOOP("PlanPresets", "Fastest on the path")); },
        [] {
          return preset_text(
              QT_TRANSLATE_NOOP("PlanPresets", "Time-optimal ramps across blocks; every corner stays as it is"));
        },
        [](PlanOptions& o) { choose(o, LawKind::time_optimal, Ramps::span, std::nullopt, CornerRule::servo); }},
       {"tolerance", [] { return preset_text(QT_TRANSLATE_NOOP("PlanPresets", "Fastest inside the tolerance")); },
        [] {
          return preset_text(
              QT_TRANSLATE_NOOP("PlanPresets", "The fastest motion that stays within the tolerance of the path"));
        },
        [](PlanOptions& o) { choose(o, LawKind::time_optimal, Ramps::span, std::nullopt, CornerRule::smooth); }}}};
  return presets;
}

}  // namespace toolpace::ui
