#include "solve/symmetry.hpp"

#include <nauty/nauty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numeric>
#include <set>
#include <utility>

namespace restrip::generator {
namespace {

using Permutation = std::vector<unsigned>;

// nauty reports the generators of the group to a plain function.
std::vector<Permutation>* generators = nullptr;

// nauty keeps state of its own between calls.
std::mutex one_at_a_time;

void take_generator(int, int* image, int*, int, int, int n) {
  Permutation p;
  for (int i = 0; i < n; ++i) p.push_back(static_cast<unsigned>(image[i]));
  generators->push_back(p);
}

/// What is to be kept, as a graph with coloured vertices: ports, triangles before, triangles after, edges after, and a
/// vertex for each term that chooses among some of these.
class PatchGraph {
 public:
  explicit PatchGraph(const Operation& operation) {
    const auto& [before, after] = operation.patch;
    const unsigned ports = before.ports();
    for (unsigned p = 0; p < ports; ++p) color_.push_back({0, operation.may_give_up >> p & 1U});
    first_before_ = size();
    color_.resize(size() + before.nodes, {1});
    first_after_ = size();
    color_.resize(size() + after.nodes, {2});
    const unsigned first_edge = size();
    color_.resize(size() + after.edges.size(), {3});
    for (unsigned p = 0; p < ports; ++p) {
      join(p, first_before_ + before.owner[p]);
      join(p, first_after_ + after.owner[p]);
    }
    for (const auto& [u, v] : before.edges) join(first_before_ + u, first_before_ + v);
    for (unsigned e = 0; e < after.edges.size(); ++e) {
      join(first_edge + e, first_after_ + after.edges[e].u);
      join(first_edge + e, first_after_ + after.edges[e].v);
    }
    for (std::size_t i = 0; i < operation.preference.size(); ++i)
      for (const Term& term : operation.preference[i]) {
        const unsigned vertex = size();
        color_.push_back({4, static_cast<std::int64_t>(i), static_cast<std::int64_t>(term.count), term.weight});
        const auto choose = [&](unsigned first, std::size_t count) {
          for (unsigned j = 0; j < count; ++j)
            if ((term.of >> j & 1U) != 0) join(vertex, first + j);
        };
        if (term.count == Count::kept) choose(0, ports);
        if (term.count == Count::solid) choose(first_edge, after.edges.size());
        if (term.count == Count::ends || term.count == Count::ends_at_port) choose(first_after_, after.nodes);
      }
  }

  /// Generators of its automorphisms, and how many of these there are.
  [[nodiscard]] std::vector<Permutation> generators_of(double& order) const {
    const unsigned n = size();
    const int m = SETWORDSNEEDED(static_cast<int>(n));
    std::vector<graph> g(static_cast<std::size_t>(m) * n, 0);
    for (const auto& [u, v] : edges_) {
      ADDELEMENT(GRAPHROW(g.data(), u, static_cast<unsigned>(m)), v);
      ADDELEMENT(GRAPHROW(g.data(), v, static_cast<unsigned>(m)), u);
    }
    std::vector<int> lab(n);
    std::vector<int> ptn(n, 1);
    std::vector<int> orbits(n);
    std::iota(lab.begin(), lab.end(), 0);
    const auto color = [&](int vertex) -> const Color& { return color_[static_cast<unsigned>(vertex)]; };
    std::stable_sort(lab.begin(), lab.end(), [&](int u, int v) { return color(u) < color(v); });
    for (unsigned i = 0; i < n; ++i)
      if (i + 1 == n || color(lab[i]) != color(lab[i + 1])) ptn[i] = 0;
    static DEFAULTOPTIONS_GRAPH(defaults);
    optionblk options = defaults;
    options.defaultptn = FALSE;
    options.userautomproc = take_generator;
    statsblk stats;
    std::vector<Permutation> found;
    const std::lock_guard lock(one_at_a_time);
    generators = &found;
    densenauty(g.data(), lab.data(), ptn.data(), orbits.data(), &options, &stats, m, static_cast<int>(n), nullptr);
    // Its memory belongs to this thread, which may end.
    nauty_freedyn();
    nautil_freedyn();
    naugraph_freedyn();
    generators = nullptr;
    order = stats.grpsize1 * std::pow(10.0, stats.grpsize2);
    return found;
  }

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(color_.size()); }
  [[nodiscard]] unsigned first_before() const { return first_before_; }
  [[nodiscard]] unsigned first_after() const { return first_after_; }

