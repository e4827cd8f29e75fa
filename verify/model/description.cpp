#include "model/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "common/printable.hpp"
#include "model/input.hpp"
#include "model/side_reader.hpp"

namespace restrip::verify {
namespace {

bool is_name(std::string_view text) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !text.empty() && text.size() <= longest_name && text.front() >= 'a' && text.front() <= 'z' &&
         text.back() != '-' && text.find("--") == std::string_view::npos && std::all_of(text.begin(), text.end(), fits);
}

std::string name_of(const JsonValue& value) {
  std::string name = value.text("a name");
  if (!is_name(name))
    value.expected(fmt::format("at most {} lower-case letters, digits and single hyphens between them, a letter first",
                               longest_name));
  return name;
}

/// Whether an operation of restrip (tables/operations) has this name but another description.
bool is_other_operation(std::string_view name, const JsonValue& description) {
  static const std::vector<JsonValue> shipped = parse_json("tables/operations", operations_text).elements("operations");
  return std::any_of(shipped.begin(), shipped.end(),
                     [&](const JsonValue& one) { return one["name"].text() == name && one != description; });
}

/// Words of printable ASCII separated by one space, like lines of certificates.
bool is_words(std::string_view text) {
  for (const char c : text)
    if (c < ' ' || c > '~') return false;
  return !text.empty() && text.front() != ' ' && text.back() != ' ' && text.find("  ") == std::string_view::npos;
}

/// A position in the form of certificates and reports.
std::string words_of(const JsonValue& description, std::string_view name, const std::vector<std::string>& numbers,
                     const std::string& otherwise) {
  const std::optional<JsonValue> value = description.member(name);
  if (!value) return otherwise;
  constexpr std::size_t longest = 60;
  std::string text = value->text();
  if (!is_words(text) || text.size() > longest)
    value->expected(
        fmt::format("at most {} characters, words of printable ASCII with one space between them", longest));
  std::string rest = text;
  for (const std::string& number : numbers)
    if (const std::size_t at = rest.find(fmt::format("{{{}}}", number)); at != std::string::npos)
      rest.erase(at, number.size() + 2);
  if (rest.find_first_of("{}") != std::string::npos)
    value->expected("braces only around numbers, around each once at most");
  return text;
}

Conditions conditions_of(const JsonValue& description, const std::vector<std::string>& numbers, std::string_view name) {
  const std::optional<JsonValue> value = description.member(name);
  if (!value) return {};
  try {
    return Conditions(value->text(), numbers);
  } catch (const std::invalid_argument& error) {
    value->refuse(error.what());
  }
}

Mask mask_of(const std::vector<unsigned>& places) {
  Mask mask = 0;
  for (const unsigned place : places) mask |= single(place);
  return mask;
}

Mask give_up_of(const JsonValue& value, unsigned ports) {
  if (value.is_list()) return mask_of(value.places(ports, "port"));
  const std::string expected = "\"none\", \"all\" or a list of ports";
  const std::string word = value.text(expected);
  if (word != "none" && word != "all") value.expected(expected);
  return word == "all" ? mask_count(ports) - 1 : 0;
}

/// The number of members that a count may be restricted to.
unsigned members(Among among, const Side& after) {
  return among == Among::edges ? after.inner_edges() : among == Among::triangles ? after.triangles : after.ports();
}

Term term_of(const JsonValue& value, const Side& after) {
  value.expect_members({"count", "weight", "edges", "triangles", "ports"});
  Term term;
  term.count = static_cast<Count>(value["count"].one_of(count_names));
  if (const std::optional<JsonValue> weight = value.member("weight"))
    term.weight = weight->number(-largest_weight, largest_weight, "an integer");
  const Among own = among_of(term.count);
  if (own != Among::nothing) term.among = mask_count(members(own, after)) - 1;
  for (const Among among : {Among::edges, Among::triangles, Among::ports}) {
    const std::string name(among_names[static_cast<std::size_t>(among)]);
    const std::optional<JsonValue> chosen = value.member(name);
    if (!chosen) continue;
    if (among != own)
      chosen->refuse(fmt::format("unknown member, \"{}\" is not counted among {}",
                                 count_names[static_cast<std::size_t>(term.count)], name));
    term.among = mask_of(chosen->places(members(among, after), name.substr(0, name.size() - 1)));
  }
  return term;
}

std::vector<Criterion> cost_of(const JsonValue& value, const Side& after) {
  std::vector<Criterion> cost;
  for (const JsonValue& criterion : value.elements("criteria", 1, most_criteria)) {
    cost.emplace_back();
    for (const JsonValue& term : criterion.elements("terms", 1, most_terms))
      cost.back().push_back(term_of(term, after));
  }
  return cost;
}

/// Takes the smaller of two bounds; the value is checked even if the bound does not apply here.
void lower(std::optional<int>& bound, const std::optional<JsonValue>& value, bool holds) {
  if (!value) return;
  const auto found = static_cast<int>(value->number(-16, 16, "a number"));
  if (holds) bound = std::min(bound.value_or(found), found);
}

/// The limits of a user's file; the shipped families exceed them.
void expect_limits(const JsonValue& description, const Operation& operation) {
  for (const auto& [member, side] : {std::pair("before", &operation.before), {"after", &operation.after}})
    if (side->ports() > most_ports || side->colors() > most_colors_of_a_user)
      description[member].refuse(fmt::format(
          "expected 1 to {} ports, and at most {} edges and ports together, found {} and {} ({}); a smaller "
          "--max-k leaves large positions out",
          most_ports, most_colors_of_a_user, side->ports(), side->colors(), operation.name()));
}

void expect_version(const JsonValue& value) { value.number(1, 1, "the version of the format"); }

void take_bounds(const JsonValue& value, const std::vector<std::string>& numbers, Operation& operation) {
  for (const JsonValue& bound : value.elements("bounds")) {
    bound.expect_members({"where", "strips", "isolated", "indices"});
    const bool holds = conditions_of(bound, numbers, "where").hold(operation.numbers);
    lower(operation.most_strips, bound.member("strips"), holds);
    lower(operation.most_isolated, bound.member("isolated"), holds);
    lower(operation.most_indices, bound.member("indices"), holds);
  }
}

}  // namespace

