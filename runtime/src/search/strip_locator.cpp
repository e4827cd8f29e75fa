// Strips as treaps.
//
// Outline. Each strip is a binary tree in the order of its triangles; the name of the strip is the root. A node has the
// size of its subtree, so a climb to the root counts the triangles before it. A parent has a higher rank than its
// children, and ranks are fixed pseudo-random numbers: so a tree is as deep as one made in random order, whatever the
// strips went through. A cut splits a tree along the way from a node to the root; a link puts two trees together along
// their inner spines, after it has turned one around if need be: a bit at the root says so, and is pushed down on the
// way. A rewrite takes the triangles of the patch out by cuts at its rim and puts the new ones in by links.
//
// Invariant. The tree of a strip has exactly its triangles, in their order or in reverse.
//
// Cost. Expected depth about 2 ln n. Queries change nothing.
//
// Source. Seidel, Aragon, "Randomized search trees", Algorithmica 16, 1996.
#include "search/strip_locator.hpp"

#include "restrip/output/strips.hpp"

namespace restrip {

namespace {

// The finalizer of MurmurHash3 (Appleby, 2011): one to one, so no two triangles have the same rank.
constexpr std::uint32_t rank_of(Triangle t) noexcept {
  t = (t ^ t >> 16) * 0x85EBCA6BU;
  t = (t ^ t >> 13) * 0xC2B2AE35U;
  return t ^ t >> 16;
}

}  // namespace

// ---- trees

// The position of t. If `above`, which precedes or follows t, is an ancestor of it, `step` is added to the order of t
// to get the order of `above`. Without branches on the shape of the tree, which no processor predicts.
StripLocator::Position StripLocator::climb(Triangle t, Triangle above, int& step) const noexcept {
  RESTRIP_ASSERT(knows(t), "StripLocator::position", "the locator does not know the triangle");
  const Node* node = &nodes_[t];
  const Triangle first = node->child[0];
  std::uint32_t before = first == none ? 0 : nodes_[first].size;
  for (;;) {
    const std::uint32_t turned = 0U - std::uint32_t{node->turned};  // a mask; size + ~before is size - 1 - before
    before = (before ^ turned) + (node->size & turned);
    step = node->turned ? -step : step;
    if (node->parent == none) return {t, before};
    const Node& parent = nodes_[node->parent];
    const bool on_right = parent.child[1] == t;
    before += (parent.size - node->size) & (0U - std::uint32_t{on_right});
    t = node->parent;
    if (t == above) step = on_right ? -1 : 1;
    node = &parent;
  }
}

StripLocator::Position StripLocator::position(Triangle t) const noexcept {
  int unused = 0;
  return climb(t, none, unused);
}
// Of two triangles that follow each other in order, one is an ancestor of the other.
std::pair<StripLocator::Position, std::uint32_t> StripLocator::position(Triangle t, Triangle next) const noexcept {
  int step = 0;
  const bool t_above = rank_of(t) > rank_of(next);
  Position below = climb(t_above ? next : t, t_above ? t : next, step);
  const std::uint32_t above = below.order + static_cast<std::uint32_t>(step);
  if (!t_above) return {below, above};
  return {{below.strip, above}, below.order};
}

void StripLocator::turn(Triangle t) noexcept { nodes_[t].turned = !nodes_[t].turned; }
void StripLocator::push_down(Triangle t) noexcept {
  Node& node = nodes_[t];
  if (!node.turned) return;
  node.turned = false;
  std::swap(node.child[0], node.child[1]);
  for (const Triangle child : node.child)
    if (child != none) turn(child);
}
void StripLocator::push_down_to(Triangle t) noexcept {
  if (nodes_[t].parent != none) push_down_to(nodes_[t].parent);
  push_down(t);
}
// The child may be none.
void StripLocator::hang(Triangle child, Triangle parent, unsigned side) noexcept {
  nodes_[parent].child[side] = child;
  if (child != none) nodes_[child].parent = parent;
}

// Puts two trees together, by their roots, and returns the root.
Triangle StripLocator::append(Triangle first, Triangle second) noexcept {
  if (first == none || second == none) return first != none ? first : second;
  const bool first_on_top = rank_of(first) > rank_of(second);
  const Triangle top = first_on_top ? first : second;
  push_down(top);
  nodes_[top].size = nodes_[first].size + nodes_[second].size;
  if (first_on_top)
    hang(append(nodes_[first].child[1], second), first, 1);
  else
    hang(append(first, nodes_[second].child[0]), second, 0);
  return top;
}

// Cuts a strip between two triangles that follow each other.
void StripLocator::part(Triangle a, Triangle b) noexcept {
  const bool a_above = rank_of(a) > rank_of(b);
  const Triangle above = a_above ? a : b;
  Triangle below = a_above ? b : a;
  push_down_to(below);
  // The lower one is at the edge of a subtree of the other, and nothing hangs on its side of the cut.
  Triangle t = nodes_[below].parent;
  const bool on_right = nodes_[t].child[1] == below;
  std::array<Triangle, 2> half{none, none};
  half[(t == above) == on_right ? 1 : 0] = below;
  // On the way up each node, with its other subtree, goes to the part before the cut or to the one after it.
  while (t != none) {
    Node& node = nodes_[t];
    const unsigned side = node.child[1] == below ? 0 : 1;
    hang(half[side], t, 1 - side);
    const auto size_of = [this](Triangle child) { return child == none ? 0 : nodes_[child].size; };
    node.size = 1 + size_of(node.child[0]) + size_of(node.child[1]);
    half[side] = below = t;
    t = node.parent;
  }
  for (const Triangle root : half) nodes_[root].parent = none;
  ++strips_;
}

// Links two ends of different strips.
void StripLocator::join(Triangle a, Triangle b) noexcept {
  const Position first = position(a);
  const Position second = position(b);
  if (first.order + 1 != nodes_[first.strip].size) turn(first.strip);
  if (second.order != 0) turn(second.strip);
  append(first.strip, second.strip);
  --strips_;
}

// ---- strips

void StripLocator::rebuild(const StripMesh& mesh) {
  nodes_.assign(mesh.triangle_bound(), {});
  const Strips strips = detail::valid_strips(mesh);
  strips_ = strips.size();
  for (std::size_t s = 0; s < strips.size(); ++s) {
    Triangle root = none;
    for (const Triangle t : strips[s]) {
      nodes_[t].size = 1;
      root = append(root, t);
    }
  }
}

void StripLocator::cut(StripMesh& mesh, Halfedge h) {
  RESTRIP_ASSERT(mesh.solid(h), "StripLocator::cut", "the dual edge is dashed already");
  mesh.set_solid(h, false);
  part(StripMesh::triangle(h), StripMesh::triangle(mesh.opposite(h)));
}

void StripLocator::link(StripMesh& mesh, Halfedge h) {
  RESTRIP_ASSERT(!mesh.solid(h), "StripLocator::link", "the dual edge is solid already");
  const Triangle a = StripMesh::triangle(h);
  const Triangle b = StripMesh::triangle(mesh.opposite(h));
  RESTRIP_ASSERT(mesh.solid_degree(a) < 2 && mesh.solid_degree(b) < 2, "StripLocator::link",
                 "a triangle at the dual edge is not the end of a strip");
  RESTRIP_ASSERT(position(a).strip != position(b).strip, "StripLocator::link",
                 "the dual edge joins the two ends of one strip");
  mesh.set_solid(h, true);
  join(a, b);
}

// Calls visit(t, u) for each solid edge of the triangles t of the patch; once if u is in the patch, too.
template <class Visit>
void StripLocator::for_each_solid_edge(const StripMesh& mesh, std::span<const Triangle> patch, Visit&& visit) const {
  for (const Triangle t : patch)
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      if (!mesh.solid(h)) continue;
      const Triangle u = StripMesh::triangle(mesh.opposite(h));
      if (!nodes_[u].in_patch || t < u) visit(t, u);
    }
}

void StripLocator::before_patch(const StripMesh& mesh, std::span<const Triangle> patch) {
  for (const Triangle t : patch) nodes_[t].in_patch = true;
  strips_ -= patch.size();
  for_each_solid_edge(mesh, patch,
                      [this](Triangle t, Triangle u) { nodes_[u].in_patch ? void(++strips_) : part(t, u); });
  for (const Triangle t : patch) nodes_[t] = {};
}

void StripLocator::after_patch(const StripMesh& mesh, std::span<const Triangle> patch) {
  if (nodes_.size() < mesh.triangle_bound()) nodes_.resize(mesh.triangle_bound());
  for (const Triangle t : patch) nodes_[t] = {.size = 1, .in_patch = true};
  strips_ += patch.size();
  for_each_solid_edge(mesh, patch, [this](Triangle t, Triangle u) { join(t, u); });
  for (const Triangle t : patch) nodes_[t].in_patch = false;
}

}  // namespace restrip
