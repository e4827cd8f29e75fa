#pragma once
// Checks the classes of a certificate against arcs by their definition, for arcs of any length
// (docs/explanation/automaton.md, "What is verified").

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "automaton/arcs_around.hpp"
#include "automaton/automaton_certificate.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

/// A claim of the certificate, with the number of tests and of failures.
struct AutomatonClaim {
  const char* claim = "";
  const char* method = "";
  std::uint64_t cases = 0;
  Failures failures;
};

/// Arcs distinguished by the least cost of each case and by their end ports, together with the class that the
/// certificate assigns to them: finitely many kinds, which include all arcs.
struct ArcKind {
  std::string word;  ///< one of the shortest
  std::string ports;
  Costs costs;                                       ///< minus the least of them
  std::vector<std::pair<std::size_t, int>> entries;  ///< the same, existing ones only
  std::size_t arc_class = 0;
  int offset = 0;          ///< their excess over the certificate's values
  bool comparable = true;  ///< false if they differ by more than an offset, which has been reported
};

class ClassCheck {
 public:
  explicit ClassCheck(const AutomatonCertificate& certificate);

  const std::vector<AutomatonClaim>& claims() const { return claims_; }
  const std::vector<ArcKind>& arcs() const { return arcs_; }

 private:
  enum Which : std::size_t { joints, witnesses, values, costs, origins, meetings, closings };
  struct Longer;

  void check_witnesses();
  void explore();
  /// The index of an arc's kind; it is new if no equal one was seen.
  std::size_t place_of(const std::string& word, const Costs& absolute, std::size_t arc_class);
  Longer longer(const ArcKind& arc, char letter) const;
  void check_step(std::size_t at, char letter);
  void check_meetings();
  void check_meeting(const ArcKind& x, const ArcKind& y);
  void check_closing(const ArcKind& arc);
  Mask allowed_pairs(const ArcKind& x, const ArcKind& y);
  bool states(const ArcKind& arc, std::size_t arc_case) const {
    return certificate_.classes[arc.arc_class].costs[arc_case].has_value();
  }
  void fail(Which which, unsigned line, const std::string& what);

  const AutomatonCertificate& certificate_;
  const ArcWays ways_;
  std::vector<AutomatonClaim> claims_;
  std::vector<ArcKind> arcs_;
  std::map<std::tuple<std::size_t, bool, std::string, Costs>, std::size_t> places_;
  std::map<std::pair<std::string, std::string>, Mask> allowed_;  ///< by end ports of two arcs
};

}  // namespace restrip::verify
