// In place of common/progress.hpp: progress goes to the page.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

extern "C" __attribute__((import_module("maker"), import_name("progress"))) void maker_progress(
    const char* label, std::uint32_t label_bytes, std::uint32_t done, std::uint32_t total);

namespace restrip {

enum class Watched { no, yes };

class Progress {
 public:
  Progress(std::string label, std::size_t total, Watched watched = Watched::yes)
      : label_(std::move(label)), total_(watched == Watched::yes ? total : 0) {
    at(0);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void at(std::size_t done) {
    if (total_ == 0 || done < next_) return;
    maker_progress(label_.data(), static_cast<std::uint32_t>(label_.size()), static_cast<std::uint32_t>(done),
                   static_cast<std::uint32_t>(total_));
    next_ = done + std::max<std::size_t>(1, total_ / 20);
  }
  void step() { at(++done_); }

 private:
  std::string label_;
  std::size_t total_;
  std::size_t next_ = 0;
  std::size_t done_ = 0;
};

}  // namespace restrip
