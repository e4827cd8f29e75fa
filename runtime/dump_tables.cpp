// restrip-dump-tables: prints what the compiled rules answer to every configuration, valid or not, in every position,
// so that those who trust neither the generator nor the look-up in the tables can compare (docs/certificate.md, "Table
// dump"; "Dump of linked rules", the output with --linked; "Dump of the automaton", that with --automaton).
#include <cstdio>
#include <string>
#include <string_view>

#include "dump_output.hpp"
#include "restrip/operations/linked.hpp"
#include "restrip/rules/rules.hpp"

namespace {

using restrip::Word;

using restrip::dump::Output;

void configuration(Output& out, Word before, Word ports, const restrip::Rule& rule) {
  out.hex(before, ' ');
  out.hex(ports, ' ');
  if (rule.valid) {
    out.hex(rule.colors, ' ');
    out.hex(ports, '\n');
  } else {
    out.text('-');
    out.text('\n');
  }
  out.entry_done();
}

void flip(Output& out, bool inner, unsigned ports, const restrip::FlipRule& rule) {
  out.hex(inner ? 1 : 0, ' ');
  out.hex(ports, ' ');
  if (rule.valid) {
    out.hex(rule.inner ? 1 : 0, ' ');
    out.hex(rule.ports, '\n');
  } else {
    out.text('-');
    out.text('\n');
  }
  out.entry_done();
}

/// Every pair of masks, in ascending order.
template <class Rule>
void all(Output& out, std::size_t before_bits, std::size_t port_bits, Rule&& rule) {
  for (Word before = 0; before < restrip::bit(before_bits); ++before)
    for (Word ports = 0; ports < restrip::bit(port_bits); ++ports)
      configuration(out, before, ports, rule(before, ports));
}

template <class Table>
void lists(Output& out, const std::string& heading, const Table& table, std::size_t k, std::size_t place) {
  out.line(heading);
  for (Word ports = 0; ports < restrip::bit(k); ++ports) {
    const std::size_t list = table.first[k] + (place << k) + ports;
    out.hex(ports, ' ');
    for (std::size_t at = table.start[list]; at < table.start[list + 1]; ++at) {
      out.hex(table.rules[at].recoloring, ' ');
      out.hex(restrip::tables::pairings[table.rules[at].pairing], at + 1 < table.start[list + 1] ? ' ' : '\n');
    }
    out.entry_done();
  }
}

void tables(Output& out, std::size_t max_k) {
  using std::to_string;
  for (const bool collapse : {false, true}) {
    for (std::size_t k = 3; k <= max_k; ++k) {
      for (std::size_t a = 1; a < k; ++a) {
        out.line((collapse ? "table collapse k " : "table split k ") + to_string(k) + " a " + to_string(a));
        const restrip::SplitPosition at{k, a};
        all(out, collapse ? k + 3 : k, k, [&](Word before, Word ports) {
          return collapse ? collapse_rule(at, before, ports) : split_rule(at, before, ports);
        });
      }
    }
  }
  for (const bool collapse : {false, true}) {
    for (std::size_t k = 1; k <= max_k; ++k) {
      for (std::size_t i = 0; i <= k; ++i) {
        for (std::size_t j = i + 1; j <= k; ++j) {
          out.line((collapse ? "table open-collapse k " : "table open-split k ") + to_string(k) + " gaps " +
                   to_string(i) + " " + to_string(j));
          const restrip::GapPair at{k, i, j};
          all(out, collapse ? k + 2 : k - 1, k, [&](Word before, Word ports) {
            return collapse ? open_collapse_rule(at, before, ports) : open_split_rule(at, before, ports);
          });
        }
      }
    }
  }
  for (const bool collapse : {false, true}) {
    for (std::size_t k = 1; k <= max_k; ++k) {
      for (std::size_t i = 0; i <= k; ++i) {
        out.line((collapse ? "table boundary-collapse k " : "table boundary-split k ") + to_string(k) + " gap " +
                 to_string(i));
        const restrip::Gap at{k, i};
        all(out, collapse ? k : k - 1, k, [&](Word before, Word ports) {
          return collapse ? boundary_collapse_rule(at, before, ports) : boundary_split_rule(at, before, ports);
        });
      }
    }
  }
  for (std::size_t k = 3; k <= max_k; ++k)
    for (std::size_t a = 1; a <= k / 2; ++a)
      lists(out, "table linked-split k " + to_string(k) + " a " + to_string(a), restrip::tables::linked_split, k,
            a - 1);
  for (std::size_t k = 3; k <= max_k; ++k)
    lists(out, "table linked-collapse k " + to_string(k), restrip::tables::linked_collapse, k, 0);
  out.line("table flip");
  for (const bool inner : {false, true})
    for (unsigned ports = 0; ports < 16; ++ports) flip(out, inner, ports, restrip::flip_rule(inner, ports));
}

/// The number from 3 to table_max_k that a word says; 0 for any other word.
std::size_t valence_named(std::string_view word) {
  for (std::size_t k = 3; k <= restrip::table_max_k; ++k)
    if (word == std::to_string(k)) return k;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  bool linked = false;
  bool automaton = false;
  std::size_t max_k = restrip::table_max_k;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--linked") {
      linked = true;
    } else if (word == "--automaton") {
      automaton = true;
    } else if (word == "--max-k" && i + 1 < argc && valence_named(argv[i + 1]) != 0) {
      max_k = valence_named(argv[++i]);
    } else {
      const bool asked = word == "--help";
      std::fprintf(
          asked ? stdout : stderr,
          "usage: restrip-dump-tables [--linked | --automaton] [--max-k K]\n"
          "  what the compiled rules answer; with --linked, what the linked look-up picks; with --automaton, the\n"
          "  numbers of the automaton and digests of what it answers; 3 <= K <= %u\n",
          static_cast<unsigned>(restrip::table_max_k));
      return asked ? 0 : 2;
    }
  }
  if (linked && automaton) {
    std::fputs("restrip-dump-tables: choose one of --linked and --automaton\n", stderr);
    return 2;
  }
  Output out(stdout);
  if (automaton) {
    out.line("restrip-automaton-dump 1");
    restrip::dump::automaton(out, max_k);
  } else if (linked) {
    out.line("restrip-linked-dump 1");
    restrip::dump::linked_rules(out, max_k);
  } else {
    out.line("restrip-table-dump 3");
    tables(out, max_k);
  }
  return out.finish() ? 0 : 1;
}
