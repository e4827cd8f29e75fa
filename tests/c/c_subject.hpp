// A mesh of the C interface as a subject of the driver (tests/drive).
#pragma once

#include <array>
#include <vector>

#include "drive/subject.hpp"
#include "handle.hpp"

namespace restrip::c_test {

/// The operations that take one halfedge, in the order of their numbers and of drive::Call.
using AtHalfedge = restrip_status (*)(restrip_mesh*, restrip_halfedge, restrip_change*);
inline constexpr std::array<AtHalfedge, 6> at_halfedge{restrip_mesh_collapse,   restrip_mesh_flip,
                                                       restrip_mesh_split_face, restrip_mesh_join_faces,
                                                       restrip_mesh_bisect,     restrip_mesh_merge};

class CSubject : public drive::Subject {
 public:
  using Call = drive::Call;

  CSubject(Handle mesh, std::size_t history) : mesh_(std::move(mesh)), history_(history) { ranges_.reserve(10'000); }

  [[nodiscard]] bool can(Call call) const override {
    return call != Call::apply && call != Call::move_to_level && call != Call::pack;
  }

  drive::Outcome perform(const drive::Step& step) override {
    drive::Outcome outcome;
    const restrip_status status = status_of(step, outcome);
    using End = drive::Outcome::End;
    outcome.end = status == RESTRIP_OK              ? End::done
                  : status == RESTRIP_OUT_OF_MEMORY ? End::out_of_memory
                  : status < RESTRIP_NULL_ARGUMENT  ? End::refused
                                                    : End::too_wide;
    outcome.reason = is_operation(step.call) ? restrip_describe(status) : "";
    return outcome;
  }

  [[nodiscard]] std::size_t triangle_bound() const override { return restrip_mesh_triangle_bound(m()); }
  [[nodiscard]] std::size_t vertex_bound() const override { return restrip_mesh_vertex_bound(m()); }
  [[nodiscard]] drive::Corners corners(Triangle t) const override {
    drive::Corners corners{none, none, none};
    restrip_mesh_corners(m(), t, corners.data());
    return corners;
  }
  [[nodiscard]] Halfedge opposite(Halfedge h) const override { return {restrip_mesh_opposite(m(), h.id)}; }
  [[nodiscard]] bool solid(Halfedge h) const override { return restrip_mesh_solid(m(), h.id) != 0; }
  [[nodiscard]] std::size_t strips() const override { return strip_count(m()); }

  [[nodiscard]] drive::BufferView buffer() override {
    restrip_buffer_view view{};
    std::size_t room = 0;
    EXPECT_EQ(restrip_live_buffer(m(), &view, &room), RESTRIP_OK);
    draws_.clear();
    for (const restrip_range& draw : std::span(view.draws, view.draw_count)) draws_.push_back({draw.first, draw.count});
    const auto width = static_cast<std::size_t>(view.index_bits) / 8;
    return {{static_cast<const std::byte*>(view.indices), view.index_count * width},
            width,
            room,
            static_cast<StripForm>(view.form),
            draws_};
  }
  [[nodiscard]] std::size_t undoable() const override { return history()[0]; }
  [[nodiscard]] std::size_t redoable() const override { return history()[1]; }
  [[nodiscard]] std::size_t frame() const override { return restrip_live_frame(m()); }

 private:
  [[nodiscard]] restrip_mesh* m() const { return mesh_.get(); }
  [[nodiscard]] std::array<std::size_t, 2> history() const {
    std::array<std::size_t, 2> frames{};
    EXPECT_EQ(restrip_live_history_size(m(), frames.data(), &frames[1]), RESTRIP_OK);
    return frames;
  }

  restrip_status status_of(const drive::Step& step, drive::Outcome& outcome) {
    const restrip_cost cost{step.cost.restart, step.cost.swap, step.cost.isolated};
    std::int32_t done = 0;
    restrip_status status = RESTRIP_OK;
    switch (step.call) {
      case Call::improve:
        return restrip_mesh_improve(m(), step.number, &outcome.number);
      case Call::recolor:
        return restrip_mesh_stripify(m(), RESTRIP_EFFORT_FAST, &cost, 0, &outcome.number);
      case Call::keep:
        return restrip_mesh_keep(m(), static_cast<std::int32_t>(step.policy), &cost);
      case Call::reload:
        return reload();
      case Call::update:
        return update(step.ranges, outcome);
      case Call::undo:
      case Call::redo:
        status = step.call == Call::undo ? restrip_live_undo(m(), &done) : restrip_live_redo(m(), &done);
        outcome.moved = done != 0;
        return status;
      default:
        return operate(step, outcome);
    }
  }

  restrip_status operate(const drive::Step& step, drive::Outcome& outcome) {
    restrip_change change{};
    const restrip_status status = step.by_vertices && has_vertices(step) ? operate_by_vertices(step, &change)
                                                                         : operate_by_halfedges(step, &change);
    if (status != RESTRIP_OK) return status;
    outcome.rewrite.strips = change.strips;
    outcome.rewrite.isolated = change.isolated;
    if (step.call == Call::split || step.call == Call::split_face || step.call == Call::bisect)
      outcome.added.push_back(restrip_mesh_to(m(), change.halfedge));
    return status;
  }

  restrip_status operate_by_halfedges(const drive::Step& step, restrip_change* change) {
    const restrip_halfedge left = step.where.left.id;
    if (step.call == Call::split) return restrip_mesh_split(m(), left, step.where.right.id, step.name, change);
    if (step.call != Call::replace) return at_halfedge[static_cast<std::size_t>(step.call) - 1](m(), left, change);
    return restrip_mesh_replace(m(), step.out.data(), step.out.size(), step.in.empty() ? nullptr : step.in[0].data(),
                                step.in.size(), change);
  }

  /// Collapses, flips and splits at spokes of one vertex.
  [[nodiscard]] bool has_vertices(const drive::Step& step) const {
    const auto [left, right] = ends(step);
    if (step.call != Call::split) return step.call <= Call::flip && left[0] != none;
    return (left[0] != none || step.where.left.id == none) && (right[0] != none || step.where.right.id == none) &&
           (left[0] == right[0] || left[0] == none || right[0] == none);
  }
  restrip_status operate_by_vertices(const drive::Step& step, restrip_change* change) {
    const auto [left, right] = ends(step);
    if (step.call == Call::collapse) return restrip_mesh_collapse_at(m(), left[0], left[1], change);
    if (step.call == Call::flip) return restrip_mesh_flip_at(m(), left[0], left[1], change);
    return restrip_mesh_split_at(m(), left[0] == none ? right[0] : left[0], left[1], right[1], step.name, change);
  }
  /// The vertices of both halfedges, from and to.
  [[nodiscard]] std::array<std::array<std::uint32_t, 2>, 2> ends(const drive::Step& step) const {
    const auto of = [this](Halfedge h) { return std::array{restrip_mesh_from(m(), h.id), restrip_mesh_to(m(), h.id)}; };
    return {of(step.where.left), of(step.where.right)};
  }

  restrip_status update(const RangeOptions& options, drive::Outcome& outcome) {
    const restrip_range* ranges = nullptr;
    std::size_t count = 0;
    std::int32_t outgrown = 0;
    const restrip_status status =
        restrip_live_update(m(), options.merge_gap, options.align, &ranges, &count, &outgrown);
    ranges_.clear();
    for (const restrip_range& range : std::span(ranges, count)) ranges_.push_back({range.first, range.count});
    outcome.upload = {ranges_, outgrown != 0};
    return status;
  }

  restrip_status reload() {
    const void* bytes = nullptr;
    std::size_t size = 0;
    if (const restrip_status status = restrip_mesh_save(m(), &bytes, &size); status != RESTRIP_OK) return status;
    restrip_mesh* loaded = nullptr;
    const restrip_status status = restrip_mesh_load(bytes, size, history_, nullptr, 0, &loaded);
    if (status == RESTRIP_OK) mesh_.reset(loaded);
    return status;
  }

  Handle mesh_;
  std::size_t history_;
  std::vector<IndexRange> draws_;
  std::vector<IndexRange> ranges_;
};

}  // namespace restrip::c_test
