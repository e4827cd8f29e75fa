// Random operations on a user's mesh, each compared with the prediction from a picture of the mesh before it. Included
// by test_adapter.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "restrip/operations/impl/mesh_picture.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/operations/test_adapter.hpp"

namespace restrip {

namespace detail {

inline constexpr const char* contract_sentences[] = {
    "the mesh keeps the contract",
    "opposite: the opposite of the opposite is not the halfedge itself, or a halfedge is its own opposite",
    "next: three steps do not lead once around a triangle",
    "on_boundary: true for a halfedge of a triangle",
    "on_boundary: true for both halfedges of a mesh edge",
    "next, opposite: they lead to more halfedges than the mesh has",
    "solid: a halfedge and its opposite have different colours",
    "solid: true on a boundary edge",
    "set_solid: the halfedge or its opposite has another colour afterwards",
    "set_solid: it changed another dual edge as well",
    "alive: false for a halfedge of the mesh",
    "leaves_boundary: it disagrees with a walk around the vertex",
    "fan_step: it disagrees with next, opposite and solid",
    "strip_step: it disagrees with next, opposite and solid",
    "triangle, halfedge, has_triangle, triangle_bound: they do not number each triangle once",
    "from: halfedges that leave the same vertex have different numbers, or two corners of a triangle the same",
    "insert_vertex: the halfedge returned is not v_s -> v_t with the triangles that VertexSplit says around each",
    "insert_vertex: a dual edge of a new triangle is solid",
    ("remove_vertex: the halfedge returned is not v_s -> v_l (or v_r if v_l does not exist) with the triangles of both "
     "ends around v_s"),
    "remove_vertex: the dual edge of two merged mesh edges is solid",
    "turn_edge: the halfedge returned is not r -> l between the triangles (r, l, u) and (l, r, v)",
    "insert_vertex, remove_vertex, turn_edge: another halfedge has moved",
    "insert_vertex, remove_vertex, turn_edge: another triangle has another number, or another halfedge(t)",
    "insert_vertex, remove_vertex, turn_edge: another dual edge changed its colour",
    "insert_vertex, remove_vertex, turn_edge: the number of triangles is not what it should be",
    "the colouring is not valid after an operation of restrip, though every other line held",
    "an operation of restrip did not report the change in strips, though every other line held",
    "the list of changes: a triangle changed and is not in it",
};
static_assert(std::size(contract_sentences) == static_cast<std::size_t>(Contract::changes_named) + 1);

template <class Mesh>
class AdapterDrive {
 public:
  using Halfedge = typename Mesh::Halfedge;
  using Picture = MeshPicture<Mesh>;
  using Split = VertexSplit<Halfedge>;
  using Spokes = typename Split::Spokes;

  AdapterDrive(Mesh& mesh, AdapterTest options, std::vector<std::uint32_t>* changed)
      : mesh_(mesh), options_(options), changed_(changed), random_(options.seed) {}

  AdapterReport run(const Halfedge& start) {
    // Limits the walk, so that a broken mesh does not exhaust memory.
    if (look_at(start, std::size_t{1} << 16)) return report_;
    const std::size_t first_size = now_.triangles;
    list_misses_one();
    if (colors_one_by_one() || list_misses_one()) return report_;
    while (report_.operations < options_.operations) {
      const bool bare = report_.operations < options_.operations / 2;
      if (report_.operations == options_.operations / 2 && all_dashed()) return report_;
      const std::size_t h = pick(now_.size());
      const bool grow = now_.triangles < first_size + pick(first_size + 8) - first_size / 4;
      ++report_.operations;
      if (bare) set_random_colors();
      const std::size_t kind = pick(5);
      if (operation(h, kind, grow, bare)) return report_;
      if (list_misses_one()) return report_;
    }
    report_.during = "the mesh as it is given";
    return report_;
  }

 private:
  std::size_t pick(std::size_t below) { return static_cast<std::size_t>(random_()) % below; }
  bool fail(Contract line) {
    report_.broken = line;
    return line != Contract::kept;
  }

  bool look_at(const Halfedge& start, std::size_t limit) {
    if (fail(read_picture(mesh_, start, limit, now_))) return true;
    return fail(check_members(mesh_, now_)) || fail(check_numbers(mesh_, now_));
  }
  [[nodiscard]] bool interior(std::size_t h) const {
    return !now_.on_boundary(h) && !now_.on_boundary(now_.opposite[h]);
  }

