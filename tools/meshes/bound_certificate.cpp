#include "meshes/bound_certificate.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <iterator>

#include "restrip/formats/baked_format.hpp"

namespace restrip::tools {

namespace {

/// FNV-1a of all corners, each four bytes, the lowest first: tells whether a certificate is that of a mesh.
std::uint64_t digest_of(std::span<const Corners> triangles) {
  std::string bytes;
  bytes.reserve(12 * triangles.size());
  for (const Corners& corners : triangles)
    for (const std::uint32_t corner : corners)
      for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(corner >> shift & 0xFFU));
  return baked_format::fnv1a(std::span<const char>(bytes));
}

}  // namespace

std::string bound_certificate(const IndexBound& bound, std::span<const Corners> triangles, std::size_t vertex_count) {
  std::string text =
      fmt::format("restrip-bound 1\nvertices {}\ntriangles {}\ndigest {:016x}\ndenominator {}\ncuts {}\n", vertex_count,
                  bound.triangles, digest_of(triangles), IndexBound::denominator, bound.cuts.size());
  for (const VertexCut& cut : bound.cuts)
    fmt::format_to(std::back_inserter(text), "cut {} {}\n", cut.multiplier, fmt::join(cut.vertices, " "));
  text += fmt::format("arrows {}\ncomponents {}\nindices {}\nend\n", bound.arrows, bound.components, bound.indices);
  return text;
}

}  // namespace restrip::tools
