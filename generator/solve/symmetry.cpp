#include "solve/symmetry.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

namespace restrip::generator {
namespace {

using Permutation = std::vector<unsigned>;

/// What a symmetry must preserve, as a graph with coloured vertices: ports, triangles before, triangles after, edges
/// after, and a vertex for each term that chooses among some of these.
struct PatchGraph {
  explicit PatchGraph(const Operation& operation) {
    const Side& before = operation.patch.before;
    const Side& after = operation.patch.after;
    const unsigned ports = before.ports();
    for (unsigned p = 0; p < ports; ++p) colors.push_back({0, operation.may_give_up >> p & 1U});
    first_before = size();
    colors.resize(size() + before.nodes, {1});
    first_after = size();
    colors.resize(size() + after.nodes, {2});
    const unsigned first_edge = size();
    colors.resize(size() + after.edges.size(), {3});
    for (unsigned p = 0; p < ports; ++p) {
      join(p, first_before + before.owner[p]);
      join(p, first_after + after.owner[p]);
    }
    for (const auto& [u, v] : before.edges) join(first_before + u, first_before + v);
    for (unsigned e = 0; e < after.edges.size(); ++e) {
      join(first_edge + e, first_after + after.edges[e].u);
      join(first_edge + e, first_after + after.edges[e].v);
    }
    for (std::size_t i = 0; i < operation.preference.size(); ++i) {
      std::vector<Term> terms = operation.preference[i];
      while (!terms.empty()) {  // equal ones have one vertex
        const Term term = terms.back();
        const auto times = static_cast<std::int64_t>(std::erase(terms, term));
        const unsigned vertex = size();
        colors.push_back({4, static_cast<std::int64_t>(i), static_cast<std::int64_t>(term.count), term.weight, times});
        const auto choose = [&](unsigned first, std::size_t count) {
          for (unsigned j = 0; j < count; ++j)
            if ((term.of >> j & 1U) != 0) join(vertex, first + j);
        };
        if (term.count == Count::kept) choose(0, ports);
        if (term.count == Count::solid) choose(first_edge, after.edges.size());
        if (term.count == Count::ends || term.count == Count::ends_at_port) choose(first_after, after.nodes);
      }
    }
  }

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(colors.size()); }
  void join(unsigned u, unsigned v) { edges.emplace_back(u, v); }

  using Color = std::array<std::int64_t, 5>;
  std::vector<Color> colors;
  std::vector<std::pair<unsigned, unsigned>> edges;
  unsigned first_before = 0;
  unsigned first_after = 0;
};

/// Finds automorphisms by backtracking. Vertices get images in breadth-first order, so that neighbours soon show which
/// images do not fit.
class AutomorphismSearch {
 public:
  explicit AutomorphismSearch(const PatchGraph& graph)
      : colors_(graph.colors), joined_(graph.size(), std::vector<bool>(graph.size())) {
    for (const auto& [u, v] : graph.edges) joined_[u][v] = joined_[v][u] = true;
    std::vector<bool> met(graph.size());
    for (unsigned start = 0; start < graph.size(); ++start) {
      if (met[start]) continue;
      met[start] = true;
      order_.push_back(start);
      for (std::size_t i = order_.size() - 1; i < order_.size(); ++i)
        for (unsigned v = 0; v < graph.size(); ++v) {
          if (met[v] || !joined_[order_[i]][v]) continue;
          met[v] = true;
          order_.push_back(v);
        }
    }
  }

  /// Generators of the group: for each vertex, with the vertices before it fixed, an automorphism for each image that
  /// those found so far do not reach. The order of the group is the product of the sizes of these orbits.
  std::vector<Permutation> generators(double& order) {
    std::vector<Permutation> found;
    order = 1;
    for (std::size_t fixed = order_.size(); fixed-- > 0;) {
      std::vector<unsigned> orbit{order_[fixed]};
      const auto reached = [&](unsigned v) { return std::find(orbit.begin(), orbit.end(), v) != orbit.end(); };
      const auto grow = [&] {
        for (std::size_t i = 0; i < orbit.size(); ++i)
          for (const Permutation& map : found)
            if (!reached(map[orbit[i]])) orbit.push_back(map[orbit[i]]);
      };
      grow();
      for (std::size_t later = fixed + 1; later < order_.size(); ++later) {
        images_.assign(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(fixed));
        if (reached(order_[later]) || !extend(order_[later])) continue;
        Permutation& map = found.emplace_back(order_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) map[order_[i]] = images_[i];
        grow();
      }
      order *= static_cast<double>(orbit.size());
    }
    return found;
  }

 private:
  /// Gives the next vertex this image, and then all others theirs; false if that is not possible.
  bool extend(unsigned to) {
    if (++steps_ > most_steps)
      throw std::runtime_error(
          "the patches have too many equal parts: their symmetries were not found in 20,000,000 steps");
    const unsigned vertex = order_[images_.size()];
    if (colors_[vertex] != colors_[to]) return false;
    for (std::size_t i = 0; i < images_.size(); ++i)
      if (images_[i] == to || joined_[vertex][order_[i]] != joined_[to][images_[i]]) return false;
    images_.push_back(to);
    if (images_.size() == order_.size()) return true;
    for (const unsigned next : order_)
      if (extend(next)) return true;
    images_.pop_back();
    return false;
  }

