// JSON as a tree of values and places in it. A value of the wrong kind gets a message that names its place
// ("accessors[3].count").
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace restrip::tools {

struct JsonMember;

struct JsonValue {
  std::variant<std::nullptr_t, bool, double, std::string, std::vector<JsonValue>, std::vector<JsonMember>> is;
};

struct JsonMember {
  std::string name;
  JsonValue value;
};

/// Limits on a parsed text; the smallest values take about 50 times their bytes.
inline constexpr std::size_t most_json_values = 20'000'000;
inline constexpr std::size_t deepest_json = 64;

/// Throws BadInput if the text is not JSON or exceeds the limits; `name` is the file.
[[nodiscard]] JsonValue parse_json(std::string_view text, const std::string& name);

/// A value of a tree, or the place of a missing one. The tree and the name of the file must outlive it. Every function
/// throws BadInput if the value has the wrong type.
class JsonPlace {
 public:
  /// `remedy` ends every message; it must outlive the place.
  JsonPlace(const JsonValue& root, const std::string& file, const char* remedy = "")
      : file_(&file), value_(&root), remedy_(remedy) {}

  [[nodiscard]] bool there() const noexcept { return value_ != nullptr; }
  /// A member of an object; a missing value if it does not exist. The last one of several members with one name. O(log
  /// n).
  [[nodiscard]] JsonPlace operator[](std::string_view member) const;
  /// An element of an array. Throws BadInput if the index is out of range.
  [[nodiscard]] JsonPlace at(std::uint64_t index) const;
  /// Elements of an array; 0 if the array is missing.
  [[nodiscard]] std::size_t size() const;

  /// The names of an object's members, in alphabetical order; empty if the object is missing.
  [[nodiscard]] std::vector<std::string> members() const;

  /// Except for functions with a default, these throw BadInput if the value is missing.
  [[nodiscard]] std::uint64_t whole() const;  ///< below 2^53, the range of exact integers in JSON
  [[nodiscard]] std::uint64_t whole_or(std::uint64_t other) const { return there() ? whole() : other; }
  [[nodiscard]] double number() const;
  [[nodiscard]] bool boolean_or(bool other) const;
  [[nodiscard]] const std::string& text() const;

  /// Throws BadInput: the file, this place, and why.
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  template <class Kind>
  [[nodiscard]] const Kind& as(const char* kind) const;

  const std::string* file_;
  const JsonValue* value_;
  const char* remedy_;
  std::string path_;
};

}  // namespace restrip::tools
