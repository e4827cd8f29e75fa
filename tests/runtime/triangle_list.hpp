// Split, collapse, flip and custom operations, and the definition of a good mesh, on bare lists of vertex triples: the
// other side of checks_test.cpp. Nothing here uses a StripMesh, and every question is answered by a scan of the whole
// list.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "restrip/operations/apply.hpp"
#include "sample_meshes.hpp"

namespace restrip::bare {

using Name = std::uint32_t;
using Corners = std::array<Name, 3>;  // counter-clockwise
using List = std::vector<Corners>;
using sample::sorted;

// The neighbours of a vertex in order around it, counter-clockwise: a path, or a cycle that names its first one once.
struct Link {
  std::vector<Name> around;
  bool closed = false;
  [[nodiscard]] std::size_t triangles() const { return closed ? around.size() : around.size() - 1; }
};

// Nothing when the triangles around v are not one fan, each next to the following one and turned the same way.
inline std::optional<Link> link_of(const List& list, Name v) {
  std::map<Name, Name> next;
  std::set<Name> entered;
  for (const Corners& c : list)
    for (std::size_t i = 0; i < 3; ++i)
      if (c[i] == v) {
        if (!next.emplace(c[(i + 1) % 3], c[(i + 2) % 3]).second) return std::nullopt;
        if (!entered.insert(c[(i + 2) % 3]).second) return std::nullopt;
      }
  if (next.empty()) return std::nullopt;
  Link link;
  Name start = next.begin()->first;
  link.closed = true;
  for (const auto& [from, to] : next)
    if (!entered.contains(from)) {
      start = from;
      link.closed = false;
    }
  Name at = start;
  do {
    link.around.push_back(at);
    const auto step = next.find(at);
    if (step == next.end()) break;
    at = step->second;
  } while (at != start);
  if (link.triangles() != next.size()) return std::nullopt;
  return link;
}

// What an operation must leave as it is.
struct Shape {
  std::set<Name> vertices;
  std::set<Name> non_manifold;  // vertices whose triangles are not one fan
  long euler = 0;
  std::size_t components = 0;
  std::size_t boundaries = 0;  // connected parts of the edges of one triangle
  bool degenerate = false;     // a triangle with a corner twice
};

class Groups {
 public:
  void join(Name a, Name b) { parent_[root(a)] = root(b); }
  std::size_t count() {
    std::size_t n = 0;
    for (const auto& [name, parent] : std::map<Name, Name>(parent_)) n += root(name) == name ? 1U : 0U;
    return n;
  }

