// StripMesh, its checks, and triangle lists.
#include "restrip/mesh/strip_mesh.hpp"

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/impl/checks.hpp"
#include "restrip/mesh/impl/join_sides.hpp"
#include "restrip/mesh/impl/replace.hpp"
#include "restrip/mesh/impl/strip_mesh.hpp"

namespace restrip {

using Triples = std::array<Vertex, 3>;

template StripMesh StripMesh::build_of(const TriangleList<std::uint32_t>&, std::size_t, BuildReport*,
                                       std::vector<std::uint32_t>*);
template StripMesh StripMesh::build_of(const TriangleList<std::uint16_t>&, std::size_t, BuildReport*,
                                       std::vector<std::uint32_t>*);
template StripMesh StripMesh::build_of(const TriangleList<Triples>&, std::size_t, BuildReport*,
                                       std::vector<std::uint32_t>*);
template void find_neighbors(const TriangleList<std::uint32_t>&, std::size_t, std::span<Triples>, BuildReport&);
template void find_neighbors(const TriangleList<std::uint16_t>&, std::size_t, std::span<Triples>, BuildReport&);
template void find_neighbors(const TriangleList<Triples>&, std::size_t, std::span<Triples>, BuildReport&);

}  // namespace restrip
