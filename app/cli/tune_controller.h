#pragma once
/// `tune --settings`: the settings of a real controller instead of this planner's.

#include "controller_flags.h"
#include "failure.h"
#include "job_flags.h"
#include "reading_flags.h"

namespace toolpace::cli {

struct TuneControllerFlags {
  ReadingFlags reading;
  JobFlags job;
  ControllerFlags controller;
  std::string vary;  ///< keys of settings, with commas between; empty = all
  std::string output;
  std::size_t plans;
  bool json;
};

Done tune_controller(TuneControllerFlags flags);

}  // namespace toolpace::cli
