#include "lod/baked_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/bad_input.hpp"
#include "files/reading.hpp"
#include "lod/coloring_check.hpp"
#include "lod/dual_order.hpp"
#include "lod/pm_file.hpp"
#include "restrip/mesh/checks.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using Spokes = VertexSplit<Halfedge>::Spokes;

constexpr std::string_view magic = "RestripB";
constexpr std::uint32_t version = 1;
constexpr std::size_t header_bytes = 24;
constexpr std::size_t checksum_bytes = 8;
constexpr std::size_t point_bytes = 12;
constexpr std::size_t triangle_bytes = 13;
constexpr std::size_t least_record_bytes = point_bytes + 3;

// Flips further away are named by the halfedge itself.
constexpr std::size_t near_edges = 2048;

/// The vertices around v, in ascending order: the names of v_l and v_r are their places in this list.
void neighbors_of(const StripMesh& mesh, Vertex v, std::vector<Vertex>& out) {
  out.clear();
  for_each_spoke(mesh, v, [&](Halfedge h) { out.push_back(mesh.to(h)); });
  std::sort(out.begin(), out.end());
}

/// A dual edge by the lower one of its two halfedges.
Halfedge canonical(const StripMesh& mesh, Halfedge h) { return {std::min(h.id, mesh.opposite(h).id)}; }

std::uint8_t colors(const StripMesh& mesh, Triangle t) {
  unsigned bits = 0;
  for (unsigned side = 0; side < 3; ++side) bits |= unsigned{mesh.solid(StripMesh::halfedge(t, side))} << side;
  return static_cast<std::uint8_t>(bits);
}

// ---- writing

class Writer {
 public:
  explicit Writer(const BakedMesh& baked)
      : baked_(baked),
        mesh_(numbered_by_appearance(baked.mesh)),
        now_(StripMesh::build(mesh_.base, mesh_.points.size())) {}

  std::string run() {
    const std::size_t base_points = mesh_.points.size() - mesh_.splits.size();
    bytes_ = magic;
    put(version);
    put(static_cast<std::uint32_t>(base_points));
    put(static_cast<std::uint32_t>(mesh_.base.size()));
    put(static_cast<std::uint32_t>(mesh_.splits.size()));
    for (std::size_t v = 0; v < base_points; ++v) put(mesh_.points[v]);
    for (const Corners& triangle : mesh_.base)
      for (const Vertex v : triangle) put(v);
    for (Triangle t = 0; t < mesh_.base.size(); ++t) bytes_.push_back(static_cast<char>(colors(baked_.base, t)));
    for (std::size_t i = 0; i < mesh_.splits.size(); ++i) put_record(i);
    const std::uint64_t hash = fnv1a(bytes_);
    put(static_cast<std::uint32_t>(hash));
    put(static_cast<std::uint32_t>(hash >> 32));
    return std::move(bytes_);
  }

 private:
  void put(std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
  }
  void put(const Point& p) {
    for (const float coordinate : {p.x, p.y, p.z}) put(std::bit_cast<std::uint32_t>(coordinate));
  }
  void put_number(std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes_.push_back(static_cast<char>((value & 127U) | 128U));
    bytes_.push_back(static_cast<char>(value));
  }
  /// Ascending numbers, each by how much it is beyond the least it could be.
  void put_ascending(const std::vector<std::uint64_t>& numbers) {
    std::uint64_t least = 0;
    for (const std::uint64_t n : numbers) {
      put_number(n - least);
      least = n + 1;
    }
  }

  void put_record(std::size_t i) {
    const Record& record = mesh_.splits[i];
    put(mesh_.points[record.v_t]);
    put_number(record.v_s);
    neighbors_of(now_, record.v_s, neighbors_);
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
    for (std::size_t n = 0; n < near_edges && near_.size() < wanted_.size(); ++n) {
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

// ---- reading

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  BakedMesh run() {
    check_whole();
    rest_.remove_prefix(magic.size() + 4);
    rest_.remove_suffix(checksum_bytes);
    const std::size_t points = u32();
    const std::size_t triangles = u32();
    const std::size_t splits = u32();
    if (triangles == 0) fail("its base has no triangles");
    if (points * point_bytes + triangles * triangle_bytes + splits * least_record_bytes > rest_.size())
      fail("its header promises more than it holds");
    baked_.mesh.points.reserve(points + splits);
    for (std::size_t v = 0; v < points; ++v) baked_.mesh.points.push_back(point());
    read_base(triangles, points + splits);
    now_ = baked_.base;
    now_.reserve(triangles + 2 * splits, points + splits);
    baked_.mesh.splits.reserve(splits);
    for (std::size_t i = 0; i < splits; ++i) read_record(i);
    if (!rest_.empty()) fail("it goes on behind its last record");
    if (!find_faults(now_).empty()) fail("the colours of its finest level are not valid");
    return std::move(baked_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw BadInput(fmt::format("{}: {}; bake it again (restrip bake)", name_, what));
  }
  void check_whole() const {
    if (!rest_.starts_with(magic))
      throw BadInput(
          fmt::format("{}: no baked mesh: it does not begin with '{}'; make one by restrip bake", name_, magic));
    if (rest_.size() < header_bytes + checksum_bytes) fail("it ends inside its header: the file is not complete");
    Reader header(rest_.substr(magic.size()), name_);
    if (const std::uint32_t found = header.u32(); found != version)
      fail(fmt::format("it is of version {}, and this program reads version {}", found, version));
    const std::string_view body = rest_.substr(0, rest_.size() - checksum_bytes);
    Reader end(rest_.substr(body.size()), name_);
    const std::uint64_t low = end.u32();
    if ((std::uint64_t{end.u32()} << 32 | low) != fnv1a(body))
      fail("its checksum does not fit: the file is truncated or altered");
  }

  std::uint8_t u8() {
    if (rest_.empty()) fail("it ends inside a record");
    const auto value = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return value;
  }
  std::uint32_t u32() {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i) value |= std::uint32_t{u8()} << (8 * i);
    return value;
  }
  Point point() {
    Point p;
    for (float* coordinate : {&p.x, &p.y, &p.z}) {
      *coordinate = std::bit_cast<float>(u32());
      if (!std::isfinite(*coordinate)) fail("a coordinate in it is infinite or not a number");
    }
    return p;
  }
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      const std::uint64_t byte = u8();
      value |= (byte & 127U) << shift;
      if (byte < 128) return value;
    }
    fail("a number in it is too long");
  }

