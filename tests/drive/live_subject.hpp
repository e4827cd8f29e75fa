// A LiveMesh as a subject of the driver.
#pragma once

#include "drive/subject.hpp"

namespace restrip::drive {

class LiveSubject : public Subject {
 public:
  /// `history`: the budget, of which a loaded mesh gets as much.
  explicit LiveSubject(LiveMesh live, std::size_t history) : history_(history), live_(std::move(live)) {}

  Outcome perform(const Step& step) override;
  [[nodiscard]] bool can(Call call) const override { return call != Call::move_to_level || live_.level().has_value(); }

  [[nodiscard]] std::size_t triangle_bound() const override { return live_.mesh().triangle_bound(); }
  [[nodiscard]] std::size_t vertex_bound() const override { return live_.mesh().vertex_bound(); }
  [[nodiscard]] Corners corners(Triangle t) const override { return live_.mesh().corners(t); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const override;
  [[nodiscard]] bool solid(Halfedge h) const override { return live_.mesh().solid(h); }
  [[nodiscard]] std::size_t strips() const override { return live_.strips(); }
  [[nodiscard]] std::vector<std::uint32_t> look() const override;

  [[nodiscard]] BufferView buffer() override;
  [[nodiscard]] std::size_t undoable() const override { return live_.undoable(); }
  [[nodiscard]] std::size_t redoable() const override { return live_.redoable(); }
  [[nodiscard]] std::size_t frame() const override { return live_.frame(); }

  [[nodiscard]] const LiveMesh* live() const override { return &live_; }

 protected:
  std::size_t history_;
  LiveMesh live_;
  std::vector<IndexRange> draws_;
};

}  // namespace restrip::drive
