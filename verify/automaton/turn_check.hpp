#pragma once
// The classes of the index automaton's certificate against arcs by their definition, for arcs of any length
// (docs/automaton.md, "What is verified of the index automaton").

#include <map>
#include <string>
#include <vector>

#include "class_check.hpp"
#include "turn_certificate.hpp"
#include "turn_parts.hpp"

namespace restrip::verify {

/// Arcs told apart by what each case costs at least, together with the class that the certificate gives them. A case is
/// left out where cutting a link or both is no worse in any patch.
struct TurnArcKind {
  std::string word;  ///< a shortest one
  TurnCosts costs;   ///< less the least of them
  std::size_t arc_class = 0;
  int offset = 0;          ///< what costs are more than the certificate's values
  bool comparable = true;  ///< false where they differ in other ways, which has been told
};

class TurnCheck {
 public:
  /// `every` = n compares the answers of every n-th kind of arc only.
  explicit TurnCheck(const TurnCertificate& certificate, unsigned every = 1);

  const std::vector<AutomatonClaim>& claims() const { return claims_; }
  const std::vector<TurnArcKind>& arcs() const { return arcs_; }

 private:
  enum Which : std::size_t { joints, witnesses, values, costs, origins, answers };
  /// An arc of an open fan that ends at the boundary, by the reach of its other link.
  struct AtBoundary;

  void check_witnesses();
  void explore();
  std::size_t place_of(const std::string& word, const TurnCosts& absolute, std::size_t arc_class);
  void check_step(std::size_t at, std::size_t letter);
  /// The costs that the certificate states, of the cases that the class keeps.
  TurnCosts stated(const TurnArcKind& arc) const;
  void check_answers(unsigned every);
  void check_pair(const TurnArcKind& first, const TurnCosts& second, const TurnCosts& second_stated,
                  const std::string& second_word);
  void fail(Which which, unsigned line, const std::string& what);

  const TurnCertificate& certificate_;
  const TurnJoints& joints_;
  const TurnWays ways_;
  std::vector<AutomatonClaim> claims_;
  std::vector<TurnArcKind> arcs_;
  std::map<std::pair<std::size_t, TurnCosts>, std::size_t> places_;
};

}  // namespace restrip::verify
