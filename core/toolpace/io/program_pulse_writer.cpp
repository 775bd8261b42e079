#include "toolpace/io/program_pulse_writer.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>

#include "toolpace/base/file_name.h"

namespace toolpace {

bool is_pulse_file(const std::filesystem::path& file) {
  return extension_of(file) == ".csv" && inner_extension_of(file) == ".pulses";
}

Result<ProgramPulseWriter> ProgramPulseWriter::create(const std::filesystem::path& file, const Monitor& monitor) {
  auto out = OutputFile::create(file, OutputFile::Access::forward, monitor);
  if (!out) return tl::unexpected(out.error());
  if (auto written = out->write("t_ticks,axis,direction\n"); !written) return tl::unexpected(written.error());
  return ProgramPulseWriter(std::move(*out));
}

Result<void> ProgramPulseWriter::write(const std::vector<Pulse>& pulses) {
  text_.clear();
  for (const Pulse& p : pulses) {
    fmt::format_to(std::back_inserter(text_), FMT_COMPILE("{},{},{}\n"), p.ticks, kAxisNames[p.axis],
                   static_cast<int>(p.direction));
  }
  return file_.write(text_);
}

}  // namespace toolpace
