#pragma once
/// A file for what can only be fuzzed through one; in memory where the system can, as it is written many times a second.

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace toolpace::fuzz {

inline std::filesystem::path scratch_file(const std::string& ending) {
  const std::filesystem::path memory = "/dev/shm";
  const auto folder = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  return folder / ("toolpace_fuzz_" + std::to_string(getpid()) + ending);
}

inline void fill(const std::filesystem::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace toolpace::fuzz
