#include <fmt/format.h>

#include <algorithm>

#include "bad_input.hpp"
#include "commands.hpp"
#include "paper_report.hpp"
#include "whole_file.hpp"

namespace restrip::replay {

int run(const PaperCommand& command) {
  std::error_code error;
  std::filesystem::create_directories(command.out, error);
  if (!std::filesystem::is_directory(command.out))
    throw BadInput(fmt::format("{}: cannot be made a folder: {}; name another one", command.out.string(),
                               error ? error.message() : "a file of that name is in the way"));
  const auto write = [&](const std::vector<NamedFile>& files) {
    for (const NamedFile& file : files) write_whole_file(command.out / file.name, file.bytes);
  };
  std::vector<PaperSubject> subjects;
  for (const std::filesystem::path& mesh : command.meshes) subjects.push_back(read_subject(mesh));
  const RuleFigures figures = rule_figures();
  write(csv_files(figures));  // before the long work, which would be lost if the folder took no files
  std::vector<PaperMesh> meshes;
  for (PaperSubject& subject : subjects) {
    meshes.push_back(measure(subject, command.options));
    subject = {};
  }
  // Never a page beside figures that are not its own.
  std::filesystem::remove(command.out / "index.html", error);
  write(csv_files(meshes));
  write({{"index.html", as_html(figures, meshes, command.options)}});
  fmt::print("{}", command.json ? as_json(figures, meshes) : as_text(meshes));
  return std::all_of(meshes.begin(), meshes.end(), [](const PaperMesh& mesh) { return mesh.faults.empty(); }) ? 0 : 1;
}

}  // namespace restrip::replay
