#include "meshes/gltf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "meshes/little_endian.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t glb_header_bytes = 12;
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t binary_chunk = 0x004E4942;

/// Members of any number and name: exporters add their own.
constexpr JsonLimits json_limits{.deepest = 64, .most_values = 20'000'000, .strict = false};

constexpr bool is_index_type(std::uint64_t type) { return type == 5121 || type == 5123 || type == 5125; }

/// The type of the components of an accessor of positions, or of an attribute.
ComponentType type_of_values(const JsonValue& accessor, const char* what) {
  const std::uint64_t type = accessor["componentType"].whole();
  if (type < 5120 || type > 5126 || type == 5124 || type == 5125)
    accessor["componentType"].refuse(fmt::format("is {}, which is not a type of {}", type, what));
  return ComponentType{static_cast<unsigned>(type)};
}

ComponentType type_of_indices(const JsonValue& accessor) {
  const std::uint64_t type = accessor["componentType"].whole();
  if (!is_index_type(type))
    accessor["componentType"].refuse(fmt::format("is {}, which is not a type of an index (5121, 5123 or 5125)", type));
  return ComponentType{static_cast<unsigned>(type)};
}

unsigned digit_of(char c, std::string_view digits) { return static_cast<unsigned>(digits.find(c)); }

/// Empty if the text is not valid base64.
std::optional<std::string> from_base64(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  if (text.size() % 4 != 0) return std::nullopt;
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  unsigned known = 0;
  for (const char c : text) {
    const unsigned digit = digit_of(c, digits);
    if (digit >= digits.size()) return std::nullopt;
    bits = bits << 6U | digit;
    known += 6;
    if (known < 8) continue;
    known -= 8;
    bytes.push_back(static_cast<char>(bits >> known & 0xFFU));
  }
  return bytes;
}

/// Decodes %XX; another percent sign stays.
std::string percent_decoded(std::string_view text) {
  std::string plain;
  for (; !text.empty(); text.remove_prefix(1)) {
    const auto half = [&](std::size_t at) {
      const unsigned digit = at < text.size() ? digit_of(text[at], "0123456789abcdefABCDEF") : 99;
      return digit < 16 ? digit : digit - 6;
    };
    if (text[0] == '%' && half(1) < 16 && half(2) < 16) {
      plain.push_back(static_cast<char>(half(1) << 4U | half(2)));
      text.remove_prefix(2);
    } else {
      plain.push_back(text[0]);
    }
  }
  return plain;
}

/// Whether a path leads to a file in this folder or below, on every system.
bool is_below(std::string_view path) {
  if (path.empty() || path.ends_with('/') || path.find_first_of(std::string_view("\\:\0", 3)) != std::string_view::npos)
    return false;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string_view step = path.substr(at, end - at);
    if (step.empty() || step == "..") return false;
    at = end + 1;
  }
  return true;
}

/// Extensions that change neither what triangles are drawn nor where; their names begin so.
constexpr std::string_view harmless_extensions =
    "KHR_mesh_primitive_restart KHR_mesh_quantization EXT_mesh_manifold KHR_materials_ KHR_texture_ KHR_lights_ "
    "KHR_animation_pointer KHR_audio KHR_interactivity KHR_physics_ KHR_rigid_bodies KHR_implicit_shapes "
    "KHR_node_selectability KHR_node_hoverability KHR_techniques_webgl KHR_xmp KHR_environment_map EXT_texture_ "
    "EXT_lights_ EXT_materials_ EXT_mesh_features EXT_instance_features EXT_feature_metadata "
    "EXT_structural_metadata ADOBE_materials_ AGI_stk_metadata CESIUM_primitive_outline FB_ GODOT_single_root "
    "GRIFFEL_bim_data MSFT_audio_ MSFT_collision_ MSFT_packing_ MSFT_physics_ MSFT_texture_dds MPEG_material_ "
    "MPEG_texture_ NV_materials_ OMI_ VRM EXT_property_";

bool is_harmless(std::string_view extension) {
  TextCursor names(harmless_extensions);
  std::string_view begin = names.word();
  while (!begin.empty() && !extension.starts_with(begin)) begin = names.word();
  return !begin.empty();
}

}  // namespace

