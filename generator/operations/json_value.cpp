#include "operations/json_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "operations/emitted_words.hpp"

namespace restrip::generator {

Json parse_json(const std::string& file, const std::string& text) {
  if (text.starts_with("\xef\xbb\xbf"))  // which the parser would skip
    throw std::runtime_error(
        fmt::format("{}:1: the file begins with a byte order mark; save it as UTF-8 without one", file));
  // The last of two members of one name would silently win.
  std::vector<std::set<std::string>> members;
  std::string twice;
  const auto look = [&](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) members.emplace_back();
    if (event == Json::parse_event_t::object_end) members.pop_back();
    if (event == Json::parse_event_t::key && !members.back().insert(value.get<std::string>()).second)
      twice = value.get<std::string>();
    return true;
  };
  try {
    Json json = Json::parse(text, look);
    if (!twice.empty())
      throw std::runtime_error(fmt::format("{}: the member \"{}\" is there twice", file, printable(twice)));
    return json;
  } catch (const Json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    throw std::runtime_error(fmt::format("{}:{}: this is not JSON: {}", file, line, printable(error.what())));
  }
}

void JsonValue::refuse(const std::string& what) const {
  std::string place;
  for (const JsonStep& step : path_)
    place += step.member.empty() ? fmt::format("[{}]", step.element) : (place.empty() ? "" : ".") + step.member;
  throw std::runtime_error(fmt::format("{}:{}: {}{}{}", file_, line_of(text_, path_), printable(place),
                                       place.empty() ? "" : ": ", printable(what)));
}

JsonValue JsonValue::operator[](const std::string& member) const {
  if (!has(member)) refuse(fmt::format("expected a member \"{}\"", member));
  return inside(json_.at(member), {member, 0});
}

std::vector<std::string> JsonValue::members() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : json_.items()) names.push_back(name);
  return names;
}

std::vector<JsonValue> JsonValue::elements(const std::string& of_what) const {
  if (!json_.is_array()) refuse(fmt::format("expected a list of {}", of_what));
  std::vector<JsonValue> values;
  for (std::size_t i = 0; i < json_.size(); ++i) values.push_back(inside(json_[i], {"", i}));
  return values;
}

std::string JsonValue::text() const {
  if (!json_.is_string()) refuse("expected a string");
  return json_.get<std::string>();
}

bool JsonValue::truth() const {
  if (!json_.is_boolean()) refuse("expected true or false");
  return json_.get<bool>();
}

std::int64_t JsonValue::number(std::int64_t least, std::int64_t most, const std::string& what) const {
  const bool whole =
      json_.is_number_integer() && !(json_.is_number_unsigned() && json_.get<std::uint64_t>() > INT64_MAX);
  if (!whole || json_.get<std::int64_t>() < least || json_.get<std::int64_t>() > most)
    refuse(fmt::format("expected {} from {} to {}", what, least, most));
  return json_.get<std::int64_t>();
}

unsigned JsonValue::place(std::size_t count, const std::string& what) const {
  if (count == 0) refuse(fmt::format("there is no {}", what));
  return static_cast<unsigned>(number(0, static_cast<std::int64_t>(count) - 1, "a " + what));
}

void JsonValue::expect_members(const std::vector<std::string>& known) const {
  if (!json_.is_object()) refuse("expected an object");
  for (const auto& [name, value] : json_.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      inside(value, {name, 0}).refuse(fmt::format("unknown member; expected one of {}", fmt::join(known, ", ")));
}

JsonValue JsonValue::inside(const Json& json, JsonStep step) const {
  std::vector<JsonStep> path = path_;
  path.push_back(std::move(step));
  return {file_, text_, json, std::move(path)};
}

}  // namespace restrip::generator
