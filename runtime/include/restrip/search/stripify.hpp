// Strips from scratch, with three efforts and a cost.
//
// Fewest strips and fewest indices are different aims: a strip that turns twice the same way repeats an index, so few
// long strips take more indices than many straight ones (on the Stanford bunny 3 strips take 1.38 indices a triangle,
// 1,500 take 1.12).
//
//   stripify(mesh, Effort::full, Cost::indices());
//   const std::vector<std::uint32_t> indices = strip_indices(mesh);
#pragma once

#include <cstddef>
#include <cstdint>

#include "restrip/fwd.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// Asked by a long search, several times a second: once `stop` returns true, the search ends with the best strips that
/// it has found. Null: never.
struct Interrupt {
  bool (*stop)(void* context) = nullptr;
  void* context = nullptr;
};

/// Colours the whole mesh from scratch and returns the number of strips. The result depends only on the mesh and the
/// arguments, and is the same on every machine. `cost` is as in cost.hpp, with one addition: if swaps have a weight, a
/// strip that begins with the wrong turn from both ends counts as one more swap, as in a written index buffer. So with
/// Cost::indices() the length of strip_indices() is minimised.
///
/// `limit` bounds the work of Effort::full and Effort::best; 0 is the default. If only strips have a weight, it counts
/// states of searches, a few hundred nanoseconds each: by default 40 for each triangle; the search stops early when
/// fewer strips are impossible. Otherwise it counts moves of annealing, some 60 ns each: by default 100 for each
/// triangle with Effort::full, and 900 more with Effort::best; chains are not counted. `seed` selects one of many
/// equally good colourings; the search for fewest strips ignores it.
std::size_t stripify(StripMesh& mesh, Effort effort = default_effort, Cost cost = default_cost, std::uint64_t limit = 0,
                     std::uint64_t seed = 1, const Interrupt& interrupt = {});

}  // namespace restrip