Description::Description(const JsonValue& value, Author author) : value_(value), author_(author) {
  if (const std::optional<JsonValue> take = value.member("take"))
    take->refuse("expected no taken ports, since a rule does not see the triangle beyond a dashed port");
  value.expect_members({"restrip_operation", "name", "about", "constraint", "before", "after", "boundary", "give_up",
                        "cost", "certificate", "numbers", "where", "listed", "position", "section", "table",
                        "at_most"});
  if (const std::optional<JsonValue> version = value.member("restrip_operation")) expect_version(*version);
  name = name_of(value["name"]);
  if (author == Author::user && is_other_operation(name, value))
    value["name"].refuse(fmt::format(
        "expected a name that is free, \"{0}\" is an operation of restrip, tables/operations/{0}.json, and this "
        "is another one; \"my-{0}\" would do",
        name));
  if (const std::optional<JsonValue> sentence = value.member("about")) {  // becomes a comment of the table
    about = sentence->text("a sentence in quotes");
    if (const std::string forbidden = files::unfit_for_comment(about); !forbidden.empty())
      sentence->refuse(fmt::format("expected words that can stand in a comment, found {}; remove it", forbidden));
  }
  const std::optional<JsonValue> other_name = value.member("certificate");
  certificate = other_name ? name_of(*other_name) : name;
  if (const auto names = value.member("numbers"))
    for (const JsonValue& number : names->elements("names", 0, most_numbers)) {
      const std::string word = number.text();
      if (word.empty() || word.size() > longest_word ||
          word.find_first_not_of("abcdefghijklmnopqrstuvwxyz") < word.size())
        number.expected(fmt::format("1 to {} lower-case letters", longest_word));
      if (std::find(numbers.begin(), numbers.end(), word) != numbers.end())
        number.refuse(fmt::format("expected each number once, \"{}\" is listed above", word));
      numbers.push_back(word);
    }
  where = conditions_of(value, numbers, "where");
  listed = conditions_of(value, numbers, "listed");
  std::string every_number;  // "k {k} a {a}"
  for (const std::string& number : numbers)
    every_number += fmt::format("{}{} {{{}}}", every_number.empty() ? "" : " ", number, number);
  position = words_of(value, "position", numbers, every_number);
  for (const std::string& number : numbers)
    if (position.find(fmt::format("{{{}}}", number)) == std::string::npos)
      value["position"].expected(fmt::format("each number in braces, also \"{{{}}}\"", number));
  section = words_of(value, "section", numbers, position);
  if (const auto flag = value.member("table")) has_table = flag->truth();
  if (author == Author::user && serves_every_position())
    value["section"].refuse("expected all numbers: triangles may be numbered again at each position");
  for (unsigned k = 0; k <= most_searched_ports; ++k)
    if (const std::vector<Numbers> some = positions(k); !some.empty()) {
      (void)at(some.front());
      return;
    }
}

