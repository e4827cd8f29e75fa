#include "judge/answer_digests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "certificate/stream_lines.hpp"
#include "judge/table_dump.hpp"

namespace restrip::verify {

std::string digest_words(const Operation& operation) {
  // Operations are identified by their index here.
  constexpr std::array<std::string_view, 7> names = {
      "split", "collapse", "open-split", "open-collapse", "boundary-split", "boundary-collapse", "flip"};
  const auto name = std::find(names.begin(), names.end(), operation.family);
  if (name == names.end()) throw std::logic_error(operation.family + " has no digests");
  Numbers numbers = operation.numbers;
  numbers.resize(3);
  return fmt::format("{} {} {} {}", name - names.begin(), numbers[0], numbers[1], numbers[2]);
}

std::uint32_t digest_of(const Operation& operation, Colors configuration, const std::optional<Answer>& answer) {
  if (!answer) return mixed_number(configuration.inner, configuration.ports, 0);
  // The flip's answer has its kept ports below its inner edge; the others keep all ports.
  const Mask colors = operation.may_give_up != 0
                          ? concatenated(answer->colors.inner, answer->colors.ports, operation.ports())
                          : answer->colors.inner;
  return mixed(configuration.inner, configuration.ports, colors, answer->strips.value());
}

DigestComparison compare_digests_of(const std::string& program, const Digests& expected) {
  const auto compare = [&](StreamLines& lines, DigestComparison& result) {
    Digests missing = expected;
    while (!missing.empty()) {
      const std::string& first = missing.begin()->first;
      const std::string_view line = lines.next(first);
      const std::size_t space = std::min(line.rfind(' '), line.size());
      const auto position = missing.find(std::string(line.substr(0, space)));
      if (position == missing.end())
        lines.fail(fmt::format("\"{}\" is not a position that is missing, such as \"{}\"", line, first));
      ++result.positions;
      if (const std::string right = fmt::format("{} {:08x}", position->first, position->second); line != right)
        result.differences.add(
            fmt::format("line {}: \"{}\", the judged answers give \"{}\"\n", lines.number(), line, right));
      missing.erase(position);
    }
    lines.expect_last("rules outside the tables: 0");
  };
  return checked_output_of(program, [&](std::FILE* stream) { return found_in<DigestComparison>(stream, compare); });
}

}  // namespace restrip::verify
