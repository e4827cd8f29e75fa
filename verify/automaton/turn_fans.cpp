#include "turn_fans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "automaton_mutants.hpp"

namespace restrip::verify {
namespace {

/// A corner of a triangle: the two ends of the new mesh edge, one of which is the hub where there is none, and the
/// corners of the rim.
using CornerNumber = int;
constexpr CornerNumber no_corner = -1;
using MeshEdge = std::array<CornerNumber, 2>;

CornerNumber common_corner(const MeshEdge& one, const MeshEdge& other) {
  return one[0] == other[0] || one[0] == other[1] ? one[0] : one[1];
}

/// Triangles in the order of docs/notation.md, each edge with the mesh edge that it crosses.
struct CornerPatch {
  struct Triangle {
    std::array<CornerNumber, 3> corners{};
    std::optional<unsigned> port;
  };
  struct Inner {
    std::size_t one;
    std::size_t other;
    MeshEdge crossed;
  };
  std::vector<Triangle> triangles;
  std::vector<Inner> inner;
  std::vector<MeshEdge> ports;

  explicit CornerPatch(const FanPlace& place) {
    const auto rim = [&](unsigned i) { return static_cast<CornerNumber>(2 + (place.closed() ? i % place.k : i)); };
    const bool has_a = place.family == "split" || place.family == "open-split" || place.family == "boundary-split";
    const bool has_d = place.family == "split" || place.family == "open-split";
    const unsigned gap_a = place.family == "split" ? 0 : place.a;
    const unsigned gap_d = place.family == "split" ? place.a : has_d ? place.b : place.k;
    std::size_t a = 0;
    std::size_t d = 0;
    for (unsigned i = 0; i <= place.k; ++i) {
      if (has_a && i == gap_a) {
        a = triangles.size();
        triangles.push_back({{0, 1, rim(i)}, {}});
      }
      if (has_d && i == gap_d) {
        d = triangles.size();
        triangles.push_back({{0, 1, rim(i)}, {}});
      }
      if (i == place.k) break;
      const CornerNumber hub = has_a && gap_a <= i && i < gap_d ? 1 : 0;
      triangles.push_back({{hub, rim(i), rim(i + 1)}, i});
      ports.push_back({rim(i), rim(i + 1)});
    }
    for (std::size_t t = 0; t + 1 < triangles.size(); ++t) add(t, t + 1);
    if (place.closed()) add(triangles.size() - 1, 0);
    if (has_d) add(a, d);
  }

 private:
  void add(std::size_t one, std::size_t other) {
    MeshEdge crossed{no_corner, no_corner};
    for (const CornerNumber corner : triangles[one].corners)
      for (const CornerNumber same : triangles[other].corners)
        if (corner == same) crossed[crossed[0] == no_corner ? 0 : 1] = corner;
    inner.push_back({one, other, crossed});
  }
};

/// A recolouring that is sound for some key with certain ports.
struct SoundColoring {
  Mask inner = 0;
  Mask joins = 0;                          ///< the key's bits of what it joins
  int cost = 0;                            ///< but for swaps at ports
  std::vector<CornerNumber> port_corners;  ///< about which strips pass the triangles of solid ports
};

class TurnSearch {
 public:
  TurnSearch(const FanPlace& place, const TurnWeights& weights) : place_(place), weights_(weights), patch_(place) {}

  /// All recolourings that are sound for some key with these ports.
  std::vector<SoundColoring> colorings(Mask ports) const {
    std::vector<SoundColoring> list;
    for (Mask inner = 0; inner < mask_count(static_cast<unsigned>(patch_.inner.size())); ++inner)
      if (auto coloring = survey_turns(inner, ports)) list.push_back(std::move(*coloring));
    return list;
  }

  /// What lies behind the ports, as corners.
  std::vector<CornerNumber> behind(const TurnKey& key) const {
    std::vector<CornerNumber> corners;
    const bool no_right = mutated(AutomatonMutant::turns_search_one_side);
    for (unsigned i = 0; i < place_.k; ++i)
      corners.push_back(is_solid(key.left, i)                 ? patch_.ports[i][0]
                        : is_solid(key.right, i) && !no_right ? patch_.ports[i][1]
                                                              : no_corner);
    return corners;
  }

  int cost(const SoundColoring& coloring, const std::vector<CornerNumber>& behind) const {
    int cost = coloring.cost;
    for (unsigned i = 0; i < place_.k; ++i)
      if (coloring.port_corners[i] != no_corner && coloring.port_corners[i] == behind[i]) cost += weights_.swap;
    return cost;
  }

  bool two_in_ring(Mask ports) const { return place_.closed() && solid_count(ports) == 2; }

  /// The bits that `joined` may have: solid ports that have a predecessor.
  Mask joinable(Mask ports) const {
    Mask mask = 0;
    for (unsigned port = 0; port < place_.k; ++port)
      if (is_solid(ports, port) && port_before(port, ports)) mask |= single(port);
    return mask;
  }

 private:
  std::optional<unsigned> port_before(unsigned port, Mask ports) const {
    for (unsigned step = 1; step < place_.k; ++step) {
      if (!place_.closed() && step > port) return {};
      const unsigned candidate = (port + place_.k - step) % place_.k;
      if (is_solid(ports, candidate)) return candidate;
    }
    return {};
  }

