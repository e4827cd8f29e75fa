#include "meshes/soup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
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

constexpr double nearly_one = 1e-4;

/// Why glTF forbids the value; empty if it is allowed.
std::string_view fault_of(const Attribute& attribute, const Attribute::Value& value) {
  if (attribute.name.starts_with("COLOR_") && attribute.type == ComponentType::real &&
      !std::all_of(value.begin(), value.end(), [](double c) { return c >= 0 && c <= 1; }))
    return "outside 0 to 1";
  if (attribute.name != "NORMAL" && attribute.name != "TANGENT") return "";
  const auto [x, y, z, w] = value;
  if (std::abs(x * x + y * y + z * z - 1) > 2 * nearly_one) return "of length 0";
  return attribute.name == "TANGENT" && w != 1 && w != -1 ? "of a side other than 1 and -1" : "";
}

}  // namespace

std::optional<unsigned> set_number(std::string_view name) {
  for (const std::string_view kind : {"TEXCOORD_", "COLOR_"}) {
    if (!name.starts_with(kind)) continue;
    name.remove_prefix(kind.size());
    const bool is_number = !name.empty() && name.size() < 4 && (name[0] != '0' || name.size() == 1) &&
                           name.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_number) return std::nullopt;
    unsigned number = 0;
    for (const char digit : name) number = 10 * number + static_cast<unsigned>(digit - '0');
    return number;
  }
  return std::nullopt;
}

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
  for (double& component : found) component = fraction(component, type);
  return found;
}

double fraction(double stored, ComponentType type) {
  const bool is_signed = type == ComponentType::signed_byte || type == ComponentType::signed_short;
  const auto most = static_cast<double>((std::uint64_t{1} << (8 * width_of(type) - (is_signed ? 1U : 0U))) - 1);
  return std::max(stored / most, -1.0);
}

bool is_finite(const Attribute::Value& value) {
  return std::all_of(value.begin(), value.end(), [](double c) { return std::isfinite(static_cast<float>(c)); });
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
  const auto [x, y, z, w] = normal;
  const double square = x * x + y * y + z * z;
  if (std::abs(square - 1) <= nearly_one || !(square > 0) || !std::isfinite(square)) return normal;
  const double length = std::sqrt(square);
  return {x / length, y / length, z / length, w};
}

std::vector<std::string> remove_invalid(std::vector<Attribute>& attributes) {
  std::vector<std::string> removed;
  const auto remove_if = [&](auto&& fault) {
    return std::erase_if(attributes, [&](const Attribute& attribute) {
      const std::string_view remark = fault(attribute);
      if (!remark.empty()) removed.push_back(fmt::format("{} ({})", attribute.name, remark));
      return !remark.empty();
    });
  };
  (void)remove_if([](const Attribute& attribute) -> std::string_view {
    for (std::size_t at = 0; at < attribute.bytes.size(); at += attribute.value_bytes())
      if (const std::string_view remark = fault_of(attribute, attribute.value(at / attribute.value_bytes()));
          !remark.empty())
        return remark;
    return "";
  });
  while (remove_if([&](const Attribute& attribute) -> std::string_view {
           const std::string& name = attribute.name;
           if (name == "TANGENT" && named(attributes, "NORMAL") == nullptr) return "without normals";
           const auto number = set_number(name);
           if (!number || *number == 0) return "";
           const std::string before = fmt::format("{}_{}", name.substr(0, name.find('_')), *number - 1);
           return named(attributes, before) == nullptr ? "without the set before" : "";
         }) != 0) {
  }
  return removed;
}

Attribute::Value neutral_value(std::string_view name) {
  if (name == "NORMAL") return {0, 0, 1, 0};
  return name == "TANGENT" ? Attribute::Value{1, 0, 0, 1} : Attribute::Value{};
}

std::string left_out_in_words(std::span<const std::string> names) {
  std::vector<std::string> words;
  for (const std::string& name : names) note(words, attribute_in_words(name));
  return fmt::format("{}", fmt::join(words, ", "));
}

void note(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

namespace {

std::array<std::uint64_t, 3> bits(const Point& p) {
  return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
          std::bit_cast<std::uint64_t>(p.z + 0.0)};
}

std::size_t repeated(std::span<const Point> points) {
  const std::vector<std::uint32_t> first = first_alike(points.size(), points);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (first[v] != v) ++count;
  return count;
}

}  // namespace

std::vector<std::uint32_t> first_alike(std::size_t count, std::span<const Point> points,
                                       std::span<const Attribute> attributes) {
  const auto compare = [&](std::uint32_t a, std::uint32_t b) {
    if (!points.empty()) {
      const auto one = bits(points[a]);
      const auto other = bits(points[b]);
      if (one != other) return one < other ? -1 : 1;
    }
    for (const Attribute& attribute : attributes) {
      const std::size_t size = attribute.value_bytes();
      if (const int order = std::memcmp(&attribute.bytes[a * size], &attribute.bytes[b * size], size); order != 0)
        return order;
    }
    return 0;
  };
  struct Entry {
    std::uint64_t x;  // most points differ in it already
    std::uint32_t vertex;
  };
  std::vector<Entry> order(count);
  for (std::uint32_t v = 0; v < count; ++v) order[v] = {points.empty() ? 0 : bits(points[v])[0], v};
  std::sort(order.begin(), order.end(), [&](const Entry& a, const Entry& b) {
    if (a.x != b.x) return a.x < b.x;
    const int other = compare(a.vertex, b.vertex);
    return other != 0 ? other < 0 : a.vertex < b.vertex;
  });
  std::vector<std::uint32_t> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t v = order[i].vertex;
    const bool same = i != 0 && order[i - 1].x == order[i].x && compare(order[i - 1].vertex, v) == 0;
    first[v] = same ? first[order[i - 1].vertex] : v;
  }
  return first;
}

std::vector<std::uint32_t> renumber(std::vector<std::uint32_t>& first) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    const bool is_first = first[v] == v;
    first[v] = is_first ? static_cast<std::uint32_t>(kept.size()) : first[first[v]];
    if (is_first) kept.push_back(v);
  }
  return kept;
}

void put_coordinates(std::string& text, const Point& p) {
  const char* between = "";
  for (const double c : {p.x, p.y, p.z}) {
    text += between;
    if (const auto brief = static_cast<float>(c); static_cast<double>(brief) == c)
      text += fmt::format("{}", brief);
    else
      text += fmt::format("{}", c);
    between = " ";
  }
}

Rounding rounding_of(std::span<const Point> points) {
  Rounding found;
  if (points.empty()) return found;
  std::vector<Point> rounded;
  rounded.reserve(points.size());
  Point low = points.front();
  Point high = low;
  for (const Point& p : points) {
    const Point& r = rounded.emplace_back(in_32_bits(p));
    found.largest = std::max({found.largest, std::abs(p.x - r.x), std::abs(p.y - r.y), std::abs(p.z - r.z)});
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  if (found.largest == 0) return found;
  found.coinciding = repeated(rounded) - repeated(points);
  const double size = std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
  found.matters = found.coinciding != 0 || found.largest > 1e-6 * size;
  return found;
}

}  // namespace restrip::tools
