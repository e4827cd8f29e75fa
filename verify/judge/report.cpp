#include "judge/report.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "common/counted.hpp"

namespace restrip::verify {
namespace {

/// "answers of the shipped headers proved: 32 in 1 position (flip 1)"; empty without answers.
std::string answers_line(const char* what, const AnswerCounts& answers) {
  if (answers.empty()) return {};
  const AnswerCount sum = sum_of(answers);
  std::string list;
  for (const auto& [family, count] : answers)
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", family, count.positions);
  return fmt::format("answers of the shipped headers {}: {} in {} ({})\n", what, grouped(sum.entries),
                     counted(sum.positions, "position"), list);
}

nlohmann::ordered_json json_of(const AnswerCounts& answers) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [family, count] : answers)
    json[family] = {{"positions", count.positions}, {"answers", count.entries}};
  return json;
}

}  // namespace

AnswerCount sum_of(const AnswerCounts& counts) {
  AnswerCount sum;
  for (const auto& family : counts) sum += family.second;
  return sum;
}

std::string text_of(const Sources& sources) {
  std::vector<std::string> all = sources.of_headers;
  if (sources.certificates) all.insert(all.begin(), "certificates");
  if (all.empty()) return "nothing";
  std::string text = all.front();
  for (std::size_t i = 1; i < all.size(); ++i) text += (i + 1 < all.size() ? ", " : " and ") + all[i];
  if (!sources.certificates) return text + " only; no certificate was read";
  return sources.of_headers.empty() ? text + " only; no header was read" : text;
}

std::string line_of(const ClaimResult& result) {
  std::string text = fmt::format("{:<6} {:<15} {:<58} {:<48} {:>15} {:>8.2f}\n", result.held() ? "holds" : "FAILS",
                                 result.subject, result.claim, result.method, grouped(result.cases), result.seconds);
  if (!result.held())
    text += fmt::format("{}, the first:\n{}\n", counted_grouped(result.failures.count, "counterexample"),
                        result.failures.first);
  return text;
}

ClaimListener listed_in(std::vector<ClaimResult>& claims, bool prints) {
  if (prints)
    fmt::print("{:<6} {:<15} {:<58} {:<48} {:>15} {:>8}\n", "", "family", "claim", "method", "cases", "seconds");
  return [&claims, prints](const ClaimResult& result) {
    claims.push_back(result);
    if (prints) fmt::print("{}", line_of(result));
    std::fflush(stdout);
  };
}

std::string last_line(const Totals& totals) {
  return answers_line("proved", totals.answers) + answers_line("NOT compared", totals.not_compared) +
         fmt::format("{}: {}, {}, {} judged, {}{}, k <= {}; read: {}\n",
                     totals.failed == 0 ? "verified" : "NOT verified", counted_grouped(totals.rules, "rule"),
                     counted_grouped(totals.configurations, "configuration"), counted_grouped(totals.graphs, "graph"),
                     counted(totals.claims, "claim"),
                     totals.failed == 0 ? "" : fmt::format(" of which {} failed", totals.failed), totals.max_k,
                     text_of(totals.read));
}

nlohmann::ordered_json json_of(const std::vector<ClaimResult>& claims) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ClaimResult& claim : claims) {
    json.push_back({{"family", claim.subject},
                    {"claim", claim.claim},
                    {"method", claim.method},
                    {"cases", claim.cases},
                    {"seconds", claim.seconds},
                    {"holds", claim.held()},
                    {"failures", claim.failures.count},
                    {"counterexample", nullptr}});
    if (!claim.held()) json.back()["counterexample"] = claim.failures.first;
  }
  return json;
}

std::string json_of(const std::vector<ClaimResult>& claims, const Totals& totals) {
  return text_of({{"claims", json_of(claims)},
                  {"rules", totals.rules},
                  {"configurations", totals.configurations},
                  {"graphs", totals.graphs},
                  {"answers_proved", json_of(totals.answers)},
                  {"answers_not_compared", json_of(totals.not_compared)},
                  {"read", text_of(totals.read)},
                  {"failed", totals.failed},
                  {"verified", totals.failed == 0}});
}

std::string text_of(const nlohmann::ordered_json& report) {
  return report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace restrip::verify
