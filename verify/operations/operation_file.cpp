#include "operation_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <set>

#include "json.hpp"

namespace restrip::verify::operations {
namespace {

bool is_name(std::string_view text) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !text.empty() && text.size() <= longest_name && text.front() >= 'a' && text.front() <= 'z' &&
         text.back() != '-' && text.find("--") == std::string_view::npos && std::all_of(text.begin(), text.end(), fits);
}

/// "\"a\", \"b\" or \"c\"".
template <std::size_t n>
std::string listed_names(const std::array<std::string_view, n>& names) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i)
    text += fmt::format("{}\"{}\"", i == 0 ? "" : (i + 1 == n ? " or " : ", "), names[i]);
  return text;
}

/// A value of the file with the path that leads to it: before.edges[2].
class Value {
 public:
  Value(const std::string& file, const Json& json, std::string path)
      : file_(file), json_(json), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& expected) const {
    fail_found(fmt::format("expected {}, found {}", expected, json_.described()));
  }
  [[noreturn]] void fail_found(const std::string& what) const {
    fail_at(file_, json_.place, path_.empty() ? what : fmt::format("{}: {}", path_, what));
  }

  bool is_string() const { return json_.kind == Json::Kind::string; }
  bool is_list() const { return json_.kind == Json::Kind::array; }
  bool is_integer(std::int64_t number) const { return json_.kind == Json::Kind::integer && json_.integer == number; }

  /// Members that may stand here; each is unknown until it is named.
  void expect_object(std::initializer_list<std::string_view> known) const {
    if (json_.kind != Json::Kind::object) fail("an object");
    for (const Json::Name& name : json_.names)
      if (std::find(known.begin(), known.end(), name.text) == known.end())
        fail_at(file_, name.place,
                fmt::format("{}: unknown member, expected {}", path_.empty() ? name.text : path_ + '.' + name.text,
                            fmt::join(known, ", ")));
  }

  std::optional<Value> member(std::string_view name) const {
    for (std::size_t i = 0; i < json_.names.size(); ++i)
      if (json_.names[i].text == name)
        return Value(file_, json_.items[i], path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name));
    return {};
  }
  Value required(std::string_view name) const {
    if (std::optional<Value> found = member(name)) return *std::move(found);
    fail_found(fmt::format("expected a member \"{}\"", name));
  }

  std::vector<Value> list(const std::string& expected, std::size_t most) const {
    if (json_.kind != Json::Kind::array) fail(expected);
    if (json_.items.size() > most)
      fail_found(fmt::format("expected {}, found a list of {}", expected, json_.items.size()));
    std::vector<Value> values;
    for (std::size_t i = 0; i < json_.items.size(); ++i)
      values.emplace_back(file_, json_.items[i], fmt::format("{}[{}]", path_, i));
    return values;
  }

  std::int64_t integer(std::int64_t low, std::int64_t high, const std::string& what) const {
    if (json_.kind != Json::Kind::integer || json_.integer < low || json_.integer > high)
      fail(fmt::format("{} from {} to {}", what, low, high));
    return json_.integer;
  }
  unsigned index(unsigned count, const std::string& what) const {
    return static_cast<unsigned>(integer(0, static_cast<std::int64_t>(count) - 1, what));
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
    for (const Value& value : list(fmt::format("a list of {}s", what), count)) {
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

Side side_of(const Value& value) {
  value.expect_object({"triangles", "edges", "ports"});
  Side side;
  side.triangles = static_cast<unsigned>(value.required("triangles").integer(1, most_triangles, "a number"));
  std::vector<unsigned> used(side.triangles);
  const auto use = [&](const Value& where, unsigned triangle) {
    if (++used[triangle] > 3)
      where.fail_found(
          fmt::format("expected at most three edges and ports of triangle {}, this is the fourth", triangle));
  };
  const auto triangle_at = [&](const Value& where) { return where.index(side.triangles, "a triangle"); };

  const Value edges = value.required("edges");
  std::set<std::array<unsigned, 2>> seen;
  for (const Value& edge : edges.list("a list of at most 19 edges, pairs of triangles", most_colors - 1)) {
    const std::vector<Value> ends = edge.list("a pair of triangles", 2);
    if (ends.size() != 2) edge.fail_found("expected a pair of triangles");
    const std::array<unsigned, 2> pair = {triangle_at(ends[0]), triangle_at(ends[1])};
    if (pair[0] == pair[1]) edge.fail_found(fmt::format("expected two different triangles, found {} twice", pair[0]));
    if (!seen.insert({std::min(pair[0], pair[1]), std::max(pair[0], pair[1])}).second)
      edge.fail_found(fmt::format("expected each edge once, {} and {} are joined above", pair[0], pair[1]));
    use(ends[0], pair[0]);
    use(ends[1], pair[1]);
    side.edges.push_back(pair);
  }
  const Value ports = value.required("ports");
  for (const Value& port : ports.list("a list of 1 to 8 ports, the triangle of each", most_ports)) {
    side.owner_of_port.push_back(triangle_at(port));
    use(port, side.owner_of_port.back());
  }
  if (side.ports() == 0) ports.fail_found("expected a list of 1 to 8 ports, found none");
  if (side.inner_edges() + side.ports() > most_colors)
    edges.fail_found(fmt::format("expected at most {} edges and ports together, found {} and {}", most_colors,
                                 side.inner_edges(), side.ports()));
  return side;
}

Mask give_up_of(const Value& value, unsigned ports) {
  if (value.is_list()) return value.set_of(ports, "port");
  const std::string expected = "\"none\", \"all\" or a list of ports";
  const std::string word = value.string(expected);
  if (word != "none" && word != "all") value.fail(expected);
  return word == "all" ? mask_count(ports) - 1 : 0;
}

/// How many members there are of what a count may be restricted to.
unsigned members(Among among, const Side& after) {
  return among == Among::edges ? after.inner_edges() : among == Among::triangles ? after.triangles : after.ports();
}

Term term_of(const Value& value, const Side& after) {
  value.expect_object({"count", "weight", "edges", "triangles", "ports"});
  Term term;
  term.count = static_cast<Count>(value.required("count").one_of(count_names));
  if (const std::optional<Value> weight = value.member("weight"))
    term.weight = weight->integer(-largest_weight, largest_weight, "an integer");
  const Among own = among_of(term.count);
  if (own != Among::nothing) term.among = mask_count(members(own, after)) - 1;
  for (const Among among : {Among::edges, Among::triangles, Among::ports}) {
    const std::string name(among_names[static_cast<std::size_t>(among)]);
    const std::optional<Value> chosen = value.member(name);
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

std::vector<Criterion> cost_of(const Value& value, const Side& after) {
  std::vector<Criterion> cost;
  for (const Value& criterion : value.list(fmt::format("a list of 1 to {} criteria", most_criteria), most_criteria)) {
    cost.emplace_back();
    for (const Value& term : criterion.list(fmt::format("a list of 1 to {} terms", most_terms), most_terms))
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
  const Value whole(file, json, {});
  whole.expect_object({"restrip_operation", "name", "about", "constraint", "before", "after", "give_up", "cost"});
  const Value version = whole.required("restrip_operation");
  if (!version.is_integer(1)) version.fail("1, the version of the format");
  OperationFile operation;
  const Value name = whole.required("name");
  operation.name = name.string("a name");
  if (!is_name(operation.name))
    name.fail(fmt::format("at most {} lower-case letters, digits and single hyphens between them, a letter first",
                          longest_name));
  if (const std::optional<Value> about = whole.member("about")) operation.about = about->string("a sentence in quotes");
  operation.constraint = static_cast<Constraint>(whole.required("constraint").one_of(constraint_names));
  operation.before = side_of(whole.required("before"));
  const Value after = whole.required("after");
  operation.after = side_of(after);
  if (operation.after.ports() != operation.before.ports())
    after.required("ports").fail_found(fmt::format("expected as many ports as before, {}, found {}",
                                                   operation.before.ports(), operation.after.ports()));
  if (const std::optional<Value> give_up = whole.member("give_up"))
    operation.may_give_up = give_up_of(*give_up, operation.ports());
  const std::optional<Value> cost = whole.member("cost");
  operation.cost = cost ? cost_of(*cost, operation.after) : default_cost(operation.constraint);
  return operation;
}

}  // namespace restrip::verify::operations
