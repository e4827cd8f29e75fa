#pragma once
// A value of a JSON file with its path, so that errors name both. Readers request what they expect; anything else is an
// InputError.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/json.hpp"
#include "model/masks.hpp"

namespace restrip::verify {

/// "\"a\", \"b\" or \"c\"".
template <std::size_t n>
std::string listed_names(const std::array<std::string_view, n>& names) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i)
    text += fmt::format("{}\"{}\"", i == 0 ? "" : (i + 1 == n ? " or " : ", "), names[i]);
  return text;
}

/// A value of the file with the path that leads to it: before.edges[2].
class JsonValue {
 public:
  JsonValue(const std::string& file, const Json& json, std::string path)
      : file_(file), json_(json), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& expected) const {
    fail_found(fmt::format("expected {}, found {}", expected, json_.described()));
  }
  [[noreturn]] void fail_found(const std::string& what) const {
    fail_at(file_, json_.place, path_.empty() ? what : fmt::format("{}: {}", path_, what));
  }

  bool same_as(const Json& json) const { return json_.same_as(json); }
  bool is_string() const { return json_.kind == Json::Kind::string; }
  bool is_object() const { return json_.kind == Json::Kind::object; }
  bool is_list() const { return json_.kind == Json::Kind::array; }
  std::size_t size() const { return json_.items.size(); }
  bool is_integer(std::int64_t number) const { return json_.kind == Json::Kind::integer && json_.integer == number; }

  /// The members that may occur here; a member is unknown unless it is listed.
  void expect_object(std::initializer_list<std::string_view> known) const {
    if (json_.kind != Json::Kind::object) fail("an object");
    for (const Json::Name& name : json_.names)
      if (std::find(known.begin(), known.end(), name.text) == known.end())
        fail_at(file_, name.place,
                fmt::format("{}: unknown member, expected {}", path_.empty() ? name.text : path_ + '.' + name.text,
                            fmt::join(known, ", ")));
  }

  std::optional<JsonValue> member(std::string_view name) const {
    for (std::size_t i = 0; i < json_.names.size(); ++i)
      if (json_.names[i].text == name)
        return JsonValue(file_, json_.items[i], path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name));
    return {};
  }
  JsonValue required(std::string_view name) const {
    if (std::optional<JsonValue> found = member(name)) return *std::move(found);
    fail_found(fmt::format("expected a member \"{}\"", name));
  }

  std::vector<JsonValue> list(const std::string& expected, std::size_t most) const {
    if (json_.kind != Json::Kind::array) fail(expected);
    if (json_.items.size() > most)
      fail_found(fmt::format("expected {}, found a list of {}", expected, json_.items.size()));
    std::vector<JsonValue> values;
    for (std::size_t i = 0; i < json_.items.size(); ++i) values.push_back(item(i));
    return values;
  }

  /// An element of a list; it must exist.
  JsonValue item(std::size_t place) const {
    return JsonValue(file_, json_.items.at(place), fmt::format("{}[{}]", path_, place));
  }

  std::int64_t integer(std::int64_t low, std::int64_t high, const std::string& what) const {
    if (json_.kind != Json::Kind::integer || json_.integer < low || json_.integer > high)
      fail(fmt::format("{} from {} to {}", what, low, high));
    return json_.integer;
  }
  unsigned index(unsigned count, const std::string& what) const {
    return static_cast<unsigned>(integer(0, static_cast<std::int64_t>(count) - 1, what));
  }

  bool boolean(const std::string& what) const {
    if (json_.kind != Json::Kind::boolean) fail(fmt::format("true or false: {}", what));
    return json_.text == "true";
  }
  std::string string(const std::string& expected) const {
    if (!is_string()) fail(expected);
    return json_.text;
  }
  template <std::size_t n>
  std::size_t one_of(const std::array<std::string_view, n>& names) const {
    const auto found = is_string() ? std::find(names.begin(), names.end(), json_.text) : names.end();
    if (found == names.end()) fail(listed_names(names));
    return static_cast<std::size_t>(found - names.begin());
  }

  /// Different numbers below `count`, as a mask.
  Mask set_of(unsigned count, const std::string& what) const {
    Mask mask = 0;
    for (const JsonValue& value : list(fmt::format("a list of {}s", what), count)) {
      const unsigned number = value.index(count, what + "s");
      if (is_solid(mask, number))
        value.fail_found(fmt::format("expected each {} once, {} is listed above", what, number));
      mask |= single(number);
    }
    return mask;
  }

 private:
  const std::string& file_;
  const Json& json_;
  std::string path_;
};

}  // namespace restrip::verify
