#include "linked/linked_dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include "certificate/stream_lines.hpp"
#include "definition/definition.hpp"
#include "linked/linked_check.hpp"

namespace restrip::verify {
namespace {

/// The continuation of a path of a tree: a node, or the chosen recolouring.
struct Branch {
  enum class Kind { none, node, leaf };
  Kind kind = Kind::none;
  Mask number = 0;  ///< of the node; or the recolouring
};

/// A question about one port.
struct Question {
  unsigned port = 0;
  Branch ends;
  Branch unknown;
  std::array<Branch, 8> back;  ///< by the port through which the strip comes back
};

/// Judges all trees of one position and one port mask.
class TreeJudge {
 public:
  TreeJudge(const Side& after, const PatchInWorlds& in_worlds, const std::vector<World>& worlds, Mask ports)
      : after_(after),
        in_worlds_(in_worlds),
        worlds_(worlds),
        ports_(ports),
        recolorings_(recolorings_of(after, ports)),
        partners_(worlds.size()) {
    for (std::size_t world = 0; world < worlds.size(); ++world) {
      partners_[world].fill(no_partner);
      for (const std::vector<unsigned>& pair : worlds[world].connected) {
        partners_[world][pair[0]] = pair[1];
        partners_[world][pair[1]] = pair[0];
      }
    }
    // Only the best of the recolourings that are sound in the same worlds can matter.
    std::map<std::vector<bool>, Merit> best;
    for (const Recoloring& recoloring : recolorings_) {
      if (!recoloring.survey.valid) continue;
      const auto [place, is_new] = best.try_emplace(sound_in(recoloring.colors.inner), recoloring.merit);
      if (!is_new) place->second = std::max(place->second, recoloring.merit);
    }
    for (const auto& [sound, merit] : best) choices_.push_back({merit, sound});
    std::stable_sort(choices_.begin(), choices_.end(),
                     [](const Choice& one, const Choice& other) { return one.merit > other.merit; });
  }

  struct Verdict {
    std::uint64_t leaves = 0;  ///< reachable ones
    std::string fault;         ///< the first one; empty without a fault
  };
  /// The tree that starts at `root`, for a configuration that may occur in these worlds.
  Verdict judge(const std::vector<Question>& questions, Branch root, const std::vector<unsigned>& worlds) {
    Verdict verdict;
    descend(questions, root, {0, worlds, {}}, verdict);
    return verdict;
  }

 private:
  static constexpr unsigned most_partners = 8;
  static constexpr unsigned no_partner = most_partners;

  using Partners = std::array<unsigned, most_partners>;
  /// The worlds in which recolourings are valid, and the best merit among them.
  struct Choice {
    Merit merit;
    std::vector<bool> sound;
  };
  /// The answers on the way to a leaf.
  struct Knowledge {
    Mask asked = 0;                  ///< ports, including ports through which strips come back
    std::vector<unsigned> possible;  ///< worlds
    std::string text;
  };

  const std::vector<bool>& sound_in(Mask inner) {
    const auto [place, is_new] = sound_.try_emplace(inner);
    if (is_new)
      for (std::size_t world = 0; world < worlds_.size(); ++world)
        place->second.push_back(is_subset(worlds_[world].ports, ports_) && in_worlds_.valid({inner, ports_}, world));
    return place->second;
  }

  void descend(const std::vector<Question>& questions, Branch branch, const Knowledge& known, Verdict& verdict) {
    if (known.possible.empty() || !verdict.fault.empty()) return;  // no outside agrees with these answers
    if (branch.kind == Branch::Kind::none) {
      verdict.fault = "no answer for a possible outside:" + known.text;
      return;
    }
    if (branch.kind == Branch::Kind::leaf) return judge_leaf(branch.number, known, verdict);
    const Question& question = questions.at(branch.number);
    const unsigned port = question.port;
    if (!is_solid(ports_, port) || is_solid(known.asked, port)) {
      verdict.fault = fmt::format("the question is about port {}, which is dashed or known:{}", port, known.text);
      return;
    }
    const auto answered = [&](unsigned partner, const std::string& text) {
      Knowledge more{known.asked | single(port), {}, known.text + text};
      if (partner != no_partner) more.asked |= single(partner);
      for (const unsigned world : known.possible)
        if (partners_[world][port] == partner) more.possible.push_back(world);
      return more;
    };
    descend(questions, question.ends, answered(no_partner, fmt::format(" {} ends", port)), verdict);
    descend(questions, question.unknown,
            {known.asked | single(port), known.possible, known.text + fmt::format(" {} unknown", port)}, verdict);
    // Unknown ports have no partner.
    for (unsigned other = 0; other < most_partners; ++other)
      if (is_solid(ports_ & ~known.asked, other) && other != port)
        descend(questions, question.back[other], answered(other, fmt::format(" {} comes back through {}", port, other)),
                verdict);
  }

  void judge_leaf(Mask inner, const Knowledge& known, Verdict& verdict) {
    ++verdict.leaves;
    const auto fail = [&](const std::string& what) {
      verdict.fault =
          fmt::format("the outside:{}; picked {:x}\n    {}\n  {}", known.text.empty() ? " not asked" : known.text,
                      inner, drawn(after_, {inner, ports_}), what);
    };
    if (inner >= recolorings_.size()) {
      verdict.fault = fmt::format("picked {:x}, which is not a recolouring", inner);
      return;
    }
    const Recoloring& own = recolorings_[inner];
    if (!own.survey.valid)
      return fail("unsound: " + invalid_because(after_, own.colors, most_solid(Constraint::strips)));
    const std::vector<bool>& sound = sound_in(inner);
    for (const unsigned world : known.possible)
      if (!sound[world]) return fail("unsound with " + text_of(worlds_[world]));
    const Merit merit = own.merit;
    for (const Choice& choice : choices_) {
      if (choice.merit <= merit) return;
      if (!always_unsound(choice, known))
        return fail(fmt::format("not optimal: {} solid edges and {} isolated triangles where {} and {} are safe",
                                merit.solid, -merit.fewer_isolated, choice.merit.solid, -choice.merit.fewer_isolated));
    }
  }

  /// Whether the choice stays unsound for some possible outside, even if more were known about the ports that were not
  /// asked about. Full knowledge leaves the fewest possibilities, so these cases are checked: outsides that agree at
  /// the ports that were not asked about, and join none of them with a port that was.
  bool always_unsound(const Choice& choice, const Knowledge& known) const {
    std::map<Partners, bool> unsound;
    const Mask open = ports_ & ~known.asked;
    for (const unsigned world : known.possible) {
      Partners found_out = partners_[world];
      bool mixed = false;
      for (unsigned i = 0; i < most_partners; ++i) {
        if (is_solid(open, i))
          mixed = mixed || (found_out[i] != no_partner && !is_solid(open, found_out[i]));
        else
          found_out[i] = no_partner;
      }
      if (mixed) continue;
      bool& any = unsound[found_out];
      any = any || !choice.sound[world];
    }
    return std::all_of(unsound.begin(), unsound.end(), [](const auto& found) { return found.second; });
  }

  const Side& after_;
  const PatchInWorlds& in_worlds_;
  const std::vector<World>& worlds_;
  Mask ports_;
  std::vector<Recoloring> recolorings_;
  std::vector<Partners> partners_;           ///< by world: the partner of each port
  std::vector<Choice> choices_;              ///< in order of preference
  std::map<Mask, std::vector<bool>> sound_;  ///< by inner edges
};

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
