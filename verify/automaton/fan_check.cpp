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

/// A colouring of the inner edges of a patch without ports: degrees at most two and no cycle.
struct InnerColoring {
  Mask inner = 0;
  Mask full = 0;                                      ///< ports of triangles with two solid inner edges
  Mask lonely = 0;                                    ///< ports of triangles with none
  int isolated = 0;                                   ///< triangles without a port and without a solid edge
  std::vector<std::pair<unsigned, unsigned>> joined;  ///< ports that a strip joins if they are solid
};

/// The best sound recolouring of a fan for every key, by plain search: every colouring tried, every strip walked.
class FanSearch {
 public:
  explicit FanSearch(const FanPlace& place);

  /// A recolouring that is sound for some key with certain ports.
  struct Sound {
    Mask inner = 0;
    Mask joins = 0;  ///< the key's bits for its joins
    int cost = 0;    ///< minus the restarts of all triangles
  };
  std::vector<Sound> colorings(Mask ports) const;

  /// The possible bits of `joined`: solid ports with a predecessor.
  Mask joinable(Mask ports) const;
  /// If each of two ports precedes the other, a key has both bits or none.
  bool two_in_ring(Mask ports) const { return place_.closed() && solid_count(ports) == 2; }
  Mask end_of_inner() const { return mask_count(static_cast<unsigned>(inner_.size())); }

 private:
  struct Inner {
    std::size_t one;
    std::size_t other;
  };
  std::optional<InnerColoring> survey_inner(Mask inner) const;
  std::optional<Sound> with_ports(const InnerColoring& coloring, Mask ports) const;
  std::optional<unsigned> port_before(unsigned port, Mask ports) const;

  FanPlace place_;
  std::vector<std::optional<unsigned>> port_of_;  ///< of each triangle, in the order of docs/reference/notation.md
  std::vector<Inner> inner_;
  std::vector<InnerColoring> legal_;
};

FanSearch::FanSearch(const FanPlace& place) : place_(place) {
  const bool has_a = place.family == "split" || place.family == "open-split" || place.family == "boundary-split";
  const bool has_d = place.family == "split" || place.family == "open-split";
  const unsigned gap_a = place.family == "split" ? 0 : place.a;
  const unsigned gap_d = place.family == "split" ? place.a : place.b;
  std::size_t a = 0;
  std::size_t d = 0;
  const auto add_new = [&] {
    port_of_.emplace_back();
    return port_of_.size() - 1;
  };
  for (unsigned i = 0; i <= place.k; ++i) {
    if (has_a && i == gap_a) a = add_new();
    if (has_d && i == gap_d) d = add_new();
    if (i < place.k) port_of_.emplace_back(i);
  }
  for (std::size_t t = 0; t + 1 < port_of_.size(); ++t) inner_.push_back({t, t + 1});
  if (place.closed()) inner_.push_back({port_of_.size() - 1, 0});
  if (has_d) inner_.push_back({a, d});
  for (Mask inner = 0; inner < end_of_inner(); ++inner)
    if (auto coloring = survey_inner(inner)) legal_.push_back(std::move(*coloring));
}

std::optional<InnerColoring> FanSearch::survey_inner(Mask inner) const {
  const std::size_t n = port_of_.size();
  std::vector<std::vector<unsigned>> edges(n);
  for (unsigned e = 0; e < inner_.size(); ++e)
    if (is_solid(inner, e)) {
      edges[inner_[e].one].push_back(e);
      edges[inner_[e].other].push_back(e);
    }
  InnerColoring result;
  result.inner = inner;
  for (std::size_t t = 0; t < n; ++t) {
    const auto& own = edges[t];
    if (own.size() > 2) return {};
    const auto port = port_of_[t];
    if (port && own.size() == 2) result.full |= single(*port);
    if (port && own.empty()) result.lonely |= single(*port);
    if (!port && own.empty()) ++result.isolated;
  }
  std::vector<bool> visited(n, false);
  for (std::size_t start = 0; start < n; ++start) {
    if (edges[start].size() > 1 || visited[start]) continue;
    std::size_t at = start;
    for (bool moved = true; moved;) {
      visited[at] = true;
      moved = false;
      for (const unsigned e : edges[at]) {
        const std::size_t next = inner_[e].one == at ? inner_[e].other : inner_[e].one;
        if (visited[next]) continue;
        at = next;
        moved = true;
        break;
      }
    }
    if (at != start && port_of_[start] && port_of_[at]) result.joined.emplace_back(*port_of_[start], *port_of_[at]);
  }
  if (std::find(visited.begin(), visited.end(), false) != visited.end()) return {};  // a cycle has no end
  return result;
}

