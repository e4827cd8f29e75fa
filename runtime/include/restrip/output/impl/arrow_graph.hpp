// The vertices and edges of a triangle list, for the bound on indices. Included by impl/index_bound.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::detail {

// Every mesh edge is two arrows, 2 e and 2 e + 1, one each way.
class ArrowGraph {
 public:
  struct Leaving {
    Vertex to;
    std::uint32_t arrow;
  };

  ArrowGraph(std::span<const std::array<Vertex, 3>> triangles, std::size_t vertex_count)
      : lacking_(vertex_count, 0), first_(vertex_count + 1, 0) {
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * triangles.size());
    for (const auto& t : triangles)
      for (unsigned s = 0; s < 3; ++s) {
        const auto [low, high] = std::minmax(t[s], t[(s + 1) % 3]);
        edges.push_back(std::uint64_t{low} << 32 | high);
        lacking_[t[s]] = static_cast<std::uint8_t>((lacking_[t[s]] + 2) % 3);
      }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const std::uint64_t e : edges) {
      ++first_[static_cast<std::size_t>(e >> 32) + 1];
      ++first_[std::size_t{static_cast<Vertex>(e)} + 1];
    }
    for (std::size_t v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
    leaving_.resize(2 * edges.size());
    std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
    std::uint32_t arrow = 0;
    for (const std::uint64_t e : edges) {
      const auto low = static_cast<Vertex>(e >> 32);
      const auto high = static_cast<Vertex>(e);
      leaving_[place[low]++] = {high, arrow};
      leaving_[place[high]++] = {low, arrow + 1};
      arrow += 2;
    }
  }

  [[nodiscard]] std::size_t vertices() const noexcept { return lacking_.size(); }
  [[nodiscard]] std::size_t arrows() const noexcept { return leaving_.size(); }
  [[nodiscard]] std::span<const Leaving> from(Vertex v) const noexcept {
    return std::span(leaving_).subspan(first_[v], first_[v + 1] - first_[v]);
  }
  /// What is missing at v, modulo 3.
  [[nodiscard]] unsigned lacking(Vertex v) const noexcept { return lacking_[v]; }

  /// Connected components, single vertices without triangles left out.
  [[nodiscard]] std::size_t components() const {
    std::vector<bool> met(vertices(), false);
    std::vector<Vertex> open;
    std::size_t found = 0;
    for (Vertex start = 0; start < vertices(); ++start) {
      if (met[start] || from(start).empty()) continue;
      ++found;
      met[start] = true;
      open.push_back(start);
      while (!open.empty()) {
        const Vertex v = open.back();
        open.pop_back();
        for (const Leaving& way : from(v)) {
          if (!met[way.to]) open.push_back(way.to);
          met[way.to] = true;
        }
      }
    }
    return found;
  }

 private:
  std::vector<std::uint8_t> lacking_;
  std::vector<std::uint32_t> first_;
  std::vector<Leaving> leaving_;
};

}  // namespace restrip::detail
