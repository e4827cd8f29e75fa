#include "operations/write.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "common/counted.hpp"
#include "common/output.hpp"
#include "common/report_output.hpp"
#include "languages/languages.hpp"
#include "operations/description_file.hpp"
#include "operations/operation_layout.hpp"
#include "tables/certificate_text.hpp"
#include "tables/changed.hpp"

namespace restrip::generator {
namespace {

std::string operation_certificate_path(const std::string& name) { return "certificates/operations/" + name + ".cert"; }

std::string operation_header_path(const std::string& name) {
  return "include/restrip/tables/operations/" + identifier(name) + ".hpp";
}

void expect_within_limits(const Patches& section) {
  for (const Position& position : section.serves) {
    const Patch patch = make_patch(position);
    for (const Side* side : {&patch.before, &patch.after})
      if (side->nodes > most_nodes || side->owner.empty() || side->ports() > most_ports ||
          side->edges.size() + side->owner.size() > most_edges_and_ports)
        throw std::runtime_error(fmt::format(
            "{}{}: expected 1 to {} triangles, 1 to {} ports, and at most {} edges and ports together on each "
            "side; a smaller --max-k leaves large positions out",
            position.family->in_file, name_of(position), most_nodes, most_ports, most_edges_and_ports));
  }
}

/// All positions of a description with their rules.
struct AnsweredPositions {
  std::vector<Description> every;  ///< the description with all positions listed
  std::vector<Section> images;
  std::vector<AnsweredPosition> positions;
};

/// From the sections of its certificate. Positions that it omits, because they are images of others, are solved.
AnsweredPositions answered_positions(const Description& description, const std::vector<Section>& known,
                                     unsigned max_k) {
  AnsweredPositions answered;
  auto& [every, images, positions] = answered;
  every = {description};
  every[0].listed.clear();
  every[0].section = description.place.empty() ? description.name : description.place;
  const std::vector<Patches> patches = patches_of(every, max_k);
  images.reserve(patches.size());
  for (const Patches& one : patches) {
    const Position& position = one.serves[0];
    const auto serves = [&](const Section& other) {
      return std::any_of(other.serves.begin(), other.serves.end(), [&](const Position& served) {
        return served.family == &description && served.numbers() == position.numbers();
      });
    };
    const auto found = std::find_if(known.begin(), known.end(), serves);
    if (found == known.end()) {
      expect_within_limits(one);
      images.push_back(solve(one, Watched::yes));
    }
    positions.push_back({position, found == known.end() ? &images.back() : &*found});
  }
  return answered;
}

/// The files of a description, from the sections of its certificate. Adds the bytes of the table.
std::map<std::filesystem::path, std::string> files_of(const Description& description, const std::vector<Section>& known,
                                                      const std::set<std::string>& languages, unsigned max_k,
                                                      std::size_t& table_bytes) {
  const AnsweredPositions answered = answered_positions(description, known, max_k);
  const OperationLayout layout = operation_layout(answered.positions);
  table_bytes += layout.bytes();
  std::map<std::filesystem::path, std::string> files;
  if (languages.contains("c++")) files[operation_header_path(description.name)] = operation_header(layout);
  for (const auto& [name, file] : files_in(languages, "rule_of_" + identifier(description.name)))
    if (file->of_operation != nullptr) files[name] = file->of_operation(layout);
  return files;
}

/// Adds the figures of a certificate to a report, as JSON and as a human-readable line.
void add_figures(const Certificate& certificate, std::size_t bytes, nlohmann::ordered_json& json, std::string& text) {
  const auto& [name, sections, texts] = certificate;
  const std::size_t rows = certificate.rows();
  std::vector<Claims> parts;
  double symmetries = 0;
  for (const Section& section : sections) {
    parts.insert(parts.end(), section.claims.begin(), section.claims.end());
    symmetries = std::max(symmetries, section.symmetries);
  }
  const Claims claims = sum(parts);
  const bool graph_only = sections[0].position.family->is_graph_only();
  json.push_back({{"name", name},
                  {"configurations", claims.configurations},
                  {"valid", claims.valid},
                  {"orbits", claims.orbits},
                  {"valid_orbits", claims.valid_orbits},
                  {"symmetries", static_cast<std::uint64_t>(symmetries)},
                  {"keys", rows},
                  {"costing", claims.costing},
                  {"worst_strips", claims.worst_strips},
                  {"worst_isolated", claims.worst_isolated},
                  {"bytes", bytes},
                  {"graph_only", graph_only}});
  text +=
      fmt::format("{:<24} {:>6} {:<14}  {:>5} {:<5}  {:>6} {}\n{}", name, claims.configurations,
                  plural(claims.configurations, "configuration"), rows, plural(rows, "rule"), bytes,
                  plural(bytes, "byte"), graph_only ? "  graph only: not checked to be an operation on a mesh\n" : "");
}

}  // namespace

void dump_rules(const std::string& file, std::optional<unsigned> max_k, std::FILE* out) {
  const std::vector<Description> descriptions = read_descriptions(file);
  if (descriptions.size() != 1)
    throw std::runtime_error(
        fmt::format("{}: describes {} operations; dump a file of one at a time", file, descriptions.size()));
  const Description& description = descriptions[0];
  if (max_k && description.numbers.empty())
    throw std::runtime_error(fmt::format("{}: not a family, so --max-k has no effect; leave it out", file));
  std::vector<Section> sections;
  for (Patches& patches : patches_of(descriptions, max_k.value_or(most_ports))) {
    expect_within_limits(patches);
    sections.push_back(solve(std::move(patches)));
  }
  const bool gives_up = description.gives_all_up || description.may_give_up != 0;
  for (const std::string& number : description.numbers) fmt::print(out, "{},", number);
  fmt::print(out, "inner,ports,inner_after,{}strips,isolated\n", gives_up ? "ports_after," : "");
  const AnsweredPositions answered = answered_positions(description, sections, max_k.value_or(most_ports));
  for (const auto& [position, section] : answered.positions) {
    const Operation operation = operation_at(position);
    std::string place;
    for (std::size_t i = 0; i < description.numbers.size(); ++i) place += fmt::format("{},", position.numbers().at(i));
    for_each_valid(operation, [&, rows = section](const Configuration& c) {
      const Row& row = row_of(*rows, c.ports, c.outcome.joined);
      const Change change = change_of(operation.patch, c, row);
      fmt::print(out, "{}{},{},{},", place, c.before, c.ports, row.recoloring);
      if (gives_up) fmt::print(out, "{},", row.kept);
      fmt::print(out, "{},{}\n", change.strips, change.isolated);
    });
  }
}

void make_rules(const RulesOptions& options) {
  std::vector<Description> descriptions;
  bool has_family = false;
  for (const std::string& file : options.files) {
    const std::vector<Description> others = descriptions;
    for (Description& description : read_descriptions(file)) {
      for (const Description& other : others)
        if (other.name == description.name || other.certificate == description.certificate)
          throw std::runtime_error(fmt::format("{}: another of these files has the name {}", file, description.name));
      has_family = has_family || !description.numbers.empty();
      descriptions.push_back(std::move(description));
    }
  }
  if (options.max_k && !has_family)
    throw std::runtime_error(
        fmt::format("{}: not a family, so --max-k has no effect; leave it out", fmt::join(options.files, ", ")));
  std::set<std::filesystem::path> paths;
  const unsigned max_k = options.max_k.value_or(most_ports);
  const bool certified = options.languages.contains("c++");
  std::vector<Patches> all = patches_of(descriptions, max_k);
  for (const Patches& one : all) {
    expect_within_limits(one);
    if (certified) paths.insert(operation_certificate_path(one.certificate));
  }
  for (const Description& description : descriptions) {
    if (certified) paths.insert(operation_header_path(description.name));
    for (const auto& [name, file] : files_in(options.languages, "rule_of_" + identifier(description.name)))
      if (file->of_operation != nullptr) paths.insert(name);
  }
  const std::vector<std::filesystem::path> inputs{options.files.begin(), options.files.end()};
  files::OutputSet out(options.out, {paths.begin(), paths.end()}, {{}, inputs});
  const files::ReportOutput report(options.json, inputs);

  std::vector<Section> solved;
  std::vector<std::string> solved_texts;
  for (Patches& patches : all) {
    solved.push_back(solve(std::move(patches), Watched::yes));
    if (certified) solved_texts.push_back(section_text(solved.back(), Watched::yes));
  }
  std::vector<files::NamedBytes> texts;
  nlohmann::ordered_json json;
  std::string text;
  for (const Certificate& certificate : by_certificate(std::move(solved), std::move(solved_texts))) {
    const std::string& name = certificate.name;
    if (certified) texts.push_back({operation_certificate_path(name), certificate_text(certificate)});
    std::size_t table_bytes = 0;
    for (const Description& description : descriptions) {
      if (description.certificate != name) continue;
      for (auto& [path, bytes] : files_of(description, certificate.sections, options.languages, max_k, table_bytes))
        texts.push_back({path, std::move(bytes)});
    }
    add_figures(certificate, table_bytes, json["operations"], text);
  }
  out.write(changed(options.out, std::move(texts)));
  report.print(text, json.dump(2) + "\n");
}

}  // namespace restrip::generator
