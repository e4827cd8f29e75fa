#include "model/triangles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace restrip::verify {
namespace {

using Name = std::string;

/// A triangle at an edge, along which it runs from `from` to `to`, as its side number `side`.
struct Along {
  std::size_t triangle;
  std::size_t side;
  Name from;
  Name to;
};

/// Disjoint sets of connected things.
template <class Thing>
class Connected {
 public:
  Thing of(const Thing& thing) const {
    const auto at = above_.find(thing);
    return at == above_.end() || at->second == thing ? thing : of(at->second);
  }
  void join(const Thing& a, const Thing& b) { above_[of(a)] = of(b); }

 private:
  std::map<Thing, Thing> above_;
};

/// One side of the operation as a simplicial complex.
class Complex {
 public:
  Complex(Name member, const NamedTriangles& triangles) : member_(std::move(member)), triangles_(triangles) {
    for (std::size_t t = 0; t < triangles.size(); ++t) add(t);
    expect_manifold();
    expect_disc();
  }

  const Name& member() const { return member_; }
  [[noreturn]] void fail(std::optional<std::size_t> triangle, const std::string& what) const {
    throw SurfaceFault{member_, triangle, what};
  }

  bool has(const Name& vertex) const {
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const auto& corners) {
      return std::find(corners.begin(), corners.end(), vertex) != corners.end();
    });
  }
  /// Edges of one triangle, by their start vertex.
  const std::map<Name, Along>& rim() const { return rim_; }

  /// The two triangles at each inner edge, ordered by the later one and its sides.
  std::vector<std::array<Along, 2>> inner_edges() const {
    std::map<std::tuple<std::size_t, std::size_t>, std::array<Along, 2>> by_second;
    for (const auto& [ends, along] : edges_) {
      if (along.size() != 2) continue;
      const auto& [first, second] =
          std::minmax(along[0], along[1], [](const Along& a, const Along& b) { return a.triangle < b.triangle; });
      by_second.insert({{second.triangle, second.side}, {first, second}});
    }
    std::vector<std::array<Along, 2>> edges;
    edges.reserve(by_second.size());
    for (const auto& edge : by_second) edges.push_back(edge.second);
    return edges;
  }

 private:
  void add(std::size_t t) {
    const auto& corners = triangles_[t];
    const std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    for (const Name& name : corners)
      if (name.empty() || name.size() > longest_word || name.find_first_not_of(allowed) != Name::npos)
        fail(t, "expected three vertices, each of 1 to 20 letters, digits and underscores");
    if (std::set<Name>(corners.begin(), corners.end()).size() != 3)
      fail(t, fmt::format("expected three different vertices, found {} {} {}", corners[0], corners[1], corners[2]));
    for (std::size_t side = 0; side < 3; ++side) {
      const Name& from = corners[side];
      const Name& to = corners[(side + 1) % 3];
      std::vector<Along>& along = edges_[std::minmax(from, to)];
      along.push_back({t, side, from, to});
      if (along.size() > 2)
        fail(t, fmt::format("expected at most two triangles at the edge {} {}, found three", from, to));
      if (along.size() == 2 && along[0].from == from)
        fail(t,
             fmt::format("expected the triangles at the edge {} {} to run along it in opposite directions, found that "
                         "triangle {} runs in the same direction; is one of them clockwise?",
                         from, to, along[0].triangle));
    }
  }

  /// The triangles around a vertex must form one path or one cycle.
  void expect_manifold() const {
    std::map<Name, std::vector<std::pair<Name, Name>>> links;
    for (const auto& [a, b, c] : triangles_) {
      links[a].emplace_back(b, c);
      links[b].emplace_back(c, a);
      links[c].emplace_back(a, b);
    }
    for (const auto& [vertex, link] : links) {
      Connected<Name> parts;
      for (const auto& [a, b] : link) parts.join(a, b);
      for (const auto& [a, b] : link)
        if (parts.of(a) != parts.of(link.front().first))
          fail({}, fmt::format("expected the triangles around a vertex to be one fan, those around {} are several",
                               vertex));
    }
  }

  void expect_disc() {
    Connected<std::size_t> parts;
    std::set<Name> vertices;
    for (const auto& corners : triangles_) vertices.insert(corners.begin(), corners.end());
    for (const auto& [ends, along] : edges_) {
      parts.join(along.front().triangle, along.back().triangle);
      if (along.size() == 1) rim_.emplace(along[0].from, along[0]);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (parts.of(t) != parts.of(0)) fail(t, "expected triangles that are connected over edges, this one is apart");
    // A connected surface is a disc exactly if its Euler characteristic is 1.
    const auto euler = static_cast<long>(vertices.size() + triangles_.size()) - static_cast<long>(edges_.size());
    if (euler != 1)
      fail({}, fmt::format("expected a disc, found a surface of Euler characteristic {} in place of 1", euler));
  }

  Name member_;
  const NamedTriangles& triangles_;
  std::map<std::pair<Name, Name>, std::vector<Along>> edges_;
  std::map<Name, Along> rim_;
};

