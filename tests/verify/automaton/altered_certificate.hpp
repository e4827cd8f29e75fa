// Certificates of automata altered in one row: each alteration must be noticed.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "altered_lines.hpp"

namespace restrip::verify::test {

/// What a checker says first of a certificate; empty when all claims hold.
using VerdictOf = std::function<std::string(const std::vector<std::string>& lines)>;

/// Changes `count` rows of a kind, one at a time, spread over the file; each must be noticed.
inline void expect_each_noticed(const std::vector<std::string>& shipped, const VerdictOf& verdict_of,
                                const std::string& kind, const Change& change, const std::string& message,
                                std::size_t count) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < shipped.size(); ++i)
    if (shipped[i].rfind(kind + " ", 0) == 0 && change(words_of(shipped[i]))) rows.push_back(i);
  ASSERT_GE(rows.size(), count) << kind;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t row = rows[(2 * n + 1) * rows.size() / (2 * count)];
    std::vector<std::string> lines = shipped;
    lines[row] = change(words_of(lines[row])).value();
    const std::string verdict = verdict_of(lines);
    EXPECT_NE(verdict.find(message), std::string::npos) << shipped[row] << " -> " << lines[row] << ": " << verdict;
  }
}

}  // namespace restrip::verify::test