  static constexpr std::uint64_t most_steps = 20'000'000;
  const std::vector<PatchGraph::Color>& colors_;
  std::vector<std::vector<bool>> joined_;
  Permutation order_;
  Permutation images_;  ///< of the first vertices in that order
  std::uint64_t steps_ = 0;
};

Permutation composed(const Permutation& first, const Permutation& second) {
  Permutation image;
  image.reserve(first.size());
  for (const unsigned i : first) image.push_back(second[i]);
  return image;
}

/// All permutations generated by these, ascending.
std::vector<Permutation> closure(const std::vector<Permutation>& generating, unsigned n) {
  std::vector<Permutation> found(1, Permutation(n));
  std::iota(found[0].begin(), found[0].end(), 0U);
  std::set<Permutation> group(found.begin(), found.end());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Permutation& q : generating)
      if (const auto [p, is_new] = group.insert(composed(found[i], q)); is_new) found.push_back(*p);
  return {group.begin(), group.end()};
}

std::vector<unsigned> on_edges(const Side& side, const Permutation& p, unsigned first) {
  std::vector<unsigned> image;
  for (const auto& [u, v] : side.edges) {
    const unsigned x = p[first + u] - first;
    const unsigned y = p[first + v] - first;
    const auto at = std::find_if(side.edges.begin(), side.edges.end(),
                                 [&](const Edge& e) { return (e.u == x && e.v == y) || (e.u == y && e.v == x); });
    image.push_back(static_cast<unsigned>(at - side.edges.begin()));
  }
  return image;
}

/// Larger groups are not listed element by element.
constexpr double most_listed = 100;

}  // namespace

PatchMap then(const PatchMap& first, const PatchMap& second) {
  return {composed(first.port, second.port), composed(first.before, second.before),
          composed(first.after, second.after)};
}

Symmetries symmetries(const Operation& operation) {
  const PatchGraph graph(operation);
  Symmetries found;
  const auto maps_of = [&](const std::vector<Permutation>& permutations) {
    std::vector<PatchMap> maps;
    maps.reserve(permutations.size());
    for (const Permutation& p : permutations)
      maps.push_back({{p.begin(), p.begin() + operation.patch.before.ports()},
                      on_edges(operation.patch.before, p, graph.first_before),
                      on_edges(operation.patch.after, p, graph.first_after)});
    return maps;
  };
  const std::vector<Permutation> generating = AutomorphismSearch(graph).generators(found.order);
  found.generators = maps_of(generating);
  found.maps = found.order <= most_listed ? maps_of(closure(generating, graph.size())) : found.generators;
  if (operation.turns_first && found.order <= most_listed)
    std::stable_partition(found.maps.begin(), found.maps.end(), [](const PatchMap& map) {
      // Port i goes to port i + n for some n, modulo the number of ports.
      const std::size_t ports = map.port.size();
      for (std::size_t i = 0; i < ports; ++i)
        if (map.port[i] != (map.port[0] + i) % ports) return false;
      return true;
    });
  return found;
}

Mask permute(Mask mask, const std::vector<unsigned>& to) {
  Mask image = 0;
  for (unsigned i = 0; i < to.size(); ++i) image |= (mask >> i & 1U) << to[i];
  return image;
}

std::vector<unsigned> inverse(const std::vector<unsigned>& to) {
  std::vector<unsigned> from(to.size());
  for (unsigned i = 0; i < to.size(); ++i) from[to[i]] = i;
  return from;
}

std::vector<bool> larger_in_orbits(const Patch& patch, const std::vector<PatchMap>& maps) {
  const unsigned ports = patch.before.ports();
  // For each map, the image of each byte of a configuration.
  std::vector<std::vector<std::array<Mask, 256>>> images;
  for (const PatchMap& map : maps) {
    std::vector<unsigned> to = map.port;
    for (const unsigned edge : map.before) to.push_back(ports + edge);
    auto& of_bytes = images.emplace_back((to.size() + 7) / 8);
    for (std::size_t i = 0; i < to.size(); ++i)
      for (Mask byte = 0; byte < 256; ++byte) of_bytes[i / 8][byte] |= (byte >> i % 8 & 1U) << to[i];
  }
  std::vector<bool> larger(std::size_t{1} << (patch.before.edges.size() + ports));
  std::vector<std::size_t> orbit;
  for (std::size_t smallest = 0; smallest < larger.size(); ++smallest) {
    if (larger[smallest]) continue;
    orbit = {smallest};
    while (!orbit.empty()) {
      const std::size_t one = orbit.back();
      orbit.pop_back();
      for (const auto& of_bytes : images) {
        std::size_t image = 0;
        for (std::size_t i = 0; i < of_bytes.size(); ++i) image |= of_bytes[i][one >> 8 * i & 0xff];
        if (image == smallest || larger[image]) continue;
        larger[image] = true;
        orbit.push_back(image);
      }
    }
  }
  return larger;
}

}  // namespace restrip::generator
