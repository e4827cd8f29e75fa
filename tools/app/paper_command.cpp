#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/commands.hpp"
#include "common/report_output.hpp"
#include "paper/paper_report.hpp"

namespace restrip::tools {

int run(const PaperCommand& command) {
  // The report comes last: it vouches for the figures.
  const auto with_report = [](std::vector<files::NamedBytes> files, std::vector<files::NamedBytes> more,
                              std::string report) {
    std::move(more.begin(), more.end(), std::back_inserter(files));
    files.push_back({"report.json", std::move(report)});
    return files;
  };
  std::vector<std::filesystem::path> names;
  for (const files::NamedBytes& file : with_report(csv_files(RuleFigures{}), csv_files(std::vector<PaperMesh>{}), ""))
    names.push_back(file.name);
  files::OutputSet out(command.out, names, {{}, command.meshes});
  const ReportOutput report(command.json, command.meshes);
  std::vector<PaperSubject> subjects;
  for (const std::filesystem::path& mesh : command.meshes) subjects.push_back(read_subject(mesh, command.mending));
  const RuleFigures figures = rule_figures();
  std::vector<PaperMesh> meshes;
  for (PaperSubject& subject : subjects) {
    meshes.push_back(measure(subject, command.options));
    subject = {};
  }
  const std::string json = as_json(figures, meshes, command.options);
  out.write(with_report(csv_files(figures), csv_files(meshes), json));
  report.print(as_text(meshes), json);
  return std::all_of(meshes.begin(), meshes.end(), [](const PaperMesh& mesh) { return mesh.faults.empty(); }) ? 0 : 1;
}

}  // namespace restrip::tools
