#include "judge/report.hpp"

#include <fmt/format.h>

#include "model/quantity.hpp"

namespace restrip::verify {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < ' ')
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + '"';
}

/// "answers of the shipped headers proved: 32 in 1 position (flip 1)"; empty when there are none.
std::string answers_line(const char* what, const std::map<std::string, Totals::Answers>& answers) {
  if (answers.empty()) return {};
  Totals::Answers sum;
  std::string list;
  for (const auto& [family, count] : answers) {
    sum.positions += count.positions;
    sum.entries += count.entries;
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", family, count.positions);
  }
  return fmt::format("answers of the shipped headers {}: {} in {} ({})\n", what, grouped(sum.entries),
                     quantity(sum.positions, "position"), list);
}

std::string json_of_answers(const std::map<std::string, Totals::Answers>& answers) {
  std::string text = "{";
  for (const auto& [family, count] : answers)
    text += fmt::format("{}{}: {{\"positions\": {}, \"answers\": {}}}", text.size() == 1 ? "" : ", ", quoted(family),
                        count.positions, count.entries);
  return text + '}';
}

}  // namespace

std::string text_of(const Sources& sources) {
  std::vector<std::string> all = sources.of_headers;
  if (sources.certificates) all.insert(all.begin(), "certificates");
  if (all.empty()) return "nothing";
  std::string text = all.front();
  for (std::size_t i = 1; i < all.size(); ++i) text += (i + 1 < all.size() ? ", " : " and ") + all[i];
  if (!sources.certificates) return text + " only; no certificate was read";
  return sources.of_headers.empty() ? text + " only; no header was read" : text;
}

std::string heading() {
  return fmt::format("{:<6} {:<15} {:<58} {:<48} {:>15} {:>8}\n", "", "family", "claim", "method", "cases", "seconds");
}

std::string line_of(const ClaimResult& result) {
  std::string text = fmt::format("{:<6} {:<15} {:<58} {:<48} {:>15} {:>8.2f}\n", result.held() ? "holds" : "FAILS",
                                 result.subject, result.claim, result.method, grouped(result.cases), result.seconds);
  if (!result.held())
    text +=
        fmt::format("{}, the first:\n{}\n", quantity_grouped(result.failures, "counterexample"), result.counterexample);
  return text;
}

std::string last_line(const Totals& totals) {
  return answers_line("proved", totals.answers) + answers_line("NOT compared", totals.not_compared) +
         fmt::format("{}: {}, {}, {}, {} tried, {}{}, k <= {}; read: {}\n",
                     totals.failed == 0 ? "verified" : "NOT verified", quantity_grouped(totals.rules, "rule"),
                     quantity_grouped(totals.alternatives, "alternative"),
                     quantity_grouped(totals.configurations, "configuration"),
                     quantity_grouped(totals.pairs, "recolouring"), quantity(totals.claims, "claim"),
                     totals.failed == 0 ? "" : fmt::format(" of which {} failed", totals.failed), totals.max_k,
                     text_of(totals.read));
}

std::string json_of(const std::vector<ClaimResult>& claims, const Totals& totals) {
  std::string text = "{\n  \"claims\": [";
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const ClaimResult& claim = claims[i];
    text += fmt::format(
        "{}\n    {{\"family\": {}, \"claim\": {}, \"method\": {}, \"cases\": {}, \"seconds\": {:.3f}, \"holds\": {}, "
        "\"failures\": {}, \"counterexample\": {}}}",
        i == 0 ? "" : ",", quoted(claim.subject), quoted(claim.claim), quoted(claim.method), claim.cases, claim.seconds,
        claim.held(), claim.failures, claim.held() ? "null" : quoted(claim.counterexample));
  }
  return text + fmt::format(
                    "\n  ],\n  \"rules\": {},\n  \"alternatives\": {},\n  \"configurations\": {},\n  \"recolorings\": "
                    "{},\n  \"answers_proved\": {},\n  \"answers_not_compared\": {},\n  \"graph_only\": {},\n"
                    "  \"read\": {},\n  \"failed\": {},\n  \"verified\": {}\n}}\n",
                    totals.rules, totals.alternatives, totals.configurations, totals.pairs,
                    json_of_answers(totals.answers), json_of_answers(totals.not_compared), totals.graph_only,
                    quoted(text_of(totals.read)), totals.failed, totals.failed == 0);
}

}  // namespace restrip::verify
