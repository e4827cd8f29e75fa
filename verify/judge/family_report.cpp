#include "judge/family_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/counted.hpp"
#include "judge/reference.hpp"
#include "judge/report.hpp"
#include "judge/section_check.hpp"

namespace restrip::verify {
namespace {

class FamilyReport {
 public:
  FamilyReport(const Family& family, const Certificate* certificate, std::span<const PositionCheck> checks,
               const ClaimListener& listener)
      : family_(family),
        operation_(family.sections.front().operations.front()),
        certificate_(certificate),
        checks_(checks),
        listener_(listener) {
    for (const Section& section : family.sections)
      for (const Operation& operation : section.operations)
        if (!searched(operation)) limit_ = fmt::format(", k <= {}", most_searched_ports);
  }

  void run() {
    if (certificate_ == nullptr) return;
    check_sections();
    report_rows();
    report_reasons();
    report("copies follow from rules by symmetry",
           fmt::format("{:.0f} {} at most, by backtracking", most_symmetries_,
                       most_symmetries_ == 1 ? "symmetry" : "symmetries"),
           certificate_->rows, section_seconds_, copies_);
    report("the stated numbers", "recounted; orbits by merging images", stated_, sum(&PositionCheck::Seconds::merged),
           claims_);
    report_nauty();
    report_bounds();
    report_published();
  }

