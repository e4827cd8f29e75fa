// The verifier's readers for custom operations: operation files, certificates and dumps.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "certificate/certificate.hpp"
#include "judge/table_dump.hpp"
#include "model/families_text.hpp"
#include "model/input.hpp"
#include "model/words.hpp"
#include "sealed.hpp"
#include "target.hpp"

namespace restrip::fuzz {
namespace {

using namespace verify;

std::string corpus_text(const char* name) { return read_file(fmt::format("{}/{}.json", RESTRIP_OPERATIONS, name)); }

/// The shipped families, under other names.
std::string custom_families() {
  std::string text(families_text);
  for (const std::string_view member : {"\"name\": \"", "\"certificate\": \""})
    for (std::size_t at = text.find(member); at != std::string::npos; at = text.find(member, at + 1))
      text.insert(at + member.size(), "my-");
  return text;
}

void promise_limits(const Side& side) {
  promise(side.triangles >= 1 && side.triangles <= most_triangles, "triangles within limits");
  promise(side.ports() >= 1 && side.ports() <= most_ports, "ports within limits");
  promise(side.colors() <= most_colors, "colours within limits");
  for (const auto& edge : side.edges)
    promise(edge[0] < side.triangles && edge[1] < side.triangles && edge[0] != edge[1], "edges join triangles");
  for (const unsigned owner : side.owner_of_port) promise(owner < side.triangles, "ports have owners");
}

Target file_target() {
  const auto read = [](std::string_view bytes) {
    const std::vector<Description> descriptions = parse_descriptions("f", bytes);
    for (const Description& description : descriptions) {
      for (const std::string& name : {description.name, description.certificate}) {
        promise(!name.empty() && name.find('/') == std::string::npos, "a name names a file");
        promise(!owner_of_name(name), "a name is free");
      }
      for (const std::string& text : {description.about, description.position, description.section})
        for (const char c : text) promise(c < 0 || c >= ' ', "a text is one line");
      promise(description.about.find('\\') == std::string::npos, "a sentence does not join lines");
    }
    const std::vector<Numbers> positions = descriptions.front().positions(4);
    if (positions.empty()) return true;
    const Operation operation = descriptions.front().at(positions.front());
    promise_limits(operation.before);
    promise_limits(operation.after);
    promise(operation.before.ports() == operation.after.ports(), "the same number of ports on both sides");
    promise(!operation.cost.empty() && operation.cost.size() <= most_criteria, "criteria within limits");
    promise(operation.may_give_up < mask_count(operation.ports()), "ports that may be given up are ports");
    return true;
  };
  return {"operation-file",
          {corpus_text("split-face-graph"), corpus_text("bisect-costs"), corpus_text("flip-forest"), custom_families(),
           read_file(RESTRIP_TABLES "/operations/merge-boundary.json")},
          refusing(read),
          10000};
}

/// The family of an operation that has one position.
std::shared_ptr<const Family> family_of_one(const std::string& text) {
  return std::make_shared<const Family>(families_of(parse_descriptions("f", text), 1).front());
}

Target operation_certificate_target() {
  const auto family = family_of_one(read_file(RESTRIP_TABLES "/operations/split-face.json"));
  const auto read = [family](std::string_view bytes) {
    const std::string text = sealed(bytes);
    const Certificate certificate = parse_certificate("f", text, *family);
    const std::vector<std::string> lines = lines_of(text);
    for (const Row& row : certificate.sections.front().rows)
      promise(row.text() == lines.at(row.line - 1), "a row is its line");
    return true;
  };
  return {"operation-certificate",
          {read_file(RESTRIP_TABLES "/certificates/operations/split-face.cert")},
          refusing(read),
          10000};
}

Target operation_dump_target() {
  const auto family = family_of_one(corpus_text("split-face-graph"));
  std::string seed = "restrip-table-dump 4\ntable split-face-graph\n";
  for (Mask ports = 0; ports < 8; ++ports) seed += fmt::format("0 {:x} {}\n", ports, ports == 7 ? "-" : "0 0 2 2");
  seed += "end 8\n";
  const auto read = [family](std::string_view bytes) {
    std::string text(bytes);
    if (text.empty()) return false;  // fmemopen requires at least one byte
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(fmemopen(text.data(), text.size(), "r"), std::fclose);
    promise(stream != nullptr, "a stream of bytes opens");
    ExpectedDump expected;
    expected.tables.push_back({&family->sections.front().operations.front(), Against::own_patch, nullptr});
    return compare_dump(stream.get(), expected).fault.empty();
  };
  return {"operation-dump", {seed}, read, 3000};
}

}  // namespace

std::vector<Target> operation_targets() {
  return {file_target(), operation_certificate_target(), operation_dump_target()};
}

}  // namespace restrip::fuzz
