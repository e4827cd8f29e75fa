#include "lod/baked_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/bad_input.hpp"
#include "lod/pm_file.hpp"
#include "meshes/little_endian.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/formats/baked_format.hpp"
#include "restrip/formats/dual_order.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using baked_format::canonical;

std::uint8_t colors(const StripMesh& mesh, Triangle t) {
  unsigned bits = 0;
  for (unsigned side = 0; side < 3; ++side) bits |= unsigned{mesh.solid(StripMesh::halfedge(t, side))} << side;
  return static_cast<std::uint8_t>(bits);
}

class Writer {
 public:
  explicit Writer(const BakedMesh& baked)
      : baked_(baked),
        mesh_(numbered_by_appearance(baked.mesh)),
        now_(StripMesh::build(mesh_.base, mesh_.points.size())) {}

  std::string run() {
    const std::size_t base_points = mesh_.points.size() - mesh_.splits.size();
    const bool has_payload = baked_.payload.bytes != 0;
    bytes_ = baked_format::magic;
    put(bytes_, has_payload ? baked_format::version_with_payload : baked_format::version);
    put(bytes_, static_cast<std::uint32_t>(base_points));
    put(bytes_, static_cast<std::uint32_t>(mesh_.base.size()));
    put(bytes_, static_cast<std::uint32_t>(mesh_.splits.size()));
    if (has_payload) put(bytes_, static_cast<std::uint32_t>(baked_.payload.bytes));
    for (std::size_t v = 0; v < base_points; ++v) put(bytes_, mesh_.points[v]);
    for (const Corners& triangle : mesh_.base)
      for (const Vertex v : triangle) put(bytes_, v);
    for (Triangle t = 0; t < mesh_.base.size(); ++t) bytes_.push_back(static_cast<char>(colors(baked_.base, t)));
    for (std::size_t i = 0; i < mesh_.splits.size(); ++i) put_record(i);
    for (const std::byte b : baked_.payload.all) bytes_.push_back(std::to_integer<char>(b));
    const std::uint64_t hash = fnv1a(bytes_);
    put(bytes_, static_cast<std::uint32_t>(hash));
    put(bytes_, static_cast<std::uint32_t>(hash >> 32));
    return std::move(bytes_);
  }

 private:
  void put_number(std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes_.push_back(static_cast<char>((value & 127U) | 128U));
    bytes_.push_back(static_cast<char>(value));
  }
  /// Writes ascending numbers, each as its difference from the smallest possible value.
  void put_ascending(const std::vector<std::uint64_t>& numbers) {
    std::uint64_t least = 0;
    for (const std::uint64_t n : numbers) {
      put_number(n - least);
      least = n + 1;
    }
  }

  void put_record(std::size_t i) {
    const Record& record = mesh_.splits[i];
    put(bytes_, mesh_.points[record.v_t]);
    put_number(record.v_s);
    baked_format::neighbors_of(now_, record.v_s, neighbors_);
    const auto place = [this](Vertex v) -> std::uint64_t {
      if (v == none) return 0;
      return static_cast<std::uint64_t>(std::lower_bound(neighbors_.begin(), neighbors_.end(), v) -
                                        neighbors_.begin()) +
             1;
    };
    put_number(place(record.v_l) * (neighbors_.size() + 1) + place(record.v_r));
    put_flips(now_.insert_vertex(spokes_of(now_, record), record.v_t), baked_.records[i]);
  }

  void put_flips(Halfedge chord, std::span<const Halfedge> flips) {
    wanted_.clear();
    for (const Halfedge h : flips) wanted_.push_back(canonical(now_, h).id);
    std::sort(wanted_.begin(), wanted_.end());
    near_.clear();
    far_.clear();
    order_.start(now_, chord);
    for (std::size_t n = 0; n < baked_format::near_edges && near_.size() < wanted_.size(); ++n) {
      const Halfedge h = order_.edge(n);
      if (h.id == none) break;
      if (std::binary_search(wanted_.begin(), wanted_.end(), canonical(now_, h).id)) {
        near_.push_back(n);
        met_.push_back(canonical(now_, h).id);
      }
    }
    std::sort(met_.begin(), met_.end());
    for (const std::uint32_t id : wanted_)
      if (!std::binary_search(met_.begin(), met_.end(), id)) far_.push_back(std::uint64_t{id >> 2} * 3 + (id & 3U));
    met_.clear();
    put_number(near_.size() * 2 + (far_.empty() ? 0 : 1));
    put_ascending(near_);
    if (far_.empty()) return;
    put_number(far_.size());
    put_ascending(far_);
  }

  const BakedMesh& baked_;
  const ProgressiveMesh mesh_;
  StripMesh now_;
  DualOrder order_;
  std::string bytes_;
  std::vector<Vertex> neighbors_;
  std::vector<std::uint32_t> wanted_;
  std::vector<std::uint32_t> met_;
  std::vector<std::uint64_t> near_;
  std::vector<std::uint64_t> far_;
};

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

std::string baked_bytes(const BakedMesh& baked) { return Writer(baked).run(); }

}  // namespace restrip::tools
