// Reads JSON within limits given by the caller. A value knows its place in the file and the members that lead to it. A
// reader states what it expects; anything else is refused with a files::FileError
// "FILE:LINE:COLUMN: after.ring[3]: expected ..., found ...".
//
// nlohmann-json parses; its tree is not used, because it takes more memory and ends the program if memory runs out
// during destruction. Here a value takes 32 bytes in one array, and texts stay in the text of the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace restrip {

struct JsonFile;
struct JsonNode;

/// Limits on a file, without which a small one could take gigabytes.
struct JsonLimits {
  static constexpr std::size_t none = std::numeric_limits<std::uint32_t>::max();

  std::size_t deepest = none;         ///< lists and objects inside one another
  std::size_t most_values = none;     ///< also members
  std::size_t most_members = none;    ///< of an object
  std::size_t longest_member = none;  ///< bytes of a name
  /// Refuses byte order marks and duplicate members. Otherwise the last of them counts, and members are sorted by name.
  bool strict = true;
  /// Errors state line and column; otherwise the byte, for JSON inside another file, which zero bytes may fill up.
  bool has_lines = true;
};

/// The limits of docs/reference/operation-file.md.
inline constexpr JsonLimits operation_file_limits{.deepest = 8, .most_members = 64, .longest_member = 60};

/// A value, or the place of a missing one. It keeps its file in memory. Except as stated, functions refuse a missing
/// value and one of another kind.
class JsonValue {
 public:
  /// A missing value of no file.
  JsonValue() = default;

  /// The beginning of errors about it: "f.json:4:17: after.ring[3]: ". Lines and columns count from 1, columns in
  /// bytes.
  [[nodiscard]] std::string where() const;
  [[nodiscard]] const std::string& file() const;
  [[noreturn]] void refuse(const std::string& what) const;
  /// Refuses it: "expected WHAT, found 3".
  [[noreturn]] void expected(const std::string& what) const;

  /// Whether the content is the same, with all members in the same order.
  [[nodiscard]] bool operator==(const JsonValue& other) const;
  /// Whether it exists.
  [[nodiscard]] bool there() const noexcept { return there_; }
  [[nodiscard]] bool is_text() const;
  [[nodiscard]] bool is_list() const;

  /// A member of an object; a missing value if it or the object does not exist. Takes O(log n) steps in lenient files.
  [[nodiscard]] JsonValue operator[](std::string_view member) const;
  [[nodiscard]] bool has(std::string_view member) const;
  [[nodiscard]] std::optional<JsonValue> member(std::string_view name) const;
  /// The names of the members, in the order of the file, in lenient files by name; empty if the object is missing.
  [[nodiscard]] std::vector<std::string> members() const;
  /// Refuses everything but an object with some of these members.
  void expect_members(std::initializer_list<std::string_view> known) const;

  /// The number of elements of a list; 0 if it is missing.
  [[nodiscard]] std::size_t size() const;
  /// An element of a list. Refuses an index that is too large.
  [[nodiscard]] JsonValue at(std::uint64_t index) const;
  /// The values of a list, which `what` names; 64 at most if the page states no other limit.
  [[nodiscard]] std::vector<JsonValue> elements(std::string_view what, std::size_t least = 0,
                                                std::size_t most = 64) const;

  [[nodiscard]] std::string text(const std::string& what = "a text") const { return std::string(view(what)); }
  /// The same without a copy, while a value of this file exists.
  [[nodiscard]] std::string_view view(const std::string& what = "a text") const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] bool truth_or(bool other) const { return there_ ? truth() : other; }
  /// The index of a text in the list.
  [[nodiscard]] std::size_t one_of(std::span<const std::string_view> texts) const;
  std::int64_t number(std::int64_t least, std::int64_t most, std::string_view what) const;
  /// Any number.
  [[nodiscard]] double real() const;
  /// A whole number below 2^53, the range of exact integers in JSON; 3.0 is one.
  [[nodiscard]] std::uint64_t whole() const;
  [[nodiscard]] std::uint64_t whole_or(std::uint64_t other) const { return there_ ? whole() : other; }
  /// The index of one of `count` things.
  [[nodiscard]] unsigned place(std::size_t count, std::string_view what) const;
  /// A list of different ones.
  [[nodiscard]] std::vector<unsigned> places(std::size_t count, std::string_view what) const;

 private:
  friend JsonValue parse_json(const std::string& file, std::string_view text, const JsonLimits& limits);
  JsonValue(std::shared_ptr<const JsonFile> file, const JsonNode& node, std::string path)
      : file_(std::move(file)), node_(&node), path_(std::move(path)), there_(true) {}
  /// Refuses a missing value.
  [[nodiscard]] const JsonNode& node() const;
  /// The elements or members; none of other kinds.
  [[nodiscard]] std::span<const JsonNode> items() const;
  [[nodiscard]] const JsonNode* find(std::string_view member) const;

  std::shared_ptr<const JsonFile> file_;
  const JsonNode* node_ = nullptr;  ///< of the file; of a missing value the nearest that exists
  std::string path_;                ///< to that node
  std::string missing_;             ///< from there
  bool there_ = false;
};

/// The value of a whole text, a copy of which it keeps. `file` is used in errors only. Refuses what is not JSON, what
/// exceeds a limit, and texts of 4 GiB and more.
[[nodiscard]] JsonValue parse_json(const std::string& file, std::string_view text,
                                   const JsonLimits& limits = operation_file_limits);

}  // namespace restrip