  // ---- the list of changes

  /// By number: corners, neighbours and colours of a triangle, from its lowest corner.
  using TriangleState = std::array<std::array<std::uint32_t, 3>, 3>;
  static constexpr std::uint32_t nothing = 0xFFFFFFFFU;

  [[nodiscard]] TriangleState state_of(std::uint32_t t) const {
    TriangleState sides{};
    auto h = mesh_.halfedge(t);
    for (auto& side : sides) {
      const auto across = mesh_.opposite(h);
      side = {static_cast<std::uint32_t>(mesh_.from(h)),
              mesh_.on_boundary(across) ? nothing : static_cast<std::uint32_t>(mesh_.triangle(across)),
              mesh_.solid(h) ? 1U : 0U};
      h = mesh_.next(h);
    }
    std::rotate(sides.begin(), std::min_element(sides.begin(), sides.end()), sides.end());
    return sides;
  }
  bool list_misses_one() {
    if constexpr (NumberedMesh<Mesh>) {
      if (changed_ == nullptr) return false;
      constexpr TriangleState no_triangle{{{nothing, nothing, nothing}, {}, {}}};
      const bool first = states_.empty();
      const std::size_t bound = mesh_.triangle_bound();
      states_.resize((std::max)(states_.size(), bound), no_triangle);
      for (std::uint32_t t = 0; t < states_.size(); ++t) {
        const TriangleState now = t < bound && mesh_.has_triangle(t) ? state_of(t) : no_triangle;
        if (!first && now != states_[t] && std::find(changed_->begin(), changed_->end(), t) == changed_->end())
          return fail(Contract::changes_named);
        states_[t] = now;
      }
      changed_->clear();
    }
    return false;
  }

  // ---- colours

  /// Sets one colour and checks all.
  bool colors_one_by_one() {
    report_.during = "set_solid";
    for (int times = 0; times < 20; ++times) {
      const std::size_t h = pick(now_.size());
      if (!interior(h)) continue;
      const bool solid = now_.solid[h] == 0;
      mesh_.set_solid(now_.halfedges[h], solid);
      now_.solid[h] = now_.solid[now_.opposite[h]] = solid ? 1 : 0;
      for (const std::size_t g : {h, now_.opposite[h]})
        if (bool{mesh_.solid(now_.halfedges[g])} != solid) return fail(Contract::set_solid_sets);
      for (std::size_t g = 0; g < now_.size(); ++g)
        if (bool{mesh_.solid(now_.halfedges[g])} != (now_.solid[g] != 0)) return fail(Contract::set_solid_sets_one);
    }
    return false;
  }
  void set_random_colors() {
    for (std::size_t h = 0; h < now_.size(); ++h) {
      if (!interior(h) || h > now_.opposite[h]) continue;
      const bool solid = pick(2) == 0;
      if (solid == (now_.solid[h] != 0)) continue;
      mesh_.set_solid(now_.halfedges[h], solid);
      now_.solid[h] = now_.solid[now_.opposite[h]] = solid ? 1 : 0;
    }
  }
  bool all_dashed() {
    for (std::size_t h = 0; h < now_.size(); ++h)
      if (now_.solid[h] != 0 && bool{mesh_.solid(now_.halfedges[h])}) mesh_.set_solid(now_.halfedges[h], false);
    report_.during = "set_solid";
    return look_at(now_.halfedges[0], now_.size());
  }

  // ---- possible operations

  static bool granted(Refusal refusal) { return refusal == Refusal::granted || refusal == Refusal::colors_not_valid; }

