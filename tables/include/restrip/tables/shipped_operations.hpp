// Visits the tables of tables/operations. Written by the target `regenerate`. Do not edit.
#pragma once

#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/bisect_boundary.hpp"
#include "restrip/tables/operations/bisect_matching.hpp"
#include "restrip/tables/operations/flip_matching.hpp"
#include "restrip/tables/operations/join_faces.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/merge_boundary.hpp"
#include "restrip/tables/operations/merge_matching.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "restrip/tables/operations/split_face.hpp"

namespace restrip::tables {

/// Calls visit(name, table) for each shipped operation, in the order of their names.
template <class Visit>
constexpr void for_each_operation(Visit&& visit) {
  visit("bisect", bisect_rules);
  visit("bisect-boundary", bisect_boundary_rules);
  visit("bisect-matching", bisect_matching_rules);
  visit("flip-matching", flip_matching_rules);
  visit("join-faces", join_faces_rules);
  visit("merge", merge_rules);
  visit("merge-boundary", merge_boundary_rules);
  visit("merge-matching", merge_matching_rules);
  visit("refine-face", refine_face_rules);
  visit("split-face", split_face_rules);
}

}  // namespace restrip::tables
