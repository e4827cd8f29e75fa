// The stage `certify` of the generator's pipeline: certificates (docs/reference/certificate.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {

// Why no sound recolouring is preferred to a rule: the reasons in certificates (docs/reference/certificate.md,
// "Reasons"). A reason is a case tree; docs/reference/verifiers.md proves its validity.

/// Edges of the side after an operation: inner edges first, then ports, of which only those that may be given up count.
using EdgeSet = Mask;
[[nodiscard]] constexpr EdgeSet single(std::size_t edge) { return EdgeSet{1} << edge; }

/// Either two cases (an edge solid, and the same edge dashed), or disjoint sets of edges that cannot all be solid.
struct Reason {
  unsigned edge = 0;
  std::vector<Reason> cases;  ///< solid, dashed; empty for a leaf
  std::vector<EdgeSet> sets;  ///< in ascending order of (size, set), smallest first

  [[nodiscard]] std::size_t leaves() const;
  /// The reason as certificates write it.
  [[nodiscard]] std::string text() const;
};

/// Whether the rules of an operation can have reasons: strips or forests, preferred by fewest_strips() first.
[[nodiscard]] bool has_reasons(const Operation& operation);

/// The step limit of the search for the smallest reason of a rule; beyond it, a larger one is made quickly. The limit
/// is a number of steps, not a time, so that the bytes are the same everywhere. The shipped rules take at most a
/// quarter of it (reason_test.cpp).
inline constexpr std::uint64_t most_steps_of_smallest_reason = 1'000'000;

struct FoundReason {
  Reason reason;
  std::uint64_t steps = 0;  ///< steps taken
  bool smallest = false;    ///< no reason has fewer leaves
};

/// Finds reasons for the rules of an operation for which has_reasons() is true.
class Reasoner {
 public:
  explicit Reasoner(const Operation& operation);

  /// `best` must be the best choice for these solid ports and previously joined pairs (two bits each).
  [[nodiscard]] FoundReason find(Mask solid_ports, const std::vector<Mask>& joined, const Choice& best,
                                 std::uint64_t most_steps = most_steps_of_smallest_reason) const;

 private:
  /// Edges that cannot all be solid unless `pair` was joined before. Here ports always follow the inner edges.
  struct Forbidden {
    EdgeSet edges = 0;
    Mask pair = 0;
  };

  Mask may_give_up_;
  Side after_;
  std::vector<EdgeSet> edges_of_triangle_;
  std::vector<Forbidden> forbidden_;
};

/// All sections of one certificate.
struct Certificate {
  std::string name;
  std::vector<Section> sections;
  std::string text;  ///< the file: claims, rows and reasons; empty if only the rules are needed
  [[nodiscard]] std::size_t rows() const;
};

/// Groups the sections by certificate; the sections of each must be consecutive. The texts take time, which `threads`
/// share.
[[nodiscard]] std::vector<Certificate> certify(std::vector<Section> sections, unsigned threads, bool with_texts);

/// Appends the last line: the number of rows, and two sums of bytes by which a reader can locate a single altered byte.
[[nodiscard]] std::string sealed(std::string text, std::size_t rows);

}  // namespace restrip::generator
