// Keepers of a StripMesh.
#include "restrip/search/keeper.hpp"

namespace restrip {

using Halfedge = StripMesh::Halfedge;

template class Keeper<StripMesh>;
template Rewrite<Halfedge> Keeper<StripMesh>::split(const VertexSplit<Halfedge>&);
template Rewrite<Halfedge> Keeper<StripMesh>::split(const VertexSplit<Halfedge>&, Vertex);

}  // namespace restrip
