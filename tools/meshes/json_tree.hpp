// JSON as a tree of values, and places in it: whoever reads a value of the wrong kind gets a message that says where it
// stands ("accessors[3].count").
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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

/// Bounds on what is made of a text: it takes some 50 times the bytes of the smallest values.
inline constexpr std::size_t most_json_values = 20'000'000;
inline constexpr std::size_t deepest_json = 64;

/// Throws BadInput where the text is not a JSON or beyond the bounds; `name` is the file.
[[nodiscard]] JsonValue parse_json(std::string_view text, const std::string& name);

/// A value of a tree, or the place where one might stand. The tree and the name of the file must outlive it. Every
/// function throws BadInput if the value has the wrong type.
class JsonPlace {
 public:
  JsonPlace(const JsonValue& root, const std::string& file) : file_(&file), value_(&root) {}

  [[nodiscard]] bool there() const noexcept { return value_ != nullptr; }
  /// A member of an object; of what is not there, nothing. Of several of one name the last. O(log n).
  [[nodiscard]] JsonPlace operator[](std::string_view member) const;
  /// An element of an array. Throws BadInput when there are fewer.
  [[nodiscard]] JsonPlace at(std::uint64_t index) const;
  /// Elements of an array; 0 when it is not there.
  [[nodiscard]] std::size_t size() const;

  /// The names of an object's members, in alphabetical order; none when it is not there.
  [[nodiscard]] std::vector<std::string> members() const;

  /// These throw BadInput when the value is not there, but for those with a default.
  [[nodiscard]] std::uint64_t whole() const;  ///< below 2^53, where JSON's numbers are exact
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
  std::string path_;
};

}  // namespace restrip::tools
