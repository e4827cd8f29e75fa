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

/// Parts of a dump.
struct DumpText {
  /// The lines of one table; `rule` is called with a mask of inner edges and one of ports.
  template <class Rule>
  static void print_rules(unsigned edges, unsigned port_count, const Rule& rule) {
    for (std::uint32_t inner = 0; inner < std::uint32_t{1} << edges; ++inner)
      for (std::uint32_t ports = 0; ports < std::uint32_t{1} << port_count; ++ports) {
        const OperationRule found = rule(inner, ports);
        if (found.valid)
          std::printf("%x %x %x %x\n", unsigned{inner}, unsigned{ports}, unsigned{found.colors}, unsigned{found.ports});
        else
          std::printf("%x %x -\n", unsigned{inner}, unsigned{ports});
      }
  }

  /// A position: "k 8 a 3" of "k {0} a {1}".
  static void print_position(const char* text, const FamilyNumbers& numbers) {
    for (; *text != 0; ++text)
      if (text[0] == '{' && text[1] >= '0' && text[1] <= '2' && text[2] == '}') {
        std::printf("%u", numbers[static_cast<std::size_t>(text[1] - '0')]);
        text += 2;
      } else {
        std::putchar(*text);
      }
  }

  /// The last line. 0, or 1 when standard output takes no more.
  static int print_end(std::size_t lines) {
    std::printf("end %zu\n", lines);
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? 0 : 1;
  }
};

/// docs/certificate.md, "Table dump". 0, or 1 when standard output takes no more.
template <class Entry, std::size_t Size>
int print_dump(const char* name, const OperationTable<Entry, Size>& table) {
  std::printf("restrip-table-dump 3\ntable %s\n", name);
  DumpText::print_rules(table.matching ? 0 : table.before.edges, table.ports,
                        [&](std::uint32_t inner, std::uint32_t ports) { return rule_of(table, inner, ports); });
  return DumpText::print_end(Size);
}

/// The same of a family, one table for each position.
template <class Entry, std::size_t Size, std::size_t Positions>
int print_dump(const char* name, const OperationFamily<Entry, Size, Positions>& family) {
  std::printf("restrip-table-dump 3\n");
  for (const FamilyPosition& at : family.positions) {
    std::printf("table %s ", name);
    DumpText::print_position(family.position, at.numbers);
    std::putchar('\n');
    DumpText::print_rules(
        family.matching ? 0 : at.before.edges, at.ports,
        [&](std::uint32_t inner, std::uint32_t ports) { return rule_of(family, at.numbers, inner, ports); });
  }
  return DumpText::print_end(Size);
}

}  // namespace restrip::tables
