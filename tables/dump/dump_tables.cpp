// restrip-dump-tables: prints the results of the compiled rules for every configuration, valid or not, in every
// position, for comparison without trust in the generator or the look-up (docs/reference/verifiers.md, "Table dump";
// "Dump of the automaton", with --automaton); or, with --digests, only digests of them; for the automaton, also digests
// of its results in larger fans.
#include <cstdio>
#include <string>
#include <string_view>

#include "dump_output.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/rules/rules.hpp"

#ifndef RESTRIP_VERSION
#define RESTRIP_VERSION "of a user's tables"
#endif

namespace restrip::dump {
namespace {

/// The colours of an answer and the ports that it keeps, then the changes that it reports.
void answer(Output& out, Word colors, Word kept, int strips, int isolated) {
  out.hex(colors, ' ');
  out.hex(kept, ' ');
  out.text(std::to_string(strips) + ' ' + std::to_string(isolated) + '\n');
}

void all_tables(Output& out, std::size_t max_k) {
  using std::to_string;
  for_each_position(
      max_k, [&](unsigned operation, std::size_t k, std::size_t p, std::size_t q, std::size_t bits, auto&& rule_of) {
        constexpr const char* families[] = {"split",         "collapse",       "open-split",
                                            "open-collapse", "boundary-split", "boundary-collapse"};
        constexpr const char* places[] = {" a ", " gaps ", " gap "};
        out.line(std::string("table ") + families[operation] + " k " + to_string(k) + places[operation / 2] +
                 to_string(p) + (operation / 2 == 1 ? ' ' + to_string(q) : ""));
        const bool collapse = operation % 2 != 0;
        const auto fan = open_fan(k);
        const auto path = operation / 2 == 1 ? path_with_chord(k, p, q) : restrip::path(k, p);
        // The change in isolated triangles. Closed fans have separate code, which split() and collapse() use.
        const auto isolated_by = [&](Word before, Word ports, const Rule& rule) {
          if (operation >= 2)
            return detail::isolated(collapse ? fan : path, rule.colors, ports) -
                   detail::isolated(collapse ? path : fan, before, ports);
          const Word ring = detail::isolated_ring(k, p, collapse ? before : rule.colors, ports);
          const Word closed = detail::isolated_closed(k, collapse ? rule.colors : before, ports);
          return collapse ? -count_difference(ring, closed) : count_difference(ring, closed);
        };
        // Every pair of masks, in ascending order.
        for (Word before = 0; before < bit(bits); ++before)
          for (Word ports = 0; ports < bit(k); ++ports) {
            out.hex(before, ' ');
            out.hex(ports, ' ');
            if (const Rule rule = rule_of(before, ports); rule.valid)
              answer(out, rule.colors, ports, rule.strips, isolated_by(before, ports, rule));
            else
              out.text("-\n");
            out.entry_done();
          }
      });
  out.line("table flip");
  for (const bool inner : {false, true})
    for (unsigned ports = 0; ports < 16; ++ports) {
      out.hex(inner ? 1 : 0, ' ');
      out.hex(ports, ' ');
      if (const FlipRule rule = flip_rule(inner, ports); rule.valid)
        answer(out, rule.inner ? 1 : 0, rule.ports, rule.strips, detail::isolated_by_flip(inner, ports, rule));
      else
        out.text("-\n");
      out.entry_done();
    }
}

/// The number from 3 to max_word_valence that a word names; 0 for any other word.
std::size_t valence_named(std::string_view word) {
  for (std::size_t k = 3; k <= max_word_valence; ++k)
    if (word == std::to_string(k)) return k;
  return 0;
}

}  // namespace
}  // namespace restrip::dump

namespace {

int run(int argc, char** argv) {
  using namespace restrip;
  using namespace restrip::dump;
  bool automaton = false;
  bool digests = false;
  std::size_t max_k = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--automaton") {
      automaton = true;
    } else if (word == "--digests") {
      digests = true;
    } else if (word == "--max-k" && i + 1 < argc && valence_named(argv[i + 1]) != 0) {
      max_k = valence_named(argv[++i]);
    } else if (word == "--version") {
      std::puts(RESTRIP_VERSION);
      return 0;
    } else {
      const bool asked = word == "--help" || word == "-h";
      std::fprintf(asked ? stdout : stderr,
                   "Prints what the compiled rules answer, in the text that restrip-verify reads.\n\n"
                   "Usage: restrip-dump-tables [--automaton | --digests | --automaton --digests] [--max-k K]\n\n"
                   "  --automaton  the numbers of the automaton and digests of what it answers\n"
                   "  --digests    digests of what the rules answer; with --automaton, of what the automaton answers\n"
                   "  --max-k K    fans of at most K triangles, 3 to %u; with both options 3 to %u, by default 28\n"
                   "  --version    the version\n\n"
                   "Example: restrip-verify --tables-dir tables --dump-command restrip-dump-tables\n",
                   static_cast<unsigned>(table_max_k), static_cast<unsigned>(max_word_valence));
      return asked ? 0 : 2;
    }
  }
  if (automaton && digests) return dump::automaton_digests(max_k == 0 ? 28 : max_k) ? 0 : 1;
  if (max_k == 0) max_k = table_max_k;
  if (max_k > table_max_k) {
    std::fprintf(stderr, "restrip-dump-tables: --max-k %zu: the tables answer fans of up to %u triangles\n", max_k,
                 static_cast<unsigned>(table_max_k));
    return 2;
  }
  if (digests) return dump::digests(max_k, "016") ? 0 : 1;
  Output out(stdout);
  if (automaton) {
    out.line("restrip-automaton-dump 2");
    dump::automaton(out, max_k);
  } else {
    out.line("restrip-table-dump 4");
    all_tables(out, max_k);
  }
  return out.finish() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const int code = run(argc, argv);
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  std::fputs("restrip-dump-tables: standard output could not be written\n", stderr);
  return 2;
}
