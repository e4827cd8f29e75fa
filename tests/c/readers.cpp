// Everything that takes a const mesh may be called for one mesh by several threads at once: each gets what a single
// reader gets, and ThreadSanitizer, with which this program and the library are compiled, reports no race.
#include <restrip.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace {

void check(bool right, const char* what) {
  if (right) return;
  std::fprintf(stderr, "wrong: %s\n", what);
  std::exit(1);
}

template <class Number>
void append(std::string& out, const Number* numbers, std::size_t count) {
  if (count != 0) out.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
}

/// What all reading functions return.
std::string everything(const restrip_mesh* mesh) {
  std::string out;
  const auto number = [&out](auto value) { append(out, &value, 1); };
  const std::size_t triangles = restrip_mesh_triangle_count(mesh);
  std::size_t strips = 0;
  number(restrip_mesh_strip_count(mesh, &strips));
  number(strips);
  std::vector<std::uint32_t> corners(3 * triangles + 1);
  number(restrip_mesh_triangles(mesh, corners.data(), corners.size()));
  append(out, corners.data(), corners.size());
  std::vector<std::uint32_t> order(triangles + 1);
  std::vector<std::size_t> starts(strips + 1);
  number(restrip_mesh_strips(mesh, order.data(), order.size(), starts.data(), starts.size()));
  append(out, order.data(), triangles);
  std::vector<std::uint8_t> colors(restrip_mesh_triangle_bound(mesh));
  number(restrip_mesh_get_colors(mesh, colors.data(), colors.size()));
  append(out, colors.data(), colors.size());
  restrip_coloring coloring{};
  number(restrip_mesh_check(mesh, &coloring));
  number(coloring.strips);
  for (std::uint32_t v = 0; v < restrip_mesh_vertex_bound(mesh); v += 7) {
    const restrip_halfedge h = restrip_mesh_spoke(mesh, v);
    const restrip_halfedge next = restrip_mesh_next(mesh, h);
    for (const std::uint32_t each :
         {h, next, restrip_mesh_opposite(mesh, h), restrip_mesh_to(mesh, next), restrip_mesh_from(mesh, next),
          restrip_mesh_triangle(mesh, next), restrip_mesh_find(mesh, v, restrip_mesh_to(mesh, h))})
      number(each);
    number(restrip_mesh_solid(mesh, next));
    number(restrip_mesh_check_split(mesh, h, next, RESTRIP_NONE));
    for (std::int32_t operation = RESTRIP_COLLAPSE; operation <= RESTRIP_MERGE; ++operation) {
      restrip_status status = RESTRIP_OK;
      number(restrip_mesh_check_each(mesh, operation, 1, &next, &status));
      number(status);
    }
  }
  restrip_buffer_view view{};
  std::size_t room = 0;
  number(restrip_live_buffer(mesh, &view, &room));
  append(out, static_cast<const std::uint8_t*>(view.indices),
         view.index_count * static_cast<std::size_t>(view.index_bits) / 8);
  append(out, view.draws, view.draw_count);
  number(room);
  std::size_t undoable = 0;
  std::size_t redoable = 0;
  number(restrip_live_history_size(mesh, &undoable, &redoable));
  number(restrip_live_frame(mesh) + undoable + redoable);
  number(restrip_mesh_policy(mesh));
  restrip_buffer* buffer = nullptr;
  const restrip_cache cache{16, 0};
  number(restrip_mesh_buffer(mesh, &cache, nullptr, &buffer));
  check(restrip_buffer_read(buffer, &view) == RESTRIP_OK, "restrip_buffer_read");
  append(out, static_cast<const std::uint8_t*>(view.indices),
         view.index_count * static_cast<std::size_t>(view.index_bits) / 8);
  restrip_buffer_free(buffer);
  restrip_mesh* copy = nullptr;
  number(restrip_mesh_copy(mesh, &copy));
  number(restrip_mesh_triangle_count(copy));
  restrip_mesh_free(copy);
  return out;
}

}  // namespace

int main() {
  constexpr std::uint32_t n = 30;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      for (const std::uint32_t v : {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1}) indices.push_back(v);
    }
  for (const std::int32_t form : {RESTRIP_FORM_RESTART, RESTRIP_FORM_LENGTHS, RESTRIP_FORM_LIST}) {
    restrip_mesh* mesh = nullptr;
    check(restrip_mesh_build_u32(indices.data(), indices.size(), (n + 1) * (n + 1), nullptr, nullptr, &mesh) ==
              RESTRIP_OK,
          "restrip_mesh_build_u32");
    const restrip_format format{form, 0, 0, 0, 1};
    const restrip_range* ranges = nullptr;
    std::size_t count = 0;
    check(restrip_live_begin(mesh, &format, nullptr, 1000) == RESTRIP_OK, "restrip_live_begin");
    check(restrip_live_update(mesh, 2, 4, &ranges, &count, nullptr) == RESTRIP_OK, "restrip_live_update");
    // Not updated since: a reader must not catch up.
    check(restrip_mesh_collapse(mesh, restrip_mesh_find(mesh, 100, 101), nullptr) == RESTRIP_OK, "collapse");
    std::vector<std::string> found(4);
    std::vector<std::thread> readers;
    readers.reserve(found.size());
    for (std::string& out : found)
      readers.emplace_back([&out, mesh] {
        for (int round = 0; round < 10; ++round) out = everything(mesh);
      });
    for (std::thread& reader : readers) reader.join();
    const std::string alone = everything(mesh);
    for (const std::string& each : found) check(each == alone, "a reader among others found something else");
    restrip_mesh_free(mesh);
  }
  std::puts("readers of one mesh: as one reader");
  return 0;
}
