// The automaton as a look-up will use it: forward over the letters, one meeting or closing, and back over the cases.
#pragma once

#include <string>
#include <vector>

#include "automaton/automaton.hpp"
#include "configuration.hpp"
#include "patch.hpp"

namespace restrip::generator {

/// A recolouring with its value as the automaton tells it.
struct Answer {
  Mask recoloring = 0;
  Value value;
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
      const ValuedMeeting met = automaton_.meeting(first.classes.back(), second.classes.back());
      const std::vector<bool> x = links(first, met.meeting.first);
      const std::vector<bool> y = links(second, met.meeting.second);
      // In ring order: A's edge is the first link, D's edges are the last link and the other arc's first.
      std::vector<bool> solid = x;
      solid.insert(solid.end(), y.begin(), y.end());
      solid.push_back(met.meeting.chord);
      return {mask(solid), first.value + second.value + met.value};
    }
    if (family == "collapse") {
      const Walk whole = walk(letters(key, 0, k));
      const Closing& closing = automaton_.classes[whole.classes.back()].closing;
      std::vector<bool> solid = links(whole, closing.arc);
      solid.erase(solid.begin());  // it is the last one, too
      return {mask(solid), whole.value + closing.value};
    }
    if (family == "open-split") {
      const Walk first = walk(letters(key, position.at, position.to));
      std::vector<Letter> around = letters(key, position.to, k);
      around.push_back(Letter::boundary);
      for (const Letter letter : letters(key, 0, position.at)) around.push_back(letter);
      const Walk second = walk(around);
      const ValuedMeeting met = automaton_.meeting(first.classes.back(), second.classes.back());
      const std::vector<bool> x = links(first, met.meeting.first);
      const std::vector<bool> y = links(second, met.meeting.second);
      // y: D's edge, those above, the boundary's two (dashed), those below, A's edge.
      const std::size_t above = k - position.to;
      std::vector<bool> solid;
      if (position.at > 0) solid.insert(solid.end(), y.begin() + static_cast<std::ptrdiff_t>(above) + 2, y.end());
      solid.insert(solid.end(), x.begin(), x.end());
      solid.insert(solid.end(), y.begin(), y.begin() + static_cast<std::ptrdiff_t>(above));
      solid.push_back(met.meeting.chord);
      return {mask(solid), first.value + second.value + met.value};
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
    Value value;                       ///< of the best case
  };

  [[nodiscard]] static std::vector<Letter> letters(const Key& key, unsigned from, unsigned to) {
    std::vector<Letter> word;
    for (unsigned i = from; i < to; ++i)
      word.push_back((key.ports >> i & 1U) == 0    ? Letter::dashed
                     : (key.joined >> i & 1U) == 0 ? Letter::separate
                                                   : Letter::joined);
    return word;
  }

  [[nodiscard]] Walk walk(const std::vector<Letter>& letters) const {
    Walk walk{letters, {0}, {}};
    for (const Letter letter : letters) {
      const auto& step = automaton_.classes[walk.classes.back()].steps[static_cast<std::size_t>(letter)].value();
      walk.value = walk.value + step.gain;
      walk.classes.push_back(step.to);
    }
    return walk;
  }

  /// The colours of the links before each letter and after the last one.
  [[nodiscard]] std::vector<bool> links(const Walk& walk, Case c) const {
    std::vector<bool> solid(walk.classes.size());
    solid.back() = right_of(c) != Reach::dashed;
    for (std::size_t m = walk.letters.size(); m-- > 0;) {
      c = automaton_.classes[walk.classes[m]].steps[static_cast<std::size_t>(walk.letters[m])].value().before[c];
      solid[m] = right_of(c) != Reach::dashed;
    }
    return solid;
  }

  [[nodiscard]] Answer open_path(const std::vector<Letter>& letters) const {
    const Walk whole = walk(letters);
    const std::vector<bool> all = links(whole, both_dashed);
    const Value of_case = automaton_.classes[whole.classes.back()].values[both_dashed].value();
    return {mask({all.begin() + 1, all.end() - 1}), whole.value + of_case};
  }

  [[nodiscard]] static Mask mask(const std::vector<bool>& solid) {
    Mask result = 0;
    for (std::size_t i = 0; i < solid.size(); ++i) result |= solid[i] ? Mask{1} << i : Mask{0};
    return result;
  }

  const Automaton& automaton_;
};

}  // namespace restrip::generator
