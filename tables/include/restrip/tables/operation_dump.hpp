// Prints what a compiled table of an operation file answers, for `restrip-verify --operation FILE --header HEADER
// --dump-command PROGRAM`.
// The whole program is
//
//     #include "restrip/tables/operation_dump.hpp"
//     #include "restrip/tables/operations/bisect.hpp"
//     int main() { return restrip::tables::print_dump("bisect", restrip::tables::bisect_rules); }
#pragma once

#include <cstdio>

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

/// Parts of a dump.
struct DumpText {
  /// The lines of one table. `rule` is called with a mask of inner edges and one of ports; `more` may print what else
  /// is reported with an answer.
  template <class Rule, class More>
  static void print_rules(unsigned edges, unsigned port_count, const Rule& rule, const More& more) {
    for (std::uint32_t inner = 0; inner < std::uint32_t{1} << edges; ++inner)
      for (std::uint32_t ports = 0; ports < std::uint32_t{1} << port_count; ++ports) {
        std::printf("%x %x ", unsigned{inner}, unsigned{ports});
        const OperationRule found = rule(inner, ports);
        if (found.valid) {
          std::printf("%x %x %d", unsigned{found.colors}, unsigned{found.ports}, found.strips);
          more(patch_edges(inner, ports), patch_edges(found.colors, found.ports));
        } else {
          std::putchar('-');
        }
        std::putchar('\n');
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

  /// Prints the change in isolated triangles.
  template <class Table>
  static auto isolated_by(const Table& table) {
    return [before = table.triangles_before, after = table.triangles_after](PatchEdges solid, PatchEdges now) {
      std::printf(" %d", isolated_among(after, now) - isolated_among(before, solid));
    };
  }

  template <class Entry, std::size_t Size, class More>
  static int print_table(const char* name, const OperationTable<Entry, Size>& table, const More& more) {
    std::printf("restrip-table-dump 4\ntable %s\n", name);
    print_rules(
        table.matching ? 0 : table.before.edges, table.ports,
        [&](std::uint32_t inner, std::uint32_t ports) { return rule_of(table, inner, ports); }, more);
    return print_end(Size);
  }

  /// `more_at` gives what is printed more at a position.
  template <class Entry, std::size_t Size, std::size_t Positions, class MoreAt>
  static int print_tables(const char* name, const OperationFamily<Entry, Size, Positions>& family,
                          const MoreAt& more_at) {
    std::printf("restrip-table-dump 4\n");
    for (const FamilyPosition& at : family.positions) {
      std::printf("table %s ", name);
      print_position(family.position, at.numbers);
      std::putchar('\n');
      print_rules(
          family.matching ? 0 : at.before.edges, at.ports,
          [&](std::uint32_t inner, std::uint32_t ports) { return rule_of(family, at.numbers, inner, ports); },
          more_at(at));
    }
    return print_end(Size);
  }
};

/// docs/reference/verifiers.md, "Table dump". 0, or 1 when standard output takes no more.
template <class Entry, std::size_t Size>
int print_dump(const char* name, const OperationTable<Entry, Size>& table) {
  return DumpText::print_table(name, table, [](PatchEdges, PatchEdges) {});
}

/// The same with the change in isolated triangles.
template <class Entry, std::size_t Size, std::size_t Before, std::size_t After>
int print_dump(const char* name, const SurfaceOperation<Entry, Size, Before, After>& table) {
  return DumpText::print_table(name, table, DumpText::isolated_by(table));
}

/// The same of a family, one table for each position.
template <class Entry, std::size_t Size, std::size_t Positions>
int print_dump(const char* name, const OperationFamily<Entry, Size, Positions>& family) {
  return DumpText::print_tables(name, family, [](const FamilyPosition&) { return [](PatchEdges, PatchEdges) {}; });
}

template <class Entry, std::size_t Size, std::size_t Positions, std::size_t Before, std::size_t After>
int print_dump(const char* name, const SurfaceFamily<Entry, Size, Positions, Before, After>& family) {
  return DumpText::print_tables(
      name, family, [&](const FamilyPosition& at) { return DumpText::isolated_by(position_of(family, at.numbers)); });
}

}  // namespace restrip::tables
