// Custom operations.
//
// Outline. The sides of the patch are found from the first one, triangle after triangle, as the table lists them. Their
// colours are the configuration that the table is asked for. Edges that the rule clears are cleared, the mesh replaces
// the triangles, and edges that the rule sets are set: so the colouring is valid at every moment, whatever throws.
//
// Cost. Quadratic in the triangles of the patch, at most 16.
#include "restrip/operations/apply.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/fan_checks.hpp"
#include "operations/halves.hpp"
#include "operations/patch_sides.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

using tables::edge_of;
using tables::patch_edges;
using tables::PatchEdges;
using tables::PatchTriangle;

tables::OperationRule OperationView::rule(std::uint32_t inner, std::uint32_t solid_ports) const noexcept {
  if (entries == nullptr) return {};
  const std::size_t place = matching ? solid_ports : inner << ports | solid_ports;
  std::uint32_t entry = 0;
  std::uint32_t not_valid = 0;
  const auto read = [&](const auto* numbers) {
    entry = numbers[place];
    not_valid = static_cast<std::remove_cvref_t<decltype(*numbers)>>(-1);
  };
  if (entry_bytes == 1)
    read(static_cast<const std::uint8_t*>(entries));
  else if (entry_bytes == 2)
    read(static_cast<const std::uint16_t*>(entries));
  else
    read(static_cast<const std::uint32_t*>(entries));
  return tables::OperationRule::in_entry(entry, not_valid, before, after, ports, inner, solid_ports);
}

namespace detail {

PatchSides read_sides(const StripMesh& mesh, std::span<const PatchTriangle> triangles, Halfedge where) {
  PatchSides patch;
  patch.triangles = triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    auto& side = patch.side[t];
    side[0] = t == 0 ? where : mesh.opposite(patch.side[triangles[t].from][triangles[t].from_side]);
    side[1] = StripMesh::next(side[0]);
    side[2] = StripMesh::next(side[1]);
  }
  return patch;
}

namespace {

constexpr PatchEdges all_ports = ~PatchEdges{0} << 32;

PatchEdges solid_edges(const StripMesh& mesh, const PatchSides& patch) {
  PatchEdges solid = 0;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s) solid |= mesh.solid(patch.side[t][s]) ? edge_of(patch.triangles[t].side[s]) : 0;
  return solid & ~edge_of(PatchTriangle::boundary_side);
}

/// Calls visit(halfedge) once for each of the edges.
template <class Visit>
void for_each_edge(const PatchSides& patch, PatchEdges edges, Visit&& visit) {
  for (std::size_t t = 0; t < patch.triangles.size() && edges != 0; ++t)
    for (std::size_t s = 0; s < 3; ++s) {
      const PatchEdges edge = edge_of(patch.triangles[t].side[s]);
      if ((edges & edge) != 0) visit(patch.side[t][s]);
      edges &= ~edge;
    }
}

tables::OperationRule rule_for(const OperationView& table, PatchEdges solid) noexcept {
  return table.rule(static_cast<std::uint32_t>(solid), static_cast<std::uint32_t>(solid >> 32));
}

/// Whether the triangles exist, each once, and are joined as in the table and nowhere else.
Refusal refusal_of_patch(const StripMesh& mesh, std::span<const PatchTriangle> triangles, Halfedge where) {
  if (!mesh.alive(where)) return Refusal::no_such_edge;
  if (StripMesh::on_boundary(where)) return Refusal::boundary_edge;
  if (triangles.empty()) return Refusal::other_patch;  // the position is not in the family
  PatchSides patch;
  const std::size_t sides = 3 * triangles.size();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    auto& side = patch.side[t];
    side[0] = t == 0 ? where : mesh.opposite(patch.side[triangles[t].from][triangles[t].from_side]);
    if (StripMesh::on_boundary(side[0])) return Refusal::other_patch;
    side[1] = StripMesh::next(side[0]);
    side[2] = StripMesh::next(side[1]);
  }
  for (std::size_t i = 0; i < sides; ++i) {
    const Halfedge h = patch.side[i / 3][i % 3];
    const std::uint8_t side = triangles[i / 3].side[i % 3];
    const Halfedge across = mesh.opposite(h);
    if (side == PatchTriangle::boundary_side && !StripMesh::on_boundary(across)) return Refusal::other_patch;
    bool met = false;
    for (std::size_t j = 0; j < sides; ++j) {
      if (j < i && patch.side[j / 3][j % 3] == h) return Refusal::other_patch;
      if (!(patch.side[j / 3][j % 3] == across)) continue;
      if (triangles[j / 3].side[j % 3] != side) return Refusal::other_patch;
      met = true;
    }
    if (met != (side < PatchTriangle::port_side)) return Refusal::other_patch;
  }
  return Refusal::granted;
}

