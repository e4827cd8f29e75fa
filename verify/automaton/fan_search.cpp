#include "automaton/fan_search.hpp"

#include <algorithm>

namespace restrip::verify {
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
    if (auto sound = with_ports(coloring, ports)) list.push_back(std::move(*sound));
  return list;
}

}  // namespace restrip::verify
