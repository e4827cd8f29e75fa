// Checks words of an operation file that appear in emitted files: nothing in them may end a comment or a string, or be
// read as something else, in any emitted language (docs/reference/operation-file.md, "Words").
#pragma once

#include <string>
#include <string_view>

namespace restrip::generator {

/// The first part of a UTF-8 text that may not be in a comment, such as "U+000A"; empty if everything may.
[[nodiscard]] std::string unprintable(std::string_view text);

/// The owner of a taken name, such as "a keyword of C++" (docs/taken-names.json); empty if it is free.
[[nodiscard]] std::string name_is(std::string name);

}  // namespace restrip::generator
