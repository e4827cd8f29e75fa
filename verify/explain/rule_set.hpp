// A rule set of any source, as CSV with the columns of `restrip-generate dump`: read, and each row judged by the
// definition.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "explain/explanation.hpp"

namespace restrip::verify {

/// A row that is not as good as the best, or states a wrong change.
struct BadRow {
  unsigned line = 0;
  Standing standing = Standing::best;
  int strips_lost = 0;
  std::string because;
  std::string arguments;  ///< of `restrip-verify explain`, after the operation
};

struct RuleSetReport {
  std::string operation;
  std::uint64_t rows = 0;
  std::array<std::uint64_t, 6> standings{};  ///< of the rows, by Standing
  std::uint64_t misstated = 0;               ///< rows whose `strips` or `isolated` is not what they change
  std::uint64_t configurations = 0;          ///< valid ones of the positions that the file has rows of
  std::int64_t strips_lost = 0;              ///< of sound rows, against the best
  std::uint64_t positions = 0;               ///< that the file has rows of
  std::vector<std::string> without_row;      ///< the first such configurations, as arguments of `explain`
  std::vector<std::string> absent;           ///< listed positions of the same first number without any row
  std::vector<BadRow> worst;                 ///< the worst first

  std::uint64_t at_least(Standing standing) const;
  std::uint64_t not_configurations() const { return standings.front(); }
  bool best() const { return misstated == 0 && at_least(Standing::equally_good) == rows; }
};

/// Judges a file. `family` or, if it is empty, its header says which of the descriptions is meant; a header that
/// several have is an InputError. The header: the names of the numbers, then `before,ports,after`, where shipped
/// families have the words of their dumps; `ports_after` and `strips,isolated` may follow. The header may be repeated.
/// InputError if the file is not well formed, has two rows of one configuration, or has rows of positions that do not
/// exist. Keeps at most `worst` bad rows, and as many configurations without a row.
RuleSetReport judge_rules(const std::string& file, const std::string& text,
                          const std::vector<Description>& descriptions, const std::string& family, std::size_t worst,
                          unsigned threads);

/// `source`: how `explain` is given the operation, "--family split".
std::string text_of(const RuleSetReport& report, const std::string& source);
nlohmann::ordered_json json_of(const RuleSetReport& report);

}  // namespace restrip::verify
