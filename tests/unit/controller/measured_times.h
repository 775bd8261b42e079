#pragma once
/// Cycle times that real controllers took, measured.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "places.h"
#include "toolpace/base/input_file.h"
#include "toolpace/controller/prediction.h"
#include "toolpace/nc/reader.h"

namespace toolpace::test {

/// A row of times.tsv.
struct MeasuredTime {
  Controller controller;
  std::string program, settings, control;  ///< control: "G64 P0.01" of LinuxCNC, as it was set before the program
  double cycle_time;
  std::optional<double> baud;
  std::filesystem::path file;
};

inline std::filesystem::path controller_data() { return source_dir() / "tests/data/controllers"; }

inline std::vector<MeasuredTime> measured_times() {
  std::vector<MeasuredTime> times;
  std::ifstream in(controller_data() / "times.tsv");
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::stringstream rest(line);
    for (std::string cell; std::getline(rest, cell, '\t');) cells.push_back(cell);
    if (cells.size() < 8 || cells[0] == "controller") continue;
    MeasuredTime time;
    const std::string& name = cells[0];
    time.controller = name == "grbl"      ? Controller::grbl
                      : name == "grblHAL" ? Controller::grblhal
                      : name == "Klipper" ? Controller::klipper
                                          : Controller::linuxcnc;
    time.program = cells[2];
    const std::size_t blank = cells[3].find(' ');
    time.settings = cells[3].substr(0, blank);
    if (blank != std::string::npos) time.control = cells[3].substr(blank + 1);
    time.cycle_time = std::stod(cells[4]);
    if (cells[7].find("link=115200") != std::string::npos) time.baud = 115200.0;
    const std::size_t printer = cells[7].find("printer_F");
    time.file = controller_data() / "programs" /
                (printer != std::string::npos ? cells[7].substr(printer) + "/" + time.program + ".gcode"
                                              : time.program + ".ngc");
    times.push_back(time);
  }
  return times;
}

inline std::filesystem::path settings_file(const MeasuredTime& time) {
  const char* suffix = time.controller == Controller::klipper    ? ".cfg"
                       : time.controller == Controller::linuxcnc ? ".ini"
                                                                 : ".txt";
  return controller_data() / "settings" / (time.settings + suffix);
}

/// The text of a program as that measurement ran it.
inline std::string program_text(const MeasuredTime& time) {
  std::string text(read_whole_file(time.file)->bytes());
  if (time.control.empty()) return text;
  const std::size_t end = text.find("G94 G40");
  return text.substr(0, end) + time.control + " " + text.substr(end);
}

inline Prediction prediction_of(const MeasuredTime& time) {
  auto settings = *read_controller_settings(settings_file(time), time.controller);
  const std::string text = program_text(time);
  ReadOptions reading;
  reading.dialect = dialect_of(time.controller);
  PredictOptions options;
  options.baud = time.baud;
  return *predict(*read_text(text, time.file.filename().string(), reading), scan_program(text), settings, options);
}

}  // namespace toolpace::test
