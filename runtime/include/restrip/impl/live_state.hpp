// The bytes of LiveMesh::save(), written and read. docs/reference/file-formats.md has the format.
//
// What is saved is what later operations depend on. A run of the strip buffer is saved as its place and the halfedge
// over which its first triangle is left; loading walks the strip from there and writes the indices again. So a file
// cannot describe a buffer that draws anything but its mesh. The reader trusts nothing: every number is compared with
// its range before it is used, and no array becomes larger than a constant times the file. Linear time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>

#include "restrip/formats/baked_format.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/policy.hpp"

namespace restrip::detail {

class LiveState {
 public:
  static constexpr std::string_view magic = "RestripL";
  static constexpr std::uint32_t version = 1;
  static constexpr std::size_t checksum_bytes = 8;

  /// Appends numbers, the lowest byte first.
  class Writer {
   public:
    template <class Number>
    void put(Number number) {
      for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes.push_back(static_cast<std::byte>(std::uint64_t{number} >> 8 * i & 0xFFU));
    }
    void put_all(std::span<const std::uint32_t> numbers) {
      for (const std::uint32_t number : numbers) put(number);
    }
    void operator()(std::uint64_t& number) { put(number); }

    std::vector<std::byte> bytes;
  };

  /// Reads them, and refuses the file when it ends or a number is out of range.
  class Reader {
   public:
    explicit Reader(std::span<const std::byte> bytes) : size_(bytes.size()) {
      for (std::size_t i = 0; i < (std::min)(magic.size(), bytes.size()); ++i)
        expect(bytes[i] == static_cast<std::byte>(magic[i]), "restrip: these bytes are not a saved LiveMesh");
      expect(bytes.size() >= magic.size() + 4 + checksum_bytes, truncated);
      left_ = bytes.subspan(magic.size());
      expect(get<std::uint32_t>() == version,
             "restrip: the saved LiveMesh has a version that this library cannot read");
      const auto above = bytes.first(bytes.size() - checksum_bytes);
      Reader sum(bytes.last(checksum_bytes), bytes.size());
      expect(sum.get<std::uint64_t>() == baked_format::fnv1a(above),
             "restrip: the saved LiveMesh is truncated or altered: its checksum is wrong");
      left_ = left_.first(left_.size() - checksum_bytes);
    }

    template <class Number>
    Number get() {
      expect(left_.size() >= sizeof(Number), truncated);
      std::uint64_t number = 0;
      for (std::size_t i = 0; i < sizeof(Number); ++i) number |= std::to_integer<std::uint64_t>(left_[i]) << 8 * i;
      left_ = left_.subspan(sizeof(Number));
      return static_cast<Number>(number);
    }
    /// A number of things that take at least this many bytes each.
    std::uint32_t count(std::size_t bytes_each) {
      const auto number = get<std::uint32_t>();
      expect(number <= left_.size() / bytes_each, truncated);
      return number;
    }
    std::uint32_t below(std::size_t bound) {
      const auto number = get<std::uint32_t>();
      expect(number < bound, altered);
      return number;
    }
    void operator()(std::uint64_t& number) { number = get<std::uint64_t>(); }
    /// Of the whole file.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    void expect_end() const { expect(left_.empty(), "restrip: the saved LiveMesh is too long"); }
    static void expect(bool holds, [[maybe_unused]] const char* sentence) {
      if (!holds) RESTRIP_THROW(std::invalid_argument, sentence);
    }

    static constexpr const char* truncated = "restrip: the saved LiveMesh is truncated";
    static constexpr const char* altered = "restrip: the saved LiveMesh describes a mesh or a buffer that cannot exist";

   private:
    Reader(std::span<const std::byte> bytes, std::size_t size) : left_(bytes), size_(size) {}

    std::span<const std::byte> left_;
    std::size_t size_;
  };

