#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "common/json.hpp"
#include "common/printable.hpp"
#include "common/reading.hpp"
#include "describe/description.hpp"

namespace restrip::generator {
namespace {

std::string name_from(const JsonValue& value) {
  std::string name = value.text();
  const auto allowed = [](char c) { return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '-'; };
  const bool good = !name.empty() && name.size() <= 60 && 'a' <= name.front() && name.front() <= 'z' &&
                    name.back() != '-' && name.find("--") == std::string::npos &&
                    std::all_of(name.begin(), name.end(), allowed);
  if (!good) value.refuse("expected lower-case letters, digits and single hyphens, a letter first");
  return name;
}

/// The library includes the tables of its operations under these names.
void expect_no_other_operation(const JsonValue& value, const std::string& name) {
  static const std::vector<JsonValue> shipped = parse_json("tables/operations", operations_text).elements("operations");
  for (const JsonValue& one : shipped)
    if (one["name"].text() == name && one != value)
      value["name"].refuse(
          fmt::format("\"{0}\" is an operation of restrip, tables/operations/{0}.json, and this is another one; "
                      "choose another name, such as \"{0}-own\"",
                      name));
}

/// A position as certificates write it, in words.
std::string words_from(const JsonValue& value) {
  std::string words = value.text();
  constexpr std::size_t longest = 60;
  const bool ill_formed = words.empty() || words.size() > longest || words.front() == ' ' || words.back() == ' ' ||
                          words.find("  ") < words.size();
  if (ill_formed || !std::all_of(words.begin(), words.end(), [](char c) { return ' ' <= c && c <= '~'; }))
    value.refuse(
        fmt::format("expected words of printable ASCII with one space between them, at most {} characters", longest));
  return words;
}

}  // namespace

std::string too_many_colors(const Side& side) {
  return fmt::format(
      "expected at most {} edges and ports together: a table has an entry for each of their colourings; found {} and "
      "{}",
      most_edges_and_ports, side.edges.size(), side.ports());
}

namespace {

/// Parses a formula in the file; a fault in it is reported with its place.
template <class Parse>
auto formula(const JsonValue& value, const std::vector<std::string>& numbers, Parse&& parse) {
  const std::string text = value.text();
  try {
    return parse(text, numbers);
  } catch (const std::runtime_error& error) {
    value.refuse(error.what());
  }
}

/// Vertices of a family may have indices.
IndexedName vertex_from(const JsonValue& value, const std::vector<std::string>& numbers, const std::string& index) {
  if (numbers.empty()) return {value.text(), {}};
  return formula(value, numbers, [&](const std::string& text, const std::vector<std::string>& all) {
    return parse_vertex(text, all, index);
  });
}

/// Three vertices each; in a family also an index with its values, if the element stands for several triangles.
TrianglePatterns triangles_from(const JsonValue& value, const std::vector<std::string>& numbers) {
  TrianglePatterns patterns;
  for (const JsonValue& triangle : value.elements("triangles", 1, most_nodes)) {
    const std::vector<JsonValue> words =
        numbers.empty() ? triangle.elements("vertices", 3, 3)
                        : triangle.elements("words: three vertices, and an index with its values", 3, 4);
    TrianglePattern& pattern = patterns.emplace_back();
    if (words.size() == 4) {
      pattern.index = formula(words[3], numbers, parse_stretch);
      const std::string& name = pattern.index->name;
      if (!pattern.index->range || std::find(numbers.begin(), numbers.end(), name) != numbers.end() ||
          !std::all_of(name.begin(), name.end(), [](char c) { return 'a' <= c && c <= 'z'; }))
        words[3].refuse("expected an index with its values, such as \"i[0,k)\", other than the numbers of the family");
    }
    for (std::size_t corner = 0; corner < 3; ++corner)
      pattern.corners.at(corner) = vertex_from(words[corner], numbers, pattern.index ? pattern.index->name : "");
  }
  return patterns;
}

/// Of tables/families.json, whose forms the verifier checks.
Fan fan_from(const JsonValue& value, const std::vector<std::string>& numbers) {
  value.expect_members({"ring", "path", "chord"});
  Fan fan{value.has("ring"), {}, value.has("chord")};
  for (const JsonValue& element : value[fan.ring ? "ring" : "path"].elements("triangles"))
    fan.elements.push_back(formula(element, numbers, parse_stretch));
  return fan;
}

Mask mask_from(const JsonValue& value, std::size_t count, const std::string& what) {
  Mask mask = 0;
  for (const unsigned place : value.places(count, what)) mask |= Mask{1} << place;
  return mask;
}

/// `after` is null for families.
void take_give_up(const JsonValue& value, const Side* after, Description& description) {
  if (!value.is_text()) {
    if (after == nullptr) value.expected("\"none\" or \"all\"");
    description.may_give_up = mask_from(value, after->owner.size(), "port");
    return;
  }
  const std::string word = value.text();
  if (word != "none" && word != "all") value.expected("\"none\", \"all\" or a list of ports");
  if (word == "all") description.may_give_up = ~Mask{0};
}

/// `after` is null for families, whose terms count everything.
Term term_from(const JsonValue& value, const Side* after) {
  value.expect_members({"count", "weight", "edges", "triangles", "ports"});
  const std::size_t count = value["count"].one_of(count_words);
  const std::string_view may_choose = count_among.at(count);
  Term term{static_cast<Count>(count)};
  constexpr std::int64_t heaviest = 1'000'000;
  if (value.has("weight")) term.weight = value["weight"].number(-heaviest, heaviest, "a weight");
  if (!may_choose.empty() && after != nullptr) term.of = (Mask{1} << how_many(may_choose, *after)) - 1;
  for (const std::string among : {"edge", "triangle", "port"}) {
    const std::string member = among + "s";
    if (!value.has(member)) continue;
    if (may_choose != among)
      value[member].refuse(fmt::format("\"{}\" does not choose among {}", count_words.at(count), member));
    if (after == nullptr) value[member].refuse("a family has different ones at each position; leave this out");
    term.of = mask_from(value[member], how_many(among, *after), among);
  }
  return term;
}

Preference preference_from(const JsonValue& value, const Side* after) {
  Preference preference;
  for (const JsonValue& criterion : value.elements("criteria", 1, most_criteria)) {
    preference.emplace_back();
    for (const JsonValue& term : criterion.elements("terms", 1, most_terms))
      preference.back().push_back(term_from(term, after));
  }
  return preference;
}

std::vector<std::string> numbers_from(const JsonValue& value) {
  std::vector<std::string> numbers;
  for (const JsonValue& element : value.elements("numbers", 0, PositionNumbers{}.size())) {
    numbers.push_back(element.text());
    const std::string& name = numbers.back();
    if (name.empty() || name.size() > longest_word ||
        !std::all_of(name.begin(), name.end(), [](char c) { return 'a' <= c && c <= 'z'; }))
      element.refuse(fmt::format("expected 1 to {} lower-case letters", longest_word));
    if (std::count(numbers.begin(), numbers.end(), name) > 1) element.refuse("this number is listed already");
  }
  return numbers;
}

/// Braces enclose numbers, each once: the header has their places instead, as in "k {0}".
void expect_numbers_once(const JsonValue& value, const std::vector<std::string>& numbers) {
  std::string text = value.text();
  for (const std::string& number : numbers)
    if (const std::size_t at = text.find(fmt::format("{{{}}}", number)); at != std::string::npos)
      text.erase(at, number.size() + 2);
  if (text.find_first_of("{}") != std::string::npos)
    value.refuse(fmt::format(
        "expected braces only around {}, each at most once",
        numbers.empty() ? "numbers, and the family has no numbers" : fmt::format("{}", fmt::join(numbers, ", "))));
}

/// The verifier checks every rule against these bounds.
void expect_bounds(const JsonValue& value, const std::vector<std::string>& numbers) {
  for (const JsonValue& bound : value.elements("bounds")) {
    bound.expect_members({"where", "strips", "isolated", "indices"});
    if (bound.has("where")) formula(bound["where"], numbers, parse_conditions);
    for (const char* member : {"strips", "isolated", "indices"})
      if (bound.has(member)) bound[member].number(-16, 16, "a number");
  }
}

/// Reads what only families have.
void take_positions(const JsonValue& value, Description& family) {
  if (value.has("numbers")) family.numbers = numbers_from(value["numbers"]);
  if (value.has("where")) {
    family.range = value["where"].text();
    family.where = formula(value["where"], family.numbers, parse_conditions);
  }
  if (value.has("listed")) family.listed = formula(value["listed"], family.numbers, parse_conditions);
  for (const std::string& number : family.numbers)
    family.place += fmt::format("{1}{0} {{{0}}}", number, family.place.empty() ? "" : " ");
  if (value.has("position")) family.place = words_from(value["position"]);
  for (const std::string& number : family.numbers)
    if (family.place.find(fmt::format("{{{}}}", number)) == std::string::npos)
      value["position"].expected(fmt::format("each number in braces, also \"{{{}}}\"", number));
  if (value.has("position")) expect_numbers_once(value["position"], family.numbers);
  family.section = value.has("section") ? words_from(value["section"]) : family.place;
  if (value.has("section")) expect_numbers_once(value["section"], family.numbers);
  if (family.section.empty()) family.section = family.name;
}

/// Makes the patch of a single operation, so that faults are reported with their place in the file.
std::optional<Patch> patch_from(const JsonValue& value, const Description& description) {
  if (!description.numbers.empty()) return {};
  try {
    return surface_patch(named_at(std::get<TrianglePatterns>(description.before),
                                  std::get<TrianglePatterns>(description.after), description.boundary, {}));
  } catch (const PatchFault& fault) {
    const JsonValue member = value[fault.member];
    if (fault.element < 0) member.refuse(fault.what());
    member.elements("triangles")[static_cast<std::size_t>(fault.element)].refuse(fault.what());
  }
}

void expect_version(const JsonValue& value) { value.number(1, 1, "the version of the format"); }

Description description_from(const JsonValue& value, Author author) {
  if (value.has("take"))
    value["take"].refuse(
        "a dashed port stays dashed: whether it may become solid depends on the triangle beyond it, which no rule "
        "sees; "
        "describe that triangle as part of the patch");
  value.expect_members({"restrip_operation", "name", "about", "certificate", "constraint", "numbers", "where", "listed",
                        "position", "section", "before", "after", "boundary", "give_up", "cost", "table", "at_most"});
  Description description;
  description.author = author;
  description.in_file = value.where();
  if (value.has("restrip_operation")) expect_version(value["restrip_operation"]);
  description.name = name_from(value["name"]);
  if (author == Author::user) expect_no_other_operation(value, description.name);
  if (value.has("about")) {
    description.about = value["about"].text();
    if (const std::string found = files::unfit_for_comment(description.about); !found.empty())
      value["about"].refuse(
          fmt::format("expected one line that can stand in a comment of any language, found {}; remove it", found));
  }
  description.certificate = value.has("certificate") ? name_from(value["certificate"]) : description.name;
  take_positions(value, description);
  if (value.has("at_most")) expect_bounds(value["at_most"], description.numbers);
  description.before_in_file = value["before"].where();
  description.after_in_file = value["after"].where();
  if (value.has("boundary")) description.boundary_in_file = value["boundary"].where();
  if (author == Author::restrip && !value["before"].is_list()) {
    description.before = fan_from(value["before"], description.numbers);
    description.after = fan_from(value["after"], description.numbers);
  } else {
    description.before = triangles_from(value["before"], description.numbers);
    description.after = triangles_from(value["after"], description.numbers);
    if (value.has("boundary"))
      for (const JsonValue& stretch : value["boundary"].elements("stretches of the outline")) {
        const std::vector<JsonValue> ends = stretch.elements("vertices", 2, 2);
        description.boundary.push_back(
            {vertex_from(ends[0], description.numbers, ""), vertex_from(ends[1], description.numbers, "")});
      }
    if (serves_every_position(description))
      value["section"].refuse("a family given by triangles has a section for each position");
  }
  const std::optional<Patch> patch = patch_from(value, description);
  const Side* after = patch ? &patch->after : nullptr;
  if (value.has("constraint"))
    description.constraint.most_edges = static_cast<unsigned>(value["constraint"].one_of(constraint_words)) + 1;
  if (value.has("give_up")) take_give_up(value["give_up"], after, description);
  description.preference = fewest_strips();
  if (description.constraint.most_edges == 1) description.preference.erase(description.preference.begin());
  description.own_cost = value.has("cost");
  if (description.own_cost) description.preference = preference_from(value["cost"], after);
  if (value.has("table")) description.has_table = value["table"].truth();
  return description;
}

}  // namespace

std::vector<Description> parse_descriptions(const std::string& file, const std::string& text, Author author) {
  const JsonValue whole = parse_json(file, text);
  expect_version(whole["restrip_operation"]);
  if (!whole.has("operations")) return {description_from(whole, author)};
  whole.expect_members({"restrip_operation", "operations"});
  std::vector<Description> all;
  for (const JsonValue& one : whole["operations"].elements("operations", 1)) {
    all.push_back(description_from(one, author));
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
      if (all[i].name == all.back().name) one["name"].refuse("another description has this name");
  }
  return all;
}

std::vector<Description> read_descriptions(const std::vector<std::string>& files) {
  constexpr std::uint64_t longest = 1 << 20;
  std::vector<Description> all;
  for (const std::string& file : files) {
    const std::vector<Description> others = all;
    for (Description& description : parse_descriptions(file, files::read_whole(file, {longest, longest}))) {
      for (const Description& other : others)
        if (other.name == description.name || other.certificate == description.certificate)
          throw std::runtime_error(fmt::format("{}: another of these files has the name {}", file, description.name));
      all.push_back(std::move(description));
    }
  }
  return all;
}

}  // namespace restrip::generator
