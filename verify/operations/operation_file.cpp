#include "operation_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "json_value.hpp"
#include "words.hpp"

namespace restrip::verify::operations {
namespace {

bool is_name(std::string_view text) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !text.empty() && text.size() <= longest_name && text.front() >= 'a' && text.front() <= 'z' &&
         text.back() != '-' && text.find("--") == std::string_view::npos && std::all_of(text.begin(), text.end(), fits);
}

Side side_of(const JsonValue& value) {
  value.expect_object({"triangles", "edges", "ports"});
  Side side;
  side.triangles = static_cast<unsigned>(value.required("triangles").integer(1, most_triangles, "a number"));
  std::vector<unsigned> used(side.triangles);
  const auto use = [&](const JsonValue& where, unsigned triangle) {
    if (++used[triangle] > 3)
      where.fail_found(
          fmt::format("expected at most three edges and ports of triangle {}, this is the fourth", triangle));
  };
  const auto triangle_at = [&](const JsonValue& where) { return where.index(side.triangles, "a triangle"); };

  const JsonValue edges = value.required("edges");
  std::set<std::array<unsigned, 2>> seen;
  for (const JsonValue& edge : edges.list("a list of at most 19 edges, pairs of triangles", most_colors - 1)) {
    const std::vector<JsonValue> ends = edge.list("a pair of triangles", 2);
    if (ends.size() != 2) edge.fail_found("expected a pair of triangles");
    const std::array<unsigned, 2> pair = {triangle_at(ends[0]), triangle_at(ends[1])};
    if (pair[0] == pair[1]) edge.fail_found(fmt::format("expected two different triangles, found {} twice", pair[0]));
    if (!seen.insert({std::min(pair[0], pair[1]), std::max(pair[0], pair[1])}).second)
      edge.fail_found(fmt::format("expected each edge once, {} and {} are joined above", pair[0], pair[1]));
    use(ends[0], pair[0]);
    use(ends[1], pair[1]);
    side.edges.push_back(pair);
  }
  const JsonValue ports = value.required("ports");
  for (const JsonValue& port : ports.list("a list of 1 to 8 ports, the triangle of each", most_ports)) {
    side.owner_of_port.push_back(triangle_at(port));
    use(port, side.owner_of_port.back());
  }
  if (side.ports() == 0) ports.fail_found("expected a list of 1 to 8 ports, found none");
  if (side.inner_edges() + side.ports() > most_colors)
    edges.fail_found(fmt::format("expected at most {} edges and ports together, found {} and {}", most_colors,
                                 side.inner_edges(), side.ports()));
  return side;
}

Mask give_up_of(const JsonValue& value, unsigned ports) {
  if (value.is_list()) return value.set_of(ports, "port");
  const std::string expected = "\"none\", \"all\" or a list of ports";
  const std::string word = value.string(expected);
  if (word != "none" && word != "all") value.fail(expected);
  return word == "all" ? mask_count(ports) - 1 : 0;
}

/// A text for people, which stands in a comment of the table.
std::string sentence_of(const JsonValue& value) {
  const std::string text = value.string("a sentence in quotes");
  if (const std::optional<std::string> stranger = no_comment(text))
    value.fail_found(
        fmt::format("expected words that can stand in a comment, found {}; write the sentence without", *stranger));
  return text;
}

/// How many members there are of what a count may be restricted to.
unsigned members(Among among, const Side& after) {
  return among == Among::edges ? after.inner_edges() : among == Among::triangles ? after.triangles : after.ports();
}

Term term_of(const JsonValue& value, const Side& after) {
  value.expect_object({"count", "weight", "edges", "triangles", "ports"});
  Term term;
  term.count = static_cast<Count>(value.required("count").one_of(count_names));
  if (const std::optional<JsonValue> weight = value.member("weight"))
    term.weight = weight->integer(-largest_weight, largest_weight, "an integer");
  const Among own = among_of(term.count);
  if (own != Among::nothing) term.among = mask_count(members(own, after)) - 1;
  for (const Among among : {Among::edges, Among::triangles, Among::ports}) {
    const std::string name(among_names[static_cast<std::size_t>(among)]);
    const std::optional<JsonValue> chosen = value.member(name);
    if (!chosen) continue;
    if (among != own)
      chosen->fail_found(fmt::format("unknown member, \"{}\" is not counted among {}",
                                     count_names[static_cast<std::size_t>(term.count)], name));
    term.among = chosen->set_of(members(among, after), name.substr(0, name.size() - 1));
  }
  return term;
}

std::vector<Criterion> default_cost(Constraint constraint) {
  std::vector<Criterion> cost = {{{Count::strips}}, {{Count::isolated}, {Count::given_up}}, {{Count::given_up}}};
  if (constraint == Constraint::matching) cost.erase(cost.begin());
  return cost;
}

std::vector<Criterion> cost_of(const JsonValue& value, const Side& after) {
  std::vector<Criterion> cost;
  for (const JsonValue& criterion :
       value.list(fmt::format("a list of 1 to {} criteria", most_criteria), most_criteria)) {
    cost.emplace_back();
    for (const JsonValue& term : criterion.list(fmt::format("a list of 1 to {} terms", most_terms), most_terms))
      cost.back().push_back(term_of(term, after));
    if (cost.back().empty())
      criterion.fail_found(fmt::format("expected a list of 1 to {} terms, found none", most_terms));
  }
  if (cost.empty()) value.fail_found(fmt::format("expected a list of 1 to {} criteria, found none", most_criteria));
  return cost;
}

}  // namespace