GltfFile::GltfFile(std::string_view bytes, const std::string& name, const ReadSibling& sibling)
    : name_(name), sibling_(sibling), file_bytes_(bytes.size()) {
  if (bytes.starts_with("glTF"))
    read_container(bytes);
  else
    json_ = parse_json(name, bytes, json_limits);
  const JsonValue version = root()["asset"]["version"];
  if (!version.text().starts_with("2."))
    version.refuse(fmt::format("is '{}'; only glTF 2 is read", version.text().substr(0, 40)));
  check_extensions();
}

void GltfFile::read_container(std::string_view bytes) {
  const auto refuse = [this](const std::string& why) {
    throw BadInput(fmt::format("{}: {}; is it complete?", name_, why));
  };
  if (bytes.size() < glb_header_bytes) refuse("ends inside its header");
  if (little_endian(bytes, 4) != 2)
    throw BadInput(fmt::format("{}: a GLB of version {}; only 2 is read", name_, little_endian(bytes, 4)));
  const std::size_t size = little_endian(bytes, 8);
  if (size != bytes.size()) refuse(fmt::format("says that it has {} bytes, and has {}", size, bytes.size()));
  bool has_json = false;
  for (std::size_t at = glb_header_bytes; at < bytes.size();) {
    if (bytes.size() - at < 8) refuse(fmt::format("ends inside the header of the chunk at byte {}", at));
    const std::size_t length = little_endian(bytes, at);
    const std::uint32_t kind = little_endian(bytes, at + 4);
    if (length > bytes.size() - at - 8)
      refuse(fmt::format("its chunk at byte {} has {} bytes, more than are left", at, length));
    const std::string_view chunk = bytes.substr(at + 8, length);
    if (!has_json) {
      if (kind != json_chunk) refuse("its first chunk is not JSON");
      JsonLimits limits = json_limits;
      limits.has_lines = false;
      json_ = parse_json(name_, chunk, limits);
      has_json = true;
    } else if (kind == binary_chunk && !has_binary_) {
      binary_ = chunk;
      has_binary_ = true;
    }
    at += 8 + length;
  }
  if (!has_json) refuse("has no JSON");
}

void GltfFile::check_extensions() const {
  const JsonValue required = root()["extensionsRequired"];
  for (std::size_t i = 0; i < required.size(); ++i) {
    const std::string extension = required.at(i).text();
    if (!is_harmless(extension))
      required.at(i).refuse(fmt::format("is {}, which may change the triangles and is not read; export without it",
                                        extension.substr(0, 60)));
  }
}

std::string GltfFile::load(const JsonValue& uri) const {
  const std::string_view text = uri.view();
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(',');
    const bool base64 = comma != std::string_view::npos && text.substr(0, comma).ends_with(";base64");
    std::optional<std::string> bytes;
    if (base64) bytes = from_base64(text.substr(comma + 1));
    if (!bytes) uri.refuse("is not base64; is it complete?");
    return *std::move(bytes);
  }
  const std::string file = percent_decoded(text);
  if (!is_below(file))
    uri.refuse(
        fmt::format("is '{}'; only a file in the same folder or below is read: put it there, and name it by the "
                    "path from there",
                    text.substr(0, 80)));
  return sibling_(file);
}

std::string_view GltfFile::buffer(std::uint64_t number) {
  const JsonValue about = root()["buffers"].at(number);
  const std::uint64_t length = about["byteLength"].whole();
  std::string_view bytes = binary_;
  if (about["uri"].there()) {
    loaded_.resize(root()["buffers"].size());  // resized once, since views of the buffers are kept
    std::string& loaded = loaded_[static_cast<std::size_t>(number)];
    if (loaded.empty()) loaded = load(about["uri"]);
    bytes = loaded;
  } else if (number != 0 || !has_binary_) {
    about.refuse("has neither a `uri` nor the chunk of a GLB");
  }
  if (length > bytes.size())
    about.refuse(fmt::format("has {} bytes of the {} that it says; is it complete?", bytes.size(), length));
  return bytes.substr(0, static_cast<std::size_t>(length));
}

