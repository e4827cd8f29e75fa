// Everything that must hold of a mesh and its strips, checked from scratch, and the same in the small around one
// vertex.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meshes/soup.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/strip_locator.hpp"

namespace restrip::tools {

/// The triangles of a mesh, in the order of their handles.
[[nodiscard]] std::vector<Corners> triangles_of(const StripMesh& mesh);

/// Triangles as a set: each begun at its smallest corner, all sorted, degenerate ones left out.
[[nodiscard]] std::vector<Corners> sorted_triangles(std::vector<Corners> triangles);

/// What a graphics card draws: the triangles of an index buffer of strips with primitive restart, without the
/// degenerate ones, which it drops.
[[nodiscard]] std::vector<Corners> decode_strips(std::span<const std::uint32_t> indices);

/// The whole mesh: links lead back, neighbours agree on their vertices, each vertex's first spoke starts its fan, and
/// the colouring is valid. One sentence for each kind of fault; empty when none exists. Linear time.
[[nodiscard]] std::vector<std::string> find_faults(const StripMesh& mesh);

/// Looks for faults in the triangles around one vertex; cycles are looked for along the strips that pass it, as far as
/// `farthest_cycle` triangles. Empty when there is no fault.
[[nodiscard]] std::string find_fault_around(const StripMesh& mesh, Vertex v);
inline constexpr std::size_t farthest_cycle = 4096;

/// Does the locator know the strips of the mesh, and the order of the triangles in each? Empty when it does.
[[nodiscard]] std::string find_fault(const StripMesh& mesh, const StripLocator& locator);

/// Are the strips, swaps and isolated triangles of the mesh as many as its keeper says? Empty when they are.
[[nodiscard]] std::string find_fault(const Keeper<StripMesh>& keeper);

}  // namespace restrip::tools
