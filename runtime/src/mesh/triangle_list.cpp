// The neighbours in a triangle list: join_sides.hpp on the list itself.
#include "restrip/mesh/triangle_list.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "mesh/join_sides.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace detail {

/// The sides of a list, for JoinSides.
template <class Element>
class ListedSides {
 public:
  static constexpr std::uint32_t not_joined = none;

  ListedSides(const TriangleList<Element>& list, std::size_t vertex_count,
              std::span<std::array<std::uint32_t, 3>> across, BuildReport& report) noexcept
      : list_(list), vertex_count_(vertex_count), across_(across), report_(&report) {}

  [[nodiscard]] std::size_t triangle_bound() const noexcept { return list_.size(); }
  [[nodiscard]] bool takes(Triangle t) const noexcept {
    if (list_.is_triangle(t, vertex_count_)) return true;
    ++(list_.in_range(t, vertex_count_) ? report_->degenerate_triangles : report_->out_of_range_triangles);
    across_[t] = {none, none, none};
    return false;
  }
  [[nodiscard]] Vertex corner(std::uint32_t h) const noexcept { return list_.corner(h); }
  [[nodiscard]] std::uint32_t& link(std::uint32_t h) const noexcept { return across_[h >> 2][h & 3U]; }
  [[nodiscard]] static std::uint32_t joined(std::uint32_t h) noexcept { return h; }
  [[nodiscard]] std::uint32_t across(std::uint32_t h) const noexcept { return link(h); }
  void odd_edge(Vertex /*v*/, Vertex /*w*/) const noexcept {}

 private:
  TriangleList<Element> list_;
  std::size_t vertex_count_;
  std::span<std::array<std::uint32_t, 3>> across_;
  BuildReport* report_;
};

void expect_vertices(std::size_t vertex_count) {
  if (vertex_count > none) RESTRIP_THROW(std::length_error, "restrip: a StripMesh has at most 2^32 - 1 vertices");
}

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t t) noexcept {
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

}  // namespace detail

template <class Element>
void find_neighbors(const TriangleList<Element>& list, std::size_t vertex_count,
                    std::span<std::array<std::uint32_t, 3>> across, BuildReport& report) {
  RESTRIP_ASSERT(across.size() == list.size(), "find_neighbors", "`across` must have one element for each triangle");
  detail::expect_vertices(vertex_count);
  report = {};
  const detail::ListedSides<Element> sides(list, vertex_count, across, report);
  detail::JoinSides<detail::ListedSides<Element>>(sides, vertex_count, report).run();
}

template void find_neighbors(const TriangleList<std::uint32_t>&, std::size_t, std::span<std::array<std::uint32_t, 3>>,
                             BuildReport&);
template void find_neighbors(const TriangleList<std::uint16_t>&, std::size_t, std::span<std::array<std::uint32_t, 3>>,
                             BuildReport&);
template void find_neighbors(const TriangleList<std::array<Vertex, 3>>&, std::size_t,
                             std::span<std::array<std::uint32_t, 3>>, BuildReport&);

}  // namespace restrip
