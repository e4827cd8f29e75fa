// Reads Wavefront OBJ: `v x y z`, optionally followed by red, green, blue and alpha, `vt u v`, `vn x y z` and `f c c c
// …`. A corner is v, v/vt, v//vn or v/vt/vn, counted from 1, or from the end if negative. Other lines are left out.
// An attribute is left out if one of its values or indices cannot be used.
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

#include "common/printable.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

constexpr std::uint32_t no_value = std::numeric_limits<std::uint32_t>::max();

/// What lines of the format other than meshes hold.
struct OtherLines {
  std::string_view keywords;  // with blanks around them
  const char* part;
};
constexpr OtherLines other_lines[]{
    {" l ", "lines"},
    {" p ", "points"},
    {" mtllib usemtl maplib usemap ", "materials"},
    {" vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con mg ctech stech ", "curves and surfaces"},
    {" bevel c_interp d_interp lod shadow_obj trace_obj ", "display attributes"}};

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
        read_value(places_, 1, 2);
      else if (keyword == "vn")
        read_value(normals_, 3, 3);
      else if (keyword == "f" || keyword == "fo")
        read_face();
      else if (!keyword.empty())
        leave_out_line(keyword);
    }
    if (groups_ > 1) soup_.leave_out("groups");
    const Largest& last = largest_point_;
    if (last.line != 0 && last.index >= soup_.point_count())
      throw BadInput(
          fmt::format("{}:{}: a face refers to vertex {} (counted from 1), but there are {}; is the file complete?",
                      name_, last.line, std::uint64_t{last.index} + 1, soup_.point_count()));
    if (carry_) make_vertices();
    return std::move(soup_).finish();
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw BadInput(fmt::format("{}:{}: {}", name_, cursor_.line(), why));
  }
  /// Values of corners: the lines `vt` or `vn`.
  struct Values {
    const char* name;
    const char* keyword;
    std::vector<Attribute::Value> values = {};
    std::string fault = {};  ///< the first, because of which all are left out
  };
  void spoil(Values& all, const std::string& why) const {
    if (all.fault.empty()) all.fault = fmt::format("line {}: {}", cursor_.line(), why);
  }

  void leave_out_line(std::string_view keyword) {
    if (keyword == "o" || keyword == "g") {
      ++groups_;
      return;
    }
    if (keyword == "s") {
      if (const std::string_view group = cursor_.word(); group != "off" && group != "0")
        soup_.leave_out("smoothing groups");
      return;
    }
    const auto has = [word = fmt::format(" {} ", keyword.substr(0, 40))](const OtherLines& lines) {
      return lines.keywords.find(word) != std::string_view::npos;
    };
    const auto* found = std::find_if(std::begin(other_lines), std::end(other_lines), has);
    soup_.leave_out(found != std::end(other_lines)
                        ? found->part
                        : fmt::format("lines `{}`", files::printable_ascii(keyword.substr(0, 40))));
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
    soup_.add_point(p[0], p[1], p[2], cursor_.line());
    Attribute::Value color{};
    unsigned components = 0;
    std::string_view word = cursor_.word();
    for (; !word.empty() && components < 4; word = cursor_.word()) {
      const auto number = parse<double>(word);
      color[components++] = number.value_or(std::numeric_limits<double>::quiet_NaN());
    }
    const bool is_weight = components == 1 && color[0] == 1;
    if (!word.empty() || (components < 3 && components != 0 && !is_weight))
      soup_.leave_out("other numbers of vertices");
    if (components < 3) components = 0;
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
    colors_.append(soup_.usable(color, soup_.point_count() - 1, "COLOR_0"));
  }

  void read_value(Values& all, unsigned least, unsigned most) {
    if (!carry_) {
      soup_.leave_out(all.name);
      return;
    }
    Attribute::Value read{};
    unsigned components = 0;
    std::string_view word = cursor_.word();
    for (; !word.empty() && components < most; word = cursor_.word()) {
      const auto number = parse<double>(word);
      if (!number) spoil(all, fmt::format("'{}' is not a number", files::printable_ascii(word.substr(0, 40))));
      read[components++] = number.value_or(0);
    }
    if (components < least) spoil(all, fmt::format("a `{}` of {} numbers", all.keyword, components));
    if (most == 2 && !word.empty() && parse<double>(word) != 0.0) soup_.leave_out("third texture coordinates");
    if (most == 2) read[1] = 1 - read[1];  // OBJ counts from below
    all.values.push_back(most == 3 ? unit_normal(read) : read);
  }

  /// The largest vertex that a face has named, and the line of that face.
  struct Largest {
    std::uint32_t index = 0;
    std::size_t line = 0;  ///< 0: none yet
  };

  /// The index that a word names in a list of which `size` elements have been read; no_value if it is none.
  static std::uint32_t index_of(std::string_view word, std::size_t size) {
    const auto index = parse<long long>(word);
    const long long place = !index ? -1 : *index > 0 ? *index - 1 : static_cast<long long>(size) + *index;
    const bool is_index = index && *index != 0 && place >= 0 && place <= static_cast<long long>(max_vertices);
    return is_index ? static_cast<std::uint32_t>(place) : no_value;
  }
  std::uint32_t point_of(std::string_view word, std::string_view corner) {
    const std::uint32_t found = index_of(word, soup_.point_count());
    if (found == no_value)
      refuse(fmt::format("'{}' is not a vertex of the {} before this face; corners are counted from 1",
                         corner.substr(0, 40), soup_.point_count()));
    if (largest_point_.line == 0 || found > largest_point_.index) largest_point_ = {found, cursor_.line()};
    return found;
  }
  std::uint32_t value_of(std::string_view word, std::string_view corner, Values& all) const {
    if (word.empty()) return no_value;
    const std::uint32_t found = index_of(word, all.values.size());
    if (found == no_value)
      spoil(all, fmt::format("'{}' names no `{}`", files::printable_ascii(corner.substr(0, 40)), all.keyword));
    return found;
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
      ObjCorner read{point_of(next_part(), corner)};
      corners.push_back(carry_ ? static_cast<std::uint32_t>(corners_.size()) : read.point);
      if (!carry_) continue;
      read.place = value_of(next_part(), corner, places_);
      read.normal = value_of(next_part(), corner, normals_);
      corners_.push_back(read);
    }
    if (!carry_) {
      soup_.add_face(corners);
      return;
    }
    faces_.push_back(corners.size());
  }

  /// Whether the corners of all faces have a usable one. Otherwise reports the attribute, unless it does not occur.
  bool all_have(std::uint32_t ObjCorner::*part, Values& all) {
    std::size_t have = 0;
    for (const ObjCorner& corner : corners_) {
      if (corner.*part == no_value) continue;
      ++have;
      if (all.values.empty() || !all.fault.empty()) continue;
      const std::uint64_t number = std::uint64_t{corner.*part} + 1;
      if (corner.*part >= all.values.size())
        all.fault = fmt::format("a face refers to `{}` {}, and there are {}", all.keyword, number, all.values.size());
      else if (!is_finite(all.values[corner.*part]))
        all.fault = fmt::format("`{}` {} is infinite or not a number", all.keyword, number);
    }
    if (have != 0 && all.values.empty()) all.fault = "missing from the file";
    if (have == corners_.size() && have != 0 && all.fault.empty()) return true;
    if (!all.values.empty() || !all.fault.empty())
      soup_.leave_out(all.fault.empty() ? all.name : fmt::format("{} ({})", all.name, all.fault));
    return false;
  }

  void make_vertices() {
    const bool has_places = all_have(&ObjCorner::place, places_);
    const bool has_normals = all_have(&ObjCorner::normal, normals_);
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
    if (has_normals) add_values(normals_, 3, &ObjCorner::normal, drawn);
    if (has_places) add_values(places_, 2, &ObjCorner::place, drawn);
    if (colors_.components == 0) return;
    for (std::size_t v = points; v < drawn.size(); ++v) colors_.append(colors_.value(drawn[v].point));
    soup_.attributes().push_back(std::move(colors_));
  }

  void add_values(const Values& all, unsigned components, std::uint32_t ObjCorner::*part,
                  const std::vector<ObjCorner>& drawn) {
    Attribute made{all.name, ComponentType::real, components};
    for (const ObjCorner& corner : drawn)
      made.append(corner.point == no_value ? neutral_value(all.name) : all.values[corner.*part]);
    soup_.attributes().push_back(std::move(made));
  }

  const std::string& name_;
  TextCursor cursor_;
  SoupBuilder soup_;
  bool carry_;
  Values places_{"TEXCOORD_0", "vt"};
  Values normals_{"NORMAL", "vn"};
  Largest largest_point_;
  std::size_t groups_ = 0;                               // statements that begin one
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
