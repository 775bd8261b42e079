#pragma once
/// Where tests find files. One source file knows the folders, so that the others compile alike wherever the project lies.

#include <filesystem>

namespace toolpace::test {

/// The project's own folder.
std::filesystem::path source_dir();

/// The big reference programs beside the project, which may be absent: tests of them skip then.
std::filesystem::path shared_dir();

}  // namespace toolpace::test
