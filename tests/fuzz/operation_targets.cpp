// What the verifier reads of operations of a user's own: their files, certificates and dumps.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "input.hpp"
#include "operation_certificate.hpp"
#include "operation_dump.hpp"
#include "sealed.hpp"
#include "target.hpp"
#include "words.hpp"

namespace restrip::fuzz {
namespace {

using namespace verify::operations;
using verify::read_file;

std::string corpus_text(const char* name) { return read_file(fmt::format("{}/{}.json", RESTRIP_OPERATIONS, name)); }

void promise_limits(const Side& side) {
  promise(side.triangles >= 1 && side.triangles <= most_triangles, "triangles within limits");
  promise(side.ports() >= 1 && side.ports() <= most_ports, "ports within limits");
  promise(side.inner_edges() + side.ports() <= most_colors, "colours within limits");
  for (const auto& edge : side.edges)
    promise(edge[0] < side.triangles && edge[1] < side.triangles && edge[0] != edge[1], "edges join triangles");
  for (const unsigned owner : side.owner_of_port) promise(owner < side.triangles, "ports have owners");
}

Target file_target() {
  const auto read = [](std::string_view bytes) {
    const OperationFile operation = parse_operation_file("f", bytes);
    promise_limits(operation.before);
    promise_limits(operation.after);
    promise(operation.before.ports() == operation.after.ports(), "as many ports on both sides");
    promise(!operation.name.empty() && operation.name.find('/') == std::string::npos, "a name names a file");
    promise(!owner_of_name(operation.name), "a name is free");
    for (const char c : operation.about)
      promise(c != '\\' && (c < 0 || c >= ' '), "a sentence is one line of a comment");
    promise(!operation.cost.empty() && operation.cost.size() <= most_criteria, "criteria within limits");
    promise(operation.may_give_up < verify::mask_count(operation.ports()), "ports that may be given up are ports");
    return true;
  };
  return {"operation-file",
          {corpus_text("split-face"), corpus_text("bisect-costs"), corpus_text("flip-forest")},
          refusing(read),
          10000};
}

Target operation_certificate_target() {
  const auto operation = std::make_shared<OperationFile>(
      parse_operation_file("f", read_file(RESTRIP_TABLES "/operations/split-face.json")));
  const auto read = [operation](std::string_view bytes) {
    const std::string text = sealed(bytes);
    const OperationCertificate certificate = parse_operation_certificate("f", text, *operation);
    const std::vector<std::string> lines = lines_of(text);
    for (const RuleRow& row : certificate.rows) promise(row.text() == lines.at(row.line - 1), "a row is its line");
    return true;
  };
  return {"operation-certificate",
          {read_file(RESTRIP_TABLES "/certificates/operations/split-face.cert")},
          refusing(read),
          10000};
}

Target operation_dump_target() {
  const auto operation = std::make_shared<OperationFile>(parse_operation_file("f", corpus_text("split-face")));
  std::string seed = "restrip-operation-dump 1\noperation split-face\n";
  for (verify::Mask ports = 0; ports < 8; ++ports) seed += fmt::format("0 {:x} {}\n", ports, ports == 7 ? "-" : "0 0");
  seed += "end 8\n";
  const auto read = [operation](std::string_view bytes) {
    std::string text(bytes);
    if (text.empty()) return false;  // fmemopen takes no less
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(fmemopen(text.data(), text.size(), "r"), std::fclose);
    promise(stream != nullptr, "a stream of bytes opens");
    RuleJudge judge(*operation);  // a new one each time: it remembers what it was asked
    return check_operation_dump(stream.get(), judge, nullptr).fault.empty();
  };
  return {"operation-dump", {seed}, read, 3000};
}

}  // namespace

std::vector<Target> operation_targets() {
  return {file_target(), operation_certificate_target(), operation_dump_target()};
}

}  // namespace restrip::fuzz
