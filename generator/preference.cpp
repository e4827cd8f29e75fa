#include "preference.hpp"

namespace restrip::generator {

std::int64_t tie_break(const Position&, const Side&, const Coloring& coloring, const Outcome&, Mask) {
  return coloring.inner;
}

}  // namespace restrip::generator
