#pragma once
// Linked rules for small fans, made in the slowest and most obvious way, and a count of the faults of lists, by kind.
// Shares nothing with the checker that it tests.

#include "naive_tables.hpp"

namespace restrip::verify::test {

/// One section: for each port mask its recolourings, best first.
struct NaiveLists {
  std::string family;  ///< "linked-split"
  std::string position;
  std::map<int, std::vector<int>> lists;
  std::vector<std::pair<std::string, int>> claims;

  /// Sets the claims to the values that follow from the lists.
  void count();
};

/// How often each fault occurs, by the claim under which a checker must report it. No entry: never.
using Crimes = std::map<std::string, std::uint64_t>;

/// All data about one section, computed once.
class NaiveLinked {
 public:
  NaiveLinked(const std::string& family, const NaiveSection& section);

  /// Correct lists.
  NaiveLists good() const;
  Crimes crimes(const NaiveLists& lists) const;

  /// The number of recolourings.
  int recolorings() const { return 1 << section_->operations.front().operation().after.edges.size(); }

 private:
  struct Recoloring {
    std::vector<int> merit;  ///< empty if degrees or cycles forbid it
    int joined = 0;
    std::vector<bool> sound;  ///< in each world of the ports
  };

  bool best_beside(int ports, const std::vector<int>& list, std::size_t world) const;
  const Recoloring& at(int ports, int inner) const;

  std::string family_;
  const NaiveSection* section_;
  std::vector<std::vector<Recoloring>> recolorings_;  ///< by ports, inner
};

/// A certificate with these sections.
std::string certificate_text(const std::string& family, const std::vector<NaiveLists>& sections);

/// The sections of `linked-split` and `linked-collapse`. `families` must outlive them.
std::vector<NaiveLinked> naive_linked(const std::vector<NaiveFamily>& families);

}  // namespace restrip::verify::test
