// First in the module for JavaScript: what the library throws ends the call by a trap, which JavaScript sees, and
// leaves its reason. exports.cpp returns it.
#pragma once

namespace restrip::web {
inline const char* stopped_because = nullptr;
}  // namespace restrip::web
#define RESTRIP_THROW(exception, sentence) (restrip::web::stopped_because = (sentence), __builtin_trap())
