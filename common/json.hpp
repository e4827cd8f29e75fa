#pragma once
// Reads JSON within the limits of docs/reference/operation-file.md. A value knows its place in the file and the members
// that lead to it. A reader states what it expects; anything else is refused with a files::FileError
// "FILE:LINE:COLUMN: after.ring[3]: expected ..., found ...".

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace restrip {

struct JsonFile;
struct JsonNode;

/// It keeps its file in memory.
class JsonValue {
 public:
  /// The beginning of errors about it: "f.json:4:17: after.ring[3]: ". Lines and columns count from 1, columns in
  /// bytes.
  [[nodiscard]] std::string where() const;
  [[nodiscard]] const std::string& file() const;
  [[noreturn]] void refuse(const std::string& what) const;
  /// Refuses it: "expected WHAT, found 3".
  [[noreturn]] void expected(const std::string& what) const;

  /// Whether the content is the same, with all members in the same order.
  [[nodiscard]] bool operator==(const JsonValue& other) const;
  [[nodiscard]] bool is_text() const;
  [[nodiscard]] bool is_list() const;

  [[nodiscard]] bool has(std::string_view member) const;
  [[nodiscard]] std::optional<JsonValue> member(std::string_view name) const;
  /// A member that must exist.
  [[nodiscard]] JsonValue operator[](std::string_view member) const;
  /// The names of the members, in the order of the file.
  [[nodiscard]] std::vector<std::string> members() const;
  /// Refuses everything but an object with some of these members.
  void expect_members(std::initializer_list<std::string_view> known) const;

  /// The values of a list, which `what` names; 64 at most if the page states no other limit.
  [[nodiscard]] std::vector<JsonValue> elements(std::string_view what, std::size_t least = 0,
                                                std::size_t most = 64) const;
  [[nodiscard]] std::string text(const std::string& what = "a text") const;
  [[nodiscard]] bool truth() const;
  /// The index of a text in the list.
  [[nodiscard]] std::size_t one_of(std::span<const std::string_view> texts) const;
  std::int64_t number(std::int64_t least, std::int64_t most, std::string_view what) const;
  /// The index of one of `count` things.
  [[nodiscard]] unsigned place(std::size_t count, std::string_view what) const;
  /// A list of different ones.
  [[nodiscard]] std::vector<unsigned> places(std::size_t count, std::string_view what) const;

 private:
  friend JsonValue parse_json(const std::string& file, std::string_view text);
  JsonValue(std::shared_ptr<const JsonFile> file, const JsonNode& node, std::string path);
  [[nodiscard]] std::string path_to(std::string_view member) const;

  std::shared_ptr<const JsonFile> file_;
  const JsonNode* node_;  ///< of the file
  std::string path_;
};

/// The value of a whole file, whose name is only used in errors. Refuses what is not JSON, byte order marks, duplicate
/// members, and what exceeds a limit.
[[nodiscard]] JsonValue parse_json(const std::string& file, std::string_view text);

}  // namespace restrip
