#pragma once
// Compares the compiled tables, as a program prints them (docs/certificate.md, "Table dump"), with the certificates'
// answers, configuration by configuration.

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "judgment.hpp"

namespace restrip::verify {

/// What one table must say. `answers` is null for a table that is read but not compared.
struct ExpectedTable {
  const Operation* operation = nullptr;
  const std::vector<Answer>* answers = nullptr;
};

/// What one table of lists must say: a line for each port mask, whole, or null for a table that is not compared.
struct ExpectedLists {
  std::string name;  ///< "linked-split k 3 a 1"
  unsigned ports = 0;
  const std::vector<std::string>* lines = nullptr;
};

struct ExpectedDump {
  std::vector<ExpectedTable> tables;
  std::vector<ExpectedLists> lists;
};

struct DumpComparison {
  std::uint64_t lines = 0;  ///< entry lines read
  std::string difference;   ///< the first one, empty when there is none
};

/// Reads a dump to its end. Every expected table must occur exactly once, in any order.
DumpComparison compare_dump(std::FILE* stream, const ExpectedDump& expected);

/// Runs the program and compares what it prints; a program that fails is a difference.
DumpComparison compare_dump_of(const std::string& program, const ExpectedDump& expected);

}  // namespace restrip::verify
