// A triangle soup: points and triangles as a mesh file lists them, unchecked.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/printable.hpp"

namespace restrip::tools {

/// The input is at fault, not the program, which exits with code 2. The text is one sentence that names the file, the
/// remedy, and the position if that helps.
using BadInput = files::FileError;

// Attributes of vertices: normals, texture coordinates, colours. Values are kept as the file encodes them, so writing
// them changes nothing.

/// Types of a number, as glTF numbers them.
enum class ComponentType : unsigned {
  signed_byte = 5120,
  unsigned_byte = 5121,
  signed_short = 5122,
  unsigned_short = 5123,
  unsigned_int = 5125,
  real = 5126
};

/// In bytes.
[[nodiscard]] constexpr unsigned width_of(ComponentType type) noexcept {
  if (type == ComponentType::signed_byte || type == ComponentType::unsigned_byte) return 1;
  return type == ComponentType::signed_short || type == ComponentType::unsigned_short ? 2 : 4;
}

/// The number that these bits encode.
[[nodiscard]] inline double decoded(std::uint32_t bits, ComponentType type) {
  if (type == ComponentType::real) return std::bit_cast<float>(bits);
  if (type == ComponentType::signed_byte) return static_cast<std::int8_t>(bits);
  if (type == ComponentType::signed_short) return static_cast<std::int16_t>(bits);
  return bits;
}

/// One value for each vertex.
struct Attribute {
  using Value = std::array<double, 4>;  ///< holds a component of any type exactly

  std::string name;  ///< as glTF names it: NORMAL, TANGENT, TEXCOORD_0, COLOR_0, or _OWN
  ComponentType type = ComponentType::real;
  unsigned components = 3;  ///< 1 to 4
  bool normalized = false;  ///< whole numbers that stand for 0 to 1, or -1 to 1
  std::string bytes = {};   ///< the values of all vertices, without gaps, little-endian

  [[nodiscard]] std::size_t value_bytes() const noexcept { return std::size_t{components} * width_of(type); }
  /// The stored value of a vertex, not normalised. Missing components are 0.
  [[nodiscard]] Value value(std::size_t vertex) const;
  /// The meaning of that value: normalised integers as 0 to 1, or -1 to 1.
  [[nodiscard]] Value meant(std::size_t vertex) const;
  /// Appends the value of the next vertex. Every component must be representable in the type.
  void append(const Value& value);
  /// Whether both have the same name and encoding, so that values of one may follow values of the other.
  [[nodiscard]] bool alike(const Attribute& other) const noexcept {
    return name == other.name && type == other.type && components == other.components && normalized == other.normalized;
  }
};

/// What a stored component of a normalised attribute stands for: 0 to 1, or -1 to 1.
[[nodiscard]] double fraction(double stored, ComponentType type);

/// Whether every component is finite in 32 bits.
[[nodiscard]] bool is_finite(const Attribute::Value& value);

/// The attribute of these vertices only, in this order.
[[nodiscard]] Attribute selected(const Attribute& attribute, std::span<const std::uint32_t> vertices);

/// The attribute of this name, or null.
[[nodiscard]] const Attribute* named(std::span<const Attribute> attributes, std::string_view name);

/// The n of TEXCOORD_n or COLOR_n; empty for other names.
[[nodiscard]] std::optional<unsigned> set_number(std::string_view name);

/// Scales a normal, or the first three components of a tangent, to length one, as glTF requires. Zero stays.
[[nodiscard]] Attribute::Value unit_normal(const Attribute::Value& normal);

/// Removes attributes that glTF forbids: colours outside 0 to 1, normals and tangents of length 0, tangents without
/// normals, a second set of colours without a first one. Returns their names with remarks.
[[nodiscard]] std::vector<std::string> remove_invalid(std::vector<Attribute>& attributes);

/// The default value for a vertex without this attribute: a normal or tangent of length one, otherwise zeros.
[[nodiscard]] Attribute::Value neutral_value(std::string_view name);

/// Soup::left_out in words, each once: "normals, texture coordinates".
[[nodiscard]] std::string left_out_in_words(std::span<const std::string> names);

/// Appends a name to a list unless the list has it already.
void note(std::vector<std::string>& names, const std::string& name);

struct Point {
  double x = 0;
  double y = 0;
  double z = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// Whether every coordinate is.
[[nodiscard]] inline bool is_finite(const Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// As most formats and graphics processors store it.
[[nodiscard]] constexpr Point in_32_bits(const Point& p) noexcept {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// Three vertices, counter-clockwise.
using Corners = std::array<std::uint32_t, 3>;

/// Rotates a triangle to start at its smallest corner: equal for equal triangles of equal orientation.
[[nodiscard]] constexpr Corners rotated(const Corners& t) noexcept {
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  if (t[1] <= t[2]) return {t[1], t[2], t[0]};
  return {t[2], t[0], t[1]};
}

/// Has a corner twice.
[[nodiscard]] constexpr bool degenerate(const Corners& t) noexcept {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Separates two strips of an index buffer.
inline constexpr std::uint32_t strip_end = 0xFFFF'FFFF;

/// Every corner is an index into `points`. Corners and triangles may repeat.
struct Soup {
  std::vector<Point> points;
  std::vector<Corners> triangles;
  /// The strips of the file, as an index buffer with strip_end between them. They draw all non-degenerate triangles
  /// above, in order; a triangle that the file lists individually is one strip. Empty if the file has no strips.
  std::vector<std::uint32_t> strips = {};
  /// Faces of more than three corners; each became triangles, a fan around its first corner if it is convex.
  std::size_t polygons = 0;
  std::size_t stubs = 0;  ///< faces of fewer than three corners; left out
  /// Attributes of the points, if requested. Two points at one position that differ in them are two vertices: a strip
  /// does not cross from one to the other.
  std::vector<Attribute> attributes = {};
  bool is_64_bits = false;  ///< the file declares its coordinates so (`double` in PLY)
  /// Parts of the file that the soup lacks: attributes by their names in glTF, perhaps with a remark after a blank, and
  /// others in words.
  std::vector<std::string> left_out = {};
};

// Positions of vertices: which coincide, and what is lost when they are rounded. Coordinates have 64 bits here; formats
// with 32 bits round them, which matters far from the origin.

/// For each of `count` vertices, the first vertex with the same point and the same attributes. Values are compared bit
/// by bit, except that both zeros are equal. Without points, only the attributes are compared. Sorting bounds the time
/// for any input: O(n log n).
[[nodiscard]] std::vector<std::uint32_t> first_alike(std::size_t count, std::span<const Point> points,
                                                     std::span<const Attribute> attributes = {});

/// Replaces the result of first_alike() by the numbers that vertices get if only the first of those alike remain, which
/// are returned.
std::vector<std::uint32_t> renumber(std::vector<std::uint32_t>& first);

/// The effect of rounding a mesh to 32 bits.
struct Rounding {
  double largest = 0;          ///< the largest change of a coordinate
  std::size_t coinciding = 0;  ///< vertices that then coincide with others
  /// Whether to report it: vertices coincide, or move by more than a millionth of the mesh's size.
  bool matters = false;
};

/// "x y z", each with the fewest digits that read back as the same number; in 32 bits if that is exact.
void put_coordinates(std::string& text, const Point& p);

/// O(n log n).
[[nodiscard]] Rounding rounding_of(std::span<const Point> points);

}  // namespace restrip::tools
