// Cheap colourings from scratch by simulated annealing.
//
// Method. A random change of a few dual edges is accepted when it costs no more, and now and then when it does; how
// often falls with a temperature (Kirkpatrick, Gelatt, Vecchi, "Optimization by simulated annealing", 1983). A change
// takes one solid edge out, or makes a dashed one solid and takes out one at each end that has two: its price is known
// from six triangles. A walk from both ends of the strip keeps cycles out; where strips are too long to be walked,
// trees that know which triangles are of one strip. Changes are tried only where something is wrong, at strip ends and
// swaps, in the order of triangle handles: these are a few of a hundred triangles in the end. Meshes whose handles lie
// in memory as their triangles lie on the surface are annealed fastest. Last comes a round of windows of twenty
// triangles (window_rounds.hpp).
//
// On the Stanford bunny 100 tries a triangle give 1.12 indices per triangle in about half a second, 1,000 give 1.11;
// nothing can have fewer than 1.06.
#pragma once

#include <cstdint>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/numbered_mesh.hpp"

namespace restrip {

struct AnnealOptions {
  std::uint64_t moves = 0;   ///< changes to be tried in a round, some 80 ns each; 0: 100 for each triangle
  std::uint32_t rounds = 1;  ///< each from hot to cold; the cheapest colouring that one ends with counts
  std::uint64_t seed = 1;    ///< other seeds, other colourings, about as good
  std::uint32_t heat = 100;  ///< first temperature: about 100 forgets the colours it begins with, 20 improves them, and
                             ///< with 0 no change is made that costs something
};

/// Lowers the cost of a valid colouring. The cost is as in cost.hpp, with one addition: where swaps have a weight, a
/// strip that begins with the wrong turn from both ends counts as one more swap, as in a written index buffer. So with
/// Cost::indices() it is the length of strip_indices() less T - 1.
///
/// The mesh keeps the colours it has unless others cost less. Returns the cost of the colours that it has afterwards.
/// They depend on the mesh, its colours and the arguments alone, and are the same on every machine. Time: O(log n) for
/// each change tried, for n triangles, and O(n) for the windows, of which one takes some 20 microseconds. Memory while
/// it runs: 15 bytes a triangle, 29 where strips get longer than 500. May throw std::bad_alloc; nothing has changed
/// then, unless the mesh is watched.
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
