#include "judge/family_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/counted.hpp"
#include "judge/report.hpp"

namespace restrip::verify {
namespace {

/// Figures published in docs/explanation/theory.md (section 6), counted there by an independent program. They are typed
/// on purpose, for comparison.
struct ReferenceCount {
  std::string_view operation;  ///< Operation::name()
  std::uint64_t configurations;
  std::uint64_t valid;
  std::optional<std::uint64_t> orbits;
  std::optional<std::uint64_t> valid_orbits;
  std::uint64_t costing;
};

constexpr std::array<ReferenceCount, 26> reference_counts = {{
    {"split k 3 a 1", 64, 44, 40, 27, 0},
    {"split k 4 a 1", 256, 160, 144, 88, 0},
    {"split k 4 a 2", 256, 160, 84, 55, 2},
    {"split k 5 a 1", 1024, 572, 544, 305, 0},
    {"split k 5 a 2", 1024, 572, 544, 305, 6},
    {"split k 6 a 1", 4096, 2040, 2112, 1050, 0},
    {"split k 6 a 2", 4096, 2040, 2112, 1064, 14},
    {"split k 6 a 3", 4096, 2040, 1104, 558, 19},
    {"split k 7 a 1", 16384, 7268, 8320, 3703, 0},
    {"split k 7 a 2", 16384, 7268, 8320, 3703, 40},
    {"split k 7 a 3", 16384, 7268, 8320, 3703, 44},
    {"split k 8 a 1", 65536, 25888, 33024, 13052, 0},
    {"split k 8 a 2", 65536, 25888, 33024, 13102, 102},
    {"split k 8 a 3", 65536, 25888, 33024, 13052, 118},
    {"split k 8 a 4", 65536, 25888, 16704, 6670, 110},
    {"collapse k 3 a 1", 512, 278, {}, {}, 0},
    {"collapse k 4 a 1", 2048, 998, {}, {}, 1},
    {"collapse k 4 a 2", 2048, 1016, {}, {}, 4},
    {"collapse k 5 a 1", 8192, 3562, {}, {}, 7},
    {"collapse k 5 a 2", 8192, 3640, {}, {}, 28},
    {"collapse k 6 a 1", 32768, 12694, {}, {}, 23},
    {"collapse k 6 a 2", 32768, 12988, {}, {}, 83},
    {"collapse k 6 a 3", 32768, 13032, {}, {}, 104},
    {"collapse k 7 a 1", 131072, 45218, {}, {}, 67},
    {"collapse k 7 a 2", 131072, 46280, {}, {}, 238},
    {"collapse k 7 a 3", 131072, 46492, {}, {}, 321},
}};

std::string fault_of_copy(const Row& row, const SectionRows& rows, const Symmetries& symmetries) {
  if (!symmetries.allows(row.by)) return "wrong witness: no symmetry moves the ports in this way";
  const Key image = moved(row.key, row.by);
  const Row* const rule = rows.row_of(image);
  if (rule == nullptr || rule->copy)
    return fmt::format("wrong witness: it takes the key to {:x} {:x}, which has no rule row", image.ports,
                       image.joined.bits);
  if (!symmetries.carries(row.by, row.after, rule->after))
    return fmt::format(
        "wrong witness: no symmetry with this permutation of ports maps the recolouring to the one in line {}",
        rule->line);
  return {};
}

/// For each row, the smallest key with a row in its orbit. Images without a row are followed too: if a section serves
/// several positions, no configuration may have them. Missing rows are reported by another claim.
std::vector<Key> smallest_keys(const SectionRows& rows, const Symmetries& symmetries) {
  std::map<Key, Key> smallest;
  std::vector<Key> result;
  for (const Row& row : rows.rows) {
    if (!smallest.contains(row.key)) {
      std::vector<Key> orbit = {row.key};
      std::set<Key> seen = {row.key};
      for (std::size_t i = 0; i < orbit.size(); ++i)
        for (const Symmetry& symmetry : symmetries.generators())
          if (const Key image = moved(orbit[i], symmetry.ports); seen.insert(image).second) orbit.push_back(image);
      const Key first =
          *std::find_if(seen.begin(), seen.end(), [&](const Key& key) { return rows.row_of(key) != nullptr; });
      for (const Key& key : orbit) smallest.emplace(key, first);
    }
    result.push_back(smallest.at(row.key));
  }
  return result;
}

class FamilyReport {
 public:
  FamilyReport(const Family& family, const Certificate& certificate, std::span<const PositionCheck> checks,
               const ClaimListener& listener)
      : family_(family),
        operation_(family.sections.front().operations.front()),
        certificate_(certificate),
        checks_(checks),
        listener_(listener) {
    for (const PositionCheck& check : checks)
      if (!searched(*check.operation)) limit_ = fmt::format(", k <= {}", most_searched_ports);
  }