/// The vertices of an operation by their numbers in the table; `none` for those that are not in use before it.
using PatchVertices = std::array<Vertex, 2 * NewVertices::most>;

PatchVertices vertices_before(const StripMesh& mesh, const PatchSides& patch) {
  PatchVertices vertex;
  vertex.fill(none);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s) vertex[patch.triangles[t].vertex[s]] = mesh.from(patch.side[t][s]);
  return vertex;
}

std::size_t triangles_at(std::span<const PatchTriangle> triangles, std::size_t v) {
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), [v](const PatchTriangle& t) {
    return std::find(t.vertex.begin(), t.vertex.end(), v) != t.vertex.end();
  }));
}

/// Whether the mesh keeps its properties: an edge that the operation makes is new, and around each vertex that stays
/// there are three triangles or more, or it is on the boundary.
Refusal refusal_of_result(const StripMesh& mesh, const OperationView& table, const PatchSides& patch) {
  const PatchVertices vertex = vertices_before(mesh, patch);
  const auto in_patch = [&](Halfedge h) {
    return StripMesh::on_boundary(h) || std::any_of(patch.sides().begin(), patch.sides().end(), [&](const auto& side) {
             return StripMesh::triangle(side[0]) == StripMesh::triangle(h);
           });
  };
  for (std::size_t v = 0; v < table.vertices; ++v) {
    if (vertex[v] == none) continue;
    if (std::count(vertex.begin(), vertex.end(), vertex[v]) != 1) return Refusal::same_vertex;
    if (mesh.non_manifold(vertex[v])) return Refusal::non_manifold_vertex;
  }
  PatchEdges on_rim = 0;  // by vertex, on the rim after the operation
  for (const PatchTriangle& t : table.triangles_after)
    for (std::size_t s = 0; s < 3; ++s) {
      const std::uint8_t from = t.vertex[s];
      const std::uint8_t to = t.vertex[(s + 1) % 3];
      if (t.side[s] >= PatchTriangle::port_side) on_rim |= PatchEdges{1} << from | PatchEdges{1} << to;
      const bool port = t.side[s] >= PatchTriangle::port_side && t.side[s] != PatchTriangle::boundary_side;
      if (port || vertex[from] == none || vertex[to] == none) continue;
      const Halfedge h = mesh.spoke(vertex[from], vertex[to]);
      if (h.id != none && !(in_patch(h) && in_patch(mesh.opposite(h)))) return Refusal::edge_exists;
    }
  for (std::size_t v = 0; v < table.vertices; ++v) {
    const std::size_t more = triangles_at(table.triangles_after, v);
    if ((on_rim >> v & 1U) == 0) {
      if (more == 1 || more == 2) return Refusal::too_few_triangles;
    } else if (vertex[v] != none && !mesh.leaves_boundary(mesh.spoke(vertex[v]))) {
      const std::size_t fewer = triangles_at(table.triangles_before, v);
      const std::size_t valence = spokes_up_to(mesh, vertex[v], 3 + fewer);
      if (valence != fewer && valence - fewer + more < 3) return Refusal::too_few_triangles;
    }
  }
  return Refusal::granted;
}

}  // namespace

