// What happens when a caller breaks a precondition, and when an input turns out to be one that restrip cannot take.
//
// Every public function checks what it asks of its caller through one macro:
//
//   RESTRIP_ASSERT(condition, function, sentence)
//
// `function` and `sentence` are C strings: the public function that was called, and what is wrong in one sentence
// (describe() of a Refusal, where there is one). They are evaluated only when the condition is false. Without NDEBUG a
// false condition prints "restrip: function: sentence" with the source line and aborts. With NDEBUG nothing is
// evaluated, and the functions stay what they are without it: constexpr, noexcept, and as fast.
//
// To handle failures yourself, define the macro before the first header of restrip, alike in all sources of a program.
// Your macro is used with NDEBUG as well. A handler that returns lets the function go on with what it was given; one
// that throws must not be used with functions that are noexcept.
//
// A check costs O(valence) at most, so that debug builds stay usable. For operations of unknown origin do not rely on
// it: checks.hpp asks the same questions and answers with a value, in every build.
//
// Some inputs are found to be wrong only while they are read: a colouring that is not valid, more triangles than a
// StripMesh can hold. That is an error in every build, and goes through a second macro:
//
//   RESTRIP_THROW(exception, sentence)
//
// It throws exception(sentence), a class of <stdexcept>. Where a program is compiled without exceptions
// (-fno-exceptions), it prints the sentence and aborts. This is what the comments of the headers mean by "throws"; what
// becomes of std::bad_alloc without exceptions is up to the standard library. You may define this macro too; what you
// put in its place must not return.
#pragma once

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
