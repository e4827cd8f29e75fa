// Reads PLY (the Stanford polygon format): text, little-endian and big-endian. Elements: `vertex` (x, y, z), `face` and
// `tristrips` (vertex_indices or vertex_index; in strips -1 begins the next one, signed or unsigned). Other elements
// and properties are skipped by their declared type, and reported. Supported attributes of vertices are nx ny nz, s t
// (or u v, texture_u texture_v), and red green blue alpha (or diffuse_red …).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "common/counted.hpp"
#include "common/printable.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

enum class Encoding { text, little_endian, big_endian };

struct Type {
  unsigned bytes = 0;
  enum class Kind { signed_integer, unsigned_integer, real } kind = Kind::real;
};

struct Property {
  std::string name;
  Type type;
  std::optional<Type> length;  ///< set for lists
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

std::optional<Type> type_named(std::string_view name) {
  using enum Type::Kind;
  if (name == "char" || name == "int8") return Type{1, signed_integer};
  if (name == "uchar" || name == "uint8") return Type{1, unsigned_integer};
  if (name == "short" || name == "int16") return Type{2, signed_integer};
  if (name == "ushort" || name == "uint16") return Type{2, unsigned_integer};
  if (name == "int" || name == "int32") return Type{4, signed_integer};
  if (name == "uint" || name == "uint32") return Type{4, unsigned_integer};
  if (name == "float" || name == "float32") return Type{4, real};
  if (name == "double" || name == "float64") return Type{8, real};
  return std::nullopt;
}

/// The vertex properties that form an attribute, the last of which may be missing, and the attribute's name in glTF.
struct AttributeProperties {
  const char* name;
  unsigned least;  // components
  std::array<std::string_view, 4> of_file;
};
constexpr AttributeProperties attribute_properties[]{
    {"NORMAL", 3, {"nx", "ny", "nz"}},
    {"TEXCOORD_0", 2, {"s", "t"}},
    {"TEXCOORD_0", 2, {"u", "v"}},
    {"TEXCOORD_0", 2, {"texture_u", "texture_v"}},
    {"COLOR_0", 3, {"red", "green", "blue", "alpha"}},
    {"COLOR_0", 3, {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}}};

/// The encoding of an attribute that the file stores in numbers of this type.
std::optional<ComponentType> carried_type(const Type& type, std::string_view name) {
  if (type.kind == Type::Kind::real) return ComponentType::real;
  if (type.kind == Type::Kind::signed_integer || type.bytes > 2 || name != "COLOR_0") return std::nullopt;
  return type.bytes == 1 ? ComponentType::unsigned_byte : ComponentType::unsigned_short;
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name, ReadAttributes attributes)
      : name_(name), cursor_(bytes), soup_(name), carry_(attributes == ReadAttributes::yes) {}

