#pragma once
// Judges whether the choice of a tree of questions is the best in all outsides that its answers allow.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "definition/definition.hpp"
#include "linked/list_check.hpp"

namespace restrip::verify {

/// The continuation of a path of a tree: a node, or the chosen recolouring.
struct Branch {
  enum class Kind { none, node, leaf };
  Kind kind = Kind::none;
  Mask number = 0;  ///< of the node; or the recolouring
};

/// A question about one port.
struct Question {
  unsigned port = 0;
  Branch ends;
  Branch unknown;
  std::array<Branch, 8> back;  ///< by the port through which the strip comes back
};

/// Judges all trees of one position and one port mask.
class TreeJudge {
 public:
  TreeJudge(const Side& after, const PatchInWorlds& in_worlds, const std::vector<World>& worlds, Mask ports);

  struct Verdict {
    std::uint64_t leaves = 0;  ///< reachable ones
    std::string fault;         ///< the first one; empty without a fault
  };
  /// The tree that starts at `root`, for a configuration that may occur in these worlds.
  Verdict judge(const std::vector<Question>& questions, Branch root, const std::vector<unsigned>& worlds);

 private:
  static constexpr unsigned most_partners = 8;
  static constexpr unsigned no_partner = most_partners;

  using Partners = std::array<unsigned, most_partners>;
  /// The worlds in which recolourings are valid, and the best merit among them.
  struct Choice {
    Merit merit;
    std::vector<bool> sound;
  };
  /// The answers on the way to a leaf.
  struct Knowledge {
    Mask asked = 0;                  ///< ports, including ports through which strips come back
    Mask unknown = 0;                ///< ports among them without a known partner
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
  std::vector<Partners> partners_;           ///< by world: the partner of each port
  std::vector<Choice> choices_;              ///< in order of preference
  std::map<Mask, std::vector<bool>> sound_;  ///< by inner edges
};

}  // namespace restrip::verify
