// Window, member by member. Included by window.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "restrip/precondition.hpp"
#include "restrip/search/window.hpp"

namespace restrip {

// The ball grows ring by ring, in an order drawn at random. A triangle with two neighbours inside is added immediately,
// so that the rim is short.
WindowChange Window::around(SidedMesh auto& mesh, Triangle middle, const WindowLimits& limits) {
  const auto size = std::min<std::size_t>(limits.triangles, max_triangles);
  ball_.clear();
  in_ball_.clear();
  const auto inside = [&](Triangle t) { return in_ball_[t] != detail::LocalNumbers::absent; };
  const auto add = [&](Triangle t) {
    in_ball_.add(t, 0);
    ball_.push_back(t);
  };
  const auto neighbor = [&](Triangle t, unsigned side) {
    const auto there = mesh.opposite(StripMesh::halfedge(t, side));
    return StripMesh::on_boundary(there) ? none : StripMesh::triangle(there);
  };
  add(middle);
  for (std::size_t next = 0; next < ball_.size() && ball_.size() < size; ++next) {
    const unsigned first_side = random_.below(3);
    for (unsigned turn = 0; turn < 3 && ball_.size() < size; ++turn) {
      const Triangle adjacent = neighbor(ball_[next], (first_side + turn) % 3);
      if (adjacent == none || inside(adjacent)) continue;
      add(adjacent);
      hollows_.assign(1, adjacent);
      while (!hollows_.empty() && ball_.size() < size) {
        const Triangle t = hollows_.back();
        hollows_.pop_back();
        for (unsigned s = 0; s < 3 && ball_.size() < size; ++s) {
          const Triangle hollow = neighbor(t, s);
          if (hollow == none || inside(hollow)) continue;
          unsigned sides_inside = 0;
          for (unsigned side = 0; side < 3; ++side)
            if (const Triangle around = neighbor(hollow, side); around != none && inside(around)) ++sides_inside;
          if (sides_inside < 2) continue;
          add(hollow);
          hollows_.push_back(hollow);
        }
      }
    }
  }
  return solve(mesh, limits);
}

WindowChange Window::inside(SidedMesh auto& mesh, std::span<const Triangle> triangles, const WindowLimits& limits) {
  RESTRIP_ASSERT(triangles.size() <= max_triangles, "Window::inside", "the window has too many triangles");
  ball_.assign(triangles.begin(), triangles.end());
  return solve(mesh, limits);
}

WindowChange Window::solve(SidedMesh auto& mesh, const WindowLimits& limits) {
  ++windows_;
  if (!plan_.make(mesh, ball_)) {
    ++refused_;
    return {};
  }
  // A third of a strip is two thirds of an end.
  const std::uint64_t third = std::max<std::uint64_t>({cost_.restart, std::uint64_t{3} * cost_.swap, cost_.isolated});
  const auto slack = limits.slack == WindowLimits::no_limit ? (std::numeric_limits<std::int64_t>::max)()
                                                            : static_cast<std::int64_t>(2 * third * limits.slack / 3);
  search_.run(plan_.triangles(), plan_.steps(), slack, limits.states, random_);
  // Edges that become dashed are cleared before others are set.
  for (const bool solid : {false, true})
    for (std::size_t i = 0; i < plan_.steps().size(); ++i) {
      const detail::WindowTriangle& here = plan_.triangles()[plan_.steps()[i].first];
      const unsigned changed = (here.present ^ search_.best()[i]) & here.leaving;
      for (unsigned s = 0; s < 3; ++s)
        if ((changed >> s & 1U) != 0 && ((search_.best()[i] >> s & 1U) != 0) == solid)
          mesh.set_solid(StripMesh::halfedge(here.triangle, s), solid);
    }
  const detail::WindowTally& now = search_.tally_of_best();
  const detail::WindowTally& before = search_.tally_of_present();
  return {{(now.ends - before.ends) / 2, now.swaps - before.swaps, now.isolated - before.isolated},
          now.windings - before.windings,
          search_.proven()};
}

}  // namespace restrip
