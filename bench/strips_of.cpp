// strips_of() as C functions, for scripts/scratch_table.py, which compares it with other libraries.
#include "restrip/search/strips_of.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

extern "C" {

/// Whether the list of `count` indices is an oriented manifold, except at its vertices.
int restrip_bench_is_manifold(const std::uint32_t* ids, std::size_t count, std::size_t vertices) {
  const restrip::TriangleList list(std::span<const std::uint32_t>(ids, count));
  return restrip::detail::is_oriented_manifold(list, vertices) ? 1 : 0;
}

/// Writes the indices of strips of effort `fast` to `out`, at most 2 * count + 4, and returns how many.
std::size_t restrip_bench_strips(const std::uint32_t* ids, std::size_t count, std::size_t vertices, int trust,
                                 std::uint32_t* out) {
  const std::span<const std::uint32_t> list(ids, count);
  constexpr restrip::StripFormat plain{.width = restrip::IndexWidth::bits32, .list_if_shorter = false};
  const restrip::IndexBuffer buffer =
      trust != 0 ? restrip::strips_of(restrip::trusted, list, vertices, plain, restrip::Effort::fast)
                 : restrip::strips_of(list, vertices, plain, restrip::Effort::fast);
  const auto& indices = std::get<std::vector<std::uint32_t>>(buffer.indices);
  std::copy(indices.begin(), indices.end(), out);
  return indices.size();
}

}  // extern "C"
