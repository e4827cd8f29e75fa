// `restrip paper`: reproduces the figures and experiments of the paper.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/options.hpp"
#include "common/output.hpp"
#include "lod/mesh_files.hpp"
#include "paper/paper.hpp"
#include "replay/source.hpp"

namespace restrip::tools {

namespace {

struct PaperCommand {
  std::filesystem::path out;  ///< a folder; created if missing
  std::vector<std::filesystem::path> meshes;
  MendingOptions mending;
  PaperOptions options;
  std::string json;
};

int run(const PaperCommand& command) {
  const files::OutputSet out(command.out, {"report.json"});
  Report report(command.json);
  // Every mesh is read before hours of work.
  std::vector<Source> sources;
  for (const std::filesystem::path& mesh : command.meshes) {
    Source& source =
        sources.emplace_back(source_of(read_mesh_file(mesh), mesh, command.mending, command.options.simplify, false));
    if (source.original.empty()) source.original = finest_level(source.mesh).triangles;
  }
  const RuleFigures figures = rule_figures();
  std::vector<PaperMesh> meshes;
  for (Source& source : sources) {
    meshes.push_back(measure(source, command.options.levels));
    source = {};
  }
  report.text = as_text(meshes);
  report.json = as_json(figures, meshes, command.options);
  out.write({{"report.json", report.json_text()}});
  report.print();
  return std::all_of(meshes.begin(), meshes.end(), [](const PaperMesh& mesh) { return mesh.faults.empty(); }) ? 0 : 1;
}

}  // namespace

Subcommand add_paper(CLI::App& app) {
  const auto kept = std::make_shared<PaperCommand>();
  PaperCommand& command = *kept;
  CLI::App* sub = app.add_subcommand("paper", "Reproduce the paper's figures and experiments, as a report");
  sub->add_option("-o,--out", command.out, "the folder for report.json")->required();
  sub->add_option("meshes", command.meshes, help_of_mesh(levels_kept))->required();
  add_simplify_options(*sub, command.options.simplify);
  sub->add_option("--levels", command.options.levels, "levels of detail to count strips at")
      ->check(whole_number_from(2, 1000))
      ->capture_default_str();
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->footer("Example: restrip paper --out report bunny.obj\nscripts/paper_page.py makes a page and CSV files of it.");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
