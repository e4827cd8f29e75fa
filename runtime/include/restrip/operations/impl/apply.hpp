// Included by apply.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "restrip/operations/apply.hpp"
#include "restrip/operations/impl/halves.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

template <class Halfedge, std::size_t Extent>
Halfedge PatchSides<Halfedge, Extent>::between(unsigned from, unsigned to) const {
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s)
      if (triangles[t].vertex[s] == from && triangles[t].vertex[(s + 1) % 3] == to) return side[t][s];
  RESTRIP_ASSERT(false, "PatchSides::between", "no triangle of the patch has this side");
  return side[0][0];
}

namespace detail {

template <class Mesh, class Triangles, class Halfedge = typename Mesh::Halfedge>
auto read_sides(const Mesh& mesh, const Triangles& triangles, Halfedge where) {
  PatchSides<Halfedge, patch_extent<Triangles>> patch(triangles);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    auto& side = patch.side[t];
    side[0] = t == 0 ? where : mesh.opposite(patch.side[triangles[t].from][triangles[t].from_side]);
    side[1] = mesh.next(side[0]);
    side[2] = mesh.next(side[1]);
  }
  return patch;
}

using tables::edge_of;
using tables::patch_edges;
using tables::PatchEdges;
inline constexpr PatchEdges all_ports = ~PatchEdges{0} << 32;

template <class Mesh, class Sides>
PatchEdges solid_edges(const Mesh& mesh, const Sides& patch) {
  PatchEdges solid = 0;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s) solid |= mesh.solid(patch.side[t][s]) ? edge_of(patch.triangles[t].side[s]) : 0;
  return solid & ~edge_of(tables::PatchTriangle::boundary_side);
}

/// Calls visit(halfedge) once for each of the edges.
template <class Sides, class Visit>
void for_each_edge(const Sides& patch, PatchEdges edges, Visit&& visit) {
  for (std::size_t t = 0; t < patch.triangles.size() && edges != 0; ++t)
    for (std::size_t s = 0; s < 3; ++s) {
      const PatchEdges edge = edge_of(patch.triangles[t].side[s]);
      if ((edges & edge) != 0) visit(patch.side[t][s]);
      edges &= ~edge;
    }
}

template <SurfaceTable Table>
constexpr tables::OperationRule rule_for(const Table& table, PatchEdges solid) noexcept {
  return tables::rule_of(table, static_cast<std::uint32_t>(solid), static_cast<std::uint32_t>(solid >> 32));
}

/// What apply() takes instead of the rule of these solid edges: the rule itself. RuleChoice has another answer.
struct TakeRule {
  template <class Mesh, class Table, class Sides>
  tables::OperationRule operator()(const Mesh& /*mesh*/, const Table& /*table*/, const Sides& /*patch*/,
                                   PatchEdges /*solid*/, const tables::OperationRule& rule) const noexcept {
    return rule;
  }
};

/// apply() without checks of preconditions.
template <class Mesh, class Table, class Change, class Choose = TakeRule>
Rewrite<typename Mesh::Halfedge> apply_unchecked(Mesh& mesh, const Table& table, typename Mesh::Halfedge where,
                                                 Change&& change, Choose&& choose = {}) {
  const PendingApply<typename Mesh::Halfedge, Table> pending(mesh, table, where, choose);
  return pending.finish(mesh, change(pending.patch()));
}

/// Whether the triangles exist, each once, and are joined as in the table and nowhere else.
template <ColoredMesh Mesh, class Triangles>
Refusal refusal_of_patch(const Mesh& mesh, const Triangles& triangles, typename Mesh::Halfedge where) {
  if (!knows(mesh, where)) return Refusal::no_such_edge;
  if (mesh.on_boundary(where)) return Refusal::boundary_edge;
  if (triangles.empty()) return Refusal::other_patch;  // the position is not in the family
  PatchSides<typename Mesh::Halfedge, patch_extent<Triangles>> patch(triangles);
  const std::size_t sides = 3 * triangles.size();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    auto& side = patch.side[t];
    side[0] = t == 0 ? where : mesh.opposite(patch.side[triangles[t].from][triangles[t].from_side]);
    if (mesh.on_boundary(side[0])) return Refusal::other_patch;
    side[1] = mesh.next(side[0]);
    side[2] = mesh.next(side[1]);
  }
  for (std::size_t i = 0; i < sides; ++i) {
    const auto h = patch.side[i / 3][i % 3];
    const std::uint8_t side = triangles[i / 3].side[i % 3];
    const auto across = mesh.opposite(h);
    if (side == tables::PatchTriangle::boundary_side && !mesh.on_boundary(across)) return Refusal::other_patch;
    bool met = false;
    for (std::size_t j = 0; j < sides; ++j) {
      if (j < i && patch.side[j / 3][j % 3] == h) return Refusal::other_patch;
      if (!(patch.side[j / 3][j % 3] == across)) continue;
      if (triangles[j / 3].side[j % 3] != side) return Refusal::other_patch;
      met = true;
    }
    if (met != (side < tables::PatchTriangle::port_side)) return Refusal::other_patch;
  }
  return Refusal::granted;
}

