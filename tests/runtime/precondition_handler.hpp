// Handlers that a program defines: precondition_handler_test compiles the library with them.
#pragma once

#include <stdexcept>
#include <string>

inline void fail_with(const char* function, const char* sentence) {
  throw std::logic_error(std::string(function) + ": " + sentence);
}
#define RESTRIP_ASSERT(condition, function, sentence) \
  ((condition) ? static_cast<void>(0) : fail_with(function, sentence))
[[noreturn]] inline void refuse(const char* sentence) { throw std::string(sentence); }
#define RESTRIP_THROW(exception, sentence) refuse(sentence)
