#include <cstdio>
#include <restrip/live_mesh.hpp>

int main() {
  std::vector<std::uint32_t> triangles;  // a sheet of 40 by 40 squares, as an index buffer
  for (std::uint32_t v = 0; v < 40 * 41; ++v)
    if (v % 41 != 40) triangles.insert(triangles.end(), {v, v + 1, v + 42, v, v + 42, v + 41});
  restrip::LiveMesh live(triangles, 41 * 41, {.history = 10'000});  // strips from scratch; upload live.indices() once
  const auto make_buffer = [](std::size_t /*indices*/) {};
  make_buffer(live.room());
  const auto end_of_frame = [&] {
    std::size_t written = 0;
    const auto ranges = live.update();
    if (ranges.outgrown) make_buffer(live.room());            // then the only range is everything
    for (const auto& range : ranges) written += range.count;  // upload each range
    std::printf("%zu triangles, strips: %zu, indices written: %zu of %zu\n", live.mesh().triangle_count(),
                live.strips(), written, live.indices().size());
  };
  end_of_frame();
  for (std::uint32_t v = 100; v < 110; ++v) live.collapse(v + 41, v);  // or refused, with a reason
  end_of_frame();
  // Of vertex 600, left 641, right 559: the new vertex gets the triangles counter-clockwise from right to left.
  live.split(600, 641, 559);
  end_of_frame();
  live.undo();  // the split: triangles, numbers and strips are exactly as before
  end_of_frame();
  const auto& rules = live.rule_counts();
  std::printf("%d rules asked: %d taken, %d kept colours as good; then %d improved\n", int(rules.asked),
              int(rules.taken), int(rules.kept), int(rules.improved));
}
