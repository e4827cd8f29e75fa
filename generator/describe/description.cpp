#include "describe/description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace restrip::generator {
namespace {

/// Triangles t_i are numbered by index; inserted ones follow in the order of appearance.
Side side_at(const Fan& fan, const PositionNumbers& place) {
  constexpr unsigned inserted = ~0U;
  std::vector<unsigned> order;
  Side side;
  for (const Stretch& stretch : fan.elements) {
    if (!stretch.range) order.push_back(inserted);
    for (int i = stretch.range ? stretch.range->from.at(place) : 0; stretch.range && i < stretch.range->to.at(place);
         ++i) {
      order.push_back(static_cast<unsigned>(i));
      side.owner.push_back(side.nodes++);
    }
  }
  for (unsigned& triangle : order)
    if (triangle == inserted) triangle = side.nodes++;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) side.edges.push_back({order[i], order[i + 1]});
  if (fan.ring) side.edges.push_back({order.back(), order.front()});
  if (fan.chord) side.edges.push_back({side.nodes - 2, side.nodes - 1});
  return side;
}

[[noreturn]] void refuse(const Position& position, const std::string& in_file, const std::string& what) {
  throw std::runtime_error(fmt::format("{}{} ({})", in_file, what, name_of(position)));
}

/// For positions given by triangles.
Patch triangles_at(const Position& position) {
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
  const auto* before = std::get_if<Fan>(&position.family->before);
  const auto* after = std::get_if<Fan>(&position.family->after);
  if (before == nullptr || after == nullptr) return triangles_at(position);
  return {side_at(*before, position.numbers()), side_at(*after, position.numbers()), {}};
}

Patch patch_of_rows(const Position& position) {
  if (!serves_every_position(*position.family)) return make_patch(position);
  const Side after = side_at(std::get<Fan>(position.family->after), position.numbers());
  return {after, after, {}};
}

Operation operation_at(const Position& position, Patch patch) {
  const Description& description = *position.family;
  const Mask may_give_up = description.may_give_up & patch.after.all_ports();
  return {std::move(patch),
          description.constraint,
          may_give_up,
          description.preference,
          {},
          description.author == Author::restrip};
}

std::string position_text(const Position& position) { return filled(position.family->section, position); }

std::string name_of(const Position& position) {
  const Description& family = *position.family;
  return family.place.empty() ? family.name : family.name + ' ' + filled(family.place, position);
}

namespace {

/// The counted features and their weights. The weights were found by hill climbing from a guess, one or a few weights
/// at a time, judged by replays of real meshes from 2 % to 100 %; docs/reference/tables.md has the figures.
struct TieWeights {
  int solid_chord;         ///< the chord is solid
  int joined_pair;         ///< two ports are joined inside
  int end_facing_out;      ///< a strip ends at a fan triangle with a dashed port, where it may continue later
  int end_at_port;         ///< a strip enters by a port and ends at once
  int end_at_new;          ///< a strip ends at A or D
  int neighbouring_ends;   ///< an inner edge between two strip ends
  int square_of_ports;     ///< for each strip, the square of the fan triangles it covers: favours long strips
  int solid_at_new;        ///< a solid edge of A or D
  int solid_in_first_arc;  ///< a solid edge between A and D on the side of the first arc
};

constexpr TieWeights weight{64, -49, -53, -4, 100, -11, -14, 64, 7};

/// Inner edges with this many ends among the nodes.
Mask edges_at(const Side& side, Mask nodes, int ends) {
  Mask edges = 0;
  for (std::size_t e = 0; e < side.edges.size(); ++e)
    if (static_cast<int>(nodes >> side.edges[e].u & 1U) + static_cast<int>(nodes >> side.edges[e].v & 1U) == ends)
      edges |= Mask{1} << e;
  return edges;
}

}  // namespace

Criterion tie_break(const Position& position, const Side& after) {
  const Description& family = *position.family;
  if (family.own_cost || family.constraint.most_edges != 2) return {};
  // If one of two ports must be given up, either is possible; this has always been the flip's choice.
  if (family.numbers.empty())
    return family.author == Author::restrip ? Criterion{{Count::kept, -1, 0b0101}} : Criterion{};
  Mask fan = 0;
  for (const unsigned owner : after.owner) fan |= Mask{1} << owner;
  const Mask added = ((Mask{1} << after.nodes) - 1) & ~fan;
  Criterion terms{{Count::ends, weight.end_facing_out, fan},
                  {Count::ends_at_port, weight.end_at_port - weight.end_facing_out, fan},
                  {Count::ends, weight.end_at_new, added},
                  {Count::neighbouring_ends, weight.neighbouring_ends},
                  {Count::squares, weight.square_of_ports},
                  {Count::joined, weight.joined_pair},
                  {Count::solid, weight.solid_at_new, edges_at(after, added, 1)},
                  {Count::solid, 2 * std::int64_t{weight.solid_at_new}, edges_at(after, added, 2)}};
  if (const auto* side = std::get_if<Fan>(&family.after); side != nullptr && side->chord) {
    const Mask chord = Mask{1} << (after.edges.size() - 1);
    const Mask first_arc = (Mask{2} << position.at) - 1;
    terms.push_back({Count::solid, weight.solid_chord, chord});
    terms.push_back({Count::solid, weight.solid_in_first_arc, first_arc});
  }
  return terms;
}

Operation operation_of_rows(const Position& position) {
  Operation operation = operation_at(position, patch_of_rows(position));
  operation.tie_break = tie_break(position, operation.patch.after);
  return operation;
}

}  // namespace restrip::generator
