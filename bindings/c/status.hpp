// Codes and texts of the C interface, and the guard that no exception passes.
#pragma once

#include <new>
#include <stdexcept>

#include "restrip.h"
#include "restrip/restrip.hpp"

namespace restrip::c {

/// The codes 1 to 13 are the refusals of the library under numbers that never change.
constexpr restrip_status status_of(Refusal refusal) noexcept {
  switch (refusal) {
    case Refusal::granted:
      return RESTRIP_OK;
    case Refusal::no_such_edge:
      return RESTRIP_NO_SUCH_EDGE;
    case Refusal::different_vertices:
      return RESTRIP_DIFFERENT_VERTICES;
    case Refusal::same_spoke:
      return RESTRIP_SAME_SPOKE;
    case Refusal::non_manifold_vertex:
      return RESTRIP_NON_MANIFOLD_VERTEX;
    case Refusal::boundary_edge:
      return RESTRIP_BOUNDARY_EDGE;
    case Refusal::spoke_on_boundary:
      return RESTRIP_SPOKE_ON_BOUNDARY;
    case Refusal::joins_boundaries:
      return RESTRIP_JOINS_BOUNDARIES;
    case Refusal::link_condition:
      return RESTRIP_LINK_CONDITION;
    case Refusal::too_few_triangles:
      return RESTRIP_TOO_FEW_TRIANGLES;
    case Refusal::dangling_edge:
      return RESTRIP_DANGLING_EDGE;
    case Refusal::edge_exists:
      return RESTRIP_EDGE_EXISTS;
    case Refusal::vertex_in_use:
      return RESTRIP_VERTEX_IN_USE;
    case Refusal::vertex_too_far:
      return RESTRIP_VERTEX_TOO_FAR;
    case Refusal::other_valence:
      return RESTRIP_OTHER_VALENCE;
    case Refusal::colors_not_valid:
      return RESTRIP_BAD_COLORING;
    case Refusal::other_patch:  // of operations that the C interface lacks
    case Refusal::same_vertex:
      break;
  }
  return RESTRIP_UNEXPECTED;
}

/// The text of a code; refusals have the texts of the library.
constexpr const char* text_of(restrip_status status) noexcept {
  for (int i = 0; i <= static_cast<int>(Refusal::other_valence); ++i)
    if (const auto refusal = static_cast<Refusal>(i); status_of(refusal) == status) return describe(refusal);
  switch (status) {
    case RESTRIP_NULL_ARGUMENT:
      return "a pointer that must not be null is null";
    case RESTRIP_BAD_ARGUMENT:
      return "an argument is outside its range or not supported here: see the function's comment";
    case RESTRIP_BAD_COLORING:
      return "the colours are not a valid colouring";
    case RESTRIP_TOO_LARGE:
      return "there are more triangles or vertices than a mesh or its indices can hold";
    case RESTRIP_TOO_SMALL:
      return "the array is too short for the result";
    case RESTRIP_BAD_FILE:
      return "the bytes are not a baked mesh, or are damaged";
    case RESTRIP_NOT_BAKED:
      return "the mesh was not read from a baked mesh";
    case RESTRIP_OUT_OF_STEP:
      return "the mesh has left its baked levels: restart it";
    case RESTRIP_OVERLAP:
      return "two operations of the batch overlap";
    case RESTRIP_MIXED_NAMES:
      return "either all splits of a batch name their new vertex, or none does";
    case RESTRIP_NOT_LIVE:
      return "the mesh has no live buffer: call restrip_live_begin first";
    case RESTRIP_OUT_OF_MEMORY:
      return "there is not enough memory";
    case RESTRIP_UNEXPECTED:
      return "an error in restrip";
    default:
      return "this is not a code of restrip";
  }
}

/// The result of work(), or the code of the exception that ends it.
template <class Work>
restrip_status guarded(Work&& work) noexcept {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return RESTRIP_OUT_OF_MEMORY;
  } catch (const std::length_error&) {
    return RESTRIP_TOO_LARGE;
  } catch (...) {
    return RESTRIP_UNEXPECTED;
  }
}

/// The number given, as a member of an enumeration of the library, 0 to `last`.
template <class Enum>
bool named(std::int32_t number, Enum last, Enum& out) noexcept {
  if (number < 0 || number > static_cast<std::int32_t>(last)) return false;
  out = static_cast<Enum>(number);
  return true;
}

/// False when a weight is out of range.
inline bool cost_of(const restrip_cost* given, Cost& out) noexcept {
  constexpr std::uint16_t most = 1000;
  if (given == nullptr) {
    out = default_cost;
    return true;
  }
  out = {given->restart, given->swap, given->isolated};
  return out.restart >= 1 && out.restart <= most && out.swap <= most && out.isolated <= most;
}

}  // namespace restrip::c
