// The error of files that cannot be used; and how text with names and bytes of files is made safe to print: a terminal
// obeys some of them.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace restrip::files {

/// One line that names the file, what is wrong with it, and the remedy.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Control characters other than line feeds, and bytes that are not UTF-8, as \x1b.
[[nodiscard]] std::string printable(std::string_view text);

/// The same for one message; the middle of longer ones is left out.
inline constexpr std::size_t longest_message = 1000;
[[nodiscard]] std::string printable_message(std::string_view text);

/// Every byte that is not printable ASCII as \x1b, and at most 400 bytes: for words quoted from a file.
[[nodiscard]] std::string printable_ascii(std::string_view text);

/// The first part of UTF-8 text that must not be in a comment of generated files, such as "U+000A"; empty if every part
/// may: nothing ends the comment, continues it, or is invisible (docs/reference/operation-file.md, "Words").
[[nodiscard]] std::string unfit_for_comment(std::string_view text);

}  // namespace restrip::files
