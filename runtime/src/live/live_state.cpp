// Saved meshes and packed numbers.
//
// Outline. A file has the corners and solid sides of each triangle in the order of their numbers, and a bit for each
// number that says whether it is one of a triangle. Loading hands the triangles to StripMesh::build, so a loaded mesh
// is one that building makes, whatever the bytes are; colours the mesh, and spreads the triangles over their numbers.
// Free numbers are used again from the lowest on.
//
// The reader trusts nothing: every number is compared with its range before it is used. A bit of the file stands for 24
// bytes of the mesh, and nothing else grows faster with the file, so memory is linear in the bytes, and so is time.
#include "live/live_state.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "formats/baked_format.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/precondition.hpp"
#include "restrip/search/policy.hpp"

namespace restrip::detail {

namespace {

constexpr std::string_view magic = "RestripL";
constexpr std::uint32_t version = 2;
constexpr std::size_t checksum_bytes = 8;
constexpr std::size_t triangle_bytes = 13;

constexpr const char* truncated = "restrip: the saved LiveMesh is truncated";

void expect(bool holds, [[maybe_unused]] const char* sentence) {
  if (!holds) RESTRIP_THROW(std::invalid_argument, sentence);
}

/// Appends numbers, the lowest byte first.
struct Writer {
  template <class Number>
  void put(Number number) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bytes.push_back(static_cast<std::byte>(std::uint64_t{number} >> 8 * i & 0xFFU));
  }
  void put_bits(const std::vector<bool>& bits) {
    for (std::size_t i = 0; i < bits.size(); i += 8) {
      unsigned byte = 0;
      for (std::size_t bit = 0; bit < 8 && i + bit < bits.size(); ++bit) byte |= unsigned{bits[i + bit]} << bit;
      put(static_cast<std::uint8_t>(byte));
    }
  }
  std::vector<std::byte> bytes;
};

struct Reader {
  template <class Number>
  Number get() {
    expect(left.size() >= sizeof(Number), truncated);
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) number |= std::to_integer<std::uint64_t>(left[i]) << 8 * i;
    left = left.subspan(sizeof(Number));
    return static_cast<Number>(number);
  }
  std::vector<bool> get_bits(std::size_t count) {
    expect(count / 8 <= left.size(), truncated);
    std::vector<bool> bits(count);
    for (std::size_t i = 0; i < count; i += 8) {
      const auto byte = get<std::uint8_t>();
      for (std::size_t bit = 0; bit < 8; ++bit)
        if ((unsigned{byte} >> bit & 1U) != 0) {
          expect(i + bit < count, "restrip: the saved LiveMesh marks numbers beyond its last one");
          bits[i + bit] = true;
        }
    }
    return bits;
  }
  std::span<const std::byte> left;
};

/// Checks what does not depend on the contents. Returns the rest, without the checksum.
Reader opened(std::span<const std::byte> bytes) {
  for (std::size_t i = 0; i < (std::min)(magic.size(), bytes.size()); ++i)
    expect(bytes[i] == static_cast<std::byte>(magic[i]), "restrip: these bytes are not a saved LiveMesh");
  expect(bytes.size() >= magic.size() + sizeof(version) + checksum_bytes, truncated);
  Reader in{bytes.subspan(magic.size())};
  const auto found = in.get<std::uint32_t>();
  expect(found >= version, "restrip: an older library saved this LiveMesh, in a format that is no longer read");
  expect(found == version, "restrip: the saved LiveMesh has a version that this library cannot read");
  Reader sum{bytes.last(checksum_bytes)};
  expect(sum.get<std::uint64_t>() == baked_format::fnv1a(bytes.first(bytes.size() - checksum_bytes)),
         "restrip: the saved LiveMesh is truncated or altered: its checksum is wrong");
  in.left = in.left.first(in.left.size() - checksum_bytes);
  return in;
}

