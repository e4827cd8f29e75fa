// Saved LiveMeshes: damaged bytes are refused, or they load as a mesh whose adjacency, colours and buffer agree, that
// can be edited, and that saves to bytes which load as the same mesh. Checksums are made to match, so that alterations
// reach the reader.
#include <cstring>
#include <optional>
#include <stdexcept>
#include <vector>

#include "formats/baked_format.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/policy.hpp"
#include "runtime/form_reader.hpp"
#include "target.hpp"

namespace restrip::fuzz {
namespace {

using Halfedge = LiveMesh::Halfedge;

std::vector<std::byte> sealed(std::string_view text) {
  std::vector<std::byte> bytes(text.size());
  if (!text.empty()) std::memcpy(bytes.data(), text.data(), text.size());
  if (bytes.size() < 8) return bytes;
  const std::span<const std::byte> above = std::span(bytes).first(bytes.size() - 8);
  const std::uint64_t sum = baked_format::fnv1a(above);
  for (std::size_t i = 0; i < 8; ++i) bytes[above.size() + i] = static_cast<std::byte>(sum >> 8 * i & 0xFF);
  return bytes;
}

/// Adjacency by its definition, colours, and what is drawn.
void promise_valid(const LiveMesh& live) {
  const StripMesh& mesh = live.mesh();
  std::vector<std::size_t> corners(mesh.vertex_bound(), 0);
  std::size_t triangles = 0;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    ++triangles;
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      promise(mesh.from(h) < mesh.vertex_bound() && mesh.from(h) != mesh.to(h), "corners are vertices");
      promise(mesh.opposite(mesh.opposite(h)) == h && mesh.from(mesh.opposite(h)) == mesh.to(h), "links lead back");
      ++corners[mesh.from(h)];
    }
  }
  promise(triangles == mesh.triangle_count(), "triangles are counted");
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v) {
    promise((mesh.spoke(v).id == none) == (corners[v] == 0), "vertices of triangles have spokes");
    if (corners[v] == 0 || mesh.non_manifold(v)) continue;
    std::size_t met = 0;
    for_each_spoke(mesh, v, [&](Halfedge h) { met += StripMesh::on_boundary(h) ? 0U : 1U; });
    promise(met == corners[v], "fans are whole");
  }
  promise(check_coloring(mesh).valid, "colours are valid");
  std::vector<IndexRange> draws;
  live.buffer().draws(draws);
  form_reader::Reader reader(live.bytes(), live.index_bytes());
  const StripForm form = live.buffer().format().form;
  for (const auto& [first, count] : draws)
    form == StripForm::list ? reader.list(first, count) : reader.strip(first, count, form == StripForm::restart);
  promise(std::move(reader).triangles() == sample::triangles_of(mesh), "the buffer draws the mesh");
}

void edit(LiveMesh& live) {
  const auto bound = static_cast<Triangle>(live.mesh().triangle_bound());
  for (Triangle t = 0; t < bound && t < 40; ++t) {
    const Halfedge h = StripMesh::halfedge(t * 7 % bound, t % 3);
    live.flip(h);
    live.collapse(h);
    live.split({h, StripMesh::halfedge(t * 5 % bound, t % 2)});
    live.bisect(h);
    live.split_face(h);
    if (t % 8 == 0) live.update();
  }
  live.improve(500);
  live.update();
  promise_valid(live);
}

/// Every saved mesh loads, with the same triangles, neighbours and colours.
void promise_saved(const LiveMesh& live) {
  const LiveMesh copy = LiveMesh::load(live.save());
  const StripMesh& mesh = live.mesh();
  promise(copy.mesh().triangle_bound() == mesh.triangle_bound() && copy.mesh().vertex_bound() == mesh.vertex_bound(),
          "numbers are those of the saved mesh");
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    promise(copy.mesh().corners(t) == mesh.corners(t), "corners are those of the saved mesh");
    for (unsigned side = 0; mesh.alive(t) && side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      promise(copy.mesh().opposite(h) == mesh.opposite(h) && copy.mesh().solid(h) == mesh.solid(h),
              "neighbours and colours are those of the saved mesh");
    }
  }
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v)
    promise(copy.mesh().non_manifold(v) == mesh.non_manifold(v), "marks are those of the saved mesh");
  promise(copy.strips() == live.strips() && copy.save() == live.save(), "what is loaded saves to the same bytes");
}

bool read_saved(std::string_view text) {
  std::optional<LiveMesh> live;
  try {
    live.emplace(LiveMesh::load(sealed(text), 100));
  } catch (const std::invalid_argument&) {
    return false;
  } catch (const std::length_error&) {  // 16 bits are not enough
    return false;
  }
  promise_valid(*live);
  promise(live->mesh().triangle_bound() <= 8 * text.size(), "memory is bounded by the file");
  promise_saved(*live);
  try {
    edit(*live);
  } catch (const std::length_error&) {  // 16 bits are not enough
  }
  promise_saved(*live);
  return true;
}

std::string saved_mesh(const LiveOptions& options, std::uint32_t width) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t v = 0; v < width * (width + 1); ++v)
    if (v % (width + 1) != width)
      triangles.insert(triangles.end(), {v, v + 1, v + width + 2, v, v + width + 2, v + width + 1});
  LiveMesh live(triangles, (width + 1) * (width + 1), options);
  for (Triangle t = 0; t < 2 * width; t += 3) live.collapse(StripMesh::halfedge(t * 5 % (2 * width), t % 3));
  live.update();
  for (Triangle t = 0; t < width; ++t) live.bisect(StripMesh::halfedge(t, 1));
  const std::vector<std::byte> bytes = live.save();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::vector<Target> saved_targets() {
  std::vector<std::string> seeds;
  for (const StripForm form : {StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list})
    for (const IndexWidth bits : {IndexWidth::automatic, IndexWidth::bits32}) {
      const auto n = static_cast<std::uint32_t>(seeds.size());
      const LiveOptions options{.policy = policies[n % policies.size()].policy,
                                .cost = n % 2 == 0 ? Cost::strips() : Cost::indices(),
                                .format = {form, bits}};
      seeds.push_back(saved_mesh(options, n + 1));
    }
  return {{"saved", seeds, read_saved, 6000}};
}

}  // namespace restrip::fuzz