/// Also whether the colours have a rule.
template <ColoredMesh Mesh, SurfaceTable Table>
Refusal refusal_of_apply(const Mesh& mesh, const Table& table, typename Mesh::Halfedge where) {
  const Refusal refusal = refusal_of_patch(mesh, table.triangles_before, where);
  if (refusal != Refusal::granted) return refusal;
  const PatchEdges solid = solid_edges(mesh, read_sides(mesh, table.triangles_before, where));
  return rule_for(table, solid).valid ? Refusal::granted : Refusal::colors_not_valid;
}

/// Calls call(out, in, vertices, made) with the arguments of StripMesh::replace().
template <class Table, class Call>
auto with_replacement(const StripMesh& mesh, const Table& table, const SidesBefore<StripMesh::Halfedge, Table>& patch,
                      Call&& call) {
  using After = PatchSides<StripMesh::Halfedge, patch_extent<decltype(Table::triangles_after)>>;
  constexpr std::size_t most_before = std::tuple_size_v<decltype(patch.side)>;
  constexpr std::size_t most_after = std::tuple_size_v<decltype(After::side)>;
  std::array<Triangle, most_before> out;
  std::array<StripMesh::Places, most_after> in;
  std::array<Vertex, 3 * (most_before + most_after)> vertices;
  std::array<Triangle, most_after> made;
  vertices.fill(none);
  const std::size_t before = table.triangles_before.size();
  for (std::size_t t = 0; t < before; ++t) {
    out[t] = StripMesh::triangle(patch.side[t][0]);
    for (std::size_t s = 0; s < 3; ++s) vertices[table.triangles_before[t].vertex[s]] = mesh.from(patch.side[t][s]);
  }
  const std::size_t after = table.triangles_after.size();
  for (std::size_t t = 0; t < after; ++t) in[t] = table.triangles_after[t].vertex;
  return call(std::span(out).first(before), std::span(in).first(after), std::span(vertices).first(table.vertices),
              std::span(made).first(after));
}

/// Changes a StripMesh as the table says.
template <class Table>
auto replacing(StripMesh& mesh, const Table& table) {
  return [&mesh, &table](const SidesBefore<StripMesh::Halfedge, Table>& patch) {
    return with_replacement(mesh, table, patch, [&mesh](auto out, auto in, auto vertices, auto made) {
      mesh.replace(out, in, vertices, made);
      return StripMesh::halfedge(made[0]);
    });
  };
}

}  // namespace detail

template <class Halfedge, SurfaceTable Table>
class PendingApply {
 public:
  [[nodiscard]] const SidesBefore<Halfedge, Table>& patch() const noexcept { return patch_; }

  /// Reads the patch, looks the rule up, and clears the inner edges and the ports to be cleared.
  template <class Mesh, class Choose = detail::TakeRule>
  PendingApply(Mesh& mesh, const Table& table, Halfedge where, Choose&& choose = {})
      : table_(&table), patch_(detail::read_sides(mesh, table.triangles_before, where)) {
    const detail::PatchEdges before = detail::solid_edges(mesh, patch_);
    const tables::OperationRule rule = choose(mesh, table, patch_, before, detail::rule_for(table, before));
    solid_ = detail::patch_edges(rule.colors, rule.ports);
    strips_ = rule.strips;
    isolated_ =
        tables::isolated_among(table.triangles_after, solid_) - tables::isolated_among(table.triangles_before, before);
    if (const detail::PatchEdges cleared = before & ~solid_ & detail::all_ports; cleared != 0) {
      std::array<Halfedge, tables::most_patch_ports> outer;  // not {}: a handle's default constructor may be explicit
      std::size_t count = 0;
      detail::for_each_edge(patch_, cleared, [&](Halfedge h) { outer[count++] = mesh.opposite(h); });
      isolated_ += detail::isolated_outside(mesh, std::span<const Halfedge>(outer.data(), count));
    }
    detail::for_each_edge(patch_, before & ~(solid_ & detail::all_ports),
                          [&](Halfedge h) { mesh.set_solid(h, false); });
  }
  /// Sets the solid edges of the rule.
  template <class Mesh>
  Rewrite<Halfedge> finish(Mesh& mesh, Halfedge first) const {
    detail::for_each_edge(detail::read_sides(mesh, table_->triangles_after, first), solid_, [&](Halfedge h) {
      if (!mesh.solid(h)) mesh.set_solid(h, true);
    });
    return {{strips_, 0, isolated_}, first, table_->ports};
  }
  [[nodiscard]] const Table& table() const noexcept { return *table_; }