LiveOptions read_options(Reader& in) {
  LiveOptions options;
  options.policy = static_cast<Policy>(in.get<std::uint8_t>());
  expect(
      std::any_of(policies.begin(), policies.end(), [&](const PolicyRow& row) { return row.policy == options.policy; }),
      "restrip: the saved LiveMesh has a policy that this library does not know");
  for (std::uint16_t* const weight : {&options.cost.restart, &options.cost.swap, &options.cost.isolated})
    *weight = in.get<std::uint16_t>();
  options.format.form = static_cast<StripForm>(in.get<std::uint8_t>());
  options.format.width = static_cast<IndexWidth>(in.get<std::uint8_t>());
  expect(options.format.form <= StripForm::list && options.format.width <= IndexWidth::bits32,
         "restrip: the saved LiveMesh has a buffer of a form that this library does not know");
  for (unsigned* const number : {&options.layout.cache, &options.layout.waste, &options.layout.work})
    *number = in.get<std::uint32_t>();
  expect(options.layout.in_range(), "restrip: the layout options of the saved LiveMesh are out of range");
  return options;
}

}  // namespace

std::vector<std::byte> LiveState::write(const StripMesh& mesh, const LiveOptions& options) {
  Writer out;
  out.bytes.reserve(64 + mesh.triangle_bound() / 8 + mesh.vertex_bound() / 8 + triangle_bytes * mesh.triangle_count());
  for (const char c : magic) out.put(static_cast<std::uint8_t>(c));
  out.put(version);
  out.put(static_cast<std::uint8_t>(options.policy));
  for (const std::uint16_t weight : {options.cost.restart, options.cost.swap, options.cost.isolated}) out.put(weight);
  out.put(static_cast<std::uint8_t>(options.format.form));
  out.put(static_cast<std::uint8_t>(options.format.width));
  for (const unsigned number : {options.layout.cache, options.layout.waste, options.layout.work})
    out.put(std::uint32_t{number});
  out.put(static_cast<std::uint32_t>(mesh.triangle_bound()));
  out.put(static_cast<std::uint32_t>(mesh.vertex_bound()));
  std::vector<bool> alive(mesh.triangle_bound());
  for (Triangle t = 0; t < alive.size(); ++t) alive[t] = mesh.alive(t);
  out.put_bits(alive);
  std::vector<bool> free(mesh.vertex_bound());
  for (const Vertex v : mesh.free_vertices_) free[v] = mesh.spoke_[v] == none;
  out.put_bits(free);
  for (Triangle t = 0; t < alive.size(); ++t) {
    if (!alive[t]) continue;
    for (const Vertex v : mesh.corners(t)) out.put(v);
    out.put(static_cast<std::uint8_t>(mesh.solid_sides(t)));
  }
  out.put(baked_format::fnv1a(std::span<const std::byte>(out.bytes)));
  return std::move(out.bytes);
}

LiveState::Saved LiveState::read(std::span<const std::byte> bytes) {
  Reader in = opened(bytes);
  Saved saved{{}, read_options(in)};
  const auto triangle_bound = in.get<std::uint32_t>();
  const auto vertex_bound = in.get<std::uint32_t>();
  expect(triangle_bound <= StripMesh::max_triangles, "restrip: the saved LiveMesh has too many triangles");
  const std::vector<bool> alive = in.get_bits(triangle_bound);
  const std::vector<bool> free = in.get_bits(vertex_bound);
  std::vector<Triangle> numbers;
  for (Triangle t = 0; t < triangle_bound; ++t)
    if (alive[t]) numbers.push_back(t);
  expect(in.left.size() / triangle_bytes >= numbers.size(), truncated);
  std::vector<std::array<Vertex, 3>> triangles(numbers.size());
  std::vector<std::uint8_t> solid_sides(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (Vertex& v : triangles[i]) {
      v = in.get<std::uint32_t>();
      expect(v < vertex_bound, "restrip: a triangle of the saved LiveMesh has a vertex that is out of range");
      expect(!free[v], "restrip: a vertex of the saved LiveMesh is both free and in use");
    }
    solid_sides[i] = in.get<std::uint8_t>();
  }
  expect(in.left.empty(), "restrip: the saved LiveMesh is too long");

  StripMesh& mesh = saved.mesh;
  mesh = StripMesh::build(triangles, vertex_bound);
  expect(mesh.triangle_count() == numbers.size(), "restrip: a triangle of the saved LiveMesh has a corner twice");
  for (Triangle t = 0; t < solid_sides.size(); ++t)
    for (unsigned side = 0; side < 8; ++side) {
      if ((unsigned{solid_sides[t]} >> side & 1U) == 0) continue;
      expect(side < 3, "restrip: a triangle of the saved LiveMesh has a colour for more than three sides");
      const StripMesh::Halfedge back = mesh.opposite(StripMesh::halfedge(t, side));
      expect(!StripMesh::on_boundary(back), "restrip: the saved LiveMesh has a solid side on the boundary");
      expect((unsigned{solid_sides[StripMesh::triangle(back)]} >> StripMesh::side(back) & 1U) != 0,
             "restrip: an edge of the saved LiveMesh has different colours in its two triangles");
    }
  mesh.set_colors(solid_sides);
  expect(check_coloring(mesh).valid, "restrip: the colours of the saved LiveMesh have a branch or a cycle");
  if (numbers.size() != triangle_bound) renumber(mesh, numbers, triangle_bound, {}, vertex_bound);
  for (Vertex v = vertex_bound; v-- > 0;)
    if (free[v]) mesh.free_vertices_.push_back(v);
  return saved;
}

