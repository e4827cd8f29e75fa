// `restrip paper`: reproduces the figures and experiments of the paper.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>

#include "app/options.hpp"
#include "common/output.hpp"
#include "lod/simplify.hpp"
#include "paper/paper.hpp"

namespace restrip::tools {

namespace {

/// Writes the paper's figures and experiments as CSV files and a JSON report (paper.hpp). Files are written
/// atomically, the report last.
struct PaperCommand {
  std::filesystem::path out;  ///< a folder; created if missing
  std::vector<std::filesystem::path> meshes;
  MendingOptions mending;
  PaperOptions options;
  std::string json;
};

int run(const PaperCommand& command) {
  // The report is written last: if it exists, the figures are complete.
  const auto with_report = [](std::vector<files::NamedBytes> files, std::vector<files::NamedBytes> more,
                              std::string report) {
    std::move(more.begin(), more.end(), std::back_inserter(files));
    files.push_back({"report.json", std::move(report)});
    return files;
  };
  std::vector<std::filesystem::path> names;
  for (const files::NamedBytes& file : with_report(csv_files(RuleFigures{}), csv_files(std::vector<PaperMesh>{}), ""))
    names.push_back(file.name);
  files::OutputSet out(command.out, names);
  Report report(command.json);
  std::vector<PaperSubject> subjects;
  for (const std::filesystem::path& mesh : command.meshes) subjects.push_back(read_subject(mesh, command.mending));
  const RuleFigures figures = rule_figures();
  std::vector<PaperMesh> meshes;
  for (PaperSubject& subject : subjects) {
    meshes.push_back(measure(subject, command.options));
    subject = {};
  }
  report.text = as_text(meshes);
  report.json = as_json(figures, meshes, command.options);
  out.write(with_report(csv_files(figures), csv_files(meshes), report.json_text()));
  report.print();
  return std::all_of(meshes.begin(), meshes.end(), [](const PaperMesh& mesh) { return mesh.faults.empty(); }) ? 0 : 1;
}

}  // namespace

Subcommand add_paper(CLI::App& app) {
  const auto kept = std::make_shared<PaperCommand>();
  PaperCommand& command = *kept;
  CLI::App* sub =
      app.add_subcommand("paper", "Reproduce the paper's figures and experiments, as CSV files and a report");
  sub->add_option("-o,--out", command.out, "the folder for report.json and CSV files")->required();
  sub->add_option("meshes", command.meshes, help_of_mesh(levels_kept))->required();
  add_simplify_options(*sub, command.options.simplify);
  sub->add_option("--levels", command.options.levels, "levels of detail to count strips at")
      ->check(whole_number_from(2, 1000))
      ->capture_default_str();
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->footer("Example: restrip paper --out report bunny.obj\nscripts/paper_page.py makes a page of the folder.");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