void GltfFile::charge(std::uint64_t values) {
  charged_ += values;
  if (charged_ <= limit_) return;
  if (!all_loaded_) {  // large files may draw more
    all_loaded_ = true;
    std::uint64_t bytes = file_bytes_;
    for (std::size_t i = 0; i < root()["buffers"].size(); ++i)
      if (root()["buffers"].at(i)["uri"].there()) bytes += buffer(i).size();
    limit_ = std::max(limit_, most_gltf_values_per_byte * bytes);
  }
  if (charged_ > limit_)
    throw BadInput(
        fmt::format("{}: draws more than {} vertices and indices, the limit for a file of its size; export "
                    "its meshes once each",
                    name_, limit_));
}

double GltfFile::Elements::value(std::size_t element, std::size_t component) const {
  const unsigned width = width_of(type);
  return decoded(little_endian(bytes, element * stride + component * width, width), type);
}

std::string_view GltfFile::view(std::uint64_t number) {
  const JsonValue about = root()["bufferViews"].at(number);
  const std::string_view all = buffer(about["buffer"].whole());
  const std::uint64_t begin = about["byteOffset"].whole_or(0);
  const std::uint64_t length = about["byteLength"].whole();
  if (begin > all.size() || length > all.size() - begin)
    about.refuse("reaches beyond its buffer; is the file complete?");
  return all.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(length));
}

GltfFile::Elements GltfFile::elements(const JsonValue& from, ComponentType type, std::size_t components,
                                      std::size_t count) {
  const std::uint64_t number = from["bufferView"].whole();
  const JsonValue about = root()["bufferViews"].at(number);
  const std::string_view all = view(number);
  const std::size_t size = components * width_of(type);
  const std::uint64_t stride = about["byteStride"].whole_or(size);
  if (stride < size || stride > 252) about["byteStride"].refuse(fmt::format("is {}, not {} to 252", stride, size));
  const std::uint64_t offset = from["byteOffset"].whole_or(0);
  // Both are below 2^53 and a stride is small: the sum does not overflow.
  if (count != 0 && (offset > all.size() || (count - 1) * stride + size > all.size() - offset))
    from.refuse(fmt::format("has {} elements, which reach beyond its buffer view; is the file complete?", count));
  return {all.substr(static_cast<std::size_t>(std::min<std::uint64_t>(offset, all.size()))),
          static_cast<std::size_t>(stride), type};
}

template <class Value, class Read>
void GltfFile::fill(const JsonValue& accessor, ComponentType type, std::size_t components, std::vector<Value>& values,
                    Read&& read) {
  const std::uint64_t announced = accessor["count"].whole();
  // Elements without a buffer are zero and take no bytes.
  if (!accessor["bufferView"].there() && announced > file_bytes_)
    accessor.refuse(
        fmt::format("has {} elements, more than the {} bytes of the file can mean", announced, file_bytes_));
  constexpr std::uint64_t most =
      std::min<std::uint64_t>(std::uint64_t{1} << 40U, std::numeric_limits<std::ptrdiff_t>::max());
  if (announced > most) accessor["count"].refuse("is too large");
  const auto count = static_cast<std::size_t>(announced);
  charge(count);
  if (accessor["bufferView"].there()) {
    const Elements all = elements(accessor, type, components, count);
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) values.push_back(read(all, i));
  } else {
    values.resize(count);
  }
  const JsonValue sparse = accessor["sparse"];
  if (!sparse.there()) return;
  if (sparse["count"].whole() > count)
    sparse["count"].refuse(fmt::format("is {}, more than the accessor has", sparse["count"].whole()));
  const auto replaced = static_cast<std::size_t>(sparse["count"].whole());
  const JsonValue places = sparse["indices"];
  const std::uint64_t place_type = places["componentType"].whole();
  if (!is_index_type(place_type)) places["componentType"].refuse("is not a type of an index (5121, 5123 or 5125)");
  const Elements at = elements(places, ComponentType{static_cast<unsigned>(place_type)}, 1, replaced);
  const Elements others = elements(sparse["values"], type, components, replaced);
  std::size_t least = 0;
  for (std::size_t i = 0; i < replaced; ++i) {
    const auto element = static_cast<std::size_t>(at.value(i, 0));
    if (element < least || element >= count)
      places.refuse(fmt::format("has {} as its number {}; they must increase and be below {}", element, i, count));
    values[element] = read(others, i);
    least = element + 1;
  }
}

