// The verifier's readers: manifests, certificates of rules and of linked rules, dumps of tables and of linked rules.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "certificate/certificate.hpp"
#include "certificate/manifest.hpp"
#include "judge/table_dump.hpp"
#include "linked/linked_certificate.hpp"
#include "linked/linked_dump.hpp"
#include "model/input.hpp"
#include "sealed.hpp"
#include "target.hpp"

namespace restrip::fuzz {
namespace {

using namespace verify;

constexpr unsigned small_max_k = 4;  // of the tables in tests/corpus

/// One target for each certificate of the small tables.
Target certificate_target(const Family& family) {
  const auto read = [family](std::string_view bytes) {
    const std::string text = sealed(bytes);
    const Certificate certificate = parse_certificate("f", text, family);
    const std::vector<std::string> lines = lines_of(text);
    for (const SectionRows& section : certificate.sections)
      for (const Row& row : section.rows) promise(row.text() == lines.at(row.line - 1), "a row is its line");
    return true;
  };
  return {"certificate-" + family.name,
          {read_file(RESTRIP_SMALL_TABLES "/certificates/" + family.name + ".cert")},
          refusing(read),
          2000};
}

Target linked_target(const LinkedFamily& family) {
  const auto read = [family](std::string_view bytes) {
    const std::string text = sealed(bytes);
    const LinkedCertificate certificate = parse_linked_certificate("f", text, family);
    const std::vector<std::string> lines = lines_of(text);
    for (const SectionLists& section : certificate.sections)
      for (const Alternative& row : section.rows)
        promise(row.text() == lines.at(row.line - 1), "an alternative is its line");
    return true;
  };
  return {"certificate-" + family.name,
          {read_file(RESTRIP_SMALL_TABLES "/certificates/" + family.name + ".cert")},
          refusing(read),
          4000};
}

Target manifest_target() {
  const auto read = [](std::string_view bytes) {
    const std::string text(bytes);
    const std::vector<std::string> lines = lines_of(text);
    for (const ManifestLine& line : parse_manifest("f", text))
      promise(fmt::format("{} {} {} {}", line.sha256, line.bytes, line.rows, line.path) == lines.at(line.line - 1),
              "an entry is its line");
    return true;
  };
  return {"manifest", {read_file(RESTRIP_SMALL_TABLES "/MANIFEST")}, refusing(read), 10000};
}

/// Runs a reader of streams on bytes.
template <class Read>
auto of_stream(Read read) {
  return [read](std::string_view bytes) {
    std::string text(bytes);
    if (text.empty()) return false;  // fmemopen requires at least one byte
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(fmemopen(text.data(), text.size(), "r"), std::fclose);
    promise(stream != nullptr, "a stream of bytes opens");
    return read(stream.get());
  };
}

/// The linked look-up's choices for k = 3: `restrip-dump-tables --linked --max-k 3`.
Target linked_dump_target() {
  return {"linked-dump",
          {read_file(RESTRIP_CORPUS "/dumps/linked-3.txt")},
          of_stream([](std::FILE* stream) { return check_linked_dump(stream, 3).holds(); }),
          2000};
}

/// A dump of flips and of one table of lists, which are only read, and of splits, which are judged.
Target dump_target() {
  struct Expected {
    std::vector<Family> families = all_families(3);
    std::vector<LinkedFamily> linked = linked_families(3);
    ExpectedDump dump;
  };
  auto expected = std::make_shared<Expected>();
  std::string seed = "restrip-table-dump 4\n";
  std::size_t entries = 0;
  for (const Family& family : expected->families) {
    if (family.name != "flip" && family.name != "split") continue;
    const Operation& operation = family.sections.front().operations.front();
    expected->dump.tables.push_back(
        {&operation, family.name == "flip" ? Against::nothing : Against::own_patch, nullptr});
    seed += fmt::format("table {}\n", operation.name());
    for (Mask inner = 0; inner < mask_count(operation.before.inner_edges()); ++inner)
      for (Mask ports = 0; ports < mask_count(operation.before.ports()); ++ports, ++entries)
        seed += fmt::format("{:x} {:x} -\n", inner, ports);
  }
  const LinkedFamily& lists = expected->linked.front();
  const Section& section = lists.local.sections.front();
  expected->dump.lists.push_back({lists.name, section.position, section.ports, nullptr});
  seed += fmt::format("table {} {}\n", lists.name, section.position);
  for (Mask ports = 0; ports < mask_count(section.ports); ++ports, ++entries) seed += fmt::format("{:x} 0 0\n", ports);
  seed += fmt::format("end {}\n", entries);
  const auto read =
      of_stream([expected](std::FILE* stream) { return compare_dump(stream, expected->dump).fault.empty(); });
  return {"dump", {seed}, read, 4000};
}

}  // namespace

std::vector<Target> table_targets() {
  std::vector<Target> targets;
  targets.push_back(manifest_target());
  for (const Family& family : all_families(small_max_k)) targets.push_back(certificate_target(family));
  for (const LinkedFamily& family : linked_families(small_max_k)) targets.push_back(linked_target(family));
  targets.push_back(dump_target());
  targets.push_back(linked_dump_target());
  return targets;
}

}  // namespace restrip::fuzz
