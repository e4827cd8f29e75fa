#include "lod/baked_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/bad_input.hpp"
#include "lod/pm_file.hpp"
#include "meshes/little_endian.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/formats/baked_format.hpp"

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

}  // namespace restrip::tools
