// A snapshot of a mesh: all halfedges of a component, with the results of next, opposite, on_boundary and solid.
// Reading it checks the lines of the contract that do not involve an operation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/mesh.hpp"
#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/operations/test_adapter.hpp"

namespace restrip::detail {

/// The halfedges that leave a vertex, counter-clockwise; of an open fan from boundary to boundary.
struct PictureFan {
  std::vector<std::size_t> spokes;
  bool closed = false;

  [[nodiscard]] std::size_t place(std::size_t h) const {
    return static_cast<std::size_t>(std::find(spokes.begin(), spokes.end(), h) - spokes.begin());
  }
  [[nodiscard]] std::size_t triangles() const { return spokes.size() - (closed ? 0 : 1); }
};

template <class Mesh>
struct MeshPicture {
  using Halfedge = typename Mesh::Halfedge;
  static constexpr std::size_t no_next = static_cast<std::size_t>(-1);

  std::vector<Halfedge> halfedges;
  std::vector<std::size_t> next;  ///< no_next on the boundary
  std::vector<std::size_t> opposite;
  std::vector<std::size_t> vertex;  ///< that the halfedge leaves: the first of them
  std::vector<std::uint8_t> solid;
  std::vector<std::uint32_t> number;  ///< of its triangle, if the mesh has numbers
  std::vector<std::uint8_t> chosen;   ///< is it what halfedge(number) answers?
  std::size_t triangles = 0;

  [[nodiscard]] std::size_t size() const { return halfedges.size(); }
  [[nodiscard]] std::size_t find(const Halfedge& h) const {
    return static_cast<std::size_t>(std::find(halfedges.begin(), halfedges.end(), h) - halfedges.begin());
  }
  [[nodiscard]] bool on_boundary(std::size_t h) const { return next[h] == no_next; }
  [[nodiscard]] std::size_t ccw(std::size_t h) const { return opposite[next[next[h]]]; }
  [[nodiscard]] std::size_t cw(std::size_t h) const { return next[opposite[h]]; }
  [[nodiscard]] std::size_t to(std::size_t h) const { return vertex[opposite[h]]; }
  [[nodiscard]] std::size_t apex(std::size_t h) const { return to(next[h]); }

  /// The fan of the vertex that h leaves; a closed one begins with h.
  [[nodiscard]] PictureFan fan(std::size_t h) const {
    PictureFan fan;
    std::size_t first = h;
    while (!on_boundary(opposite[first])) {
      first = cw(first);
      if (first == h) {
        fan.closed = true;
        break;
      }
    }
    for (std::size_t g = first;; g = ccw(g)) {
      fan.spokes.push_back(g);
      if (on_boundary(g) || (fan.closed && ccw(g) == first)) return fan;
    }
  }
  [[nodiscard]] bool neighbors(std::size_t v, std::size_t w) const {
    for (std::size_t h = 0; h < size(); ++h)
      if (vertex[h] == v && to(h) == w) return true;
    return false;
  }
};

/// The walk ends early if the component of `start` has more than `limit` halfedges.
template <class Mesh>
Contract read_picture(const Mesh& mesh, typename Mesh::Halfedge start, std::size_t limit, MeshPicture<Mesh>& picture) {
  picture = {};
  auto& all = picture.halfedges;
  all.push_back(start);
  const auto number = [&](const typename Mesh::Halfedge& h) {
    const std::size_t found = picture.find(h);
    if (found == all.size()) all.push_back(h);
    return found;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.size() > limit) return Contract::walk_ends;
    const auto h = all[i];
    if constexpr (requires { mesh.alive(h); })
      if (!mesh.alive(h)) return Contract::alive_knows;
    const auto across = mesh.opposite(h);
    if (across == h || !(mesh.opposite(across) == h)) return Contract::opposite_is_involution;
    const bool boundary = mesh.on_boundary(h);
    if (boundary && mesh.on_boundary(across)) return Contract::edge_has_triangle;
    if (bool{mesh.solid(h)} != bool{mesh.solid(across)}) return Contract::same_color_on_both_sides;
    if (mesh.solid(h) && (boundary || mesh.on_boundary(across))) return Contract::boundary_is_dashed;
    picture.solid.push_back(mesh.solid(h) ? 1 : 0);
    picture.opposite.push_back(number(across));
    picture.next.push_back(MeshPicture<Mesh>::no_next);
    if (boundary) continue;
    const auto second = mesh.next(h);
    if (second == h) return Contract::triangle_of_three;
    if (mesh.on_boundary(second)) return Contract::triangle_has_no_boundary;
    const auto third = mesh.next(second);
    if (third == h || third == second) return Contract::triangle_of_three;
    if (mesh.on_boundary(third)) return Contract::triangle_has_no_boundary;
    if (!(mesh.next(third) == h)) return Contract::triangle_of_three;
    picture.next[i] = number(second);
    ++picture.triangles;
  }
  picture.triangles /= 3;
  picture.vertex.assign(all.size(), all.size());
  for (std::size_t h = 0; h < all.size(); ++h)
    if (picture.vertex[h] == all.size())
      for (const std::size_t spoke : picture.fan(h).spokes) picture.vertex[spoke] = h;
  return Contract::kept;
}