 private:
  Name root(Name a) {
    Name at = parent_.emplace(a, a).first->second;
    while (at != parent_.at(at)) at = parent_.at(at);
    return at;
  }
  std::map<Name, Name> parent_;
};

inline Shape shape_of(const List& list) {
  Shape shape;
  std::map<std::pair<Name, Name>, std::size_t> edges;
  Groups components;
  for (const Corners& c : list)
    for (std::size_t i = 0; i < 3; ++i) {
      const Name a = c[i];
      const Name b = c[(i + 1) % 3];
      shape.degenerate = shape.degenerate || a == b;
      shape.vertices.insert(a);
      ++edges[std::minmax(a, b)];
      components.join(a, b);
    }
  Groups boundaries;
  for (const auto& [edge, triangles] : edges)
    if (triangles == 1) boundaries.join(edge.first, edge.second);
  shape.components = components.count();
  shape.boundaries = boundaries.count();
  shape.euler =
      static_cast<long>(shape.vertices.size()) - static_cast<long>(edges.size()) + static_cast<long>(list.size());
  for (const Name v : shape.vertices)
    if (!link_of(list, v)) shape.non_manifold.insert(v);
  return shape;
}

// Is the mesh after an operation as good as the one before? `named` are the vertices of the operation that are still
// there, `gone` and `made` the vertices that it removes and adds.
inline bool as_good(const Shape& before, const List& list, const std::vector<Name>& named,
                    const std::vector<Name>& gone, const std::vector<Name>& made) {
  const Shape after = shape_of(list);
  std::set<Name> vertices = before.vertices;
  for (const Name v : gone) vertices.erase(v);
  for (const Name v : made)
    if (!vertices.insert(v).second) return false;
  if (after.degenerate || after.vertices != vertices || after.non_manifold != before.non_manifold) return false;
  if (after.euler != before.euler || after.components != before.components || after.boundaries != before.boundaries)
    return false;
  for (const Name v : named) {
    const auto link = link_of(list, v);
    if (!link || (link->closed && link->triangles() < 3)) return false;
  }
  return true;
}

inline bool all_regular(const Shape& shape, const std::vector<Name>& named) {
  return std::none_of(named.begin(), named.end(), [&](Name v) { return shape.non_manifold.contains(v); });
}

// The third corner of the triangle that has the directed edge a -> b, if exactly one has.
inline std::optional<Name> apex(const List& list, Name a, Name b) {
  std::optional<Name> found;
  for (const Corners& c : list)
    for (std::size_t i = 0; i < 3; ++i)
      if (c[i] == a && c[(i + 1) % 3] == b) {
        if (found) return std::nullopt;
        found = c[(i + 2) % 3];
      }
  return found;
}

// The mesh after each operation; nothing when it is not one or leaves a mesh worse than before. A split takes the
// vertex v_h, its neighbours v_l and v_r (one may be missing on the boundary) and the name of the new vertex.
inline std::optional<List> split(const List& list, const Shape& shape, Name v_h, std::optional<Name> v_l,
                                 std::optional<Name> v_r, Name v_t) {
  const auto link = link_of(list, v_h);
  std::vector<Name> named{v_h};
  if (v_l) named.push_back(*v_l);
  if (v_r) named.push_back(*v_r);
  if (!link || v_l == v_r || !all_regular(shape, named)) return std::nullopt;
  const std::size_t k = link->triangles();
  if (link->closed && (!v_l || !v_r || k < 3)) return std::nullopt;
  const auto place = [&](Name v) {
    return static_cast<std::size_t>(std::find(link->around.begin(), link->around.end(), v) - link->around.begin());
  };
  // Triangle i of the fan lies between neighbours i and i + 1. Counter-clockwise from v_r to v_l they go to v_t; where
  // one is missing, from or to the boundary.
  std::set<std::pair<Name, Name>> moved;
  const std::size_t begin = v_r ? place(*v_r) : 0;
  const std::size_t end = v_l ? place(*v_l) : k;
  const auto triangle = [&](std::size_t i) {
    return std::pair{link->around[i], link->around[(i + 1) % link->around.size()]};
  };
  const std::size_t count = begin <= end ? end - begin : k - begin + end;
  for (std::size_t i = 0; i < count; ++i) moved.insert(triangle((begin + i) % k));
  List after;
  for (Corners c : list) {
    for (std::size_t i = 0; i < 3; ++i)
      if (c[i] == v_h && moved.contains({c[(i + 1) % 3], c[(i + 2) % 3]})) {
        c[i] = v_t;
        break;
      }
    after.push_back(c);
  }
  if (v_l) after.push_back({v_h, v_t, *v_l});
  if (v_r) after.push_back({v_t, v_h, *v_r});
  named.push_back(v_t);
  if (!as_good(shape, after, named, {}, {v_t})) return std::nullopt;
  return after;
}

inline std::optional<List> collapse(const List& list, const Shape& shape, Name v_s, Name v_t) {
  std::vector<Name> named{v_s};
  for (const auto v : {apex(list, v_s, v_t), apex(list, v_t, v_s)})
    if (v) named.push_back(*v);
  if (!all_regular(shape, named) || !all_regular(shape, {v_t})) return std::nullopt;
  List after;
  for (Corners c : list) {
    const bool has_s = std::count(c.begin(), c.end(), v_s) != 0;
    const bool has_t = std::count(c.begin(), c.end(), v_t) != 0;
    if (has_s && has_t) continue;
    std::replace(c.begin(), c.end(), v_t, v_s);
    after.push_back(c);
  }
  if (!as_good(shape, after, named, {v_t}, {})) return std::nullopt;
  return after;
}

inline std::optional<List> flip(const List& list, const Shape& shape, Name u, Name v) {
  const auto l = apex(list, u, v);
  const auto r = apex(list, v, u);
  if (!l || !r || !all_regular(shape, {u, v, *l, *r})) return std::nullopt;
  List after;
  for (const Corners& c : list)
    if (std::count(c.begin(), c.end(), u) == 0 || std::count(c.begin(), c.end(), v) == 0) after.push_back(c);
  after.push_back({*r, *l, u});
  after.push_back({*l, *r, v});
  if (!as_good(shape, after, {u, v, *l, *r}, {}, {})) return std::nullopt;
  return after;
}

// The list after an operation at the directed edge from -> to; empty if the patch does not exist there, has a vertex
// twice, or leaves a mesh that is not manifold. `added`: the new vertices, in the order of the operation file.
template <class Table>
std::optional<List> applied(const List& list, const Shape& shape, const Table& table, Name from, Name to,
                            const std::vector<Name>& added) {
  std::map<unsigned, Name> names;
  std::vector<Corners> out;
  for (const tables::PatchTriangle& t : table.triangles_before) {
    const bool first = out.empty();
    const Name a = first ? from : out[t.from][(t.from_side + 1U) % 3];
    const Name b = first ? to : out[t.from][t.from_side];
    const auto c = apex(list, a, b);
    if (!c) return {};
    out.push_back({a, b, *c});
    for (std::size_t s = 0; s < 3; ++s)
      if (!names.emplace(t.vertex[s], out.back()[s]).second && names.at(t.vertex[s]) != out.back()[s]) return {};
  }
  for (std::size_t t = 0; t < out.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s)
      if (table.triangles_before[t].side[s] == tables::PatchTriangle::boundary_side &&
          apex(list, out[t][(s + 1) % 3], out[t][s]))
        return {};
  std::set<Name> gone;
  for (const auto& [place, name] : names)
    if (!gone.insert(name).second) return {};
  std::vector<Name> made;
  std::vector<Name> named;
  List after;
  for (const Corners& c : list)
    if (std::none_of(out.begin(), out.end(), [&](const Corners& o) { return sorted({o}) == sorted({c}); }))
      after.push_back(c);
  if (after.size() + out.size() != list.size()) return {};
  for (const tables::PatchTriangle& t : table.triangles_after) {
    Corners corners{};
    for (std::size_t s = 0; s < 3; ++s) {
      if (!names.contains(t.vertex[s])) {
        made.push_back(added.at(made.size()));
        names[t.vertex[s]] = made.back();
      }
      corners[s] = names.at(t.vertex[s]);
      named.push_back(corners[s]);
    }
    after.push_back(corners);
  }
  for (const Name v : named) gone.erase(v);
  std::vector<Name> old(named);
  old.insert(old.end(), gone.begin(), gone.end());
  if (!all_regular(shape, old)) return {};
  if (!as_good(shape, after, named, {gone.begin(), gone.end()}, made)) return {};
  return sorted(after);
}

}  // namespace restrip::bare
