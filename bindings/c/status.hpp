// Codes and texts of the C interface, and the guard that no exception passes.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <utility>

#include "restrip.h"
#include "restrip/restrip.hpp"

namespace restrip::c {

/// The codes of the refusals, which never change, in the order of Refusal up to other_valence.
inline constexpr std::array<restrip_status, 15> codes{
    RESTRIP_OK,
    RESTRIP_NO_SUCH_EDGE,
    RESTRIP_DIFFERENT_VERTICES,
    RESTRIP_SAME_SPOKE,
    RESTRIP_NON_MANIFOLD_VERTEX,
    RESTRIP_BOUNDARY_EDGE,
    RESTRIP_SPOKE_ON_BOUNDARY,
    RESTRIP_JOINS_BOUNDARIES,
    RESTRIP_LINK_CONDITION,
    RESTRIP_TOO_FEW_TRIANGLES,
    RESTRIP_DANGLING_EDGE,
    RESTRIP_EDGE_EXISTS,
    RESTRIP_VERTEX_IN_USE,
    RESTRIP_VERTEX_TOO_FAR,
    RESTRIP_OTHER_VALENCE,
};
static_assert(codes.size() == static_cast<std::size_t>(Refusal::other_valence) + 1);

constexpr restrip_status status_of(Refusal refusal) noexcept {
  if (refusal == Refusal::colors_not_valid) return RESTRIP_BAD_COLORING;
  const auto place = static_cast<std::size_t>(refusal);
  // The others are of operations that the C interface lacks.
  return place < codes.size() ? codes[place] : RESTRIP_UNEXPECTED;
}

/// The text of a code; refusals have the texts of the library.
constexpr const char* text_of(restrip_status status) noexcept {
  for (std::size_t place = 0; place < codes.size(); ++place)
    if (codes[place] == status) return describe(static_cast<Refusal>(place));
  constexpr std::pair<restrip_status, const char*> texts[] = {
      {RESTRIP_NULL_ARGUMENT, "a pointer that must not be null is null"},
      {RESTRIP_BAD_ARGUMENT, "an argument is outside its range or not supported here: see the function's comment"},
      {RESTRIP_BAD_COLORING, "the colours are not a valid colouring"},
      {RESTRIP_TOO_LARGE, "there are more triangles or vertices than a mesh or its indices can hold"},
      {RESTRIP_TOO_SMALL, "the array is too short for the result"},
      {RESTRIP_BAD_FILE, "the bytes are not a baked mesh, or are damaged"},
      {RESTRIP_NOT_BAKED, "the mesh was not read from a baked mesh"},
      {RESTRIP_OUT_OF_STEP, "the mesh has left its baked levels: restart it"},
      {RESTRIP_OVERLAP, "two operations of the batch overlap"},
      {RESTRIP_MIXED_NAMES, "either all splits of a batch name their new vertex, or none does"},
      {RESTRIP_NOT_LIVE, "the mesh has no live buffer: call restrip_live_begin first"},
      {RESTRIP_OUT_OF_MEMORY, "there is not enough memory"},
      {RESTRIP_UNEXPECTED, "an error in restrip"},
  };
  for (const auto& [code, text] : texts)
    if (code == status) return text;
  return "this is not a code of restrip";
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
