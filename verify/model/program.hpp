#pragma once
// How the verifying programs end.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

namespace restrip::verify {

inline constexpr int all_claims_hold = 0;
inline constexpr int some_claim_fails = 1;
inline constexpr int bad_input = 2;

/// The exit code of what a program does: what `work` says, or bad_input when it throws or its output was not written.
template <class Work>
int exit_code_of(const char* program, const Work& work) {
  try {
    const int code = work();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw std::runtime_error("standard output: what was found could not be written");
    return code;
  } catch (const std::exception& error) {
    std::fflush(stdout);
    fmt::print(stderr, "{}: {}\n", program, error.what());
    return bad_input;
  }
}

}  // namespace restrip::verify
