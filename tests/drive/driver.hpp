// The one driver of random operations on a LiveMesh. Bytes say which calls are made and where, so a seed, a fuzzer and
// a shrunk input all drive it; oracles (oracles.hpp) say after each call whether the subject is right. Seldom an
// allocation fails during a call.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "drive/oracles.hpp"
#include "drive/subject.hpp"

namespace restrip::drive {

/// The bytes of an input one after the other, then zeros.
class Input {
 public:
  explicit Input(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] bool over() const noexcept { return bytes_.empty(); }
  std::uint32_t byte() noexcept;
  std::uint32_t word() noexcept;
  template <class Value, std::size_t N>
  Value one_of(const std::array<Value, N>& values) noexcept {
    return values[byte() % N];
  }

 private:
  std::string_view bytes_;
};

/// Bytes that look random, the same on every machine.
[[nodiscard]] std::string random_bytes(std::size_t length, std::uint32_t seed);

struct Limits {
  std::size_t steps = 400;
  /// Between these numbers of triangles, any operation; beyond them, only such that lead back.
  std::size_t fewest = 20;
  std::size_t most = 160;
  bool allocations_fail = true;
  /// Or only one in the call of this step: twice its number, plus one if all later ones fail as well. 0: none.
  std::uint32_t failing = 0;
  std::size_t failing_step = 0;
  bool far_names = true;  ///< splits may name vertices that need indices of 32 bits
};

/// How often each call was done and refused.
struct Tally {
  std::array<std::size_t, calls> done{};
  std::array<std::size_t, calls> refused{};
  std::size_t shortages = 0;  ///< calls during which an allocation failed
  std::size_t failed = 0;     ///< of them
  Tally& operator+=(const Tally& other) noexcept;
};

/// Makes calls until the input or the steps end; then undoes and redoes all frames, and saves and loads the mesh.
/// Throws std::logic_error if an oracle objects.
Tally drive(Input& input, Subject& subject, std::span<Oracle* const> oracles, const Limits& limits = {});

/// A mesh of some kind, and the options of a LiveMesh.
[[nodiscard]] Triangles any_mesh(Input& input);
[[nodiscard]] LiveOptions any_options(Input& input);

}  // namespace restrip::drive
