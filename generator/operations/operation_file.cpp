#include "operations/operation_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "files/reading.hpp"
#include "operations/emitted_words.hpp"
#include "operations/json_line.hpp"
#include "operations/operation_words.hpp"

namespace restrip::generator {
namespace {

using Json = nlohmann::json;

/// A value in the file, which knows where it stands.
class JsonValue {
 public:
  JsonValue(const std::string& file, const std::string& text, const Json& json, std::vector<JsonStep> path = {})
      : file_(file), text_(text), json_(json), path_(std::move(path)) {}

  [[noreturn]] void refuse(const std::string& what) const {
    std::string place;
    for (const JsonStep& step : path_)
      place += step.member.empty() ? fmt::format("[{}]", step.element) : (place.empty() ? "" : ".") + step.member;
    throw std::runtime_error(fmt::format("{}:{}: {}{}{}", file_, line_of(text_, path_), printable(place),
                                         place.empty() ? "" : ": ", printable(what)));
  }

  [[nodiscard]] bool has(const std::string& member) const { return json_.contains(member); }
  [[nodiscard]] bool is_text() const { return json_.is_string(); }
  [[nodiscard]] JsonValue operator[](const std::string& member) const {
    if (!has(member)) refuse(fmt::format("expected a member \"{}\"", member));
    return inside(json_.at(member), {member, 0});
  }
  [[nodiscard]] std::vector<JsonValue> elements(const std::string& of_what) const {
    if (!json_.is_array()) refuse(fmt::format("expected a list of {}", of_what));
    std::vector<JsonValue> values;
    for (std::size_t i = 0; i < json_.size(); ++i) values.push_back(inside(json_[i], {"", i}));
    return values;
  }
  [[nodiscard]] std::string text() const {
    if (!json_.is_string()) refuse("expected a string");
    return json_.get<std::string>();
  }
  /// A whole number from `least` to `most`; `what` names it.
  [[nodiscard]] std::int64_t number(std::int64_t least, std::int64_t most, const std::string& what) const {
    const bool whole =
        json_.is_number_integer() && !(json_.is_number_unsigned() && json_.get<std::uint64_t>() > INT64_MAX);
    if (!whole || json_.get<std::int64_t>() < least || json_.get<std::int64_t>() > most)
      refuse(fmt::format("expected {} from {} to {}", what, least, most));
    return json_.get<std::int64_t>();
  }
  /// One of the places 0 … count - 1.
  [[nodiscard]] unsigned place(std::size_t count, const std::string& what) const {
    if (count == 0) refuse(fmt::format("there is no {}", what));
    return static_cast<unsigned>(number(0, static_cast<std::int64_t>(count) - 1, "a " + what));
  }
  void expect_members(const std::vector<std::string>& known) const {
    if (!json_.is_object()) refuse("expected an object");
    for (const auto& [name, value] : json_.items())
      if (std::find(known.begin(), known.end(), name) == known.end())
        inside(value, {name, 0}).refuse(fmt::format("unknown member; expected one of {}", fmt::join(known, ", ")));
  }

 private:
  [[nodiscard]] JsonValue inside(const Json& json, JsonStep step) const {
    std::vector<JsonStep> path = path_;
    path.push_back(std::move(step));
    return {file_, text_, json, std::move(path)};
  }

