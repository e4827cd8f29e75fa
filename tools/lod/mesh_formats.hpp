// The formats of mesh files: one table of what is read from each and what is written in it. README has the same table
// for people, and a test compares the two. Everything here works on bytes; mesh_files.hpp opens files.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lod/baked_gltf.hpp"
#include "lod/progressive_mesh.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup.hpp"
#include "meshes/strip_file.hpp"

namespace restrip::tools {

/// What the bytes of a mesh file turned out to be.
using ReadMesh = std::variant<Soup, ProgressiveMesh, BakedBytes>;

/// Functions that are null do what the format does not.
struct MeshFormat {
  std::string_view extension;  ///< in lower case, with its point
  ReadMesh (*read)(std::string_view bytes, const std::string& name, const ReadBeside& beside,
                   ReadAttributes attributes) = nullptr;
  std::string (*write_mesh)(const Soup& mesh) = nullptr;
  /// Throws BadInput where the format cannot hold the mesh: glTF and the lists of PLY have less than 2^31 values, and
  /// glTF no mesh without triangles. written_strips() below makes the buffer.
  std::string (*write_strips)(const StripFile& strips) = nullptr;
  /// A .glb has it where the user asks for it. Throws BadInput where the format has no record for a split.
  std::string (*write_progressive)(const ProgressiveMesh& mesh) = nullptr;
  /// Writes a baked mesh, given by its bytes.
  WrittenStrips (*write_baked)(std::string_view baked, const StripOptions& options) = nullptr;
  enum class Attributes { none, usual, all } attributes = Attributes::none;  ///< usual: those of OBJ and PLY
  std::string_view strips_as = {};  ///< how strips are written, where the extension alone does not say so
  bool holds_strips = false;        ///< else their triangles are written
  StripForm usual_form = StripForm::restart;
  bool forms = false;   ///< StripOptions leave a choice; else strips have the usual form and 32 bits
  bool rounds = false;  ///< coordinates to 32 bits

  /// Whether a file has such an attribute.
  [[nodiscard]] bool holds(const Attribute& attribute) const;
};

[[nodiscard]] std::span<const MeshFormat> mesh_formats();
/// Or nullptr. `extension` is in lower case.
[[nodiscard]] const MeshFormat* format_named(std::string_view extension);

/// The extension of the format that bytes are of, by how they begin; empty when that is not known. STL in binary is
/// told by its size.
[[nodiscard]] std::string_view extension_of_bytes(std::string_view bytes);

/// What a format may be asked for.
using FormatCan = bool (*)(const MeshFormat&);
inline constexpr FormatCan reads = [](const MeshFormat& format) { return format.read != nullptr; };
inline constexpr FormatCan writes_mesh = [](const MeshFormat& format) { return format.write_mesh != nullptr; };
inline constexpr FormatCan writes_strips = [](const MeshFormat& format) { return format.write_strips != nullptr; };
inline constexpr FormatCan writes_baked = [](const MeshFormat& format) { return format.write_baked != nullptr; };
/// A mesh alone, its strips or all its levels.
inline constexpr FormatCan writes_any = [](const MeshFormat& format) {
  return writes_mesh(format) || writes_strips(format) || writes_baked(format) || format.write_progressive != nullptr;
};
inline constexpr FormatCan writes_strips_or_progressive = [](const MeshFormat& format) {
  return writes_strips(format) || format.write_progressive != nullptr;
};
/// In the order of the table.
[[nodiscard]] std::vector<std::string> extensions_of(FormatCan can);

/// Throws BadInput when no format with this extension is read, and as its reader does. `name` is for messages.
[[nodiscard]] ReadMesh parse_mesh(std::string_view bytes, std::string_view extension, const std::string& name,
                                  const ReadBeside& beside, ReadAttributes attributes = ReadAttributes::no);

/// The mesh, or the finest level of a progressive or baked one; the latter with its strips. Throws BadInput at a split
/// that is not possible. Linear in the triangles, and in the valences of the vertices that are split.
[[nodiscard]] Soup finest_level(ReadMesh mesh);
[[nodiscard]] Soup finest_level(const ProgressiveMesh& mesh);

/// The bytes of a mesh, or of strips, in the format with this extension. Throws BadInput when none exists.
[[nodiscard]] std::string mesh_bytes(const Soup& soup, std::string_view extension);
[[nodiscard]] std::string strip_bytes(std::span<const Point> points, std::span<const std::uint32_t> indices,
                                      std::string_view extension, const StripOptions& options = {},
                                      std::span<const Attribute> attributes = {});
/// The file of strips with strip_end between them. A list takes their place when it has fewer indices. Throws BadInput
/// as the format does, and when 16 bits are wanted and do not suffice.
[[nodiscard]] WrittenStrips written_strips(const MeshFormat& format, std::span<const Point> points,
                                           std::span<const std::uint32_t> indices, const StripOptions& options = {},
                                           std::span<const Attribute> attributes = {}, bool is_64_bits = false);
/// A triangle list as indices of strips of one triangle each.
[[nodiscard]] std::vector<std::uint32_t> each_a_strip(std::span<const Corners> triangles);

}  // namespace restrip::tools
