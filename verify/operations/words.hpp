#pragma once
// Words of an operation file that stand in files made from it: docs/operation-file.md, "Words".

#include <optional>
#include <string>
#include <string_view>

namespace restrip::verify::operations {

/// What in a text of valid UTF-8 cannot stand in a comment of every language, such as "a line feed (U+000A)".
std::optional<std::string> no_comment(std::string_view text);

/// Whose the name is already, "a keyword of C++", by docs/taken-names.json.
std::optional<std::string> owner_of_name(std::string_view name);

}  // namespace restrip::verify::operations
