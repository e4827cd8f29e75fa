// The generator: `restrip-generate rules` of one operation file.
//   {files: {NAME: TEXT}, languages: ["c++", …], max_k: 5 or nothing}  ->
//   {files: {PATH: TEXT}, bytes: {PATH: [BYTE, …]}, report: […], text: "…"}
#include <vector>

#include "files.hpp"
#include "module.hpp"
#include "operations/write.hpp"
#include "tables/changed.hpp"

namespace restrip::generator {

std::vector<files::NamedBytes> changed(const std::filesystem::path& /*folder*/, std::vector<files::NamedBytes> files) {
  return files;
}

}  // namespace restrip::generator

namespace restrip::maker {

nlohmann::ordered_json generated(const nlohmann::json& request) {
  generator::RulesOptions options;
  for (const auto& [name, text] : request.at("files").items()) options.files.push_back(name);
  if (request.contains("max_k")) options.max_k = request.at("max_k").get<unsigned>();
  options.languages = request.at("languages").get<std::set<std::string>>();
  options.json = "-";
  const std::map<std::string, std::string> given = memory_files();
  generator::make_rules(options);
  nlohmann::ordered_json out = {{"files", nlohmann::ordered_json::object()},
                                {"report", nlohmann::ordered_json::parse(last_report().json).at("operations")},
                                {"text", last_report().text}};
  for (const auto& [name, text] : memory_files())
    if (name.ends_with(".bin"))
      out["bytes"][name] = std::vector<unsigned char>(text.begin(), text.end());
    else if (!given.contains(name))
      out["files"][name] = text;
  return out;
}

}  // namespace restrip::maker
