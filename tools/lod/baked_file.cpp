#include "lod/baked_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formats/baked_format.hpp"
#include "lod/pm_file.hpp"
#include "meshes/gltf_file.hpp"
#include "meshes/little_endian.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using baked_format::canonical;

void put_number(std::string& bytes, std::uint64_t value) {
  for (; value >= 128; value >>= 7) bytes.push_back(static_cast<char>((value & 127U) | 128U));
  bytes.push_back(static_cast<char>(value));
}

/// Writes ascending numbers, each as its difference from the smallest possible value.
void put_ascending(std::string& bytes, const std::vector<std::uint64_t>& numbers) {
  std::uint64_t least = 0;
  for (const std::uint64_t n : numbers) {
    put_number(bytes, n - least);
    least = n + 1;
  }
}

std::span<const Point> points_of_base(const ProgressiveMesh& mesh) {
  return std::span(mesh.points).first(mesh.points.size() - mesh.splits.size());
}

std::vector<Corners> in_order(std::span<const Corners> triangles) {
  std::vector<Corners> made;
  made.reserve(triangles.size());
  for (const Corners& t : triangles) made.push_back(rotated(t));
  std::sort(made.begin(), made.end());
  return made;
}

}  // namespace

BakedMesh parse_baked(std::string_view bytes, const std::string& name) {
  BakedFile file;
  const std::string fault = restrip::read_baked(std::as_bytes(std::span(bytes.data(), bytes.size())), file);
  if (!bytes.starts_with(baked_format::magic))
    throw BadInput(fmt::format("{}: {}; make one by restrip bake", name, fault));
  if (!fault.empty()) throw BadInput(fmt::format("{}: {}; bake it again (restrip bake)", name, fault));
  BakedMesh baked;
  for (const auto& [x, y, z] : file.points) baked.mesh.points.push_back({x, y, z});
  baked.mesh.base = std::move(file.base);
  for (const auto& [v_s, v_t, v_l, v_r] : file.splits) baked.mesh.splits.push_back({v_s, v_t, v_l, v_r});
  baked.base = std::move(file.mesh);
  baked.records = std::move(file.records);
  baked.payload = std::move(file.payload);
  return baked;
}

