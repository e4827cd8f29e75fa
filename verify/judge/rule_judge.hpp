#pragma once
// Judges recolourings by the definitions of docs/operation-file.md: a recolouring is held against every world that the
// configuration fits, and against every recolouring that stands this test. Configurations that fit the same worlds are
// judged together (colorings.hpp).

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "judge/colorings.hpp"
#include "judge/cost.hpp"
#include "judge/report.hpp"
#include "model/key.hpp"

namespace restrip::verify {

enum class Verdict { right, wrong_ports, unsound, not_best };

struct Judged {
  Verdict verdict = Verdict::right;
  unsigned criterion = 0;  ///< of `not_best`: the first in which something is better
};

class RuleJudge {
 public:
  /// The table must be that of the operation's constraint and ports. Nothing is searched when the operation is not
  /// `searched`: then nothing is found `not_best`.
  RuleJudge(const Operation& operation, FitTable& table);

  const Operation& operation() const { return operation_; }
  const Colorings& before() const { return before_; }
  const Colorings& after() const { return after_; }

  /// Of a class of configurations.
  Key key_of_class(std::uint32_t number) const {
    const FitClass& own = table_.classes()[before_.classes()[number].fit_class];
    return {own.ports, own.joined.both(joinable_[own.ports])};
  }
  /// Of a valid configuration.
  Key key_of(Colors configuration) const { return key_of_class(before_.class_of(configuration)); }

  /// All pairs of ports that a valid configuration joins.
  PortPairs joined_by(Colors configuration) const { return table_.classes()[class_before(configuration)].joined; }

  /// Of a recolouring of a valid configuration. Each question is answered once and remembered.
  Judged judged(Colors configuration, Colors recoloring);
  /// What is wrong, in full: colours drawn, the world in which they do not fit, the recolouring that is better.
  std::string explained(Colors configuration, Colors recoloring, const Judged& judged) const;

  /// In every world that the valid configuration fits.
  bool is_sound(Colors configuration, Colors recoloring) const {
    return admissible(configuration.ports, recoloring.ports) && after_.valid(recoloring) &&
           table_.sound(class_before(configuration), class_after(recoloring));
  }

  /// A sound recolouring that none is better than; nullopt where none is sound.
  std::optional<Colors> best(Colors configuration) const { return best_[before_.class_of(configuration)]; }
  CostValues cost(Colors configuration, Colors recoloring) const {
    return cost_of(operation_, recoloring, solid_count(configuration.ports) - solid_count(recoloring.ports));
  }

  /// Pairs of a valid configuration and a recolouring with valid colours and admissible ports.
  std::uint64_t pairs() const { return pairs_; }
  /// Where the key says of a recolouring what the worlds do not, or the other way round.
  const Failures& wrong_shortcuts() const { return wrong_shortcuts_; }
  /// Pairs of classes for which the two were compared.
  std::uint64_t shortcuts() const { return shortcuts_; }

 private:
  bool admissible(Mask ports, Mask kept) const {
    return is_subset(kept, ports) && is_subset(ports & ~kept, operation_.may_give_up);
  }
  std::uint32_t class_before(Colors colors) const { return before_.classes()[before_.class_of(colors)].fit_class; }
  std::uint32_t class_after(Colors colors) const { return after_.classes()[after_.class_of(colors)].fit_class; }
  /// Calls back for each class of admissible recolourings.
  template <class Visit>
  void for_each_class_after(Mask ports, const Visit& visit) const {
    for (Mask kept = 0; kept <= ports; ++kept)
      if (admissible(ports, kept))
        for (const std::uint32_t number : after_.of_ports(kept)) visit(number);
  }
  void search(Mask ports);
  void compare_shortcut(const ColoringClass& configurations, const ColoringClass& recolorings, bool sound);

  const Operation& operation_;
  FitTable& table_;
  Colorings before_;
  std::vector<Colors> best_of_class_;  ///< of each class after: the best of its colourings
  Colorings after_;
  std::vector<PortPairs> joinable_;          ///< by ports: the pairs that some admissible recolouring joins
  std::vector<std::optional<Colors>> best_;  ///< for each class before: the best sound recolouring
  std::uint64_t pairs_ = 0;
  Failures wrong_shortcuts_;
  std::uint64_t shortcuts_ = 0;
  std::unordered_map<std::uint64_t, Judged> known_;
};

}  // namespace restrip::verify
