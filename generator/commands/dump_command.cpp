// `restrip-generate dump`: the frozen CSV of docs/reference/verifiers.md, "Rules as CSV", and the same for later
// families and custom operations.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "commands/command.hpp"
#include "commands/pipeline.hpp"
#include "common/output.hpp"
#include "describe/description.hpp"
#include "solve/section.hpp"

namespace restrip::generator {
namespace {

struct DumpCommand {
  std::string family = "split";
  std::optional<unsigned> k;
  std::string file;  ///< an operation file, or empty
  std::optional<unsigned> max_k;
  std::string json;
};

/// The columns, with these names for the colours.
std::string columns(const Description& description, const std::string& before, const std::string& after) {
  std::string text;
  for (const std::string& number : description.numbers) text += number + ",";
  return text + before + ",ports," + after + (description.may_give_up != 0 ? ",ports_after" : "") + ",strips,isolated";
}

std::vector<std::string> columns_in(const std::string& header) {
  std::vector<std::string> names(1);
  for (const char c : header)
    if (c == ',')
      names.emplace_back();
    else
      names.back() += c;
  return names;
}

/// The columns of a shipped family: "loop" for the fan alone, "inner" if there are other triangles.
std::string columns(const Description& family) {
  const auto colors_of = [](const SideForm& form) -> std::string {
    const auto* fan = std::get_if<Fan>(&form);
    return fan != nullptr && fan->elements.size() == 1 ? "loop" : "inner";
  };
  const std::string before = colors_of(family.before);
  const std::string after = colors_of(family.after);
  return columns(family, before, before == after ? after + "_after" : after);
}

/// One row for each valid configuration, ordered by position, then colours before, then ports; all decimal. As JSON the
/// names of the columns, and the rows as lists.
void dump(const std::string& header, const std::vector<AnsweredPosition>& positions, const files::ReportOutput& out) {
  std::string text = header + '\n';
  std::string json = fmt::format("{{\n\"columns\": {},\n\"rows\": [", nlohmann::json(columns_in(header)).dump());
  const char* between = "\n";
  for (const auto& [position, section] : positions) {
    const Operation operation = operation_at(position, position.patch);
    const PositionNumbers numbers = position.numbers();
    const auto count = static_cast<std::ptrdiff_t>(position.family->numbers.size());
    const bool with_kept = position.family->may_give_up != 0;
    for_each_valid(operation, [&, rows = section](const Configuration& c) {
      const Row& row = row_of(*rows, c.ports, c.outcome.joined);
      const Change change = change_of(operation.patch, c, row);
      std::vector<std::int64_t> cells(numbers.begin(), numbers.begin() + count);
      cells.insert(cells.end(), {c.before, c.ports, row.recoloring});
      if (with_kept) cells.push_back(row.kept);
      cells.insert(cells.end(), {change.strips, change.isolated});
      text += fmt::format("{}\n", fmt::join(cells, ","));
      json += fmt::format("{}[{}]", std::exchange(between, ",\n"), fmt::join(cells, ", "));
    });
  }
  out.print(text, json + "\n]\n}\n");
}

/// The positions that a shipped family lists for one valence, by the rules of its certificate.
void dump_family(const Description& family, std::optional<unsigned> k, const files::ReportOutput& out) {
  if (family.numbers.empty() && k)
    throw std::invalid_argument(fmt::format("--family {}: it has one position, without --k", family.name));
  if (!family.numbers.empty() && k.value_or(0) < smallest_valence(family))
    throw std::invalid_argument(fmt::format("--family {} needs --k {} or more", family.name, smallest_valence(family)));
  const auto asked = [&](const Position& position) { return position.family == &family && (!k || position.k == *k); };
  // All families have positions up to 3.
  std::vector<Patches> patches = patches_of(families(), std::max(k.value_or(0), 3U));
  std::erase_if(patches, [&](const Patches& one) { return std::none_of(one.serves.begin(), one.serves.end(), asked); });
  const std::vector<Section> sections = solve_all(patches, 1);
  std::vector<AnsweredPosition> positions;
  for (const Section& section : sections)
    for (const PositionWithPatch& position : section.serves)
      if (asked(position)) positions.push_back({position, &section});
  std::sort(positions.begin(), positions.end(), [](const AnsweredPosition& x, const AnsweredPosition& y) {
    return static_cast<const Position&>(x.position) < y.position;
  });
  dump(columns(family), positions, out);
}

void dump_file(const std::string& file, std::optional<unsigned> max_k, const files::ReportOutput& out) {
  const Order order = order_of({file}, max_k);
  if (order.descriptions.size() != 1)
    throw std::runtime_error(
        fmt::format("{}: describes {} operations; dump a file of one at a time", file, order.descriptions.size()));
  const Description& description = order.descriptions[0];
  const std::vector<Section> sections = solve_all(patches_of(order.descriptions, order.max_k), 1);
  dump(columns(description, "inner", "inner_after"), answers_of(description, sections, order.max_k).positions, out);
}

}  // namespace

Subcommand add_dump(CLI::App& app) {
  const auto kept = std::make_shared<DumpCommand>();
  CLI::App* sub = app.add_subcommand("dump", "Print every rule as CSV, one row for each valid configuration");
  std::string all;
  std::vector<std::string> names;
  for (const Description& family : families()) {
    all += fmt::format("  {:<19}{}\n", family.name, columns(family));
    names.push_back(family.name);
  }
  sub->footer("Columns:\n" + all +
              "  others             their numbers, then inner,ports,inner_after,strips,isolated; ports_after "
              "before strips\n                     if ports may be given up\n"
              "\nExamples, from the top of the source tree:\n  restrip-generate dump --family split --k 4\n"
              "  restrip-generate dump --operation tables/operations/bisect.json\n");
  sub->add_option("--family", kept->family, fmt::format("One of {}", fmt::join(names, ", ")))
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  sub->add_option("--k", kept->k, "Valence: 3 … 13 (open families: 1 … 13)")->check(CLI::Range(1, 13));
  auto* file = sub->add_option("--operation", kept->file, "Instead, a custom operation or family: its file")
                   ->excludes("--family")
                   ->excludes("--k");
  sub->add_option("--max-k", kept->max_k, "Of its family: the largest first number; default 8")
      ->check(CLI::Range(3, 10))
      ->needs(file);
  add_json_option(*sub, kept->json);
  return {sub, [kept] {
            const files::ReportOutput out(kept->json, {kept->file});
            if (kept->file.empty())
              dump_family(family_named(kept->family), kept->k, out);
            else
              dump_file(kept->file, kept->max_k, out);
          }};
}

}  // namespace restrip::generator
