#include "replay/maintainer.hpp"

namespace restrip::tools {

void Maintainer::play_up(std::span<const Record> records, std::size_t first) {
  for (const Record& record : records) {
    split_silently(spokes_of(mesh_, record), record.v_t, first++);
    between();
  }
}

void Maintainer::play_down(std::span<const Record> records, std::size_t first) {
  for (std::size_t i = records.size(); i-- > 0;) {
    collapse_silently(mesh_.spoke(records[i].v_s, records[i].v_t), first + i);
    between();
  }
}

}  // namespace restrip::tools
