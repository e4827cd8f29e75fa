// Progressive meshes in Hoppe's format (pm_file.hpp).
#include <fmt/format.h>

#include <bit>
#include <tuple>
#include <vector>

#include "lod/pm_file.hpp"
#include "meshes/soup.hpp"
#include "meshes/text_cursor.hpp"
#include "restrip/mesh/checks.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t hoppe_face_bytes = 14;   // three wedges and a material
constexpr std::size_t least_split_bytes = 44;  // with one wedge's normal
constexpr std::size_t longest_header_line = 1000;

/// The bits of a split's code.
struct HoppeCode {
  unsigned bits = 0;

  [[nodiscard]] unsigned corner() const { return bits & 3U; }  ///< in its face: the vertex that is split
  [[nodiscard]] unsigned centre() const {
    return bits >> 2 & 3U;
  }  ///< 0, 1, 2: the vertex was v_t, the midpoint or v_s
  [[nodiscard]] bool has_materials() const { return (bits & 0xC000U) != 0; }
  /// Whether the vertex (4: the old one, 7: the new one) has the same wedge inside as outside on the left (0), on the
  /// right (1), or on both sides inside (2).
  [[nodiscard]] bool same(unsigned vertex, unsigned where) const { return (bits >> (vertex + where) & 1U) != 0; }

  /// Wedges whose attributes the record changes.
  [[nodiscard]] unsigned wedges(bool has_right) const {
    const auto differ = [this](unsigned where) { return unsigned{!same(7, where)} + unsigned{!same(4, where)}; };
    unsigned count = differ(0) == 2 ? 2 : 1;
    if (has_right) {
      if (differ(1) == 2)
        count += differ(2);
      else if (centre() == 1)
        count += unsigned{differ(2) != 0};
      else
        count += unsigned{!same(centre() == 2 ? 7 : 4, 2)};
    }
    return count + (bits >> 11 & 1U) + (bits >> 13 & 1U);  // new wedges at the two apexes
  }
};

class HoppeReader {
 public:
  HoppeReader(std::string_view bytes, const std::string& name) : name_(name), bytes_(bytes) {}

  ProgressiveMesh read() {
    read_header();
    read_base();
    need(splits_, least_split_bytes, "splits");
    mesh_.splits.reserve(splits_);
    for (std::size_t i = 0; i < splits_; ++i) read_split(i);
    if (!bytes_.starts_with('\xFF')) refuse(fmt::format("does not end after its {} splits", splits_));
    return std::move(mesh_);
  }

 private:
  using Halfedge = StripMesh::Halfedge;

  [[noreturn]] void refuse(const std::string& why) const { throw BadInput(fmt::format("{}: {}", name_, why)); }
  [[noreturn]] void refuse_split(std::size_t number, const std::string& why) const {
    refuse(fmt::format("split {} (counted from 0) {}; only splits of manifolds are read", number, why));
  }
  void need(std::size_t count, std::size_t each, const char* what) const {
    if (count > bytes_.size() / each)
      refuse(fmt::format("announces {} {}, more than its remaining {} bytes can hold; is it complete?", count, what,
                         bytes_.size()));
  }

