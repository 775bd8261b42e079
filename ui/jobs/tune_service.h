#pragma once
/// Sweeps the look-ahead, searches for the best settings, finds what each of them does alone, and what each setting of a controller
/// gives, in a worker.

#include <QObject>
#include <functional>
#include <memory>

#include "drawing/controlled.h"
#include "jobs/background.h"
#include "toolpace/tune/single_changes.h"
#include "toolpace/tune/sweep.h"
#include "toolpace/tune/tune.h"
#include "toolpace/tune/tune_settings.h"
#include "toolpace/tune/vibration_advice.h"
#include "toolpace/tune/what_if.h"

namespace toolpace::ui {

/// A newer request replaces an older one, whose result never arrives.
class TuneService : public QObject {
  Q_OBJECT

 public:
  explicit TuneService(QObject* parent = nullptr);

  void sweep(std::shared_ptr<const Job> job);
  void search(std::shared_ptr<const Job> job, const TuneOptions& options);
  void trySingleChanges(std::shared_ptr<const Job> job);
  /// @param limit  [mm, deg]
  void advise(std::shared_ptr<const Job> job, std::optional<double> limit);
  /// What the program takes there with another value of each setting.
  void trySettings(std::shared_ptr<const Controlled> run);
  /// The settings that are best for it. @param search  but for how blocks come, which `run` tells
  void searchSettings(std::shared_ptr<const Controlled> run, const SettingsSearch& search);
  /// What it takes as setpoints of this planner, on the same limits.
  void planSetpoints(std::shared_ptr<const Controlled> run);
  void cancel();
  bool isRunning() const { return worker_.isBusy() || next_; }

 signals:
  void swept(const toolpace::LookaheadSweep& sweep);
  void tuned(const toolpace::TuneResult& tuning);
  void changesTried(const toolpace::SingleChanges& changes);
  void advised(const toolpace::VibrationAdvice& advice);
  void settingsTried(const std::vector<toolpace::WhatIf>& rows);
  void settingsTuned(const toolpace::TunedSettings& tuned);
  void setpointsPlanned(double cycle_time);  ///< [s]
  void failed(const toolpace::Error& error);
  void progressed(double fraction);
  void finished();

 private:
  void submit(quint64 number, Background::Task task);
  /// Gives a result to its signal, an error to failed(), and nothing where the request is no longer the latest.
  template <class T, class Argument>
  Background::Delivery answer(quint64 number, Result<T> result, void (TuneService::*signal)(Argument));

  Background worker_;
  std::function<void()> next_;
  quint64 latest_ = 0;
};

}  // namespace toolpace::ui
