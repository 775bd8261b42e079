#pragma once
/// Pulse tables of programs as files.

#include <string>
#include <vector>

#include "toolpace/io/output_file.h"
#include "toolpace/sample/program_pulses.h"

namespace toolpace {

/// True for names that ask for a pulse table: ….pulses.csv, in letters of any case
bool is_pulse_file(const std::filesystem::path& file);

/// CSV with the header t_ticks,axis,direction: one row a pulse, axis X … C, direction 1 or −1. Whole or not at all.
class ProgramPulseWriter {
 public:
  static Result<ProgramPulseWriter> create(const std::filesystem::path& file, const Monitor& monitor = {});
  Result<void> write(const std::vector<Pulse>& pulses);
  Result<void> finish() { return file_.commit(); }

 private:
  explicit ProgramPulseWriter(OutputFile file) : file_(std::move(file)) {}
  OutputFile file_;
  std::string text_;
};

}  // namespace toolpace
