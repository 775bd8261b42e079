#include "toolpace/io/pulse_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <vector>

#include "toolpace/base/numbers.h"
#include "toolpace/io/output_file.h"

namespace toolpace {
namespace {

constexpr std::size_t kChunk = 8192;  // pulses
constexpr std::size_t kRowBytes = 40;
constexpr std::size_t kPerLine = 10;  // values a line of the C header

/// Rows of text, appended with no checks but the caller's promise of space.
class Rows {
 public:
  void put(char c) { buffer_[used_++] = c; }
  void put(std::uint64_t value) {
    char* const at = buffer_.data() + used_;
    used_ += static_cast<std::size_t>(std::to_chars(at, buffer_.data() + buffer_.size(), value).ptr - at);
  }
  std::string_view text() const { return {buffer_.data(), used_}; }
  void clear() { used_ = 0; }

 private:
  std::array<char, kChunk * kRowBytes> buffer_;
  std::size_t used_ = 0;
};

void put_csv(Rows& rows, std::uint64_t first, std::span<const std::uint32_t> ticks) {
  for (const std::uint32_t t : ticks) {
    rows.put(++first);
    rows.put(',');
    rows.put(std::uint64_t{t});
    rows.put('\n');
  }
}

void put_c(Rows& rows, std::uint64_t first, std::span<const std::uint32_t> ticks) {
  for (const std::uint32_t t : ticks) {
    rows.put(first % kPerLine == 0 ? '\n' : ' ');
    rows.put(std::uint64_t{t});
    rows.put('U');
    rows.put(',');
    ++first;
  }
}

std::string c_head(const PulseTable& table) {
  const StepperMove& move = table.move();
  return "/* Pulse table of a stepper move, five-phase S-curve from rest to rest.\n"
         " * steps " +
         std::to_string(move.steps) + ", top speed " + to_text(move.speed) + " step/s, peak " +
         to_text(table.peak_speed()) + " step/s\n * acceleration " + to_text(move.t_acc * 1e3) + " ms, deceleration " +
         to_text(move.t_dec * 1e3) + " ms, timer " + to_text(move.timer_hz) + " Hz\n * total " +
         to_text(table.total_time()) + " s, " + std::to_string(table.total_ticks()) +
         " ticks\n * Entry k is the number of timer ticks between pulse k and pulse k + 1; entry 0 counts from the "
         "start. */\n"
         "#ifndef TOOLPACE_PULSE_TABLE_H\n#define TOOLPACE_PULSE_TABLE_H\n\n#include <stdint.h>\n\n"
         "#define PULSE_COUNT " +
         std::to_string(move.steps) + "UL\n\nstatic const uint32_t pulse_ticks[PULSE_COUNT] = {";
}

}  // namespace

Result<void> write_pulses(const std::filesystem::path& path, const PulseTable& table, PulseFormat format,
                          const Monitor& monitor) {
  auto file = OutputFile::create(path, OutputFile::Access::forward, monitor);
  if (!file) return tl::make_unexpected(file.error());
  const bool is_csv = format == PulseFormat::csv;
  if (auto done = file->write(is_csv ? "pulse,ticks\n" : c_head(table)); !done) return done;

  const std::uint64_t steps = table.move().steps;
  std::vector<std::uint32_t> ticks(static_cast<std::size_t>(std::min<std::uint64_t>(steps, kChunk)));
  const auto rows = std::make_unique<Rows>();
  for (std::uint64_t first = 0; first < steps; first += kChunk) {
    if (monitor.is_cancelled()) return tl::make_unexpected(cancelled_error());
    ticks.resize(static_cast<std::size_t>(std::min<std::uint64_t>(steps - first, kChunk)));
    table.read(first, ticks);
    rows->clear();
    is_csv ? put_csv(*rows, first, ticks) : put_c(*rows, first, ticks);
    if (auto done = file->write(rows->text()); !done) return done;
    monitor.report(static_cast<double>(first) / static_cast<double>(steps));
  }
  if (!is_csv) {
    if (auto done = file->write("\n};\n\n#endif\n"); !done) return done;
  }
  return file->commit();
}

}  // namespace toolpace