  /// Draws a split of the vertex that h leaves; the unused spoke is garbage on purpose.
  bool draw_split(std::size_t h, Split& where) {
    const PictureFan fan = now_.fan(h);
    if (fan.closed && fan.triangles() < 3) return false;
    left_ = fan.spokes[pick(fan.spokes.size())];
    right_ = fan.spokes[pick(fan.spokes.size())];
    where = {now_.halfedges[left_], now_.halfedges[right_]};
    if (!fan.closed && pick(2) == 0) {
      where.spokes = pick(2) == 0 ? Spokes::left_only : Spokes::right_only;
      (where.spokes == Spokes::left_only ? where.right : where.left) = Halfedge{};
    } else if (left_ == right_) {
      return false;
    }
    return granted(refusal_of_split(mesh_, where));
  }
  bool may_collapse(std::size_t chord) const {
    const std::size_t back = now_.opposite[chord];
    const PictureFan tail = now_.fan(chord);
    const PictureFan head = now_.fan(back);
    if (interior(chord) && !tail.closed && !head.closed) return false;
    if (tail.closed && head.closed && tail.triangles() + head.triangles() < 7) return false;
    std::size_t apexes = 0;
    for (const std::size_t inward : {chord, back}) {
      if (now_.on_boundary(inward)) continue;
      const std::size_t up = now_.next[inward];
      if (!interior(up) && !interior(now_.next[up])) return false;
      const PictureFan apex = now_.fan(now_.next[up]);
      if (apex.closed && apex.triangles() < 4) return false;
      ++apexes;
    }
    std::size_t shared = 0;
    for (const std::size_t spoke : tail.spokes) shared += now_.neighbors(now_.vertex[back], now_.to(spoke)) ? 1U : 0U;
    return shared == apexes && granted(refusal_of_collapse(mesh_, now_.halfedges[chord]));
  }
  bool may_flip(std::size_t h) const {
    if (!interior(h)) return false;
    const std::size_t l = now_.apex(h);
    const std::size_t r = now_.apex(now_.opposite[h]);
    if (l == r || now_.neighbors(l, r)) return false;
    for (const std::size_t end : {h, now_.opposite[h]})
      if (const PictureFan fan = now_.fan(end); fan.closed && fan.triangles() < 4) return false;
    return granted(refusal_of_flip(mesh_, now_.halfedges[h]));
  }

  // ---- expected results

  /// Spokes in a row: known halfedges, or no_next for a new one, whose edge must be dashed.
  using Row = std::vector<std::size_t>;
  static constexpr std::size_t unknown = Picture::no_next;

  static void append(Row& row, const Row& from, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) row.push_back(from[i]);
  }

