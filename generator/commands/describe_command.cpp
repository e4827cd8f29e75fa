// `restrip-generate describe`: the operation file of a shipped family at one position.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include "commands/command.hpp"
#include "describe/description_file.hpp"

namespace restrip::generator {
namespace {

constexpr std::array<const char*, 3> place_options{"--k", "--at", "--to"};

struct DescribeCommand {
  std::string family = "split";
  PositionNumbers numbers{};
  std::string constraint = "strips";
};

/// The position given by the options.
Position position_of(const Description& family, PositionNumbers numbers, const CLI::App& given) {
  std::vector<std::string> expected;
  for (std::size_t i = 0; i < place_options.size(); ++i)
    if (i < family.numbers.size())
      expected.push_back(fmt::format("{} by {}", family.numbers[i], place_options.at(i)));
    else if (given.count(place_options.at(i)) != 0)
      throw std::invalid_argument(fmt::format("--family {}: its positions do not depend on {}; leave it out",
                                              family.name, place_options.at(i)));
  if (family.numbers.empty()) return positions(family, 0).at(0);
  if (!hold(family.where, numbers))
    throw std::invalid_argument(
        fmt::format("--family {}: expected {}; {}", family.name, family.range, fmt::join(expected, ", ")));
  for (std::size_t i = family.numbers.size(); i < numbers.size(); ++i) numbers.at(i) = 0;
  return {&family, numbers[0], numbers[1], numbers[2]};
}

void run(const DescribeCommand& command, const CLI::App& given) {
  const auto word = std::find(constraint_words.begin(), constraint_words.end(), command.constraint);
  const Constraint constraint{static_cast<unsigned>(word - constraint_words.begin()) + 1};
  fmt::print("{}", operation_file_text(position_of(family_named(command.family), command.numbers, given), constraint));
}

}  // namespace

Subcommand add_describe(CLI::App& app) {
  const auto kept = std::make_shared<DescribeCommand>();
  CLI::App* sub = app.add_subcommand("describe", "Print the operation file of a family at one position, to start from");
  add_family_option(*sub, kept->family);
  constexpr std::array<const char*, 3> help{"Valence, 1 … 8; not for the flip",
                                            "Arc a of a closed fan, gap i of an open one", "Gap j of an open fan"};
  for (std::size_t i = 0; i < help.size(); ++i)
    sub->add_option(place_options.at(i), kept->numbers.at(i), help.at(i))->check(CLI::Range(i == 0 ? 1 : 0, 8));
  sub->add_option("--constraint", kept->constraint,
                  "strips, matching (triangles in pairs) or forest; except for strips, the file names no cost and so "
                  "has the default")
      ->check(CLI::IsMember(std::vector<std::string>(constraint_words.begin(), constraint_words.end())))
      ->capture_default_str();
  sub->footer(
      "\nExamples:\n"
      "  restrip-generate describe --family split --k 4 --at 2 > split.json\n"
      "  restrip-generate describe --family collapse --k 6 --at 3 --constraint matching > pairs.json\n");
  return {sub, [kept, sub] { run(*kept, *sub); }};
}

}  // namespace restrip::generator
