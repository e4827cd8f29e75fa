#pragma once
// JSON as operation files use it, read by nlohmann's parser: every value knows where it stands, so that errors can name
// the place. Numbers other than integers are read, and distinguished. A member that stands twice is an error.

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
  std::string text;         ///< of a string; otherwise what stands in the file
  std::vector<Json> items;  ///< of an array, or the values of an object's members
  std::vector<Name> names;  ///< of an object's members

  /// What it is, for errors: "3", "\"abc\"", "a list", "an object".
  std::string described() const;
  /// Whether both say the same, wherever it stands.
  bool same_as(const Json& other) const;
};

/// InputError naming file, line and column when the text is not JSON or nests deeper than operation files do.
Json parse_json(const std::string& file, std::string_view text);

/// The text with every byte that is not printable ASCII as \x1b: a file's words may tell a terminal anything.
std::string shown(std::string_view text);

/// Throws InputError "file:line:column: what", as it is shown.
[[noreturn]] void fail_at(const std::string& file, TextPlace place, const std::string& what);

}  // namespace restrip::verify
