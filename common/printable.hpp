#pragma once
// Makes text with names and bytes of files safe to print: a terminal obeys some of them.

#include <cstddef>
#include <string>
#include <string_view>

namespace restrip::files {

/// Control characters other than line feeds, and bytes that are not UTF-8, as \x1b.
[[nodiscard]] std::string printable(std::string_view text);

/// The same for one message; the middle of longer ones is left out.
inline constexpr std::size_t longest_message = 1000;
[[nodiscard]] std::string printable_message(std::string_view text);

/// Every byte that is not printable ASCII as \x1b, and at most 400 bytes: for words quoted from a file.
[[nodiscard]] std::string printable_ascii(std::string_view text);

}  // namespace restrip::files