// Triangle t becomes triangles[t], vertex v becomes vertices[v], or `none` if it goes; without `vertices` they stay.
void LiveState::renumber(StripMesh& mesh, std::span<const Triangle> triangles, std::size_t triangle_bound,
                         std::span<const Vertex> vertices, std::size_t vertex_bound) {
  constexpr StripMesh::Record removed{{none, none, none},
                                      {StripMesh::edge_of_mesh, StripMesh::edge_of_mesh, StripMesh::edge_of_mesh}};
  const auto new_vertex = [vertices](Vertex v) { return vertices.empty() ? v : vertices[v]; };
  std::vector<StripMesh::Record> records(triangle_bound, removed);
  for (Triangle t = 0; t < mesh.triangles_.size(); ++t) {
    if (!mesh.alive(t)) continue;
    StripMesh::Record& record = records[triangles[t]] = mesh.triangles_[t];
    for (Vertex& v : record.corner) v = new_vertex(v);
    for (std::uint32_t& link : record.link)  // 8 t + 2 side + solid
      if (link != StripMesh::edge_of_mesh) link = triangles[link >> 3] << 3 | (link & 7U);
  }
  std::vector<std::uint32_t> spokes(vertex_bound, none);
  std::vector<std::uint8_t> non_manifold(vertex_bound, 0);
  for (Vertex v = 0; v < mesh.spoke_.size(); ++v) {
    if (mesh.spoke_[v] == none) continue;
    const StripMesh::Halfedge h{mesh.spoke_[v]};
    spokes[new_vertex(v)] = StripMesh::halfedge(triangles[StripMesh::triangle(h)], StripMesh::side(h)).id;
    non_manifold[new_vertex(v)] = mesh.non_manifold_[v];
  }
  std::vector<Triangle> free;
  for (auto t = static_cast<Triangle>(triangle_bound); t-- > 0;)
    if (records[t].corner[0] == none) free.push_back(t);
  mesh.triangles_ = std::move(records);
  mesh.free_ = std::move(free);
  mesh.spoke_ = std::move(spokes);
  mesh.non_manifold_ = std::move(non_manifold);
}

Renumbering LiveState::pack(StripMesh& mesh) {
  Renumbering numbers{std::vector<Triangle>(mesh.triangle_bound(), none),
                      std::vector<Vertex>(mesh.vertex_bound(), none)};
  Triangle triangles = 0;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) numbers.triangles[t] = triangles++;
  Vertex vertices = 0;
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v)
    if (mesh.spoke_[v] != none) numbers.vertices[v] = vertices++;
  renumber(mesh, numbers.triangles, triangles, numbers.vertices, vertices);
  mesh.free_vertices_ = {};
  return numbers;
}

}  // namespace restrip::detail
