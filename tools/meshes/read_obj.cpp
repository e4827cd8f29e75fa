// Reads Wavefront OBJ: `v x y z`, optionally followed by red, green, blue and alpha, `vt u v`, `vn x y z` and `f c c c
// …`. A corner is v, v/vt, v//vn or v/vt/vn, counted from 1, or from the end if negative. All other lines are ignored.
//
// A vertex of the soup is a `v` with one `vt` and one `vn`. The first such pair used with a `v` has the number of the
// `v`; other pairs follow at the end, in the order of the faces.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "common/bad_input.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

constexpr std::uint32_t no_value = std::numeric_limits<std::uint32_t>::max();

/// One corner of a face, as indices into the lists of the file.
struct ObjCorner {
  std::uint32_t point = no_value;
  std::uint32_t place = no_value;  // in the texture
  std::uint32_t normal = no_value;
};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& name, ReadAttributes attributes)
      : name_(name), cursor_(bytes), soup_(name), carry_(attributes == ReadAttributes::yes) {}

  Soup read() {
    for (; !cursor_.at_end(); cursor_.next_line()) {
      const std::string_view keyword = cursor_.word();
      if (keyword == "v")
        read_point();
      else if (keyword == "vt")
        read_value("TEXCOORD_0", places_, 1, 2);
      else if (keyword == "vn")
        read_value("NORMAL", normals_, 3, 3);
      else if (keyword == "f" || keyword == "fo")
        read_face();
    }
    refuse_missing(largest_point_, soup_.point_count(), "vertex");
    // Without any values the attribute is left out.
    if (!places_.empty()) refuse_missing(largest_place_, places_.size(), "`vt`");
    if (!normals_.empty()) refuse_missing(largest_normal_, normals_.size(), "`vn`");
    if (carry_) make_vertices();
    return std::move(soup_).finish();
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw BadInput(fmt::format("{}:{}: {}", name_, cursor_.line(), why));
  }
  /// Reads a value other than a coordinate.
  double value(std::string_view word) const {
    const auto found = parse<double>(word);
    if (!found) refuse(fmt::format("'{}' is not a number", word.substr(0, 40)));
    return *found;
  }
  static bool is_finite(const Attribute::Value& value) {
    return std::all_of(value.begin(), value.end(), [](double c) { return std::isfinite(static_cast<float>(c)); });
  }

  void read_point() {
    std::array<double, 3> p{};
    for (double& coordinate : p) {
      const std::string_view word = cursor_.word();
      const auto number = parse<double>(word);
      if (word.empty()) refuse("a vertex needs three numbers, but the line ends");
      if (!number) refuse(fmt::format("a vertex needs three numbers, found '{}'", word.substr(0, 40)));
      coordinate = *number;
    }
    soup_.add_point(p[0], p[1], p[2]);
    Attribute::Value color{};
    unsigned components = 0;
    for (std::string_view word = cursor_.word(); !word.empty() && components < 4; word = cursor_.word())
      color[components++] = carry_ ? value(word) : 0;
    if (components < 3) components = 0;  // one more is a weight
    if (components != 0 && !carry_) soup_.leave_out("COLOR_0");
    if (!carry_) return;
    // Either all vertices have the same kind of colour, or none.
    if (soup_.point_count() == 1) {
      colors_.components = components;
    } else if (components != colors_.components) {
      if (components != 0 || colors_.components != 0) soup_.leave_out("COLOR_0");
      colors_.components = 0;
    }
    if (colors_.components == 0) return;
    if (!is_finite(color)) soup_.doubt(soup_.point_count() - 1, "colours that are");
    colors_.append(is_finite(color) ? color : Attribute::Value{});
  }

  void read_value(const char* name, std::vector<Attribute::Value>& values, unsigned least, unsigned most) {
    if (!carry_) {
      soup_.leave_out(name);
      return;
    }
    Attribute::Value read{};
    unsigned components = 0;
    for (std::string_view word = cursor_.word(); !word.empty() && components < most; word = cursor_.word())
      read[components++] = value(word);
    if (components < least) refuse(fmt::format("a {} of {} numbers needs {}", attribute_line(name), components, least));
    if (most == 2) read[1] = 1 - read[1];  // OBJ counts from below
    values.push_back(most == 3 ? unit_normal(read) : read);
  }
  static const char* attribute_line(std::string_view name) { return name == "NORMAL" ? "`vn`" : "`vt`"; }

  /// The largest index into a list that a face has named, and the line of that face.
  struct Largest {
    std::uint32_t index = 0;
    std::size_t line = 0;  ///< 0: none yet
  };
  /// At the end of the file: refuses a face that names an element beyond the `size` elements of the list.
  void refuse_missing(const Largest& named, std::size_t size, const char* element) const {
    if (named.line != 0 && named.index >= size)
      throw BadInput(
          fmt::format("{}:{}: a face refers to {} {} (counted from 1), but there are {}; is the file complete?", name_,
                      named.line, element, std::uint64_t{named.index} + 1, size));
  }

  /// The index named in a corner; `size` elements of the list have been read.
  std::uint32_t place_of(std::string_view word, std::size_t size, std::string_view corner, Largest& largest) const {
    const auto index = parse<long long>(word);
    const long long place = !index ? -1 : *index > 0 ? *index - 1 : static_cast<long long>(size) + *index;
    if (!index || *index == 0 || place < 0 || place > static_cast<long long>(max_vertices))
      refuse(fmt::format("'{}' is not a vertex of the {} before this face; corners are counted from 1",
                         corner.substr(0, 40), size));
    const auto named = static_cast<std::uint32_t>(place);
    if (largest.line == 0 || named > largest.index) largest = {named, cursor_.line()};
    return named;
  }

  void read_face() {
    std::vector<std::uint32_t>& corners = face_;
    corners.clear();
    for (std::string_view word = cursor_.word(); !word.empty(); word = cursor_.word()) {
      const std::string_view corner = word;
      const auto next_part = [&word] {
        const std::size_t stop = word.find('/');
        const std::string_view part = word.substr(0, stop);
        word.remove_prefix(stop == std::string_view::npos ? word.size() : stop + 1);
        return part;
      };
      ObjCorner read{place_of(next_part(), soup_.point_count(), corner, largest_point_)};
      corners.push_back(carry_ ? static_cast<std::uint32_t>(corners_.size()) : read.point);
      if (!carry_) continue;
      if (const std::string_view part = next_part(); !part.empty())
        read.place = place_of(part, places_.size(), corner, largest_place_);
      if (const std::string_view part = next_part(); !part.empty())
        read.normal = place_of(part, normals_.size(), corner, largest_normal_);
      corners_.push_back(read);
    }
    if (!carry_) {
      soup_.add_face(corners);
      return;
    }
    faces_.push_back(corners.size());
  }

  /// Whether the corners of all faces have one. Reports the attribute if only some have it or the file has no values.
  bool all_have(std::uint32_t ObjCorner::*part, const std::vector<Attribute::Value>& values, const char* name) {
    std::size_t have = 0;
    for (const ObjCorner& corner : corners_) {
      if (corner.*part == no_value) continue;
      ++have;
      if (!values.empty() && !is_finite(values[corner.*part]))
        throw BadInput(
            fmt::format("{}: a face refers to {} {} (counted from 1), which is infinite or not a number; "
                        "mend or remove it",
                        name_, attribute_line(name), std::uint64_t{corner.*part} + 1));
    }
    if (have != 0 && values.empty()) soup_.leave_out(fmt::format("{} (missing from the file)", name));
    const bool all = have == corners_.size() && have != 0 && !values.empty();
    if (!all && !values.empty()) soup_.leave_out(name);
    return all;
  }

  void make_vertices() {
    const bool has_places = all_have(&ObjCorner::place, places_, "TEXCOORD_0");
    const bool has_normals = all_have(&ObjCorner::normal, normals_, "NORMAL");
    const std::size_t points = soup_.point_count();
    // The values with which each vertex is drawn. Vertices in no face have neutral values.
    std::vector<ObjCorner> drawn(points);
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> others;
    std::size_t at = 0;
    for (const std::size_t size : faces_) {
      face_.clear();
      for (const std::size_t end = at + size; at < end; ++at) {
        ObjCorner corner = corners_[at];
        if (!has_places) corner.place = 0;
        if (!has_normals) corner.normal = 0;
        ObjCorner& first = drawn[corner.point];
        if (first.point == no_value) first = corner;
        if (first.place == corner.place && first.normal == corner.normal) {
          face_.push_back(corner.point);
          continue;
        }
        const auto [found, is_new] = others.try_emplace(std::array{corner.point, corner.place, corner.normal},
                                                        static_cast<std::uint32_t>(drawn.size()));
        if (is_new) {
          const Point p = soup_.point(corner.point);
          soup_.add_point(p.x, p.y, p.z);
          drawn.push_back(corner);
        }
        face_.push_back(found->second);
      }
      soup_.add_face(face_);
    }
    if (has_normals) add_values("NORMAL", 3, normals_, &ObjCorner::normal, drawn);
    if (has_places) add_values("TEXCOORD_0", 2, places_, &ObjCorner::place, drawn);
    if (colors_.components == 0) return;
    for (std::size_t v = points; v < drawn.size(); ++v) colors_.append(colors_.value(drawn[v].point));
    soup_.attributes().push_back(std::move(colors_));
  }

  void add_values(const char* name, unsigned components, const std::vector<Attribute::Value>& values,
                  std::uint32_t ObjCorner::*part, const std::vector<ObjCorner>& drawn) {
    Attribute made{name, ComponentType::real, components};
    for (const ObjCorner& corner : drawn)
      made.append(corner.point == no_value ? neutral_value(name) : values[corner.*part]);
    soup_.attributes().push_back(std::move(made));
  }

  const std::string& name_;
  TextCursor cursor_;
  SoupBuilder soup_;
  bool carry_;
  std::vector<Attribute::Value> places_;
  std::vector<Attribute::Value> normals_;
  Largest largest_point_;
  Largest largest_place_;
  Largest largest_normal_;
  Attribute colors_{"COLOR_0", ComponentType::real, 0};  // 0 components: no colours
  std::vector<ObjCorner> corners_;                       // of all faces
  std::vector<std::size_t> faces_;                       // number of corners of each
  std::vector<std::uint32_t> face_;
};

}  // namespace

Soup read_obj(std::string_view bytes, const std::string& name, ReadAttributes attributes) {
  refuse_long_lines(bytes, name);
  return ObjReader(bytes, name, attributes).read();
}

}  // namespace restrip::tools
