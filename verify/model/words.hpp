#pragma once
// Checks words of an operation file that appear in generated files: docs/reference/operation-file.md, "Words".

#include <optional>
#include <string>
#include <string_view>

#include "common/json.hpp"

namespace restrip::verify {

/// A part of valid UTF-8 text that cannot stand in a comment of every language, such as "the character U+000A".
std::optional<std::string> no_comment(std::string_view text);

/// Whether it consists of words of printable ASCII separated by one space, like lines of certificates.
bool is_words(std::string_view text);

/// The owner of a taken name, "a keyword of C++", by docs/taken-names.json.
std::optional<std::string> owner_of_name(std::string_view name);

/// Whether an operation of restrip (tables/operations) has this name but another description.
bool is_other_operation(std::string_view name, const JsonValue& description);

}  // namespace restrip::verify
