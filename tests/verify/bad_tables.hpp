#pragma once
// Wrong tables aimed at one check each: for every constraint and every key, the optimum that a checker without the
// constraint would accept. Random damage does not find such checkers.

#include <functional>
#include <string>

#include "naive_tables.hpp"

namespace restrip::verify::test {

struct BadTable {
  std::string kind;      ///< "pairing dropped"
  std::string crime;     ///< "pairing dropped, split k 4 a 2, key 5 4"
  std::string expected;  ///< what the checker must report
  NaiveTable table;
};

/// Stops when the callback returns false.
void for_each_bad_table(int max_k, const std::function<bool(const BadTable&)>& visit);

}  // namespace restrip::verify::test