  static void write_header(Writer& out, const Keeper<StripMesh>& keeper, const LiveBuffer& buffer) {
    for (const char c : magic) out.put(static_cast<std::uint8_t>(c));
    out.put(version);
    out.put(static_cast<std::uint8_t>(keeper.policy()));
    for (const std::uint16_t weight : {keeper.weights().restart, keeper.weights().swap, keeper.weights().isolated})
      out.put(weight);
    out.put(static_cast<std::uint8_t>(buffer.format().form));
    out.put(static_cast<std::uint8_t>(buffer.format().width));
    out.put_all(std::array{buffer.layout().cache, buffer.layout().waste, buffer.layout().work});
  }
  static LiveOptions read_header(Reader& in) {
    LiveOptions options;
    options.policy = static_cast<Policy>(in.get<std::uint8_t>());
    Reader::expect(std::any_of(policies.begin(), policies.end(),
                               [&](const PolicyRow& row) { return row.policy == options.policy; }),
                   Reader::altered);
    for (std::uint16_t* const weight : {&options.cost.restart, &options.cost.swap, &options.cost.isolated})
      *weight = in.get<std::uint16_t>();
    options.format.form = static_cast<StripForm>(in.get<std::uint8_t>());
    options.format.width = static_cast<IndexWidth>(in.get<std::uint8_t>());
    Reader::expect(options.format.form <= StripForm::list && options.format.width <= IndexWidth::bits32,
                   Reader::altered);
    for (unsigned* const number : {&options.layout.cache, &options.layout.waste, &options.layout.work})
      *number = in.get<std::uint32_t>();
    Reader::expect(options.layout.in_range(), Reader::altered);
    return options;
  }

  // ---- the mesh

  static void write_mesh(Writer& out, const StripMesh& mesh) {
    out.put(static_cast<std::uint32_t>(mesh.triangles_.size()));
    out.put(static_cast<std::uint32_t>(mesh.spoke_.size()));
    out.put(static_cast<std::uint32_t>(mesh.free_vertices_.size()));
    for (const StripMesh::Record& record : mesh.triangles_) {
      out.put_all(record.corner);
      out.put_all(record.link);
    }
    out.put_all(mesh.free_);
    out.put_all(mesh.spoke_);
    for (const std::uint8_t mark : mesh.non_manifold_) out.put(mark);
    out.put_all(mesh.free_vertices_);
  }

  static StripMesh read_mesh(Reader& in) {
    constexpr std::size_t triangle_bytes = 24;
    constexpr std::size_t vertex_bytes = 5;
    StripMesh mesh;
    const std::uint32_t triangles = in.count(triangle_bytes);
    const std::uint32_t vertices = in.count(vertex_bytes);
    const std::uint32_t free_vertices = in.count(4);
    Reader::expect(triangles <= StripMesh::max_triangles, Reader::altered);
    mesh.triangles_.resize(triangles);
    std::size_t free = 0;
    for (StripMesh::Record& record : mesh.triangles_) {
      for (std::uint32_t& corner : record.corner) corner = in.get<std::uint32_t>();
      for (std::uint32_t& link : record.link) link = in.get<std::uint32_t>();
      free += record.corner[0] == none ? 1U : 0U;
    }
    std::vector<std::uint8_t> named(triangles, 0);
    mesh.free_.resize(free);
    for (Triangle& t : mesh.free_) {
      t = in.below(triangles);
      Reader::expect(!mesh.alive(t) && named[t]++ == 0, Reader::altered);
    }
    mesh.spoke_.resize(vertices);
    for (std::uint32_t& spoke : mesh.spoke_) spoke = in.get<std::uint32_t>();
    mesh.non_manifold_.resize(vertices);
    for (std::uint8_t& mark : mesh.non_manifold_) {
      mark = in.get<std::uint8_t>();
      Reader::expect(mark <= 1, Reader::altered);
    }
    mesh.free_vertices_.resize(free_vertices);
    for (Vertex& v : mesh.free_vertices_) v = in.below(vertices);
    expect_links(mesh);
    expect_fans(mesh);
    Reader::expect(check_coloring(mesh).valid, "restrip: the colours of the saved LiveMesh have a branch or a cycle");
    return mesh;
  }

  // ---- the buffer

  static void write_buffer(Writer& out, const StripMesh& mesh, const LiveBuffer& buffer) {
    out.put(static_cast<std::uint8_t>(buffer.index_bytes()));
    out.put(std::uint64_t{buffer.room()});
    std::visit([&](const auto& strips) { write(out, mesh, strips, buffer.format().form); }, buffer.buffer_);
  }