  // ---- text
  std::string_view line() {
    const std::size_t stop = bytes_.find('\n');
    if (stop == std::string_view::npos) refuse("ends inside its header; is it complete?");
    std::string_view found = bytes_.substr(0, stop);
    bytes_.remove_prefix(stop + 1);
    if (found.ends_with('\r')) found.remove_suffix(1);
    return found.substr(0, longest_header_line);
  }
  /// The number after `name`= in a line.
  std::size_t number(std::string_view text, std::string_view name) const {
    const std::string key = fmt::format("{}=", name);
    for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
      if (at != 0 && text[at - 1] != ' ') continue;
      const std::string_view word = text.substr(at + key.size());
      const auto value = parse<std::uint32_t>(word.substr(0, word.find(' ')));
      if (value) return *value;
    }
    refuse(fmt::format("its header has no number {} in the line '{}'", name, text.substr(0, 80)));
  }

  void read_header() {
    mesh_.left_out = {"NORMAL", "materials"};  // every file has them
    std::string_view text = line();
    while (text != "PM") text = line();
    std::size_t version = 0;
    bool counted = false;
    for (text = line(); text != "PM base mesh:"; text = line()) {
      if (text.starts_with("version=")) version = number(text, "version");
      if (text.starts_with("nvsplits=")) {
        splits_ = number(text, "nvsplits");
        counted = true;
      }
      for (const auto& [name, bytes, attribute] :
           {std::tuple{"has_rgb", 12U, "COLOR_0"}, std::tuple{"has_uv", 8U, "TEXCOORD_0"}})
        if (text.starts_with(name) && number(text, name) != 0) {
          wedge_bytes_ += bytes;
          note(mesh_.left_out, attribute);
        }
      if (text.starts_with("has_resid=") && number(text, "has_resid") != 0) residual_bytes_ = 8;
      if (text.starts_with("has_wad2=") && number(text, "has_wad2") != 0) always_two_ = true;
    }
    if (version != 2) refuse(fmt::format("a progressive mesh of Hoppe's version {}; only 2 is read", version));
    if (!counted) refuse("its header does not say how many splits there are");
  }

  // ---- numbers
  std::string_view take(std::size_t bytes) {
    if (bytes_.size() < bytes) refuse("ends among its records; is it complete?");
    const std::string_view taken = bytes_.substr(0, bytes);
    bytes_.remove_prefix(bytes);
    return taken;
  }
  std::uint32_t whole(unsigned bytes) {
    std::uint32_t value = 0;
    for (const char c : take(bytes)) value = value << 8U | static_cast<unsigned char>(c);
    return value;
  }
  Point vector() {
    Point p;
    for (double* coordinate : {&p.x, &p.y, &p.z}) *coordinate = std::bit_cast<float>(whole(4));
    return p;
  }
  void set_point(Vertex v, const Point& p) {
    if (!is_finite(p)) refuse(fmt::format("vertex {} moves to a position that is infinite or not a number", v));
    mesh_.points[v] = p;
  }

  // ---- the base
  void read_base() {
    for (std::size_t materials = number(line(), "nmaterials"); materials > 0; --materials) line();
    const std::string_view counts = line();
    const std::size_t vertices = number(counts, "nvertices");
    const std::size_t wedges = number(counts, "nwedges");
    const std::size_t faces = number(counts, "nfaces");
    need(vertices, 12, "vertices");
    if (splits_ > none - vertices) refuse("has more vertices than there are numbers");
    mesh_.points.resize(vertices);
    for (std::size_t v = 0; v < vertices; ++v) set_point(static_cast<Vertex>(v), vector());
    need(wedges, 4 + wedge_bytes_, "wedges");
    std::vector<Vertex> vertex_of(wedges);
    for (Vertex& v : vertex_of) {
      v = whole(4);
      if (v >= vertices) refuse(fmt::format("a wedge of its base is at vertex {} of {}", v, vertices));
      take(wedge_bytes_);
    }
    need(faces, hoppe_face_bytes, "faces");
    mesh_.base.resize(faces);
    for (Corners& face : mesh_.base) {
      for (Vertex& corner : face) {
        const std::uint32_t wedge = whole(4);
        if (wedge >= wedges) refuse(fmt::format("a face of its base refers to wedge {} of {}", wedge, wedges));
        corner = vertex_of[wedge];
      }
      if (degenerate(face)) refuse("a face of its base has a corner twice; remove it");
      take(2);
    }
    if (faces == 0) refuse("its base has no triangles, so there is nothing to replay");
    strip_mesh_ = StripMesh::build(mesh_.base, vertices);
    for (std::size_t t = 0; t < faces; ++t) {
      unsigned side = 0;
      while (strip_mesh_.from(StripMesh::halfedge(static_cast<Triangle>(t), side)) != mesh_.base[t][0]) ++side;
      first_side_.push_back(StripMesh::halfedge(static_cast<Triangle>(t), side));
    }
  }

  // ---- a split
  void read_split(std::size_t number) {
    const std::uint32_t face = whole(4);
    const std::uint32_t turn = whole(2);
    const HoppeCode code{whole(2)};
    const bool has_right = turn > 1;
    if (code.has_materials()) take(4);
    const Point large = vector();
    const Point small = vector();
    take((always_two_ ? 2 : code.wedges(has_right)) * wedge_bytes_ + residual_bytes_);
    if (face >= first_side_.size() || code.corner() > 2 || code.centre() > 2 || turn > 0x7FFFU)
      refuse_split(number, "names no corner of a face");

    Halfedge h = first_side_[face];
    for (unsigned i = 0; i < code.corner(); ++i) h = StripMesh::next(h);
    Record record;
    record.v_s = strip_mesh_.from(h);
    record.v_t = static_cast<Vertex>(mesh_.points.size());
    record.v_l = turn == 0 ? strip_mesh_.to(h) : strip_mesh_.from(StripMesh::next(StripMesh::next(h)));
    if (has_right) {
      const Halfedge begin = h;
      for (std::uint32_t i = 2; i < turn; ++i) {
        const Halfedge back = strip_mesh_.opposite(h);
        h = StripMesh::on_boundary(back) ? begin : StripMesh::next(back);
        if (h == begin) refuse_split(number, "turns further than the triangles around its vertex reach");
      }
      record.v_r = strip_mesh_.to(h);
    }
    const auto where = spokes_of(strip_mesh_, record);
    if (const Refusal refusal = check_split(strip_mesh_, where, record.v_t); refusal != Refusal::granted)
      refuse_split(number, fmt::format("cannot be done: {}", describe(refusal)));
    const Halfedge chord = strip_mesh_.insert_vertex(where, record.v_t);
    first_side_.push_back(chord);
    if (has_right) first_side_.push_back(StripMesh::next(strip_mesh_.opposite(chord)));
    mesh_.splits.push_back(record);
    // The positions of both vertices.
    const auto sum = [](const Point& a, const Point& b, double factor) {
      return Point{a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
    };
    const Point old = mesh_.points[record.v_s];
    mesh_.points.emplace_back();
    if (code.centre() == 1) {
      const Point middle = sum(old, small, 1);
      set_point(record.v_t, sum(middle, large, 1));
      set_point(record.v_s, sum(middle, large, -1));
    } else {
      set_point(record.v_t, sum(old, code.centre() == 2 ? large : small, 1));
      set_point(record.v_s, sum(old, code.centre() == 2 ? small : large, 1));
    }
  }

  const std::string& name_;
  std::string_view bytes_;  // unread bytes
  std::size_t splits_ = 0;
  std::size_t wedge_bytes_ = 12;  // of its attributes: at least a normal
  std::size_t residual_bytes_ = 0;
  bool always_two_ = false;  // wedges change in every split
  ProgressiveMesh mesh_;
  StripMesh strip_mesh_;
  std::vector<Halfedge> first_side_;  // of each face: the one that leaves its first corner
};

}  // namespace

bool is_hoppe_pm(std::string_view bytes) {
  while (bytes.starts_with('#')) {
    const std::size_t stop = bytes.find('\n');
    if (stop == std::string_view::npos) return false;
    bytes.remove_prefix(stop + 1);
  }
  return bytes.starts_with("PM\n") || bytes.starts_with("PM\r\n");
}

ProgressiveMesh parse_hoppe_pm(std::string_view bytes, const std::string& name) {
  return HoppeReader(bytes, name).read();
}

}  // namespace restrip::tools
