// The checker accepts good tables, and rejects every bad one for the right reason. Wrong tables are aimed at one check
// each: for every constraint and every key, the optimum that a checker without the constraint would accept. Random
// damage does not find such checkers.

#include "corpus.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <numeric>

#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

TEST(Corpus, GoodTablesHold) {
  for (const NaiveFamily& family : naive_families(corpus_max_k))
    for (const NaiveSection& section : family.sections) {
      const Verdict verdict = verdict_of(naive_table(family.name, section, true).value());
      EXPECT_EQ(verdict.exit_code, 0) << verdict.text;
    }
}

TEST(Corpus, SmallTablesHold) {
  const Verdict verdict = verdict_of(small_tables());
  EXPECT_EQ(verdict.exit_code, 0) << verdict.text;
}

bool cheaper(const NaiveCandidate& x, const NaiveCandidate& y) { return x.cost < y.cost; }

/// Equal in all criteria before this one, and worse in it by `by`, or by any amount if `by` is 0.
bool worse_in(std::size_t criterion, const NaiveCandidate& candidate, const NaiveCandidate& best, long by = 0) {
  for (std::size_t i = 0; i < criterion; ++i)
    if (candidate.cost[i] != best.cost[i]) return false;
  const long more = candidate.cost[criterion] - best.cost[criterion];
  return by == 0 ? more > 0 : more == by;
}

std::string key_text(NaiveKey key) { return fmt::format("{:x} {:x}", key.first, key.second); }

/// One section with its good table, to be damaged.
class DamagedSection {
 public:
  /// Counts the wrong tables by their kind.
  DamagedSection(const std::string& family, const NaiveSection& section, std::map<std::string, int>& kinds)
      : section_(section), good_(naive_table(family, section, true).value()), kinds_(kinds) {
    for_each_valid(section, [&](const NaiveOperation& operation, NaiveColors before) {
      const NaiveKey key = operation.key(before);
      if (examples_.contains(key)) return;
      const std::vector<NaiveCandidate> sound = operation.sound(before);
      examples_[key] = {&operation, before, sound, *std::min_element(sound.begin(), sound.end(), cheaper)};
    });
  }

  /// For each dropped constraint, the best recolouring that it kept out, if that is better than the best one it
  /// allowed.
  void unsound() const {
    const std::map<std::string, Dropped> constraints = {
        {"all cycles dropped", Dropped::all_cycles},     {"outer cycle dropped", Dropped::outer_cycle},
        {"chord cycles dropped", Dropped::chord_cycles}, {"degrees dropped", Dropped::degrees},
        {"new degrees dropped", Dropped::new_degrees},   {"pairing dropped", Dropped::pairing}};
    for (const auto& [crime, dropped] : constraints)
      for (const auto& [key, example] : examples_) {
        std::vector<NaiveCandidate> loose = example.operation->sound(example.before, dropped);
        std::erase_if(loose, [&sound = example.sound](const NaiveCandidate& candidate) {
          return std::any_of(sound.begin(), sound.end(),
                             [&](const NaiveCandidate& other) { return other.after == candidate.after; });
        });
        if (loose.empty()) continue;
        expect_rejected(crime, key, "unsound: ", std::min_element(loose.begin(), loose.end(), cheaper)->after);
      }
  }

  /// Sound, but not the best.
  void inferior() const {
    for (const auto& entry : examples_) {
      const Example& example = entry.second;
      const NaiveCandidate& best = example.best;
      const auto offer_best_of = [&](const char* crime, std::size_t criterion, const auto& condition) {
        const NaiveCandidate* found = nullptr;
        for (const NaiveCandidate& candidate : example.sound)
          if (condition(candidate) && (found == nullptr || cheaper(candidate, *found))) found = &candidate;
        constexpr std::array expected = {"not best: strips is", "not best: isolated + given_up is",
                                         "not best: given_up is"};
        if (found != nullptr) expect_rejected(crime, entry.first, expected[criterion], found->after);
      };
      const Side& after = example.operation->operation().after;
      const auto edges = static_cast<int>(after.edges.size());
      // Of the patches by hand only the flip's triangles have no names, and it has no chord.
      const bool has_chord = edges != 0 && !after.names.empty() && after.names.at(after.edges.back()[1]) == "D";
      offer_best_of("one edge short", 0, [&](const NaiveCandidate& c) { return worse_in(0, c, best, 1); });
      offer_best_of("chord avoided", 0, [&](const NaiveCandidate& c) {
        return has_chord && (c.after.inner >> (edges - 1)) % 2 == 0 && worse_in(0, c, best);
      });
      offer_best_of("all solid avoided", 0, [&](const NaiveCandidate& c) {
        return best.after.inner == (1 << edges) - 1 && c.after.inner != best.after.inner && worse_in(0, c, best);
      });
      offer_best_of("lonelier", 1, [&](const NaiveCandidate& c) { return worse_in(1, c, best); });
      offer_best_of("ports given up", 2, [&](const NaiveCandidate& c) { return worse_in(2, c, best); });
    }
  }