  static void read_buffer(Reader& in, const StripMesh& mesh, LiveBuffer& buffer) {
    const auto width = in.get<std::uint8_t>();
    const bool fits = (width == 2 && buffer.format().width != IndexWidth::bits32) ||
                      (width == 4 && buffer.format().width != IndexWidth::bits16);
    Reader::expect(fits, Reader::altered);
    const auto room = in.get<std::uint64_t>();
    buffer.make(width == 4);
    for (Triangle t = 0; width == 2 && t < mesh.triangle_bound(); ++t)
      Reader::expect(LiveBuffer::fits_16_bits(mesh, t), Reader::altered);
    std::visit([&](auto& indices) { read(in, mesh, indices); }, buffer.buffer_);
    Reader::expect(room >= buffer.size() && room <= 2 * in.size(), Reader::altered);
    buffer.room_ = static_cast<std::size_t>(room);
    buffer.whole_ = false;
    buffer.device_ = buffer.returned_ = {buffer.index_bytes(), buffer.room_};
  }

 private:
  using Halfedge = StripMesh::Halfedge;

  /// Corners are three vertices, or none; links lead back, between the same vertices, in the same colour.
  static void expect_links(const StripMesh& mesh) {
    constexpr std::array<Vertex, 3> removed{none, none, none};
    for (Triangle t = 0; t < mesh.triangles_.size(); ++t) {
      const auto& [corner, link] = mesh.triangles_[t];
      for (unsigned s = 0; s < 3; ++s) {
        const Vertex from = corner[s];
        const Vertex to = corner[StripMesh::side_after(s)];
        if (corner == removed) {
          Reader::expect(link[s] == StripMesh::edge_of_mesh, Reader::altered);
          continue;
        }
        Reader::expect(from < mesh.spoke_.size() && from != to, Reader::altered);
        if (link[s] == StripMesh::edge_of_mesh) continue;
        const Halfedge back{link[s] >> 1};
        Reader::expect(
            !StripMesh::on_boundary(back) && StripMesh::side(back) < 3 && mesh.alive(StripMesh::triangle(back)),
            Reader::altered);
        const std::uint32_t here = StripMesh::halfedge(t, s).id << 1 | (link[s] & 1U);
        Reader::expect(mesh.link_of(back) == here && mesh.corner_of(back, 0) == to && mesh.corner_of(back, 1) == from,
                       Reader::altered);
      }
    }
  }

  /// The first spoke of a vertex is one from which turning counter-clockwise meets all its triangles.
  static void expect_fans(const StripMesh& mesh) {
    std::vector<std::uint32_t> corners(mesh.spoke_.size(), 0);
    for (const StripMesh::Record& record : mesh.triangles_)
      for (const Vertex v : record.corner)
        if (v != none) ++corners[v];
    for (Vertex v = 0; v < mesh.spoke_.size(); ++v) {
      const Halfedge first{mesh.spoke_[v]};
      Reader::expect((first.id == none) == (corners[v] == 0), Reader::altered);
      if (first.id == none) continue;
      Reader::expect(!StripMesh::on_boundary(first) && mesh.alive(first) && mesh.from(first) == v, Reader::altered);
      if (mesh.non_manifold_[v] != 0) continue;
      std::uint32_t met = 0;
      Halfedge h = first;
      do {
        ++met;
        h = turn_ccw(mesh, h);
      } while (!StripMesh::on_boundary(h) && !(h == first));
      Reader::expect(met == corners[v], Reader::altered);
    }
  }

  /// Reads the run of some triangles that begins in the triangle of `out` and leaves it over that side; side 3: a
  /// single triangle. Its indices are then the last text of the buffer. False if no such run exists.
  static bool read_run(const StripMesh& mesh, StripBuffer& buffer, Halfedge out, std::uint32_t triangles,
                       std::uint32_t cuts) {
    buffer.begin_reading();
    Halfedge in = StripMesh::halfedge(StripMesh::triangle(out), 3);
    for (std::uint32_t i = 0; i < triangles; ++i) {
      if (i == 1) in = mesh.opposite(out);
      const Triangle t = StripMesh::triangle(in);
      const auto [a, b, c] = mesh.corners(t);
      if (buffer.links_ == buffer.strip_.size()) buffer.strip_.resize(2 * buffer.strip_.size() + 64);
      buffer.strip_[buffer.links_++] = {t, a ^ b ^ c, 0, StripBuffer::nothing};
      if (i + 1 == triangles) break;
      Halfedge exit = out;
      if (i != 0) {
        const auto step = strip_step(mesh, in);
        if (!step.continues) return false;
        exit = mesh.opposite(step.in);
        in = step.in;
      } else if (StripMesh::side(out) == 3 || StripMesh::on_boundary(mesh.opposite(out)) || !mesh.solid(out)) {
        return false;
      }
      buffer.strip_[buffer.links_ - 1].edge = mesh.from(exit) ^ mesh.to(exit);
    }
    buffer.write_text(mesh, 0, triangles, cuts);
    return true;
  }

