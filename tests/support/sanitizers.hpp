// Sanitizers make tests many times slower, so tests use smaller meshes under them.
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

/// `usual`, or a quarter of it with sanitizers.
constexpr std::uint32_t large(std::uint32_t usual) { return sanitized ? usual / 4 : usual; }

}  // namespace restrip::test
