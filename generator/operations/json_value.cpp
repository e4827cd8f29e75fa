#include "operations/json_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <istream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "operations/emitted_words.hpp"

namespace restrip::generator {
namespace {

std::string path_of(const std::string& object, const std::string& member) {
  return object.empty() ? member : object + "." + member;
}
std::string path_of(const std::string& list, std::size_t place) { return fmt::format("{}[{}]", list, place); }

/// Limits of docs/reference/operation-file.md. Without them the paths of a small file would take gigabytes.
constexpr std::size_t deepest = 8;
constexpr std::size_t most_members = 64;
constexpr std::size_t longest_member = 60;

/// Follows the parser through a text. The parser reports values without places, but its read position is known.
class Follower {
 public:
  Follower(JsonFile& file, std::istream& text, const std::string& whole) : file_(file), text_(text), whole_(whole) {}

  bool operator()(int /*depth*/, Json::parse_event_t event, Json& value) {
    using Event = Json::parse_event_t;
    if (event == Event::key) {
      Open& object = open_.back();
      const std::string name = value.get<std::string>();
      object.path_inside = path_of(object.path, name);
      if (name.size() > longest_member)
        refuse(fmt::format("expected names of members of at most {} bytes, found \"{}\"", longest_member, name));
      // Otherwise the last of two members of one name would silently win.
      if (!object.members.insert(object.path_inside).second) refuse(fmt::format("duplicate member \"{}\"", name));
      if (object.members.size() > most_members)
        refuse(fmt::format("expected at most {} members of an object", most_members));
    } else if (event == Event::object_end || event == Event::array_end) {
      open_.pop_back();
    } else {
      std::string path;
      if (!open_.empty())
        path = open_.back().is_list ? path_of(open_.back().path, open_.back().elements++) : open_.back().path_inside;
      file_.lines.emplace(path, line());
      if (event == Event::value) return true;
      if (open_.size() == deepest)
        refuse(fmt::format("expected lists and objects at most {} deep inside one another", deepest));
      open_.push_back({path, event == Event::array_start, 0, {}, {}});
    }
    return true;
  }

 private:
  struct Open {
    std::string path;
    bool is_list = false;
    std::size_t elements = 0;
    std::string path_inside;  ///< of the next member
    std::set<std::string> members;
  };

  [[noreturn]] void refuse(const std::string& what) {
    throw std::runtime_error(fmt::format("{}:{}: {}", file_.name, line(), printable(what)));
  }

  /// The line of the last token: the parser has read it and, after a number, one more character.
  std::size_t line() {
    const auto read = static_cast<std::ptrdiff_t>(text_.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in));
    const std::ptrdiff_t end = std::max(read - 1, counted_);
    line_ += static_cast<std::size_t>(std::count(whole_.begin() + counted_, whole_.begin() + end, '\n'));
    counted_ = end;
    return line_;
  }

  JsonFile& file_;
  std::istream& text_;
  const std::string& whole_;
  std::vector<Open> open_;
  std::ptrdiff_t counted_ = 0;
  std::size_t line_ = 1;
};

}  // namespace

JsonFile parse_json(const std::string& file, const std::string& text) {
  if (text.starts_with("\xef\xbb\xbf"))  // the parser would skip it
    throw std::runtime_error(
        fmt::format("{}:1: the file begins with a byte order mark; save it as UTF-8 without one", file));
  JsonFile parsed{file, {}, {}};
  std::istringstream stream(text);
  Follower follower(parsed, stream, text);
  try {
    parsed.json = Json::parse(stream, std::ref(follower));
  } catch (const Json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    throw std::runtime_error(fmt::format("{}:{}: this is not JSON: {}", file, line, printable(error.what())));
  }
  return parsed;
}

std::string JsonValue::where() const {
  return fmt::format("{}:{}: {}{}", file_.name, file_.lines.at(path_), printable(path_), path_.empty() ? "" : ": ");
}

void JsonValue::refuse(const std::string& what) const { throw std::runtime_error(where() + printable(what)); }

JsonValue JsonValue::operator[](const std::string& member) const {
  if (!has(member)) refuse(fmt::format("expected a member \"{}\"", member));
  return {file_, json_.at(member), path_of(path_, member)};
}

std::vector<std::string> JsonValue::members() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : json_.items()) names.push_back(name);
  return names;
}

std::vector<JsonValue> JsonValue::elements(const std::string& of_what) const {
  constexpr std::size_t most = 64;
  if (!json_.is_array()) refuse(fmt::format("expected a list of {}", of_what));
  if (json_.size() > most)
    refuse(fmt::format("expected a list of at most {} {}, found {}", most, of_what, json_.size()));
  std::vector<JsonValue> values;
  for (std::size_t i = 0; i < json_.size(); ++i) values.push_back({file_, json_[i], path_of(path_, i)});
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
  if (count == 0) refuse(fmt::format("the patch has no {}", what));
  return static_cast<unsigned>(number(0, static_cast<std::int64_t>(count) - 1, "a " + what));
}

void JsonValue::expect_members(const std::vector<std::string>& known) const {
  if (!json_.is_object()) refuse("expected an object");
  for (const auto& [name, value] : json_.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      (*this)[name].refuse(fmt::format("unknown member; expected one of {}", fmt::join(known, ", ")));
}

}  // namespace restrip::generator
