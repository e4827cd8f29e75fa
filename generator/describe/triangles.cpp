#include "describe/triangles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "describe/description.hpp"

namespace restrip::generator {
namespace {

using Corners = std::array<unsigned, 3>;
/// A directed edge by its ends; its triangle lies to its left.
using Ends = std::pair<unsigned, unsigned>;
/// The place of a directed edge: side s of a triangle runs from its corner s to the next one.
struct SideOf {
  unsigned triangle = 0;
  unsigned side = 0;
};

Ends back(Ends ends) { return {ends.second, ends.first}; }

/// The triangles of one side of the operation, by their directed edges.
class Disc {
 public:
  /// `names` has the vertices of both sides.
  Disc(std::string member, const NamedPatch::Triangles& triangles, std::vector<std::string>& names)
      : member_(std::move(member)), names_(names) {
    if (triangles.empty() || triangles.size() > most_nodes)
      fail(-1, fmt::format("expected 1 to {} triangles", most_nodes));
    for (const auto& triangle : triangles) add(triangle);
    for (const auto& [ends, at] : sides_)
      if (!sides_.contains(back(ends))) rim_[ends.first].push_back(ends.second);
    expect_single_fans();
    expect_disc();
  }

  [[noreturn]] void fail(int element, const std::string& what) const { throw PatchFault(member_, element, what); }

  [[nodiscard]] const std::vector<Corners>& corners() const { return corners_; }
  [[nodiscard]] bool has(Ends ends) const { return sides_.contains(ends); }
  [[nodiscard]] SideOf at(Ends ends) const { return sides_.at(ends); }
  /// Whether it is an edge of the outline that does not lie on the boundary of the mesh.
  [[nodiscard]] bool is_open(Ends ends) const { return has(ends) && !has(back(ends)) && !boundary_.contains(ends); }
  [[nodiscard]] Ends side(unsigned triangle, unsigned s) const {
    return {corners_[triangle][s], corners_[triangle][(s + 1) % 3]};
  }
  /// The rim once around, starting at this vertex.
  [[nodiscard]] std::vector<Ends> rim_from(unsigned first) const {
    std::vector<Ends> edges;
    unsigned v = first;
    do {
      edges.emplace_back(v, rim_.at(v)[0]);
      v = edges.back().second;
    } while (v != first);
    return edges;
  }

  /// Takes the edges of the outline that lie on the boundary of the mesh.
  void take_boundary(const std::vector<std::array<std::string, 2>>& stretches) {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const auto refuse = [&](const std::string& what) { throw PatchFault("boundary", static_cast<int>(i), what); };
      const auto& [from, to] = stretches[i];
      if (from == to) refuse("expected two different vertices");
      for (const std::string& name : stretches[i])
        if (!rim_.contains(index_of(name)))
          refuse(fmt::format("expected vertices of the outline on both sides; {} is not one {} the operation", name,
                             member_));
      for (const Ends& edge : rim_from(index_of(from))) {
        if (!boundary_.insert(edge).second) refuse(fmt::format("{} is in a stretch already", words(edge)));
        if (edge.second == index_of(to)) break;
      }
    }
  }

  /// Checks that every edge of its outline that is not on the boundary is also in the other's.
  void expect_outline_of(const Disc& other) const {
    for (unsigned t = 0; t < corners_.size(); ++t)
      for (unsigned s = 0; s < 3; ++s)
        if (const Ends edge = side(t, s); is_open(edge) && !other.is_open(edge))
          fail(static_cast<int>(t),
               fmt::format("{} is an edge of the outline {} the operation, but not {} it; both sides need the same "
                           "outline{}",
                           words(edge), member_, other.member_, remedy(edge, other)));
  }

 private:
  /// What may have been meant by an edge of the outline that the other side does not have.
  [[nodiscard]] std::string remedy(Ends edge, const Disc& other) const {
    if (other.is_open(back(edge))) return "; is this triangle clockwise?";
    const auto is_there = [&](unsigned v) {
      return std::any_of(other.corners_.begin(), other.corners_.end(),
                         [&](const Corners& c) { return std::find(c.begin(), c.end(), v) != c.end(); });
    };
    for (const unsigned v : {edge.first, edge.second})
      if (!is_there(v))
        return fmt::format("; {} is {}: include the triangle across this edge, or declare the boundary of the mesh",
                           names_[v], member_ == "after" ? "new" : "not there afterwards");
    return "";
  }
  /// The number of names for one that is not there.
  [[nodiscard]] unsigned index_of(const std::string& name) const {
    return static_cast<unsigned>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }
  [[nodiscard]] std::string words(Ends ends) const {
    return fmt::format("{} {}", names_[ends.first], names_[ends.second]);
  }

