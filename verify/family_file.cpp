#include "family_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "families_text.hpp"
#include "json_value.hpp"
#include "mutants.hpp"

namespace restrip::verify {
namespace {

constexpr std::size_t most_members = 64;  // of any list in the file

std::string text_of(const JsonValue& value) { return value.string("a text"); }

std::string optional_text(const JsonValue& family, std::string_view name, const std::string& otherwise) {
  const std::optional<JsonValue> value = family.member(name);
  return value ? text_of(*value) : otherwise;
}

/// Calls make, and names the place of what it refuses.
template <class Make>
auto made_of(const JsonValue& value, Make&& make) {
  try {
    return make(text_of(value));
  } catch (const std::invalid_argument& error) {
    value.fail_found(error.what());
  }
}

Conditions conditions_of(const JsonValue& family, std::string_view name, const std::vector<std::string>& numbers) {
  const std::optional<JsonValue> value = family.member(name);
  if (!value) return {};
  return made_of(*value, [&](const std::string& text) { return Conditions(text, numbers); });
}

FamilySide::Part part_of(const JsonValue& value, const std::vector<std::string>& numbers) {
  return made_of(value, [&](const std::string& text) -> FamilySide::Part {
    if (!text.starts_with("t[")) return {text, {}};
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos || !text.ends_with(')'))
      throw std::invalid_argument(fmt::format("expected a range as \"t[0,k)\", found \"{}\"", text));
    return {"t", std::pair{Sum(text.substr(2, comma - 2), numbers),
                           Sum(text.substr(comma + 1, text.size() - comma - 2), numbers)}};
  });
}

FamilySide side_of(const JsonValue& value, const std::vector<std::string>& numbers) {
  value.expect_object({"ring", "path", "chord", "ports"});
  const std::optional<JsonValue> ring = value.member("ring");
  if (ring && value.member("path")) value.fail_found("expected \"ring\" or \"path\", not both");
  FamilySide side;
  side.ring = ring.has_value();
  for (const JsonValue& part : (ring ? *ring : value.required("path")).list("a list of triangles", most_members))
    side.parts.push_back(part_of(part, numbers));
  if (const std::optional<JsonValue> chord = value.member("chord")) {
    const std::vector<JsonValue> ends = chord->list("two triangles", 2);
    if (ends.size() != 2) chord->fail("two triangles");
    side.chord = {text_of(ends[0]), text_of(ends[1])};
  }
  if (const std::optional<JsonValue> ports = value.member("ports"))
    for (const JsonValue& port : ports->list("the triangle of each port", most_members))
      side.ports.push_back(text_of(port));
  return side;
}

FamilyBound bound_of(const JsonValue& value, const std::vector<std::string>& numbers) {
  value.expect_object({"where", "strips", "isolated"});
  FamilyBound bound{conditions_of(value, "where", numbers), {}, {}};
  if (const auto strips = value.member("strips")) bound.strips = static_cast<int>(strips->integer(-16, 16, "a number"));
  if (const auto isolated = value.member("isolated"))
    bound.isolated = static_cast<int>(isolated->integer(-16, 16, "a number"));
  return bound;
}

FamilyDescription family_of(const JsonValue& value) {
  value.expect_object({"name", "about", "certificate", "numbers", "where", "listed", "position", "section", "key",
                       "give_up", "before", "after", "linked", "at_most"});
  FamilyDescription family;
  family.name = text_of(value.required("name"));
  family.certificate = optional_text(value, "certificate", family.name);
  if (const auto numbers = value.member("numbers"))
    for (const JsonValue& number : numbers->list("a list of names", 3)) family.numbers.push_back(text_of(number));
  family.where = conditions_of(value, "where", family.numbers);
  family.listed = conditions_of(value, "listed", family.numbers);
  family.position = optional_text(value, "position", "");
  family.section = optional_text(value, "section", family.position);
  if (const auto key = value.member("key"))
    family.keyed_by_inner = key->one_of(std::array<std::string_view, 2>{"joined", "inner"}) == 1;
  if (const auto give_up = value.member("give_up"))
    family.gives_ports_up = give_up->one_of(std::array<std::string_view, 2>{"none", "all"}) == 1;
  if (const auto linked = value.member("linked")) family.linked = linked->boolean("whether it has linked rules");
  family.before = side_of(value.required("before"), family.numbers);
  family.after = side_of(value.required("after"), family.numbers);
  if (const auto at_most = value.member("at_most"))
    for (const JsonValue& bound : at_most->list("a list of bounds", most_members))
      family.at_most.push_back(bound_of(bound, family.numbers));
  return family;
}

}  // namespace

Patch FamilySide::patch(const Numbers& given) const {
  Numbers numbers = given;
  if (mutated(Mutant::off_by_one_arc) && ring) ++numbers.at(1);
  std::vector<PatchTriangle> triangles;
  for (const Part& part : parts) {
    if (!part.range) {
      triangles.push_back({part.name, {}});
      continue;
    }
    for (unsigned i = part.range->first.of(numbers); i < part.range->second.of(numbers); ++i)
      triangles.push_back({fmt::format("{}{}", part.name, i), {i}});
  }
  for (unsigned port = 0; port < ports.size(); ++port) {
    const auto owner = std::find_if(triangles.begin(), triangles.end(),
                                    [&](const PatchTriangle& triangle) { return triangle.name == ports[port]; });
    if (owner == triangles.end()) throw std::logic_error("no triangle is named " + ports[port]);
    owner->ports.push_back(port);
  }
  return Patch(triangles, ring, chord);
}

std::vector<Numbers> FamilyDescription::positions(unsigned max_k) const {
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

std::string FamilyDescription::filled(std::string text, const Numbers& values) const {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string braced = fmt::format("{{{}}}", numbers[i]);
    if (const std::size_t place = text.find(braced); place != std::string::npos)
      text.replace(place, braced.size(), std::to_string(values.at(i)));
  }
  return text;
}

bool FamilyDescription::serves_every_position() const {
  return std::any_of(numbers.begin(), numbers.end(), [&](const std::string& number) {
    return section.find(fmt::format("{{{}}}", number)) == std::string::npos;
  });
}

std::vector<FamilyDescription> parse_families(const std::string& file, std::string_view text) {
  const Json json = parse_json(file, text);
  const JsonValue whole(file, json, "");
  whole.expect_object({"restrip_families", "families"});
  if (const JsonValue version = whole.required("restrip_families"); !version.is_integer(1)) version.fail("version 1");
  std::vector<FamilyDescription> families;
  for (const JsonValue& family : whole.required("families").list("a list of families", most_members))
    families.push_back(family_of(family));
  return families;
}

const std::vector<FamilyDescription>& family_descriptions() {
  static const std::vector<FamilyDescription> families = parse_families("tables/families.json", families_text);
  return families;
}

}  // namespace restrip::verify
