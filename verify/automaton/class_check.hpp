#pragma once
// The classes of a certificate against arcs by their definition, for arcs of any length (docs/automaton.md, "What is
// verified").

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "automaton_certificate.hpp"
#include "judgment.hpp"

namespace restrip::verify {

/// A claim of the certificate, how often it was tested and how often it failed.
struct AutomatonClaim {
  const char* claim = "";
  const char* method = "";
  std::uint64_t cases = 0;
  Failures failures;
};

/// Arcs told apart by what is best for each case and by their end ports, each together with the class that the
/// certificate gives it: finitely many, which together are all arcs.
struct ProductArc {
  std::string word;  ///< a shortest one
  Worths worths;     ///< less the best of them
  Worth best;        ///< of them all
  std::size_t arc_class = 0;
  Worth offset;            ///< what worths are more than the certificate's values
  bool comparable = true;  ///< false where they differ in other ways, which has been told
};

class ClassCheck {
 public:
  explicit ClassCheck(const AutomatonCertificate& certificate);

  const std::vector<AutomatonClaim>& claims() const { return claims_; }
  const std::vector<ProductArc>& arcs() const { return arcs_; }

 private:
  enum Which : std::size_t { witnesses, values, gains, origins, meetings, closings };

  void check_witnesses();
  void explore();
  /// The place of an arc among all; it is new when nothing like it was seen.
  std::size_t place_of(const std::string& word, const Worths& absolute, std::size_t arc_class);
  void check_step(std::size_t at, std::size_t letter);
  void check_meetings();
  void check_meeting(const ProductArc& x, const ProductArc& y);
  void check_closings();
  void fail(Which which, unsigned line, const std::string& what);

  const AutomatonCertificate& certificate_;
  std::vector<AutomatonClaim> claims_;
  std::vector<ProductArc> arcs_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace restrip::verify
