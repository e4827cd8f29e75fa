// Delta debugging (Zeller and Hildebrandt 2002): a short sublist that still fails.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace restrip::tools {

/// A sublist of `items` that fails, in the same order. `items` itself must fail. No single item can be removed from the
/// result, unless `tries` calls of fails() did not suffice.
template <class Item, class Fails>
std::vector<Item> shrink(std::vector<Item> items, Fails&& fails, std::size_t tries) {
  for (std::size_t chunk = std::max<std::size_t>(1, items.size() / 2);;) {
    bool shorter = false;
    // From the end: later operations are more often irrelevant.
    for (std::size_t stop = items.size(); stop > 0 && tries > 0;) {
      const std::size_t start = stop > chunk ? stop - chunk : 0;
      std::vector<Item> rest(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(start));
      rest.insert(rest.end(), items.begin() + static_cast<std::ptrdiff_t>(stop), items.end());
      --tries;
      if (fails(rest)) {
        items = std::move(rest);
        shorter = true;
      }
      stop = start;
    }
    if (tries == 0 || (chunk == 1 && !shorter)) return items;
    if (!shorter) chunk = std::max<std::size_t>(1, chunk / 2);
    chunk = std::min(chunk, std::max<std::size_t>(1, items.size()));
  }
}

}  // namespace restrip::tools
