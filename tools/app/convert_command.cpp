// `restrip convert`: writes a mesh in another format, otherwise unchanged.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "common/bad_input.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "common/report_output.hpp"
#include "lod/mesh_files.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

/// Writes a mesh in another format. Strips are kept if the new format has strips; a baked mesh stays baked.
struct ConvertCommand {
  NamedFile mesh;
  NamedFile out;
  StripOptions strips;
  bool progressive = false;  ///< all levels in a .glb
  ReadAttributes attributes = ReadAttributes::yes;
  MendingOptions mending;
  std::string json;
};

/// What was written of a mesh, and what the format left out.
struct Converted {
  WrittenStrips written;
  std::size_t left_out = 0;
};

Converted converted(const Soup& soup, const ConvertCommand& command, const MeshFormat& format) {
  if (format.write_mesh != nullptr && (!format.holds_strips || soup.strips.empty()))
    return {{.bytes = format.write_mesh(soup)}};
  StripOptions options = command.strips;
  if (soup.strips.empty()) {
    if (format.write_baked == nullptr || options.form.value_or(StripForm::list) != StripForm::list)
      throw BadInput(
          fmt::format("{}: has no strips; restrip stripify makes some and writes them", command.mesh.string()));
    options.form = StripForm::list;
  }
  std::vector<Corners> drawn;
  std::copy_if(soup.triangles.begin(), soup.triangles.end(), std::back_inserter(drawn),
               [](const Corners& t) { return !degenerate(t); });
  WrittenStrips written = written_strips(format, soup.points, soup.strips.empty() ? each_a_strip(drawn) : soup.strips,
                                         options, soup.attributes, soup.is_64_bits);
  return {std::move(written), soup.triangles.size() - drawn.size()};
}

/// Converts a baked mesh from one container to the other, byte by byte.
int convert_baked(const BakedBytes& found, const ConvertCommand& command, const MeshFormat& format,
                  const files::Output& out, const files::ReportOutput& report) {
  refuse_mending(command.mesh.string(), command.mending);
  const WrittenStrips written = format.write_baked(found.bytes, command.strips);
  out.write(written.bytes);
  const ProgressiveMesh& mesh = found.baked.mesh;
  nlohmann::ordered_json json{
      {"base_triangles", mesh.base.size()}, {"records", mesh.splits.size()}, {"triangles", mesh.fine_triangles()}};
  add_to(json, written);
  report.print(fmt::format("{}: {} and {} to {}\n", command.out.string(), counted(mesh.base.size(), "triangle"),
                           counted(mesh.splits.size(), "record"), mesh.fine_triangles()) +
                   as_text(written, command.out.string()),
               json.dump(2) + "\n");
  return 0;
}

/// Writes all levels of a progressive or baked mesh.
int convert_progressive(const ReadMesh& read, const ConvertCommand& command, const MeshFormat& format,
                        const files::Output& out, const files::ReportOutput& report) {
  const auto* baked = std::get_if<BakedBytes>(&read);
  const ProgressiveMesh* mesh = baked != nullptr ? &baked->baked.mesh : std::get_if<ProgressiveMesh>(&read);
  if (mesh == nullptr)
    throw BadInput(fmt::format("{}: has no levels; restrip simplify makes some", command.mesh.string()));
  refuse_mending(command.mesh.string(), command.mending);
  (void)finest_level(*mesh);  // every split is possible
  out.write(format.write_progressive(*mesh));
  Mended mended;
  mended.left_out_attributes = mesh->left_out_attributes;
  nlohmann::ordered_json json{
      {"base_triangles", mesh->base.size()}, {"splits", mesh->splits.size()}, {"triangles", mesh->fine_triangles()}};
  add_to(json, mended);
  report.print(as_text(mended) + fmt::format("{}: {} and {} to {}\n", command.out.string(),
                                             counted(mesh->base.size(), "triangle"),
                                             counted(mesh->splits.size(), "split"), mesh->fine_triangles()),
               json.dump(2) + "\n");
  return 0;
}

int run(const ConvertCommand& command) {
  const files::Output out = open_output(command.out, extensions_of(writes_any));
  const files::ReportOutput report(command.json);
  const MeshFormat& format = format_to_write(command.out, writes_any);
  ReadMesh read = read_mesh_file(command.mesh, command.attributes);
  if (command.progressive || !(writes_mesh(format) || writes_strips(format) || writes_baked(format)))
    return convert_progressive(read, command, format, out, report);
  const auto* baked = std::get_if<BakedBytes>(&read);
  if (baked != nullptr && writes_baked(format)) return convert_baked(*baked, command, format, out, report);
  if (!writes_mesh(format) && !writes_strips(format))
    throw BadInput(fmt::format("{}: is not a baked mesh; restrip bake makes one", command.mesh.string()));
  Soup soup = finest_level(std::move(read));
  Mended mended = mend(soup, command.mesh.string(), command.mending);
  note_losses(soup, format, mended);
  const Converted made = converted(soup, command, format);
  out.write(made.written.bytes);
  nlohmann::ordered_json json{{"vertices", soup.points.size()},
                              {"triangles", soup.triangles.size() - made.left_out},
                              {"strips", made.written.strips},
                              {"left_out", made.left_out}};
  add_to(json, mended);
  std::string text = as_text(mended);
  text += fmt::format("{}: {}, {}", command.out.string(), counted(soup.points.size(), "vertex", "vertices"),
                      counted(soup.triangles.size() - made.left_out, "triangle"));
  if (made.written.strips != 0) text += fmt::format(" in {}", counted(made.written.strips, "strip"));
  if (made.left_out != 0) text += fmt::format("; {} left out", counted(made.left_out, "degenerate triangle"));
  add_to(json, made.written);
  report.print(text + "\n" + as_text(made.written, command.out.string()), json.dump(2) + "\n");
  return 0;
}

}  // namespace

Subcommand add_convert(CLI::App& app) {
  const auto kept = std::make_shared<ConvertCommand>();
  ConvertCommand& command = *kept;
  CLI::App* sub = app.add_subcommand("convert", "Write a mesh in another format, with the strips of the file");
  add_mesh_option(*sub, command.mesh, help_of_mesh("the finest level, unless a baked one is written as .baked or .glb"))
      ->required();
  add_output_option(
      *sub, command.out, extensions_of(writes_any),
      list_in_words(extensions_of(writes_any), "or") +
          "; .bin, .ply and .glb with the strips of the file, .ply and .glb also without strips; .baked and "
          ".glb from a baked mesh, with all levels; .pm from a baked or progressive mesh")
      ->required();
  add_strip_options(*sub, command.strips, nullptr, &command.progressive);
  add_attributes_option(*sub, command.attributes);
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([sub, &command] { check_strip_options(*sub, command.out, command.strips); });
  sub->footer("Example: restrip convert scan.ply --weld -o scan.glb");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
