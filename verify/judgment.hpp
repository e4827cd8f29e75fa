#pragma once
// The first formulation: every configuration of an operation against every recolouring, by plain search over strips
// that were walked.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certificate.hpp"
#include "merit.hpp"
#include "report.hpp"

namespace restrip::verify {

/// What is claimed of each valid configuration's row. The order is the order in which a row is judged; a row that
/// fails one is not asked the next.
enum class RowClaim { covered, sound, most_solid, fewest_isolated, most_ports_kept };
inline constexpr std::size_t row_claim_count = 5;

/// The answer that the certificate gives to a configuration, packed; or one of the two below.
using Answer = std::uint16_t;
inline constexpr Answer not_valid = 0xffff;
inline constexpr Answer no_row = 0xfffe;
inline Answer packed(Coloring after, const Operation& operation) {
  return static_cast<Answer>(
      operation.gives_ports_up ? concatenated(after.ports, after.inner, operation.after.inner_edges()) : after.inner);
}

struct Judgment {
  std::uint64_t configurations = 0;
  std::uint64_t valid = 0;
  std::uint64_t with_row = 0;        ///< valid ones that have a row: whose row was tested for soundness
  std::uint64_t with_sound_row = 0;  ///< those of them whose row is sound
  std::uint64_t pairs = 0;           ///< (configuration with a sound row, recolouring)
  std::uint64_t costing = 0;
  std::optional<int> worst_strips;
  std::optional<int> worst_isolated;
  std::array<Failures, row_claim_count> failures;
  std::vector<bool> row_used;
  std::vector<Answer> answers;  ///< by concatenated(inner before, ports)
};

class Judge {
 public:
  Judge(const Section& section, const SectionRows& rows, const Operation& operation, std::string file);

  /// Judges the rows of all configurations of a slice.
  void judge(const PortSlice& slice);
  const Judgment& judgment() const { return judgment_; }

 private:
  void judge_configuration(const PortSlice& slice, const SurveyedColoring& configuration);
  const SurveyedColoring* own_recoloring(const PortSlice& slice, const Row& row);
  void search_better(const PortSlice& slice, const SurveyedColoring& configuration, const Row& row, Merit merit);
  /// Only the first failure of each kind is put into words.
  template <class InWords>
  void fail(RowClaim claim, const PortSlice& slice, const SurveyedColoring& configuration, const Row* row,
            const InWords& in_words) {
    Failures& failures = judgment_.failures[static_cast<std::size_t>(claim)];
    failures.add(failures.count == 0 ? explained(in_words(), slice, configuration, row) : std::string{});
  }
  std::string explained(const std::string& what, const PortSlice& slice, const SurveyedColoring& configuration,
                        const Row* row) const;

  const Section& section_;
  const SectionRows& rows_;
  const Operation& operation_;
  std::string file_;
  std::vector<const Row*> row_of_key_;
  std::vector<std::optional<SurveyedColoring>> own_;  ///< by row, where no recolourings are searched
  Judgment judgment_;
};

}  // namespace restrip::verify
