// `restrip convert`: writes a mesh in another format, otherwise unchanged.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "lod/mesh_files.hpp"

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

int run(const ConvertCommand& command) {
  const files::Output out = open_output(command.out, extensions_of(writes_any));
  Report report(command.json);
  const MeshFormat& format = format_to_write(command.out, writes_any);
  const std::string in = command.mesh.string();
  const std::string name = command.out.string();
  ReadMesh read = read_mesh_file(command.mesh, command.attributes);
  WrittenStrips written;
  Mended mended;
  mended.left_out = left_out_of(read);

  // All levels: of a baked mesh byte by byte from one container to the other, or the splits alone.
  const auto* baked = std::get_if<BakedBytes>(&read);
  const bool progressive =
      command.progressive || !(writes_mesh(format) || writes_strips(format) || writes_baked(format));
  if (progressive || (baked != nullptr && writes_baked(format))) {
    const ProgressiveMesh* mesh = baked != nullptr ? &baked->baked.mesh : std::get_if<ProgressiveMesh>(&read);
    if (mesh == nullptr) throw BadInput(fmt::format("{}: has no levels; restrip simplify makes some", in));
    refuse_mending(in, command.mending);
    if (progressive) {
      (void)finest_level(*mesh);  // every split is possible
      written.bytes = format.write_progressive(*mesh);
    } else {
      written = format.write_baked(baked->bytes, command.strips);
    }
    out.write(written.bytes);
    const std::string what = progressive ? "split" : "record";
    report.json = {{"base_triangles", mesh->base.size()},
                   {what + "s", mesh->splits.size()},
                   {"triangles", mesh->fine_triangles()}};
    report.add(mended);
    report.text += fmt::format("{}: {} and {} to {}\n", name, counted(mesh->base.size(), "triangle"),
                               counted(mesh->splits.size(), what), mesh->fine_triangles());
    report.add(written, name);
    report.print();
    return 0;
  }

  // One level.
  if (!writes_mesh(format) && !writes_strips(format))
    throw BadInput(fmt::format("{}: is not a baked mesh; restrip bake makes one", in));
  Soup soup = finest_level(std::move(read));
  mended = mend(soup, in, command.mending);
  leave_out_losses(soup, format, mended);
  std::size_t left_out = 0;
  if (format.write_mesh != nullptr && (!format.holds_strips || soup.strips.empty())) {
    written.bytes = format.write_mesh(soup);
  } else {
    StripOptions options = command.strips;
    if (soup.strips.empty()) {
      if (format.write_baked == nullptr || options.form.value_or(StripForm::list) != StripForm::list)
        throw BadInput(fmt::format("{}: has no strips; restrip stripify makes some and writes them", in));
      options.form = StripForm::list;
    }
    left_out = static_cast<std::size_t>(std::count_if(soup.triangles.begin(), soup.triangles.end(), degenerate));
    std::vector<std::uint32_t> strips = soup.strips;
    if (strips.empty())  // each triangle is one
      for (const Corners& t : soup.triangles)
        if (!degenerate(t)) strips.insert(strips.end(), {t[0], t[1], t[2], strip_end});
    written = written_strips(format, soup.points, strips, options, soup.attributes, soup.is_64_bits);
  }
  out.write(written.bytes);
  report.json = {{"vertices", soup.points.size()},
                 {"triangles", soup.triangles.size() - left_out},
                 {"strips", written.strips},
                 {"left_out", left_out}};
  report.add(mended);
  report.text += fmt::format("{}: {}, {}", name, counted(soup.points.size(), "vertex", "vertices"),
                             counted(soup.triangles.size() - left_out, "triangle"));
  if (written.strips != 0) report.text += fmt::format(" in {}", counted(written.strips, "strip"));
  if (left_out != 0) report.text += fmt::format("; {} left out", counted(left_out, "degenerate triangle"));
  report.text += "\n";
  report.add(written, name);
  report.print();
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