 private:
  using Color = std::array<std::int64_t, 4>;
  void join(unsigned u, unsigned v) { edges_.emplace_back(u, v); }

  std::vector<Color> color_;
  std::vector<std::pair<unsigned, unsigned>> edges_;
  unsigned first_before_ = 0;
  unsigned first_after_ = 0;
};

/// All permutations that these generate, ascending.
std::vector<Permutation> closure(const std::vector<Permutation>& generating, unsigned n) {
  Permutation identity(n);
  std::iota(identity.begin(), identity.end(), 0U);
  std::set<Permutation> group{identity};
  std::vector<Permutation> fresh{identity};
  while (!fresh.empty()) {
    std::vector<Permutation> next;
    for (const auto& p : fresh) {
      for (const auto& q : generating) {
        Permutation composed(n);
        for (unsigned i = 0; i < n; ++i) composed[i] = q[p[i]];
        if (group.insert(composed).second) next.push_back(composed);
      }
    }
    fresh = std::move(next);
  }
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

/// Whether port i goes to port i + n for some n, modulo the number of ports.
bool turns(const PatchMap& map) {
  const std::size_t ports = map.port.size();
  for (std::size_t i = 0; i < ports; ++i)
    if (map.port[i] != (map.port[0] + i) % ports) return false;
  return true;
}

/// What a map does to masks of so many bits, eight bits at a time.
class MaskMap {
 public:
  MaskMap(const std::vector<unsigned>& to) : images_((to.size() + 7) / 8) {
    for (std::size_t byte = 0; byte < images_.size(); ++byte)
      for (Mask mask = 0; mask < 256; ++mask)
        for (unsigned i = 0; i < 8 && 8 * byte + i < to.size(); ++i)
          images_[byte][mask] |= (mask >> i & 1U) << to[8 * byte + i];
  }
  [[nodiscard]] Mask operator()(Mask mask) const {
    Mask image = 0;
    for (const auto& of_byte : images_) {
      image |= of_byte[mask & 0xff];
      mask >>= 8;
    }
    return image;
  }

 private:
  std::vector<std::array<Mask, 256>> images_;
};

std::vector<unsigned> composed(const std::vector<unsigned>& first, const std::vector<unsigned>& second) {
  std::vector<unsigned> image;
  image.reserve(first.size());
  for (const unsigned i : first) image.push_back(second[i]);
  return image;
}

/// Up to so many symmetries are listed one by one.
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
                      on_edges(operation.patch.before, p, graph.first_before()),
                      on_edges(operation.patch.after, p, graph.first_after())});
    return maps;
  };
  const std::vector<Permutation> generating = graph.generators_of(found.order);
  found.generators = maps_of(generating);
  found.maps = found.order <= most_listed ? maps_of(closure(generating, graph.size())) : found.generators;
  if (operation.turns_first && found.order <= most_listed)
    std::stable_partition(found.maps.begin(), found.maps.end(), turns);
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

Orbits::Orbits(const Patch& patch, const std::vector<PatchMap>& maps)
    : ports_(patch.before.owner.size()), other_(std::size_t{1} << (patch.before.edges.size() + ports_)) {
  std::vector<std::pair<MaskMap, MaskMap>> images;
  images.reserve(maps.size());
  for (const PatchMap& map : maps) images.emplace_back(map.before, map.port);
  const Mask all_ports = patch.before.all_ports();
  std::vector<std::size_t> orbit;
  for (std::size_t smallest = 0; smallest < other_.size(); ++smallest) {
    if (other_[smallest]) continue;
    ++count_;
    orbit = {smallest};
    while (!orbit.empty()) {
      const std::size_t one = orbit.back();
      orbit.pop_back();
      for (const auto& [on_edges, on_ports] : images) {
        const std::size_t image = std::size_t{on_edges(static_cast<Mask>(one >> ports_))} << ports_ |
                                  on_ports(static_cast<Mask>(one) & all_ports);
        if (image == smallest || other_[image]) continue;
        other_[image] = true;
        orbit.push_back(image);
      }
    }
  }
}

}  // namespace restrip::generator
