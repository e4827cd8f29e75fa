// Makes violated preconditions throw in every build. Include it before any header of restrip.
#pragma once

#include <stdexcept>
#include <string>

[[noreturn]] inline void precondition_broken(const char* function, const char* sentence) {
  throw std::logic_error(std::string(function) + ": " + sentence);
}
#define RESTRIP_ASSERT(condition, function, sentence) \
  ((condition) ? static_cast<void>(0) : precondition_broken(function, sentence))