std::vector<Numbers> Description::positions(unsigned max_k) const {
  std::vector<Numbers> all{{}};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::vector<Numbers> longer;
    for (const Numbers& one : all)
      for (unsigned value = 0; value <= (i == 0 ? max_k : one.front()); ++value) {
        longer.push_back(one);
        longer.back().push_back(value);
      }
    all = std::move(longer);
  }
  std::erase_if(all, [&](const Numbers& one) { return !where.hold(one); });
  return all;
}

Operation Description::at(const Numbers& values) const {
  Operation operation;
  operation.family = name;
  operation.position = filled(position, values);
  operation.numbers = values;
  if (const std::optional<JsonValue> constraint = value_.member("constraint"))
    operation.constraint = static_cast<Constraint>(constraint->one_of(constraint_names));
  Sides sides = read_sides(value_, {numbers, values}, author_);
  operation.before = std::move(sides.before);
  operation.after = std::move(sides.after);
  operation.vertices = sides.vertices;
  operation.placed_before = std::move(sides.placed_before);
  operation.placed_after = std::move(sides.placed_after);
  if (const std::optional<JsonValue> give_up = value_.member("give_up"))
    operation.may_give_up = give_up_of(*give_up, operation.ports());
  if (author_ == Author::user) expect_limits(value_, operation);
  const std::optional<JsonValue> cost = value_.member("cost");
  operation.cost = cost ? cost_of(*cost, operation.after) : default_cost(operation.constraint);
  if (author_ == Author::user && !searched(operation) && operation.cost != default_cost(operation.constraint))
    cost->refuse(fmt::format(
        "expected no cost, because {} has {} ports: beyond {} only rules of the default cost can be verified, "
        "by their reasons; leave it out",
        operation.name(), operation.ports(), most_searched_ports));
  if (const std::optional<JsonValue> bounds = value_.member("at_most")) take_bounds(*bounds, numbers, operation);
  return operation;
}

Side Description::side_after(const Numbers& values) const { return read_fan_after(value_, {numbers, values}); }

std::string Description::filled(std::string text, const Numbers& values) const {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string braced = fmt::format("{{{}}}", numbers[i]);
    if (const std::size_t place = text.find(braced); place != std::string::npos)
      text.replace(place, braced.size(), std::to_string(values.at(i)));
  }
  return text;
}

bool Description::serves_every_position() const {
  return std::any_of(numbers.begin(), numbers.end(), [&](const std::string& number) {
    return section.find(fmt::format("{{{}}}", number)) == std::string::npos;
  });
}

