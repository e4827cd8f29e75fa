// restrip-verify-automaton: proves the certificates of the automata, for fans of any valence, from docs/notation.md and
// docs/automaton.md alone.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "exit_code.hpp"
#include "facts.hpp"
#include "quantity.hpp"
#include "verify_automaton.hpp"

namespace {

using namespace restrip::verify;

int run(const restrip::verify::AutomatonOptions& options) {
  fmt::print("{}", heading());
  const AutomatonTotals totals = verify_automaton(options, [](const ClaimResult& result) {
    fmt::print("{}", line_of(result));
    std::fflush(stdout);
  });
  fmt::print("{}: {}, {}, {} of arcs, {} of which {} failed\n", totals.failed == 0 ? "verified" : "NOT verified",
             quantity(totals.classes, "class", "es"), quantity(totals.rows, "row"), quantity(totals.kinds, "kind"),
             quantity(totals.claims, "claim"), totals.failed);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::runtime_error("standard output: what was found could not be written");
  return totals.failed == 0 ? all_claims_hold : some_claim_fails;
}

}  // namespace

int main(int argc, char** argv) {
  restrip::verify::AutomatonOptions options;
  bool facts = false;
  std::string cost = "both";
  CLI::App app("Proves the certificates of the automata: rules of fans of any valence.");
  app.name("restrip-verify-automaton");
  app.footer(
      "Exit code: 0 every claim holds, 1 some claim fails, 2 bad input.\n\n"
      "Example, from the top of the source tree:\n"
      "  build/release/bin/restrip-verify-automaton --tables-dir tables\n"
      "An index automaton of other weights, alone in its folder:\n"
      "  build/release/bin/restrip-verify-automaton --tables-dir DIR --cost indices");
  app.add_option("--tables-dir", options.tables_dir, "The folder with certificates/")->capture_default_str();
  app.add_option("--cost", cost, "Which automaton: of fewest strips, of the index cost, or both")
      ->capture_default_str()
      ->check(CLI::IsMember({"strips", "indices", "both"}));
  app.add_option("--tables-max-k", options.tables_max_k, "The largest fans of the other certificates in the folder")
      ->capture_default_str()
      ->check(CLI::Range(3U, restrip::verify::largest_judged_fan));
  app.add_option("--max-k", options.max_k, "The largest fans that are searched as a whole for fewest strips")
      ->capture_default_str()
      ->check(CLI::Range(1, 12));
  app.add_option("--every", options.every, "Of the places with k > 8 search every N-th only")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--index-max-k", options.index_max_k, "The same for the index cost")
      ->capture_default_str()
      ->check(CLI::Range(1, 9));
  app.add_option("--index-every", options.index_every,
                 "Of the pairs of arcs of the index automaton, and of its places with k > 5, look at every N-th only")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_flag("--facts", facts, "Read no certificate: print the worst that an operation costs in fans of any valence");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? all_claims_hold : bad_input;
  }
  // What the other options ask for is then not done: that is no way to ignore them.
  const auto refuse = [&](const std::string& why, std::initializer_list<const char*> without) {
    for (const char* name : without)
      if (!app.get_option(name)->empty()) {
        fmt::print(stderr, "restrip-verify-automaton: {}, so {} has no effect; leave it out\n", why, name);
        return true;
      }
    return false;
  };
  if ((facts && refuse("--facts reads and searches nothing", {"--tables-dir", "--cost", "--tables-max-k", "--max-k",
                                                              "--every", "--index-max-k", "--index-every"})) ||
      (cost == "strips" &&
       refuse("--cost strips leaves the index automaton out", {"--index-max-k", "--index-every"})) ||
      (cost == "indices" &&
       refuse("--cost indices leaves the automaton of fewest strips out", {"--tables-max-k", "--max-k", "--every"})))
    return bad_input;
  options.strips = cost != "indices";
  options.indices = cost != "strips";
  try {
    if (!facts) return run(options);
    fmt::print("{}", restrip::verify::table_of(restrip::verify::facts_of_every_fan()));
    if (std::fflush(stdout) != 0) throw std::runtime_error("standard output: the table could not be written");
    return all_claims_hold;
  } catch (const std::exception& error) {
    std::fflush(stdout);
    fmt::print(stderr, "restrip-verify-automaton: {}\n", error.what());
    return bad_input;
  }
}
