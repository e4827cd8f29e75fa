// The generator: `restrip-generate rules` of one operation file.
//   {files: {NAME: TEXT}, languages: ["c++", …], max_k: 5 or nothing}  ->
//   {files: {PATH: TEXT}, bytes: {PATH: [BYTE, …]}, report: […], text: "…"}
#include <vector>

#include "commands/pipeline.hpp"
#include "module.hpp"

namespace restrip::maker {

nlohmann::ordered_json generated(const nlohmann::json& request) {
  std::vector<std::string> names;
  for (const auto& [name, text] : request.at("files").items()) names.push_back(name);
  std::optional<unsigned> max_k;
  if (request.contains("max_k")) max_k = request.at("max_k").get<unsigned>();
  generator::Order order = generator::order_of(names, max_k);
  order.languages = request.at("languages").get<std::set<std::string>>();
  const generator::Emitted made = generator::make(order, generator::patches_of(order.descriptions, order.max_k));
  nlohmann::ordered_json out = {{"files", nlohmann::ordered_json::object()},
                                {"report", nlohmann::ordered_json::parse(made.json).at("operations")},
                                {"text", made.text}};
  for (const auto& [name, text] : made.files)
    if (name.extension() == ".bin")
      out["bytes"][name.string()] = std::vector<unsigned char>(text.begin(), text.end());
    else
      out["files"][name.string()] = text;
  return out;
}

}  // namespace restrip::maker
