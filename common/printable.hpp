#pragma once
// Text for people, whatever names and bytes of files are in it: a terminal obeys some of them.

#include <cstddef>
#include <string>
#include <string_view>

namespace restrip::files {

/// Control characters other than line feeds, and bytes that are not UTF-8, as \x1b.
[[nodiscard]] std::string printable(std::string_view text);

/// The same as one message, its middle left out where it is longer.
inline constexpr std::size_t longest_message = 1000;
[[nodiscard]] std::string printable_message(std::string_view text);

}  // namespace restrip::files
