// A value of a JSON file with its place, so that every refusal names file, line and member.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace restrip::generator {

/// Members stay in the order of the file.
using Json = nlohmann::ordered_json;

/// A file, and the first line of each of its values by path: "after.ring[3]", and "" for the whole.
struct JsonFile {
  std::string name;
  Json json;
  std::map<std::string, std::size_t> lines;
};

/// Throws std::runtime_error, naming file and line, if the text is not JSON, has a duplicate member, or exceeds a limit
/// of docs/reference/operation-file.md.
[[nodiscard]] JsonFile parse_json(const std::string& file, const std::string& text);

class JsonValue {
 public:
  /// The whole file, which must outlive it.
  explicit JsonValue(const JsonFile& file) : JsonValue(file, file.json, "") {}

  [[noreturn]] void refuse(const std::string& what) const;
  /// The beginning of errors about it: "f.json:4: after.ring[3]: ".
  [[nodiscard]] std::string where() const;

  [[nodiscard]] bool has(const std::string& member) const { return json_.contains(member); }
  [[nodiscard]] bool operator==(const Json& json) const { return json_ == json; }
  [[nodiscard]] bool is_text() const { return json_.is_string(); }
  [[nodiscard]] bool is_list() const { return json_.is_array(); }
  [[nodiscard]] JsonValue operator[](const std::string& member) const;
  /// The names of the members, in order.
  [[nodiscard]] std::vector<std::string> members() const;
  [[nodiscard]] std::vector<JsonValue> elements(const std::string& of_what) const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool truth() const;
  /// An integer from `least` to `most`; `what` names it.
  [[nodiscard]] std::int64_t number(std::int64_t least, std::int64_t most, const std::string& what) const;
  /// An index from 0 to count - 1.
  [[nodiscard]] unsigned place(std::size_t count, const std::string& what) const;
  void expect_members(const std::vector<std::string>& known) const;

 private:
  JsonValue(const JsonFile& file, const Json& json, std::string path)
      : file_(file), json_(json), path_(std::move(path)) {}

  const JsonFile& file_;
  const Json& json_;
  std::string path_;
};

}  // namespace restrip::generator
