#pragma once
/// What the window remembers between two starts. Parameters of planning live in machine files, not here.

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "models/units.h"
#include "toolpace/controller/prediction.h"
#include "toolpace/nc/read_options.h"

namespace toolpace::studio {

struct Preferences {
  bool dark = false;
  bool touch = false;
  ui::Units units;
  bool line_times = true;                                ///< beside the lines of the program
  bool rapids = true;                                    ///< drawn in the preview
  bool welcomed = false;                                 ///< the example need not say that it is one
  QString language;                                      ///< "en", "zh_CN"; empty = that of the system
  QString colour_map;                                    ///< "cividis", "viridis", "turbo"
  ReadOptions reading;                                   ///< of programs
  PredictOptions supply;                                 ///< how blocks come to a controller
  double timer_hz = 1e6;                                 ///< of the step pulses' timer
  bool axis_derivatives = false, decimal_comma = false;  ///< of exported setpoints
  QByteArray geometry, layout;
  QStringList recent_programs, recent_machines, recent_controllers;  ///< latest first
  QString last_program, last_machine;
};

Preferences load_preferences();
void save_preferences(const Preferences& preferences);

/// Puts `path` in front, without doubles, at most ten entries.
void remember(QStringList& recent, const QString& path);

}  // namespace toolpace::studio
