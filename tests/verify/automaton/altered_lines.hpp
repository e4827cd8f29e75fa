// An automaton's certificate as lines, altered in some rows, their sums brought up to date.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certificate/sums.hpp"
#include "model/input.hpp"

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
using RowChange = std::function<std::optional<std::string>(std::vector<std::string> words)>;

/// The word at this place, plus one.
inline RowChange one_more(std::size_t word) {
  return [word](std::vector<std::string> words) {
    words[word] = std::to_string(std::stoi(words[word]) + 1);
    return joined(words);
  };
}

}  // namespace restrip::verify::test
