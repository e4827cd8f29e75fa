#include "automaton/fan_search.hpp"

#include <algorithm>

namespace restrip::verify {
namespace {

CornerNumber common_corner(const MeshEdge& one, const MeshEdge& other) {
  return one[0] == other[0] || one[0] == other[1] ? one[0] : one[1];
}

}  // namespace

FanSearch::FanSearch(const FanPlace& place, const Weights& weights) : place_(place), weights_(weights) {
  const auto rim = [&](unsigned i) { return static_cast<CornerNumber>(2 + (place.closed() ? i % place.k : i)); };
  const bool has_a = place.family == "split" || place.family == "open-split" || place.family == "boundary-split";
  const bool has_d = place.family == "split" || place.family == "open-split";
  const unsigned gap_a = place.family == "split" ? 0 : place.a;
  const unsigned gap_d = place.family == "split" ? place.a : has_d ? place.b : place.k;
  std::size_t a = 0;
  std::size_t d = 0;
  const auto add_new = [&](unsigned gap) {
    triangles_.push_back({0, 1, rim(gap)});
    port_of_.emplace_back();
    return triangles_.size() - 1;
  };
  for (unsigned i = 0; i <= place.k; ++i) {
    if (has_a && i == gap_a) a = add_new(i);
    if (has_d && i == gap_d) d = add_new(i);
    if (i == place.k) break;
    const CornerNumber hub = has_a && gap_a <= i && i < gap_d ? 1 : 0;
    triangles_.push_back({hub, rim(i), rim(i + 1)});
    port_of_.emplace_back(i);
    ports_.push_back({rim(i), rim(i + 1)});
  }
  for (std::size_t t = 0; t + 1 < triangles_.size(); ++t) add_inner(t, t + 1);
  if (place.closed()) add_inner(triangles_.size() - 1, 0);
  if (has_d) add_inner(a, d);
  for (Mask inner = 0; inner < end_of_inner(); ++inner)
    if (auto coloring = survey_inner(inner)) legal_.push_back(std::move(*coloring));
}

void FanSearch::add_inner(std::size_t one, std::size_t other) {
  MeshEdge crossed{no_corner, no_corner};
  for (const CornerNumber corner : triangles_[one])
    for (const CornerNumber same : triangles_[other])
      if (corner == same) crossed[crossed[0] == no_corner ? 0 : 1] = corner;
  inner_.push_back({one, other, crossed});
}

std::optional<InnerColoring> FanSearch::survey_inner(Mask inner) const {
  const std::size_t n = triangles_.size();
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
    result.passed.push_back(own.size() == 2 ? common_corner(inner_[own[0]].crossed, inner_[own[1]].crossed)
                                            : no_corner);
    result.passed_to_port.push_back(own.size() == 1 && port ? common_corner(inner_[own[0]].crossed, ports_[*port])
                                                            : no_corner);
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
  result.cost = weights_.isolated * isolated - weights_.restart * static_cast<int>(solid_count(coloring.inner));
  if (!weights_.tells_turns()) return result;
  const auto passed = [&](std::size_t t) {
    const bool to_port = port_of_[t] && is_solid(ports, *port_of_[t]);
    return (to_port ? coloring.passed_to_port : coloring.passed)[t];
  };
  for (unsigned e = 0; e < inner_.size(); ++e) {
    if (!is_solid(coloring.inner, e)) continue;
    const CornerNumber corner = passed(inner_[e].one);
    if (corner != no_corner && corner == passed(inner_[e].other)) result.cost += weights_.swap;
  }
  result.port_corners.assign(place_.k, no_corner);
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (port_of_[t] && is_solid(ports, *port_of_[t])) result.port_corners[*port_of_[t]] = passed(t);
  return result;
}

std::vector<FanSearch::Sound> FanSearch::colorings(Mask ports) const {
  std::vector<Sound> list;
  for (const InnerColoring& coloring : legal_)
    if (auto sound = with_ports(coloring, ports)) list.push_back(std::move(*sound));
  return list;
}

std::vector<CornerNumber> FanSearch::behind(const FanKey& key) const {
  std::vector<CornerNumber> corners;
  for (unsigned i = 0; i < place_.k; ++i)
    corners.push_back(is_solid(key.left, i) ? ports_[i][0] : is_solid(key.right, i) ? ports_[i][1] : no_corner);
  return corners;
}

int FanSearch::cost(const Sound& coloring, const std::vector<CornerNumber>& behind) const {
  int cost = coloring.cost;
  for (unsigned i = 0; i < coloring.port_corners.size(); ++i)
    if (coloring.port_corners[i] != no_corner && coloring.port_corners[i] == behind[i]) cost += weights_.swap;
  return cost;
}

}  // namespace restrip::verify