std::optional<unsigned> FanSearch::port_before(unsigned port, Mask ports) const {
  for (unsigned step = 1; step < place_.k; ++step) {
    if (!place_.closed() && step > port) return {};
    const unsigned candidate = (port + place_.k - step) % place_.k;
    if (is_solid(ports, candidate)) return candidate;
  }
  return {};
}

Mask FanSearch::joinable(Mask ports) const {
  Mask mask = 0;
  for (unsigned port = 0; port < place_.k; ++port)
    if (is_solid(ports, port) && port_before(port, ports)) mask |= single(port);
  return mask;
}

std::optional<FanSearch::Sound> FanSearch::with_ports(const InnerColoring& coloring, Mask ports) const {
  if ((coloring.full & ports) != 0) return {};
  Sound result;
  result.inner = coloring.inner;
  for (const auto& [one, other] : coloring.joined) {
    if (!is_solid(ports, one) || !is_solid(ports, other)) continue;
    if (two_in_ring(ports))
      result.joins = ports;
    else if (port_before(one, ports) == other)
      result.joins |= single(one);
    else if (port_before(other, ports) == one)
      result.joins |= single(other);
    else
      return {};
  }
  const int isolated = coloring.isolated + static_cast<int>(solid_count(coloring.lonely & ~ports));
  result.cost = isolated_cost * isolated - strip_cost * static_cast<int>(solid_count(coloring.inner));
  return result;
}

std::vector<FanSearch::Sound> FanSearch::colorings(Mask ports) const {
  std::vector<Sound> list;
  for (const InnerColoring& coloring : legal_)
    if (auto sound = with_ports(coloring, ports)) list.push_back(*sound);
  return list;
}

/// All keys of one place with certain ports.
void check_keys(const AutomatonReader& reader, const FanSearch& search, const FanPlace& place, Mask ports,
                FanCheck& check) {
  constexpr auto nowhere = std::numeric_limits<std::size_t>::max();
  const std::vector<FanSearch::Sound> colorings = search.colorings(ports);
  std::vector<std::size_t> place_of_inner(search.end_of_inner(), nowhere);  // in `colorings`
  std::vector<int> least(mask_count(place.k), std::numeric_limits<int>::max());
  for (std::size_t i = 0; i < colorings.size(); ++i) {
    place_of_inner[colorings[i].inner] = i;
    least[colorings[i].joins] = std::min(least[colorings[i].joins], colorings[i].cost);
  }
  // A recolouring sound for a key is sound for a key that joins more.
  for (unsigned port = 0; port < place.k; ++port)
    for (Mask joined = 0; joined < mask_count(place.k); ++joined)
      if (is_solid(joined, port)) least[joined] = std::min(least[joined], least[joined & ~single(port)]);
  const Mask joinable = search.joinable(ports);
  for (Mask joined = 0; joined < mask_count(place.k); ++joined) {
    if (!is_subset(joined, joinable) || (search.two_in_ring(ports) && joined != 0 && joined != ports)) continue;
    ++check.keys;
    const FanKey key{ports, joined};
    const AutomatonAnswer answer = reader.answer(place, key);
    const std::size_t found = answer.inner < place_of_inner.size() ? place_of_inner[answer.inner] : nowhere;
    const auto wrong = [&](const char* what) {
      check.failures.add(fmt::format("{}, {}: {:x} {}", place.text(), key.text(), answer.inner, what));
    };
    if (found == nowhere || !is_subset(colorings[found].joins, joined))
      wrong("is not sound");
    else if (colorings[found].cost != answer.cost)
      wrong("does not have the stated cost");
    else if (answer.cost != least[joined])
      wrong("is not the best");
  }
}

}  // namespace

FanCheck check_against_search(const AutomatonCertificate& certificate, unsigned k, unsigned every) {
  FanCheck check;
  const AutomatonReader reader(certificate);
  const std::vector<FanPlace> places = all_places(k);
  for (std::size_t i = 0; i < places.size(); i += every) {
    const FanSearch search(places[i]);
    ++check.places;
    for (Mask ports = 0; ports < mask_count(k); ++ports) check_keys(reader, search, places[i], ports, check);
  }
  return check;
}

FanCheck check_against_rows(const AutomatonCertificate& certificate, const Family& family, const Certificate& rows) {
  FanCheck check;
  const AutomatonReader reader(certificate);
  for (std::size_t s = 0; s < family.sections.size(); ++s) {
    const FanPlace place = place_of(family, family.sections[s]);
    const Side after = patch_after(place);
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