  /// The halfedge that read_run() needs to write the run in this place as it is.
  static Halfedge exit_of(const StripMesh& mesh, const StripBuffer& buffer, std::uint32_t place,
                          std::span<const Triangle> ends, StripBuffer& scratch) {
    const Run& run = buffer.places_.run(place);
    Halfedge out;
    for (const Triangle t : ends) {
      out = StripMesh::halfedge(t, 3);
      for (unsigned s = 0; s < 3 && run.triangles > 1; ++s) {
        const Halfedge h = StripMesh::halfedge(t, s);
        if (mesh.solid(h) && buffer.run_of_[StripMesh::triangle(mesh.opposite(h))] == place) out = h;
      }
      if (read_run(mesh, scratch, out, run.triangles, run.cuts) && scratch.texts_.back().length == run.length &&
          buffer.cells_.hold(run.first, scratch.indices_of(scratch.texts_.back())))
        break;
    }
    return out;
  }

  static void write(Writer& out, const StripMesh& mesh, const StripBuffer& buffer, StripForm form) {
    const RunPlaces& places = buffer.places_;
    // The first and the last triangle of each run, the same for a single one.
    std::vector<std::array<Triangle, 2>> ends(places.places_.size(), {none, none});
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      if (!mesh.alive(t)) continue;
      const std::uint32_t place = buffer.run_of_[t];
      unsigned inside = 0;
      for (unsigned s = 0; s < 3; ++s) {
        const Halfedge h = StripMesh::halfedge(t, s);
        inside += mesh.solid(h) && buffer.run_of_[StripMesh::triangle(mesh.opposite(h))] == place ? 1U : 0U;
      }
      if (inside == 2) continue;
      ends[place][1] = t;
      if (ends[place][0] == none) ends[place][0] = t;
    }
    StripBuffer scratch(form, {}, buffer.width());
    out.put(static_cast<std::uint32_t>(buffer.cells_.size()));
    out.put(places.cursor());
    out.put(static_cast<std::uint32_t>(places.places_.size() - 1));
    out.put(static_cast<std::uint32_t>(places.runs()));
    for (std::uint32_t p = places.next(RunPlaces::head); p != RunPlaces::head; p = places.next(p)) {
      const Run& run = places.run(p);
      out.put_all(std::array{p, run.first, run.triangles, run.cuts, exit_of(mesh, buffer, p, ends[p], scratch).id});
    }
    for (std::uint32_t p = places.totals_.free; p != RunPlaces::head; p = places.next(p)) out.put(p);
    std::vector<std::uint32_t> sorted;  // so that sorting them in, the last one first, makes the same lists
    for (std::uint32_t p : places.totals_.first_of)
      for (; p != RunPlaces::no_place; p = places.places_[p].farther) sorted.push_back(p);
    out.put(static_cast<std::uint32_t>(sorted.size()));
    out.put_all(sorted);
  }

