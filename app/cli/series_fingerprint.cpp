#include "series_fingerprint.h"

#include <fmt/format.h>

#include "toolpace/base/input_file.h"
#include "version.h"

namespace toolpace::cli {

void Fingerprint::add(std::string_view text) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  for (const char c : text) value_ = (value_ ^ static_cast<unsigned char>(c)) * kPrime;
  value_ = (value_ ^ 0x100) * kPrime;  // "ab", "c" are not "a", "bc"
}

Result<void> Fingerprint::add_file(const std::string& file, const Monitor& monitor) {
  const auto content = read_whole_file(file, monitor);
  if (!content) return tl::unexpected(content.error());
  add(content->bytes());
  return {};
}

std::string Fingerprint::digits() const { return fmt::format("{:016x}", value_); }

Result<Fingerprint> fingerprint_of(const Series& series, const Monitor& monitor) {
  Fingerprint fingerprint;
  fingerprint.add(version());
  fingerprint.add(series.command);
  for (const GivenFlag& flag : series.given) {
    fingerprint.add(flag.name);
    if (!flag.is_output) fingerprint.add(flag.value);
  }
  for (const FileRole& input : series.inputs) {
    if (input.file.empty()) continue;
    if (auto done = fingerprint.add_file(input.file.string(), monitor); !done) return tl::unexpected(done.error());
  }
  return fingerprint;
}

}  // namespace toolpace::cli
