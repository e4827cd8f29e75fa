// What both modules export: a request goes in as JSON, and its answer comes out as JSON.
//
//   maker_take(bytes)           memory for a request
//   maker_answer(request, size) runs it; the answer's address and size follow from maker_text and maker_size
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace restrip::maker {

/// The work of a module: reads `request`, and returns the members of the answer.
nlohmann::ordered_json answer_of(const nlohmann::json& request);

}  // namespace restrip::maker
