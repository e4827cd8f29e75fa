// The verifier's readers: manifests, certificates, dumps of tables, of rules and of custom operations, and operation
// files.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "certificate/certificate.hpp"
#include "certificate/manifest.hpp"
#include "judge/table_dump.hpp"
#include "model/input.hpp"
#include "target.hpp"

namespace restrip::fuzz {
namespace {

using namespace verify;

constexpr unsigned small_max_k = 4;  // of the tables in tests/corpus

/// Replaces the sums in the last line by matching ones, so that alterations reach the reader.
std::string sealed(std::string_view text) {
  const std::size_t end = text.rfind("end ");
  if (end == std::string_view::npos) return std::string(text);
  const std::string_view above = text.substr(0, end);
  const std::string_view rows = text.substr(end + 4, text.find(' ', end + 4) - end - 4);
  const ByteSums sums = sums_of(above);
  return fmt::format("{}end {} {} {}\n", above, rows, sums.plain, sums.weighted);
}

/// The lines of a text, which promise what its reader found in them.
class Lines {
 public:
  explicit Lines(std::string_view text) {  // a stream would take a shortage of memory for the end
    for (std::size_t at = 0; at < text.size(); at += lines_.back().size() + 1)
      lines_.emplace_back(text.substr(at, text.find('\n', at) - at));
  }
  void promise_found(const std::string& found, unsigned line) const {
    promise(found == lines_.at(line - 1), "what is read from a line is that line");
  }

 private:
  std::vector<std::string> lines_;
};

Target certificate_target(const std::string& name, const std::string& file, unsigned runs, const Family& family) {
  const auto read = [family](std::string_view bytes) {
    const std::string text = sealed(bytes);
    const Certificate certificate = parse_certificate("f", text, family);
    const Lines lines(text);
    for (const SectionRows& section : certificate.sections)
      for (const Row& row : section.rows) lines.promise_found(row.text(), row.line);
    return true;
  };
  return {name, {read_file(file)}, refusing(read), runs};
}

Target manifest_target() {
  const auto read = [](std::string_view bytes) {
    const std::string text(bytes);
    const Lines lines(text);
    for (const ManifestLine& line : parse_manifest("f", text))
      lines.promise_found(fmt::format("{} {} {} {}", line.sha256, line.bytes, line.rows, line.path), line.line);
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

/// A dump of flips, which are only read, and of splits, which are judged.
Target dump_target() {
  struct Expected {
    std::vector<Family> families = all_families(3);
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
  seed += fmt::format("end {}\n", entries);
  const auto read =
      of_stream([expected](std::FILE* stream) { return compare_dump(stream, expected->dump).fault.empty(); });
  return {"dump", {seed}, read, 4000};
}

std::string corpus_text(const char* name) { return read_file(fmt::format("{}/{}.json", RESTRIP_OPERATIONS, name)); }

void promise_limits(const Side& side) {
  promise(side.triangles >= 1 && side.triangles <= most_triangles, "triangles within limits");
  promise(side.ports() >= 1 && side.ports() <= most_ports, "ports within limits");
  promise(side.colors() <= most_colors, "colours within limits");
  for (const auto& edge : side.edges)
    promise(edge[0] < side.triangles && edge[1] < side.triangles && edge[0] != edge[1], "edges join triangles");
  for (const unsigned owner : side.owner_of_port) promise(owner < side.triangles, "ports have owners");
}

Target operation_file_target() {
  const auto read = [](std::string_view bytes) {
    const std::vector<Description> descriptions = parse_descriptions("f", bytes);
    for (const Description& description : descriptions) {
      for (const std::string& name : {description.name, description.certificate})
        promise(!name.empty() && name.find('/') == std::string::npos, "a name names a file");
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
          {corpus_text("split-face-own"), corpus_text("bisect-costs"), corpus_text("families/spoke-flips"),
           read_file(RESTRIP_TABLES "/operations/merge-boundary.json")},
          refusing(read),
          10000};
}

/// The family of an operation that has one position.
Family family_of_one(const std::string& text) { return families_of(parse_descriptions("f", text), 1).front(); }

Target operation_dump_target() {
  const auto family = std::make_shared<const Family>(family_of_one(corpus_text("split-face-own")));
  std::string seed = "restrip-table-dump 4\ntable split-face-own\n";
  for (Mask ports = 0; ports < 8; ++ports) seed += fmt::format("0 {:x} {}\n", ports, ports == 7 ? "-" : "0 0 2 2");
  seed += "end 8\n";
  const auto read = of_stream([family](std::FILE* stream) {
    ExpectedDump expected;
    expected.tables.push_back({&family->sections.front().operations.front(), Against::own_patch, nullptr});
    return compare_dump(stream, expected).fault.empty();
  });
  return {"operation-dump", {seed}, read, 3000};
}

}  // namespace

std::vector<Target> table_targets() {
  std::vector<Target> targets{manifest_target()};
  for (const Family& family : tabled_families(small_max_k))
    targets.push_back(certificate_target("certificate-" + family.name,
                                         RESTRIP_SMALL_TABLES "/certificates/" + family.name + ".cert", 2000, family));
  targets.push_back(dump_target());
  targets.push_back(operation_file_target());
  targets.push_back(certificate_target("operation-certificate",
                                       RESTRIP_TABLES "/certificates/operations/split-face.cert", 10000,
                                       family_of_one(read_file(RESTRIP_TABLES "/operations/split-face.json"))));
  targets.push_back(operation_dump_target());
  return targets;
}

}  // namespace restrip::fuzz
