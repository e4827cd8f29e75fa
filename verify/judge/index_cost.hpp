// The most that an operation adds to the length of an index buffer, 3 strips + swaps, over all turns of strips beyond
// the ports: the claim "indices" of a description (docs/reference/operation-file.md, "Families").
#pragma once

#include <optional>
#include <vector>

#include "certificate/certificate.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

/// One operation at one position whose description says how strips turn (Side::around).
///
/// A strip that continues from one triangle into the next, and on both sides of their edge, turns in each of the two.
/// The edge is a *swap* if both turns go the same way. An edge inside the patch has known turns. At a port the turn of
/// the outer triangle is not known and does not change: it may be any, at each port by itself, because outer triangles
/// may be different. So a port that stays solid adds 1 at most, if the strip turns at its inner triangle and did not
/// turn this way before; a port that is given up adds nothing to the swaps.
class IndexCost {
 public:
  explicit IndexCost(const Operation& operation);

  struct Added {
    int by_rule = 0;
    int at_most = 0;  ///< by the rule or, in a fan, by the colours passed on if they add less
  };
  /// For a valid configuration and its rule.
  Added added(Colors before, Colors rule) const;

 private:
  /// In a fan: an edge between two triangles that have ports, and the edges between them with the inserted ones.
  struct Carried {
    unsigned fan = 0;
    Mask through = 0;
  };
  static std::optional<std::vector<Carried>> carried(const Side& fan, const Side& with);
  int change(Colors before, Colors after) const;
  std::optional<Mask> passed_on(Mask inner) const;

  const Operation& operation_;
  std::optional<std::vector<Carried>> inserts_;  ///< set if the fan is before
  std::optional<std::vector<Carried>> removes_;  ///< set if it is after
};

/// Checks the claim in the positions of a certificate, if its description has it. A keeper uses the colours of the rule
/// or, in a fan, the previous colours passed on if they cost less: a strip cut by inserted triangles continues through
/// them, and a strip through removed triangles closes up. Other operations use their rule.
void report_index_cost(const Family& family, const Certificate& certificate, unsigned threads,
                       const ClaimListener& listener);

}  // namespace restrip::verify
