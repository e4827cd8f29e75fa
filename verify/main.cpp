// restrip-verify: proves certificates exhaustively. It uses only docs/reference/notation.md and
// docs/reference/certificate.md for families, and only docs/reference/operation-file.md and the operation file for
// custom operations.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "automaton/command.hpp"
#include "common/output.hpp"
#include "explain/commands.hpp"
#include "model/input.hpp"
#include "model/program.hpp"
#include "verify.hpp"

namespace {

using namespace restrip::verify;

/// `verify` takes a listener and returns totals; `last` formats the last line.
template <class Verify, class Last>
int run(const Verify& verify, const Last& last, const Options& options, const std::string& json) {
  const restrip::files::ReportOutput out(json, {options.operation, options.certificate, options.header});
  std::vector<ClaimResult> claims;
  const Totals totals = verify(listed_in(claims, !out.replaces_text()));
  out.print(last(totals), json_of(claims, totals));
  return totals.failed == 0 ? all_claims_hold : some_claim_fails;
}

/// Throws std::invalid_argument for options that conflict: otherwise a request would be silently ignored.
void refuse_if(bool condition, const std::string& what) {
  if (condition) throw std::invalid_argument(what);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  std::string json;

  CLI::App app("Proves the rewriting rules: reads the certificates and checks every claim for every configuration.");
  app.name("restrip-verify");
  app.set_version_flag("--version", RESTRIP_VERSION);
  app.require_subcommand(0, 1);
  app.footer(
      "Exit code: 0 every claim holds, 1 some claim fails, 2 bad input.\n\n"
      "Example, from the top of the source tree, with the folder of the programs in PATH:\n"
      "  restrip-verify --tables-dir tables\n\n"
      "A custom operation (docs/reference/operation-file.md):\n"
      "  restrip-verify --operation tables/operations/bisect.json \\\n"
      "    --certificate tables/certificates/operations/bisect.cert");
  CLI::Option* const operation =
      app.add_option("--operation", options.operation,
                     "The file of a custom operation or family. It can be combined only with "
                     "--certificate, --header, --dump-command, --max-k, --threads and --json");
  app.add_option("--certificate", options.certificate, "The certificate of the operation")->needs(operation);
  app.add_option("--header", options.header,
                 "The header of the operation's table, which is checked before a program compiled from it is run")
      ->needs(operation);
  app.add_option("--tables-dir", options.tables_dir, "The folder with MANIFEST and certificates/")
      ->capture_default_str();
  CLI::Option* const dump_command =
      app.add_option("--dump-command", options.dump_command,
                     "A program that prints the compiled tables; they are compared with the certificates");
  app.add_option("--digest-command", options.digest_commands,
                 "A program that prints digests of the answers of a look-up in another language "
                 "(docs/how-to/other-languages.md); "
                 "may be repeated. They are compared with digests of the output of --dump-command")
      ->needs(dump_command);
  app.add_flag("--headers", options.headers_only,
               "Read no certificates: judge what the dump command prints in every position by itself")
      ->needs(dump_command);
  app.add_option(
         "--max-k", options.max_k,
         "The largest fans of the certificates, or with --headers of the dumps. Beyond k = 8 rules are proved by "
         "their reasons, and not searched again")
      ->capture_default_str()
      ->check(CLI::Range(3U, largest_judged_fan));
  add_json_option(app, json);
  app.add_option("--family", options.families, "Only this certificate, such as split; may be repeated");
  app.add_option("--threads", options.threads, "The number of threads; the result does not depend on it")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  for (CLI::Option* option : app.get_options())
    if (const std::string name = option->get_name();
        name == "--tables-dir" || name == "--digest-command" || name == "--headers" || name == "--family")
      operation->excludes(option);
  const auto automaton = add_automaton(app);
  const auto explain = add_explain(app);
  const auto rules = add_rules(app);
  const auto given = [&](const char* name) { return !app.get_option(name)->empty(); };
  return exit_code_of(app, argc, argv, [&] {
    for (const CLI::Option* option : app.get_options())
      refuse_if(!app.get_subcommands().empty() && !option->empty(),
                fmt::format("{} cannot be used with a subcommand", option->get_name()));
    if (app.got_subcommand("automaton")) return automaton();
    if (app.got_subcommand("explain")) return explain();
    if (app.got_subcommand("rules")) return rules();
    refuse_if(!options.operation.empty() && options.certificate.empty() && options.header.empty() &&
                  options.dump_command.empty(),
              "--operation needs --certificate, --header or, of a family, --dump-command");
    refuse_if(options.max_k > largest_fan && (options.headers_only || !options.digest_commands.empty()),
              fmt::format("--max-k {}: --headers and --digest-command judge fans of up to {} triangles", options.max_k,
                          largest_fan));
    for (const char* name : {"--tables-dir", "--threads"})
      refuse_if(options.headers_only && given(name),
                fmt::format("--headers reads no certificates, so {} has no effect; leave it out", name));
    refuse_if(!options.families.empty() && given("--digest-command"),
              "--digest-command judges all rules, so --family has no effect on it; run them one after the other");
    if (options.operation.empty())
      return run([&](const auto& listener) { return verify_tables(options, listener); }, last_line, options, json);
    options.operation_text = read_file(options.operation);  // once: it may be a pipe
    const bool of_a_family = has_family(options);
    refuse_if(!of_a_family && given("--max-k"),
              fmt::format("{} describes no family, so --max-k has no effect; leave it out", options.operation));
    refuse_if(!of_a_family && !options.dump_command.empty() && options.header.empty(),
              "--dump-command with --operation needs --header: the program was compiled from that file, which is read "
              "before the program is run");
    return run([&](const auto& listener) { return verify_operation(options, listener); },
               [&](const auto& totals) { return last_line_of(options, totals); }, options, json);
  });
}