  void run() {
    check_sections();
    report_rows();
    report_reasons();
    report("copies follow from rules by symmetry",
           fmt::format("{:.0f} {} at most, by backtracking", most_symmetries_,
                       most_symmetries_ == 1 ? "symmetry" : "symmetries"),
           certificate_.rows, section_seconds_, copies_);
    report("the stated numbers", "recounted; orbits by merging images", stated_, sum(&PositionCheck::Seconds::orbits),
           claims_);
    report_bounds();
    report_published();
  }

 private:
  void report(const std::string& claim, const std::string& method, std::uint64_t cases, double seconds,
              const Failures& failures) const {
    listener_({family_.name, claim, method, cases, seconds, failures});
  }
  std::uint64_t sum(std::uint64_t PositionCheck::*count) const {
    std::uint64_t all = 0;
    for (const PositionCheck& check : checks_) all += check.*count;
    return all;
  }
  double sum(double PositionCheck::Seconds::*stage) const {
    double all = 0;
    for (const PositionCheck& check : checks_) all += check.seconds.*stage;
    return all;
  }
  Failures sum(Failures PositionCheck::*claim) const {
    Failures all;
    for (const PositionCheck& check : checks_) all.add(check.*claim);
    return all;
  }

  void check_sections() {
    const double start = thread_seconds();
    std::span<const PositionCheck> rest = checks_;
    for (std::size_t i = 0; i < family_.sections.size(); ++i) {
      const std::size_t count = family_.sections[i].operations.size();
      check_section(family_.sections[i], certificate_.sections[i], rest.first(count));
      rest = rest.subspan(count);
    }
    section_seconds_ = thread_seconds() - start;
  }

  /// Claims about a section as a whole, after its rows have been judged in each of its positions: every row has a valid
  /// configuration; every orbit of keys has its `rule` row at its smallest key, and every other key is a `copy` whose
  /// symmetry preserves the operation and maps key and recolouring to the `rule` row; the stated numbers.
  void check_section(const Section& section, const SectionRows& rows, std::span<const PositionCheck> positions) {
    const Symmetries symmetries(section.operations.front(),
                                section.serves_every_position ? Symmetries::Keep::after : Symmetries::Keep::both_sides);
    most_symmetries_ = std::max(most_symmetries_, symmetries.order());
    const std::vector<Key> smallest = smallest_keys(rows, symmetries);
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      const Row& row = rows.rows[i];
      const auto add = [&](Failures& failures, const std::string& fault) {
        failures.add(fmt::format("{}:{}: \"{}\"\n  section {}: {}\n", certificate_.file, row.line, row.text(),
                                 section.position, fault));
      };
      if (std::none_of(positions.begin(), positions.end(),
                       [&](const PositionCheck& position) { return position.row_used[i]; }))
        add(extra_, "extra row: no valid configuration has this key");

      std::string fault;
      const bool smallest_is_rule = row.copy != (smallest[i] == row.key);
      if (!smallest_is_rule && row.copy)
        fault = "wrong representative: the smallest key of its orbit must be a rule, not a copy";
      else if (!smallest_is_rule)
        fault = fmt::format("wrong representative: {:x} {:x} is a smaller key of this orbit, so the row must be a copy",
                            smallest[i].ports, smallest[i].joined.bits);
      else if (row.copy)
        fault = fault_of_copy(row, rows, symmetries);
      if (!fault.empty()) add(copies_, fault);

      if (row.reason) {
        const std::size_t cases = row.reason->leaves();
        ++rules_with_reason_;
        case_trees_ += cases > 1 ? 1U : 0U;
        most_cases_ = std::max(most_cases_, cases);
      }
      const auto wrong = std::find_if(positions.begin(), positions.end(), [&](const PositionCheck& position) {
        return !position.reason_faults[i].empty();
      });
      if (wrong != positions.end()) add(wrong_reasons_, "wrong reason: " + wrong->reason_faults[i]);
    }

