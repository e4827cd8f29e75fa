// Reads glTF 2.0, as text (.gltf) and binary (.glb): lists, strips and fans of triangles, also with primitive restart,
// placed by the nodes of the scene. A node with a skin is not moved, as glTF requires; the skin itself, morph targets,
// instances, points, lines, materials and animations are left out and reported. Primitives of one node share vertices
// if they share positions and the supported attributes. A vertex with two normals is two vertices in the file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>

#include "common/printable.hpp"
#include "meshes/gltf_file.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"

namespace restrip::tools {
namespace {

/// An affine map: three rows of four.
using Affine = std::array<std::array<double, 4>, 3>;

constexpr Affine identity_map{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/// Applies `inner` first.
Affine product(const Affine& outer, const Affine& inner) {
  Affine made{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      made[row][column] = column == 3 ? outer[row][3] : 0;
      for (std::size_t i = 0; i < 3; ++i) made[row][column] += outer[row][i] * inner[i][column];
    }
  return made;
}

bool mirrors(const Affine& m) {
  const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return determinant < 0;
}

/// Transforms a tangent with the surface, including the last component, which gives the side of the bitangent.
Attribute::Value moved_tangent(const Affine& m, const Attribute::Value& t) {
  Attribute::Value made{0, 0, 0, mirrors(m) ? -t[3] : t[3]};
  for (std::size_t row = 0; row < 3; ++row) made[row] = m[row][0] * t[0] + m[row][1] * t[1] + m[row][2] * t[2];
  return unit_normal(made);
}

/// Transforms a normal by the matrix of cofactors, so that it stays perpendicular.
Attribute::Value moved_normal(const Affine& m, const Attribute::Value& n) {
  Attribute::Value made{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      const auto& below = m[(row + 1) % 3];
      const auto& last = m[(row + 2) % 3];
      const std::size_t right = (column + 1) % 3;
      const std::size_t left = (column + 2) % 3;
      made[row] += (below[right] * last[left] - below[left] * last[right]) * n[column];
    }
  if (mirrors(m))
    for (double& component : made) component = -component;
  return unit_normal(made);
}

Attribute moved(const Attribute& attribute, const Affine& map) {
  const bool is_normal = attribute.name == "NORMAL";
  if (map == identity_map || (!is_normal && attribute.name != "TANGENT")) return attribute;
  Attribute made = attribute;
  made.bytes.clear();
  for (std::size_t at = 0; at < attribute.bytes.size(); at += attribute.value_bytes()) {
    const Attribute::Value value = attribute.value(at / attribute.value_bytes());
    made.append(is_normal ? moved_normal(map, value) : moved_tangent(map, value));
  }
  return made;
}

template <std::size_t Count>
std::array<double, Count> numbers(const JsonValue& list, const std::array<double, Count>& other) {
  if (!list.there()) return other;
  if (list.size() != Count) list.refuse(fmt::format("has {} numbers, not {}", list.size(), Count));
  std::array<double, Count> found{};
  for (std::size_t i = 0; i < Count; ++i) found[i] = list.at(i).real();
  return found;
}

/// The map of a node. A rotation is normalised; `lengths` becomes true if it is not about 1 long, as glTF requires.
Affine map_of(const JsonValue& node, bool& lengths) {
  if (node["matrix"].there()) {
    const auto m = numbers<16>(node["matrix"], {});
    constexpr double rounding = 1e-5;  // of programs that multiply matrices in 32 bits
    if (!(std::max({std::abs(m[3]), std::abs(m[7]), std::abs(m[11]), std::abs(m[15] - 1)}) <= rounding))
      node["matrix"].refuse("has a last row other than 0 0 0 1");
    return {{{m[0], m[4], m[8], m[12]}, {m[1], m[5], m[9], m[13]}, {m[2], m[6], m[10], m[14]}}};
  }
  auto [x, y, z, w] = numbers<4>(node["rotation"], {0, 0, 0, 1});
  const double length = std::hypot(std::hypot(x, y, z), w);
  constexpr double rounding_of_rotations = 1e-3;  // more than that of programs that store them in few bits
  if (!(std::abs(length - 1) <= rounding_of_rotations)) {
    if (!(length > 0) || !std::isfinite(length))
      node["rotation"].refuse("is not a rotation: its length is not above 0");
    lengths = true;
  }
  for (double* component : {&x, &y, &z, &w}) *component /= length;
  const auto scale = numbers<3>(node["scale"], {1, 1, 1});
  const auto move = numbers<3>(node["translation"], {0, 0, 0});
  Affine m{{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), move[0]},
            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), move[1]},
            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), move[2]}}};
  for (auto& row : m)
    for (std::size_t i = 0; i < 3; ++i) row[i] *= scale[i];
  return m;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const std::string& name, const ReadSibling& sibling, ReadAttributes attributes)
      : file_(bytes, name, sibling), soup_(name), carry_(attributes == ReadAttributes::yes) {}

  Soup read() {
    const JsonValue root = file_.root();
    const JsonValue nodes = root["nodes"];
    visited_.assign(nodes.size(), false);
    if (nodes.size() == 0) {
      for (std::size_t i = 0; i < root["meshes"].size(); ++i) read_mesh_at(i, identity_map);
    } else if (root["scenes"].size() != 0) {
      const JsonValue tops = root["scenes"].at(root["scene"].whole_or(0))["nodes"];
      for (std::size_t i = 0; i < tops.size(); ++i) read_node(tops.at(i).whole());
    } else {
      std::vector<bool> is_child(nodes.size(), false);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t c = 0; c < nodes.at(i)["children"].size(); ++c) {
          const std::uint64_t child = nodes.at(i)["children"].at(c).whole();
          if (child < nodes.size()) is_child[static_cast<std::size_t>(child)] = true;
        }
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!is_child[i]) read_node(i);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!visited_[i] && nodes.at(i)["mesh"].there()) soup_.leave_out("meshes outside the scene");
    if (root["animations"].size() != 0) soup_.leave_out("animations");
    for (std::size_t i = 0; i < root["extensionsUsed"].size(); ++i)
      leave_out_extension(root["extensionsUsed"].at(i).text());
    return std::move(soup_).finish();
  }

 private:
  void leave_out_extension(const std::string& name) {
    constexpr std::array<std::string_view, 4> read{"KHR_mesh_primitive_restart", "KHR_mesh_quantization",
                                                   baked_strips_extension, progressive_extension};
    if (std::find(read.begin(), read.end(), name) != read.end()) return;
    const bool instances = name.ends_with("_instancing");
    soup_.leave_out(instances ? fmt::format("instances ({})", name) : "extension " + files::printable(name));
  }
  void leave_out_extensions(const JsonValue& of) {
    for (const std::string& name : of["extensions"].members()) leave_out_extension(name);
  }

  /// Reads a node and all its descendants.
  void read_node(std::uint64_t top) {
    struct Open {
      std::uint64_t node;
      Affine outer;
    };
    std::vector<Open> open{{top, identity_map}};
    while (!open.empty()) {
      const auto [number, outer] = open.back();
      open.pop_back();
      const JsonValue node = file_.root()["nodes"].at(number);
      const auto index = static_cast<std::size_t>(number);
      if (visited_[index]) node.refuse("is in the scene twice; nodes must form trees");
      visited_[index] = true;
      bool lengths = false;
      const Affine map = product(outer, map_of(node, lengths));
      if (lengths) soup_.leave_out("lengths of rotations other than 1");
      leave_out_extensions(node);
      if (node["camera"].there()) soup_.leave_out("cameras");
      const bool has_skin = node["skin"].there();
      if (has_skin) soup_.leave_out("skins");
      if (node["mesh"].there()) read_mesh_at(node["mesh"].whole(), has_skin ? identity_map : map);
      const JsonValue children = node["children"];
      for (std::size_t i = children.size(); i-- > 0;) open.push_back({children.at(i).whole(), map});
    }
  }

  void read_mesh_at(std::uint64_t number, const Affine& map) {
    const JsonValue mesh = file_.root()["meshes"].at(number);
    const JsonValue primitives = mesh["primitives"];
    std::map<Accessors, First> placed;  // index of their first point
    const bool mirrored = mirrors(map);
    leave_out_extensions(mesh);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const JsonValue primitive = primitives.at(i);
      file_.charge(16);
      const std::uint64_t mode = primitive["mode"].whole_or(4);
      if (mode > 6) primitive["mode"].refuse(fmt::format("is {}; there are 0 to 6", mode));
      if (mode < 4) {
        soup_.leave_out(mode == 0 ? "points" : "lines");
        continue;
      }
      if (!primitive["attributes"]["POSITION"].there()) {
        soup_.leave_out("primitives without positions");
        continue;
      }
      leave_out_extensions(primitive);
      if (primitive["targets"].size() != 0) soup_.leave_out("morph targets");
      if (primitive["material"].there()) soup_.leave_out("materials");
      const Accessors accessors = accessors_of(primitive["attributes"]);
      auto known = placed.find(accessors);
      if (known == placed.end()) known = placed.emplace(accessors, add_points(accessors, map)).first;
      std::vector<std::uint32_t> indices;
      if (primitive["indices"].there()) {
        indices = file_.indices(primitive["indices"].whole(), mode != 4);
      } else {
        indices.resize(static_cast<std::size_t>(known->second.count));
        std::iota(indices.begin(), indices.end(), 0U);
      }
      add_primitive(primitive, static_cast<unsigned>(mode), std::move(indices), known->second, mirrored);
    }
  }

  struct First {
    std::size_t point = 0;
    std::uint64_t count = 0;
  };

  /// The accessors of a primitive's vertices.
  struct Accessors {
    std::uint64_t positions = 0;
    std::map<std::string, std::uint64_t> attributes = {};  // the supported ones
    friend bool operator<(const Accessors& a, const Accessors& b) {
      return std::tie(a.positions, a.attributes) < std::tie(b.positions, b.attributes);
    }
  };

  Accessors accessors_of(const JsonValue& attributes) {
    Accessors found{attributes["POSITION"].whole()};
    constexpr std::size_t most_attributes = 256;
    if (const std::size_t count = attributes.members().size(); count > most_attributes)
      attributes.refuse(fmt::format("are {}, more than {}, the limit", count, most_attributes));
    for (const std::string& name : attributes.members()) {
      if (name == "POSITION") continue;
      const auto is_letter = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
      };
      if (carry_ && std::all_of(name.begin(), name.end(), is_letter))
        found.attributes.emplace(name, attributes[name].whole());
      else
        soup_.leave_out(name);
    }
    return found;
  }

  /// Adds the attributes of new points. An attribute is left out if not all vertices have it in the same encoding.
  void add_attributes(const std::map<std::string, std::uint64_t>& accessors, const First& first, const Affine& map) {
    std::vector<Attribute> added;
    for (const auto& [name, accessor] : accessors) {
      std::optional<Attribute> attribute = file_.attribute(accessor, name);
      if (!attribute) {
        soup_.leave_out(name);
        continue;
      }
      const std::size_t count = attribute->bytes.size() / attribute->value_bytes();
      if (count != first.count)
        file_.accessor(accessor).refuse(
            fmt::format("has {} values of {}, and there are {} positions", count, name, first.count));
      const bool is_direction = name == "NORMAL" || name == "TANGENT";
      for (std::size_t v = 0; v < count; ++v) {
        const Attribute::Value value = attribute->value(v);
        Attribute::Value usable = soup_.usable(value, first.point + v, name);
        if (is_direction) usable = unit_normal(usable);
        if (usable == value) continue;
        Attribute other = selected(*attribute, {});
        other.append(usable);
        attribute->bytes.replace(v * attribute->value_bytes(), other.bytes.size(), other.bytes);
      }
      added.push_back(moved(*attribute, map));
    }
    std::vector<Attribute>& carried = soup_.attributes();
    if (first.point == 0) {
      carried = std::move(added);
      return;
    }
    const auto same_in = [](const std::vector<Attribute>& all, const Attribute& one) {
      return std::find_if(all.begin(), all.end(), [&](const Attribute& other) { return other.alike(one); });
    };
    for (const Attribute& attribute : added)
      if (same_in(carried, attribute) == carried.end()) soup_.leave_out(attribute.name);
    std::vector<Attribute> kept;
    for (Attribute& attribute : carried) {
      if (const auto same = same_in(added, attribute); same != added.end()) {
        attribute.bytes += same->bytes;
        kept.push_back(std::move(attribute));
      } else {
        soup_.leave_out(attribute.name);
      }
    }
    carried = std::move(kept);
  }

  First add_points(const Accessors& accessors, const Affine& map) {
    const First first{soup_.point_count(), file_.accessor(accessors.positions)["count"].whole()};
    for (const Point& p : file_.positions(accessors.positions)) {
      const auto coordinate = [&](std::size_t row) {
        const auto& m = map[row];
        return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
      };
      soup_.add_point(coordinate(0), coordinate(1), coordinate(2));
    }
    try {
      if (first.count != 0) add_attributes(accessors.attributes, first, map);
    } catch (const BadInput& fault) {
      throw BadInput(fmt::format("{}; --no-attributes reads the mesh without it", fault.what()));
    }
    return first;
  }

  void add_primitive(const JsonValue& primitive, unsigned mode, std::vector<std::uint32_t> indices, const First& first,
                     bool mirrored) {
    for (std::uint32_t& index : indices) {
      if (index == strip_end) continue;
      if (index >= first.count)
        primitive["indices"].refuse(fmt::format("have {}, and there are {} positions", index, first.count));
      index += static_cast<std::uint32_t>(first.point);
    }
    std::vector<std::uint32_t> run;  // of indices between restarts
    for (auto from = indices.begin();; ++from) {
      const auto to = std::find(from, indices.end(), strip_end);
      const std::size_t size = static_cast<std::size_t>(to - from);
      if (mode == 4 && size % 3 != 0)
        primitive["indices"].refuse(fmt::format("are {}, which is not a multiple of three", size));
      run.assign(from, to);
      if (mode == 5) {
        // One more index in front turns all triangles.
        if (mirrored && !run.empty()) run.insert(run.begin(), run.front());
        soup_.add_strip(run);
      }
      for (std::size_t i = 2; i < run.size() && mode != 5; i += mode == 4 ? 3 : 1) {
        Corners corners{mode == 4 ? run[i - 2] : run.front(), run[i - 1], run[i]};
        if (mirrored) std::swap(corners[1], corners[2]);
        soup_.add_face(corners);
      }
      if (to == indices.end()) return;
      from = to;
    }
  }

  GltfFile file_;
  SoupBuilder soup_;
  bool carry_;
  std::vector<bool> visited_;
};

}  // namespace

Soup read_gltf(std::string_view bytes, const std::string& name, const ReadSibling& sibling, ReadAttributes attributes) {
  return GltfReader(bytes, name, sibling, attributes).read();
}

}  // namespace restrip::tools