  /// Recolourings that are not the best, each with a reason that a careless checker would accept.
  void reasons() const {
    const std::map<std::string, Careless> kinds = {{"reason off by one", Careless::off_by_one},
                                                   {"reason for dashed edges only", Careless::only_dashed},
                                                   {"sets that may be solid", Careless::sound_sets},
                                                   {"overlapping sets", Careless::overlapping_sets},
                                                   {"dashed edge counted twice", Careless::count_dashed_twice},
                                                   {"foreign edges", Careless::foreign_edges},
                                                   {"solid case skipped", Careless::skip_solid_case},
                                                   {"dashed case skipped", Careless::skip_dashed_case},
                                                   {"solid in both cases", Careless::solid_in_both_cases}};
    for (const auto& kind : kinds)
      for (const auto& [key, example] : examples_) {
        if (!good_.rows.at(key).by.empty()) continue;
        const Careless careless = kind.second;
        const auto worse = std::find_if(example.sound.begin(), example.sound.end(),
                                        [&best = example.best, careless](const NaiveCandidate& other) {
                                          if (careless != Careless::only_dashed) return worse_in(0, other, best, 1);
                                          return worse_in(1, other, best) || worse_in(2, other, best);
                                        });
        if (worse == example.sound.end()) continue;
        const auto reason = naive_reason(*example.operation, example.before, worse->after, careless);
        if (!reason) continue;
        NaiveTable bad = good_;
        bad.rows[key] = {worse->after, {}, *reason};
        expect_rejected(kind.first, key_text(key), "wrong reason", bad);
      }
  }

  void rows() const {
    for (const auto& [key, row] : good_.rows) {
      NaiveTable bad = good_;
      bad.rows.erase(key);
      if (!bad.rows.empty()) expect_rejected("missing row", key_text(key), "no row for the key", bad);
    }
    const int ports = section_.operations.front().ports();
    for (int first = 0; first < 1 << ports; ++first)
      for (int joined = 0; joined < 1 << ports * (ports - 1) / 2; ++joined) {
        if (good_.rows.contains({first, joined}) || __builtin_popcount(static_cast<unsigned>(joined)) > 2) continue;
        NaiveTable bad = good_;
        bad.rows[{first, joined}] = {{0, first}, {}, "-"};
        expect_rejected("extra row", key_text({first, joined}), "extra row", bad);
      }
  }

  void claims() const {
    for (std::size_t i = 0; i < good_.claims.size(); ++i)
      for (const int difference : {-1, 1}) {
        NaiveTable bad = good_;
        bad.claims[i].second += difference;
        expect_rejected("wrong claim", bad.claims[i].first, "wrong claim", bad);
      }
  }

  void witnesses() const {
    std::vector<int> identity(static_cast<std::size_t>(section_.operations.front().ports()));
    std::iota(identity.begin(), identity.end(), 0);
    for (const auto& [key, row] : good_.rows) {
      NaiveTable bad = good_;
      bad.rows[key].by = row.by.empty() ? identity : std::vector<int>{};
      bad.rows[key].because = row.by.empty() ? "" : "-";
      expect_rejected("rule and copy swapped", key_text(key), "wrong representative", bad);
      if (row.by.empty()) continue;
      // A copy's key is never the representative's, so the identity is a wrong witness.
      bad.rows[key].by = identity;
      expect_rejected("wrong symmetry", key_text(key), "wrong witness", bad);
    }
  }

 private:
  /// A configuration with its sound recolourings.
  struct Example {
    const NaiveOperation* operation = nullptr;
    NaiveColors before;
    std::vector<NaiveCandidate> sound;
    NaiveCandidate best;
  };

  void expect_rejected(const std::string& kind, const std::string& where, const std::string& expected,
                       const NaiveTable& table) const {
    ++kinds_[kind];
    if (testing::Test::HasFailure()) return;  // the first one is enough
    const Verdict verdict = verdict_of(table);
    const std::string crime = fmt::format("{} {}, {} {}", kind, where, good_.family, good_.position);
    EXPECT_EQ(verdict.exit_code, 1) << crime;
    EXPECT_TRUE(verdict.says(expected)) << crime << ": expected " << expected << "\n" << verdict.text;
  }
  void expect_rejected(const std::string& crime, NaiveKey key, const std::string& expected, NaiveColors after) const {
    NaiveTable bad = good_;
    bad.rows[key].after = after;
    expect_rejected(crime, key_text(key), expected, bad);
  }

  const NaiveSection& section_;
  NaiveTable good_;
  std::map<std::string, int>& kinds_;
  std::map<NaiveKey, Example> examples_;
};

// One table for each constraint and case; each must be rejected for its own fault.
TEST(Corpus, TargetedBadTablesAreRejected) {
  std::map<std::string, int> kinds;
  for (const NaiveFamily& family : naive_families(corpus_max_k))
    for (const NaiveSection& section : family.sections) {
      const DamagedSection damaged(family.name, section, kinds);
      damaged.unsound();
      damaged.inferior();
      damaged.reasons();
      damaged.rows();
      damaged.claims();
      damaged.witnesses();
    }
  for (const char* kind :
       {"all cycles dropped", "outer cycle dropped", "chord cycles dropped", "degrees dropped", "new degrees dropped",
        "pairing dropped", "one edge short", "chord avoided", "all solid avoided", "lonelier"})
    EXPECT_GT(kinds[kind], 0) << kind;
  for (const auto& [kind, count] : kinds) std::cout << count << " x " << kind << '\n';
}

TEST(Corpus, DamagedFilesAreRejected) {
  const std::vector<Damage> all = damages();
  EXPECT_GE(all.size(), 82U);
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("restrip-corpus-{}", getpid());
  for (const Damage& damage : all) {
    make_damaged_tables(damage, folder);
    const Verdict verdict = verdict_of(folder);
    EXPECT_EQ(verdict.exit_code, damage.exit_code) << damage.name << "\n" << verdict.text;
    EXPECT_TRUE(verdict.says(damage.message)) << damage.name << ": expected \"" << damage.message << "\"\n"
                                              << verdict.text;
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace restrip::verify::test
