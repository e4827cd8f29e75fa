#include "operation_dump.hpp"

#include <fmt/format.h>

#include <charconv>

#include "certificate_judge.hpp"
#include "operation_mutants.hpp"
#include "stream_lines.hpp"

namespace restrip::verify::operations {
namespace {

/// Takes a mask as certificates write it off the beginning of a line.
std::optional<Mask> taken_mask(std::string_view& line, unsigned bits) {
  Mask mask = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), mask, 16);
  if (error != std::errc{} || mask >= mask_count(bits)) return {};
  const std::string_view word = line.substr(0, static_cast<std::size_t>(end - line.data()));
  if (fmt::format("{:x}", mask) != word) return {};
  line.remove_prefix(word.size());
  return mask;
}

class DumpReader {
 public:
  DumpReader(std::FILE* stream, RuleJudge& judge, const OperationCertificate* certificate, OperationDumpCheck& check)
      : lines_(stream), judge_(judge), certificate_(certificate), check_(check) {}

  void run() {
    const OperationFile& operation = judge_.operation();
    expect("restrip-operation-dump 1");
    expect("operation " + operation.name);
    const Mask inner_masks =
        operation.constraint == Constraint::matching ? 1 : mask_count(operation.before.inner_edges());
    for (Mask inner = 0; inner < inner_masks; ++inner)
      for (Mask ports = 0; ports < mask_count(operation.ports()); ++ports) entry({inner, ports});
    expect(fmt::format("end {}", check_.entries));
    if (lines_.next() || lines_.left_over()) throw BadDump(fmt::format("line {}: text after the end", lines_.number()));
  }

 private:
  std::string_view next_line(const std::string& expected) {
    const std::optional<std::string_view> line = lines_.next();
    if (!line) throw BadDump(fmt::format("line {}: expected \"{}\", found the end", lines_.number() + 1, expected));
    return *line;
  }

  void expect(const std::string& whole) {
    if (const std::string_view line = next_line(whole); line != whole)
      throw BadDump(fmt::format("line {}: expected \"{}\", found \"{}\"", lines_.number(), whole, line));
  }

  void entry(Colors configuration) {
    const std::string prefix = fmt::format("{:x} {:x} ", configuration.inner, configuration.ports);
    const std::string_view line = next_line(prefix);
    if (!line.starts_with(prefix))
      throw BadDump(fmt::format("line {}: expected \"{}\" and an answer, found \"{}\"", lines_.number(), prefix, line));
    ++check_.entries;
    std::string_view rest = line.substr(prefix.size());
    if (rest == "-") {
      judge(configuration, {});
      return;
    }
    const std::optional<Mask> inner = taken_mask(rest, judge_.operation().after.inner_edges());
    const bool spaced = rest.starts_with(' ');
    rest.remove_prefix(spaced ? 1 : 0);
    const std::optional<Mask> kept = taken_mask(rest, judge_.operation().ports());
    if (!inner || !spaced || !kept || !rest.empty())
      throw BadDump(fmt::format("line {}: expected \"{}\" and \"-\" or two masks, {} and {} bits at most, found \"{}\"",
                                lines_.number(), prefix, judge_.operation().after.inner_edges(),
                                judge_.operation().ports(), line));
    judge(configuration, Colors{*inner, *kept});
  }

  void judge(Colors configuration, std::optional<Colors> answer) {
    const bool valid = judge_.before().class_of(configuration) != FitClasses::not_valid;
    if (valid != answer.has_value() && (valid || !mutated(OperationMutant::answer_the_invalid))) {
      const OperationFile& operation = judge_.operation();
      check_.wrong.add(
          fmt::format("line {}:\n    before  {}\n  {}\n", lines_.number(), drawn(operation.before, configuration),
                      valid ? "no answer to a valid configuration"
                            : "an answer to a configuration that is not valid: " +
                                  invalid_because(operation.before, configuration, operation.most_solid())));
      return;
    }
    if (!valid) return;
    ++check_.answers;
    if (const Judged judged = judge_.judged(configuration, *answer); judged.verdict != Verdict::right)
      check_.wrong.add(check_.wrong.count != 0 ? std::string()
                                               : fmt::format("line {}:\n{}", lines_.number(),
                                                             judge_.explained(configuration, *answer, judged)));
    if (certificate_ == nullptr || mutated(OperationMutant::skip_certificate)) return;
    const RuleRow* const row = certificate_->row_of(key_of(judge_.operation(), configuration));
    if (row == nullptr || row->after != *answer)
      check_.other_than_stated.add(fmt::format(
          "line {}: the table answers \"{:x} {:x}\", the certificate has {}\n", lines_.number(), answer->inner,
          answer->ports, row == nullptr ? "no row" : fmt::format("\"{}\" in line {}", row->text(), row->line)));
  }

  StreamLines lines_;
  RuleJudge& judge_;
  const OperationCertificate* certificate_;
  OperationDumpCheck& check_;
};

}  // namespace

OperationDumpCheck check_operation_dump(std::FILE* stream, RuleJudge& judge, const OperationCertificate* certificate) {
  OperationDumpCheck check;
  try {
    DumpReader(stream, judge, certificate, check).run();
  } catch (const BadDump& bad) {
    check.fault = bad.what();
  }
  return check;
}

OperationDumpCheck check_operation_dump_of(const std::string& program, RuleJudge& judge,
                                           const OperationCertificate* certificate) {
  OperationDumpCheck check;
  std::FILE* const stream = popen(program.c_str(), "r");
  if (stream == nullptr) {
    check.fault = "cannot run " + program;
    return check;
  }
  check = check_operation_dump(stream, judge, certificate);
  const int status = pclose(stream);
  if (check.fault.empty() && status != 0) check.fault = program + " failed";
  return check;
}

}  // namespace restrip::verify::operations
