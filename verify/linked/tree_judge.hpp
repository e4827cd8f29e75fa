#pragma once
// Is what a tree of questions picks the best for all that its answers leave possible outside?

#include <array>
#include <map>
#include <string>
#include <vector>

#include "definition/definition.hpp"
#include "linked/list_check.hpp"

namespace restrip::verify {

/// Where a path of a tree continues: at a node, or with a recolouring that is picked.
struct Branch {
  enum class Kind { none, node, leaf };
  Kind kind = Kind::none;
  Mask number = 0;  ///< of the node; the recolouring
};

/// A question about one port.
struct Question {
  unsigned port = 0;
  Branch ends;
  Branch unknown;
  std::array<Branch, 8> back;  ///< by the port that the strip comes back through
};

/// All trees of one position and one port mask are judged by one of these.
class TreeJudge {
 public:
  TreeJudge(const Side& after, const PatchInWorlds& in_worlds, const std::vector<World>& worlds, Mask ports);

  struct Verdict {
    std::uint64_t leaves = 0;  ///< those that can be reached
    std::string fault;         ///< the first; empty when none exists
  };
  /// The tree that begins at `root`, for a configuration that may stand in these worlds.
  Verdict judge(const std::vector<Question>& questions, Branch root, const std::vector<unsigned>& worlds);

 private:
  static constexpr unsigned most_partners = 8;
  static constexpr unsigned nobody = most_partners;

  using Partners = std::array<unsigned, most_partners>;
  /// The worlds in which recolourings are valid, and the best merit among these recolourings.
  struct Choice {
    Merit merit;
    std::vector<bool> sound;
  };
  /// The answers on the way to a leaf.
  struct Knowledge {
    Mask asked = 0;                  ///< ports, those that strips come back through included
    Mask unknown = 0;                ///< those of them that nothing is known of
    std::vector<unsigned> possible;  ///< worlds
    std::string text;
  };

  const std::vector<bool>& sound_in(Mask inner);
  void descend(const std::vector<Question>& questions, Branch branch, const Knowledge& known, Verdict& verdict);
  void judge_leaf(Mask inner, const Knowledge& known, Verdict& verdict);
  bool always_unsound(const Choice& choice, const Knowledge& known) const;

  const Side& after_;
  const PatchInWorlds& in_worlds_;
  const std::vector<World>& worlds_;
  Mask ports_;
  std::vector<Recoloring> recolorings_;
  std::vector<Partners> partners_;           ///< by world: the port that each one is joined with
  std::vector<Choice> choices_;              ///< the preferred ones first
  std::map<Mask, std::vector<bool>> sound_;  ///< by inner edges
};

}  // namespace restrip::verify
