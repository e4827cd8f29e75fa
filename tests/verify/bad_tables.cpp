#include "bad_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify::test {
namespace {

using Visitor = std::function<bool(const BadTable&)>;

bool cheaper(const NaiveCandidate& x, const NaiveCandidate& y) { return x.cost < y.cost; }

/// Equal in all criteria before this one, and worse in it by `by`, or by any amount if `by` is 0.
bool worse_in(std::size_t criterion, const NaiveCandidate& candidate, const NaiveCandidate& best, long by = 0) {
  for (std::size_t i = 0; i < criterion; ++i)
    if (candidate.cost[i] != best.cost[i]) return false;
  const long more = candidate.cost[criterion] - best.cost[criterion];
  return by == 0 ? more > 0 : more == by;
}

/// Damages to one section. Each function returns false if the visitor wants to stop.
class DamagedSection {
 public:
  DamagedSection(const NaiveSection& section, NaiveTable good, const Visitor& visit)
      : section_(section), good_(std::move(good)), visit_(visit) {
    for_each_valid(section, [&](const NaiveOperation& operation, NaiveColors before) {
      examples_.emplace(operation.key(before), std::pair{&operation, before});
    });
  }

  bool all() { return unsound() && inferior() && reasons() && rows() && claims() && witnesses(); }

 private:
  bool offer(const std::string& kind, const std::string& where, const std::string& expected, const NaiveTable& table) {
    return visit_({kind, fmt::format("{} {}, {} {}", kind, where, good_.family, good_.position), expected, table});
  }

  static std::string text(NaiveKey key) { return fmt::format("{:x} {:x}", key.first, key.second); }

  bool replace(const std::string& crime, const std::string& expected, NaiveKey key, NaiveColors after) {
    NaiveTable bad = good_;
    bad.rows[key].after = after;
    return offer(crime, text(key), expected, bad);
  }

  /// For each dropped constraint, the best recolouring that it kept out, if that is better than the best one it
  /// allowed.
  bool unsound() {
    const std::map<std::string, Dropped> constraints = {
        {"all cycles dropped", Dropped::all_cycles},     {"outer cycle dropped", Dropped::outer_cycle},
        {"chord cycles dropped", Dropped::chord_cycles}, {"degrees dropped", Dropped::degrees},
        {"new degrees dropped", Dropped::new_degrees},   {"pairing dropped", Dropped::pairing}};
    for (const auto& [crime, dropped] : constraints)
      for (const auto& [key, example] : examples_) {
        const auto& [operation, before] = example;
        const std::vector<NaiveCandidate>& sound = sound_for(key);
        std::vector<NaiveCandidate> loose = operation->sound(before, dropped);
        std::erase_if(loose, [&](const NaiveCandidate& candidate) {
          return std::any_of(sound.begin(), sound.end(),
                             [&](const NaiveCandidate& other) { return other.after == candidate.after; });
        });
        if (loose.empty()) continue;
        const NaiveCandidate best = *std::min_element(loose.begin(), loose.end(), cheaper);
        if (!replace(crime, "unsound: ", key, best.after)) return false;
      }
    return true;
  }

  /// Sound, but not the best.
  bool inferior() {
    for (const auto& entry : examples_) {
      const NaiveKey key = entry.first;
      const std::vector<NaiveCandidate>& sound = sound_for(key);
      const NaiveCandidate best = *std::min_element(sound.begin(), sound.end(), cheaper);
      const auto offer_best_of = [&](const char* crime, std::size_t criterion, const auto& condition) {
        const NaiveCandidate* found = nullptr;
        for (const NaiveCandidate& candidate : sound)
          if (condition(candidate) && (found == nullptr || cheaper(candidate, *found))) found = &candidate;
        constexpr std::array expected = {"not best: strips is", "not best: isolated + given_up is",
                                         "not best: given_up is"};
        return found == nullptr || replace(crime, expected[criterion], key, found->after);
      };
      const Side& after = entry.second.first->operation().after;
      const auto edges = static_cast<int>(after.edges.size());
      const bool has_chord = edges != 0 && after.names.at(after.edges.back()[1]) == "D";
      const bool go_on =
          offer_best_of("one edge short", 0, [&](const NaiveCandidate& c) { return worse_in(0, c, best, 1); }) &&
          offer_best_of("chord avoided", 0,
                        [&](const NaiveCandidate& c) {
                          return has_chord && (c.after.inner >> (edges - 1)) % 2 == 0 && worse_in(0, c, best);
                        }) &&
          offer_best_of("all solid avoided", 0,
                        [&](const NaiveCandidate& c) {
                          return best.after.inner == (1 << edges) - 1 && c.after.inner != best.after.inner &&
                                 worse_in(0, c, best);
                        }) &&
          offer_best_of("lonelier", 1, [&](const NaiveCandidate& c) { return worse_in(1, c, best); }) &&
          offer_best_of("ports given up", 2, [&](const NaiveCandidate& c) { return worse_in(2, c, best); });
      if (!go_on) return false;
    }
    return true;
  }

