// StripIndex: the treap of chunks. Included by strip_index.hpp.
#pragma once

#include <utility>

#include "restrip/strip_index.hpp"

namespace restrip {

// A bijection of 32-bit words that mixes well: no two chunks have the same priority.
inline std::uint32_t StripIndex::priority(ChunkId c) noexcept {
  c = (c ^ c >> 16) * 0x7feb352dU;
  c = (c ^ c >> 15) * 0x846ca68bU;
  return c ^ c >> 16;
}

inline void StripIndex::update(ChunkId c) noexcept {
  Chunk& chunk = chunks_[c];
  chunk.size = 1 + size(chunk.left) + size(chunk.right);
  if (chunk.left != none) chunks_[chunk.left].parent = c;
  if (chunk.right != none) chunks_[chunk.right].parent = c;
}

// Hands the reversal of a subtree down to the chunk and its children.
inline void StripIndex::push(ChunkId c) noexcept {
  Chunk& chunk = chunks_[c];
  if (!chunk.turn_below) return;
  chunk.turn_below = false;
  chunk.backwards = !chunk.backwards;
  std::swap(chunk.left, chunk.right);
  for (const ChunkId child : {chunk.left, chunk.right})
    if (child != none) chunks_[child].turn_below = !chunks_[child].turn_below;
}

// Hands down every reversal from the root to c: then c.backwards is the whole truth about c.
inline void StripIndex::expose(ChunkId c) {
  path_.clear();
  for (ChunkId at = c; at != none; at = chunks_[at].parent) path_.push_back(at);
  for (auto at = path_.rbegin(); at != path_.rend(); ++at) push(*at);
}

inline StripIndex::ChunkId StripIndex::merge(ChunkId a, ChunkId b) noexcept {
  if (a == none) return b;
  if (b == none) return a;
  if (priority(a) > priority(b)) {
    push(a);
    chunks_[a].right = merge(chunks_[a].right, b);
    update(a);
    return a;
  }
  push(b);
  chunks_[b].left = merge(a, chunks_[b].left);
  update(b);
  return b;
}

inline StripIndex::ChunkId StripIndex::merge_roots(ChunkId a, ChunkId b) noexcept {
  ++version_;
  const ChunkId root = merge(a, b);
  if (root != none) chunks_[root].parent = none;
  return root;
}

// Cuts the tree of c behind c (`after`) or before it.
inline void StripIndex::split(ChunkId c, bool after, ChunkId& lower, ChunkId& upper) {
  ++version_;
  expose(c);
  ChunkId below = c;
  ChunkId parent = chunks_[c].parent;
  if (after) {
    lower = c;
    upper = std::exchange(chunks_[c].right, none);
  } else {
    upper = c;
    lower = std::exchange(chunks_[c].left, none);
  }
  update(c);
  while (parent != none) {
    const ChunkId at = parent;
    parent = chunks_[at].parent;
    if (chunks_[at].left == below) {
      chunks_[at].left = upper;
      upper = at;
    } else {
      chunks_[at].right = lower;
      lower = at;
    }
    update(at);
    below = at;
  }
  if (lower != none) chunks_[lower].parent = none;
  if (upper != none) chunks_[upper].parent = none;
}

// Takes a chunk without triangles out of its tree. A tree without chunks is a strip no more.
inline void StripIndex::erase(ChunkId c) {
  ++version_;
  push(c);
  const ChunkId parent = chunks_[c].parent;
  const ChunkId rest = merge(chunks_[c].left, chunks_[c].right);
  if (rest != none) chunks_[rest].parent = parent;
  if (parent != none) (chunks_[parent].left == c ? chunks_[parent].left : chunks_[parent].right) = rest;
  for (ChunkId at = parent; at != none; at = chunks_[at].parent) --chunks_[at].size;
  if (parent == none && rest == none) --strips_;
  chunks_[c].size = 0;
  free_chunks_.push_back(c);
}

// Rank, root and direction of a chunk: climbs to the root, or to the first chunk that knows its own.
inline const StripIndex::Chunk& StripIndex::look_up(ChunkId c) const noexcept {
  const Chunk& chunk = chunks_[c];
  if (chunk.seen == version_) return chunk;
  std::uint32_t rank = size(chunk.left);
  bool turned = false;
  ChunkId at = c;
  for (;;) {
    const Chunk& here = chunks_[at];
    if (here.turn_below) {
      rank = here.size - 1 - rank;
      turned = !turned;
    }
    if (here.parent == none) {
      chunk.root = at;
      break;
    }
    const Chunk& above = chunks_[here.parent];
    const bool is_right = above.right == at;
    if (above.seen == version_) {
      const std::uint32_t offset = is_right ? rank + 1 : rank - here.size;  // from `above`, modulo 2^32
      rank = above.turned ? above.rank - offset : above.rank + offset;
      turned = turned != above.turned;
      chunk.root = above.root;
      break;
    }
    if (is_right) rank += size(above.left) + 1;
    at = here.parent;
  }
  chunk.rank = rank;
  chunk.turned = turned;
  chunk.seen = version_;
  return chunk;
}

inline StripIndex::ChunkId StripIndex::new_chunk() {
  if (free_chunks_.empty()) {
    chunks_.emplace_back();
    return static_cast<ChunkId>(chunks_.size() - 1);
  }
  const ChunkId c = free_chunks_.back();
  free_chunks_.pop_back();
  chunks_[c] = {};
  return c;
}

}  // namespace restrip
