#pragma once
// A certificate of an automaton taken apart, put together again with what a test has altered, and checked.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "automaton/automaton_certificate.hpp"
#include "automaton/class_check.hpp"
#include "certificate/sums.hpp"
#include "model/input.hpp"

namespace restrip::verify::test {

/// What stands between these characters: lines, the empty one behind the last line break included, or words.
inline std::vector<std::string> parts_of(const std::string& text, char between) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == between)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// The words of a line, and a line of words.
inline std::vector<std::string> words_of(const std::string& line) { return parts_of(line, ' '); }
inline std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

/// The text with the right last line. Whatever is not part of the frame is a row.
inline std::string sealed_again(const std::vector<std::string>& lines) {
  std::string text;
  std::size_t rows = 0;
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    text += lines[i] + "\n";
    const std::string word = words_of(lines[i])[0];
    rows += word != "restrip-certificate" && word != "family" && word != "section" && word != "claim";
  }
  const ByteSums sums = sums_of(text);
  return text + fmt::format("end {} {} {}\n", rows, sums.plain, sums.weighted);
}

/// What the checker says first; empty when all claims hold.
inline std::string verdict_of(const std::string& text) {
  try {
    const AutomatonCertificate certificate = parse_automaton("altered.cert", text);
    const ClassCheck check(certificate);
    for (const AutomatonClaim& claim : check.claims())
      if (claim.failures.count != 0) return claim.failures.first;
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace restrip::verify::test