  void read_base(std::size_t triangles, std::size_t fine_points) {
    std::vector<Corners>& base = baked_.mesh.base;
    base.resize(triangles);
    for (Corners& triangle : base)
      for (Vertex& corner : triangle) {
        corner = u32();
        if (corner >= baked_.mesh.points.size()) fail("a triangle of its base names a vertex that is not there");
      }
    baked_.base = StripMesh::build(base, fine_points);
    if (baked_.base.triangle_count() != triangles) fail("a triangle of its base is degenerate");
    StripMesh& mesh = baked_.base;
    std::vector<std::uint8_t> stored(triangles);
    for (Triangle t = 0; t < triangles; ++t) {
      stored[t] = u8();
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        if ((stored[t] >> side & 1U) != 0 && !StripMesh::on_boundary(mesh.opposite(h))) mesh.set_solid(h, true);
      }
    }
    for (Triangle t = 0; t < triangles; ++t)
      if (colors(mesh, t) != stored[t]) fail("neighbours in its base disagree on a colour");
    if (!find_faults(mesh).empty()) fail("the colours of its base are not valid");
  }

  void read_record(std::size_t i) {
    const auto v_t = static_cast<Vertex>(baked_.mesh.points.size());
    baked_.mesh.points.push_back(point());
    const auto fail_here = [&](std::string_view what) { fail(fmt::format("record {}: {}", i, what)); };
    const std::uint64_t v_s = number();
    if (v_s >= v_t || now_.spoke(static_cast<Vertex>(v_s)).id == none)
      fail_here("it splits a vertex that is not there");
    Record record{static_cast<Vertex>(v_s), v_t, none, none};
    neighbors_of(now_, record.v_s, neighbors_);
    const std::uint64_t apexes = number();
    const std::size_t radix = neighbors_.size() + 1;
    if (apexes == 0 || apexes / radix >= radix) fail_here("its apexes are not neighbours of the split vertex");
    if (const std::size_t left = apexes / radix; left != 0) record.v_l = neighbors_[left - 1];
    if (const std::size_t right = apexes % radix; right != 0) record.v_r = neighbors_[right - 1];
    const auto where = spokes_of(now_, record);
    if (const Refusal refusal = check_split(now_, where); refusal != Refusal::granted) fail_here(describe(refusal));
    const Halfedge chord = split_baked(now_, where, {}, v_t).halfedge;
    read_flips(chord, i);
    detail::flip_colors(now_, baked_.records[i]);
    for (const Halfedge h : baked_.records[i])
      for (const Halfedge beside : {h, now_.opposite(h)})
        if (now_.solid_degree(StripMesh::triangle(beside)) > 2) fail_here("it gives a triangle three solid edges");
    baked_.mesh.splits.push_back(record);
  }

  void read_flips(Halfedge chord, std::size_t i) {
    std::vector<Halfedge>& flips = baked_.records.flips;
    const auto fail_here = [&] { fail(fmt::format("record {}: it flips a dual edge that is not there", i)); };
    const std::uint64_t head = number();
    order_.start(now_, chord);
    std::uint64_t next = 0;
    for (std::uint64_t n = head / 2; n > 0; --n, ++next) {
      next += number();
      const Halfedge h = next < near_edges ? order_.edge(next) : Halfedge{none};
      if (h.id == none) fail_here();
      flips.push_back(canonical(now_, h));
    }
    next = 0;
    for (std::uint64_t n = head % 2 == 0 ? 0 : number(); n > 0; --n, ++next) {
      next += number();
      if (next >= 3 * std::uint64_t{now_.triangle_bound()}) fail_here();
      const Halfedge h = StripMesh::halfedge(static_cast<Triangle>(next / 3), static_cast<unsigned>(next % 3));
      if (StripMesh::on_boundary(now_.opposite(h))) fail_here();
      flips.push_back(canonical(now_, h));
    }
    baked_.records.first.push_back(static_cast<std::uint32_t>(flips.size()));
  }

  std::string_view rest_;
  const std::string& name_;
  BakedMesh baked_;
  StripMesh now_;
  DualOrder order_;
  std::vector<Vertex> neighbors_;
};

}  // namespace

BakedMesh parse_baked(std::string_view bytes, const std::string& name) { return Reader(bytes, name).run(); }

BakedMesh read_baked(const std::filesystem::path& file) { return parse_baked(files::read_whole(file), file.string()); }

std::string baked_bytes(const BakedMesh& baked) { return Writer(baked).run(); }

}  // namespace restrip::tools