std::vector<Point> GltfFile::positions(std::uint64_t number) {
  const JsonValue about = accessor(number);
  if (about["type"].text() != "VEC3") about["type"].refuse("is not VEC3, as positions are");
  const ComponentType type = type_of_values(about, "positions");
  // KHR_mesh_quantization: integers, normalised or not.
  const bool normalized = about["normalized"].truth_or(false) && type != ComponentType::real;
  std::vector<Point> points;
  fill(about, type, 3, points, [&](const Elements& from, std::size_t at) {
    const auto coordinate = [&](std::size_t axis) {
      const double stored = from.value(at, axis);
      return static_cast<float>(normalized ? fraction(stored, type) : stored);
    };
    return Point{coordinate(0), coordinate(1), coordinate(2)};
  });
  return points;
}

std::optional<Attribute> GltfFile::attribute(std::uint64_t number, const std::string& name) {
  const JsonValue about = accessor(number);
  const std::string shape = about["type"].text();
  constexpr std::array<std::string_view, 4> shapes{"SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto found = std::find(shapes.begin(), shapes.end(), shape);
  const bool is_own = name.starts_with('_');
  const bool is_known = name == "NORMAL" || name == "TANGENT" || set_number(name).has_value();
  if (!is_known && (!is_own || found == shapes.end())) return std::nullopt;
  const auto components = static_cast<unsigned>(found - shapes.begin()) + 1;
  if (name == "NORMAL" && components != 3) about["type"].refuse("is not VEC3, as normals are");
  if (name == "TANGENT" && components != 4) about["type"].refuse("is not VEC4, as tangents are");
  if (name.starts_with("TEXCOORD_") && components != 2) about["type"].refuse("is not VEC2, as texture coordinates are");
  if (name.starts_with("COLOR_") && components != 3 && components != 4)
    about["type"].refuse("is neither VEC3 nor VEC4, as colours are");
  const ComponentType type = type_of_values(about, "an attribute");
  const bool normalized = about["normalized"].truth_or(false) && type != ComponentType::real;
  const bool has_fractions = (type == ComponentType::unsigned_byte || type == ComponentType::unsigned_short) &&
                             normalized && name != "NORMAL" && name != "TANGENT";
  const bool as_it_is = type == ComponentType::real || is_own || has_fractions;
  Attribute made{name, as_it_is ? type : ComponentType::real, components, normalized && as_it_is};
  std::vector<Attribute::Value> values;
  fill(about, type, components, values, [&](const Elements& from, std::size_t at) {
    Attribute::Value value{};
    for (unsigned c = 0; c < components; ++c) value[c] = from.value(at, c);
    for (double& component : value)
      if (normalized && !as_it_is) component = fraction(component, type);
    return value;
  });
  made.bytes.reserve(values.size() * made.value_bytes());
  for (const Attribute::Value& value : values) made.append(value);
  return made;
}

std::vector<std::uint32_t> GltfFile::indices(std::uint64_t number, bool restarts) {
  const JsonValue about = accessor(number);
  if (about["type"].text() != "SCALAR") about["type"].refuse("is not SCALAR, as indices are");
  const ComponentType type = type_of_indices(about);
  const std::uint32_t restart = 0xFFFF'FFFFU >> (32 - 8 * width_of(type));
  std::vector<std::uint32_t> indices;
  fill(about, type, 1, indices, [&](const Elements& from, std::size_t at) {
    const auto index = static_cast<std::uint32_t>(from.value(at, 0));
    return restarts && index == restart ? strip_end : index;
  });
  return indices;
}

std::vector<Corners> GltfFile::triples(std::uint64_t number) {
  const JsonValue about = accessor(number);
  if (about["type"].text() != "VEC3") about["type"].refuse("is not VEC3, as three indices are");
  const ComponentType type = type_of_indices(about);
  std::vector<Corners> triples;
  fill(about, type, 3, triples, [](const Elements& from, std::size_t at) {
    const auto index = [&](std::size_t component) { return static_cast<std::uint32_t>(from.value(at, component)); };
    return Corners{index(0), index(1), index(2)};
  });
  return triples;
}

}  // namespace restrip::tools
