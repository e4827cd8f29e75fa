// A trace is made of differences: the triangles that the watch has named, before and now.
//
// Outline. The trace keeps corners and solid sides of each triangle as they were written last. For an operation it
// compares the triangles named, writes those that went and came, and the solid edges that only one of the two sets has.
//
// Cost: linear in the triangles named, up to a logarithm.
#include "restrip/output/trace.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace restrip {

template <class Number, std::size_t n>
void Trace::append(const std::array<Number, n>& numbers) {
  for (const Number number : numbers) {
    std::array<char, 24> digits{};
    digits[0] = ' ';
    const auto last = std::to_chars(digits.data() + 1, digits.data() + digits.size(), number).ptr;
    text_.append(digits.data(), last);
  }
}

template <class Numbers>
void Trace::line(std::string_view word, const Numbers& numbers) {
  text_ += word;
  append(numbers);
  text_ += '\n';
}

template <class Numbers>
void Trace::list(std::string_view sign, const std::vector<Numbers>& all) {
  if (all.empty()) return;
  text_ += sign;
  for (const Numbers& numbers : all) append(numbers);
}

Trace::SeenTriangle Trace::seen(const StripMesh& mesh, std::uint32_t t) {
  SeenTriangle now;
  if (t >= mesh.triangle_bound() || !mesh.alive(t)) return now;
  const auto corner = [&](auto of) { return static_cast<std::uint32_t>(mesh.from(of)); };
  auto h = StripMesh::halfedge(t);
  const auto second = StripMesh::next(h);
  for (const auto other : {second, StripMesh::next(second)})
    if (corner(other) < corner(h)) h = other;
  for (std::size_t side = 0; side < 3; ++side, h = StripMesh::next(h)) {
    now.corners[side] = corner(h);
    if (!StripMesh::on_boundary(mesh.opposite(h)) && mesh.solid(h)) now.solid |= 1U << side;
  }
  return now;
}

void Trace::solid_edges(const SeenTriangle& triangle, std::vector<Edge>& edges) {
  for (std::size_t side = 0; side < 3; ++side) {
    if ((triangle.solid >> side & 1U) == 0) continue;
    const std::uint32_t from = triangle.corners[side];
    const std::uint32_t to = triangle.corners[side == 2 ? 0 : side + 1];
    edges.push_back({(std::min)(from, to), (std::max)(from, to)});
  }
}

void Trace::settle(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

const std::vector<Trace::Edge>& Trace::differences(const std::vector<Edge>& of, const std::vector<Edge>& from) {
  difference_.clear();
  std::set_difference(of.begin(), of.end(), from.begin(), from.end(), std::back_inserter(difference_));
  return difference_;
}

Trace::Trace(const StripMesh& mesh, Claim claim) {
  constexpr std::array<std::string_view, 3> words{"valid", "no-worse", "best"};
  text_ = "restrip-trace 1\nclaim ";
  text_ += words[static_cast<std::size_t>(claim)];
  text_ += '\n';
  seen_.resize(mesh.triangle_bound());
  for (std::uint32_t t = 0; t < seen_.size(); ++t) {
    seen_[t] = seen(mesh, t);
    if (!seen_[t].there()) continue;
    line("t", seen_[t].corners);
    solid_edges(seen_[t], after_);
  }
  settle(after_);
  for (const Edge& edge : after_) line("s", edge);
}

void Trace::add(const StripMesh& mesh, std::span<const std::uint32_t> changed, const Traced& done) {
  constexpr std::array<std::string_view, 4> words{"split", "collapse", "flip", "other"};
  named_.assign(changed.begin(), changed.end());
  std::sort(named_.begin(), named_.end());
  named_.erase(std::unique(named_.begin(), named_.end()), named_.end());
  if (seen_.size() < mesh.triangle_bound()) seen_.resize(mesh.triangle_bound());
  before_.clear();
  after_.clear();
  gone_.clear();
  come_.clear();
  for (const std::uint32_t t : named_) {
    const SeenTriangle now = seen(mesh, t);
    SeenTriangle& then = seen_[t];
    solid_edges(then, before_);
    solid_edges(now, after_);
    if (then.corners != now.corners) {
      if (then.there()) gone_.push_back(then.corners);
      if (now.there()) come_.push_back(now.corners);
    }
    then = now;
  }
  settle(before_);
  settle(after_);
  text_ += words[static_cast<std::size_t>(done.kind)];
  append(std::array{done.from, done.to});
  append(std::array{done.strips, done.isolated});
  list(" -", gone_);
  list(" +", come_);
  list(" d", differences(before_, after_));
  list(" s", differences(after_, before_));
  text_ += '\n';
  ++operations_;
}

void Trace::end() { line("end", std::array{operations_}); }

}  // namespace restrip