const std::string& Description::file() const { return value_.file(); }

std::vector<Description> parse_descriptions(const std::string& file, std::string_view text, Author author) {
  const JsonValue whole = parse_json(file, text);
  expect_version(whole["restrip_operation"]);
  const std::optional<JsonValue> list = whole.member("operations");
  if (!list) return {Description(whole, author)};
  whole.expect_members({"restrip_operation", "operations"});
  std::vector<Description> descriptions;
  for (const JsonValue& value : list->elements("operations", 1)) {
    const Description description(value, author);
    for (const Description& other : descriptions)
      if (other.name == description.name)
        value["name"].refuse("expected another name, a description above has this one");
    descriptions.push_back(description);
  }
  return descriptions;
}

Operation parse_operation(const std::string& file, std::string_view text) {
  const std::vector<Description> descriptions = parse_descriptions(file, text);
  if (descriptions.size() != 1 || !descriptions.front().numbers.empty())
    throw std::invalid_argument(file + " has more than one operation");
  return descriptions.front().at({});
}

const std::vector<Description>& shipped_descriptions() {
  static const std::vector<Description> shipped =
      parse_descriptions("tables/families.json", families_text, Author::restrip);
  return shipped;
}

namespace {

Section& section_at(Family& family, const Description& description, const Operation& operation) {
  const std::string position =
      description.section.empty() ? description.name : description.filled(description.section, operation.numbers);
  const auto found = std::find_if(family.sections.begin(), family.sections.end(),
                                  [&](const Section& section) { return section.position == position; });
  if (found != family.sections.end()) {
    const Operation& first = found->operations.front();
    if (first.after != operation.after || first.may_give_up != operation.may_give_up || first.cost != operation.cost ||
        first.constraint != operation.constraint)
      throw InputError(description.file(), 0,
                       fmt::format("section {} cannot serve both {} and {}: they differ after the operation", position,
                                   first.name(), operation.name()));
    return *found;
  }
  family.sections.push_back({position, operation.ports(), description.serves_every_position(), {}});
  return family.sections.back();
}

/// All operations that one certificate serves.
Family family_of(const std::vector<Description>& descriptions, const std::string& certificate, unsigned max_k) {
  Family family{certificate, {}, {}, true};
  for (const Description& description : descriptions) {
    if (description.certificate != certificate) continue;
    family.has_table = description.has_table;
    const std::vector<Numbers> positions = description.positions(max_k);
    if (positions.empty())
      throw InputError(description.file(), 0, fmt::format("{} has no position up to {}", description.name, max_k));
    for (const Numbers& numbers : positions) {
      const Operation operation = description.at(numbers);
      if (description.listed.hold(numbers))
        section_at(family, description, operation).operations.push_back(operation);
      else
        family.unlisted.push_back(operation);
    }
  }
  return family;
}

}  // namespace

std::vector<Family> families_of(const std::vector<Description>& descriptions, unsigned max_k) {
  std::vector<std::string> certificates;
  for (const Description& description : descriptions) {
    std::erase(certificates, description.certificate);
    certificates.push_back(description.certificate);
  }
  std::vector<Family> families;
  families.reserve(certificates.size());
  for (const std::string& certificate : certificates) families.push_back(family_of(descriptions, certificate, max_k));
  return families;
}

std::vector<Family> all_families(unsigned max_k) { return families_of(shipped_descriptions(), max_k); }

std::vector<Family> tabled_families(unsigned max_k) {
  std::vector<Family> families = all_families(max_k);
  std::erase_if(families, [](const Family& family) { return !family.has_table; });
  return families;
}

Side patch_after(const std::string& certificate, const Numbers& numbers) {
  for (const Description& description : shipped_descriptions())
    if (description.certificate == certificate) return description.side_after(numbers);
  throw std::logic_error("no family " + certificate);
}

}  // namespace restrip::verify
