// The patches of docs/notation.md as lists of numbers.

#include <fmt/format.h>

#include "naive_tables.hpp"

namespace restrip::verify::test {
namespace {

/// The triangles in order, joined one after the other.
NaivePatch chain(const std::vector<int>& triangles, int k, bool closed, bool chord) {
  NaivePatch patch;
  patch.triangles = triangles;
  patch.closed = closed;
  for (int port = 0; port < k; ++port) patch.port_owner.push_back(port);
  for (std::size_t i = 0; i + 1 < triangles.size(); ++i) patch.edges.push_back({triangles[i], triangles[i + 1]});
  if (closed) patch.edges.push_back({triangles.back(), triangles.front()});
  if (chord) {
    patch.chord = static_cast<int>(patch.edges.size());
    patch.edges.push_back({triangle_a, triangle_d});
  }
  return patch;
}

std::vector<int> fan(int k) {
  std::vector<int> triangles;
  for (int i = 0; i < k; ++i) triangles.push_back(i);
  return triangles;
}

std::vector<int> fan_with(int k, int gap_of_a, int gap_of_d) {
  std::vector<int> triangles;
  for (int i = 0; i <= k; ++i) {
    if (i == gap_of_a) triangles.push_back(triangle_a);
    if (i == gap_of_d) triangles.push_back(triangle_d);
    if (i < k) triangles.push_back(i);
  }
  return triangles;
}

NaivePatch two_triangles(const std::vector<int>& port_owner) {
  NaivePatch patch;
  patch.triangles = {0, 1};
  patch.port_owner = port_owner;
  patch.edges = {{0, 1}};
  return patch;
}

}  // namespace

std::vector<NaiveFamily> naive_families(int max_k) {
  NaiveFamily split{"split", {}};
  NaiveFamily collapse{"collapse", {}};
  for (int k = 3; k <= max_k; ++k) {
    const NaivePatch loop = chain(fan(k), k, true, false);
    NaiveSection all{fmt::format("k {}", k), true, {}};
    for (int a = 1; a <= k / 2; ++a) {
      const NaivePatch ring = chain(fan_with(k, 0, a), k, true, true);
      split.sections.push_back({fmt::format("k {} a {}", k, a), false, {{loop, ring}}});
      all.operations.push_back({ring, loop});
    }
    collapse.sections.push_back(all);
  }
  NaiveFamily open_split{"open-split", {}};
  NaiveFamily boundary_split{"boundary-split", {}};
  NaiveFamily fan_collapse{"fan-collapse", {}};
  for (int k = 1; k <= max_k; ++k) {
    const NaivePatch open = chain(fan(k), k, false, false);
    NaiveSection all{fmt::format("k {}", k), true, {}};
    for (int i = 0; i <= k; ++i)
      for (int j = i + 1; j <= k - i; ++j) {
        const NaivePatch path = chain(fan_with(k, i, j), k, false, true);
        open_split.sections.push_back({fmt::format("k {} gaps {} {}", k, i, j), false, {{open, path}}});
        all.operations.push_back({path, open});
      }
    for (int i = 0; i <= k / 2; ++i) {
      const NaivePatch path = chain(fan_with(k, i, -1), k, false, false);
      boundary_split.sections.push_back({fmt::format("k {} gap {}", k, i), false, {{open, path}}});
      all.operations.push_back({path, open});
    }
    fan_collapse.sections.push_back(all);
  }
  const NaiveOperation flip{two_triangles({0, 0, 1, 1}), two_triangles({1, 0, 0, 1}), true};
  return {split, collapse, open_split, boundary_split, fan_collapse, {"flip", {{"flip", false, {flip}}}}};
}

NaiveOperation naive_operation(const std::string& name, const std::vector<int>& position) {
  const int k = position.at(0);
  const bool closed = name == "split" || name == "collapse";
  const bool one_triangle = name.starts_with("boundary");
  const int a = closed ? 0 : position.at(1);
  const int d = one_triangle ? -1 : position.at(closed ? 1 : 2);
  const NaivePatch small = chain(fan(k), k, closed, false);
  const NaivePatch large = chain(fan_with(k, a, d), k, closed, !one_triangle);
  return name.ends_with("split") ? NaiveOperation{small, large, false} : NaiveOperation{large, small, false};
}

}  // namespace restrip::verify::test
