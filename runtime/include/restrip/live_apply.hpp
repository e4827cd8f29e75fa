// LiveMesh::apply: custom operations on a LiveMesh (operations/apply.hpp), whose tables only your program has.
#pragma once

#include "restrip/live_mesh.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip {

template <class Table>
Checked LiveMesh::apply(const Table& table, Halfedge where) {
  return checked_apply(keeper(), table, where);
}
template <class Table>
Checked LiveMesh::apply_anywhere(const Table& table, Triangle triangle) {
  return restrip::apply_anywhere(keeper(), table, triangle);
}

}  // namespace restrip
