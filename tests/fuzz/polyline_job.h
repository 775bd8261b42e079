#pragma once
/// A polyline, planned.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::fuzz {

/// The job of a polyline on the default machine; nothing where the text is none, or longer than `most_moves`.
inline std::shared_ptr<Job> polyline_job(const std::uint8_t* data, std::size_t size, std::size_t most_moves) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  auto reading = read_text(text, "fuzz.csv");
  if (!reading || reading->refused || reading->moves.size() > most_moves) return nullptr;
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = default_setup().machine;
  return job;
}

}  // namespace toolpace::fuzz
