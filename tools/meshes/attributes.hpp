// Attributes of vertices: normals, texture coordinates, colours. Values are kept as the file encodes them, so writing
// them changes nothing.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::tools {

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

}  // namespace restrip::tools
