// Keepers of a StripMesh.
#include "restrip/search/keeper.hpp"

namespace restrip {

template class Keeper<StripMesh>;

Checked checked_split(Keeper<StripMesh>& keeper, const VertexSplit& where, Vertex new_vertex) {
  Checked done;
  done.refusal = check_split(keeper.mesh(), where, new_vertex);
  if (!done) return done;
  done.rewrite = keeper.split(where, new_vertex);
  done.new_vertices.push_back(keeper.mesh().to(done.rewrite.halfedge));
  return done;
}

Checked checked_collapse(Keeper<StripMesh>& keeper, Halfedge chord) {
  Checked done;
  done.refusal = check_collapse(keeper.mesh(), chord);
  if (done) done.rewrite = keeper.collapse(chord);
  return done;
}

Checked checked_flip(Keeper<StripMesh>& keeper, Halfedge h) {
  Checked done;
  done.refusal = check_flip(keeper.mesh(), h);
  if (done) done.rewrite = keeper.flip(h);
  return done;
}

Checked checked_apply(Keeper<StripMesh>& keeper, const OperationView& table, Halfedge where) {
  Checked done;
  done.refusal = check_apply(keeper.mesh(), table, where);
  if (done) done.rewrite = keeper.apply(table, where, &done.new_vertices);
  return done;
}

}  // namespace restrip