 private:
  void report(const std::string& claim, const std::string& method, std::uint64_t cases, double seconds,
              const Failures& failures) const {
    listener_({family_.name, claim, method, cases, seconds, failures.count, failures.first});
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
  /// Calls back with each position and its results.
  template <class Visit>
  void for_each_position(const Visit& visit) const {
    auto check = checks_.begin();
    for (const Section& section : family_.sections)
      for (const Operation& operation : section.operations) visit(operation, *check++);
  }

  void check_sections() {
    const double start = thread_seconds();
    std::size_t first = 0;
    for (std::size_t i = 0; i < family_.sections.size(); ++i) {
      const Section& section = family_.sections[i];
      const CheckedSection checked{section, certificate_->sections[i],
                                   checks_.subspan(first, section.operations.size()), certificate_->file};
      first += section.operations.size();
      const Symmetries symmetries(section.operations.front(), section.serves_every_position
                                                                  ? Symmetries::Keep::after
                                                                  : Symmetries::Keep::both_sides);
      most_symmetries_ = std::max(most_symmetries_, symmetries.order());
      extra_.add(extra_rows(checked));
      copies_.add(wrong_copies(checked, symmetries));
      claims_.add(wrong_claims(checked));
      stated_ += claim_words.size();
      tally_reasons(checked, reasons_);
    }
    section_seconds_ = thread_seconds() - start;
  }

  void report_rows() const {
    const std::string definition = "definition, " + counted_grouped(sum(&PositionCheck::graphs), "graph") + limit_;
    report("every valid configuration has a row", "definition" + limit_, sum(&PositionCheck::valid),
           sum(&PositionCheck::Seconds::judging), sum(&PositionCheck::missing));
    report("every row has a valid configuration", "definition" + limit_, certificate_->rows, 0, extra_);
    report("no port is taken, and ports that must stay are kept", "ports before and after compared",
           sum(&PositionCheck::with_row), 0, sum(&PositionCheck::wrong_ports));
    report("every row is sound", definition, sum(&PositionCheck::with_row), 0, sum(&PositionCheck::unsound));
    for (std::size_t i = 0; i < operation_.cost.size(); ++i) {
      Failures not_best;
      for (const PositionCheck& check : checks_) not_best.add(check.not_best[i]);
      std::string name = text_of(operation_.cost[i]);
      if (name.size() > 24) name = fmt::format("of criterion {}", i + 1);
      report(fmt::format("{} sound recolouring has fewer {}", i == 0 ? "no" : "as good, no", name),
             "definition" + limit_, sum(&PositionCheck::with_row), 0, not_best);
    }
  }

  void report_reasons() const {
    if (!may_have_reasons(operation_)) return;
    const std::string method =
        reasons_.rules == 0 ? "the certificate gives none"
                            : fmt::format("{} by disjoint sets, {}, leaves up to {}", reasons_.rules - reasons_.trees,
                                          counted(reasons_.trees, "case tree"), reasons_.most_cases);
    report("every rule has a reason why nothing is preferred to it", method, reasons_.rules,
           sum(&PositionCheck::Seconds::reasons), reasons_.wrong);
  }

  void report_nauty() const {
    Failures orbits;
    std::uint64_t counted = 0;
    for_each_position([&](const Operation& operation, const PositionCheck& check) {
      if (!check.nauty) return;
      counted += check.configurations;
      if (check.merged != *check.nauty)
        orbits.add(fmt::format("{}: {} orbits, {} valid by merging images; {}, {} by canonical forms", operation.name(),
                               check.merged.all, check.merged.valid, check.nauty->all, check.nauty->valid));
    });
    if (counted != 0)
      report("the orbits, counted again", "nauty, canonical coloured graphs" + limit_, counted,
             sum(&PositionCheck::Seconds::nauty), orbits);
  }

  void report_bounds() const {
    bool bounded = false;
    for_each_position([&](const Operation& operation, const PositionCheck& /*check*/) {
      bounded = bounded || operation.most_strips || operation.most_isolated;
    });
    if (!bounded) return;
    Failures wrong;
    int worst_strips = 0;
    int worst_isolated = 0;
    for_each_position([&](const Operation& operation, const PositionCheck& check) {
      const int strips = check.worst_strips.value_or(0);
      const int isolated = check.worst_isolated.value_or(0);
      worst_strips = std::max(worst_strips, strips);
      worst_isolated = std::max(worst_isolated, isolated);
      if (operation.most_isolated && isolated > *operation.most_isolated)
        wrong.add(fmt::format("{}: a rule isolates {} more, the family claims at most {}", operation.name(),
                              counted(static_cast<std::uint64_t>(isolated), "triangle"), *operation.most_isolated));
      if (operation.most_strips && strips > *operation.most_strips)
        wrong.add(fmt::format("{}: a rule costs {}, the family claims at most {}", operation.name(),
                              counted(static_cast<std::uint64_t>(strips), "strip"), *operation.most_strips));
    });
    report(fmt::format("no rule costs above {}, isolates above {}",
                       counted(static_cast<std::uint64_t>(worst_strips), "strip"), worst_isolated),
           "maximum; and what the family claims", sum(&PositionCheck::with_sound_row), 0, wrong);
  }

  void report_published() const {
    Failures wrong;
    std::uint64_t cases = 0;
    for_each_position([&](const Operation& operation, const PositionCheck& check) {
      for (const ReferenceCount& reference : reference_counts) {
        if (reference.operation != operation.name()) continue;
        const auto compare = [&](const char* what, std::optional<std::uint64_t> published, std::uint64_t counted) {
          if (!published) return;
          ++cases;
          if (*published != counted)
            wrong.add(fmt::format("{}: {}: {} published, {} counted", operation.name(), what, *published, counted));
        };
        compare("configurations", reference.configurations, check.configurations);
        compare("valid", reference.valid, check.valid);
        compare("orbits", reference.orbits, check.merged.all);
        compare("orbits of valid", reference.valid_orbits, check.merged.valid);
        compare("costing", reference.costing, check.costing);
      }
    });
    if (cases != 0) report("the published counts", "docs/explanation/theory.md, section 6", cases, 0, wrong);
  }

  const Family& family_;
  const Operation& operation_;
  const Certificate* certificate_;
  std::span<const PositionCheck> checks_;
  const ClaimListener& listener_;
  std::string limit_;  ///< a note, if not all positions are searched
  Failures extra_;
  Failures copies_;
  Failures claims_;
  ReasonTally reasons_;
  std::uint64_t stated_ = 0;
  double most_symmetries_ = 0;
  double section_seconds_ = 0;
};

}  // namespace

std::vector<PositionTask> tasks_of(const Family& family, const Certificate* certificate) {
  std::vector<PositionTask> tasks;
  for (std::size_t i = 0; i < family.sections.size(); ++i)
    for (const Operation& operation : family.sections[i].operations) {
      PositionTask task{&family.sections[i], &operation, nullptr, {}};
      if (certificate != nullptr) {
        task.rows = &certificate->sections[i];
        task.file = certificate->file;
      }
      tasks.push_back(task);
    }
  return tasks;
}

void report_family(const Family& family, const Certificate* certificate, std::span<const PositionCheck> checks,
                   const ClaimListener& listener) {
  FamilyReport(family, certificate, checks, listener).run();
}

}  // namespace restrip::verify
