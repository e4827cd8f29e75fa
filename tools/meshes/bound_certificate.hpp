// The proof of a bound on indices as a text file, for `restrip-verify-bound`: docs/bound.md has the format.
#pragma once

#include <span>
#include <string>

#include "meshes/soup.hpp"
#include "restrip/output/index_bound.hpp"

namespace restrip::tools {

/// `triangles` are those of the bound, in the order of the file that they were read from.
[[nodiscard]] std::string bound_certificate(const IndexBound& bound, std::span<const Corners> triangles,
                                            std::size_t vertex_count);

}  // namespace restrip::tools
