// Defines sound and best rules. This is the definition itself (docs/reference/operation-file.md, "What a rule must
// be"), written with disjoint sets of the Boost Graph Library. The keys, reasons and symmetries of certificates are
// theorems about it.
//
//   - A patch in a *world* is a graph. Its nodes are the triangles of a side and the outer ends of its ports. Its edges
//     are the inner edges, the ports, and the connections of outer ends in the world.
//   - A colouring is *valid* in a world if no triangle has more solid edges than the constraint allows and the solid
//     edges form a forest. The edges of the world are solid.
//   - A configuration may occur in every world of its solid ports in which it is valid.
//   - A recolouring is *sound* if it is valid in every world in which the configuration may occur. It takes no port,
//     and gives up only ports that may be given up.
//   - It is *best* if no sound recolouring costs less.
//
// Everything is found by exhaustive search. Configurations with the same solid ports and the same possible worlds share
// their answer, which is computed once.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/coloring.hpp"

namespace restrip::verify {

/// The effect of solid edges outside: pairs of ports that are connected there; none for matchings, in which no strip
/// continues.
struct World {
  Mask ports = 0;  ///< all that are in some pair
  std::vector<std::array<unsigned, 2>> connected;
};

/// Every world of this number of ports, fewest connections first: number 0 connects nothing.
std::vector<World> worlds_of(Constraint constraint, unsigned ports);
/// "ports 0-1 2-3 connected outside" or "no ports connected outside".
std::string text_of(const World& world);

/// One side of an operation in all worlds.
class PatchInWorlds {
 public:
  PatchInWorlds(const Side& side, Constraint constraint, const std::vector<World>& worlds);

  bool valid(Colors colors, std::size_t world) const;           ///< linear in the triangles, edges and ports
  bool valid(Colors colors) const { return valid(colors, 0); }  ///< in the world that connects nothing
  std::uint64_t graphs() const { return graphs_; }              ///< how many were judged

 private:
  /// The components of a graph, as disjoint sets of its nodes.
  struct Forest {
    std::array<std::uint8_t, most_triangles + most_ports> rank{};
    std::array<std::uint8_t, most_triangles + most_ports> parent{};
  };
  /// Whether the patch by itself is valid; then `inside_` is its forest.
  bool grow_inside(Colors colors) const;

  const Side& side_;
  unsigned most_solid_;
  std::vector<std::vector<std::pair<unsigned, unsigned>>> outside_;  ///< by world: the edges that it adds
  mutable std::optional<Colors> known_;                              ///< the colours of `inside_`
  mutable bool is_forest_ = false;
  mutable Forest inside_;
  mutable std::uint64_t graphs_ = 0;
};

/// A valid colouring after the operation, and its cost for known ports before.
struct Candidate {
  CostValues cost{};
  Colors colors;
  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

enum class Verdict { right, wrong_ports, unsound, not_best };
struct Judged {
  Verdict verdict = Verdict::right;
  unsigned criterion = 0;  ///< of `not_best`: the first criterion that can be improved
};

/// One operation at one position. Time and memory grow with 2 to the number of edges and ports of a side, and with the
/// number of worlds; at most `most_searched_ports` ports.
class Definition {
 public:
  explicit Definition(const Operation& operation);

  const Operation& operation() const { return operation_; }
  bool valid(Colors configuration) const { return question_number(configuration) != none; }
  /// The worlds in which a valid configuration may occur, as indices into `worlds_of`.
  const std::vector<unsigned>& worlds(Colors configuration) const { return question(configuration).worlds; }
  const World& world(unsigned number) const { return worlds_[number]; }

  /// Judges a recolouring of a valid configuration. Each question is answered once and cached.
  Judged judged(Colors configuration, Colors recoloring) const;
  /// The first world in which a valid configuration may occur and the recolouring is not valid, if any: one with the
  /// fewest connections. Ignores ports.
  std::optional<unsigned> refuting_world(Colors configuration, Colors recoloring) const {
    return refuting_world(worlds(configuration), recoloring);
  }
  bool valid_after(Colors recoloring, unsigned world) const { return after_.valid(recoloring, world); }
  /// The first of the best recolourings; empty if none is sound.
  const std::optional<Candidate>& best(Colors configuration) const { return question(configuration).best; }
  CostValues cost(Colors configuration, Colors recoloring) const {
    return cost_of(operation_, recoloring, solid_count(configuration.ports & ~recoloring.ports));
  }

  std::uint64_t graphs() const { return before_.graphs() + after_.graphs(); }

 private:
  static constexpr unsigned none = 0xffffffff;
  /// The best recolouring for all of these worlds.
  struct Question {
    std::vector<unsigned> worlds;
    std::optional<Candidate> best;
  };
  unsigned question_number(Colors configuration) const {
    return question_of_[concatenated(configuration.inner, configuration.ports, operation_.ports())];
  }
  const Question& question(Colors configuration) const { return questions_.at(question_number(configuration)); }
  std::optional<unsigned> refuting_world(const std::vector<unsigned>& worlds, Colors recoloring) const;

  const Operation& operation_;
  std::vector<World> worlds_;
  PatchInWorlds before_;
  PatchInWorlds after_;
  std::vector<std::vector<Mask>> valid_after_;  ///< by ports: the inner edges of valid colourings
  std::vector<Question> questions_;
  std::vector<unsigned> question_of_;  ///< by configuration
  mutable std::unordered_map<std::uint64_t, Judged> known_;
};

}  // namespace restrip::verify
