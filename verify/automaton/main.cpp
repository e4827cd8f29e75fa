// restrip-verify-automaton: proves the certificate of an automaton, for fans of any valence, using only
// docs/reference/notation.md and docs/explanation/automaton.md.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "automaton/automaton_digests.hpp"
#include "automaton/verify_automaton.hpp"
#include "common/counted.hpp"
#include "common/report_output.hpp"
#include "model/program.hpp"

namespace {

using namespace restrip::verify;

int run(const AutomatonOptions& options, const std::string& json) {
  const restrip::files::ReportOutput out(json);
  std::vector<ClaimResult> claims;
  if (!out.replaces_text()) fmt::print("{}", heading());
  const AutomatonTotals totals = verify_automaton(options, [&](const ClaimResult& result) {
    claims.push_back(result);
    if (!out.replaces_text()) fmt::print("{}", line_of(result));
    std::fflush(stdout);
  });
  out.print(fmt::format("{}: {}, {}, {} of arcs, {} of which {} failed; read: {}\n",
                        totals.failed == 0 ? "verified" : "NOT verified",
                        restrip::counted(totals.classes, "class", "classes"), restrip::counted(totals.rows, "row"),
                        restrip::counted(totals.kinds, "kind"), restrip::counted(totals.claims, "claim"), totals.failed,
                        text_of(totals.read)),
            text_of({{"claims", json_of(claims)},
                     {"classes", totals.classes},
                     {"rows", totals.rows},
                     {"kinds", totals.kinds},
                     {"read", text_of(totals.read)},
                     {"failed", totals.failed},
                     {"verified", totals.failed == 0}}));
  return totals.failed == 0 ? all_claims_hold : some_claim_fails;
}

}  // namespace

int main(int argc, char** argv) {
  AutomatonOptions options;
  std::string json;
  CLI::App app("Proves the certificate of an automaton: rules of fans of any valence.");
  app.name("restrip-verify-automaton");
  app.footer(
      "Exit code: 0 every claim holds, 1 some claim fails, 2 bad input.\n\n"
      "Example, from the top of the source tree:\n"
      "  build/release/bin/restrip-verify-automaton --tables-dir tables\n"
      "The compiled automaton as well:\n"
      "  build/release/bin/restrip-verify-automaton --tables-dir tables \\\n"
      "    --dump-command \"build/release/bin/restrip-dump-tables --automaton\"\n"
      "The look-up in C, from the folder that `restrip-generate automaton --language c` wrote:\n"
      "  cc restrip_automaton_check.c -o check_automaton\n"
      "  restrip-verify-automaton --tables-dir SOURCE/tables --digest-command ./check_automaton");
  app.add_option("--tables-dir", options.tables_dir, "The folder with certificates/")->capture_default_str();
  app.add_option("--dump-command", options.dump_command,
                 "A program that prints the compiled automaton; its numbers and answers are compared");
  CLI::Option* const digest_command = app.add_option(
      "--digest-command", options.digest_commands,
      "A program that prints digests of the answers of a look-up in another language "
      "(docs/how-to/other-languages.md); may be repeated. They are compared with digests of the certificate's answers");
  app.add_option("--digest-max-k", options.digest_max_k, "The largest fans of the digests")
      ->capture_default_str()
      ->needs(digest_command)
      ->check(CLI::Range(3U, largest_digest_fan));
  app.add_option("--tables-max-k", options.tables_max_k,
                 "The largest fans of the other certificates in the folder, and of the dump")
      ->capture_default_str()
      ->check(CLI::Range(3U, largest_judged_fan));
  app.add_option("--max-k", options.max_k, "The largest fans that are searched as a whole")
      ->capture_default_str()
      ->check(CLI::Range(0, 12));
  app.add_option("--every", options.every, "Of the places with k > 8, search only every N-th")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  add_json_option(app, json);
  return exit_code_of(app, argc, argv, [&] { return run(options, json); });
}