  /// Whether this row is the fan of the halfedge `at`, which has place `place` in it. old_ is the mesh before, now_ the
  /// mesh after.
  Contract fan_is(const Halfedge& at, const Row& row, std::size_t place, bool closed, Contract otherwise,
                  Contract not_dashed) const {
    const std::size_t h = now_.find(at);
    const PictureFan fan = now_.fan(h);
    if (fan.closed != closed || fan.spokes.size() != row.size() || fan.place(h) != place) return otherwise;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i] != unknown && !(old_.halfedges[row[i]] == now_.halfedges[fan.spokes[i]])) return otherwise;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i] == unknown && now_.solid[fan.spokes[i]] != 0) return not_dashed;
    return Contract::kept;
  }

  /// Checks that handles whose edge is not in `changed` have not moved and keep their colours, and that triangles
  /// without such an edge keep their numbers.
  Contract others_stay(const std::vector<std::uint8_t>& changed) const {
    for (std::size_t i = 0; i < old_.size(); ++i) {
      if (changed[i] != 0) continue;
      const Halfedge& h = old_.halfedges[i];
      if constexpr (requires { mesh_.alive(h); })
        if (!mesh_.alive(h)) return Contract::handles_stay;
      const std::size_t across = old_.opposite[i];
      if (changed[across] == 0 && !(mesh_.opposite(h) == old_.halfedges[across])) return Contract::handles_stay;
      if (bool{mesh_.on_boundary(h)} != old_.on_boundary(i)) return Contract::handles_stay;
      if (!old_.on_boundary(i) && changed[old_.next[i]] == 0 && !(mesh_.next(h) == old_.halfedges[old_.next[i]]))
        return Contract::handles_stay;
      if (bool{mesh_.solid(h)} != (old_.solid[i] != 0)) return Contract::other_colors_stay;
      if constexpr (NumberedMesh<Mesh>) {
        if (old_.on_boundary(i) || changed[old_.next[i]] != 0 || changed[old_.next[old_.next[i]]] != 0) continue;
        if (mesh_.triangle(h) != old_.number[i] || (mesh_.halfedge(old_.number[i]) == h) != (old_.chosen[i] != 0))
          return Contract::numbers_stay;
      }
    }
    return Contract::kept;
  }
  [[nodiscard]] std::vector<std::uint8_t> edges(std::initializer_list<std::size_t> list) const {
    std::vector<std::uint8_t> marked(old_.size(), 0);
    for (const std::size_t h : list) marked[h] = marked[old_.opposite[h]] = 1;
    return marked;
  }

  // ---- operations of the mesh without restrip

  bool bare_split(const Split& where) {
    report_.during = "insert_vertex";
    ++report_.splits;
    old_ = now_;
    const bool has_left = where.spokes != Spokes::right_only;
    const bool has_right = where.spokes != Spokes::left_only;
    const PictureFan fan = old_.fan(has_left ? left_ : right_);
    const std::size_t l = has_left ? fan.place(left_) : 0;
    const std::size_t r = has_right ? fan.place(right_) : 0;
    const Row& all = fan.spokes;
    const Halfedge chord = mesh_.insert_vertex(where);
    const Halfedge back = mesh_.opposite(chord);
    if (look_at(chord, old_.size() + 6)) return true;
    if (now_.triangles != old_.triangles + (has_left ? 1U : 0U) + (has_right ? 1U : 0U))
      return fail(Contract::triangle_count);
    if (bool{mesh_.on_boundary(chord)} == has_left || bool{mesh_.on_boundary(back)} == has_right)
      return fail(Contract::chord_between_new_ends);
    Row tail;
    Row head;
    std::size_t tail_place = 0;
    std::size_t head_place = 0;
    bool tail_closed = fan.closed;
    bool head_closed = fan.closed;
    const auto around = [&all](std::size_t from, std::size_t to) {  // an interior end: the chord and the spoke after it
      Row row{unknown, unknown};
      for (std::size_t i = (from + 1) % all.size(); i != to; i = (i + 1) % all.size()) row.push_back(all[i]);
      row.push_back(unknown);
      return row;
    };
    if (fan.closed) {
      tail = around(l, r);
      head = around(r, l);
    } else if (has_left && has_right) {
      const auto [low, high] = std::minmax(l, r);
      tail_closed = l < r;
      head_closed = !tail_closed;
      (tail_closed ? tail : head) = around(low, high);
      Row& outer = tail_closed ? head : tail;
      append(outer, all, 0, low);
      outer.insert(outer.end(), 3, unknown);
      append(outer, all, high + 1, all.size());
      (tail_closed ? head_place : tail_place) = low + 1;
    } else {
      const std::size_t gap = has_left ? l : r;
      Row lower;
      append(lower, all, 0, gap);
      lower.insert(lower.end(), 2, unknown);
      Row upper{unknown, unknown};
      append(upper, all, gap + 1, all.size());
      tail = has_left ? upper : lower;
      head = has_left ? lower : upper;
      (has_left ? head_place : tail_place) = gap + 1;
    }
    constexpr auto wrong = Contract::chord_between_new_ends;
    constexpr auto solid = Contract::new_edges_dashed;
    if (fail(fan_is(chord, tail, tail_place, tail_closed, wrong, solid))) return true;
    if (fail(fan_is(back, head, head_place, head_closed, wrong, solid))) return true;
    const std::size_t one = has_left ? left_ : right_;
    return fail(others_stay(edges({one, has_right ? right_ : one})));
  }

  bool bare_collapse(std::size_t chord) {
    report_.during = "remove_vertex";
    ++report_.collapses;
    old_ = now_;
    const std::size_t back = old_.opposite[chord];
    const bool has_left = !old_.on_boundary(chord);
    const bool has_right = !old_.on_boundary(back);
    const PictureFan tail = old_.fan(chord);
    const PictureFan head = old_.fan(back);
    Row row;
    std::size_t place = 0;
    if (tail.closed && head.closed) {
      row.push_back(unknown);
      append(row, tail.spokes, 2, tail.spokes.size() - 1);
      row.push_back(unknown);
      append(row, head.spokes, 2, head.spokes.size() - 1);
    } else if (has_left && has_right) {
      const bool tail_is_open = head.closed;
      const Row& inner = tail_is_open ? head.spokes : tail.spokes;
      const Row& outer = tail_is_open ? tail.spokes : head.spokes;
      const std::size_t middle = tail_is_open ? tail.place(chord) : head.place(back);
      append(row, outer, 0, middle - 1);
      const std::size_t low = row.size();
      row.push_back(unknown);
      append(row, inner, 2, inner.size() - 1);
      place = tail_is_open ? row.size() : low;
      row.push_back(unknown);
      append(row, outer, middle + 2, outer.size());
    } else {
      const Row& lower = has_left ? head.spokes : tail.spokes;
      const Row& upper = has_left ? tail.spokes : head.spokes;
      append(row, lower, 0, lower.size() - 2);
      place = row.size();
      row.push_back(unknown);
      append(row, upper, 2, upper.size());
    }
    std::vector<std::uint8_t> gone = edges({chord});
    for (const std::size_t inward : {chord, back})
      if (!old_.on_boundary(inward))
        for (const std::size_t h : {old_.next[inward], old_.next[old_.next[inward]]})
          gone[h] = gone[old_.opposite[h]] = 1;
    const Halfedge spoke = mesh_.remove_vertex(old_.halfedges[chord]);
    if (look_at(spoke, old_.size())) return true;
    if (now_.triangles + (has_left ? 1U : 0U) + (has_right ? 1U : 0U) != old_.triangles)
      return fail(Contract::triangle_count);
    if (fail(fan_is(spoke, row, place, tail.closed && head.closed, Contract::spoke_to_apex,
                    Contract::merged_edges_dashed)))
      return true;
    return fail(others_stay(gone));
  }

  bool bare_flip(std::size_t h) {
    report_.during = "turn_edge";
    ++report_.flips;
    old_ = now_;
    const std::size_t g = old_.opposite[h];
    const std::size_t ports[4] = {old_.next[h], old_.next[old_.next[h]], old_.next[g], old_.next[old_.next[g]]};
    const Halfedge turned = mesh_.turn_edge(old_.halfedges[h]);
    if (look_at(turned, old_.size())) return true;
    if (now_.triangles != old_.triangles) return fail(Contract::triangle_count);
    // The sides l u and u r of (r, l, u), and r v and v l of (l, r, v). The triangles across are known.
    const Halfedge back = mesh_.opposite(turned);
    if (mesh_.on_boundary(turned) || mesh_.on_boundary(back)) return fail(Contract::edge_turned);
    const Halfedge sides[4] = {mesh_.next(turned), mesh_.next(mesh_.next(turned)), mesh_.next(back),
                               mesh_.next(mesh_.next(back))};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t port = ports[(i + 1) % 4];
      const std::size_t across = old_.opposite[port];
      const bool inside = across == ports[0] || across == ports[1] || across == ports[2] || across == ports[3];
      if (inside) continue;
      const Halfedge there = mesh_.opposite(sides[i]);
      if (bool{mesh_.on_boundary(there)} != old_.on_boundary(across)) return fail(Contract::edge_turned);
      if (!old_.on_boundary(across) && !(there == old_.halfedges[across])) return fail(Contract::edge_turned);
      if (bool{mesh_.solid(sides[i])} != (old_.solid[port] != 0)) return fail(Contract::other_colors_stay);
    }
    if (bool{mesh_.solid(turned)} != (old_.solid[h] != 0)) return fail(Contract::other_colors_stay);
    // The handles of the two triangles may move to other sides of them, and the handles across the boundary with them.
    std::vector<std::uint8_t> inside(old_.size(), 0);
    for (const std::size_t side : {h, g, ports[0], ports[1], ports[2], ports[3]}) inside[side] = 1;
    for (const std::size_t port : ports)
      if (old_.on_boundary(old_.opposite[port])) inside[old_.opposite[port]] = 1;
    return fail(others_stay(inside));
  }

  // ---- operations of restrip

  [[nodiscard]] bool recount(long& strips) const {
    std::vector<std::size_t> end(now_.size());
    std::iota(end.begin(), end.end(), std::size_t{0});
    const auto find = [&](std::size_t h) {
      while (end[h] != h) h = end[h] = end[end[h]];
      return h;
    };
    strips = static_cast<long>(now_.triangles);
    for (std::size_t h = 0; h < now_.size(); ++h) {
      if (now_.on_boundary(h)) continue;
      const std::size_t second = now_.next[h];
      if (now_.solid[h] != 0 && now_.solid[second] != 0 && now_.solid[now_.next[second]] != 0) return false;
      end[find(h)] = find(second);
    }
    for (std::size_t h = 0; h < now_.size(); ++h) {
      if (now_.solid[h] == 0 || h > now_.opposite[h]) continue;
      const std::size_t one = find(h);
      const std::size_t other = find(now_.opposite[h]);
      if (one == other) return false;
      end[one] = other;
      --strips;
    }
    return true;
  }

  template <class Operation>
  bool try_operation(const char* name, std::size_t& served, Operation&& operation) {
    report_.during = name;
    ++served;
    long before = 0;
    if (!recount(before)) return fail(Contract::coloring_stays_valid);
    const std::size_t limit = now_.size() + 6;
    const Rewrite<Halfedge> done = operation();
    if (look_at(done.halfedge, limit)) return true;
    long strips = 0;
    if (!recount(strips)) return fail(Contract::coloring_stays_valid);
    return fail(strips == before + done.strips ? Contract::kept : Contract::report_is_true);
  }

  /// `bare`: by the mesh alone.
  bool operation(std::size_t h, std::size_t kind, bool grow, bool bare) {
    const Halfedge at = now_.halfedges[h];
    if (kind == 0) {
      if constexpr (FlippableMesh<Mesh>)
        if (may_flip(h))
          return bare ? bare_flip(h) : try_operation("flip", report_.flips, [&] { return flip(mesh_, at); });
    } else if (grow) {
      if constexpr (NamesNewVertices<Mesh>) {
        if (!bare && kind == 1 && !now_.on_boundary(h) && granted(refusal_of_split(mesh_, split_into_face(mesh_, at))))
          return try_operation("split_face", report_.splits, [&] { return split_face(mesh_, at); });
        if (!bare && kind == 2 && granted(refusal_of_split(mesh_, split_on_edge(mesh_, at))))
          return try_operation("bisect", report_.splits, [&] { return bisect(mesh_, at); });
        if (Split where; draw_split(h, where))
          return bare ? bare_split(where) : try_operation("split", report_.splits, [&] { return split(mesh_, where); });
      }
    } else if constexpr (CollapsibleMesh<Mesh>) {
      if (!may_collapse(h)) return false;
      if (bare) return bare_collapse(h);
      if (refusal_of_removal(mesh_, at, 3, 0) == Refusal::granted && kind < 3)
        return try_operation("join_faces", report_.collapses, [&] { return join_faces(mesh_, at); });
      const bool of_four = refusal_of_removal(mesh_, at, 4, 2) == Refusal::granted;
      if (of_four && kind < 3 && now_.fan(now_.opposite[h]).closed == interior(h))
        return try_operation("merge", report_.collapses, [&] { return merge(mesh_, at); });
      return try_operation("collapse", report_.collapses, [&] { return collapse(mesh_, at); });
    }
    return false;
  }

  Mesh& mesh_;
  AdapterTest options_;
  std::vector<std::uint32_t>* changed_;
  std::vector<TriangleState> states_;
  std::mt19937 random_;
  AdapterReport report_;
  Picture now_;
  Picture old_;
  std::size_t left_ = 0;  // the spokes of the split that was drawn
  std::size_t right_ = 0;
};

}  // namespace detail

[[nodiscard]] constexpr const char* describe(Contract line) noexcept {
  const auto number = static_cast<std::size_t>(line);
  return number < std::size(detail::contract_sentences) ? detail::contract_sentences[number] : "unknown";
}

template <ColoredMesh Mesh>
AdapterReport test_adapter(Mesh& mesh, typename Mesh::Halfedge start, AdapterTest options) {
  return detail::AdapterDrive<Mesh>(mesh, options, nullptr).run(start);
}

template <NumberedMesh Mesh>
AdapterReport test_adapter(Mesh& mesh, typename Mesh::Halfedge start, std::vector<std::uint32_t>* changed,
                           AdapterTest options) {
  return detail::AdapterDrive<Mesh>(mesh, options, changed).run(start);
}

}  // namespace restrip
