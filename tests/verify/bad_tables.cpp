#include "bad_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify::test {
namespace {

using Visitor = std::function<bool(const BadTable&)>;

bool better(const Candidate& x, const Candidate& y) { return x.merit < y.merit; }

/// Damages to one section. Each function returns false when the visitor has seen enough.
class Section {
 public:
  Section(const NaiveSection& section, NaiveTable good, const Visitor& visit)
      : section_(section), good_(std::move(good)), visit_(visit) {
    for_each_valid(section, [&](const NaiveOperation& operation, NaiveColors before) {
      examples_.emplace(naive_key(operation, before), std::pair{&operation, before});
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

  /// For each dropped constraint the best that it kept out, where that is more than what it let in.
  bool unsound() {
    const std::map<std::string, Dropped> constraints = {
        {"all cycles dropped", Dropped::all_cycles},     {"outer cycle dropped", Dropped::outer_cycle},
        {"chord cycles dropped", Dropped::chord_cycles}, {"degrees dropped", Dropped::degrees},
        {"new degrees dropped", Dropped::new_degrees},   {"pairing dropped", Dropped::pairing}};
    for (const auto& [crime, dropped] : constraints)
      for (const auto& [key, example] : examples_) {
        const auto& [operation, before] = example;
        const std::vector<Candidate> sound = sound_recolorings(*operation, before);
        std::vector<Candidate> loose = sound_recolorings(*operation, before, dropped);
        std::erase_if(loose, [&](const Candidate& candidate) {
          return std::any_of(sound.begin(), sound.end(),
                             [&](const Candidate& other) { return other.colors == candidate.colors; });
        });
        if (loose.empty()) continue;
        const Candidate best = *std::max_element(loose.begin(), loose.end(), better);
        if (!replace(crime, "unsound row", key, best.colors)) return false;
      }
    return true;
  }

  /// Sound, but not the best.
  bool inferior() {
    for (const auto& entry : examples_) {
      const NaiveKey key = entry.first;
      const NaiveOperation* operation = entry.second.first;
      const NaiveColors before = entry.second.second;
      const std::vector<Candidate> sound = sound_recolorings(*operation, before);
      const Candidate best = *std::max_element(sound.begin(), sound.end(), better);
      const auto offer_best_of = [&](const char* crime, const char* expected, const auto& condition) {
        const Candidate* found = nullptr;
        for (const Candidate& candidate : sound)
          if (condition(candidate) && (found == nullptr || better(*found, candidate))) found = &candidate;
        return found == nullptr || replace(crime, expected, key, found->colors);
      };
      const int chord = operation->after.chord;
      const int last = (1 << operation->after.edges.size()) - 1;
      const bool go_on =
          offer_best_of("one edge short", "not optimal",
                        [&](const Candidate& c) { return c.merit[0] == best.merit[0] - 1; }) &&
          offer_best_of("chord avoided", "not optimal",
                        [&](const Candidate& c) {
                          return chord >= 0 && (c.colors.inner >> chord) % 2 == 0 && c.merit[0] < best.merit[0];
                        }) &&
          offer_best_of("all solid avoided", "not optimal",
                        [&](const Candidate& c) {
                          return best.colors.inner == last && c.colors.inner != last && c.merit[0] < best.merit[0];
                        }) &&
          offer_best_of(
              "lonelier", "lonelier than need be",
              [&](const Candidate& c) { return c.merit[0] == best.merit[0] && c.merit[1] < best.merit[1]; }) &&
          offer_best_of("ports given up", "gives up ports", [&](const Candidate& c) {
            return c.merit[0] == best.merit[0] && c.merit[1] == best.merit[1] && c.merit[2] < best.merit[2];
          });
      if (!go_on) return false;
    }
    return true;
  }

  /// Recolourings that are not the best, each with the reason that a careless checker would take for one.
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
        const std::vector<Candidate> sound = sound_recolorings(*operation, before);
        const Candidate best = *std::max_element(sound.begin(), sound.end(), better);
        const Careless careless = kind.second;
        const auto worse = std::find_if(sound.begin(), sound.end(), [&](const Candidate& candidate) {
          if (careless != Careless::only_dashed) return candidate.merit[0] == best.merit[0] - 1;
          return candidate.merit[0] == best.merit[0] && candidate.merit < best.merit;
        });
        if (worse == sound.end()) continue;
        const std::optional<std::string> reason = naive_reason(*operation, before, worse->colors, careless);
        if (!reason) continue;
        NaiveTable bad = good_;
        bad.rows[key] = {worse->colors, "", *reason};
        if (!offer(kind.first, text(key), "wrong reason", bad)) return false;
      }
    return true;
  }

  bool rows() {
    for (const auto& [key, row] : good_.rows) {
      NaiveTable bad = good_;
      bad.rows.erase(key);
      if (!bad.rows.empty() && !offer("missing row", text(key), "missing row", bad)) return false;
    }
    const int ports = 1 << section_.operations.front().before.port_owner.size();
    for (int first = 0; first < ports; ++first)
      for (int second = 0; second < (good_.flip ? 2 : ports); ++second) {
        if (good_.rows.contains({first, second})) continue;
        NaiveTable bad = good_;
        bad.rows[{first, second}] = {{0, first}, ""};
        if (!offer("extra row", text({first, second}), "extra row", bad)) return false;
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
      bad.rows[key].by = row.by.empty() ? "turn 0" : "";
      if (!offer("rule and copy swapped", text(key), "wrong representative", bad)) return false;
      if (row.by.empty()) continue;
      // A copy's key is never the representative's, so the identity is a wrong witness.
      bad.rows[key].by = "turn 0";
      if (!offer("wrong symmetry", text(key), "wrong witness", bad)) return false;
    }
    return true;
  }

  const NaiveSection& section_;
  NaiveTable good_;
  const Visitor& visit_;
  std::map<NaiveKey, std::pair<const NaiveOperation*, NaiveColors>> examples_;
};

}  // namespace

void for_each_bad_table(int max_k, const Visitor& visit) {
  for (const NaiveFamily& family : naive_families(max_k))
    for (const NaiveSection& section : family.sections)
      if (!Section(section, naive_table(family, section), visit).all()) return;
}

}  // namespace restrip::verify::test
