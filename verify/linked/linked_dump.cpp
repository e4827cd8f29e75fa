#include "linked/linked_dump.hpp"

#include <fmt/format.h>

#include <memory>

#include "certificate/stream_lines.hpp"
#include "linked/tree_judge.hpp"

namespace restrip::verify {
namespace {

class Reader {
 public:
  Reader(StreamLines& lines, unsigned max_k, LinkedDumpCheck& check) : lines_(lines), max_k_(max_k), check_(check) {}

  void run() {
    lines_.expect("restrip-linked-dump 1");
    for (const LinkedFamily& family : linked_families(max_k_)) {
      std::map<Numbers, const Operation*> operations;  // in order of appearance
      for (const Section& section : family.local.sections)
        for (const Operation& operation : section.operations) operations.emplace(operation.numbers, &operation);
      for (const Operation& operation : family.local.unlisted) operations.emplace(operation.numbers, &operation);
      for (const auto& [place, operation] : operations) read_table(family.name, *operation);
    }
    lines_.expect_last(fmt::format("end {}", entries_));
  }

 private:
  std::string_view word() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return found;
  }
  Mask mask_in(std::string_view digits) const {
    const std::uint64_t mask = lines_.number_in(digits, 16);
    if (mask > ~Mask{0}) lines_.fail(fmt::format("expected a mask, found \"{}\"", digits));
    return static_cast<Mask>(mask);
  }
  Branch branch() {
    const std::string_view found = word();
    if (!found.starts_with('#')) return {Branch::Kind::leaf, mask_in(found)};
    const Mask node = mask_in(found.substr(1));
    if (node >= questions_.size()) lines_.fail(fmt::format("node {:x} does not exist above \"{}\"", node, line_));
    return {Branch::Kind::node, node};
  }
  unsigned port() {
    const Mask port = mask_in(word());
    if (port >= operation_->before.ports()) lines_.fail(fmt::format("port {} does not exist in \"{}\"", port, line_));
    return port;
  }

  void read_question() {
    if (mask_in(word().substr(1)) != questions_.size())
      lines_.fail(fmt::format("expected node {:x}, found \"{}\"", questions_.size(), line_));
    Question question{port(), branch(), branch(), {}};
    while (!rest_.empty()) {
      const unsigned other = port();
      question.back[other] = branch();
    }
    questions_.push_back(question);
    ++entries_;
  }

  void read_table(const std::string& family, const Operation& operation) {
    operation_ = &operation;
    lines_.expect(fmt::format("table {} {}", family, operation.position));
    lines_.place = fmt::format(", table {} {}", family, operation.position);
    ++check_.positions;
    questions_.clear();
    worlds_ = worlds_of(Constraint::strips, operation.ports());
    before_.emplace(operation.before, Constraint::strips, worlds_);
    after_.emplace(operation.after, Constraint::strips, worlds_);
    judges_.clear();
    judges_.resize(mask_count(operation.ports()));
    known_.clear();
    for (Mask inner = 0; inner < mask_count(operation.before.inner_edges()); ++inner)
      for (Mask ports = 0; ports < mask_count(operation.before.ports()); ++ports) read_entry({inner, ports});
    lines_.place.clear();
  }

  void read_entry(Colors before) {
    const std::string expected = fmt::format("{:x} {:x} ", before.inner, before.ports);
    const auto next = [&] { rest_ = line_ = lines_.next(expected); };
    for (next(); line_.starts_with('#'); next()) read_question();
    if (!line_.starts_with(expected)) lines_.fail(fmt::format("expected \"{}\", found \"{}\"", expected, line_));
    ++entries_;
    rest_.remove_prefix(expected.size());
    const bool answered = rest_ != "-";
    const Branch root = answered ? branch() : Branch{};
    if (answered && !rest_.empty()) lines_.fail(fmt::format("more words than an entry has: \"{}\"", line_));
    const bool valid = before_->valid(before);
    if (valid != answered) return wrong(before, valid ? "valid, but nothing picked" : "not valid");
    if (!answered) return;
    ++check_.configurations;
    std::vector<unsigned> worlds;
    for (unsigned world = 0; world < worlds_.size(); ++world)
      if (is_subset(worlds_[world].ports, before.ports) && before_->valid(before, world)) worlds.push_back(world);
    auto& judge = judges_[before.ports];
    if (!judge) judge = std::make_unique<TreeJudge>(operation_->after, *after_, worlds_, before.ports);
    const auto [place, is_new] =
        known_.try_emplace({before.ports, worlds, root.kind == Branch::Kind::leaf, root.number});
    if (is_new) place->second = judge->judge(questions_, root, worlds);
    check_.leaves += place->second.leaves;
    if (!place->second.fault.empty()) wrong(before, place->second.fault);
  }

  void wrong(Colors before, const std::string& what) {
    check_.wrong.add(check_.wrong.count != 0
                         ? std::string{}
                         : fmt::format("line {}{}, inner {:x}, ports {:x}\n    {}\n  {}", lines_.number(), lines_.place,
                                       before.inner, before.ports, drawn(operation_->before, before), what));
  }

  StreamLines& lines_;
  unsigned max_k_;
  LinkedDumpCheck& check_;
  std::string_view line_;
  std::string_view rest_;
  std::uint64_t entries_ = 0;
  const Operation* operation_ = nullptr;
  std::vector<Question> questions_;
  std::vector<World> worlds_;
  std::optional<PatchInWorlds> before_;
  std::optional<PatchInWorlds> after_;
  std::vector<std::unique_ptr<TreeJudge>> judges_;  ///< by ports
  std::map<std::tuple<Mask, std::vector<unsigned>, bool, Mask>, TreeJudge::Verdict> known_;
};

}  // namespace

LinkedDumpCheck check_linked_dump(std::FILE* stream, unsigned max_k) {
  return found_in<LinkedDumpCheck>(
      stream, [&](StreamLines& lines, LinkedDumpCheck& check) { Reader(lines, max_k, check).run(); });
}

LinkedDumpCheck check_linked_dump_of(const std::string& program, unsigned max_k) {
  return checked_output_of(program, [&](std::FILE* stream) { return check_linked_dump(stream, max_k); });
}

}  // namespace restrip::verify
