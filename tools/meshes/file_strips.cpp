#include "meshes/file_strips.hpp"

#include <vector>

namespace restrip::tools {
namespace {

/// The side of a triangle across which the other one lies; {none} if they share no dual edge.
StripMesh::Halfedge shared_edge(const StripMesh& mesh, Triangle one, Triangle other) {
  for (unsigned side = 0; side < 3; ++side) {
    const StripMesh::Halfedge h = StripMesh::halfedge(one, side);
    const StripMesh::Halfedge back = mesh.opposite(h);
    if (!StripMesh::on_boundary(back) && StripMesh::triangle(back) == other) return h;
  }
  return {};
}

/// Calls next(soup triangle, whether it begins a strip) for each triangle that the strips draw, in order.
template <class Next>
void for_each_drawn(const Soup& soup, Next&& next) {
  std::size_t triangle = 0;
  const auto to_drawn = [&] {  // degenerate ones are listed but in no strip
    while (triangle < soup.triangles.size() && degenerate(soup.triangles[triangle])) ++triangle;
  };
  std::size_t first = 0;
  bool begins = true;
  std::size_t degenerate_ones = 0;  // in a row: one repeats an index within a strip, more stitch two strips together
  for (std::size_t i = 0; i < soup.strips.size(); ++i) {
    if (soup.strips[i] == strip_end) {
      first = i + 1;
      begins = true;
      degenerate_ones = 0;
    } else if (i >= first + 2 && degenerate({soup.strips[i - 2], soup.strips[i - 1], soup.strips[i]})) {
      ++degenerate_ones;
    } else if (i >= first + 2) {
      to_drawn();
      next(triangle++, begins || degenerate_ones > 1);
      begins = false;
      degenerate_ones = 0;
    }
  }
}

}  // namespace

FileStrips color_as_in_file(StripMesh& mesh, const Soup& soup, std::span<const std::uint32_t> origin) {
  std::vector<Triangle> handle(soup.triangles.size(), none);
  for (std::size_t t = 0; t < origin.size(); ++t) handle[origin[t]] = static_cast<Triangle>(t);
  FileStrips done;
  Triangle before = none;
  for_each_drawn(soup, [&](std::size_t number, bool begins) {
    const Triangle now = handle[number];
    if (!begins) {
      const StripMesh::Halfedge h =
          now == none || before == none ? StripMesh::Halfedge{} : shared_edge(mesh, before, now);
      if (h == StripMesh::Halfedge{}) {
        ++done.cut;
      } else {
        mesh.set_solid(h, true);
        ++done.solid;
      }
    }
    before = now;
  });
  return done;
}

}  // namespace restrip::tools
