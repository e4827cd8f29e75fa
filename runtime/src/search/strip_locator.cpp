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

StripLocator::Position StripLocator::position(Triangle t) const noexcept {
  RESTRIP_ASSERT(knows(t), "StripLocator::position", "the locator does not know the triangle");
  const Node* node = &nodes_[t];
  std::uint32_t before = size(node->child[0]);
  for (;;) {
    if (node->turned) before = node->size - 1 - before;
    if (node->parent == none) return {t, before};
    const Node& parent = nodes_[node->parent];
    if (parent.child[1] == t) before += parent.size - node->size;
    t = node->parent;
    node = &parent;
  }
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
// Either may be none.
void StripLocator::hang(Triangle child, Triangle parent, unsigned side) noexcept {
  if (parent != none) nodes_[parent].child[side] = child;
  if (child != none) nodes_[child].parent = parent;
}

// Puts two trees together, by their roots, and returns the root.
Triangle StripLocator::append(Triangle first, Triangle second) noexcept {
  Triangle root = none;
  Triangle parent = none;
  unsigned side = 0;
  while (first != none && second != none) {
    const bool first_on_top = rank_of(first) > rank_of(second);
    const Triangle top = first_on_top ? first : second;
    push_down(top);
    nodes_[top].size = nodes_[first].size + nodes_[second].size;
    hang(top, parent, side);
    if (root == none) root = top;
    parent = top;
    side = first_on_top ? 1 : 0;
    (first_on_top ? first : second) = nodes_[top].child[side];
  }
  hang(first != none ? first : second, parent, side);
  return root != none ? root : first != none ? first : second;
}

void StripLocator::push_down_to(Triangle t) noexcept {
  if (nodes_[t].parent != none) push_down_to(nodes_[t].parent);
  push_down(t);
}

// Cuts a strip between two triangles that follow each other.
void StripLocator::part(Triangle a, Triangle b) noexcept {
  if (position(b).order < position(a).order) std::swap(a, b);
  push_down_to(a);
  // On the way up each node, with its other subtree, goes to the part before the cut or to the one after it.
  std::array<Triangle, 2> half{none, nodes_[a].child[1]};
  Triangle below = nodes_[a].child[1];
  for (Triangle t = a; t != none;) {
    const Triangle above = nodes_[t].parent;
    const unsigned side = nodes_[t].child[1] == below ? 0 : 1;
    hang(half[side], t, 1 - side);
    nodes_[t].size = 1 + size(nodes_[t].child[0]) + size(nodes_[t].child[1]);
    half[side] = t;
    below = t;
    t = above;
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
  strips_ = 0;
  for (Triangle t = 0; t < nodes_.size(); ++t)
    if (mesh.alive(t) && mesh.solid_degree(t) > 2) detail::throw_three_solid_edges();
  std::size_t placed = 0;
  for (Triangle t = 0; t < nodes_.size(); ++t) {
    if (!mesh.alive(t) || nodes_[t].size != 0 || mesh.solid_degree(t) > 1) continue;
    ++strips_;
    Triangle root = none;
    StripStep step{true, StripMesh::halfedge(t, 3)};
    for (; step.continues; step = mesh.strip_step(step.in), ++placed) {
      const Triangle next = StripMesh::triangle(step.in);
      nodes_[next].size = 1;
      root = append(root, next);
    }
  }
  // If no triangle has three solid edges, a strip without an end is a cycle.
  if (placed != mesh.triangle_count()) detail::throw_solid_cycle();
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

// Calls visit(t, u) for each solid edge between triangles of the patch, or between the patch and its neighbours.
template <class Visit>
void StripLocator::for_each_solid_edge(const StripMesh& mesh, std::span<const Triangle> patch, bool inner,
                                       Visit&& visit) const {
  for (const Triangle t : patch)
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      if (!mesh.solid(h)) continue;
      const Triangle u = StripMesh::triangle(mesh.opposite(h));
      if (inner ? nodes_[u].in_patch && t < u : !nodes_[u].in_patch) visit(t, u);
    }
}

void StripLocator::before_patch(const StripMesh& mesh, std::span<const Triangle> patch) {
  for (const Triangle t : patch) nodes_[t].in_patch = true;
  for_each_solid_edge(mesh, patch, false, [this](Triangle t, Triangle u) { part(t, u); });
  for_each_solid_edge(mesh, patch, true, [this](Triangle, Triangle) { ++strips_; });
  strips_ -= patch.size();
  for (const Triangle t : patch) nodes_[t] = {};
}

void StripLocator::after_patch(const StripMesh& mesh, std::span<const Triangle> patch) {
  if (nodes_.size() < mesh.triangle_bound()) nodes_.resize(mesh.triangle_bound());
  for (const Triangle t : patch) {
    nodes_[t].size = 1;
    nodes_[t].in_patch = true;
  }
  strips_ += patch.size();
  for (const bool inner : {true, false})
    for_each_solid_edge(mesh, patch, inner, [this](Triangle t, Triangle u) { join(t, u); });
  for (const Triangle t : patch) nodes_[t].in_patch = false;
}

}  // namespace restrip
