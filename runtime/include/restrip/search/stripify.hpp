// Strips from scratch, with three efforts and a cost.
//
// Fewest strips and fewest indices are different aims: a strip that turns twice the same way repeats an index, so few
// long strips take more indices than many straight ones (on the Stanford bunny 3 strips take 1.38 indices a triangle,
// 1,500 take 1.12).
//
//   stripify(mesh, Effort::full, Cost::indices());
//   const std::vector<std::uint32_t> indices = strip_indices(mesh);
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "restrip/fwd.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/search/impl/annealing.hpp"
#include "restrip/search/impl/greedy.hpp"
#include "restrip/search/impl/rounds.hpp"
#include "restrip/search/impl/strip_locator.hpp"
#include "restrip/search/impl/tunnel.hpp"
#include "restrip/search/impl/window_rounds.hpp"

namespace restrip {

/// Colours the whole mesh from scratch and returns the number of strips. The result depends only on the mesh and the
/// arguments, and is the same on every machine. `cost` is as in cost.hpp, with one addition: if swaps have a weight, a
/// strip that begins with the wrong turn from both ends counts as one more swap, as in a written index buffer. So with
/// Cost::indices() the length of strip_indices() is minimised.
///
/// `limit` bounds the work of Effort::full and Effort::best; 0 is the default. If only strips have a weight, it counts
/// states of searches, a few hundred nanoseconds each: by default 40 for each triangle, 1,000 with Effort::best; the
/// search stops early when fewer strips are impossible. Otherwise it counts moves of annealing and colourings of a
/// triangle in a window, some 60 ns each. With Effort::full the default is 100 moves for each triangle, and windows are
/// not counted. With Effort::best it is 1,000 for each triangle after the default work of Effort::full, two fifths of
/// them moves. `seed` selects one of many equally good colourings; the search for fewest strips ignores it.
template <NumberedMesh Mesh>
std::size_t stripify(Mesh& mesh, Effort effort = default_effort, Cost cost = default_cost, std::uint64_t limit = 0,
                     std::uint64_t seed = 1);

namespace detail {

/// Colours from scratch, or from the present colours if swaps have no weight, as for stripify().
inline void color_from_scratch(Annealing& annealing, Effort effort, Cost cost, std::uint64_t limit,
                               std::uint64_t seed) {
  const std::uint64_t triangles = annealing.triangle_count();
  if (cost.swap != 0) {
    annealing.grow();
    annealing.settle_ends();
  }
  if (effort == Effort::fast) return;
  if (cost.swap != 0) {
    annealing.keep();
    annealing.grow();
    annealing.stir_ends(2);
  }
  const auto cool = [&annealing](std::uint64_t moves, std::uint32_t heat) {
    annealing.cool(moves, heat);
    annealing.keep();
  };
  annealing.keep();
  // On regular meshes the strips of the first pass are hard to beat.
  cool(10 * triangles, 0);
  cool(limit != 0 && effort == Effort::full ? limit : 100 * triangles, 100);
  annealing.go_back();
  WindowRounds windows(cost, seed);
  windows.run(annealing.colors(), WindowRounds::round_budget(triangles), {.triangles = 20});
  annealing.keep();
  if (effort == Effort::best) {
    // Small meshes take hardly any time, so they are searched until luck does not matter.
    const std::uint64_t budget = limit != 0 ? limit : std::max<std::uint64_t>(1000 * triangles, 250'000);
    const std::uint64_t moves = budget * 2 / 5;
    cool(moves, 100);
    annealing.go_back();
    const std::uint64_t stop = windows.spent() + (budget - moves);
    while (windows.spent() < stop && annealing.colors().cost(cost) != 0)
      windows.run(annealing.colors(), stop - windows.spent(), {.triangles = 60});
    annealing.keep();
  }
  // Colours that are not cheaper than the previous ones are dropped.
  annealing.go_back();
}

}  // namespace detail

template <NumberedMesh Mesh>
std::size_t stripify(Mesh& mesh, Effort effort, Cost cost, std::uint64_t limit, std::uint64_t seed) {
  auto&& sides = by_sides(mesh);
  const std::uint64_t triangles = sides.triangle_count();
  if (cost.swap == 0) {
    const std::size_t strips = stripify_fast(sides);
    if (effort == Effort::fast) return strips;
    const bool strips_alone = cost.isolated == 0;
    const std::uint64_t states = (effort == Effort::full ? 40 : 1000) * triangles;
    StripLocator locator(sides, StripLocator::chunk_limit_for_long_strips(static_cast<std::size_t>(triangles)));
    Tunnel tunnel;
    TunnelRounds().run(sides, locator, tunnel, static_cast<std::size_t>(strips_alone && limit != 0 ? limit : states),
                       connected_components(sides));
    if (strips_alone) return locator.strips();
  }
  detail::Annealing annealing(detail::ColoringCopy(sides), cost, seed);
  detail::color_from_scratch(annealing, effort, cost, limit, seed);
  annealing.give(sides);
  return annealing.strips();
}

extern template std::size_t stripify(StripMesh&, Effort, Cost, std::uint64_t, std::uint64_t);

}  // namespace restrip
