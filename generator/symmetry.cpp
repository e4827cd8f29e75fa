#include "symmetry.hpp"

#include <fmt/format.h>
#include <nauty/nauty.h>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>
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

/// Vertices: the ports, the nodes before, the nodes after; each kind a colour of its own.
std::vector<Permutation> permutations(const Patch& patch) {
  const auto ports = static_cast<unsigned>(patch.before.owner.size());
  const unsigned first_after = ports + patch.before.nodes;
  const unsigned n = first_after + patch.after.nodes;
  const int m = SETWORDSNEEDED(static_cast<int>(n));
  std::vector<graph> g(static_cast<std::size_t>(m) * n, 0);
  const auto join = [&](unsigned u, unsigned v) {
    ADDELEMENT(GRAPHROW(g.data(), u, static_cast<unsigned>(m)), v);
    ADDELEMENT(GRAPHROW(g.data(), v, static_cast<unsigned>(m)), u);
  };
  for (unsigned p = 0; p < ports; ++p) {
    join(p, ports + patch.before.owner[p]);
    join(p, first_after + patch.after.owner[p]);
  }
  for (const auto& [u, v] : patch.before.edges) join(ports + u, ports + v);
  for (const auto& [u, v] : patch.after.edges) join(first_after + u, first_after + v);

  std::vector<int> lab(n);
  std::vector<int> ptn(n, 1);
  std::vector<int> orbits(n);
  std::iota(lab.begin(), lab.end(), 0);
  ptn[ports - 1] = ptn[first_after - 1] = ptn[n - 1] = 0;
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

  // Close under composition: the groups here have at most 4k elements.
  Permutation identity(n);
  std::iota(identity.begin(), identity.end(), 0U);
  std::set<Permutation> group{identity};
  std::vector<Permutation> fresh{identity};
  while (!fresh.empty()) {
    std::vector<Permutation> next;
    for (const auto& p : fresh) {
      for (const auto& q : found) {
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

PatchMap map_of(const Patch& patch, const Permutation& p) {
  const auto k = static_cast<unsigned>(patch.before.owner.size());
  const unsigned first_after = k + patch.before.nodes;
  PatchMap map;
  map.port.assign(p.begin(), p.begin() + k);
  map.before = on_edges(patch.before, p, k);
  map.after = on_edges(patch.after, p, first_after);
  for (unsigned node = 0; node < patch.after.nodes; ++node) map.nodes.push_back(p[first_after + node] - first_after);
  return map;
}

Symmetry named(PatchMap map) {
  Symmetry s{std::move(map), false, 0};
  const auto k = static_cast<unsigned>(s.port.size());
  s.n = s.port[0];
  const auto is = [&](bool mirror) {
    for (unsigned i = 0; i < k; ++i)
      if (s.port[i] != (mirror ? s.n + k - i : s.n + i) % k) return false;
    return true;
  };
  // On one or two ports a turn and a mirror agree; only open fans are that small, and they have no turns.
  s.mirror = k <= 2 ? s.n != 0 : !is(false);
  if (s.mirror && !is(true)) throw std::logic_error("a symmetry that is neither a turn nor a mirror of the fan");
  return s;
}

}  // namespace

std::string Symmetry::name() const { return fmt::format("{} {}", mirror ? "mirror" : "turn", n); }

std::vector<PatchMap> automorphisms(const Patch& patch) {
  std::vector<PatchMap> maps;
  for (const auto& p : permutations(patch)) maps.push_back(map_of(patch, p));
  return maps;
}

std::vector<Symmetry> symmetries(const Patch& patch) {
  std::vector<Symmetry> list;
  for (PatchMap& map : automorphisms(patch)) list.push_back(named(std::move(map)));
  std::sort(list.begin(), list.end(), [](const Symmetry& x, const Symmetry& y) {
    return std::tie(x.mirror, x.n, x.after, x.before) < std::tie(y.mirror, y.n, y.after, y.before);
  });
  return list;
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

std::vector<Mask> Smallest::images(std::size_t bits, const std::vector<unsigned>& to) {
  std::vector<Mask> image(std::size_t{1} << bits);
  for (Mask mask = 0; mask < image.size(); ++mask) image[mask] = permute(mask, to);
  return image;
}

bool Smallest::operator()(Mask before, Mask ports) const {
  for (std::size_t s = 0; s < before_.size(); ++s)
    if (std::pair{before_[s][before], ports_[s][ports]} < std::pair{before, ports}) return false;
  return true;
}

std::size_t Smallest::orbits() const {
  std::size_t n = 0;
  for (Mask before = 0; before < before_[0].size(); ++before)
    for (Mask ports = 0; ports < ports_[0].size(); ++ports) n += (*this)(before, ports) ? 1U : 0U;
  return n;
}

}  // namespace restrip::generator
