// Claim: generator and verifier read triangles with named vertices in the same way. Of random patches, valid and
// damaged, both accept the same ones and number triangles, inner edges and ports alike. The triangles that the
// generator writes into a header are the triangles of the file in traversal order.
#include "model/triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "describe/triangles.hpp"

namespace restrip {
namespace {

using Triangles = verify::NamedTriangles;
using Random = std::mt19937;

unsigned below(Random& random, std::size_t n) { return static_cast<unsigned>(random() % n); }

/// The triangle to the left of the edge from -> to, or none.
std::optional<std::size_t> left_of(const Triangles& triangles, const std::string& from, const std::string& to) {
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s)
      if (triangles[t][s] == from && triangles[t][(s + 1) % 3] == to) return t;
  return {};
}

std::string apex(const std::array<std::string, 3>& triangle, const std::string& a, const std::string& b) {
  for (const std::string& name : triangle)
    if (name != a && name != b) return name;
  return {};
}

class Patches {
 public:
  explicit Patches(Random& random) : random_(random) {}

  verify::NamedSurface next() {
    names_ = 0;
    Triangles disc{{name(), name(), name()}};
    for (unsigned n = below(random_, 6); n > 0; --n) grow(disc);
    verify::NamedSurface patch{disc, disc, {}};
    for (unsigned n = below(random_, 4); n > 0; --n) change(patch.after);
    if (below(random_, 3) == 0) {
      // A stretch of one edge, perhaps of two after the operation.
      const auto& corners = patch.before[below(random_, patch.before.size())];
      const unsigned s = below(random_, 3);
      const std::string from = corners[s];
      const std::string to = corners[(s + 1) % 3];
      patch.boundary.push_back({from, to});
      if (const auto t = left_of(patch.after, from, to); t && below(random_, 2) == 0) {
        const std::string middle = name();
        const std::string top = apex(patch.after[*t], from, to);
        patch.after[*t] = {from, middle, top};
        patch.after.push_back({middle, to, top});
      }
    }
    for (Triangles* side : {&patch.before, &patch.after}) {
      std::shuffle(side->begin(), side->end(), random_);
      for (auto& corners : *side) std::rotate(corners.begin(), corners.begin() + below(random_, 3), corners.end());
    }
    if (below(random_, 2) == 0) damage(patch);
    return patch;
  }

 private:
  std::string name() { return "v" + std::to_string(names_++); }

  /// One more triangle, at an edge of the rim.
  void grow(Triangles& disc) {
    const auto corners = disc[below(random_, disc.size())];
    const unsigned s = below(random_, 3);
    if (!left_of(disc, corners[(s + 1) % 3], corners[s])) disc.push_back({corners[(s + 1) % 3], corners[s], name()});
  }

  /// A flip, or a vertex inside a triangle.
  void change(Triangles& disc) {
    const std::size_t t = below(random_, disc.size());
    const auto corners = disc[t];
    const auto other = left_of(disc, corners[1], corners[0]);
    if (!other || below(random_, 2) == 0) {
      const std::string inside = name();
      for (unsigned s = 1; s < 3; ++s) disc.push_back({corners[s], corners[(s + 1) % 3], inside});
      disc[t] = {corners[0], corners[1], inside};
      return;
    }
    const std::string far = apex(disc[*other], corners[0], corners[1]);
    if (left_of(disc, corners[2], far) || left_of(disc, far, corners[2])) return;
    disc[t] = {corners[2], corners[0], far};
    disc[*other] = {far, corners[1], corners[2]};
  }

  void damage(verify::NamedSurface& patch) {
    Triangles& side = below(random_, 2) == 0 ? patch.before : patch.after;
    auto& corners = side[below(random_, side.size())];
    switch (below(random_, 8)) {
      case 0:
        std::swap(corners[0], corners[1]);
        break;
      case 1:
        corners[below(random_, 3)] = name();
        break;
      case 2:
        corners[below(random_, 3)] = side[below(random_, side.size())][below(random_, 3)];
        break;
      case 3:
        side.erase(side.begin() + below(random_, side.size()));
        break;
      case 4:
        side.push_back(side[below(random_, side.size())]);
        break;
      case 5:
        corners[below(random_, 3)] = below(random_, 2) == 0 ? "" : "not a name";
        break;
      case 6:
        side.push_back({name(), name(), corners[0]});
        break;
      default:
        patch.boundary.push_back({corners[0], side[below(random_, side.size())][below(random_, 3)]});
    }
  }

