// Certificates of automata as lines, altered in some rows, their sums brought up to date.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "input.hpp"
#include "sums.hpp"

namespace restrip::verify::test {

inline std::vector<std::string> lines_of(const std::string& file) {
  const std::string text = read_file(file);
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

inline std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words(1);
  for (const char c : line)
    if (c == ' ')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

inline std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

/// With the right last line. Whatever is not part of the frame is a row.
inline std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  std::size_t rows = 0;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    text += lines[i] + "\n";
    const std::string word = words_of(lines[i])[0];
    rows += word != "restrip-certificate" && word != "family" && word != "section" && word != "claim";
  }
  const ByteSums sums = sums_of(text);
  return text + fmt::format("end {} {} {}\n", rows, sums.plain, sums.weighted);
}

/// A change of one row; nothing where it does not apply to this row.
using Change = std::function<std::optional<std::string>(std::vector<std::string> words)>;

/// The word at this place, plus one.
inline Change one_more(std::size_t word) {
  return [word](std::vector<std::string> words) {
    words[word] = std::to_string(std::stoi(words[word]) + 1);
    return joined(words);
  };
}

using CaseOfClass = std::pair<std::string, std::string>;

/// The index automaton without some cases of classes, and without all that come from them: every value, step and origin
/// that is left is true, only something better can be made.
inline std::vector<std::string> without_cases(const std::vector<std::string>& shipped,
                                              std::vector<CaseOfClass> waiting) {
  std::map<CaseOfClass, std::vector<CaseOfClass>> longer;  // the cases that come from a case
  std::string to;                                          // of the step whose origins follow
  for (const std::string& line : shipped) {
    const std::vector<std::string> words = words_of(line);
    if (words[0] == "step") to = words[3];
    if (words[0] == "from") longer[{words[1], words[4]}].emplace_back(to, words[3]);
  }
  std::set<CaseOfClass> dropped;
  while (!waiting.empty()) {
    const CaseOfClass next = waiting.back();
    waiting.pop_back();
    if (next.second != "--" && dropped.insert(next).second)
      waiting.insert(waiting.end(), longer[next].begin(), longer[next].end());
  }
  std::vector<std::string> lines;
  std::size_t rows = 0;
  for (const std::string& line : shipped) {
    const std::vector<std::string> words = words_of(line);
    if (words[0] == "step") to = words[3];
    if (words[0] == "value" && dropped.contains({words[1], words[2]})) continue;
    if (words[0] == "from" && dropped.contains({to, words[3]})) continue;
    if (words[0] == "class" || words[0] == "value" || words[0] == "step" || words[0] == "from") ++rows;
    lines.push_back(line);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i] == "section classes") lines[i + 1] = "claim rows " + std::to_string(rows);
  return lines;
}

/// Where no best colouring has an edge over the left link.
inline std::vector<std::string> without_left_links(const std::vector<std::string>& shipped) {
  std::vector<CaseOfClass> cases;
  for (const std::string& line : shipped)
    if (const auto words = words_of(line); words[0] == "value" && words[1] != "0" && words[2][0] != '-')
      cases.emplace_back(words[1], words[2]);
  return without_cases(shipped, std::move(cases));
}

}  // namespace restrip::verify::test
