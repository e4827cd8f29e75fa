// What is still to be drawn at each vertex, for the orders of a vertex cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace restrip::detail {

/// By vertex, the numbers of the items that use it. Reading a list removes the items that have been drawn from it.
class UndrawnAt {
 public:
  /// `for_each_use` calls its argument with a vertex below `bound` and an item, for every use, and the same each time.
  template <class ForEachUse>
  void list(std::size_t bound, ForEachUse&& for_each_use) {
    first_.assign(bound + 1, 0);
    for_each_use([this](std::size_t v, std::uint32_t) { ++first_[v + 1]; });
    for (std::size_t v = 0; v < bound; ++v) first_[v + 1] += first_[v];
    items_.resize(first_.back());
    end_.assign(first_.begin(), first_.end() - 1);
    for_each_use([this](std::size_t v, std::uint32_t item) { items_[end_[v]++] = item; });
  }
  /// Ends if `visit` returns false.
  template <class Visit>
  void for_each(std::uint32_t v, const std::vector<bool>& drawn, Visit&& visit) {
    for (std::size_t i = first_[v]; i < end_[v];) {
      if (drawn[items_[i]])
        items_[i] = items_[--end_[v]];
      else if (!visit(items_[i++]))
        return;
    }
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::size_t> end_;
  std::vector<std::uint32_t> items_;
};

}  // namespace restrip::detail