    std::array<std::int64_t, claim_words.size()> counted{};
    std::optional<int> worst_strips;
    std::optional<int> worst_isolated;
    std::set<Key> keys;
    for (const PositionCheck& position : positions) {
      const std::array<std::uint64_t, 6> own = {
          position.configurations, position.valid, position.orbits.all, position.orbits.valid, 0, position.costing};
      for (std::size_t i = 0; i < own.size(); ++i) counted[i] += static_cast<std::int64_t>(own[i]);
      worst_strips = std::max(worst_strips, position.worst_strips);
      worst_isolated = std::max(worst_isolated, position.worst_isolated);
      keys.insert(position.keys.begin(), position.keys.end());
    }
    counted[4] = static_cast<std::int64_t>(keys.size());
    counted[6] = worst_strips.value_or(0);
    counted[7] = worst_isolated.value_or(0);
    stated_ += claim_words.size();
    for (std::size_t i = 0; i < claim_words.size(); ++i)
      if (const StatedClaim& claim = rows.claims[i]; claim.number != counted[i])
        claims_.add(fmt::format("{}:{}: \"claim {} {}\"\n  wrong claim: recounted {}\n", certificate_.file, claim.line,
                                claim_words[i], claim.number, counted[i]));
  }

  void report_rows() const {
    const bool by_keys = operation_.numbers.empty() && !searched(operation_);
    const std::string method = by_keys ? "keys and reasons" : "definition" + limit_;
    const std::string definition =
        by_keys ? method : "definition, " + counted_grouped(sum(&PositionCheck::graphs), "graph") + limit_;
    report("every valid configuration has a row", method, sum(&PositionCheck::valid),
           sum(&PositionCheck::Seconds::judging), sum(&PositionCheck::missing));
    report("every row has a valid configuration", method, certificate_.rows, 0, extra_);
    report("no port is taken, and ports that must stay are kept", "ports before and after compared",
           sum(&PositionCheck::with_row), 0, sum(&PositionCheck::wrong_ports));
    report("every row is sound", definition, sum(&PositionCheck::with_row), 0, sum(&PositionCheck::unsound));
    for (std::size_t i = 0; i < operation_.cost.size(); ++i) {
      Failures not_best;
      for (const PositionCheck& check : checks_) not_best.add(check.not_best[i]);
      std::string name = text_of(operation_.cost[i]);
      if (name.size() > 24) name = fmt::format("of criterion {}", i + 1);
      report(fmt::format("{} sound recolouring has fewer {}", i == 0 ? "no" : "as good, no", name), method,
             sum(&PositionCheck::with_row), 0, not_best);
    }
  }

  void report_reasons() const {
    if (!may_have_reasons(operation_)) return;
    const std::string method = rules_with_reason_ == 0 ? "the certificate gives none"
                                                       : fmt::format("{} by disjoint sets, {}, leaves up to {}",
                                                                     rules_with_reason_ - case_trees_,
                                                                     counted(case_trees_, "case tree"), most_cases_);
    report("every rule has a reason why nothing is preferred to it", method, rules_with_reason_,
           sum(&PositionCheck::Seconds::reasons), wrong_reasons_);
  }