  Random& random_;
  unsigned names_ = 0;
};

/// As the readers of a file see it, which know the limits.
std::optional<verify::Sides> by_verifier(const verify::NamedSurface& patch) {
  try {
    const verify::Sides graphs = verify::graphs_of(patch);
    for (const auto* graph : {&graphs.before, &graphs.after})
      if (graph->owner_of_port.empty() || graph->owner_of_port.size() > verify::most_ports ||
          graph->edges.size() + graph->owner_of_port.size() > verify::most_colors_of_a_user)
        return {};
    return graphs;
  } catch (const verify::SurfaceFault&) {
    return {};
  }
}

std::optional<generator::Patch> by_generator(const verify::NamedSurface& patch) {
  try {
    return generator::surface_patch({patch.before, patch.after, patch.boundary});
  } catch (const generator::PatchFault&) {
    return {};
  }
}

void expect_same(const generator::Side& side, const verify::Side& graph) {
  EXPECT_EQ(side.nodes, graph.triangles);
  EXPECT_EQ(side.owner, graph.owner_of_port);
  ASSERT_EQ(side.edges.size(), graph.edges.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    EXPECT_EQ(std::minmax(side.edges[e].u, side.edges[e].v), std::minmax(graph.edges[e][0], graph.edges[e][1]));
}

using generator::SurfaceTriangle;
/// What lies on the sides of a triangle, which identifies it.
using Sides = std::multiset<unsigned>;

std::multiset<Sides> sides_of(const verify::Side& graph) {
  std::vector<Sides> sides(graph.triangles);
  for (unsigned e = 0; e < graph.edges.size(); ++e)
    for (const unsigned t : graph.edges[e]) sides[t].insert(e);
  for (unsigned p = 0; p < graph.owner_of_port.size(); ++p)
    sides[graph.owner_of_port[p]].insert(SurfaceTriangle::port_side + p);
  for (Sides& of : sides)
    while (of.size() < 3) of.insert(SurfaceTriangle::boundary_side);
  return {sides.begin(), sides.end()};
}

/// The ends of the ports, which both sides must have in common.
std::map<unsigned, std::pair<unsigned, unsigned>> expect_met(const std::vector<SurfaceTriangle>& met,
                                                             const verify::Side& graph) {
  std::multiset<Sides> sides;
  std::map<unsigned, std::pair<unsigned, unsigned>> ports;
  for (std::size_t t = 0; t < met.size(); ++t) {
    sides.insert({met[t].side[0], met[t].side[1], met[t].side[2]});
    for (unsigned s = 0; s < 3; ++s)
      if (met[t].side[s] != SurfaceTriangle::boundary_side && met[t].side[s] >= SurfaceTriangle::port_side)
        ports[met[t].side[s]] = {met[t].vertex[s], met[t].vertex[(s + 1) % 3]};
    if (t == 0) continue;
    EXPECT_LT(met[t].from, t);
    const SurfaceTriangle& from = met[met[t].from];
    EXPECT_EQ(from.side[met[t].from_side], met[t].side[0]);
    EXPECT_LT(met[t].side[0], SurfaceTriangle::port_side);
    EXPECT_EQ(from.vertex[met[t].from_side], met[t].vertex[1]);
    EXPECT_EQ(from.vertex[(met[t].from_side + 1) % 3], met[t].vertex[0]);
  }
  EXPECT_EQ(sides, sides_of(graph));
  return ports;
}

TEST(Triangles, AreReadAlike) {
  Random random(28);
  Patches patches(random);
  std::size_t taken = 0;
  std::size_t refused = 0;
  std::size_t on_boundary = 0;
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    const verify::NamedSurface patch = patches.next();
    const auto graphs = by_verifier(patch);
    const auto surface = by_generator(patch);
    std::string words;
    for (const auto* side : {&patch.before, &patch.after}) {
      for (const auto& corners : *side) words += corners[0] + " " + corners[1] + " " + corners[2] + "; ";
      words += "| ";
    }
    SCOPED_TRACE(words);
    ASSERT_EQ(graphs.has_value(), surface.has_value());
    if (!graphs) {
      ++refused;
      continue;
    }
    ++taken;
    on_boundary += patch.boundary.empty() ? 0U : 1U;
    expect_same(surface->before, graphs->before);
    expect_same(surface->after, graphs->after);
    EXPECT_EQ(expect_met(surface->surface.before, graphs->before), expect_met(surface->surface.after, graphs->after));
  }
  EXPECT_GT(taken, 5000U);
  EXPECT_GT(refused, 5000U);
  EXPECT_GT(on_boundary, 500U);
}

}  // namespace
}  // namespace restrip
