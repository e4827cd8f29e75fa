// A mesh made by the program, for experiments without a file: a torus (closed, genus 1) with jittered vertices and
// valences from 3 to 10, with the same bytes on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "meshes/soup.hpp"

namespace restrip::tools {

inline constexpr std::size_t default_made_triangles = 100'000;
inline constexpr std::size_t least_made_triangles = 32;
inline constexpr std::size_t most_made_triangles = 20'000'000;

/// A torus of about this many triangles (2 * m * n for integers m, n): a grid, made irregular by one random edge flip
/// per vertex. Linear time and memory, about 80 bytes a triangle. Throws BadInput if the size is out of range.
[[nodiscard]] Soup make_mesh(std::size_t triangles = default_made_triangles, std::uint64_t seed = 1);

}  // namespace restrip::tools
