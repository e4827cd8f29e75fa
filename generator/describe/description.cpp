#include "describe/description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "describe/description_file.hpp"
#include "describe/families_text.hpp"

namespace restrip::generator {
namespace {

/// Throws if a side is not a graph of triangles: a duplicate edge, or more than three edges and ports at a triangle.
void expect_triangles(const Side& side) {
  std::vector<unsigned> degree(side.nodes, 0);
  std::set<std::pair<unsigned, unsigned>> joined;
  for (const auto& [u, v] : side.edges) {
    if (u == v || !joined.insert(std::minmax(u, v)).second)
      throw std::runtime_error(fmt::format("triangles {} and {} cannot be joined by this edge", u, v));
    ++degree[u];
    ++degree[v];
  }
  for (const unsigned owner : side.owner) ++degree[owner];
  for (unsigned node = 0; node < side.nodes; ++node)
    if (degree[node] > 3)
      throw std::runtime_error(fmt::format("triangle {} has more than three edges and ports", node));
}

/// The numbers of triangles: first those with an index, ordered by the first appearance of their name and then by
/// index, then single ones in order of appearance.
Side side_at(const SidePattern& pattern, const PositionNumbers& place) {
  using Triangle = std::pair<std::string, int>;
  constexpr int no_index = -1;
  constexpr int most_triangles = 64;  // well above the size of tables
  const auto text_of = [&](const Triangle& triangle) {
    return triangle.second == no_index ? triangle.first : fmt::format("{}_{}", triangle.first, triangle.second);
  };
  const auto triangles_of = [&](const Stretch& stretch) -> std::vector<Triangle> {
    if (!stretch.range) return {{stretch.name, no_index}};
    const int from = stretch.range->from.at(place);
    const int to = stretch.range->to.at(place);
    if (from < 0 || to < from || to > most_triangles)
      throw std::runtime_error(
          fmt::format("expected indices from 0 to {}, found {}[{},{})", most_triangles, stretch.name, from, to));
    std::vector<Triangle> all;
    for (int i = from; i < to; ++i) all.emplace_back(stretch.name, i);
    return all;
  };
  std::map<std::string, std::size_t> appeared;  // names of triangles with an index
  std::vector<std::tuple<bool, std::size_t, Triangle>> all;
  for (const Chain& chain : pattern.chains)
    for (const Stretch& stretch : chain.elements)
      for (const Triangle& triangle : triangles_of(stretch))
        all.emplace_back(!stretch.range,
                         stretch.range ? appeared.emplace(stretch.name, appeared.size()).first->second : all.size(),
                         triangle);
  if (all.size() > most_triangles)
    throw std::runtime_error(fmt::format("expected at most {} triangles, found {}", most_triangles, all.size()));
  std::sort(all.begin(), all.end());
  Side side;
  std::map<Triangle, unsigned> number;
  for (const auto& [is_single, order, triangle] : all) {
    if (!number.emplace(triangle, side.nodes).second)
      throw std::runtime_error(fmt::format("{} occurs twice", text_of(triangle)));
    if (!is_single && pattern.ports.empty()) side.owner.push_back(side.nodes);
    ++side.nodes;
  }
  const auto numbers_of = [&](const Stretch& stretch) {
    std::vector<unsigned> numbers;
    for (const Triangle& triangle : triangles_of(stretch)) {
      const auto found = number.find(triangle);
      if (found == number.end()) throw std::runtime_error(fmt::format("{} does not occur", text_of(triangle)));
      numbers.push_back(found->second);
    }
    return numbers;
  };
  for (const Chain& chain : pattern.chains) {
    std::vector<unsigned> order;
    for (const Stretch& stretch : chain.elements)
      for (const unsigned triangle : numbers_of(stretch)) order.push_back(triangle);
    for (std::size_t i = 0; i + 1 < order.size(); ++i) side.edges.push_back({order[i], order[i + 1]});
    if (chain.ring && !order.empty()) side.edges.push_back({order.back(), order.front()});
  }
  for (const auto& [from, to] : pattern.chords) {
    const std::vector<unsigned> u = numbers_of(from);
    const std::vector<unsigned> v = numbers_of(to);
    if (u.size() != 1 || v.size() != 1) throw std::runtime_error("a chord joins two triangles");
    side.edges.push_back({u[0], v[0]});
  }
  for (const Stretch& stretch : pattern.ports)
    for (const unsigned triangle : numbers_of(stretch)) side.owner.push_back(triangle);
  expect_triangles(side);
  return side;
}

[[noreturn]] void refuse(const Position& position, const std::string& in_file, const std::string& what) {
  throw std::runtime_error(fmt::format("{}{} ({})", in_file, what, name_of(position)));
}

Side side_at(const SideForm& form, const Position& position, const std::string& in_file) {
  if (const Side* side = std::get_if<Side>(&form)) return *side;
  try {
    return side_at(std::get<SidePattern>(form), position.numbers());
  } catch (const std::runtime_error& error) {
    refuse(position, in_file, error.what());
  }
}

/// For positions given by triangles.
SurfacePatch triangles_at(const Position& position) {
  const Description& family = *position.family;
  NamedPatch named;
  try {
    named = named_at(std::get<TrianglePatterns>(family.before), std::get<TrianglePatterns>(family.after),
                     family.boundary, position.numbers());
    return surface_patch(named);
  } catch (const PatchFault& fault) {
    if (fault.member == "boundary") refuse(position, family.boundary_in_file, fault.what());
    const bool is_before = fault.member == "before";
    std::string what = fault.what();
    if (fault.element >= 0)
      what = fmt::format(
          "{}: {}",
          fmt::join((is_before ? named.before : named.after).at(static_cast<std::size_t>(fault.element)), " "), what);
    refuse(position, is_before ? family.before_in_file : family.after_in_file, what);
  } catch (const std::runtime_error& error) {
    refuse(position, family.in_file, error.what());
  }
}

/// Whether a text has the number's name in braces.
bool names(const std::string& text, const std::string& number) {
  return text.find(fmt::format("{{{}}}", number)) != std::string::npos;
}

/// Replaces the names in braces by the numbers.
std::string filled(std::string text, const Position& position) {
  for (std::size_t i = 0; i < position.family->numbers.size(); ++i) {
    const std::string name = fmt::format("{{{}}}", position.family->numbers[i]);
    if (const std::size_t at = text.find(name); at != std::string::npos)
      text.replace(at, name.size(), std::to_string(position.numbers().at(i)));
  }
  return text;
}

}  // namespace

std::string identifier(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

const std::vector<Description>& families() {
  static const std::vector<Description> all =
      parse_descriptions("tables/families.json", std::string(families_text), Author::restrip);
  return all;
}

const std::vector<Description>& tabled_families() {
  static const std::vector<Description> tabled = [] {
    std::vector<Description> some;
    std::copy_if(families().begin(), families().end(), std::back_inserter(some),
                 [](const Description& family) { return family.has_table; });
    return some;
  }();
  return tabled;
}

const Description& family_named(const std::string& name) {
  for (const Description& family : families())
    if (family.name == name) return family;
  throw std::invalid_argument("unknown family " + name);
}

bool serves_every_position(const Description& family) {
  return std::any_of(family.numbers.begin(), family.numbers.end(),
                     [&](const std::string& number) { return !names(family.section, number); });
}

Position position_of_rows(Position position) {
  const std::array<unsigned*, 3> numbers{&position.k, &position.at, &position.to};
  for (std::size_t i = 0; i < position.family->numbers.size(); ++i)
    if (!names(position.family->section, position.family->numbers[i])) *numbers.at(i) = 0;
  return position;
}

unsigned smallest_valence(const Description& family) {
  for (unsigned k = 1; k < 64; ++k)
    if (!positions(family, k).empty()) return k;
  throw std::runtime_error(family.name + ": a family without a position");
}

std::vector<Position> positions_up_to(const Description& family, unsigned max_k) {
  std::vector<Position> all;
  for (unsigned k = 0; k <= (family.numbers.empty() ? 0 : max_k); ++k)
    for (const Position& position : positions(family, k)) all.push_back(position);
  return all;
}

std::vector<Position> positions(const Description& family, unsigned k) {
  if (family.numbers.empty()) {
    Position only{&family, 0, 0, 0};
    only.k = make_patch(only).before.ports();
    return {only};
  }
  const unsigned last_at = family.numbers.size() > 1 ? k : 0;
  const unsigned last_to = family.numbers.size() > 2 ? k : 0;
  std::vector<Position> list;
  for (unsigned at = 0; at <= last_at; ++at)
    for (unsigned to = 0; to <= last_to; ++to)
      if (hold(family.where, {k, at, to}) && hold(family.listed, {k, at, to})) list.push_back({&family, k, at, to});
  return list;
}

Patch make_patch(const Position& position) {
  if (!position.family->is_graph_only()) return triangles_at(position).patch;
  const Description& family = *position.family;
  Patch patch{side_at(family.before, position, family.before_in_file),
              side_at(family.after, position, family.after_in_file)};
  if (patch.before.ports() != patch.after.ports())
    refuse(position, family.after_in_file,
           fmt::format("expected the same number of ports as before, {}, found {}", patch.before.ports(),
                       patch.after.ports()));
  return patch;
}

Surface surface_at(const Position& position) { return triangles_at(position).surface; }

Patch patch_of_rows(const Position& position) {
  if (!serves_every_position(*position.family)) return make_patch(position);
  const Side after = side_at(position.family->after, position, position.family->after_in_file);
  return {after, after};
}

Operation operation_at(const Position& position, Patch patch) {
  const Description& description = *position.family;
  const Mask may_give_up = description.may_give_up & patch.after.all_ports();
  return {std::move(patch), description.constraint, may_give_up, description.preference, {}, description.is_pattern()};
}

std::string position_text(const Position& position) { return filled(position.family->section, position); }

std::string name_of(const Position& position) {
  const Description& family = *position.family;
  return family.place.empty() ? family.name : family.name + ' ' + filled(family.place, position);
}

}  // namespace restrip::generator
