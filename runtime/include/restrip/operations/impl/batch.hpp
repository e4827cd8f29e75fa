// Batches: what an operation claims, and the passes of a batch. Included by batch.hpp.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "restrip/operations/batch.hpp"
#include "restrip/operations/impl/parallel_ranges.hpp"

namespace restrip {
namespace detail {

/// Calls triangle(t) for every triangle of the vertex's fan.
template <class Visit>
void for_each_fan_triangle(const StripMesh& mesh, Vertex v, Visit&& triangle) {
  for_each_spoke(mesh, v, [&](StripMesh::Halfedge h) {
    if (!StripMesh::on_boundary(h)) triangle(StripMesh::triangle(h));
  });
}

/// Calls triangle(t) and vertex(v) for everything that the operation claims; some may come twice. See PatchClaims.
template <class OnTriangle, class OnVertex>
void for_each_claim(const StripMesh& mesh, const SplitRequest& request, OnTriangle&& triangle, OnVertex&& vertex) {
  using Spokes = VertexSplit<StripMesh::Halfedge>::Spokes;
  const auto& where = request.where;
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  for_each_fan_triangle(mesh, mesh.from(has_left ? where.left : where.right), triangle);
  // A spoke without a triangle to its left: the first spoke of the vertex it enters moves to the new triangle.
  if (has_left && StripMesh::on_boundary(where.left)) vertex(mesh.to(where.left));
  if (has_right && StripMesh::on_boundary(where.right)) vertex(mesh.to(where.right));
  if (request.new_vertex != none) vertex(request.new_vertex);
}

template <class OnTriangle, class OnVertex>
void for_each_claim(const StripMesh& mesh, StripMesh::Halfedge chord, OnTriangle&& triangle, OnVertex&& vertex) {
  for_each_fan_triangle(mesh, mesh.from(chord), triangle);
  for_each_fan_triangle(mesh, mesh.to(chord), triangle);
  for (const StripMesh::Halfedge h : {chord, mesh.opposite(chord)})
    if (!StripMesh::on_boundary(h)) vertex(mesh.to(StripMesh::next(h)));
}

inline Refusal check_request(const StripMesh& mesh, const SplitRequest& request) {
  return check_split(mesh, request.where);
}
inline Refusal check_request(const StripMesh& mesh, StripMesh::Halfedge chord) { return check_collapse(mesh, chord); }

/// A StripMesh whose insertions fill handles that were taken before, and whose removals keep the handles that become
/// free, to be given back later. Views of the same mesh may change disjoint patches at the same time.
class TwoSteps {
 public:
  using Halfedge = StripMesh::Halfedge;
  using Room = StripMesh::Room;
  TwoSteps(StripMesh& mesh, Room& room) noexcept : mesh_(mesh), room_(room) {}

  /// The handles that an insertion would use now. Throws as StripMesh::insert_vertex does.
  [[nodiscard]] static Room take(StripMesh& mesh, VertexSplit<Halfedge>::Spokes spokes, Vertex new_vertex = none) {
    return mesh.take_room(spokes, new_vertex);
  }
  /// Does not throw for the number that was expected.
  static void give_back(StripMesh& mesh, const Room& room) { mesh.give_back(room); }
  static void expect_back(StripMesh& mesh, std::size_t removals) { mesh.expect_back(removals); }

