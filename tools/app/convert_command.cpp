// `restrip convert`: any mesh in, any format out, as it is.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/source.hpp"
#include "common/bad_input.hpp"
#include "common/report_output.hpp"
#include "files/output.hpp"
#include "files/reading.hpp"
#include "lod/baked_file.hpp"
#include "lod/baked_gltf.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/strip_file.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

/// What is written of a mesh, and what of it the format left out.
struct Converted {
  std::string bytes;
  std::size_t strips = 0;
  std::size_t left_out = 0;
  std::vector<std::string> required_extensions = {};
};

Converted converted(const Soup& soup, const ConvertCommand& command) {
  const std::string extension = files::extension_of(command.out);
  const bool holds_strips = extension == ".glb" || extension == ".bin" || (extension == ".ply" && !soup.strips.empty());
  if (!holds_strips) return {mesh_bytes(soup, extension), 0, 0};
  GltfPrimitives primitives = command.gltf;
  if (soup.strips.empty()) {
    if (extension == ".bin" || (command.gltf_given && primitives != GltfPrimitives::list))
      throw BadInput(
          fmt::format("{}: has no strips; restrip stripify makes some and writes them", command.mesh.string()));
    primitives = GltfPrimitives::list;
  }
  std::vector<Corners> drawn;
  std::copy_if(soup.triangles.begin(), soup.triangles.end(), std::back_inserter(drawn),
               [](const Corners& t) { return !degenerate(t); });
  const auto ends = std::count(soup.strips.begin(), soup.strips.end(), strip_end);
  const std::size_t strips =
      soup.strips.empty() || primitives == GltfPrimitives::list ? 0 : static_cast<std::size_t>(ends) + 1;
  return {strip_bytes({soup.points, soup.strips, drawn, soup.attributes}, extension, primitives), strips,
          soup.triangles.size() - drawn.size(), required_extensions(extension, primitives, strips)};
}

}  // namespace

std::vector<std::string> converted_extensions() {
  std::vector<std::string> all = written_mesh_extensions();
  for (const auto& more : {written_strip_extensions(), baked_extensions()})
    for (const std::string& extension : more)
      if (std::find(all.begin(), all.end(), extension) == all.end()) all.push_back(extension);
  return all;
}

namespace {

/// A baked mesh as it is, byte by byte, from one kind of file into the other.
int convert_baked(const ConvertCommand& command, const files::Output& out, const ReportOutput& report) {
  refuse_mending(command.mesh, command.mending);
  const std::string extension = files::extension_of(command.out);
  const auto extensions = baked_extensions();
  if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
    throw BadInput(
        fmt::format("{}: is a baked mesh, which {} holds; restrip replay with -o and --triangles writes one "
                    "level of it",
                    command.mesh.string(), fmt::join(extensions, " or ")));
  const BakedBytes found = read_baked_bytes(command.mesh);
  out.write(extension == ".glb" ? baked_glb_bytes(found.bytes, command.gltf) : found.bytes);
  const ProgressiveMesh& mesh = found.baked.mesh;
  const auto required = required_extensions(extension, command.gltf, count_strips(found.baked.base));
  nlohmann::ordered_json json{
      {"base_triangles", mesh.base.size()}, {"records", mesh.splits.size()}, {"triangles", mesh.fine_triangles()}};
  if (!required.empty()) json["required_extensions"] = required;
  report.print(fmt::format("{}: {} triangles and {} records to {}\n", command.out.string(), mesh.base.size(),
                           mesh.splits.size(), mesh.fine_triangles()) +
                   as_text(required, command.out.string()),
               json.dump(2) + "\n");
  return 0;
}

}  // namespace

int run(const ConvertCommand& command) {
  const files::Output out(command.out, {converted_extensions(), {command.mesh}});
  const ReportOutput report(command.json, {command.mesh, command.out});
  if (files::extension_of(command.out).empty())  // a device
    throw BadInput(fmt::format("{}: has no extension that names a format; name a file that ends in {}",
                               command.out.string(), fmt::join(converted_extensions(), ", ")));
  if (is_baked(command.mesh)) return convert_baked(command, out, report);
  if (is_progressive(command.mesh))
    throw BadInput(
        fmt::format("{}: is a progressive mesh; restrip replay with -o and --triangles writes one level of it",
                    command.mesh.string()));
  if (files::extension_of(command.out) == baked_extension)
    throw BadInput(fmt::format("{}: is no baked mesh; restrip bake makes one", command.mesh.string()));
  Mended mended;
  const Soup soup = read_mesh(command.mesh, command.mending, mended, command.attributes);
  leave_out_attributes(soup, files::extension_of(command.out), mended);
  const Converted made = converted(soup, command);
  out.write(made.bytes);
  nlohmann::ordered_json json{{"vertices", soup.points.size()},
                              {"triangles", soup.triangles.size() - made.left_out},
                              {"strips", made.strips},
                              {"left_out", made.left_out}};
  add_to(json, mended);
  std::string text = as_text(mended);
  text += fmt::format("{}: {} vertices, {} triangles", command.out.string(), soup.points.size(),
                      soup.triangles.size() - made.left_out);
  if (made.strips != 0) text += fmt::format(" in {} strips", made.strips);
  if (made.left_out != 0) text += fmt::format("; {} degenerate triangles left out", made.left_out);
  if (!made.required_extensions.empty()) json["required_extensions"] = made.required_extensions;
  report.print(text + "\n" + as_text(made.required_extensions, command.out.string()), json.dump(2) + "\n");
  return 0;
}

}  // namespace restrip::tools
