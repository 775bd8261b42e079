#include "toolpace/base/file_name.h"

namespace toolpace {

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return text;
}

std::string extension_of(const std::filesystem::path& file) { return lower_case(file.extension().string()); }

std::string inner_extension_of(const std::filesystem::path& file) { return extension_of(file.stem()); }

}  // namespace toolpace
