#include "operations/operation_words.hpp"

#include <algorithm>
#include <stdexcept>

namespace restrip::generator {
namespace {

constexpr std::array<CountWord, 10> all_words{{{"strips", Count::strips, Among::nothing},
                                               {"isolated", Count::isolated, Among::nothing},
                                               {"given_up", Count::given_up, Among::nothing},
                                               {"kept", Count::kept, Among::ports},
                                               {"joined", Count::joined, Among::nothing},
                                               {"solid", Count::solid, Among::edges},
                                               {"ends", Count::ends, Among::triangles},
                                               {"ends_at_port", Count::ends_at_port, Among::triangles},
                                               {"neighbouring_ends", Count::neighbouring_ends, Among::nothing},
                                               {"squares", Count::squares, Among::nothing}}};

}  // namespace

std::span<const CountWord> count_words() { return all_words; }

const CountWord& word_of(Count count) {
  const auto* const found =
      std::find_if(all_words.begin(), all_words.end(), [&](const CountWord& word) { return word.count == count; });
  if (found == all_words.end()) throw std::logic_error("operation files have no word for this count");
  return *found;
}

std::string member_of(Among among) { return one_of(among) + "s"; }

std::string one_of(Among among) {
  switch (among) {
    case Among::edges:
      return "edge";
    case Among::triangles:
      return "triangle";
    case Among::ports:
      return "port";
    case Among::nothing:
      break;
  }
  throw std::logic_error("there is nothing to choose among");
}

std::size_t how_many(Among among, const Side& after) {
  switch (among) {
    case Among::edges:
      return after.edges.size();
    case Among::triangles:
      return after.nodes;
    case Among::ports:
      return after.owner.size();
    case Among::nothing:
      break;
  }
  return 0;
}

Mask everything(Among among, const Side& after) { return (Mask{1} << how_many(among, after)) - 1; }

}  // namespace restrip::generator
