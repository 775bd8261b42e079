#pragma once
/// What toolpace-studio is asked for.

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

#include "toolpace/base/result.h"

namespace toolpace::studio {

enum ExitCode : int { kFine = 0, kBadUsage = 2, kBadInput = 3, kFileTrouble = 4, kInterrupted = 130 };

struct Request {
  QString program, machine, controller, screenshot, language, theme;
  std::optional<QSize> size;  ///< none: as the window was left
  bool touch = false, inch = false, per_minute = false;
  QString answer;  ///< text of --help or --version: print it and leave
};

/// Needs no application and no display; options of Qt itself (-platform …) are left to the application. Errors: usage.
Result<Request> parse_command_line(const QStringList& arguments);

/// As the command line tells errors: place, message and code, the remedy below. On stderr.
/// @return the exit code that goes with it
ExitCode report(const Error& error);

}  // namespace toolpace::studio
