#include "automaton/fan_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "model/coloring.hpp"

namespace restrip::verify {
namespace {

/// "k 8 gaps 2 5" as a place of its family.
FanPlace place_of(const Family& family, const Section& section) {
  for (const FanPlace& place : all_places(section.ports))
    if (place.family == family.name &&
        (place.text() == family.name + ' ' + section.position || section.serves_every_position))
      return place;
  throw std::logic_error("no place " + family.name + ' ' + section.position);
}

/// The key of a row of a table of fans: bit i of `joined` is set if port i is joined to the solid port before it.
FanKey fan_key(const Key& key, const FanPlace& place) {
  Mask joined = 0;
  for (unsigned port = 0; port < place.k; ++port) {
    if (!is_solid(key.ports, port)) continue;
    for (unsigned step = 1; step < place.k && (place.closed() || step <= port); ++step) {
      const unsigned before = (port + place.k - step) % place.k;
      if (!is_solid(key.ports, before)) continue;
      if (key.joined.has(before, port)) joined |= single(port);
      break;
    }
  }
  return {key.ports, joined};
}

/// The patch after the operation, by docs/reference/notation.md.
Side patch_by_notation(const FanPlace& place) {
  const bool has_d = place.family == "split" || place.family == "open-split";
  const bool has_a = has_d || place.family == "boundary-split";
  const unsigned gap_a = place.family == "split" ? 0 : place.a;
  const unsigned gap_d = place.family == "split" ? place.a : place.b;
  Side side;
  unsigned a = 0;
  unsigned d = 0;
  for (unsigned i = 0; i <= place.k; ++i) {
    if (has_a && i == gap_a) a = side.triangles++;
    if (has_d && i == gap_d) d = side.triangles++;
    if (i < place.k) side.owner_of_port.push_back(side.triangles++);
  }
  for (unsigned t = 0; t + 1 < side.triangles; ++t) side.edges.push_back({t, t + 1});
  if (place.closed()) side.edges.push_back({side.triangles - 1, 0});
  if (has_d) side.edges.push_back({a, d});
  return side;
}

/// A colouring of the inner edges of a patch without ports: degrees at most two and no cycle.
struct InnerColoring {
  Mask inner = 0;
  Mask full = 0;                                      ///< ports of triangles with two solid inner edges
  Mask lonely = 0;                                    ///< ports of triangles with none
  int isolated = 0;                                   ///< triangles without a port and without a solid edge
  std::vector<std::pair<unsigned, unsigned>> joined;  ///< ports that a strip joins if they are solid
};

std::vector<InnerColoring> inner_colorings(const Side& side) {
  std::vector<InnerColoring> all;
  for (Mask inner = 0; inner < mask_count(side.inner_edges()); ++inner) {
    const std::optional<SolidGraph> graph = valid_graph(side, {inner, 0}, most_solid(Constraint::strips));
    if (!graph) continue;
    InnerColoring& coloring = all.emplace_back();
    coloring.inner = inner;
    const Degrees degree = degrees(side, {inner, 0});
    for (unsigned port = 0; port < side.ports(); ++port) {
      if (degree[side.owner_of_port[port]] == 2) coloring.full |= single(port);
      if (degree[side.owner_of_port[port]] == 0) coloring.lonely |= single(port);
    }
    coloring.isolated = static_cast<int>(isolated_of(side, {inner, 0}) - solid_count(coloring.lonely));
    for (unsigned j = 1; j < side.ports(); ++j)
      for (unsigned i = 0; i < j; ++i)
        if (!is_solid(coloring.full, i) && !is_solid(coloring.full, j) &&
            graph->connected(side.owner_of_port[i], side.owner_of_port[j]))
          coloring.joined.emplace_back(i, j);
  }
  return all;
}

/// All keys of one place: every colouring is tried.
void check_place(const AutomatonReader& reader, const FanPlace& place, FanCheck& check) {
  struct Sound {
    Mask joins = 0;  ///< the key's bits for its joins
    int cost = 0;    ///< minus the restarts of all triangles
  };
  const Side side = patch_by_notation(place);
  const std::vector<InnerColoring> colorings = inner_colorings(side);
  for (Mask ports = 0; ports < mask_count(place.k); ++ports) {
    std::vector<std::optional<unsigned>> port_before(place.k);
    Mask joinable = 0;  // the possible bits of `joined`: solid ports with a predecessor
    for (unsigned port = 0; port < place.k; ++port) {
      for (unsigned step = 1; step < place.k && (place.closed() || step <= port) && !port_before[port]; ++step)
        if (const unsigned candidate = (port + place.k - step) % place.k; is_solid(ports, candidate))
          port_before[port] = candidate;
      if (is_solid(ports, port) && port_before[port]) joinable |= single(port);
    }
    // If each of two ports precedes the other, a key has both bits or none.
    const bool two_in_ring = place.closed() && solid_count(ports) == 2;

    // The recolourings that are sound for some key with these ports, and the least cost for each key.
    std::vector<std::optional<Sound>> sound(mask_count(side.inner_edges()));
    std::vector<int> least(mask_count(place.k), std::numeric_limits<int>::max());
    for (const InnerColoring& coloring : colorings) {
      bool is_sound = (coloring.full & ports) == 0;
      Mask joins = 0;
      for (const auto& [one, other] : coloring.joined) {
        if (!is_solid(ports, one) || !is_solid(ports, other)) continue;
        if (two_in_ring)
          joins = ports;
        else if (port_before[one] == other)
          joins |= single(one);
        else if (port_before[other] == one)
          joins |= single(other);
        else
          is_sound = false;
      }
      if (!is_sound) continue;
      const int isolated = coloring.isolated + static_cast<int>(solid_count(coloring.lonely & ~ports));
      const int cost = isolated_cost * isolated - strip_cost * static_cast<int>(solid_count(coloring.inner));
      sound[coloring.inner] = Sound{joins, cost};
      least[joins] = std::min(least[joins], cost);
    }
    // A recolouring sound for a key is sound for a key that joins more.
    for (unsigned port = 0; port < place.k; ++port)
      for (Mask joined = 0; joined < mask_count(place.k); ++joined)
        if (is_solid(joined, port)) least[joined] = std::min(least[joined], least[joined & ~single(port)]);

    for (Mask joined = 0; joined < mask_count(place.k); ++joined) {
      if (!is_subset(joined, joinable) || (two_in_ring && joined != 0 && joined != ports)) continue;
      ++check.keys;
      const FanKey key{ports, joined};
      const AutomatonAnswer answer = reader.answer(place, key);
      const std::optional<Sound> found = answer.inner < sound.size() ? sound[answer.inner] : std::nullopt;
      const auto wrong = [&](const char* what) {
        check.failures.add(fmt::format("{}, {}: {:x} {}", place.text(), key.text(), answer.inner, what));
      };
      if (!found || !is_subset(found->joins, joined))
        wrong("is not sound");
      else if (found->cost != answer.cost)
        wrong("does not have the stated cost");
      else if (answer.cost != least[joined])
        wrong("is not the best");
    }
  }
}

}  // namespace

FanCheck check_against_search(const AutomatonCertificate& certificate, unsigned k, unsigned every) {
  FanCheck check;
  const AutomatonReader reader(certificate);
  const std::vector<FanPlace> places = all_places(k);
  for (std::size_t i = 0; i < places.size(); i += every) {
    ++check.places;
    check_place(reader, places[i], check);
  }
  return check;
}

FanCheck check_against_rows(const AutomatonCertificate& certificate, const Family& family, const Certificate& rows) {
  FanCheck check;
  const AutomatonReader reader(certificate);
  for (std::size_t s = 0; s < family.sections.size(); ++s) {
    const FanPlace place = place_of(family, family.sections[s]);
    const Side after = patch_after(place.family, {place.k, place.a, place.b});
    ++check.places;
    for (const Row& row : rows.sections[s].rows) {
      ++check.keys;
      const FanKey key = fan_key(row.key, place);
      const AutomatonAnswer answer = reader.answer(place, key);
      const Survey of_row = survey(after, row.after);
      check.same += answer.inner == row.after.inner ? 1U : 0U;
      if (answer.cost != isolated_cost * static_cast<int>(of_row.isolated) -
                             strip_cost * static_cast<int>(solid_count(row.after.inner)))
        check.failures.add(fmt::format("{}:{}: {}, the answer {} differs in value from this rule", rows.file, row.line,
                                       place.text(), key.text()));
    }
  }
  return check;
}

}  // namespace restrip::verify
