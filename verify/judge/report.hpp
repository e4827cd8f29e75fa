#pragma once
// What was claimed, how it was checked, whether it held.

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace restrip::verify {

/// How often something did not hold, and the first time in full.
struct Failures {
  std::uint64_t count = 0;
  std::string first;
  void add(const std::string& counterexample, std::uint64_t times = 1) {
    if (count == 0) first = counterexample;
    count += times;
  }
  void add(const Failures& later) {
    if (count == 0) first = later.first;
    count += later.count;
  }
};

struct ClaimResult {
  std::string subject;  ///< a family, or what else the claim is about
  std::string claim;
  std::string method;
  std::uint64_t cases = 0;
  double seconds = 0;  ///< of processor time
  std::uint64_t failures = 0;
  std::string counterexample;  ///< the first

  bool held() const { return failures == 0; }
};

/// What a program has read to come to its result.
struct Sources {
  bool certificates = false;
  std::vector<std::string> of_headers;  ///< "compiled tables"
};
/// "certificates and compiled tables", or "certificates only; no header was read".
std::string text_of(const Sources& sources);

/// Answers of tables, and in how many positions they are.
struct AnswerCount {
  std::uint64_t positions = 0;
  std::uint64_t entries = 0;

  AnswerCount& operator+=(const AnswerCount& more) {
    positions += more.positions;
    entries += more.entries;
    return *this;
  }
};
/// By the word that the headers of the tables begin with: "open-collapse".
using AnswerCounts = std::map<std::string, AnswerCount>;
AnswerCount sum_of(const AnswerCounts& counts);

struct Totals {
  unsigned max_k = 0;                ///< of the largest fans
  std::uint64_t rules = 0;           ///< rows, copies included
  std::uint64_t alternatives = 0;    ///< rows of linked families
  std::uint64_t configurations = 0;  ///< valid ones, all families and positions
  std::uint64_t graphs = 0;          ///< that were held against the definition
  std::uint64_t claims = 0;
  std::uint64_t failed = 0;
  Sources read;
  bool graph_only = false;      ///< an operation that is not checked to be one on a mesh
  bool lists_not_read = false;  ///< a family has linked rules, and their certificate was not given
  /// Answers of the shipped headers by operation: those that were all found right, and those that were read but not
  /// looked at, because their family was not chosen.
  AnswerCounts answers;
  AnswerCounts not_compared;
};

/// Called for each claim as soon as it is settled, in a fixed order.
using ClaimListener = std::function<void(const ClaimResult&)>;

std::string heading();
std::string line_of(const ClaimResult& result);
/// The answers of the shipped headers, a line each for what was proved and what was not compared, if there is any; then
/// "verified: …" or "NOT verified: …", and at its end what was read.
std::string last_line(const Totals& totals);
nlohmann::ordered_json json_of(const std::vector<ClaimResult>& claims);
std::string json_of(const std::vector<ClaimResult>& claims, const Totals& totals);
/// What a program printed may be in a counterexample: bytes that are not UTF-8 are shown as replaced.
std::string text_of(const nlohmann::ordered_json& report);

}  // namespace restrip::verify
