// Linked rules against every recolouring there is: sound for whatever may lie out of sight, and none that is sound is
// better, be they from tables or searched. The test knows P' and Q as sets of pairs and follows them on a graph.
#include "restrip/operations/linked.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <random>
#include <vector>

#include "naive_patch.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using naive::Bits;
using naive::Pairs;

// One colouring after the operation.
struct Candidate {
  Word inner;
  long value;
  Pairs pairs;
};

std::vector<Candidate> candidates(const naive::Patch& after, const Bits& ports) {
  std::vector<Candidate> all;
  for (Word inner = 0; inner < bit(after.edges.size()); ++inner) {
    const naive::Analysis found = naive::analyze(after, naive::bits_of(inner, after.edges.size()), ports);
    if (found.valid) all.push_back({inner, found.value(), found.joined});
  }
  return all;
}

// Of each port, the one that it is joined to.
std::vector<int> partners(std::size_t k, const Pairs& pairs) {
  std::vector<int> partner(k, strip_ends);
  for (const auto& [i, j] : pairs) {
    partner[i] = static_cast<int>(j);
    partner[j] = static_cast<int>(i);
  }
  return partner;
}

// Pairs inside and pairs outside, each port at most once in each: does their union have a cycle?
bool closes_cycle(std::size_t k, const Pairs& inside, const Pairs& outside) {
  naive::UnionFind paths(k);
  for (const Pairs* pairs : {&inside, &outside})
    for (const auto& [i, j] : *pairs)
      if (!paths.unite(i, j)) return true;
  return false;
}

// Every way to pair some of the ports.
void for_each_matching(std::vector<std::size_t> ports, const Pairs& so_far,
                       const std::function<void(const Pairs&)>& f) {
  if (ports.empty()) {
    f(so_far);
    return;
  }
  const std::size_t first = ports.back();
  ports.pop_back();
  for_each_matching(ports, so_far, f);
  for (std::size_t i = 0; i < ports.size(); ++i) {
    std::vector<std::size_t> rest = ports;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    Pairs more = so_far;
    more.emplace(std::min(first, ports[i]), std::max(first, ports[i]));
    for_each_matching(rest, more, f);
  }
}

std::vector<Pairs> matchings(const Bits& ports) {
  std::vector<std::size_t> solid;
  for (std::size_t i = 0; i < ports.size(); ++i)
    if (ports[i]) solid.push_back(i);
  std::vector<Pairs> all;
  for_each_matching(solid, {}, [&](const Pairs& pairs) { all.push_back(pairs); });
  return all;
}

using Look = std::function<int(std::size_t)>;

/// One operation: the patch before, the patch after, the rule, and the search that serves where there are no tables.
struct Case {
  std::size_t k;
  naive::Patch before;
  naive::Patch after;
  std::function<Rule(Word before, Word ports, const Look&)> rule;
  std::function<Rule(Word before, Word ports, const Look&)> search;
};

class Judge {
 public:
  explicit Judge(Case the_case) : case_(std::move(the_case)) {}

  /// Every configuration in every world that it allows, and with every set of ports out of sight; of these only
  /// one in `one_in`.
  void all(unsigned one_in) {
    for (Word ports = 0; ports < bit(case_.k); ++ports) {
      const Bits port_bits = naive::bits_of(ports, case_.k);
      const std::vector<Candidate> choices = candidates(case_.after, port_bits);
      const std::vector<Pairs> outsides = matchings(port_bits);
      for (Word before = 0; before < bit(case_.before.edges.size()); ++before) {
        const naive::Analysis now =
            naive::analyze(case_.before, naive::bits_of(before, case_.before.edges.size()), port_bits);
        if (!now.valid) continue;
        std::vector<Pairs> possible;
        for (const Pairs& outside : outsides)
          if (!closes_cycle(case_.k, now.joined, outside)) possible.push_back(outside);
        for (const Pairs& outside : possible)
          for (Word hidden = ports;; hidden = (hidden - 1) & ports) {
            if (random_() % one_in == 0) one(before, ports, outside, hidden, choices, possible);
            if (hidden == 0) break;
          }
      }
    }
    EXPECT_GT(looked_, 0U);
  }
  [[nodiscard]] std::size_t better_than_local() const { return better_than_local_; }