  static void read(Reader& in, const StripMesh& mesh, StripBuffer& buffer) {
    constexpr std::size_t run_bytes = 20;
    const auto fits = [&](std::uint32_t place) { return !buffer.stitched_ || place % 2 == 0; };  // windings
    RunPlaces& places = buffer.places_;
    const auto length = in.get<std::uint32_t>();
    Reader::expect(length <= in.size() && fits(length) && buffer.even(length) == length, Reader::altered);
    places.set_cursor(in.get<std::uint32_t>());
    const std::uint32_t count = in.count(4);
    const std::uint32_t runs = in.count(run_bytes);
    Reader::expect(runs <= count, Reader::altered);
    buffer.cells_.resize(length, buffer.filling());
    buffer.run_of_.assign(mesh.triangle_bound(), StripBuffer::nothing);
    places.places_.resize(count + std::size_t{1});
    places.totals_.length = length;
    places.totals_.runs = runs;
    std::vector<std::uint8_t> named(count + std::size_t{1}, 0);
    const auto take_place = [&] {
      const std::uint32_t p = in.below(named.size());
      Reader::expect(p != RunPlaces::head && named[p]++ == 0, Reader::altered);
      return p;
    };
    std::size_t drawn = 0;
    std::uint32_t before = RunPlaces::head;
    for (std::uint32_t i = 0; i < runs; ++i) {
      const std::uint32_t p = take_place();
      const auto first = in.get<std::uint32_t>();
      const auto triangles = in.get<std::uint32_t>();
      const auto cuts = in.get<std::uint32_t>();
      const Halfedge out{in.get<std::uint32_t>()};
      drawn += triangles;
      Reader::expect(first >= places.run(before).end() && fits(first) && triangles - 1 < longest_run &&
                         drawn <= mesh.triangle_count() && cuts <= 2 && !StripMesh::on_boundary(out) &&
                         mesh.alive(StripMesh::triangle(out)) && read_run(mesh, buffer, out, triangles, cuts),
                     Reader::altered);
      const std::uint32_t size = buffer.texts_.back().length;
      Reader::expect(size <= length && first <= length - size, Reader::altered);
      buffer.cells_.write(first, buffer.indices_of(buffer.texts_.back()));
      for (std::uint32_t link = 0; link < triangles; ++link) {
        std::uint32_t& run = buffer.run_of_[buffer.strip_[link].triangle];
        Reader::expect(run == StripBuffer::nothing, Reader::altered);
        run = p;
      }
      const Triangle end = (std::min)(buffer.strip_[0].triangle, buffer.strip_[triangles - 1].triangle);
      places.places_[p].run = {first, size, triangles, cuts, end};
      places.places_[p].previous = before;
      places.places_[before].next = p;
      places.totals_.used += size;
      places.totals_.cuts += cuts;
      before = p;
    }
    places.places_[before].next = RunPlaces::head;
    places.places_[RunPlaces::head].previous = before;
    Reader::expect(drawn == mesh.triangle_count(), Reader::altered);
    std::uint32_t* last = &places.totals_.free;
    for (std::uint32_t i = runs; i < count; ++i) {
      *last = take_place();
      last = &places.places_[*last].next;
    }
    std::vector<std::uint32_t> sorted(in.count(4));
    for (std::uint32_t& p : sorted) {
      p = in.below(named.size());
      Reader::expect(p == RunPlaces::head || places.run(p).triangles != 0, Reader::altered);
    }
    places.make_room(0);
    for (std::size_t i = sorted.size(); i-- > 0;) places.sort_in(sorted[i]);
    for (std::uint32_t p = places.next(RunPlaces::head); p != RunPlaces::head; p = places.next(p)) places.sort_in(p);
    places.sort_in(RunPlaces::head);
    buffer.written_.clear();
    buffer.stale_ = buffer.rebuilt_ = false;
  }

  static void write(Writer& out, const StripMesh& mesh, const TriangleListBuffer& buffer, StripForm /*form*/) {
    for (std::size_t slot = 0; slot < buffer.owner_.size(); ++slot) {
      const Triangle t = buffer.owner_[slot];
      unsigned turn = 0;
      while (turn < 2 && mesh.corners(t)[turn] != buffer.cells_[3 * slot]) ++turn;
      out.put(StripMesh::halfedge(t, turn).id);
    }
  }

  static void read(Reader& in, const StripMesh& mesh, TriangleListBuffer& buffer) {
    buffer.slot_.assign(mesh.triangle_bound(), TriangleListBuffer::no_slot);
    for (std::size_t slot = 0; slot < mesh.triangle_count(); ++slot) {
      const Halfedge first{in.get<std::uint32_t>()};
      Reader::expect(!StripMesh::on_boundary(first) && mesh.alive(first) &&
                         buffer.slot_[StripMesh::triangle(first)] == TriangleListBuffer::no_slot,
                     Reader::altered);
      const Halfedge second = StripMesh::next(first);
      buffer.append(StripMesh::triangle(first), {mesh.from(first), mesh.from(second), mesh.to(second)});
    }
    buffer.pad();
    buffer.stale_ = false;
  }
};

}  // namespace restrip::detail
