#pragma once
// A naive maker of certificates and dumps for small operations, for the tests of the verifier: sets of pairs as worlds,
// edges counted against components to find cycles, all permutations tried to find symmetries. Of the verifier it uses
// the operation as it was read, nothing else.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "operation_file.hpp"

namespace restrip::verify::operations::test {

struct NaiveColors {
  int inner = 0;
  int ports = 0;
  friend auto operator<=>(const NaiveColors&, const NaiveColors&) = default;
};

struct NaiveRow {
  int ports = 0;
  int joined = 0;
  NaiveColors after;
  std::vector<int> by;  ///< of a copy

  std::string text() const;
};

struct NaiveCertificate {
  std::string title = "restrip-operation-certificate 1";
  std::string name;
  std::vector<std::pair<std::string, long>> claims;
  std::vector<NaiveRow> rows;

  std::string text() const;
};

/// The text with an "end" line behind it.
std::string with_end(const std::string& above, std::size_t rows);

struct NaiveCandidate {
  NaiveColors after;
  std::vector<long> cost;
};

class NaiveOperation {
 public:
  explicit NaiveOperation(const OperationFile& operation) : operation_(operation) {}

  std::vector<NaiveColors> configurations() const;
  bool valid(bool after, NaiveColors colors) const;
  int joined(bool after, NaiveColors colors) const;
  /// Sound by definition, in ascending order of R, then K.
  std::vector<NaiveCandidate> sound(NaiveColors configuration) const;
  /// Nullopt when some configuration has no sound recolouring.
  std::optional<NaiveCertificate> certificate() const;
  /// What a program prints that answers with the rows.
  std::string dump(const NaiveCertificate& certificate) const;

 private:
  struct Symmetry {
    std::vector<int> ports, before, after;
  };
  using Pairs = std::set<std::pair<int, int>>;

  const Side& side(bool after) const { return after ? operation_.after : operation_.before; }
  std::vector<int> degrees(bool after, NaiveColors colors) const;
  std::vector<int> components(bool after, int inner) const;
  std::vector<Pairs> worlds(int ports) const;
  bool fits(bool after, NaiveColors colors, const Pairs& world) const;
  std::vector<long> cost(NaiveColors configuration, NaiveColors after) const;
  long counted(const Term& term, NaiveColors configuration, NaiveColors after) const;
  std::vector<Symmetry> symmetries() const;
  int moved_edges(const Symmetry& symmetry, bool after, int inner) const;
  static int moved_ports(const Symmetry& symmetry, int ports);
  static int moved_pairs(const Symmetry& symmetry, int joined);
  bool cost_stays(const Symmetry& symmetry) const;
  long change(const NaiveRow& row, NaiveColors configuration, Count count) const;

  const OperationFile& operation_;
};

}  // namespace restrip::verify::operations::test
