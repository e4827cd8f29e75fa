// In place of common/share.hpp: one thread does all the work.
#pragma once
#include <cstddef>

namespace restrip {

template <class Work>
void share(std::size_t count, unsigned /*threads*/, const Work& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

}  // namespace restrip