  [[nodiscard]] Halfedge next(Halfedge h) const noexcept { return StripMesh::next(h); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const noexcept { return mesh_.opposite(h); }
  [[nodiscard]] bool on_boundary(Halfedge h) const noexcept { return StripMesh::on_boundary(h); }
  [[nodiscard]] bool solid(Halfedge h) const noexcept { return mesh_.solid(h); }
  void set_solid(Halfedge h, bool solid) noexcept { mesh_.set_solid(h, solid); }
  [[nodiscard]] FanStep<Halfedge> fan_step(Halfedge h) const noexcept { return mesh_.fan_step(h); }
  [[nodiscard]] bool leaves_boundary(Halfedge h) const noexcept { return mesh_.leaves_boundary(h); }
  Halfedge insert_vertex(const VertexSplit<Halfedge>& where) noexcept { return mesh_.insert_vertex(where, room_); }
  Halfedge insert_vertex(Halfedge left, Halfedge right, std::span<const Halfedge> moved) noexcept {
    return mesh_.insert_vertex(left, right, moved, room_);
  }
  Halfedge remove_vertex(Halfedge chord) noexcept { return mesh_.remove_vertex(chord, room_); }
  Halfedge remove_vertex(Halfedge chord, std::span<const Halfedge> moved) noexcept {
    return mesh_.remove_vertex(chord, moved, room_);
  }

 private:
  StripMesh& mesh_;
  Room& room_;
};

struct Verdict {
  BatchFault fault = BatchFault::done;
  Refusal refusal = Refusal::granted;
};

/// The fault of request i by itself, including whether it names its vertex as the first request does.
template <class Request>
Verdict judge_alone(const StripMesh& mesh, std::span<const Request> requests, std::size_t i) {
  if (const Refusal refusal = check_request(mesh, requests[i]); refusal != Refusal::granted)
    return {BatchFault::refused, refusal};
  if constexpr (std::is_same_v<Request, SplitRequest>) {
    const Vertex name = requests[i].new_vertex;
    if ((name == none) != (requests[0].new_vertex == none)) return {BatchFault::mixed_names, Refusal::granted};
    const Refusal refusal = refusal_of_name(mesh, name);
    if (refusal == Refusal::vertex_in_use) return {BatchFault::vertex_in_use, Refusal::granted};
    if (refusal != Refusal::granted) return {BatchFault::refused, refusal};
  }
  return {};
}

/// The first request with a fault, or BatchFault::done. Two passes: each request enters its number wherever it claims
/// something, the smallest number stays; then each looks whether a smaller one has stayed. That does not depend on the
/// order, so both passes run in parallel.
template <class Request>
BatchReport find_fault(const StripMesh& mesh, std::span<const Request> requests, unsigned threads) {
  std::size_t vertex_bound = mesh.vertex_bound();
  if constexpr (std::is_same_v<Request, SplitRequest>)
    for (const SplitRequest& request : requests)
      if (request.new_vertex != none && refusal_of_name(mesh, request.new_vertex) == Refusal::granted)
        vertex_bound = (std::max)(vertex_bound, request.new_vertex + std::size_t{1});
  std::vector<std::uint32_t> triangles(mesh.triangle_bound(), none);
  std::vector<std::uint32_t> vertices(vertex_bound, none);
  std::vector<Verdict> verdicts(requests.size());

  const auto enter = [threads](std::uint32_t& owner, std::uint32_t number) {
    if (threads == 1) {
      owner = (std::min)(owner, number);
      return;
    }
    const std::atomic_ref<std::uint32_t> shared(owner);
    std::uint32_t now = shared.load(std::memory_order_relaxed);
    while (number < now && !shared.compare_exchange_weak(now, number, std::memory_order_relaxed)) continue;
  };
  parallel_ranges(requests.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      verdicts[i] = judge_alone(mesh, requests, i);
      if (verdicts[i].fault != BatchFault::done) continue;
      const auto number = static_cast<std::uint32_t>(i);
      for_each_claim(
          mesh, requests[i], [&](Triangle t) { enter(triangles[t], number); },
          [&](Vertex v) { enter(vertices[v], number); });
    }
  });
  const auto owner_of = [&](std::size_t i) {
    std::uint32_t earliest = none;
    for_each_claim(
        mesh, requests[i], [&](Triangle t) { earliest = (std::min)(earliest, triangles[t]); },
        [&](Vertex v) { earliest = (std::min)(earliest, vertices[v]); });
    return earliest;
  };
  parallel_ranges(requests.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (verdicts[i].fault == BatchFault::done && owner_of(i) != i) verdicts[i].fault = BatchFault::overlap;
  });

