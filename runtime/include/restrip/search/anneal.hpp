// Cheap colourings from scratch by simulated annealing.
//
// Method. A random change of a few dual edges is accepted if it costs no more, and otherwise with a probability that
// falls with a temperature (Kirkpatrick, Gelatt, Vecchi, "Optimization by simulated annealing", 1983). A change clears
// a solid edge, or sets a dashed one and clears one at each end that has two: its price follows from six triangles. A
// walk from both ends of the strip excludes cycles; if strips are too long for walks, trees record which triangles
// belong to one strip. Changes are tried only at strip ends and swaps, a few of a hundred triangles in the end, in the
// order of triangle handles. Annealing is fastest if triangles close on the surface have close handles. Last comes a
// round of windows of twenty triangles (window_rounds.hpp).
//
// On the Stanford bunny 100 tries a triangle give 1.12 indices per triangle in about half a second, 1,000 give 1.11;
// the lower bound is 1.06.
#pragma once

#include <cstdint>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/numbered_mesh.hpp"

namespace restrip {

struct AnnealOptions {
  std::uint64_t moves = 0;   ///< changes to be tried in a round, some 80 ns each; 0: 100 for each triangle
  std::uint32_t rounds = 1;  ///< each from hot to cold; the cheapest final colouring is kept
  std::uint64_t seed = 1;    ///< different seeds give different colourings, about as good
  std::uint32_t heat = 100;  ///< first temperature: about 100 forgets the initial colours, 20 improves them, and
                             ///< 0 accepts no change that increases the cost
};

/// Lowers the cost of a valid colouring. The cost is as in cost.hpp, with one addition: if swaps have a weight, a strip
/// that begins with the wrong turn from both ends counts as one more swap, as in a written index buffer. So with
/// Cost::indices() the cost is the length of strip_indices() minus (T - 1).
///
/// The mesh keeps its colours unless others cost less. Returns the final cost. The result depends only on the mesh, its
/// colours and the arguments, and is the same on every machine. Time for n triangles: O(log n) for each change tried,
/// and O(n) for the windows, some 20 microseconds each. Memory while it runs: 15 bytes a triangle, or 29 if strips get
/// longer than 500. May throw std::bad_alloc; nothing has changed then, unless the mesh is watched.
template <NumberedMesh Mesh>
std::uint64_t anneal(Mesh& mesh, Cost cost, const AnnealOptions& options = {});

}  // namespace restrip

#include "restrip/search/impl/annealing.hpp"
#include "restrip/search/window_rounds.hpp"

namespace restrip {

template <NumberedMesh Mesh>
std::uint64_t anneal(Mesh& mesh, Cost cost, const AnnealOptions& options) {
  auto&& sides = by_sides(mesh);
  detail::Annealing annealing(detail::ColoringCopy(sides), cost, options.seed);
  annealing.keep();
  for (std::uint32_t round = 0; round < options.rounds && annealing.least() != 0; ++round) {
    annealing.cool(options.moves != 0 ? options.moves : annealing.triangle_count() * std::uint64_t{100}, options.heat);
    annealing.keep();
  }
  annealing.go_back();
  WindowRounds windows(cost, options.seed);
  windows.run(annealing.colors(), WindowRounds::round_budget(annealing.triangle_count()), {.triangles = 20});
  annealing.keep();
  annealing.go_back();
  annealing.give(sides);
  return annealing.least();
}

}  // namespace restrip
