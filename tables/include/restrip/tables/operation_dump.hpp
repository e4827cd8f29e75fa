// Prints what a compiled table of an operation file answers, for `restrip-verify --operation FILE --header HEADER
// --dump-command PROGRAM`.
// The whole program is
//
//     #include "restrip/tables/operation_dump.hpp"
//     #include "restrip/tables/operations/bisect.hpp"
//     int main() { return restrip::tables::print_dump("bisect", restrip::tables::bisect); }
#pragma once

#include <cstdio>

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

/// docs/certificate.md, "Table dump". 0, or 1 when standard output takes no more.
template <class Entry, std::size_t Size>
int print_dump(const char* name, const OperationTable<Entry, Size>& table) {
  std::printf("restrip-table-dump 3\ntable %s\n", name);
  const std::uint32_t inner_end = table.matching ? 1 : std::uint32_t{1} << table.before.edges;
  for (std::uint32_t inner = 0; inner < inner_end; ++inner)
    for (std::uint32_t ports = 0; ports < std::uint32_t{1} << table.ports; ++ports) {
      const OperationRule rule = rule_of(table, inner, ports);
      if (rule.valid)
        std::printf("%x %x %x %x\n", unsigned{inner}, unsigned{ports}, unsigned{rule.colors}, unsigned{rule.ports});
      else
        std::printf("%x %x -\n", unsigned{inner}, unsigned{ports});
    }
  std::printf("end %zu\n", Size);
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? 0 : 1;
}

}  // namespace restrip::tables
