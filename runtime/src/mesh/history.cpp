// Undo and redo of frames: differences between the mesh and a copy of it.
//
// Outline. frame() compares every triangle that the watch has named with the copy, and the first spokes of the corners
// that it had or has. Of what differs it stores number and old value, and brings the copy in step; so a triangle
// that is named again no longer differs, and no list has to be sorted. Lists of free handles change at their ends only,
// by at most three elements for each triangle named, so that many elements at their ends are compared.
//
// undo() and redo() are the same step: every stored value is exchanged with the value in the mesh.
//
// Invariant: outside of frame(), the copy equals the mesh as it was at the end of the frame `done_`. Elements beyond
// the end of an array count as removed triangles, vertices without spokes, and free entries of `none`.
//
// Cost: linear in the triangles named by the watch, and in those of a frame for a step.
#include "mesh/history.hpp"

#include <algorithm>
#include <cstring>

namespace restrip {

namespace {

constexpr std::size_t words_of_triangle = 7;  // number, corners, links
constexpr std::size_t words_of_value = 2;     // number, value

}  // namespace

RESTRIP_COLD History::History(const StripMesh& mesh, std::size_t most_triangles) : last_(mesh), most_(most_triangles) {}

std::size_t History::Frame::size() const noexcept {
  return (std::max)(data.size() / words_of_triangle, std::size_t{1});
}

History::Sizes History::sizes_of(const StripMesh& mesh) noexcept {
  return {mesh.triangles_.size(), mesh.spoke_.size(), mesh.free_.size(), mesh.free_vertices_.size()};
}

void History::resize(StripMesh& mesh, const Sizes& sizes) {
  // Also of a handle that a frame took and gave back.
  constexpr StripMesh::Record removed{{none, none, none},
                                      {StripMesh::edge_of_mesh, StripMesh::edge_of_mesh, StripMesh::edge_of_mesh}};
  mesh.triangles_.resize(sizes.triangles, removed);
  mesh.spoke_.resize(sizes.vertices, none);
  mesh.non_manifold_.resize(sizes.vertices, 0);
  mesh.free_.resize(sizes.free, none);
  mesh.free_vertices_.resize(sizes.free_vertices, none);
}

void History::note_end(std::vector<std::uint32_t>& last, const std::vector<std::uint32_t>& now, std::size_t changes) {
  const std::size_t both = (std::min)(last.size(), now.size());
  const std::size_t all = (std::max)(last.size(), now.size());
  for (std::size_t i = both - (std::min)(both, changes); i < all; ++i) {
    const std::uint32_t before = i < last.size() ? last[i] : none;
    if (i >= both || before != now[i]) data_.insert(data_.end(), {static_cast<std::uint32_t>(i), before});
    if (i < both) last[i] = now[i];
  }
  last.resize(both);
  last.insert(last.end(), now.begin() + static_cast<std::ptrdiff_t>(both), now.end());
}

bool History::frame(const StripMesh& mesh, std::span<const Triangle> changed) {
  Frame frame;
  frame.sizes = sizes_of(last_);
  const Sizes now = sizes_of(mesh);
  if (changed.empty() && frame.sizes == now) return false;
  resize(last_, {now.triangles, now.vertices, frame.sizes.free, frame.sizes.free_vertices});
  data_.clear();
  std::size_t at = 0;
  data_.resize(words_of_triangle * changed.size());
  Triangle named = none;  // often several times in a row
  for (const Triangle t : changed) {
    if (t == named || t >= now.triangles) continue;
    named = t;
    StripMesh::Record& before = last_.triangles_[t];
    const StripMesh::Record& after = mesh.triangles_[t];
    if (std::memcmp(&before, &after, sizeof(StripMesh::Record)) == 0) continue;
    data_[at] = t;
    std::memcpy(data_.data() + at + 1, &before, sizeof(StripMesh::Record));
    before = after;
    at += words_of_triangle;
  }
  data_.resize(at);
  frame.triangles = at / words_of_triangle;
  const auto note_spoke = [&](Vertex v) {
    if (v == none || last_.spoke_[v] == mesh.spoke_[v]) return;
    data_.insert(data_.end(), {v, last_.spoke_[v]});
    last_.spoke_[v] = mesh.spoke_[v];
  };
  // A frame may also change the first spoke of a vertex whose triangles are as they were.
  for (std::size_t i = 0; i < at; i += words_of_triangle)
    for (std::size_t corner = 1; corner <= 3; ++corner) note_spoke(data_[i + corner]);
  named = none;
  for (const Triangle t : changed) {
    if (t == named || t >= now.triangles) continue;
    named = t;
    for (const Vertex v : mesh.triangles_[t].corner) note_spoke(v);
  }
  frame.spokes = (data_.size() - at) / words_of_value;
  note_end(last_.free_, mesh.free_, changed.size());
  frame.free = (data_.size() - at) / words_of_value - frame.spokes;
  note_end(last_.free_vertices_, mesh.free_vertices_, 3 * changed.size());
  if (data_.empty() && frame.sizes == now) return false;
  frame.data = data_;
  for (; frames_.size() > done_; frames_.pop_back()) kept_ -= frames_.back().size();
  kept_ += frame.size();
  frames_.push_back(std::move(frame));
  ++done_;
  for (; kept_ > most_ && frames_.size() > 1; ++dropped_, --done_) {
    kept_ -= frames_.front().size();
    frames_.pop_front();
  }
  return true;
}

bool History::undo(StripMesh& mesh) {
  if (undoable() == 0) return false;
  step(mesh, frames_[done_ - 1]);
  --done_;
  return true;
}
bool History::redo(StripMesh& mesh) {
  if (redoable() == 0) return false;
  step(mesh, frames_[done_]);
  ++done_;
  return true;
}

void History::step(StripMesh& mesh, Frame& frame) {
  const Sizes now = sizes_of(mesh);
  const Sizes then = frame.sizes;
  const Sizes both{(std::max)(now.triangles, then.triangles), (std::max)(now.vertices, then.vertices),
                   (std::max)(now.free, then.free), (std::max)(now.free_vertices, then.free_vertices)};
  mesh.expect_touches(frame.triangles);
  for (StripMesh* const one : {&mesh, &last_}) {  // after this nothing throws
    detail::make_room(one->triangles_, both.triangles - now.triangles);
    detail::make_room(one->spoke_, both.vertices - now.vertices);
    detail::make_room(one->non_manifold_, both.vertices - now.vertices);
    detail::make_room(one->free_, both.free - now.free);
    detail::make_room(one->free_vertices_, both.free_vertices - now.free_vertices);
  }
  resize(mesh, both);
  resize(last_, both);
  std::uint32_t* word = frame.data.data();
  for (std::size_t i = 0; i < frame.triangles; ++i, word += words_of_triangle) {
    const StripMesh::Record after = mesh.triangles_[*word];
    std::memcpy(&mesh.triangles_[*word], word + 1, sizeof(StripMesh::Record));
    last_.triangles_[*word] = mesh.triangles_[*word];
    std::memcpy(word + 1, &after, sizeof(StripMesh::Record));
    mesh.touch(*word);
  }
  const auto exchange = [&word](std::size_t count, std::vector<std::uint32_t>& list, std::vector<std::uint32_t>& copy) {
    for (; count > 0; --count, word += words_of_value) {
      std::swap(list[word[0]], word[1]);
      copy[word[0]] = list[word[0]];
    }
  };
  const std::size_t values = (frame.data.size() - frame.triangles * words_of_triangle) / words_of_value;
  exchange(frame.spokes, mesh.spoke_, last_.spoke_);
  exchange(frame.free, mesh.free_, last_.free_);
  exchange(values - frame.spokes - frame.free, mesh.free_vertices_, last_.free_vertices_);
  resize(mesh, then);
  resize(last_, then);
  frame.sizes = now;
}

}  // namespace restrip
