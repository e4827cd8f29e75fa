// Why a rule is best, and what is wrong with a recolouring that is not. Every verdict is the verdict of the definition
// (definition/definition.hpp); this names the edges and the world that show it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "definition/definition.hpp"
#include "model/description.hpp"

namespace restrip::verify {

/// A smallest set of edges that break the constraint if all of them are solid, in a world in which the configuration
/// may stand: any recolouring that has them is unsound. The world is one with the fewest connections.
struct Obstacle {
  Colors edges;                      ///< inner edges after the operation, and ports that could be given up
  Mask ports = 0;                    ///< further ports that take part; they stay solid in any case
  unsigned world = 0;                ///< its number in the definition; 0 connects nothing
  std::optional<unsigned> triangle;  ///< that has too many solid edges; otherwise the edges close a cycle
  std::uint64_t excluded = 0;        ///< cheaper recolourings that have it and none of those before
};

/// What is best for a configuration, and why nothing is better.
struct Explanation {
  Colors configuration;
  std::optional<Candidate> best;   ///< the first of the best: smallest R, then smallest K; nothing if none is sound
  std::uint64_t equally_good = 0;  ///< how many recolourings are best
  std::uint64_t cheaper = 0;       ///< how many would cost less; each has all edges of some obstacle
  std::vector<Obstacle> obstacles;
};

/// From worst to best. Only rows of a rule set can be `not_a_configuration`: invalid before the operation.
enum class Standing { not_a_configuration, not_valid, unsound, worse, equally_good, best };
std::string_view name_of(Standing standing);

/// Of a recolouring.
struct Judgement {
  Colors colors;
  Standing standing = Standing::best;
  std::string because;               ///< a sentence without its full stop; empty if it is the best
  std::optional<Obstacle> obstacle;  ///< of those that are not valid or unsound, unless they take or give up a port
  std::optional<int> strips_lost;    ///< against the best; only if it is sound
};

/// The operation of a description at a position. files::FileError if the description has no such position, or if its
/// recolourings are too many to be searched.
Operation operation_at(const Description& description, const Numbers& numbers);

/// Of a valid configuration. Cost: all recolourings, each in some worlds. Throws std::logic_error if a recolouring is
/// better than the definition's best.
Explanation explanation_of(const Definition& definition, Colors configuration);
/// Of a recolouring of a valid configuration.
Judgement judgement_of(const Definition& definition, Colors configuration, Colors recoloring);

/// "t0=A t0=t1, port 0: triangle t0 has 3 solid edges".
std::string text_of(const Definition& definition, const Obstacle& obstacle);
/// The arguments of `restrip-verify explain` after the operation: "--k 5 --at 2 --before 5 --ports 1 --after 63".
std::string arguments_of(const Operation& operation, Colors configuration, const std::optional<Colors>& recoloring);

/// Reports of an explanation and, if given, of a recolouring.
std::string text_of(const Definition& definition, const Explanation& explanation,
                    const std::optional<Judgement>& judged);
nlohmann::ordered_json json_of(const Definition& definition, const Explanation& explanation,
                               const std::optional<Judgement>& judged);

}  // namespace restrip::verify