Halfedge replace_patch(StripMesh& mesh, const OperationView& table, const PatchSides& patch, NewVertices* added) {
  PatchVertices vertex = vertices_before(mesh, patch);
  std::size_t named = 0;
  for (std::size_t v = 0; v < table.vertices; ++v) {
    if (vertex[v] != none || triangles_at(table.triangles_after, v) == 0) continue;
    do vertex[v] = mesh.next_vertex(named++);
    while (std::count(vertex.begin(), vertex.end(), vertex[v]) != 1);
    if (added != nullptr) added->push_back(vertex[v]);
  }
  std::array<Triangle, tables::most_patch_triangles> out;
  std::array<std::array<Vertex, 3>, tables::most_patch_triangles> in;
  std::array<Triangle, tables::most_patch_triangles> made;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) out[t] = StripMesh::triangle(patch.side[t][0]);
  const std::size_t count = table.triangles_after.size();
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t s = 0; s < 3; ++s) in[t][s] = vertex[table.triangles_after[t].vertex[s]];
  mesh.replace(std::span(out).first(patch.triangles.size()), std::span(in).first(count), std::span(made).first(count));
  return StripMesh::halfedge(made[0]);
}

Rewrite apply_unchecked(StripMesh& mesh, const OperationView& table, Halfedge where, NewVertices* added) {
  const PatchSides patch = read_sides(mesh, table.triangles_before, where);
  const PatchEdges before = solid_edges(mesh, patch);
  const tables::OperationRule rule = rule_for(table, before);
  const PatchEdges solid = patch_edges(rule.colors, rule.ports);
  int isolated =
      tables::isolated_among(table.triangles_after, solid) - tables::isolated_among(table.triangles_before, before);
  if (const PatchEdges cleared = before & ~solid & all_ports; cleared != 0) {
    std::array<Halfedge, tables::most_patch_ports> outer;
    std::size_t count = 0;
    for_each_edge(patch, cleared, [&](Halfedge h) { outer[count++] = mesh.opposite(h); });
    isolated += isolated_outside(mesh, std::span<const Halfedge>(outer.data(), count));
  }
  for_each_edge(patch, before & ~(solid & all_ports), [&](Halfedge h) { mesh.set_solid(h, false); });
  const Halfedge first = replace_patch(mesh, table, patch, added);
  for_each_edge(read_sides(mesh, table.triangles_after, first), solid, [&](Halfedge h) {
    if (!mesh.solid(h)) mesh.set_solid(h, true);
  });
  return {{rule.strips, 0, isolated}, first, table.ports};
}

}  // namespace detail

Refusal check_apply(const StripMesh& mesh, const OperationView& table, Halfedge where) {
  const Refusal refusal = detail::refusal_of_patch(mesh, table.triangles_before, where);
  if (refusal != Refusal::granted) return refusal;
  const detail::PatchSides patch = detail::read_sides(mesh, table.triangles_before, where);
  if (!detail::rule_for(table, detail::solid_edges(mesh, patch)).valid) return Refusal::colors_not_valid;
  return detail::refusal_of_result(mesh, table, patch);
}

Rewrite apply(StripMesh& mesh, const OperationView& table, Halfedge where, NewVertices* added) {
  RESTRIP_ASSERT_GRANTED(check_apply(mesh, table, where), "apply");
  return detail::apply_unchecked(mesh, table, where, added);
}

Checked checked_apply(StripMesh& mesh, const OperationView& table, Halfedge where) {
  Checked done;
  done.refusal = check_apply(mesh, table, where);
  if (done) done.rewrite = detail::apply_unchecked(mesh, table, where, &done.new_vertices);
  return done;
}

Halfedge first_place(const StripMesh& mesh, const OperationView& table, Triangle triangle) {
  if (!mesh.alive(triangle)) return {};
  for (unsigned side = 0; side < 3; ++side) {
    const Halfedge h = StripMesh::halfedge(triangle, side);
    if (check_apply(mesh, table, h) == Refusal::granted) return h;
  }
  return StripMesh::halfedge(triangle);
}

}  // namespace restrip
