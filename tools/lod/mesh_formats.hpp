// The formats of mesh files: one table of what each can read and write. README has the same table, and a test compares
// the two. Everything here works on bytes; mesh_files.hpp opens files.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lod/baked_file.hpp"
#include "lod/progressive_mesh.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup.hpp"
#include "meshes/strip_file.hpp"

namespace restrip::tools {

/// The content of a mesh file.
using ReadMesh = std::variant<Soup, ProgressiveMesh, BakedBytes>;

/// Parts of the file that are not in the mesh (Soup::left_out).
[[nodiscard]] inline const std::vector<std::string>& left_out_of(const ReadMesh& mesh) {
  return std::visit([](const auto& kind) -> const std::vector<std::string>& { return kind.left_out; }, mesh);
}

/// A null function means that the format does not support it.
struct MeshFormat {
  std::string_view extension;  ///< in lower case, with its dot
  /// Whether a file is of this format, by its bytes and its first word.
  bool (*recognises)(std::string_view bytes, std::string_view word) = nullptr;
  ReadMesh (*read)(std::string_view bytes, const std::string& name, const ReadSibling& sibling,
                   ReadAttributes attributes) = nullptr;
  std::string (*write_mesh)(const Soup& mesh) = nullptr;
  /// Throws BadInput if the format cannot hold the mesh: glTF and the lists of PLY hold fewer than 2^31 values, and
  /// glTF cannot hold a mesh without triangles. written_strips() below makes the buffer.
  std::string (*write_strips)(const StripFile& strips) = nullptr;
  /// Used for a .glb on request. Throws BadInput if the format has no record for a split.
  std::string (*write_progressive)(const ProgressiveMesh& mesh) = nullptr;
  /// Writes a baked mesh, given as bytes.
  WrittenStrips (*write_baked)(std::string_view baked, const StripOptions& options) = nullptr;
  enum class Attributes { none, usual, all } attributes = Attributes::none;  ///< usual: the attributes of OBJ and PLY
  std::string_view strips_as = {};  ///< how strips are written, if the extension does not show it
  bool holds_strips = false;        ///< otherwise their triangles are written
  StripForm usual_form = StripForm::restart;
  bool forms = false;   ///< StripOptions apply; otherwise strips have the usual form and 32 bits
  bool rounds = false;  ///< rounds coordinates to 32 bits

  /// Whether a file can hold this attribute.
  [[nodiscard]] bool holds(const Attribute& attribute) const;
};

[[nodiscard]] std::span<const MeshFormat> mesh_formats();
/// The format of this extension (in lower case), or nullptr.
[[nodiscard]] const MeshFormat* format_named(std::string_view extension);

/// A predicate on what a format supports.
using FormatCan = bool (*)(const MeshFormat&);
inline constexpr FormatCan reads = [](const MeshFormat& format) { return format.read != nullptr; };
inline constexpr FormatCan writes_mesh = [](const MeshFormat& format) { return format.write_mesh != nullptr; };
inline constexpr FormatCan writes_strips = [](const MeshFormat& format) { return format.write_strips != nullptr; };
inline constexpr FormatCan writes_baked = [](const MeshFormat& format) { return format.write_baked != nullptr; };
/// Writes a mesh alone, its strips, or all its levels.
inline constexpr FormatCan writes_any = [](const MeshFormat& format) {
  return writes_mesh(format) || writes_strips(format) || writes_baked(format) || format.write_progressive != nullptr;
};
inline constexpr FormatCan writes_strips_or_progressive = [](const MeshFormat& format) {
  return writes_strips(format) || format.write_progressive != nullptr;
};
/// In the order of the table.
[[nodiscard]] std::vector<std::string> extensions_of(FormatCan can);

/// Throws BadInput if no format with this extension can be read, and whatever its reader throws. `name` is for
/// messages.
[[nodiscard]] ReadMesh parse_mesh(std::string_view bytes, std::string_view extension, const std::string& name,
                                  const ReadSibling& sibling, ReadAttributes attributes = ReadAttributes::no);

/// The mesh, or the finest level of a progressive or baked one; of a baked one with its strips. Throws BadInput at a
/// split that is not possible. Linear in the triangles and in the valences of the split vertices.
[[nodiscard]] Soup finest_level(ReadMesh mesh);
[[nodiscard]] Soup finest_level(const ProgressiveMesh& mesh);

/// The file for strips with strip_end between them. A list is written instead if it has fewer indices. Throws BadInput
/// as the format does, and if 16-bit indices are requested and do not suffice.
[[nodiscard]] WrittenStrips written_strips(const MeshFormat& format, std::span<const Point> points,
                                           std::span<const std::uint32_t> indices, const StripOptions& options = {},
                                           std::span<const Attribute> attributes = {}, bool is_64_bits = false);

}  // namespace restrip::tools
