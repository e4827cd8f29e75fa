#include "meshes/json_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/bad_input.hpp"

namespace restrip::tools {
namespace {

/// Builds the tree from the events of nlohmann-json's parser. (Its tree ends the program if memory runs out during
/// destruction.)
class TreeBuilder {
 public:
  explicit TreeBuilder(const std::string& name) : name_(name) {}

  // The parser requires these names and types.
  bool null() { return put({nullptr}); }
  bool boolean(bool value) { return put({value}); }
  bool number_integer(std::int64_t value) { return put({static_cast<double>(value)}); }
  bool number_unsigned(std::uint64_t value) { return put({static_cast<double>(value)}); }
  bool number_float(double value, const std::string& /*text*/) { return put({value}); }
  bool string(std::string& value) { return put({std::move(value)}); }
  bool binary(std::vector<std::uint8_t>& /*value*/) { return false; }  // textual JSON has none
  bool start_object(std::size_t /*size*/) { return open({std::vector<JsonMember>()}); }
  bool start_array(std::size_t /*size*/) { return open({std::vector<JsonValue>()}); }
  bool end_object() {
    auto& members = std::get<std::vector<JsonMember>>(open_.back()->is);
    std::stable_sort(members.begin(), members.end(),
                     [](const JsonMember& a, const JsonMember& b) { return a.name < b.name; });
    return close();
  }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    std::get<std::vector<JsonMember>>(open_.back()->is).push_back({std::move(name), {}});
    return true;
  }
  bool parse_error(std::size_t byte, const std::string& /*token*/, const nlohmann::json::exception& /*error*/) {
    throw BadInput(fmt::format("{}: byte {} of its JSON cannot be read; is it complete?", name_, byte));
  }

  [[nodiscard]] JsonValue take() && { return std::move(root_); }

 private:
  JsonValue& place(JsonValue&& value) {
    if (++count_ > most_json_values)
      throw BadInput(fmt::format("{}: its JSON has more than {} values, the limit; keep numbers in a buffer", name_,
                                 most_json_values));
    if (open_.empty()) return root_ = std::move(value);
    if (auto* array = std::get_if<std::vector<JsonValue>>(&open_.back()->is))
      return array->emplace_back(std::move(value));
    return std::get<std::vector<JsonMember>>(open_.back()->is).back().value = std::move(value);
  }
  bool put(JsonValue&& value) {
    place(std::move(value));
    return true;
  }
  bool open(JsonValue&& value) {
    if (open_.size() == deepest_json)
      throw BadInput(fmt::format("{}: its JSON is nested more than {} deep, the limit", name_, deepest_json));
    open_.push_back(&place(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  const std::string& name_;
  JsonValue root_;
  std::vector<JsonValue*> open_;  // an array or object grows only while it is the last of these
  std::size_t count_ = 0;
};

}  // namespace

JsonValue parse_json(std::string_view text, const std::string& name) {
  TreeBuilder builder(name);
  nlohmann::json::sax_parse(text, &builder);
  return std::move(builder).take();
}

void JsonPlace::refuse(const std::string& why) const {
  throw BadInput(fmt::format("{}: {} {}{}", *file_, path_.empty() ? "its JSON" : path_, why, remedy_));
}

template <class Kind>
const Kind& JsonPlace::as(const char* kind) const {
  if (!there()) refuse("is missing");
  const Kind* value = std::get_if<Kind>(&value_->is);
  if (value == nullptr)
    refuse(fmt::format("is not {} {}", std::string_view("aeiou").find(kind[0]) == std::string_view::npos ? "a" : "an",
                       kind));
  return *value;
}

JsonPlace JsonPlace::operator[](std::string_view member) const {
  JsonPlace found = *this;
  found.value_ = nullptr;
  if (!found.path_.empty()) found.path_ += '.';
  found.path_ += member;
  if (!there()) return found;
  const auto& members = as<std::vector<JsonMember>>("object");
  const auto after = std::upper_bound(members.begin(), members.end(), member,
                                      [](std::string_view name, const JsonMember& other) { return name < other.name; });
  if (after != members.begin() && after[-1].name == member) found.value_ = &after[-1].value;
  return found;
}

std::vector<std::string> JsonPlace::members() const {
  std::vector<std::string> names;
  if (!there()) return names;
  for (const JsonMember& member : as<std::vector<JsonMember>>("object")) names.push_back(member.name);
  return names;
}

std::size_t JsonPlace::size() const { return there() ? as<std::vector<JsonValue>>("array").size() : 0; }

JsonPlace JsonPlace::at(std::uint64_t index) const {
  if (index >= size()) refuse(fmt::format("has no element {}, only {}", index, size()));
  JsonPlace found = *this;
  found.value_ = &as<std::vector<JsonValue>>("array")[static_cast<std::size_t>(index)];
  found.path_ += fmt::format("[{}]", index);
  return found;
}

double JsonPlace::number() const { return as<double>("number"); }

std::uint64_t JsonPlace::whole() const {
  constexpr double exact = 9007199254740992.0;
  const double value = number();
  if (!(value >= 0) || value >= exact || value != std::floor(value)) refuse("is not a whole number, or too large");
  return static_cast<std::uint64_t>(value);
}

bool JsonPlace::boolean_or(bool other) const { return there() ? as<bool>("truth value") : other; }

const std::string& JsonPlace::text() const { return as<std::string>("text"); }

}  // namespace restrip::tools
