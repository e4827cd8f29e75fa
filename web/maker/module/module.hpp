// What the module exports: a request goes in as JSON, and its answer comes out as JSON.
//
//   maker_take(bytes)             memory for a request
//   maker_generate(request, size) answers it with the generator; address and size of the answer follow from maker_text
//                                 and maker_size
//   maker_judge(request, size)    the same with the verifier
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace restrip::maker {

/// The files that the page gives, by name. They replace the file system below common/reading.hpp.
std::map<std::string, std::string>& memory_files();

/// Each reads `request`, and returns the members of the answer.
nlohmann::ordered_json generated(const nlohmann::json& request);
nlohmann::ordered_json judged(const nlohmann::json& request);

}  // namespace restrip::maker
