// What happens when a caller breaks a precondition, and when an input turns out to be unusable. Every public header
// includes this one, so a compiler of an older standard names the cause whichever header it reads first.
//
// Every public function checks its preconditions through one macro:
//
//   RESTRIP_ASSERT(condition, function, sentence)
//
// `function` and `sentence` are C strings: the public function that was called, and one sentence that says what is
// wrong (describe() of the Refusal, if any). They are evaluated only when the condition is false. Without NDEBUG a
// false condition prints "restrip: function: sentence" with the source line and aborts. With NDEBUG nothing is
// evaluated, so functions stay constexpr and noexcept, and lose no speed.
//
// To handle failures yourself, define the macro in a header, and compile the library and your program with
// RESTRIP_USER_CONFIG defined as the name of that header, in quotes. Your macro is used with NDEBUG as well. If a
// handler returns, the function continues with its arguments as they are. A handler that throws must not be used with
// functions that are noexcept.
//
// A check costs O(valence) at most, so that debug builds stay usable. Do not rely on it for operations from an
// untrusted source: checks.hpp has the same checks as functions that return a value, in every build.
//
// Some inputs turn out to be wrong only while they are read: a colouring that is not valid, more triangles than a
// StripMesh can hold. These are errors in every build, and use a second macro:
//
//   RESTRIP_THROW(exception, sentence)
//
// It throws exception(sentence), a class of <stdexcept>. In a program compiled without exceptions (-fno-exceptions) it
// prints the sentence and aborts. This is what the comments of the headers mean by "throws". Without exceptions, the
// standard library decides what happens instead of std::bad_alloc. You may define this macro too, but your definition
// must not return.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 202002L
#error "restrip needs C++20: compile with -std=c++20 (MSVC: /std:c++20) or a later standard"
#endif

#ifdef RESTRIP_USER_CONFIG
#include RESTRIP_USER_CONFIG
#endif

// Functions that run once for a mesh or rarely: compiled for size, which also shortens the compilation.
#if defined(__GNUC__)
#define RESTRIP_COLD [[gnu::cold]]
#else
#define RESTRIP_COLD
#endif

#include <cstdio>
#include <cstdlib>

namespace restrip::detail {

[[noreturn]] inline void precondition_failed(const char* function, const char* sentence, const char* file,
                                             int line) noexcept {
  std::fprintf(stderr, "restrip: %s: %s (%s:%d)\n", function, sentence, file, line);
  std::abort();
}

[[noreturn]] inline void input_refused(const char* sentence) noexcept {
  std::fprintf(stderr, "%s\n", sentence);
  std::abort();
}

}  // namespace restrip::detail

#ifndef RESTRIP_ASSERT
#ifdef NDEBUG
#define RESTRIP_ASSERT(condition, function, sentence) static_cast<void>(0)
#else
#define RESTRIP_ASSERT(condition, function, sentence) \
  ((condition) ? static_cast<void>(0) : ::restrip::detail::precondition_failed(function, sentence, __FILE__, __LINE__))
#endif
#endif

#ifndef RESTRIP_THROW
#ifdef __cpp_exceptions
#define RESTRIP_THROW(exception, sentence) throw exception(sentence)
#else
#define RESTRIP_THROW(exception, sentence) ::restrip::detail::input_refused(sentence)
#endif
#endif
