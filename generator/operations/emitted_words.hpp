// What the words of an operation file may be that go into emitted files: nothing in them may end a comment or a string,
// or be taken for something else, in any language that is emitted (docs/reference/operation-file.md, "Words").
#pragma once

#include <string>
#include <string_view>

namespace restrip::generator {

/// The first thing in a UTF-8 text that may not be in a comment, such as "U+000A"; empty when all of it may.
[[nodiscard]] std::string unprintable(std::string_view text);

/// The text as a message has it: every byte that is not printable ASCII is written as \x1b; long ones are cut.
[[nodiscard]] std::string printable(std::string_view text);

/// What takes the name, such as "a keyword of C++" (docs/taken-names.json); empty when nothing does.
[[nodiscard]] std::string name_is(std::string name);

}  // namespace restrip::generator
