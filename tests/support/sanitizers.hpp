// Sanitizers make tests many times slower, and scripts/test.sh without --all should be short: there tests use smaller meshes.
#pragma once

#include <cstdint>

namespace restrip::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

/// `usual`, or a quarter of it where tests are short.
#ifdef RESTRIP_LONG_TESTS
constexpr std::uint32_t large(std::uint32_t usual) { return sanitized ? usual / 4 : usual; }
#else
constexpr std::uint32_t large(std::uint32_t usual) { return usual / 4; }
#endif

}  // namespace restrip::test