 private:
  const Table* table_;
  SidesBefore<Halfedge, Table> patch_;
  detail::PatchEdges solid_ = 0;  // after the operation
  int strips_ = 0;
  int isolated_ = 0;
};

template <SurfaceTable Table>
Refusal check_apply(const StripMesh& mesh, const Table& table, StripMesh::Halfedge where) {
  const Refusal refusal = detail::refusal_of_apply(mesh, table, where);
  if (refusal != Refusal::granted) return refusal;
  return detail::with_replacement(
      mesh, table, detail::read_sides(mesh, table.triangles_before, where),
      [&mesh](auto out, auto in, auto vertices, auto /*made*/) { return check_replace(mesh, out, in, vertices); });
}

template <CheckedTarget Target, SurfaceTable Table>
Checked checked_apply(Target& target, const Table& table, StripMesh::Halfedge where) {
  return detail::done_if_granted(
      target, check_apply(detail::mesh_of(target), table, where), [&](auto& mesh) { return apply(mesh, table, where); },
      [&](auto& keeper) { return keeper.apply(table, where); });
}

template <SurfaceTable Table>
Places places(const StripMesh& mesh, const Table& table, Triangle triangle) {
  Places found;
  if (!mesh.alive(triangle)) return found;
  for (unsigned side = 0; side < 3; ++side) {
    const auto h = StripMesh::halfedge(triangle, side);
    if (check_apply(mesh, table, h) == Refusal::granted) found.side[found.count++] = h;
  }
  return found;
}

template <CheckedTarget Target, SurfaceTable Table>
Checked apply_anywhere(Target& target, const Table& table, Triangle triangle) {
  const StripMesh& mesh = detail::mesh_of(target);
  const Places found = places(mesh, table, triangle);
  const StripMesh::Halfedge none_fits = mesh.alive(triangle) ? StripMesh::halfedge(triangle) : StripMesh::Halfedge{};
  return checked_apply(target, table, found.empty() ? none_fits : found.side[0]);
}

template <SurfaceTable Table>
Rewrite<StripMesh::Halfedge> apply(StripMesh& mesh, const Table& table, StripMesh::Halfedge where) {
  RESTRIP_ASSERT_GRANTED(check_apply(mesh, table, where), "apply");
  return detail::apply_unchecked(mesh, table, where, detail::replacing(mesh, table));
}

template <ColoredMesh Mesh, SurfaceTable Table, class Change>
Rewrite<typename Mesh::Halfedge> apply(Mesh& mesh, const Table& table, typename Mesh::Halfedge where, Change&& change) {
  const auto pending = before_apply(mesh, table, where);
  return after_apply(mesh, pending, change(pending.patch()));
}

template <ColoredMesh Mesh, SurfaceTable Table>
PendingApply<typename Mesh::Halfedge, Table> before_apply(Mesh& mesh, const Table& table,
                                                          typename Mesh::Halfedge where) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_apply(mesh, table, where), "apply");
  return {mesh, table, where};
}

template <ColoredMesh Mesh, SurfaceTable Table>
Rewrite<typename Mesh::Halfedge> after_apply(Mesh& mesh, const PendingApply<typename Mesh::Halfedge, Table>& pending,
                                             typename Mesh::Halfedge first) {
  RESTRIP_ASSERT(detail::refusal_of_patch(mesh, pending.table().triangles_after, first) == Refusal::granted, "apply",
                 "the mesh does not have the triangles that the operation makes");
  return pending.finish(mesh, first);
}

}  // namespace restrip
