#include "judge/answer_digests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "certificate/stream_lines.hpp"
#include "judge/table_dump.hpp"

namespace restrip::verify {
namespace {

/// Operations are identified by their index here.
constexpr std::array<std::string_view, 7> names = {"split",          "collapse",          "open-split", "open-collapse",
                                                   "boundary-split", "boundary-collapse", "flip"};
constexpr std::string_view end_of_digests = "rules outside the tables: 0";

/// The operation's number, and its position as three numbers; unused ones are 0.
std::string words_of(const Operation& operation) {
  const auto name = std::find(names.begin(), names.end(), operation.family);
  if (name == names.end()) throw std::logic_error(operation.family + " has no digests");
  Numbers numbers = operation.numbers;
  numbers.resize(3);
  return fmt::format("{} {} {} {}", name - names.begin(), numbers[0], numbers[1], numbers[2]);
}

/// `expected` has the lines that are still missing.
void read_lines(StreamLines& lines, Digests expected, DigestComparison& result) {
  while (!expected.empty()) {
    const std::string& missing = expected.begin()->first;
    const std::string_view line = lines.next(missing);
    const std::size_t space = std::min(line.rfind(' '), line.size());
    const auto position = expected.find(std::string(line.substr(0, space)));
    if (position == expected.end())
      lines.fail(fmt::format("\"{}\" is not a position that is missing, such as \"{}\"", line, missing));
    ++result.positions;
    if (const std::string right = fmt::format("{} {:08x}", position->first, position->second); line != right)
      result.differences.add(
          fmt::format("line {}: \"{}\", the judged answers give \"{}\"\n", lines.number(), line, right));
    expected.erase(position);
  }
  lines.expect_last(std::string(end_of_digests));
}

}  // namespace

void AnswerDigests::add(const Operation& operation, Colors configuration, const std::optional<Answer>& answer) {
  if (last_ != &operation) digest_ = &digests_[words_of(operation)];
  last_ = &operation;
  // The flip's answer has its kept ports below its inner edge; the others keep all ports.
  std::optional<AnswerBits> bits;
  if (answer)
    bits = AnswerBits{operation.may_give_up != 0
                          ? concatenated(answer->colors.inner, answer->colors.ports, operation.ports())
                          : answer->colors.inner,
                      answer->strips.value()};
  *digest_ += mixed(configuration.inner, configuration.ports, bits);
}

DigestComparison compare_digests(std::FILE* stream, const Digests& expected) {
  return found_in<DigestComparison>(
      stream, [&](StreamLines& lines, DigestComparison& result) { read_lines(lines, expected, result); });
}

DigestComparison compare_digests_of(const std::string& program, const Digests& expected) {
  return checked_output_of(program, [&](std::FILE* stream) { return compare_digests(stream, expected); });
}

}  // namespace restrip::verify
