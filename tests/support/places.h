#pragma once
/// Where tests find files. One source file knows the folders, so that the others compile alike wherever the project lies.

#include <filesystem>

namespace toolpace::test {

/// The project's own folder.
std::filesystem::path source_dir();

}  // namespace toolpace::test
