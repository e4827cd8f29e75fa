#include "meshes/attributes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

#include "meshes/little_endian.hpp"

namespace restrip::tools {
namespace {

/// A remark may follow the name after a blank.
std::string attribute_in_words(std::string_view name) {
  if (const std::size_t blank = name.find(' '); blank != std::string_view::npos)
    return attribute_in_words(name.substr(0, blank)) + std::string(name.substr(blank));
  if (name == "NORMAL") return "normals";
  if (name == "TANGENT") return "tangents";
  if (name.starts_with("TEXCOORD_")) return "texture coordinates";
  if (name.starts_with("COLOR_")) return "colours";
  if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) return "skin weights";
  return std::string(name);
}

}  // namespace

Attribute::Value Attribute::value(std::size_t vertex) const {
  Value found{};
  for (unsigned c = 0; c < components; ++c) {
    const std::uint32_t bits =
        little_endian(bytes, vertex * value_bytes() + std::size_t{c} * width_of(type), width_of(type));
    found[c] = decoded(bits, type);
  }
  return found;
}

Attribute::Value Attribute::meant(std::size_t vertex) const {
  Value found = value(vertex);
  if (!normalized) return found;
  const bool is_signed = type == ComponentType::signed_byte || type == ComponentType::signed_short;
  const auto most = static_cast<double>((std::uint64_t{1} << (8 * width_of(type) - (is_signed ? 1U : 0U))) - 1);
  for (double& component : found) component = std::max(component / most, -1.0);
  return found;
}

void Attribute::append(const Value& value) {
  for (unsigned c = 0; c < components; ++c) {
    const std::uint32_t bits = type == ComponentType::real
                                   ? std::bit_cast<std::uint32_t>(static_cast<float>(value[c]))
                                   : static_cast<std::uint32_t>(static_cast<std::int64_t>(value[c]));
    put(bytes, bits, width_of(type));
  }
}

Attribute selected(const Attribute& attribute, std::span<const std::uint32_t> vertices) {
  Attribute made{attribute.name, attribute.type, attribute.components, attribute.normalized};
  const std::size_t size = attribute.value_bytes();
  made.bytes.reserve(size * vertices.size());
  for (const std::uint32_t v : vertices) made.bytes.append(attribute.bytes, v * size, size);
  return made;
}

const Attribute* named(std::span<const Attribute> attributes, std::string_view name) {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [name](const Attribute& attribute) { return attribute.name == name; });
  return found == attributes.end() ? nullptr : &*found;
}

Attribute::Value unit_normal(const Attribute::Value& normal) {
  const auto [x, y, z, unused] = normal;
  const double square = x * x + y * y + z * z;
  constexpr double nearly = 1e-4;
  if (std::abs(square - 1) <= nearly || !(square > 0) || !std::isfinite(square)) return normal;
  const double length = std::sqrt(square);
  return {x / length, y / length, z / length, 0};
}

Attribute::Value neutral_value(std::string_view name) {
  if (name == "NORMAL") return {0, 0, 1, 0};
  return name == "TANGENT" ? Attribute::Value{1, 0, 0, 1} : Attribute::Value{};
}

std::string attributes_in_words(std::span<const std::string> names) {
  std::vector<std::string> words;
  for (const std::string& name : names) note(words, attribute_in_words(name));
  return fmt::format("{}", fmt::join(words, ", "));
}

void note(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace restrip::tools
