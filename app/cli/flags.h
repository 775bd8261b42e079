#pragma once
/// Flags with values, as every command takes them: read to the last letter, never wrapped round, cut short or empty.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

namespace toolpace::cli {

/// A flag that takes a number, such as 3000, 1e6 or inf.
/// @param flag  with the unit that --help shows for its value behind a blank: "--vmax MM/S"
/// @param text  what it is for, and its default
CLI::Option* add_number(CLI::App& command, const std::string& flag, std::optional<double>& target,
                        const std::string& text);
CLI::Option* add_number(CLI::App& command, const std::string& flag, double& target, const std::string& text);

/// A flag that takes a whole number from 0 on. What `target` holds is its default.
CLI::Option* add_count(CLI::App& command, const std::string& flag, std::uint64_t& target, const std::string& text);

/// A flag that takes a word or the name of a file. An empty one, as a script's unset variable leaves it, is refused.
CLI::Option* add_word(CLI::App& command, const std::string& flag, std::string& target, const std::string& text);

}  // namespace toolpace::cli
