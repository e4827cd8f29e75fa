// Pseudo-random bits for searches.
#pragma once

#include <cstdint>

namespace restrip::detail {

/// The same everywhere: xorshift64* (Vigna, "An experimental exploration of Marsaglia's xorshift generators,
/// scrambled", 2016).
class PseudoRandom {
 public:
  explicit constexpr PseudoRandom(std::uint64_t seed) noexcept : state_(seed ^ 0x9E3779B97F4A7C15U) {
    if (state_ == 0) state_ = 1;
  }
  constexpr std::uint32_t bits() noexcept {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return static_cast<std::uint32_t>(state_ * 0x2545F4914F6CDD1DU >> 32);
  }
  /// A number less than `bound`.
  constexpr std::uint32_t below(std::uint32_t bound) noexcept {
    return static_cast<std::uint32_t>(std::uint64_t{bits()} * bound >> 32);
  }

 private:
  std::uint64_t state_;
};

}  // namespace restrip::detail
