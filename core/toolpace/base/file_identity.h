#pragma once
/// Which file a path means, whatever links lead to it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace toolpace {

/// Two paths mean the same file exactly where their identities are equal.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::string name = {};  ///< of a file that is not there yet; device and inode are then its folder's

  bool operator==(const FileIdentity&) const = default;
};

/// Of a file whose bytes stay where they are written: regular, a disk, or not there yet. None for folders, pipes, terminals
/// and other devices, which may be read and written by the same work, and for what cannot be looked at.
std::optional<FileIdentity> identity_of(const std::filesystem::path& file);
std::optional<FileIdentity> identity_of(int descriptor);

/// Symbolic links that are followed one after the other, as the kernel itself does.
inline constexpr int kMostLinks = 40;

/// The path behind symbolic links, also when the last one points at nothing yet.
std::filesystem::path follow_links(std::filesystem::path file);

/// The folder that a file lies in: "." for a name alone.
std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace toolpace
