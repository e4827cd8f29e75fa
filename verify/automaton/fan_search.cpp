#include "fan_search.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace restrip::verify {
namespace {

constexpr Worth nothing{-1000, 0};

/// The triangles of a patch as numbers, with their inner edges and ports.
struct PlainPatch {
  struct Side {
    unsigned edge;
    unsigned to;
  };
  std::vector<std::vector<Side>> sides;
  std::vector<std::optional<unsigned>> port;  ///< of each triangle
  unsigned edges = 0;

  explicit PlainPatch(const Patch& patch) : sides(patch.triangles().size()), port(patch.triangles().size()) {
    const DualGraph& graph = patch.graph();
    const auto number = [&](Node node) {
      const auto found = std::find(patch.triangles().begin(), patch.triangles().end(), node);
      return static_cast<unsigned>(found - patch.triangles().begin());
    };
    for (auto [edge, end] = boost::edges(graph); edge != end; ++edge) {
      if (graph[*edge].kind != EdgeKind::inner) continue;
      const unsigned u = number(boost::source(*edge, graph));
      const unsigned v = number(boost::target(*edge, graph));
      sides[u].push_back({graph[*edge].index, v});
      sides[v].push_back({graph[*edge].index, u});
    }
    for (unsigned p = 0; p < patch.ports(); ++p) port[number(patch.owner_of_port(p))] = p;
    edges = patch.inner_edges();
  }
};

/// One colouring, its strips walked; nullopt when it is not legal.
std::optional<InnerColoring> survey_inner(const PlainPatch& patch, Mask inner) {
  InnerColoring result;
  result.inner = inner;
  const auto n = static_cast<unsigned>(patch.sides.size());
  std::vector<unsigned> degree(n, 0);
  for (unsigned t = 0; t < n; ++t) {
    for (const auto& side : patch.sides[t]) degree[t] += is_solid(inner, side.edge) ? 1U : 0U;
    if (degree[t] > 2) return {};
    if (patch.port[t] && degree[t] == 2) result.full |= single(*patch.port[t]);
    if (patch.port[t] && degree[t] == 0) result.lonely |= single(*patch.port[t]);
    if (!patch.port[t] && degree[t] == 0) ++result.isolated;
  }
  std::vector<bool> visited(n, false);
  for (unsigned start = 0; start < n; ++start) {
    if (degree[start] > 1 || visited[start]) continue;
    unsigned at = start;
    visited[at] = true;
    for (bool moved = true; moved;) {
      moved = false;
      for (const auto& side : patch.sides[at]) {
        if (!is_solid(inner, side.edge) || visited[side.to]) continue;
        at = side.to;
        visited[at] = true;
        moved = true;
        break;
      }
    }
    if (at != start && patch.port[start] && patch.port[at])
      result.joined.emplace_back(*patch.port[start], *patch.port[at]);
  }
  if (std::find(visited.begin(), visited.end(), false) != visited.end()) return {};  // a cycle has no end
  return result;
}

}  // namespace

FanSearch::FanSearch(const FanPlace& place) : place_(place) {
  const PlainPatch patch(patch_after(place));
  const Mask end = mask_count(patch.edges);
  place_of_inner_.assign(end, -1);
  for (Mask inner = 0; inner < end; ++inner) {
    auto coloring = survey_inner(patch, inner);
    if (!coloring) continue;
    place_of_inner_[inner] = static_cast<int>(colorings_.size());
    colorings_.push_back(std::move(*coloring));
  }
}

std::optional<unsigned> FanSearch::predecessor(unsigned port, Mask ports) const {
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
    if (is_solid(ports, port) && predecessor(port, ports)) mask |= single(port);
  return mask;
}

std::optional<std::pair<Worth, Mask>> FanSearch::outcome(const InnerColoring& coloring, Mask ports) const {
  if ((coloring.full & ports) != 0) return {};
  Mask joins = 0;
  for (const auto& [one, other] : coloring.joined) {
    if (!is_solid(ports, one) || !is_solid(ports, other)) continue;
    if (two_in_ring(ports))
      joins = ports;
    else if (predecessor(one, ports) == other)
      joins |= single(one);
    else if (predecessor(other, ports) == one)
      joins |= single(other);
    else
      return {};
  }
  const int isolated = coloring.isolated + static_cast<int>(solid_count(coloring.lonely & ~ports));
  return std::pair{Worth{static_cast<int>(solid_count(coloring.inner)), -isolated}, joins};
}

FanSearch::Keys FanSearch::keys(Mask ports) const {
  Keys keys;
  keys.search_ = this;
  keys.ports_ = ports;
  keys.best_.assign(mask_count(place_.k), nothing);
  for (const InnerColoring& coloring : colorings_)
    if (const auto found = outcome(coloring, ports))
      keys.best_[found->second] = std::max(keys.best_[found->second], found->first);
  // What is sound for a key is sound for a key that joins more.
  for (unsigned port = 0; port < place_.k; ++port)
    for (Mask joined = 0; joined < mask_count(place_.k); ++joined)
      if (is_solid(joined, port)) keys.best_[joined] = std::max(keys.best_[joined], keys.best_[joined & ~single(port)]);
  return keys;
}

Mask FanSearch::Keys::normal(Mask joined) const {
  return search_->two_in_ring(ports_) && joined != 0 ? ports_ : joined;
}

std::optional<Worth> FanSearch::Keys::worth_if_sound(Mask inner, Mask joined) const {
  if (inner >= search_->place_of_inner_.size() || search_->place_of_inner_[inner] < 0) return {};
  const auto found =
      search_->outcome(search_->colorings_[static_cast<std::size_t>(search_->place_of_inner_[inner])], ports_);
  if (!found || !is_subset(found->second, normal(joined))) return {};
  return found->first;
}

}  // namespace restrip::verify