 private:
  // A port is out of sight when it or its partner is hidden: a walk is as long from either side.
  void one(Word before, Word ports, const Pairs& outside, Word hidden, const std::vector<Candidate>& choices,
           const std::vector<Pairs>& possible) {
    std::vector<int> seen = partners(case_.k, outside);
    for (std::size_t i = 0; i < case_.k; ++i)
      if (has(hidden, i)) {
        if (seen[i] >= 0) seen[static_cast<std::size_t>(seen[i])] = out_of_sight;
        seen[i] = out_of_sight;
      }
    // All outsides that look the same.
    std::vector<const Pairs*> alike;
    for (const Pairs& other : possible) {
      bool same = true;
      const std::vector<int> partner = partners(case_.k, other);
      for (std::size_t i = 0; i < case_.k; ++i)
        same = same &&
               (seen[i] == out_of_sight ? partner[i] < 0 || seen[static_cast<std::size_t>(partner[i])] == out_of_sight
                                        : partner[i] == seen[i]);
      if (same) alike.push_back(&other);
    }
    const auto sound = [&](const Candidate& choice) {
      for (const Pairs* other : alike)
        if (closes_cycle(case_.k, choice.pairs, *other)) return false;
      return true;
    };
    std::vector<int> asked(case_.k, 0);
    const Rule rule = case_.rule(before, ports, [&](std::size_t i) {
      EXPECT_TRUE(has(ports, i));
      EXPECT_EQ(asked[i]++, 0);
      return seen[i];
    });
    const Candidate* chosen = nullptr;
    const Candidate* best = nullptr;
    for (const Candidate& choice : choices) {
      if (choice.inner == rule.colors) chosen = &choice;
      if ((best == nullptr || choice.value > best->value) && sound(choice)) best = &choice;
    }
    ++looked_;
    ASSERT_TRUE(rule.valid);
    ASSERT_NE(chosen, nullptr) << "illegal";
    ASSERT_TRUE(sound(*chosen));
    ASSERT_EQ(chosen->value, best->value);
    const Rule searched = case_.search(before, ports, [&](std::size_t i) { return seen[i]; });
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&](const Candidate& choice) { return choice.inner == searched.colors; });
    ASSERT_TRUE(found != choices.end());
    ASSERT_EQ(found->value, best->value);
    ASSERT_EQ(searched.strips, rule.strips);
    bool new_pair = false;
    const naive::Analysis now =
        naive::analyze(case_.before, naive::bits_of(before, case_.before.edges.size()), naive::bits_of(ports, case_.k));
    for (const auto& pair : chosen->pairs) new_pair = new_pair || now.joined.count(pair) == 0;
    better_than_local_ += new_pair ? 1 : 0;
  }

  Case case_;
  std::mt19937 random_{3};
  std::size_t looked_ = 0;
  std::size_t better_than_local_ = 0;
};

Case split_case(std::size_t k, std::size_t a) {
  return {k, naive::closed_fan(k), naive::ring_with_chord(k, a),
          [=](Word loop, Word ports, const Look& look) {
            return linked_split_rule({k, a}, loop, ports, look);
          },
          [=](Word loop, Word ports, const Look& look) {
            return detail::searched_rule(detail::closed_fan(k), loop, detail::ring_with_chord(k, a), ports, look);
          }};
}

Case collapse_case(std::size_t k, std::size_t a) {
  return {k, naive::ring_with_chord(k, a), naive::closed_fan(k),
          [=](Word inner, Word ports, const Look& look) {
            return linked_collapse_rule({k, a}, inner, ports, look);
          },
          [=](Word inner, Word ports, const Look& look) {
            return detail::searched_rule(detail::ring_with_chord(k, a), inner, detail::closed_fan(k), ports, look);
          }};
}

TEST(LinkedRules, AreSoundAndOptimalForAllThatMayBeOutside) {
  std::size_t better = 0;
  for (std::size_t k = 3; k <= 4; ++k)
    for (std::size_t a = 1; a < k; ++a)
      for (const auto& make : {split_case, collapse_case}) {
        Judge judge(make(k, a));
        judge.all(1);
        better += judge.better_than_local();
      }
  EXPECT_GT(better, 0U);
}

TEST(LinkedRules, AreSoundAndOptimalInLargerFans) {
  for (const std::size_t k : {5U, 6U})
    for (std::size_t a = 1; a < k; ++a)
      for (const auto& make : {split_case, collapse_case}) Judge(make(k, a)).all(k == 5 ? 5 : 300);
}

TEST(LinkedRules, AreTheLocalOnesWhenNothingIsSeen) {
  const auto blind = [](std::size_t) { return out_of_sight; };
  for (std::size_t k = 3; k <= 6; ++k)
    for (std::size_t a = 1; a < k; ++a)
      for (Word ports = 0; ports < bit(k); ++ports) {
        const auto same = [&](const Rule& linked, const Rule& local, const naive::Patch& after) {
          ASSERT_EQ(linked.valid, local.valid);
          ASSERT_EQ(linked.strips, local.strips);
          const auto isolated = [&](Word colors) {
            return naive::analyze(after, naive::bits_of(colors, after.edges.size()), naive::bits_of(ports, k)).isolated;
          };
          if (local.valid) {
            ASSERT_EQ(isolated(linked.colors), isolated(local.colors));
          }
        };
        for (Word loop = 0; loop < bit(k); ++loop)
          same(linked_split_rule({k, a}, loop, ports, blind), split_rule({k, a}, loop, ports),
               naive::ring_with_chord(k, a));
        for (Word inner = 0; inner < bit(k + 3); ++inner)
          same(linked_collapse_rule({k, a}, inner, ports, blind), collapse_rule({k, a}, inner, ports),
               naive::closed_fan(k));
      }
}

static_assert(linked_split_rule({4, 2}, 0, 0b1111, [](std::size_t) { return strip_ends; }).strips <
                  split_rule({4, 2}, 0, 0b1111).strips,
              "four strips that end outside can be joined in pairs");

}  // namespace
}  // namespace restrip
