// Strips in files: PLY with a `tristrips` element, binary glTF, OBJ, or the bare index buffer.
//
//   .ply  binary; one list of indices, -1 between strips, as Stanford's scans have it (Cyberware's `tristrips`); faces
//         if a list has fewer indices
//   .glb  glTF 2.0; a primitive for each batch, or for each strip of StripForm::lengths
//   .obj  the triangles in the order of the strips: OBJ knows no strips
//   .bin  little-endian: with limits of a batch the number of batches and how many indices each has; with
//         StripForm::lengths the number of strips and their lengths, 32 bits each; then the indices alone
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/soup.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strip_format.hpp"

namespace restrip::tools {

/// How strips are written, if the format leaves a choice.
struct StripOptions {
  std::optional<StripForm> form;  ///< none: the default of the format
  IndexWidth width = IndexWidth::automatic;
  std::size_t most_vertices = 0;  ///< of a batch, as in StripFormat
  std::size_t most_indices = 0;
  bool keep_strips = false;  ///< strips even if a list has fewer indices
  std::string file = {};     ///< its name, for messages
};

/// An index buffer of strips and what it draws.
struct StripFile {
  std::span<const Point> points;
  const IndexBuffer& buffer;
  std::span<const Corners> triangles;  ///< the triangles drawn, in order
  /// Attributes of the points. A format stores the ones for which MeshFormat::holds() (lod/mesh_formats.hpp) is true.
  std::span<const Attribute> attributes = {};
  bool in_batches = false;  ///< a batch limit was given
  bool is_64_bits = false;  ///< as in Soup
};

/// The bytes of a file of strips, and their statistics.
struct WrittenStrips {
  std::string bytes;
  StripForm form = StripForm::restart;
  std::optional<StripForm> wanted = {};  ///< set if a list with fewer indices was written instead
  std::size_t index_bits = 0;            ///< 0 if the format has no index buffer
  std::size_t indices = 0;
  std::size_t batches = 0;
  std::size_t strips = 0;                             ///< 0 for a list
  std::vector<std::string> required_extensions = {};  ///< extensions that a viewer must support
};

/// Converts the indices, with strip_end between strips, to that form and fills in `written`. Throws BadInput, which
/// names options.file, if 16-bit indices are requested and do not suffice.
[[nodiscard]] IndexBuffer format_as(const StripOptions& options, StripForm usual,
                                    std::span<const std::uint32_t> indices, WrittenStrips& written);
[[nodiscard]] std::string_view name_of(StripForm form) noexcept;
/// The tables and indices of a .bin file.
[[nodiscard]] std::string bin_bytes(const IndexBuffer& buffer, bool in_batches);
/// Report lines about the file of this name.
[[nodiscard]] std::string as_text(const WrittenStrips& written, const std::string& name);
void add_to(nlohmann::ordered_json& json, const WrittenStrips& written);

struct FileStrips {
  std::size_t solid = 0;  ///< dual edges that became solid
  std::size_t cut = 0;    ///< places within a strip at which consecutive triangles share no dual edge
};

/// Colours a mesh built from the soup according to the strips of its file: consecutive triangles of a strip are joined
/// if they share a dual edge. They do not if the mesh is not manifold or not oriented there. Two or more degenerate
/// triangles in a row stitch strips together, so another strip begins. `origin` is the array from StripMesh::build. All
/// dual edges must be dashed; the colouring is valid afterwards. Linear time.
FileStrips color_as_in_file(StripMesh& mesh, const Soup& soup, std::span<const std::uint32_t> origin);

// ---- binary glTF 2.0, written directly: points, attributes and one kind of primitives

/// Required if a primitive contains several strips.
inline constexpr std::string_view restart_extension = "KHR_mesh_primitive_restart";

/// Whether a primitive contains several strips.
[[nodiscard]] bool restarts(const IndexBuffer& buffer);

/// Further data about the mesh, which viewers may ignore: bytes in a separate buffer view. The mesh has `"extensions":
/// {name: {"bufferView": number}}`.
struct GlbExtension {
  std::string_view name;  ///< empty: no extension
  std::string_view bytes;
};

/// A GLB of these two chunks. Throws BadInput if they are too large.
[[nodiscard]] std::string glb_of_chunks(std::string json, std::string binary);
/// The least and the greatest coordinates, in the form of an accessor.
[[nodiscard]] std::string bounds_of(std::span<const Point> points);

/// Throws BadInput if a GLB cannot hold the mesh.
[[nodiscard]] std::string glb_bytes(const StripFile& file, const GlbExtension& extension = {});

}  // namespace restrip::tools