/// Checks the optional members of a mesh against its picture.
template <class Mesh>
Contract check_members(const Mesh& mesh, const MeshPicture<Mesh>& picture) {
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const auto h = picture.halfedges[i];
    if constexpr (requires { mesh.leaves_boundary(h); })
      if (bool{mesh.leaves_boundary(h)} == picture.fan(i).closed) return Contract::leaves_boundary_knows;
    if (picture.on_boundary(i)) continue;
    const std::size_t second = picture.next[i];
    const std::size_t third = picture.next[second];
    if constexpr (requires { mesh.fan_step(h); }) {
      const auto step = mesh.fan_step(h);
      if (step.port != (picture.solid[second] != 0) || step.edge != (picture.solid[third] != 0) ||
          !(step.spoke == picture.halfedges[picture.opposite[third]]))
        return Contract::fan_step_agrees;
    }
    if constexpr (requires { mesh.strip_step(h); })
      if (picture.solid[i] != 0 && (picture.solid[second] == 0 || picture.solid[third] == 0)) {
        const auto step = mesh.strip_step(h);
        const std::size_t out = picture.solid[second] != 0 ? second : third;
        if (step.continues != (picture.solid[out] != 0) ||
            (step.continues && !(step.in == picture.halfedges[picture.opposite[out]])))
          return Contract::strip_step_agrees;
      }
  }
  return Contract::kept;
}

/// Checks the numbers and notes them in the picture.
template <class Mesh>
Contract check_numbers(const Mesh& mesh, MeshPicture<Mesh>& picture) {
  if constexpr (NumberedMesh<Mesh>) {
    picture.number.assign(picture.size(), 0);
    picture.chosen.assign(picture.size(), 0);
    std::vector<std::size_t> first_of(mesh.triangle_bound(), picture.size());
    for (std::size_t i = 0; i < picture.size(); ++i) {
      if (picture.on_boundary(i)) continue;
      const auto t = static_cast<std::uint32_t>(mesh.triangle(picture.halfedges[i]));
      const std::size_t first = (std::min)({i, picture.next[i], picture.next[picture.next[i]]});
      if (t >= first_of.size() || !mesh.has_triangle(t)) return Contract::triangle_numbers;
      if (first_of[t] != picture.size() && first_of[t] != first) return Contract::triangle_numbers;
      first_of[t] = first;
      const std::size_t back = picture.find(mesh.halfedge(t));
      if (back == picture.size() || picture.on_boundary(back)) return Contract::triangle_numbers;
      if ((std::min)({back, picture.next[back], picture.next[picture.next[back]]}) != first)
        return Contract::triangle_numbers;
      picture.number[i] = t;
      picture.chosen[i] = back == i ? 1 : 0;
    }
    // Called only for halfedges with a triangle: compare each with the next around its vertex, and in its triangle.
    for (std::size_t i = 0; i < picture.size(); ++i) {
      if (picture.on_boundary(i)) continue;
      const auto from = mesh.from(picture.halfedges[i]);
      const std::size_t ccw = picture.ccw(i);
      if (!picture.on_boundary(ccw) && from != mesh.from(picture.halfedges[ccw])) return Contract::vertex_numbers;
      if (from == mesh.from(picture.halfedges[picture.next[i]])) return Contract::vertex_numbers;
    }
  }
  return Contract::kept;
}

}  // namespace restrip::detail