  Soup read() {
    read_header();
    if (encoding_ == Encoding::text) refuse_long_lines(bytes_, name_);
    for (const Element& element : elements_) {
      if (element.properties.empty()) continue;
      std::size_t least = 0;
      for (const Property& property : element.properties) least += least_bytes(property.length.value_or(property.type));
      if (element.count > room() / std::max<std::size_t>(least, 1))
        refuse(fmt::format("announces {} elements `{}`, more than its remaining {} bytes can hold; is it complete?",
                           element.count, element.name, room()));
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "tristrips")
        read_strips(element);
      else
        skip_all(element);
    }
    if (encoding_ != Encoding::text && !bytes_.empty())
      soup_.leave_out(fmt::format("{} after the last element", counted(bytes_.size(), "byte")));
    if (encoding_ == Encoding::text && !cursor_.word_on_any_line().empty())
      soup_.leave_out("text after the last element");
    return std::move(soup_).finish();
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw BadInput(fmt::format("{}: {}", name_, why)); }
  [[noreturn]] void refuse_header(const std::string& why) const {
    throw BadInput(fmt::format("{}:{}: {}", name_, cursor_.line(), why));
  }
  [[noreturn]] void refuse_truncated(const std::string& where) const {
    refuse(fmt::format("ends among the {}; is it complete?", where));
  }

  // ---- the header
  void read_header() {
    if (cursor_.word() != "ply") refuse("does not begin with `ply`");
    // If lines end with CR only, the header also ends with CR: the body may begin with the byte of LF.
    const bool ends_with_cr = cursor_.rest().starts_with('\r') && !cursor_.rest().starts_with("\r\n");
    bool format_known = false;
    for (cursor_.next_line();; cursor_.next_line()) {
      if (cursor_.at_end()) refuse("ends before `end_header`; is it complete?");
      const std::string_view keyword = cursor_.word();
      if (keyword == "format") {
        const std::string_view format = cursor_.word();
        if (format == "ascii")
          encoding_ = Encoding::text;
        else if (format == "binary_little_endian")
          encoding_ = Encoding::little_endian;
        else if (format == "binary_big_endian")
          encoding_ = Encoding::big_endian;
        else
          refuse_header(fmt::format("unknown format '{}'", format.substr(0, 40)));
        format_known = true;
      } else if (keyword == "element") {
        Element element{std::string(cursor_.word()), 0, {}};
        const auto count = parse<std::uint64_t>(cursor_.word());
        if (!count) refuse_header("an element without a count");
        element.count = *count;
        elements_.push_back(std::move(element));
      } else if (keyword == "property") {
        if (elements_.empty()) refuse_header("a property before any element");
        elements_.back().properties.push_back(read_property());
      } else if (keyword == "end_header") {
        break;
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        refuse_header(fmt::format("unknown keyword '{}'", keyword.substr(0, 40)));
      }
    }
    const std::string_view end = cursor_.rest();
    cursor_.next_line();
    bytes_ = ends_with_cr && end.starts_with('\r') ? end.substr(1) : cursor_.rest();
    if (!format_known) refuse("its header has no `format` line");
  }

  Property read_property() {
    Property property;
    std::string_view word = cursor_.word();
    const auto type = [&] {
      const auto known = type_named(word);
      if (!known) refuse_header(fmt::format("unknown type '{}'", word.substr(0, 40)));
      return *known;
    };
    if (word == "list") {
      word = cursor_.word();
      property.length = type();
      if (property.length->kind == Type::Kind::real) refuse_header("the length of a list must be an integer");
      word = cursor_.word();
    }
    property.type = type();
    property.name = cursor_.word();
    return property;
  }

  // ---- the values
  /// The minimum bytes of a value: two as text (the last value may lack its separator).
  [[nodiscard]] std::size_t least_bytes(const Type& type) const { return encoding_ == Encoding::text ? 2 : type.bytes; }

  /// The number of remaining bytes.
  [[nodiscard]] std::size_t room() const {
    return encoding_ == Encoding::text ? cursor_.rest().size() + 1 : bytes_.size();
  }

  double value(const Type& type, const std::string& where) {
    if (encoding_ == Encoding::text) {
      const std::string_view word = cursor_.word_on_any_line();
      if (word.empty()) refuse_truncated(where);
      const auto number = parse<double>(word);
      if (!number) refuse_header(fmt::format("'{}' is not a number", word.substr(0, 40)));
      return *number;
    }
    if (bytes_.size() < type.bytes) refuse_truncated(where);
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < type.bytes; ++i) {
      const unsigned at = encoding_ == Encoding::little_endian ? i : type.bytes - 1 - i;
      bits |= std::uint64_t{static_cast<unsigned char>(bytes_[at])} << (8 * i);
    }
    bytes_.remove_prefix(type.bytes);
    switch (type.kind) {
      case Type::Kind::real:
        return type.bytes == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits)) : std::bit_cast<double>(bits);
      case Type::Kind::signed_integer: {
        const auto magnitude = static_cast<double>(bits);
        const double half = std::ldexp(1.0, static_cast<int>(8 * type.bytes) - 1);
        return magnitude >= half ? magnitude - 2 * half : magnitude;
      }
      case Type::Kind::unsigned_integer:
        break;
    }
    return static_cast<double>(bits);
  }

  std::size_t length(const Property& list) {
    const double size = value(*list.length, "lists");
    const std::size_t longest = room() / least_bytes(list.type);
    if (!(size >= 0) || size > static_cast<double>(longest) || size != std::floor(size))
      refuse(fmt::format("a list `{}` of length {}, which the file cannot hold", list.name, size));
    return static_cast<std::size_t>(size);
  }

  void skip(const Property& property) {
    const std::size_t values = property.length ? length(property) : 1;
    for (std::size_t i = 0; i < values; ++i) value(property.type, "elements that are stepped over");
  }

  void skip_all(const Element& element) {
    if (element.count != 0) soup_.leave_out(fmt::format("elements `{}`", quoted(element.name)));
    for (std::size_t i = 0; i < element.count; ++i)
      for (const Property& property : element.properties) skip(property);
  }
  static std::string quoted(std::string_view name) { return files::printable_ascii(name.substr(0, 40)); }
  void leave_out(const Property& property, const Element& of) {
    if (of.count == 0) return;
    std::string what = fmt::format("property `{}`", quoted(property.name));
    for (const AttributeProperties& known : attribute_properties)
      if (std::find(known.of_file.begin(), known.of_file.end(), property.name) != known.of_file.end())
        what = left_out_in_words(std::array{std::string(known.name)});
    if (property.name == "texcoord") what = "texture coordinates";
    soup_.leave_out(fmt::format("{} of `{}`", what, quoted(of.name)));
  }

  void read_vertices(const Element& element) {
    if (soup_.point_count() != 0) {  // more vertices, which may have other attributes
      for (const Attribute& attribute : soup_.attributes()) soup_.leave_out(attribute.name);
      soup_.attributes().clear();
      carry_ = false;
    }
    std::array<double, 3> xyz{};
    const auto axis_of = [&](const Property& property) -> double* {
      if (property.length || property.name.size() != 1) return nullptr;
      const char letter = property.name.front();
      return letter >= 'x' && letter <= 'z' ? &xyz[static_cast<std::size_t>(letter - 'x')] : nullptr;
    };
    for (const char letter : {'x', 'y', 'z'})
      if (std::none_of(element.properties.begin(), element.properties.end(),
                       [&](const Property& property) { return property.name == std::string(1, letter); }))
        refuse(fmt::format("its vertices have no property `{}`", letter));
    for (const Property& property : element.properties)
      if (axis_of(property) != nullptr && property.type.bytes == 8) soup_.say_64_bits();
    const std::vector<Component> components = components_of(element);
    std::vector<Attribute>& attributes = soup_.attributes();
    std::vector<Attribute::Value> values(attributes.size());
    for (std::size_t i = 0; i < element.count; ++i) {
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (double* coordinate = axis_of(property))
          *coordinate = value(property.type, "vertices");
        else if (components[p].attribute != no_attribute)
          values[components[p].attribute][components[p].number] = value(property.type, "vertices");
        else
          skip(property);
      }
      soup_.add_point(xyz[0], xyz[1], xyz[2], encoding_ == Encoding::text ? cursor_.line() : 0);
      for (std::size_t a = 0; a < attributes.size(); ++a) append(attributes[a], values[a], i);
    }
  }

  /// The role of a vertex property.
  struct Component {
    std::size_t attribute = no_attribute;  // index in the soup
    unsigned number = 0;
  };
  static constexpr std::size_t no_attribute = ~std::size_t{0};

  /// The component for each property of the vertices. Creates the attributes or leaves them out.
  std::vector<Component> components_of(const Element& element) {
    std::vector<Component> components(element.properties.size());
    std::vector<Attribute>& made = soup_.attributes();
    std::vector<bool> is_reported(element.properties.size(), false);
    for (const auto& [name, least, of_file] : attribute_properties) {
      std::vector<std::size_t> found;
      for (const std::string_view wanted : of_file) {
        const auto property = std::find_if(element.properties.begin(), element.properties.end(),
                                           [&](const Property& one) { return one.name == wanted; });
        if (wanted.empty() || property == element.properties.end()) break;
        found.push_back(static_cast<std::size_t>(property - element.properties.begin()));
      }
      if (found.empty()) continue;
      const auto& first = element.properties[found[0]];
      const auto type = carried_type(first.type, name);
      const bool alike = std::all_of(found.begin(), found.end(), [&](std::size_t p) {
        const Property& one = element.properties[p];
        return !one.length && one.type.kind == first.type.kind && one.type.bytes == first.type.bytes;
      });
      for (const std::size_t p : found) is_reported[p] = true;
      if (!carry_ || found.size() < least || !type || !alike || named(made, name) != nullptr) {
        soup_.leave_out(name);
        continue;
      }
      for (unsigned c = 0; c < found.size(); ++c) components[found[c]] = {made.size(), c};
      made.push_back({name, *type, static_cast<unsigned>(found.size()), *type != ComponentType::real});
    }
    for (std::size_t p = 0; p < components.size(); ++p) {
      const Property& property = element.properties[p];
      const bool is_coordinate =
          !property.length && (property.name == "x" || property.name == "y" || property.name == "z");
      if (!is_coordinate && !is_reported[p]) leave_out(property, element);
    }
    return components;
  }

  void append(Attribute& attribute, Attribute::Value value, std::size_t vertex) {
    value = soup_.usable(value, vertex, attribute.name);
    if (attribute.type != ComponentType::real)
      for (unsigned c = 0; c < attribute.components; ++c)
        if (const double most = attribute.type == ComponentType::unsigned_byte ? 255 : 65535;
            !(value[c] >= 0) || value[c] > most || value[c] != std::floor(value[c]))
          refuse(
              fmt::format("vertex {} has a colour {}, which is not from 0 to {}; --no-attributes reads the mesh "
                          "without it",
                          vertex, value[c], most));
    if (attribute.name == "NORMAL") value = unit_normal(value);
    if (attribute.name == "TEXCOORD_0") value[1] = 1 - value[1];  // PLY counts from below
    attribute.append(value);
  }

  std::uint32_t corner_of(double index, const char* kind, std::size_t number) const {
    if (!(index >= 0) || index > static_cast<double>(max_vertices) || index != std::floor(index))
      refuse(fmt::format("{} {} has a corner {}, which is not a vertex", kind, number, index));
    return static_cast<std::uint32_t>(index);
  }

  static bool is_corners(const Property& property) {
    return property.length && (property.name == "vertex_indices" || property.name == "vertex_index");
  }
  /// Calls read(i, list) for each list of corners of element i, and leaves out the rest.
  template <class Read>
  void for_each_list(const Element& element, Read&& read) {
    for (const Property& property : element.properties)
      if (!is_corners(property)) leave_out(property, element);
    for (std::size_t i = 0; i < element.count; ++i)
      for (const Property& property : element.properties)
        if (is_corners(property))
          read(i, property);
        else
          skip(property);
  }

  void read_faces(const Element& element) {
    std::vector<std::uint32_t> corners;
    for_each_list(element, [&](std::size_t i, const Property& list) {
      corners.clear();
      for (std::size_t left = length(list); left > 0; --left)
        corners.push_back(corner_of(value(list.type, "faces"), "face", i));
      soup_.add_face(corners);
    });
  }

  void read_strips(const Element& element) {
    double vertices = 0;
    for (const Element& each : elements_)
      if (each.name == "vertex") vertices += static_cast<double>(each.count);
    std::vector<std::uint32_t> strip;
    const auto end_strip = [&] {
      soup_.add_strip(strip);
      strip.clear();
    };
    for_each_list(element, [&](std::size_t i, const Property& list) {
      for (std::size_t left = length(list); left > 0; --left) {
        const double index = value(list.type, "strips");
        const bool is_vertex = index >= 0 && index < vertices;
        if (index == -1 || (!is_vertex && index == std::ldexp(1.0, static_cast<int>(8 * list.type.bytes)) - 1))
          end_strip();
        else
          strip.push_back(corner_of(index, "strip list", i));
      }
      end_strip();
    });
  }

  const std::string& name_;
  TextCursor cursor_;
  std::string_view bytes_;  // unread bytes of a binary body
  Encoding encoding_ = Encoding::text;
  std::vector<Element> elements_;
  SoupBuilder soup_;
  bool carry_;
};

}  // namespace

Soup read_ply(std::string_view bytes, const std::string& name, ReadAttributes attributes) {
  return PlyReader(bytes, name, attributes).read();
}

}  // namespace restrip::tools
