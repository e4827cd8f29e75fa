// Sizes of tests: a quarter in short runs and with sanitizers, which make tests many times slower.
#pragma once

#include <cstdint>

namespace restrip::test {

constexpr std::uint32_t large(std::uint32_t usual) {
#ifdef RESTRIP_LONG_TESTS
  return usual;
#else
  return usual / 4;
#endif
}

}  // namespace restrip::test
