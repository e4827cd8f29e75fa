// The results: claims, how they were checked, and whether they hold.
#pragma once

#include <cstdint>
#include <ctime>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace restrip::verify {

/// The number of failures, and the first one in full.
struct Failures {
  std::uint64_t count = 0;
  std::string first;
  void add(const std::string& counterexample) {
    if (count++ == 0) first = counterexample;
  }
  void add(const Failures& later) {
    if (count == 0) first = later.first;
    count += later.count;
  }
};

/// Processor seconds of the calling thread. WebAssembly has one thread, and newer versions of its C library know no
/// clock but real time.
inline double thread_seconds() {
  timespec now{};
#ifdef CLOCK_THREAD_CPUTIME_ID
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
#else
  clock_gettime(CLOCK_MONOTONIC, &now);
#endif
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

struct ClaimResult {
  std::string subject;  ///< a family, or another subject
  std::string claim;
  std::string method;
  std::uint64_t cases = 0;
  double seconds = 0;  ///< processor time
  Failures failures;

  bool held() const { return failures.count == 0; }
};

/// The inputs of a result.
struct Sources {
  bool certificates = false;
  std::vector<std::string> of_headers;  ///< "compiled tables"
};
/// "certificates and compiled tables", or "certificates only; no header was read".
std::string text_of(const Sources& sources);

/// The number of answers of tables, and of their positions.
struct AnswerCount {
  std::uint64_t positions = 0;
  std::uint64_t entries = 0;

  AnswerCount& operator+=(const AnswerCount& more) {
    positions += more.positions;
    entries += more.entries;
    return *this;
  }
};
/// By the first word in the headers of the tables: "open-collapse".
using AnswerCounts = std::map<std::string, AnswerCount>;
AnswerCount sum_of(const AnswerCounts& counts);

struct Totals {
  unsigned max_k = 0;                ///< of the largest fans
  std::uint64_t rules = 0;           ///< rows, including copies
  std::uint64_t configurations = 0;  ///< valid ones, over all families and positions
  std::uint64_t graphs = 0;          ///< graphs compared with the definition
  std::uint64_t claims = 0;
  std::uint64_t failed = 0;
  Sources read;
  /// Answers of the shipped headers by operation: answers proved right, and answers read but not checked because their
  /// family was not chosen.
  AnswerCounts answers;
  AnswerCounts not_compared;
};

/// Called for each claim as soon as it is decided, in a fixed order.
using ClaimListener = std::function<void(const ClaimResult&)>;

std::string line_of(const ClaimResult& result);
/// A listener that adds each claim to `claims` and, if `prints`, prints its line at once; the heading is printed now.
ClaimListener listed_in(std::vector<ClaimResult>& claims, bool prints);
/// One line each for the answers of the shipped headers that were proved and that were not compared, if any; then
/// "verified: …" or "NOT verified: …", ending with the inputs.
std::string last_line(const Totals& totals);
nlohmann::ordered_json json_of(const std::vector<ClaimResult>& claims);
std::string json_of(const std::vector<ClaimResult>& claims, const Totals& totals);
/// Counterexamples may contain output of a program: bytes that are not UTF-8 are replaced.
std::string text_of(const nlohmann::ordered_json& report);

}  // namespace restrip::verify