  BatchReport report;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (verdicts[i].fault == BatchFault::done) continue;
    report.fault = verdicts[i].fault;
    report.refusal = verdicts[i].refusal;
    report.request = report.other = i;
    if (report.fault == BatchFault::overlap) report.other = owner_of(i);
    if (report.fault == BatchFault::mixed_names) report.other = 0;
    break;
  }
  return report;
}

/// Runs perform(i), which returns a Rewrite, for every request and adds up.
template <class Perform>
void run_batch(std::size_t requests, unsigned threads, BatchReport& report, const Perform& perform) {
  parallel_ranges(requests, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) report.rewrites[i] = perform(i);
  });
  for (const auto& rewrite : report.rewrites) {
    report.strips += rewrite.strips;
    report.isolated += rewrite.isolated;
  }
}

}  // namespace detail

template <class Operation>
std::optional<std::size_t> PatchClaims::claim_patch(const Operation& operation, std::size_t number) {
  std::uint32_t earliest = none;
  detail::for_each_claim(
      mesh_, operation, [&](Triangle t) { earliest = (std::min)(earliest, triangles_[t]); },
      [&](Vertex v) {
        if (v >= vertices_.size()) vertices_.resize(v + std::size_t{1}, none);
        earliest = (std::min)(earliest, vertices_[v]);
      });
  if (earliest != none) return earliest;
  const auto owner = static_cast<std::uint32_t>(number);
  detail::for_each_claim(
      mesh_, operation, [&](Triangle t) { triangles_[t] = owner; }, [&](Vertex v) { vertices_[v] = owner; });
  return std::nullopt;
}

inline std::optional<std::size_t> PatchClaims::claim(const SplitRequest& request, std::size_t number) {
  RESTRIP_ASSERT_GRANTED(detail::check_request(mesh_, request), "PatchClaims::claim");
  return claim_patch(request, number);
}
inline std::optional<std::size_t> PatchClaims::claim(StripMesh::Halfedge chord, std::size_t number) {
  RESTRIP_ASSERT_GRANTED(detail::check_request(mesh_, chord), "PatchClaims::claim");
  return claim_patch(chord, number);
}

inline BatchReport split_batch(StripMesh& mesh, std::span<const SplitRequest> requests, const BatchOptions& options) {
  BatchReport report;
  if (!options.checked) report = detail::find_fault(mesh, requests, options.threads);
  RESTRIP_ASSERT(!options.checked || detail::find_fault(mesh, requests, 1).fault == BatchFault::done, "split_batch",
                 describe(detail::find_fault(mesh, requests, 1).fault));
  if (report.fault != BatchFault::done) return report;
  report.rewrites.resize(requests.size());
  std::vector<detail::TwoSteps::Room> rooms;
  rooms.reserve(requests.size());
  for (const SplitRequest& request : requests)
    rooms.push_back(detail::TwoSteps::take(mesh, request.where.spokes, request.new_vertex));
  detail::run_batch(requests.size(), options.threads, report, [&](std::size_t i) {
    detail::TwoSteps view(mesh, rooms[i]);
    return split(view, requests[i].where);
  });
  return report;
}

inline BatchReport collapse_batch(StripMesh& mesh, std::span<const StripMesh::Halfedge> chords,
                                  const BatchOptions& options) {
  BatchReport report;
  if (!options.checked) report = detail::find_fault(mesh, chords, options.threads);
  RESTRIP_ASSERT(!options.checked || detail::find_fault(mesh, chords, 1).fault == BatchFault::done, "collapse_batch",
                 describe(detail::find_fault(mesh, chords, 1).fault));
  if (report.fault != BatchFault::done) return report;
  report.rewrites.resize(chords.size());
  std::vector<detail::TwoSteps::Room> freed(chords.size());
  detail::TwoSteps::expect_back(mesh, chords.size());
  detail::run_batch(chords.size(), options.threads, report, [&](std::size_t i) {
    detail::TwoSteps view(mesh, freed[i]);
    return collapse(view, chords[i]);
  });
  for (const auto& room : freed) detail::TwoSteps::give_back(mesh, room);
  return report;
}

}  // namespace restrip
