#pragma once
// JSON for operation files, read by nlohmann's parser. Every value knows its place, so that errors can name it. Numbers
// that are not integers are read and distinguished. A duplicate member is an error.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::verify {

/// Counted from 1; columns in bytes.
struct TextPlace {
  unsigned line = 1;
  unsigned column = 1;
};

struct Json {
  enum class Kind { null, boolean, integer, other_number, string, array, object };
  struct Name {
    std::string text;
    TextPlace place;
  };

  Kind kind = Kind::null;
  TextPlace place;
  std::int64_t integer = 0;
  std::string text;         ///< the content of a string; otherwise the source text
  std::vector<Json> items;  ///< of an array, or the values of an object's members
  std::vector<Name> names;  ///< of an object's members

  /// A description for errors: "3", "\"abc\"", "a list", "an object".
  std::string described() const;
  /// Whether both are equal, regardless of their places.
  bool same_as(const Json& other) const;
};

/// Throws InputError naming file, line and column if the text is not JSON or nests deeper than operation files do.
Json parse_json(const std::string& file, std::string_view text);

/// Replaces every byte that is not printable ASCII by \x1b notation, since a file's words may contain terminal
/// commands.
std::string shown(std::string_view text);

/// Throws InputError "file:line:column: what", with `what` made printable.
[[noreturn]] void fail_at(const std::string& file, TextPlace place, const std::string& what);

}  // namespace restrip::verify
