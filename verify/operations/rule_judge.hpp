#pragma once
// Judges recolourings by the definitions of docs/operation-file.md: a recolouring is held against every world that the
// configuration fits, and against every recolouring that stands this test. Configurations that fit the same worlds are
// judged together (fit_classes.hpp).

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "cost.hpp"
#include "fit_classes.hpp"
#include "operation_mutants.hpp"

namespace restrip::verify::operations {

enum class Verdict { right, wrong_ports, unsound, not_best };

struct Judged {
  Verdict verdict = Verdict::right;
  unsigned criterion = 0;  ///< of `not_best`: the first in which something is better
};

class RuleJudge {
 public:
  explicit RuleJudge(const OperationFile& operation);

  const OperationFile& operation() const { return operation_; }
  const Worlds& worlds() const { return worlds_; }
  const FitClasses& before() const { return before_; }
  const FitClasses& after() const { return after_; }

  /// Judges a recolouring of a valid configuration. Each question is answered once and remembered.
  Judged judged(Colors configuration, Colors recoloring);
  /// What is wrong, in full: colours drawn, the world in which they do not fit, the recolouring that is better.
  std::string explained(Colors configuration, Colors recoloring, const Judged& judged) const;

  /// In every world that the valid configuration fits.
  bool is_sound(Colors configuration, Colors recoloring) const {
    return admissible(configuration.ports, recoloring.ports) && after_.class_of(recoloring) != FitClasses::not_valid &&
           !refuting_world(configuration, recoloring);
  }

  /// A sound recolouring that none is better than; nullopt where none is sound.
  std::optional<Colors> best(Colors configuration) const { return best_[before_.class_of(configuration)]; }
  CostValues cost(Colors configuration, Colors recoloring) const {
    return cost_of(operation_, recoloring, solid_count(configuration.ports) - solid_count(recoloring.ports));
  }

  /// Pairs of a valid configuration and a recolouring with valid colours and admissible ports.
  std::uint64_t pairs() const { return pairs_; }
  /// Where the key says of a recolouring what the worlds do not, or the other way round; empty when it never does.
  const std::string& wrong_shortcut() const { return wrong_shortcut_; }
  std::uint64_t wrong_shortcuts() const { return wrong_shortcuts_; }
  /// Pairs of classes for which the two were compared.
  std::uint64_t shortcuts() const { return shortcuts_; }

 private:
  bool admissible(Mask ports, Mask kept) const {
    return (is_subset(kept, ports) || mutated(OperationMutant::take_ports)) &&
           (is_subset(ports & ~kept, operation_.may_give_up) || mutated(OperationMutant::give_up_any_port));
  }
  void search(Mask ports);
  /// The first world that the configuration fits and the recolouring does not.
  std::optional<std::size_t> refuting_world(Colors configuration, Colors recoloring) const;

  const OperationFile& operation_;
  Worlds worlds_;
  FitClasses before_;
  FitClasses after_;
  std::vector<Colors> best_of_class_;        ///< of each class after: the best of its colourings
  std::vector<std::optional<Colors>> best_;  ///< for each class before: the best sound recolouring
  std::uint64_t pairs_ = 0;
  std::string wrong_shortcut_;
  std::uint64_t wrong_shortcuts_ = 0;
  std::uint64_t shortcuts_ = 0;
  std::unordered_map<std::uint64_t, Judged> known_;
};

}  // namespace restrip::verify::operations
