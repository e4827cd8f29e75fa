// Checks everything that must hold for a mesh and its strips, from scratch or only around one vertex.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meshes/soup.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip {
class StripLocator;
}

namespace restrip::tools {

/// The triangles of a mesh, in the order of their handles.
[[nodiscard]] std::vector<Corners> corners_of(const StripMesh& mesh);

/// Triangles as a set: each starts at its smallest corner, all are sorted, degenerate ones are left out.
[[nodiscard]] std::vector<Corners> sorted_triangles(std::vector<Corners> triangles);

/// The triangles that a graphics card draws from an index buffer of strips with primitive restart. Degenerate triangles
/// are dropped.
[[nodiscard]] std::vector<Corners> decode_strips(std::span<const std::uint32_t> indices);

/// Checks the whole mesh: links lead back, neighbours agree on their vertices, each vertex's first spoke starts its
/// fan, and the colouring is valid. Returns one sentence for each kind of fault; empty if the mesh is correct. Linear
/// time.
[[nodiscard]] std::vector<std::string> find_faults(const StripMesh& mesh);

/// Checks the triangles around one vertex. Cycles are searched for along the strips through them, up to
/// `farthest_cycle` triangles. Empty if no fault is found.
[[nodiscard]] std::string find_fault_around(const StripMesh& mesh, Vertex v);
inline constexpr std::size_t farthest_cycle = 4096;

/// Compares the locator with the strips of the mesh and the order of the triangles in each. Empty if they agree. In
/// locator_check.cpp.
[[nodiscard]] std::string find_fault(const StripMesh& mesh, const StripLocator& locator);

/// Compares the strips, swaps and isolated triangles of the mesh with the keeper's counts. Empty if they agree.
[[nodiscard]] std::string find_fault(const Keeper& keeper);

}  // namespace restrip::tools