  const std::string& file_;
  const std::string& text_;
  const Json& json_;
  std::vector<JsonStep> path_;
};

Json json_of(const std::string& file, const std::string& text) {
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

std::string name_from(const JsonValue& value) {
  std::string name = value.text();
  const auto allowed = [](char c) { return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '-'; };
  const bool good = !name.empty() && name.size() <= 60 && 'a' <= name.front() && name.front() <= 'z' &&
                    name.back() != '-' && name.find("--") == std::string::npos &&
                    std::all_of(name.begin(), name.end(), allowed);
  if (!good) value.refuse("expected lower-case letters, digits and single hyphens, a letter first");
  if (const std::string by = name_is(name); !by.empty())
    value.refuse(fmt::format("\"{0}\" is {1}; choose another name, such as \"{0}-own\"", name, by));
  return name;
}

std::string sentence_from(const JsonValue& value) {
  std::string sentence = value.text();
  if (const std::string found = unprintable(sentence); !found.empty())
    value.refuse(
        fmt::format("expected one line that can stand in a comment of any language, found {}; leave it out", found));
  return sentence;
}

Side side_from(const JsonValue& value) {
  value.expect_members({"triangles", "edges", "ports"});
  Side side;
  side.nodes = static_cast<unsigned>(value["triangles"].number(1, most_nodes, "a number of triangles"));
  std::vector<unsigned> degree(side.nodes, 0);
  const auto count = [&](unsigned node, const JsonValue& at) {
    if (++degree[node] > 3) at.refuse(fmt::format("triangle {} has more than three edges and ports", node));
  };
  for (const JsonValue& edge : value["edges"].elements("pairs of triangles")) {
    const std::vector<JsonValue> ends = edge.elements("two triangles");
    if (ends.size() != 2) edge.refuse("expected two triangles");
    const unsigned u = ends[0].place(side.nodes, "triangle");
    const unsigned v = ends[1].place(side.nodes, "triangle");
    if (u == v) edge.refuse("expected two different triangles");
    for (const auto& [a, b] : side.edges)
      if ((a == u && b == v) || (a == v && b == u)) edge.refuse("these triangles have an edge already");
    count(u, edge);
    count(v, edge);
    side.edges.push_back({u, v});
  }
  const JsonValue ports = value["ports"];
  for (const JsonValue& port : ports.elements("triangles, one for each port")) {
    side.owner.push_back(port.place(side.nodes, "triangle"));
    count(side.owner.back(), port);
  }
  if (side.owner.empty() || side.owner.size() > most_ports)
    ports.refuse(fmt::format("expected 1 to {} ports", most_ports));
  if (side.edges.size() + side.owner.size() > most_edges_and_ports)
    value.refuse(fmt::format("expected at most {} edges and ports together", most_edges_and_ports));
  return side;
}

Constraint constraint_from(const JsonValue& value) {
  const auto* const found = std::find(constraint_words.begin(), constraint_words.end(), value.text());
  if (found == constraint_words.end()) value.refuse("expected \"strips\", \"matching\" or \"forest\"");
  return {static_cast<unsigned>(found - constraint_words.begin()) + 1};
}

Mask mask_from(const JsonValue& value, std::size_t count, const std::string& what) {
  Mask mask = 0;
  for (const JsonValue& element : value.elements(what + "s")) {
    const Mask bit = Mask{1} << element.place(count, what);
    if ((mask & bit) != 0) element.refuse(fmt::format("this {} is there already", what));
    mask |= bit;
  }
  return mask;
}

Mask give_up_from(const JsonValue& value, std::size_t ports) {
  if (!value.is_text()) return mask_from(value, ports, "port");
  const std::string word = value.text();
  if (word != "none" && word != "all") value.refuse("expected \"none\", \"all\" or a list of ports");
  return word == "all" ? (Mask{1} << ports) - 1 : 0;
}

Term term_from(const JsonValue& value, const Side& after) {
  value.expect_members({"count", "weight", "edges", "triangles", "ports"});
  const JsonValue name = value["count"];
  const auto known = count_words();
  const auto word = std::find_if(known.begin(), known.end(), [&](const CountWord& w) { return w.word == name.text(); });
  if (word == known.end()) {
    std::vector<std::string> names;
    for (const CountWord& w : known) names.emplace_back(w.word);
    name.refuse(fmt::format("expected one of {}", fmt::join(names, ", ")));
  }
  Term term{word->count};
  constexpr std::int64_t heaviest = 1'000'000;
  if (value.has("weight")) term.weight = value["weight"].number(-heaviest, heaviest, "a weight");
  if (word->among != Among::nothing) term.of = everything(word->among, after);
  for (const Among among : {Among::edges, Among::triangles, Among::ports}) {
    const std::string member = member_of(among);
    if (!value.has(member)) continue;
    if (word->among != among) value[member].refuse(fmt::format("\"{}\" does not choose among {}", word->word, member));
    term.of = mask_from(value[member], how_many(among, after), one_of(among));
  }
  return term;
}

Preference preference_from(const JsonValue& value, const Side& after) {
  Preference preference;
  for (const JsonValue& criterion : value.elements("criteria")) {
    preference.emplace_back();
    for (const JsonValue& term : criterion.elements("terms")) preference.back().push_back(term_from(term, after));
    if (preference.back().empty() || preference.back().size() > most_terms)
      criterion.refuse(fmt::format("expected 1 to {} terms", most_terms));
  }
  if (preference.empty() || preference.size() > most_criteria)
    value.refuse(fmt::format("expected 1 to {} criteria", most_criteria));
  return preference;
}

}  // namespace

NamedOperation parse_operation(const std::string& file, const std::string& text) {
  const Json json = json_of(file, text);
  const JsonValue top(file, text, json);
  if (top.has("take"))
    top["take"].refuse(
        "a dashed port stays dashed: whether it may become solid depends on the triangle behind it, which no rule "
        "sees; "
        "describe that triangle as part of the patch");
  top.expect_members({"restrip_operation", "name", "about", "constraint", "before", "after", "give_up", "cost"});
  static_cast<void>(top["restrip_operation"].number(1, 1, "a version of the format"));
  NamedOperation named;
  named.name = name_from(top["name"]);
  if (top.has("about")) named.about = sentence_from(top["about"]);
  Operation& operation = named.operation;
  operation.constraint = constraint_from(top["constraint"]);
  operation.patch = {side_from(top["before"]), side_from(top["after"])};
  const std::size_t ports = operation.patch.before.owner.size();
  if (operation.patch.after.owner.size() != ports) top["after"]["ports"].refuse("expected as many ports as before");
  if (top.has("give_up")) operation.may_give_up = give_up_from(top["give_up"], ports);
  operation.preference = fewest_strips();
  if (operation.constraint.most_edges == 1) operation.preference.erase(operation.preference.begin());
  if (top.has("cost")) operation.preference = preference_from(top["cost"], operation.patch.after);
  return named;
}

NamedOperation read_operation(const std::string& file) {
  constexpr std::uint64_t longest = 1 << 20;
  return parse_operation(file, files::read_whole(file, {longest, longest}));
}

}  // namespace restrip::generator
