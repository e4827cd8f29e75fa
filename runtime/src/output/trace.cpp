// A trace is made of differences: the triangles that the watch has named, before and now.
//
// Outline. The trace keeps corners and solid sides of each triangle as they were written last. For an operation it
// compares the triangles named, writes those that went and came, and the solid edges that only one of the two sets has.
//
// Cost: linear in the triangles named, up to a logarithm.
#include "restrip/output/trace.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

namespace restrip {

namespace detail {

using TracedEdge = std::array<std::uint32_t, 2>;     // the smaller vertex first
using TracedCorners = std::array<std::uint32_t, 3>;  // counter-clockwise, the smallest first

struct TracedTriangle {
  TracedCorners corners{none, none, none};
  std::uint32_t solid = 0;  // bit s: the edge from corner s to the next one
  [[nodiscard]] bool there() const noexcept { return corners[0] != none; }
};

}  // namespace detail

namespace {

using detail::TracedCorners;
using detail::TracedEdge;
using detail::TracedTriangle;

TracedTriangle traced_triangle(const StripMesh& mesh, Triangle t) {
  TracedTriangle now;
  if (t >= mesh.triangle_bound() || !mesh.alive(t)) return now;
  Halfedge h = StripMesh::halfedge(t);
  const Halfedge second = StripMesh::next(h);
  for (const Halfedge other : {second, StripMesh::next(second)})
    if (mesh.from(other) < mesh.from(h)) h = other;
  for (std::size_t side = 0; side < 3; ++side, h = StripMesh::next(h)) {
    now.corners[side] = mesh.from(h);
    if (!StripMesh::on_boundary(mesh.opposite(h)) && mesh.solid(h)) now.solid |= 1U << side;
  }
  return now;
}

void add_solid_edges(const TracedTriangle& triangle, std::vector<TracedEdge>& edges) {
  for (std::size_t side = 0; side < 3; ++side) {
    if ((triangle.solid >> side & 1U) == 0) continue;
    const std::uint32_t from = triangle.corners[side];
    const std::uint32_t to = triangle.corners[side == 2 ? 0 : side + 1];
    edges.push_back({(std::min)(from, to), (std::max)(from, to)});
  }
}

/// Leaves each edge once: it was found from both of its triangles, or from one.
void settle(std::vector<TracedEdge>& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

}  // namespace

struct Trace::Writer {
  std::string text;
  std::size_t operations = 0;
  std::vector<TracedTriangle> seen;  // by triangle
  // Scratch lists of one operation, kept for their memory.
  std::vector<Triangle> named;
  std::vector<TracedEdge> before;
  std::vector<TracedEdge> after;
  std::vector<TracedEdge> difference;
  std::vector<TracedCorners> gone;
  std::vector<TracedCorners> come;

  template <class Number, std::size_t n>
  void append(const std::array<Number, n>& numbers) {
    for (const Number number : numbers) {
      std::array<char, 24> digits{};
      digits[0] = ' ';
      const auto last = std::to_chars(digits.data() + 1, digits.data() + digits.size(), number).ptr;
      text.append(digits.data(), last);
    }
  }
  template <class Numbers>
  void line(std::string_view word, const Numbers& numbers) {
    text += word;
    append(numbers);
    text += '\n';
  }
  template <class Numbers>
  void list(std::string_view sign, const std::vector<Numbers>& all) {
    if (all.empty()) return;
    text += sign;
    for (const Numbers& numbers : all) append(numbers);
  }
  /// The edges of one list that the other lacks.
  void list_more(std::string_view sign, const std::vector<TracedEdge>& of, const std::vector<TracedEdge>& from) {
    difference.clear();
    std::set_difference(of.begin(), of.end(), from.begin(), from.end(), std::back_inserter(difference));
    list(sign, difference);
  }
};

Trace::Trace(const StripMesh& mesh, Claim claim) : writer_(std::make_unique<Writer>()) {
  constexpr std::array<std::string_view, 3> words{"valid", "no-worse", "best"};
  Writer& out = *writer_;
  out.text = "restrip-trace 1\nclaim ";
  out.text += words[static_cast<std::size_t>(claim)];
  out.text += '\n';
  out.seen.resize(mesh.triangle_bound());
  for (Triangle t = 0; t < out.seen.size(); ++t) {
    out.seen[t] = traced_triangle(mesh, t);
    if (!out.seen[t].there()) continue;
    out.line("t", out.seen[t].corners);
    add_solid_edges(out.seen[t], out.after);
  }
  settle(out.after);
  for (const TracedEdge& edge : out.after) out.line("s", edge);
}
Trace::Trace(Trace&& other) noexcept = default;
Trace& Trace::operator=(Trace&& other) noexcept = default;
Trace::~Trace() = default;

void Trace::add(const StripMesh& mesh, std::span<const std::uint32_t> changed, const Traced& done) {
  constexpr std::array<std::string_view, 4> words{"split", "collapse", "flip", "other"};
  Writer& out = *writer_;
  out.named.assign(changed.begin(), changed.end());
  detail::sort_unique(out.named);
  if (out.seen.size() < mesh.triangle_bound()) out.seen.resize(mesh.triangle_bound());
  out.before.clear();
  out.after.clear();
  out.gone.clear();
  out.come.clear();
  for (const Triangle t : out.named) {
    const TracedTriangle now = traced_triangle(mesh, t);
    TracedTriangle& then = out.seen[t];
    add_solid_edges(then, out.before);
    add_solid_edges(now, out.after);
    if (then.corners != now.corners) {
      if (then.there()) out.gone.push_back(then.corners);
      if (now.there()) out.come.push_back(now.corners);
    }
    then = now;
  }
  settle(out.before);
  settle(out.after);
  out.text += words[static_cast<std::size_t>(done.kind)];
  out.append(std::array{done.from, done.to});
  out.append(std::array{done.strips, done.isolated});
  out.list(" -", out.gone);
  out.list(" +", out.come);
  out.list_more(" d", out.before, out.after);
  out.list_more(" s", out.after, out.before);
  out.text += '\n';
  ++out.operations;
}

void Trace::end() { writer_->line("end", std::array{writer_->operations}); }
std::string& Trace::text() noexcept { return writer_->text; }

}  // namespace restrip