std::string baked_bytes(const BakedMesh& baked) {
  const ProgressiveMesh mesh = numbered_by_appearance(baked.mesh);
  const std::size_t base_points = mesh.points.size() - mesh.splits.size();
  const bool has_payload = baked.payload.bytes != 0;
  std::string bytes(baked_format::magic);
  put(bytes, has_payload ? baked_format::version_with_payload : baked_format::version);
  put(bytes, static_cast<std::uint32_t>(base_points));
  put(bytes, static_cast<std::uint32_t>(mesh.base.size()));
  put(bytes, static_cast<std::uint32_t>(mesh.splits.size()));
  if (has_payload) put(bytes, static_cast<std::uint32_t>(baked.payload.bytes));
  for (std::size_t v = 0; v < base_points; ++v) put(bytes, mesh.points[v]);
  for (const Corners& triangle : mesh.base)
    for (const Vertex v : triangle) put(bytes, v);
  for (Triangle t = 0; t < mesh.base.size(); ++t) bytes.push_back(static_cast<char>(baked.base.solid_sides(t)));

  StripMesh now = StripMesh::build(mesh.base, mesh.points.size());
  DualOrder order;
  std::vector<Vertex> neighbors;
  std::vector<std::uint32_t> wanted;
  std::vector<std::uint32_t> met;
  std::vector<std::uint64_t> near;
  std::vector<std::uint64_t> far;
  for (std::size_t i = 0; i < mesh.splits.size(); ++i) {
    const Record& record = mesh.splits[i];
    put(bytes, mesh.points[record.v_t]);
    put_number(bytes, record.v_s);
    baked_format::neighbors_of(now, record.v_s, neighbors);
    const auto place = [&neighbors](Vertex v) -> std::uint64_t {
      if (v == none) return 0;
      const auto at = std::lower_bound(neighbors.begin(), neighbors.end(), v);
      return static_cast<std::uint64_t>(at - neighbors.begin()) + 1;
    };
    put_number(bytes, place(record.v_l) * (neighbors.size() + 1) + place(record.v_r));

    // The flips: those that the order from the new edge reaches soon, by their places in it, then all others.
    const Halfedge chord = now.insert_vertex(spokes_of(now, record), record.v_t);
    wanted.clear();
    for (const Halfedge h : baked.records[i]) wanted.push_back(canonical(now, h).id);
    std::sort(wanted.begin(), wanted.end());
    met.clear();
    near.clear();
    far.clear();
    order.start(now, chord);
    for (std::size_t n = 0; n < baked_format::near_edges && near.size() < wanted.size(); ++n) {
      const Halfedge h = order.edge(n);
      if (h.id == none) break;
      if (std::binary_search(wanted.begin(), wanted.end(), canonical(now, h).id)) {
        near.push_back(n);
        met.push_back(canonical(now, h).id);
      }
    }
    std::sort(met.begin(), met.end());
    for (const std::uint32_t id : wanted)
      if (!std::binary_search(met.begin(), met.end(), id)) far.push_back(std::uint64_t{id >> 2} * 3 + (id & 3U));
    put_number(bytes, near.size() * 2 + (far.empty() ? 0 : 1));
    put_ascending(bytes, near);
    if (far.empty()) continue;
    put_number(bytes, far.size());
    put_ascending(bytes, far);
  }
  for (const std::byte b : baked.payload.all) bytes.push_back(std::to_integer<char>(b));
  const std::uint64_t hash = fnv1a(bytes);
  put(bytes, static_cast<std::uint32_t>(hash));
  put(bytes, static_cast<std::uint32_t>(hash >> 32));
  return bytes;
}

WrittenStrips baked_glb_bytes(std::string_view baked, const StripOptions& options) {
  // The mesh as a reader of the bytes sees it, so that bake and convert write the same file.
  const BakedMesh mesh = parse_baked(baked, "the baked mesh");
  WrittenStrips written;
  const IndexBuffer buffer = format_as(options, StripForm::stitched, strip_indices(mesh.base), written);
  written.bytes = glb_bytes({points_of_base(mesh.mesh), buffer, {}}, {baked_strips_extension, baked});
  if (restarts(buffer)) written.required_extensions = {std::string(restart_extension)};
  return written;
}

std::optional<BakedBytes> parse_baked_gltf(std::string_view bytes, const std::string& name,
                                           const ReadSibling& sibling) {
  // If the name does not occur, the file has no extension and need not be parsed.
  if (bytes.find(baked_strips_extension) == std::string_view::npos) return std::nullopt;
  GltfFile file(bytes, name, sibling);
  std::optional<JsonValue> only;
  const JsonValue meshes = file.root()["meshes"];
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const JsonValue extension = meshes.at(i)["extensions"][baked_strips_extension];
    if (!extension.there()) continue;
    if (only) extension.refuse("is the second one; a file has one baked mesh");
    only = extension;
  }
  if (!only) return std::nullopt;
  BakedBytes found{std::string(file.view((*only)["bufferView"].whole())), {}, {}};
  found.baked = parse_baked(found.bytes, fmt::format("{}: the {} in it", name, baked_strips_extension));
  Soup drawn = read_gltf(bytes, name, sibling);
  const ProgressiveMesh& mesh = found.baked.mesh;
  const auto base = points_of_base(mesh);
  if (!std::equal(drawn.points.begin(), drawn.points.end(), base.begin(), base.end()) ||
      in_order(drawn.triangles) != in_order(mesh.base))
    throw BadInput(fmt::format(
        "{}: draws something other than the base of its {}, so the levels do not fit; remove the extension, "
        "or write the file again (restrip bake)",
        name, baked_strips_extension));
  found.left_out = std::move(drawn.left_out);
  return found;
}

}  // namespace restrip::tools
