#pragma once
// Words of an operation file that stand in files made from it: docs/reference/operation-file.md, "Words".

#include <optional>
#include <string>
#include <string_view>

#include "model/json_value.hpp"

namespace restrip::verify {

/// What in a text of valid UTF-8 cannot stand in a comment of every language, such as "the character U+000A".
std::optional<std::string> no_comment(std::string_view text);

/// Whether it is words of printable ASCII with one space between them, as lines of certificates are.
bool is_words(std::string_view text);

/// Whose the name is already, "a keyword of C++", by docs/taken-names.json.
std::optional<std::string> owner_of_name(std::string_view name);

/// Whether an operation of restrip (tables/operations) has this name, and the description is another one.
bool is_other_operation(std::string_view name, const JsonValue& description);

}  // namespace restrip::verify
