#include "commands/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <iterator>
#include <utility>

#include "describe/description.hpp"
#include "emit/languages.hpp"

namespace restrip::generator {

CLI::Option* add_json_option(CLI::App& command, std::string& file) {
  return command.add_option("--json", file,
                            "Write the report as JSON to this file; - for standard output, in place of the text");
}

CLI::Option* add_language_option(CLI::App& command, std::set<std::string>& languages, const char* of_cpp,
                                 const char* in_others) {
  return command
      .add_option("--language", languages,
                  fmt::format("c++ (the default: {}), c, rust, json, glsl or wgsl: {} and look-up; several "
                              "separated by commas",
                              of_cpp, in_others))
      ->delimiter(',')
      ->check(CLI::IsMember(language_files()))
      ->allow_extra_args(false);
}

CLI::Option* add_family_option(CLI::App& command, std::string& family) {
  std::vector<std::string> names;
  for (const Description& one : families()) names.push_back(one.name);
  return command.add_option("--family", family, fmt::format("One of {}", fmt::join(names, ", ")))
      ->check(CLI::IsMember(names))
      ->capture_default_str();
}

OutputFolder::OutputFolder(const std::string& folder, const std::vector<std::filesystem::path>& names,
                           const std::vector<std::string>& inputs)
    : folder_(folder), out_(folder, names, {{}, {inputs.begin(), inputs.end()}}) {}

void OutputFolder::write(std::vector<files::NamedBytes> files) {
  std::erase_if(files, [&](const files::NamedBytes& file) {
    std::ifstream old(folder_ / file.name, std::ios::binary);  // not read_whole(), which refuses outputs
    return old && std::string(std::istreambuf_iterator<char>(old), {}) == file.bytes;
  });
  out_.write(files);
}

}  // namespace restrip::generator