unsigned OperationFile::most_solid() const {
  switch (constraint) {
    case Constraint::strips:
      return 2;
    case Constraint::matching:
      return 1;
    case Constraint::forest:
      break;
  }
  return 3;
}

bool may_have_reasons(const OperationFile& operation) {
  const std::vector<Criterion> first = {
      {{Count::strips, 1, 0}}, {{Count::isolated, 1, 0}, {Count::given_up, 1, 0}}, {{Count::given_up, 1, 0}}};
  return operation.constraint != Constraint::matching && operation.cost.size() >= first.size() &&
         std::equal(first.begin(), first.end(), operation.cost.begin());
}

OperationFile parse_operation_file(const std::string& file, std::string_view text) {
  const Json json = parse_json(file, text);
  const JsonValue whole(file, json, {});
  if (const std::optional<JsonValue> take = whole.member("take"))
    take->fail_found("no port can be taken, since a rule does not see the triangle behind a dashed port");
  whole.expect_object({"restrip_operation", "name", "about", "constraint", "before", "after", "give_up", "cost"});
  const JsonValue version = whole.required("restrip_operation");
  if (!version.is_integer(1)) version.fail("1, the version of the format");
  OperationFile operation;
  const JsonValue name = whole.required("name");
  operation.name = name.string("a name");
  if (!is_name(operation.name))
    name.fail(fmt::format("at most {} lower-case letters, digits and single hyphens between them, a letter first",
                          longest_name));
  if (const std::optional<std::string> owner = owner_of_name(operation.name))
    name.fail_found(
        fmt::format("expected a name that is free, \"{0}\" is {1}; \"my-{0}\" would do", operation.name, *owner));
  if (const std::optional<JsonValue> about = whole.member("about")) operation.about = sentence_of(*about);
  operation.constraint = static_cast<Constraint>(whole.required("constraint").one_of(constraint_names));
  operation.before = side_of(whole.required("before"));
  const JsonValue after = whole.required("after");
  operation.after = side_of(after);
  if (operation.after.ports() != operation.before.ports())
    after.required("ports").fail_found(fmt::format("expected as many ports as before, {}, found {}",
                                                   operation.before.ports(), operation.after.ports()));
  if (const std::optional<JsonValue> give_up = whole.member("give_up"))
    operation.may_give_up = give_up_of(*give_up, operation.ports());
  const std::optional<JsonValue> cost = whole.member("cost");
  operation.cost = cost ? cost_of(*cost, operation.after) : default_cost(operation.constraint);
  return operation;
}

}  // namespace restrip::verify::operations
