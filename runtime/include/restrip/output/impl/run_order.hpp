// The order of runs for a cache of transformed vertices. Knows neither places nor meshes.
//
// From scratch, greedy: the next run is the one with the fewest misses for each triangle, counted by simulating the
// cache over the whole run, among the runs that have a cached vertex. If no run has one, it is a run at the vertex
// that was missed last among the vertices with runs. Linear time: for each run drawn, at most 64 runs of bounded length
// are tried.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/output/impl/cells.hpp"
#include "restrip/output/impl/drawing_cache.hpp"
#include "restrip/output/impl/run_places.hpp"
#include "restrip/precondition.hpp"

namespace restrip::detail {

/// Numbers of runs, in an order for a cache of `cache` vertices, first in, first out. `cells` has the indices of the
/// runs, each with a separator at its end.
RESTRIP_COLD inline std::vector<std::uint32_t> order_of_runs(const Cells& cells, const std::vector<Run>& runs,
                                                             std::uint32_t cache) {
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  constexpr unsigned most_tried = 64;
  std::vector<std::uint32_t> vertices;  // of all runs
  std::vector<std::uint32_t> ends;      // of each run, there
  vertices.reserve(cells.size());
  ends.reserve(runs.size());
  for (const Run& run : runs) {
    for (std::uint32_t i = run.first; i + 1 < run.end(); ++i) vertices.push_back(cells[i]);
    ends.push_back(static_cast<std::uint32_t>(vertices.size()));
  }
  const auto vertices_of = [&](std::uint32_t r) {
    const std::uint32_t* const begin = vertices.data() + (r == 0 ? 0 : ends[r - 1]);
    return std::span(begin, vertices.data() + ends[r]);
  };
  DrawingCache drawing(cache, vertices, ends);

  struct Trial {
    std::uint32_t run = none;
    std::uint64_t misses = 0;
    std::uint64_t triangles = 1;
  };
  std::vector<std::uint32_t> order;
  order.reserve(runs.size());
  for (std::uint32_t first = 0; order.size() < runs.size();) {
    Trial best;
    drawing.for_each_near(most_tried, 8 * most_tried, [&](std::uint32_t r) {
      const std::uint32_t before = drawing.try_from_here();
      std::uint32_t misses = before;
      for (const std::uint32_t v : vertices_of(r)) drawing.try_look_up(v, misses);
      const Trial here{r, misses - before, runs[r].triangles};
      if (best.run == none || here.misses * best.triangles < best.misses * here.triangles) best = here;
      return 1U;
    });
    if (best.run == none)
      drawing.for_each_left_behind([&](std::uint32_t r) {
        best.run = r;
        return false;
      });
    if (best.run == none) {
      while (drawing.is_drawn(first)) ++first;
      best.run = first;
    }
    order.push_back(best.run);
    drawing.draw(best.run);
    for (const std::uint32_t v : vertices_of(best.run)) drawing.look_up(v);
  }
  return order;
}

}  // namespace restrip::detail
