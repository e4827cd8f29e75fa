// Texts that are altered in one place, and what a reader says of each: the files of tests/corpus/altered.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace restrip::corpus {

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The bytes of a file of tests/corpus/altered.
inline std::string altered(const std::string& name) {
  return bytes_of(std::filesystem::path(RESTRIP_CORPUS_DIR) / "altered" / name);
}

/// A text that is altered in one place, and the expected message: a case of a file of tests/corpus/altered. Consecutive
/// lines of one kind form one text, and "#" begins a comment:
///
///   of NAME       the text that the following cases alter
///   - TEXT        what goes, at the beginning of a line if it stands at one; without `+` the end of the line goes as
///   well
///   + TEXT        what comes in its place
///   = TEXT        part of the message; empty if the text is correct
struct Alteration {
  std::string of;
  std::string what;
  std::optional<std::string> by;
  std::string says;

  /// The altered text; throws std::runtime_error if the alteration is impossible.
  [[nodiscard]] std::string in(std::string text) const {
    std::size_t place = ('\n' + text).find('\n' + what);
    if (place == std::string::npos) place = text.find(what);
    if (place == std::string::npos) throw std::runtime_error(fmt::format("{}: no \"{}\"", of, what));
    return text.replace(place, what.size() + (by ? 0 : 1), by.value_or(""));
  }
};

/// What an `of` names: the text below "=== NAME" in texts.txt.
inline std::string text_to_alter(const std::string& name) {
  const std::string all = altered("texts.txt");
  const std::string head = fmt::format("=== {}\n", name);
  const std::size_t at = ('\n' + all).find('\n' + head);
  if (at == std::string::npos) throw std::runtime_error("no text " + name);
  const std::size_t begin = at + head.size();
  const std::size_t end = all.find("\n=== ", begin);
  return all.substr(begin, end == std::string::npos ? end : end + 1 - begin);
}

inline std::vector<Alteration> alterations(const std::string& file) {
  std::vector<Alteration> all;
  Alteration next;
  char last = 0;
  for (const std::string& line : lines_of(altered(file))) {
    if (line.empty() || line.starts_with("#")) continue;
    const std::string text = line.substr(std::min<std::size_t>(line.size(), 2));
    const bool continues = line[0] == last;
    const auto longer = [&](const std::string& so_far) {
      return continues ? fmt::format("{}\n{}", so_far, text) : text;
    };
    if (line[0] == 'o')
      next.of = line.substr(line.find(' ') + 1);
    else if (line[0] == '-')
      next.what = longer(next.what);
    else if (line[0] == '+')
      next.by = longer(next.by.value_or(""));
    else if (line[0] != '=')
      throw std::runtime_error(fmt::format("{}: unknown line \"{}\"", file, line));
    else if (continues)
      all.back().says = longer(all.back().says);
    else
      all.push_back({next.of, next.what, std::exchange(next.by, {}), text});
    last = line[0];
  }
  if (all.empty()) throw std::runtime_error(file + ": no case");
  return all;
}

}  // namespace restrip::corpus
