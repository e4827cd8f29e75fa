// Baked meshes in glTF files (baked_file.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/bad_input.hpp"
#include "lod/baked_file.hpp"
#include "meshes/gltf_file.hpp"
#include "meshes/write_glb.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

std::span<const Point> points_of_base(const ProgressiveMesh& mesh) {
  return std::span(mesh.points).first(mesh.points.size() - mesh.splits.size());
}

std::vector<Corners> in_order(std::span<const Corners> triangles) {
  std::vector<Corners> made;
  made.reserve(triangles.size());
  for (const Corners& t : triangles) made.push_back(rotated(t));
  std::sort(made.begin(), made.end());
  return made;
}

}  // namespace

WrittenStrips baked_glb_bytes(std::string_view baked, const StripOptions& options) {
  // The mesh as a reader of the bytes sees it, so that bake and convert write the same file.
  const BakedMesh mesh = parse_baked(baked, "the baked mesh");
  WrittenStrips written;
  const IndexBuffer buffer = format_as(options, StripForm::stitched, strip_indices(mesh.base), written);
  written.bytes = glb_bytes({points_of_base(mesh.mesh), buffer, {}}, {baked_strips_extension, baked});
  if (restarts(buffer)) written.required_extensions = {std::string(restart_extension)};
  return written;
}

std::optional<BakedBytes> parse_baked_gltf(std::string_view bytes, const std::string& name,
                                           const ReadSibling& sibling) {
  // If the name does not occur, the file has no extension and need not be parsed.
  if (bytes.find(baked_strips_extension) == std::string_view::npos) return std::nullopt;
  GltfFile file(bytes, name, sibling);
  std::optional<JsonPlace> only;
  const JsonPlace meshes = file.root()["meshes"];
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const JsonPlace extension = meshes.at(i)["extensions"][baked_strips_extension];
    if (!extension.there()) continue;
    if (only) extension.refuse("is the second one; a file has one baked mesh");
    only = extension;
  }
  if (!only) return std::nullopt;
  BakedBytes found{std::string(file.view((*only)["bufferView"].whole())), {}, {}};
  found.baked = parse_baked(found.bytes, fmt::format("{}: the {} in it", name, baked_strips_extension));
  Soup drawn = read_gltf(bytes, name, sibling);
  const ProgressiveMesh& mesh = found.baked.mesh;
  const auto base = points_of_base(mesh);
  if (!std::equal(drawn.points.begin(), drawn.points.end(), base.begin(), base.end()) ||
      in_order(drawn.triangles) != in_order(mesh.base))
    throw BadInput(fmt::format(
        "{}: draws something other than the base of its {}, so the levels do not fit; remove the extension, "
        "or write the file again (restrip bake)",
        name, baked_strips_extension));
  found.left_out_attributes = std::move(drawn.left_out_attributes);
  return found;
}

}  // namespace restrip::tools