  void report_bounds() const {
    bool bounded = false;
    Failures wrong;
    std::optional<int> worst_strips;
    std::optional<int> worst_isolated;
    const auto counted_change = [](int change, const char* what) {
      return fmt::format("{} {}{}", change, what, change == 1 ? "" : "s");
    };
    for (const PositionCheck& check : checks_) {
      const Operation& operation = *check.operation;
      bounded = bounded || operation.most_strips || operation.most_isolated;
      if (!check.worst_strips || !check.worst_isolated) continue;  // no row; another claim fails
      const int strips = *check.worst_strips;
      const int isolated = *check.worst_isolated;
      worst_strips = std::max(worst_strips.value_or(strips), strips);
      worst_isolated = std::max(worst_isolated.value_or(isolated), isolated);
      if (operation.most_isolated && isolated > *operation.most_isolated)
        wrong.add(fmt::format("{}: a rule isolates {} more, the family claims at most {}", operation.name(),
                              counted_change(isolated, "triangle"), *operation.most_isolated));
      if (operation.most_strips && strips > *operation.most_strips)
        wrong.add(fmt::format("{}: a rule costs {}, the family claims at most {}", operation.name(),
                              counted_change(strips, "strip"), *operation.most_strips));
    }
    if (bounded)
      report(fmt::format("no rule costs above {}, isolates above {}", counted_change(worst_strips.value_or(0), "strip"),
                         worst_isolated.value_or(0)),
             "maximum; and what the family claims", sum(&PositionCheck::with_sound_row), 0, wrong);
  }

  void report_published() const {
    Failures wrong;
    std::uint64_t cases = 0;
    for (const PositionCheck& check : checks_)
      for (const ReferenceCount& reference : reference_counts) {
        if (reference.operation != check.operation->name()) continue;
        const auto compare = [&](const char* what, std::optional<std::uint64_t> published, std::uint64_t found) {
          if (!published) return;
          ++cases;
          if (*published != found)
            wrong.add(
                fmt::format("{}: {}: {} published, {} counted", check.operation->name(), what, *published, found));
        };
        compare("configurations", reference.configurations, check.configurations);
        compare("valid", reference.valid, check.valid);
        compare("orbits", reference.orbits, check.orbits.all);
        compare("orbits of valid", reference.valid_orbits, check.orbits.valid);
        compare("costing", reference.costing, check.costing);
      }
    if (cases != 0) report("the published counts", "docs/explanation/theory.md, section 6", cases, 0, wrong);
  }

  const Family& family_;
  const Operation& operation_;
  const Certificate& certificate_;
  std::span<const PositionCheck> checks_;
  const ClaimListener& listener_;
  std::string limit_;  ///< a note, if not all positions are searched
  Failures extra_;
  Failures copies_;
  Failures claims_;
  Failures wrong_reasons_;
  std::uint64_t rules_with_reason_ = 0;
  std::uint64_t case_trees_ = 0;  ///< of them, those whose reason has cases
  std::size_t most_cases_ = 0;
  std::uint64_t stated_ = 0;
  double most_symmetries_ = 0;
  double section_seconds_ = 0;
};

}  // namespace

std::vector<PositionTask> tasks_of(const Family& family, const Certificate* certificate) {
  std::vector<PositionTask> tasks;
  for (std::size_t i = 0; i < family.sections.size(); ++i)
    for (const Operation& operation : family.sections[i].operations) {
      PositionTask& task = tasks.emplace_back();
      task.operation = &operation;
      if (certificate == nullptr) continue;
      task.rows = &certificate->sections[i];
      task.file = certificate->file;
    }
  return tasks;
}

void report_family(const Family& family, const Certificate& certificate, std::span<const PositionCheck> checks,
                   const ClaimListener& listener) {
  FamilyReport(family, certificate, checks, listener).run();
}

void report_images(const Family& family, const ClaimListener& listener) {
  if (family.unlisted.empty()) return;
  const double start = thread_seconds();
  Failures not_images;
  for (const Operation& operation : family.unlisted) {
    const auto serves = [&](const Operation& other) {
      return other.family == operation.family && isomorphic(operation, other);
    };
    if (std::none_of(family.sections.begin(), family.sections.end(), [&](const Section& section) {
          return std::any_of(section.operations.begin(), section.operations.end(), serves);
        }))
      not_images.add(fmt::format("{}: not listed, and not the image of a listed position", operation.name()));
  }
  listener({family.name, "positions without rules are images of ones with rules", "isomorphism of both sides",
            family.unlisted.size(), thread_seconds() - start, not_images});
}

}  // namespace restrip::verify