/// The start vertices of the ports of a side, without the stretches that the file declares as boundary.
std::map<Name, Along> ports_at(const Complex& complex, const NamedSurface& surface) {
  std::map<Name, Along> ports = complex.rim();
  for (std::size_t i = 0; i < surface.boundary.size(); ++i) {
    const auto& [from, to] = surface.boundary[i];
    const auto fail = [i](const std::string& what) { throw SurfaceFault{"boundary", i, what}; };
    for (const Name& end : {from, to})
      if (!complex.rim().contains(end))
        fail(fmt::format("expected vertices that the outline has on both sides, \"{}\" is not on it {} the operation",
                         end, complex.member()));
    if (from == to) fail("expected two different vertices");
    for (Name at = from; at != to; at = complex.rim().at(at).to)
      if (ports.erase(at) == 0) fail(fmt::format("expected stretches that are apart, the edge at {} is in two", at));
  }
  return ports;
}

/// What may have been meant by an edge that is on the outline of one side only.
std::string remedy(const Name& from, const Name& to, const Complex& complex, const std::map<Name, Along>& others,
                   const Complex& other) {
  const auto reversed = others.find(to);
  if (reversed != others.end() && reversed->second.to == from) return "; is this triangle clockwise?";
  for (const Name& vertex : {from, to})
    if (!other.has(vertex))
      return fmt::format("; {} is {}: include the triangle across this edge, or declare the boundary of the mesh",
                         vertex, complex.member() == "after" ? "new" : "not there afterwards");
  return "";
}

void expect_among(const std::map<Name, Along>& ports, const Complex& complex, const std::map<Name, Along>& others,
                  const Complex& other) {
  for (const auto& [from, port] : ports)
    if (const auto same = others.find(from); same == others.end() || same->second.to != port.to)
      complex.fail(port.triangle, fmt::format("expected the same outline on both sides, the edge {} {} is on it {} the "
                                              "operation but not {} it{}",
                                              from, port.to, complex.member(), other.member(),
                                              remedy(from, port.to, complex, others, other)));
}

}  // namespace

Sides graphs_of(const NamedSurface& surface) {
  for (const auto& [member, triangles] : {std::pair("before", &surface.before), {"after", &surface.after}})
    if (triangles->empty()) throw SurfaceFault{member, {}, "expected a list of triangles, found none"};
  const Complex before("before", surface.before);
  const Complex after("after", surface.after);
  const std::map<Name, Along> ports_before = ports_at(before, surface);
  const std::map<Name, Along> ports_after = ports_at(after, surface);
  expect_among(ports_before, before, ports_after, after);
  expect_among(ports_after, after, ports_before, before);

  // Once around the outline before the operation, from the first port in the file.
  const auto earlier = [](const auto& a, const auto& b) {
    return std::tie(a.second.triangle, a.second.side) < std::tie(b.second.triangle, b.second.side);
  };
  const auto first = std::min_element(ports_before.begin(), ports_before.end(), earlier);
  std::vector<Name> order;
  if (first != ports_before.end()) {
    Name at = first->first;
    do {
      if (ports_before.contains(at)) order.push_back(at);
      at = before.rim().at(at).to;
    } while (at != first->first);
  }
  std::map<Name, unsigned> vertices;  // numbers, in order of appearance in the file
  for (const NamedTriangles* triangles : {&surface.before, &surface.after})
    for (const auto& corners : *triangles)
      for (const Name& name : corners) vertices.emplace(name, static_cast<unsigned>(vertices.size()));

  Sides sides;
  sides.vertices = static_cast<unsigned>(vertices.size());
  const auto fill = [&](Side& side, std::vector<PlacedTriangle>& placed, const NamedTriangles& triangles,
                        const Complex& complex, const std::map<Name, Along>& ports) {
    side.triangles = static_cast<unsigned>(triangles.size());
    for (const auto& [a, b, c] : triangles) {
      placed.push_back(
          {{vertices.at(a), vertices.at(b), vertices.at(c)}, {boundary_side, boundary_side, boundary_side}});
      const bool is_short = a.size() + b.size() + c.size() == 3;
      side.names.push_back(is_short ? fmt::format("{}{}{}", a, b, c) : fmt::format("{}.{}.{}", a, b, c));
    }
    for (const auto& edge : complex.inner_edges()) {
      for (const Along& along : edge) placed[along.triangle].side[along.side] = side.inner_edges();
      side.edges.push_back({static_cast<unsigned>(edge[0].triangle), static_cast<unsigned>(edge[1].triangle)});
    }
    for (const Name& from : order) {
      const Along& port = ports.at(from);
      placed[port.triangle].side[port.side] = first_port_side + side.ports();
      side.owner_of_port.push_back(static_cast<unsigned>(port.triangle));
      side.port_names.push_back(fmt::format("{} {}", port.from, port.to));
    }
    for (const PlacedTriangle& one : placed) side.around.push_back(one.side);
  };
  fill(sides.before, sides.placed_before, surface.before, before, ports_before);
  fill(sides.after, sides.placed_after, surface.after, after, ports_after);
  return sides;
}

}  // namespace restrip::verify
