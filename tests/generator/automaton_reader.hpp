// The automaton as a look-up will use it: forward over the letters, one meeting or closing, and back over the cases.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "automaton/automaton.hpp"
#include "configuration.hpp"
#include "patch.hpp"

namespace restrip::generator {

/// A recolouring with its cost as the automaton tells it: less the restarts of all triangles.
struct Answer {
  Mask recoloring = 0;
  int cost = 0;
};

class AutomatonReader {
 public:
  explicit AutomatonReader(const Automaton& automaton) : automaton_(automaton) {}

  /// What the automaton answers to a key of a fan family.
  [[nodiscard]] Answer answer(const Position& position, const Key& key) const {
    const unsigned k = position.k;
    const std::string& family = position.family->name;
    if (family == "split") {
      const Walk first = walk(letters(key, 0, position.at));
      const Walk second = walk(letters(key, position.at, k));
      const Meeting& met = meeting(first, second);
      const std::vector<bool> x = links(first, met.first);
      const std::vector<bool> y = links(second, met.second);
      // In ring order: A's edge is the first link, D's edges are the last link and the other arc's first.
      std::vector<bool> solid = x;
      solid.insert(solid.end(), y.begin(), y.end());
      solid.push_back(met.chord);
      return {mask(solid), cost(first, met.first) + cost(second, met.second) + cost_around(met)};
    }
    if (family == "collapse") {
      const Walk whole = walk(letters(key, 0, k));
      const Case closing = automaton_.classes[whole.classes.back()].closing.value();
      std::vector<bool> solid = links(whole, closing);
      solid.erase(solid.begin());  // it is the last one, too
      return {mask(solid), cost(whole, closing)};
    }
    if (family == "open-split") {
      const Walk first = walk(letters(key, position.at, position.to));
      std::vector<Letter> around = letters(key, position.to, k);
      around.push_back(Letter::boundary);
      for (const Letter letter : letters(key, 0, position.at)) around.push_back(letter);
      const Walk second = walk(around);
      const Meeting& met = meeting(first, second);
      const std::vector<bool> x = links(first, met.first);
      const std::vector<bool> y = links(second, met.second);
      // y: D's edge, those above, the boundary's two (dashed), those below, A's edge.
      const std::size_t above = k - position.to;
      std::vector<bool> solid;
      if (position.at > 0) solid.insert(solid.end(), y.begin() + static_cast<std::ptrdiff_t>(above) + 2, y.end());
      solid.insert(solid.end(), x.begin(), x.end());
      solid.insert(solid.end(), y.begin(), y.begin() + static_cast<std::ptrdiff_t>(above));
      solid.push_back(met.chord);
      return {mask(solid), cost(first, met.first) + cost(second, met.second) + cost_around(met)};
    }
    if (family == "boundary-split") {
      std::vector<Letter> path = letters(key, 0, k);
      path.insert(path.begin() + position.at, Letter::dashed);
      return open_path(path);
    }
    return open_path(letters(key, 0, k));
  }

 private:
  struct Walk {
    std::vector<Letter> letters;
    std::vector<std::size_t> classes;  ///< one more than letters
    int cost = 0;                      ///< of the best case
  };

  [[nodiscard]] static std::vector<Letter> letters(const Key& key, unsigned from, unsigned to) {
    std::vector<Letter> word;
    for (unsigned i = from; i < to; ++i)
      word.push_back((key.ports >> i & 1U) == 0    ? Letter::dashed
                     : (key.joined >> i & 1U) == 0 ? Letter::ends
                                                   : Letter::joined_ends);
    return word;
  }

  [[nodiscard]] const ArcStep& step_of(std::size_t arc_class, Letter letter) const {
    const std::vector<Letter>& all = letters_of(automaton_.weights);
    const auto place = static_cast<std::size_t>(std::find(all.begin(), all.end(), letter) - all.begin());
    return automaton_.classes[arc_class].steps[place].value();
  }

  [[nodiscard]] const Meeting& meeting(const Walk& first, const Walk& second) const {
    return automaton_
        .meets[automaton_.classes[first.classes.back()].as_first][automaton_.classes[second.classes.back()].as_second];
  }

  [[nodiscard]] int cost(const Walk& walk, Case c) const {
    return walk.cost + automaton_.classes[walk.classes.back()].costs[c].value();
  }

  /// What A, D and the edges that no arc counts add; without turns.
  [[nodiscard]] int cost_around(const Meeting& met) const {
    const auto solid = [](Reach reach) { return reach != Reach::dashed ? 1 : 0; };
    const int chord = met.chord ? 1 : 0;
    const int at_a = solid(left_of(met.first)) + solid(right_of(met.second)) + chord;
    const int at_d = solid(right_of(met.first)) + solid(left_of(met.second)) + chord;
    return automaton_.weights.isolated * ((at_a == 0 ? 1 : 0) + (at_d == 0 ? 1 : 0)) -
           automaton_.weights.restart * (solid(right_of(met.first)) + solid(right_of(met.second)) + chord);
  }

  [[nodiscard]] Walk walk(const std::vector<Letter>& letters) const {
    Walk walk{letters, {0}, {}};
    for (const Letter letter : letters) {
      const ArcStep& step = step_of(walk.classes.back(), letter);
      walk.cost += step.cost;
      walk.classes.push_back(step.to);
    }
    return walk;
  }

  /// The colours of the links before each letter and after the last one.
  [[nodiscard]] std::vector<bool> links(const Walk& walk, Case c) const {
    std::vector<bool> solid(walk.classes.size());
    solid.back() = right_of(c) != Reach::dashed;
    for (std::size_t m = walk.letters.size(); m-- > 0;) {
      c = step_of(walk.classes[m], walk.letters[m]).before[c];
      solid[m] = right_of(c) != Reach::dashed;
    }
    return solid;
  }

  [[nodiscard]] Answer open_path(const std::vector<Letter>& letters) const {
    const Walk whole = walk(letters);
    const std::vector<bool> all = links(whole, both_dashed);
    return {mask({all.begin() + 1, all.end() - 1}), cost(whole, both_dashed)};
  }

  [[nodiscard]] static Mask mask(const std::vector<bool>& solid) {
    Mask result = 0;
    for (std::size_t i = 0; i < solid.size(); ++i) result |= solid[i] ? Mask{1} << i : Mask{0};
    return result;
  }

  const Automaton& automaton_;
};

}  // namespace restrip::generator