  /// Recolourings that are not the best, each with a reason that a careless checker would accept.
  bool reasons() {
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
        const auto& [operation, before] = example;
        const std::vector<NaiveCandidate>& sound = sound_for(key);
        const NaiveCandidate best = *std::min_element(sound.begin(), sound.end(), cheaper);
        const Careless careless = kind.second;
        const auto worse = std::find_if(sound.begin(), sound.end(), [&](const NaiveCandidate& candidate) {
          if (careless != Careless::only_dashed) return worse_in(0, candidate, best, 1);
          return worse_in(1, candidate, best) || worse_in(2, candidate, best);
        });
        if (worse == sound.end()) continue;
        const std::optional<std::string> reason = naive_reason(*operation, before, worse->after, careless);
        if (!reason) continue;
        NaiveTable bad = good_;
        bad.rows[key] = {worse->after, {}, *reason};
        if (!offer(kind.first, text(key), "wrong reason", bad)) return false;
      }
    return true;
  }

  bool rows() {
    for (const auto& [key, row] : good_.rows) {
      NaiveTable bad = good_;
      bad.rows.erase(key);
      if (!bad.rows.empty() && !offer("missing row", text(key), "no row for the key", bad)) return false;
    }
    const int ports = section_.operations.front().ports();
    for (int first = 0; first < 1 << ports; ++first)
      for (int joined = 0; joined < 1 << ports * (ports - 1) / 2; ++joined) {
        if (good_.rows.contains({first, joined}) || __builtin_popcount(static_cast<unsigned>(joined)) > 2) continue;
        NaiveTable bad = good_;
        bad.rows[{first, joined}] = {{0, first}, {}, "-"};
        if (!offer("extra row", text({first, joined}), "extra row", bad)) return false;
      }
    return true;
  }

  bool claims() {
    for (std::size_t i = 0; i < good_.claims.size(); ++i)
      for (const int difference : {-1, 1}) {
        NaiveTable bad = good_;
        bad.claims[i].second += difference;
        if (!offer("wrong claim", bad.claims[i].first, "wrong claim", bad)) return false;
      }
    return true;
  }

  bool witnesses() {
    for (const auto& [key, row] : good_.rows) {
      NaiveTable bad = good_;
      const std::vector<int> identity = identity_of(section_.operations.front().ports());
      bad.rows[key].by = row.by.empty() ? identity : std::vector<int>{};
      bad.rows[key].because = row.by.empty() ? "" : "-";
      if (!offer("rule and copy swapped", text(key), "wrong representative", bad)) return false;
      if (row.by.empty()) continue;
      // A copy's key is never the representative's, so the identity is a wrong witness.
      bad.rows[key].by = identity;
      if (!offer("wrong symmetry", text(key), "wrong witness", bad)) return false;
    }
    return true;
  }

  static std::vector<int> identity_of(int ports) {
    std::vector<int> identity;
    for (int port = 0; port < ports; ++port) identity.push_back(port);
    return identity;
  }

  /// The sound recolourings of the example with this key.
  const std::vector<NaiveCandidate>& sound_for(NaiveKey key) {
    const auto [place, is_new] = sound_.try_emplace(key);
    if (is_new) place->second = examples_.at(key).first->sound(examples_.at(key).second);
    return place->second;
  }

  const NaiveSection& section_;
  NaiveTable good_;
  const Visitor& visit_;
  std::map<NaiveKey, std::pair<const NaiveOperation*, NaiveColors>> examples_;
  std::map<NaiveKey, std::vector<NaiveCandidate>> sound_;
};

}  // namespace

void for_each_bad_table(int max_k, const Visitor& visit) {
  for (const NaiveFamily& family : naive_families(max_k))
    for (const NaiveSection& section : family.sections)
      if (!DamagedSection(section, naive_table(family.name, section, true).value(), visit).all()) return;
}

}  // namespace restrip::verify::test