  void add(const std::array<std::string, 3>& triangle) {
    const auto number = static_cast<unsigned>(corners_.size());
    const auto element = static_cast<int>(number);
    const auto allowed = [](char c) {
      return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_';
    };
    for (const std::string& name : triangle)
      if (name.empty() || name.size() > longest_word || !std::all_of(name.begin(), name.end(), allowed))
        fail(element, "expected names of vertices: 1 to 20 letters, digits and underscores");
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      fail(element, "expected three different vertices");
    corners_.emplace_back();
    for (unsigned s = 0; s < 3; ++s) {
      corners_.back()[s] = index_of(triangle[s]);
      if (corners_.back()[s] == names_.size()) names_.push_back(triangle[s]);
    }
    for (unsigned s = 0; s < 3; ++s) {
      const Ends ends = side(number, s);
      const auto [there, fresh] = sides_.emplace(ends, SideOf{number, s});
      if (fresh) continue;
      if (has(back(ends))) fail(element, fmt::format("the edge {} has two triangles already", words(ends)));
      fail(element,
           fmt::format("this triangle and triangle {} both run along {} in this direction: is one of them clockwise?",
                       there->second.triangle, words(ends)));
    }
  }

  /// A turn around a vertex from any of its triangles must reach all of them.
  void expect_single_fans() const {
    std::map<unsigned, unsigned> meeting;
    for (const Corners& c : corners_)
      for (const unsigned v : c) ++meeting[v];
    for (const auto& [v, all] : meeting) {
      // Starts at the outline if the vertex is on it, so that one turn reaches the whole fan.
      const auto rim = rim_.find(v);
      if (rim != rim_.end() && rim->second.size() > 1)
        fail(-1, fmt::format("the triangles around {} are {} fans, expected one", names_[v], rim->second.size()));
      const auto starts = [v = v](const auto& side) { return side.first.first == v; };
      const Ends first =
          rim != rim_.end() ? Ends(v, rim->second[0]) : std::find_if(sides_.begin(), sides_.end(), starts)->first;
      unsigned met = 0;
      Ends spoke = first;
      do {
        const SideOf here = at(spoke);
        ++met;
        spoke = back(side(here.triangle, (here.side + 2) % 3));
      } while (has(spoke) && spoke != first);
      if (met != all) fail(-1, fmt::format("the triangles around {} are several fans, expected one", names_[v]));
    }
  }

  void expect_disc() const {
    std::vector<bool> met(corners_.size(), false);
    std::vector<unsigned> open{0};
    met[0] = true;
    while (!open.empty()) {
      const unsigned t = open.back();
      open.pop_back();
      for (unsigned s = 0; s < 3; ++s) {
        const auto there = sides_.find(back(side(t, s)));
        if (there == sides_.end() || met[there->second.triangle]) continue;
        met[there->second.triangle] = true;
        open.push_back(there->second.triangle);
      }
    }
    if (const auto apart = std::find(met.begin(), met.end(), false); apart != met.end())
      fail(static_cast<int>(apart - met.begin()), "this triangle is not connected to triangle 0 over edges");
    if (rim_.empty()) fail(-1, "expected a disc, these triangles close up and have no outline");
    if (rim_from(rim_.begin()->first).size() != rim_.size())
      fail(-1, "expected a disc, the outline of these triangles has several parts");
    std::set<unsigned> vertices;
    for (const Corners& c : corners_) vertices.insert(c.begin(), c.end());
    const std::size_t edges = (sides_.size() + rim_.size()) / 2;
    if (vertices.size() + corners_.size() != edges + 1) fail(-1, "expected a disc, these triangles have a handle");
  }

