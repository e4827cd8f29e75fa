#include "automaton/command.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "automaton/automaton_certificate.hpp"
#include "automaton/class_check.hpp"
#include "automaton/fan_check.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "judge/report.hpp"
#include "model/description.hpp"
#include "model/input.hpp"
#include "model/program.hpp"

namespace restrip::verify {
namespace {

struct AutomatonOptions {
  std::string tables_dir = "tables";
  std::string dump_command;                    ///< prints the compiled automaton; empty: not read
  std::vector<std::string> digest_commands;    ///< programs that print digests of the answers of look-ups
  unsigned digest_max_k = largest_digest_fan;  ///< the largest fans of digests
  unsigned tables_max_k = largest_fan;  ///< the largest fans of the other certificates, and of the answers of the dump
  unsigned max_k = 10;                  ///< the largest fans that are searched
  unsigned every = 1;                   ///< only every n-th place of the fans with k > 8 is searched
  std::string json;
};

struct AutomatonTotals {
  std::uint64_t claims = 0;
  std::uint64_t failed = 0;
  std::uint64_t classes = 0;
  std::uint64_t rows = 0;
  Sources read;
  std::uint64_t kinds = 0;  ///< of arcs, distinguished by the best cost of each case, ports and class
};

std::string certificate_of(const AutomatonOptions& options, const std::string& family) {
  return options.tables_dir + "/certificates/" + family + ".cert";
}

/// Checks the certificate; calls the listener for each claim. Throws files::FileError if a file cannot be read.
AutomatonTotals verify_automaton(const AutomatonOptions& options, const ClaimListener& listener) {
  AutomatonTotals totals;
  double start = thread_seconds();
  // Each claim with the time since the previous one.
  const auto report = [&](const std::string& claim, const std::string& method, std::uint64_t cases,
                          const Failures& failures) {
    ClaimResult result{"automaton", claim, method, cases, thread_seconds() - start, failures};
    start = thread_seconds();
    if (cases == 0 && result.held()) result.failures.add("nothing was compared");
    ++totals.claims;
    totals.failed += result.held() ? 0U : 1U;
    listener(result);
  };
  const std::string path = certificate_of(options, "automaton");
  const AutomatonCertificate certificate = parse_automaton(path, read_file(path));
  totals.read.certificates = true;
  totals.classes = certificate.classes.size();
  totals.rows = certificate.rows;
  const ClassCheck classes = check_classes(certificate);
  totals.kinds = classes.kinds;
  for (const AutomatonClaim& claim : classes.claims) report(claim.claim, claim.method, claim.cases, claim.failures);
  // Steps and meetings are consistent only if all claims above hold; answers rely on that.
  if (totals.failed != 0) return totals;

  if (!options.dump_command.empty()) {
    AutomatonDumpCheck dump = check_automaton_dump_of(options.dump_command, certificate, options.tables_max_k);
    totals.read.of_headers.emplace_back("compiled automaton");
    if (!dump.fault.empty()) dump.wrong_numbers.add(dump.fault);
    report("every number of the header is the certificate's", "its dump", dump.numbers, dump.wrong_numbers);
    report("every answer of the header is the certificate's",
           fmt::format("k <= {}, digests of its dump", options.tables_max_k), dump.keys, dump.wrong_answers);
  }

  if (!options.digest_commands.empty()) {
    const Digests digests = automaton_digests(certificate, options.digest_max_k);
    for (const std::string& command : options.digest_commands) {
      totals.read.of_headers.emplace_back("digests of a look-up");
      DigestComparison found = compare_digests_of(command, digests);
      if (!found.fault.empty()) found.differences.add(found.fault);
      report("a look-up answers as the certificate does", fmt::format("k <= {}, digests", options.digest_max_k),
             found.positions, found.differences);
    }
  }

  for (const Family& family : tabled_families(options.tables_max_k)) {
    if (family.sections.front().operations.front().may_give_up != 0) continue;
    const std::string file = certificate_of(options, family.name);
    const FanCheck check = check_against_rows(certificate, family, parse_certificate(file, read_file(file), family));
    report(fmt::format("every answer costs the same as the rule of {}", family.name),
           fmt::format("k <= {}, {}, {} answers equal the rule", options.tables_max_k,
                       counted(check.places, "position"), check.same),
           check.keys, check.failures);
  }
  for (unsigned k = 1; k <= options.max_k; ++k) {
    const unsigned every = k > largest_fan ? options.every : 1;
    const FanCheck check = check_against_search(certificate, k, every);
    report(fmt::format("every answer with k = {} is sound and best", k),
           fmt::format("all recolourings, {}{}", every == 1 ? "all " : "", counted(check.places, "place")), check.keys,
           check.failures);
  }
  return totals;
}

int run(const AutomatonOptions& options) {
  const files::ReportOutput out(options.json);
  std::vector<ClaimResult> claims;
  const AutomatonTotals totals = verify_automaton(options, listed_in(claims, !out.replaces_text()));
  out.print(fmt::format("{}: {}, {}, {} of arcs, {} of which {} failed; read: {}\n",
                        totals.failed == 0 ? "verified" : "NOT verified", counted(totals.classes, "class", "classes"),
                        counted(totals.rows, "row"), counted(totals.kinds, "kind"), counted(totals.claims, "claim"),
                        totals.failed, text_of(totals.read)),
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

std::function<int()> add_automaton(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("automaton", "The certificate of an automaton: rules of fans of any valence");
  command->footer(
      "Exit code: 0 every claim holds, 1 some claim fails, 2 bad input.\n\n"
      "Example, from the top of the source tree, with the folder of the programs in PATH:\n"
      "  restrip-verify automaton --tables-dir tables\n"
      "The compiled automaton as well:\n"
      "  restrip-verify automaton --tables-dir tables \\\n"
      "    --dump-command \"restrip-dump-tables --automaton\"\n"
      "The look-up in C, from the folder that `restrip-generate automaton --language c` wrote:\n"
      "  cc restrip_automaton_check.c -o check_automaton\n"
      "  restrip-verify automaton --tables-dir SOURCE/tables --digest-command ./check_automaton");
  const auto given = std::make_shared<AutomatonOptions>();
  command->add_option("--tables-dir", given->tables_dir, "The folder with certificates/")->capture_default_str();
  command->add_option("--dump-command", given->dump_command,
                      "A program that prints the compiled automaton; its numbers and answers are compared");
  CLI::Option* const digest_command = command->add_option(
      "--digest-command", given->digest_commands,
      "A program that prints digests of the answers of a look-up in another language "
      "(docs/how-to/other-languages.md); may be repeated. They are compared with digests of the certificate's answers");
  command->add_option("--digest-max-k", given->digest_max_k, "The largest fans of the digests")
      ->capture_default_str()
      ->needs(digest_command)
      ->check(CLI::Range(3U, largest_digest_fan));
  command
      ->add_option("--tables-max-k", given->tables_max_k,
                   "The largest fans of the other certificates in the folder, and of the dump")
      ->capture_default_str()
      ->check(CLI::Range(3U, largest_judged_fan));
  command->add_option("--max-k", given->max_k, "The largest fans that are searched as a whole")
      ->capture_default_str()
      ->check(CLI::Range(0, 12));
  command->add_option("--every", given->every, "Of the places with k > 8, search only every N-th")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  add_json_option(*command, given->json);
  return [given] { return run(*given); };
}

}  // namespace restrip::verify