  std::optional<SoundColoring> survey_turns(Mask inner, Mask ports) const {
    const std::size_t n = patch_.triangles.size();
    std::vector<std::vector<MeshEdge>> crossed(n);
    std::vector<std::vector<std::size_t>> neighbors(n);
    SoundColoring result;
    result.inner = inner;
    for (unsigned e = 0; e < patch_.inner.size(); ++e) {
      if (!is_solid(inner, e)) continue;
      const auto& edge = patch_.inner[e];
      crossed[edge.one].push_back(edge.crossed);
      crossed[edge.other].push_back(edge.crossed);
      neighbors[edge.one].push_back(edge.other);
      neighbors[edge.other].push_back(edge.one);
      result.cost -= weights_.restart;
    }
    std::vector<bool> solid_port(n, false);
    for (std::size_t t = 0; t < n; ++t) {
      const auto port = patch_.triangles[t].port;
      solid_port[t] = port && is_solid(ports, *port);
      if (solid_port[t]) crossed[t].push_back(patch_.ports[*port]);
      if (crossed[t].size() > 2) return {};
      if (crossed[t].empty()) result.cost += weights_.isolated;
    }
    const auto passed_about = [&](std::size_t t) {
      return crossed[t].size() == 2 ? common_corner(crossed[t][0], crossed[t][1]) : no_corner;
    };
    for (unsigned e = 0; e < patch_.inner.size(); ++e) {
      if (!is_solid(inner, e)) continue;
      const CornerNumber corner = passed_about(patch_.inner[e].one);
      if (mutated(AutomatonMutant::turns_search_no_swap)) continue;
      if (corner != no_corner && corner == passed_about(patch_.inner[e].other)) result.cost += weights_.swap;
    }
    result.port_corners.assign(place_.k, no_corner);
    std::vector<bool> visited(n, false);
    for (std::size_t start = 0; start < n; ++start) {
      if (solid_port[start]) result.port_corners[*patch_.triangles[start].port] = passed_about(start);
      if (neighbors[start].size() > 1 || visited[start]) continue;
      const std::size_t end = walk(start, neighbors, visited);
      if (end == start || !solid_port[start] || !solid_port[end]) continue;
      const auto joins = key_bits(*patch_.triangles[start].port, *patch_.triangles[end].port, ports);
      if (!joins) return {};
      result.joins |= *joins;
    }
    if (std::find(visited.begin(), visited.end(), false) != visited.end()) return {};  // a cycle has no end
    return result;
  }

  static std::size_t walk(std::size_t at, const std::vector<std::vector<std::size_t>>& neighbors,
                          std::vector<bool>& visited) {
    while (true) {
      visited[at] = true;
      const auto next =
          std::find_if(neighbors[at].begin(), neighbors[at].end(), [&](std::size_t t) { return !visited[t]; });
      if (next == neighbors[at].end()) return at;
      at = *next;
    }
  }

  /// The bits that say of two ports that they are joined; nothing where no key says so.
  std::optional<Mask> key_bits(unsigned one, unsigned other, Mask ports) const {
    if (two_in_ring(ports)) return ports;
    if (port_before(one, ports) == other) return single(one);
    if (port_before(other, ports) == one) return single(other);
    return {};
  }

  FanPlace place_;
  TurnWeights weights_;
  CornerPatch patch_;
};

/// All keys of one place with certain ports.
void check_ports(const TurnReader& reader, const TurnSearch& search, const FanPlace& place, Mask ports,
                 FanCheck& check) {
  const std::vector<SoundColoring> colorings = search.colorings(ports);
  const Mask joinable = search.joinable(ports);
  TurnKey key{ports, 0, 0, 0};
  const auto check_behind = [&] {
    const std::vector<CornerNumber> behind = search.behind(key);
    std::vector<int> least(mask_count(place.k), std::numeric_limits<int>::max());
    for (const SoundColoring& coloring : colorings)
      least[coloring.joins] = std::min(least[coloring.joins], search.cost(coloring, behind));
    for (unsigned port = 0; port < place.k; ++port)
      for (Mask joined = 0; joined < mask_count(place.k); ++joined)
        if (is_solid(joined, port)) least[joined] = std::min(least[joined], least[joined & ~single(port)]);
    for (Mask joined = 0; joined < mask_count(place.k); ++joined) {
      if (!is_subset(joined, joinable)) continue;
      // Where each of two ports precedes the other, a key has both bits or none.
      if (search.two_in_ring(ports) && joined != 0 && joined != ports) continue;
      ++check.keys;
      key.joined = joined;
      const TurnAnswer answer = reader.answer(place, key);
      const auto found = std::find_if(colorings.begin(), colorings.end(),
                                      [&](const SoundColoring& c) { return c.inner == answer.inner; });
      const auto wrong = [&](const char* what) {
        check.failures.add(fmt::format("{}, {}: {:x} {}", place.text(), key.text(), answer.inner, what));
      };
      if (found == colorings.end() || !is_subset(found->joins, joined))
        wrong("is not sound");
      else if (search.cost(*found, behind) != answer.cost)
        wrong("does not cost what is stated");
      else if (answer.cost != least[joined])
        wrong("is not the best");
    }
  };
  for (Mask left = 0; left < mask_count(place.k); ++left)
    for (Mask right = 0; right < mask_count(place.k); ++right) {
      if (!is_subset(left, ports) || !is_subset(right, ports & ~left)) continue;
      key.left = left;
      key.right = right;
      check_behind();
    }
}

}  // namespace

FanCheck check_turns_against_search(const TurnCertificate& certificate, unsigned k, unsigned every) {
  FanCheck check;
  const TurnReader reader(certificate);
  const std::vector<FanPlace> places = all_places(k);
  for (std::size_t i = 0; i < places.size(); i += every) {
    const TurnSearch search(places[i], certificate.weights);
    ++check.places;
    for (Mask ports = 0; ports < mask_count(k); ++ports) check_ports(reader, search, places[i], ports, check);
  }
  return check;
}

}  // namespace restrip::verify