  std::string member_;
  std::vector<std::string>& names_;
  std::vector<Corners> corners_;
  std::map<Ends, SideOf> sides_;
  std::map<unsigned, std::vector<unsigned>> rim_;  ///< the next vertices of the outline
  std::set<Ends> boundary_;
};

/// The side with its numbers, and the triangles in traversal order from the first side of the first.
std::pair<Side, std::vector<SurfaceTriangle>> numbered(const Disc& disc, const std::vector<Ends>& ports) {
  Side side;
  side.nodes = static_cast<unsigned>(disc.corners().size());
  constexpr std::uint8_t boundary = SurfaceTriangle::boundary_side;
  std::vector<std::array<std::uint8_t, 3>> of(side.nodes, {boundary, boundary, boundary});  // as in SurfaceTriangle
  for (unsigned t = 0; t < side.nodes; ++t)
    for (unsigned s = 0; s < 3; ++s) {
      const Ends other = back(disc.side(t, s));
      if (!disc.has(other) || disc.at(other).triangle > t) continue;
      const SideOf there = disc.at(other);
      of[t][s] = of[there.triangle][there.side] = static_cast<std::uint8_t>(side.edges.size());
      side.edges.push_back({there.triangle, t});
    }
  for (std::size_t p = 0; p < ports.size(); ++p) {
    const SideOf at = disc.at(ports[p]);
    side.owner.push_back(at.triangle);
    of[at.triangle][at.side] = static_cast<std::uint8_t>(SurfaceTriangle::port_side + p);
  }
  if (side.owner.empty() || side.owner.size() > most_ports)
    disc.fail(-1, fmt::format("expected 1 to {} ports, the edges of the outline that are not on the boundary, found {}",
                              most_ports, side.owner.size()));
  if (side.edges.size() + side.owner.size() > most_edges_and_ports) disc.fail(-1, too_many_colors(side));
  std::vector<SurfaceTriangle> met;
  std::set<unsigned> known;
  const auto meet = [&](SideOf at, unsigned from, unsigned from_side) {
    if (!known.insert(at.triangle).second) return;
    met.push_back({from, from_side, {}, {}});
    for (unsigned s = 0; s < 3; ++s) {
      met.back().vertex[s] = disc.corners()[at.triangle][(at.side + s) % 3];
      met.back().side[s] = of[at.triangle][(at.side + s) % 3];
    }
  };
  meet({0, 0}, 0, 0);
  for (unsigned i = 0; i < met.size(); ++i)
    for (unsigned s = 0; s < 3; ++s) {
      const Ends other{met[i].vertex[(s + 1) % 3], met[i].vertex[s]};
      if (disc.has(other)) meet(disc.at(other), i, s);
    }
  return {side, met};
}

std::string name_at(const IndexedName& vertex, const PositionNumbers& place, int index = 0) {
  if (!vertex.index) return vertex.name;
  const int value = vertex.index->at(place, index);
  if (value < 0) throw std::runtime_error(fmt::format("{}[{}] is not a vertex", vertex.name, value));
  return fmt::format("{}_{}", vertex.name, value);
}

NamedPatch::Triangles triangles_at(const TrianglePatterns& patterns, const PositionNumbers& place) {
  NamedPatch::Triangles triangles;
  for (const auto& [corners, index] : patterns) {
    const int from = index ? index->range->from.at(place) : 0;
    const int to = index ? index->range->to.at(place) : 1;
    if (from < 0 || to < 0)
      throw std::runtime_error(fmt::format("{}[{},{}) is not a range of indices", index->name, from, to));
    for (int i = from; i < to && triangles.size() <= most_nodes; ++i)
      triangles.push_back(
          {name_at(corners[0], place, i), name_at(corners[1], place, i), name_at(corners[2], place, i)});
  }
  return triangles;
}

}  // namespace

NamedPatch named_at(const TrianglePatterns& before, const TrianglePatterns& after,
                    const std::vector<StretchPattern>& boundary, const PositionNumbers& place) {
  NamedPatch named{triangles_at(before, place), triangles_at(after, place), {}};
  for (const auto& [from, to] : boundary) named.boundary.push_back({name_at(from, place), name_at(to, place)});
  return named;
}

Patch surface_patch(const NamedPatch& named) {
  std::vector<std::string> names;
  Disc before("before", named.before, names);
  Disc after("after", named.after, names);
  before.take_boundary(named.boundary);
  after.take_boundary(named.boundary);
  after.expect_outline_of(before);
  before.expect_outline_of(after);
  // The ports in order, by the directed edges of the outline before the operation.
  std::vector<Ends> ports;
  for (unsigned i = 0; ports.empty() && i < 3 * before.corners().size(); ++i)
    if (const Ends first = before.side(i / 3, i % 3); before.is_open(first)) ports = before.rim_from(first.first);
  std::erase_if(ports, [&](Ends edge) { return !before.is_open(edge); });
  Patch patch;
  std::tie(patch.before, patch.surface.before) = numbered(before, ports);
  std::tie(patch.after, patch.surface.after) = numbered(after, ports);
  patch.surface.vertices = static_cast<unsigned>(names.size());
  return patch;
}

}  // namespace restrip::generator
