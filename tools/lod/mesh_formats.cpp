#include "lod/mesh_formats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "formats/baked_format.hpp"
#include "lod/baked_file.hpp"
#include "lod/coloring_check.hpp"
#include "lod/pm_file.hpp"
#include "meshes/text_cursor.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {

// The readers of meshes/read_NAME.cpp. `name` is for messages.
// NOLINTBEGIN(readability-redundant-declaration): of sources that are checked as one, some follow the readers
Soup read_obj(std::string_view bytes, const std::string& name, ReadAttributes attributes);
Soup read_off(std::string_view bytes, const std::string& name);
Soup read_ply(std::string_view bytes, const std::string& name, ReadAttributes attributes);
/// Merges corners at exactly the same position, because STL has no indices.
Soup read_stl(std::string_view bytes, const std::string& name);
// NOLINTEND(readability-redundant-declaration)

namespace {

/// A reader that needs no other file, and perhaps reads no attributes.
template <auto read>
ReadMesh read_alone(std::string_view bytes, const std::string& name, const ReadSibling& /*sibling*/,
                    [[maybe_unused]] ReadAttributes attributes) {
  if constexpr (requires { read(bytes, name, attributes); })
    return read(bytes, name, attributes);
  else
    return read(bytes, name);
}

ReadMesh read_any_gltf(std::string_view bytes, const std::string& name, const ReadSibling& sibling,
                       ReadAttributes attributes) {
  if (auto baked = parse_baked_gltf(bytes, name, sibling)) return *std::move(baked);
  if (auto progressive = parse_progressive_gltf(bytes, name, sibling)) return *std::move(progressive);
  return read_gltf(bytes, name, sibling, attributes);
}

BakedBytes read_baked_mesh(std::string_view bytes, const std::string& name) {
  return {std::string(bytes), parse_baked(bytes, name), {}};
}

Soup soup_of(const StripFile& file) {
  Soup soup;
  soup.points.assign(file.points.begin(), file.points.end());
  soup.triangles.assign(file.triangles.begin(), file.triangles.end());
  soup.attributes.assign(file.attributes.begin(), file.attributes.end());
  soup.is_64_bits = file.is_64_bits;
  return soup;
}

std::string ply_of_strips(const StripFile& file) {
  if (file.buffer.form != StripForm::list)
    return ply_bytes(file.points, file.is_64_bits, file.attributes,
                     std::get<std::vector<std::uint32_t>>(file.buffer.indices));
  return ply_bytes(soup_of(file));
}

// How files are recognised.
constexpr auto begins_with_obj_line = [](std::string_view /*bytes*/, std::string_view word) {
  constexpr std::array lines{"v", "vt", "vn", "vp", "f", "fo", "o", "g", "s", "l", "p", "mtllib", "usemtl"};
  return std::find(lines.begin(), lines.end(), word) != lines.end();
};
constexpr auto begins_with_off = [](std::string_view /*bytes*/, std::string_view word) {
  const std::size_t off = word.find("OFF");
  return off != std::string_view::npos && word.substr(0, off).find_first_not_of("STCN4n") == std::string_view::npos;
};
constexpr auto is_stl = [](std::string_view bytes, std::string_view word) {
  return is_binary_stl(bytes) || word == "solid" || word == "SOLID";
};
constexpr auto is_pm = [](std::string_view bytes, std::string_view /*word*/) {
  return bytes.starts_with("ProgMesh") || is_hoppe_pm(bytes);
};

/// In the order in which help and messages list them.
constexpr std::array all_formats{
    MeshFormat{.extension = ".obj",
               .recognises = begins_with_obj_line,
               .read = read_alone<read_obj>,
               .write_mesh = obj_bytes,
               .write_strips = [](const StripFile& file) { return obj_bytes(soup_of(file)); },
               .attributes = MeshFormat::Attributes::usual,
               .strips_as = "triangles in their order"},
    MeshFormat{
        .extension = ".off", .recognises = begins_with_off, .read = read_alone<read_off>, .write_mesh = off_bytes},
    MeshFormat{.extension = ".ply",
               .recognises = [](std::string_view /*bytes*/, std::string_view word) { return word == "ply"; },
               .read = read_alone<read_ply>,
               .write_mesh = ply_bytes,
               .write_strips = ply_of_strips,
               .attributes = MeshFormat::Attributes::usual,
               .strips_as = "tristrips",
               .holds_strips = true},
    MeshFormat{.extension = ".stl",
               .recognises = is_stl,
               .read = read_alone<read_stl>,
               .write_mesh = stl_bytes,
               .rounds = true},
    MeshFormat{.extension = ".gltf",
               .recognises = [](std::string_view /*bytes*/, std::string_view word) { return word.starts_with('{'); },
               .read = read_any_gltf},
    MeshFormat{
        .extension = ".glb",
        .recognises = [](std::string_view bytes, std::string_view /*word*/) { return bytes.starts_with("glTF"); },
        .read = read_any_gltf,
        .write_strips = [](const StripFile& file) { return glb_bytes(file); },
        .write_progressive = progressive_glb_bytes,
        .write_baked = baked_glb_bytes,
        .attributes = MeshFormat::Attributes::all,
        .holds_strips = true,
        .usual_form = StripForm::stitched,
        .forms = true,
        .rounds = true},
    MeshFormat{.extension = ".pm",
               .recognises = is_pm,
               .read = read_alone<parse_pm>,
               .write_progressive = pm_bytes,
               .rounds = true},
    MeshFormat{.extension = ".baked",
               .recognises = [](std::string_view bytes,
                                std::string_view /*word*/) { return bytes.starts_with(baked_format::magic); },
               .read = read_alone<read_baked_mesh>,
               .write_baked = [](std::string_view baked, const StripOptions&) -> WrittenStrips {
                 return {.bytes = std::string(baked)};
               },
               .rounds = true},
    MeshFormat{.extension = ".bin",
               .write_strips = [](const StripFile& file) { return bin_bytes(file.buffer, file.in_batches); },
               .strips_as = "the index buffer alone",
               .holds_strips = true,
               .forms = true},
};

/// A picture, which visitors drop on the viewer; by its name, or without one by how it begins.
bool is_picture(std::string_view bytes, std::string_view extension) {
  constexpr std::array<std::string_view, 9> names{".png", ".jpg", ".jpeg", ".gif", ".webp",
                                                  ".bmp", ".tif", ".tiff", ".heic"};
  if (!extension.empty()) return std::find(names.begin(), names.end(), extension) != names.end();
  constexpr std::array<std::string_view, 3> begins{"\x89PNG", "\xff\xd8\xff", "GIF8"};
  return std::any_of(begins.begin(), begins.end(), [&](std::string_view begin) { return bytes.starts_with(begin); }) ||
         (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP"));
}

/// The format of a file, or nullptr.
const MeshFormat* format_of(std::string_view bytes) {
  // The header of a binary STL may begin with any word.
  const std::string_view word = is_binary_stl(bytes) ? "" : TextCursor(bytes).word_on_any_line();
  const auto found = std::find_if(all_formats.begin(), all_formats.end(), [&](const MeshFormat& format) {
    return format.recognises != nullptr && format.recognises(bytes, word);
  });
  return found == all_formats.end() ? nullptr : &*found;
}

/// The finest level with its strips. The triangles are in strip order.
Soup finest_level(const BakedBytes& found) {
  const BakedMesh& baked = found.baked;
  StripMesh mesh = baked.base;
  // Reading has already played all records once.
  for (std::size_t i = 0; i < baked.mesh.splits.size(); ++i)
    split_baked(mesh, spokes_of(mesh, baked.mesh.splits[i]), baked.records[i], baked.mesh.splits[i].v_t);
  Soup soup;
  soup.points = baked.mesh.points;
  soup.strips = strip_indices(mesh);
  soup.triangles = decode_strips(soup.strips);
  soup.left_out = found.left_out;
  if (baked.payload.bytes != 0) soup.left_out.emplace_back("payload");
  return soup;
}

}  // namespace

bool MeshFormat::holds(const Attribute& attribute) const {
  const std::string& name = attribute.name;
  return attributes == Attributes::all ||
         (attributes == Attributes::usual && (name == "NORMAL" || name == "TEXCOORD_0" || name == "COLOR_0"));
}

std::span<const MeshFormat> mesh_formats() { return all_formats; }

const MeshFormat* format_named(std::string_view extension) {
  const auto found = std::find_if(all_formats.begin(), all_formats.end(),
                                  [&](const MeshFormat& format) { return format.extension == extension; });
  return found == all_formats.end() ? nullptr : &*found;
}

std::vector<std::string> extensions_of(FormatCan can) {
  std::vector<std::string> extensions;
  for (const MeshFormat& format : all_formats)
    if (can(format)) extensions.emplace_back(format.extension);
  return extensions;
}

ReadMesh parse_mesh(std::string_view bytes, std::string_view extension, const std::string& name,
                    const ReadSibling& sibling, ReadAttributes attributes) {
  const MeshFormat* format = extension.empty() ? format_of(bytes) : format_named(extension);
  if (!extension.empty() && format != nullptr && !reads(*format))
    throw BadInput(fmt::format("{}: a {} file is only written, not read: it has no vertex positions; give the mesh",
                               name, extension));
  if (format == nullptr && is_picture(bytes, extension))
    throw BadInput(fmt::format("{}: a picture, which has no triangles; give a mesh: {}", name,
                               fmt::join(extensions_of(reads), ", ")));
  if (!extension.empty() && format == nullptr)
    throw BadInput(fmt::format("{}: unknown extension '{}'; name the format by --from: {}", name, extension,
                               fmt::join(extensions_of(reads), ", ")));
  if (bytes.empty()) throw BadInput(fmt::format("{}: the file is empty", name));
  if (format == nullptr)
    throw BadInput(fmt::format("{}: neither its name nor how it begins says what it is; name the format by --from: {}",
                               name, fmt::join(extensions_of(reads), ", ")));
  return format->read(bytes, name, sibling, attributes);
}

Soup finest_level(const ProgressiveMesh& source) {
  StripMesh mesh = StripMesh::build(source.base, source.points.size());
  for (std::size_t i = 0; i < source.splits.size(); ++i) {
    const auto where = possible_split(mesh, source, i);
    mesh.insert_vertex(where, source.splits[i].v_t);
  }
  Soup soup;
  soup.points = source.points;
  soup.left_out = source.left_out;
  soup.triangles = corners_of(mesh);
  return soup;
}

Soup finest_level(ReadMesh mesh) {
  if (auto* soup = std::get_if<Soup>(&mesh)) return std::move(*soup);
  if (const auto* progressive = std::get_if<ProgressiveMesh>(&mesh)) return finest_level(*progressive);
  return finest_level(std::get<BakedBytes>(mesh));
}

WrittenStrips written_strips(const MeshFormat& format, std::span<const Point> points,
                             std::span<const std::uint32_t> indices, const StripOptions& options,
                             std::span<const Attribute> attributes, bool is_64_bits) {
  WrittenStrips written;
  StripOptions fixed{StripForm::restart, IndexWidth::bits32};
  fixed.keep_strips = options.keep_strips;
  const IndexBuffer buffer = format_as(format.forms ? options : fixed, format.usual_form, indices, written);
  const std::vector<Corners> drawn = decode_strips(indices);
  written.bytes = format.write_strips({points, buffer, drawn, attributes,
                                       format.forms && options.most_vertices + options.most_indices != 0, is_64_bits});
  if (!format.forms && buffer.form != StripForm::list) written.index_bits = 0;  // a list without a choice of form
  if (format.usual_form == StripForm::stitched && restarts(buffer))
    written.required_extensions = {std::string(restart_extension)};
  return written;
}

}  // namespace restrip::tools
