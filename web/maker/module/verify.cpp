// The verifier: `restrip-verify --operation`, and `restrip-verify explain` for operations with one
// position.
//   {files, operation, certificate, header}  ->  {claims: […], failed: 0, last: "verified: …"}
//   {files, operation, numbers, before, ports, after, ports_after}  ->  what `explain --json` prints; masks are
//   hexadecimal, and numbers the position of a family
#include "verify.hpp"

#include <charconv>
#include <optional>

#include "explain/explanation.hpp"
#include "model/input.hpp"
#include "module.hpp"

extern "C" __attribute__((import_module("maker"), import_name("claim"))) void maker_claim(const char* text,
                                                                                          std::uint32_t bytes);

namespace restrip::maker {
namespace {

/// The definition of the operation that was asked about last: the page asks about one many times.
struct Asked {
  Asked(const std::string& file_text, const verify::Numbers& position)
      : text(file_text),
        numbers(position),
        operation(verify::operation_at(verify::parse_descriptions("operation", file_text).at(0), position)),
        definition(operation) {}
  std::string text;
  verify::Numbers numbers;
  verify::Operation operation;
  verify::Definition definition;
};
std::optional<Asked> asked;

verify::Mask mask_of(const nlohmann::json& request, const char* member) {
  const std::string digits = request.at(member).get<std::string>();
  verify::Mask mask = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), mask, 16);
  return mask;
}

nlohmann::ordered_json explained(const nlohmann::json& request) {
  const std::string text = verify::read_file(request.at("operation").get<std::string>());
  const auto numbers = request.at("numbers").get<verify::Numbers>();
  if (!asked || asked->text != text || asked->numbers != numbers) {
    asked.reset();
    asked.emplace(text, numbers);
  }
  const verify::Colors configuration{mask_of(request, "before"), mask_of(request, "ports")};
  const verify::Operation& operation = asked->operation;
  if (!asked->definition.valid(configuration))
    return {{"invalid",
             verify::invalid_because(operation.before, configuration, verify::most_solid(operation.constraint))}};
  std::optional<verify::Judgement> judged;
  if (request.contains("after"))
    judged = verify::judgement_of(asked->definition, configuration,
                                  {mask_of(request, "after"), mask_of(request, "ports_after")});
  return json_of(asked->definition, verify::explanation_of(asked->definition, configuration), judged);
}

}  // namespace

nlohmann::ordered_json judged(const nlohmann::json& request) {
  if (request.contains("before")) return explained(request);
  verify::Options options;
  options.threads = 1;
  options.operation = request.at("operation").get<std::string>();
  options.operation_text = verify::read_file(options.operation);
  options.certificate = request.value("certificate", "");
  options.header = request.value("header", "");
  if (request.contains("max_k")) options.max_k = request.at("max_k").get<unsigned>();
  std::vector<verify::ClaimResult> claims;
  const verify::Totals totals = verify_operation(options, [&](const verify::ClaimResult& claim) {
    claims.push_back(claim);
    const std::string one = verify::json_of({claim}).dump();
    maker_claim(one.data(), static_cast<std::uint32_t>(one.size()));
  });
  return {
      {"claims", verify::json_of(claims)}, {"failed", totals.failed}, {"last", verify::last_line_of(options, totals)}};
}

}  // namespace restrip::maker
