#pragma once
/// What the pages of this room share.

#include <string>
#include <string_view>

namespace toolpace::page {

/// For HTML.
std::string escaped(std::string_view text);

/// The whole page about a program. @param body  below its heading, which is the program's file name
std::string whole(const std::string& program_name, const std::string& body);

}  // namespace toolpace::page
