// Where the runs of a strip buffer lie: a list of places in the order of the buffer, with the gaps between them sorted
// by size. Knows neither indices nor meshes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace restrip::detail {

/// Place 0 is the head: it lies at the beginning, is empty, and its gap is what lies before the first run. Places are
/// named by numbers that are used again. All functions take constant time, and none but insert() may throw.
class RunPlaces {
 public:
  static constexpr std::uint32_t head = 0;
  static constexpr std::uint32_t no_place = 0xFFFFFFFFU;
  /// Gaps of this size and above are not told apart.
  static constexpr std::uint32_t largest_gap = 255;

  RunPlaces() { clear(); }

  void clear() {
    places_.assign(1, Place{});
    free_ = head;
    length_ = used_ = pads_ = cuts_ = 0;
    runs_ = 0;
    first_of_.fill(no_place);
    occupied_.fill(0);
  }
  /// Room for this many more runs.
  void make_room(std::size_t runs) {
    const std::size_t wanted = places_.size() + runs;
    if (wanted > places_.capacity()) places_.reserve(wanted * 2);
  }

  // ---- one place
  [[nodiscard]] std::uint32_t first(std::uint32_t p) const noexcept { return places_[p].first; }
  [[nodiscard]] std::uint32_t used(std::uint32_t p) const noexcept { return places_[p].used; }
  [[nodiscard]] std::uint32_t pads(std::uint32_t p) const noexcept { return places_[p].pads; }
  [[nodiscard]] std::uint32_t cuts(std::uint32_t p) const noexcept { return places_[p].cuts; }
  void set_cuts(std::uint32_t p, std::uint32_t cuts) noexcept {
    cuts_ += cuts - places_[p].cuts;
    places_[p].cuts = static_cast<std::uint8_t>(cuts);
  }
  [[nodiscard]] std::uint32_t end(std::uint32_t p) const noexcept { return places_[p].first + places_[p].used; }
  [[nodiscard]] std::uint32_t previous(std::uint32_t p) const noexcept { return places_[p].previous; }
  [[nodiscard]] std::uint32_t next(std::uint32_t p) const noexcept { return places_[p].next; }
  /// Where the next place begins, or the buffer ends.
  [[nodiscard]] std::uint32_t limit(std::uint32_t p) const noexcept {
    return places_[p].next == head ? length_ : places_[places_[p].next].first;
  }
  /// Unused cells behind p.
  [[nodiscard]] std::uint32_t gap(std::uint32_t p) const noexcept { return limit(p) - end(p); }

  [[nodiscard]] bool touched(std::uint32_t p) const noexcept { return places_[p].touched; }
  void set_touched(std::uint32_t p, bool touched) noexcept { places_[p].touched = touched; }
  [[nodiscard]] bool claimed(std::uint32_t p) const noexcept { return places_[p].claimed; }
  void set_claimed(std::uint32_t p, bool claimed) noexcept { places_[p].claimed = claimed; }

  // ---- all of them
  [[nodiscard]] std::size_t runs() const noexcept { return runs_; }
  [[nodiscard]] std::uint32_t length() const noexcept { return length_; }
  [[nodiscard]] std::uint32_t used() const noexcept { return used_; }
  [[nodiscard]] std::uint32_t pads() const noexcept { return pads_; }
  /// Ends of runs where a strip goes on in another run.
  [[nodiscard]] std::uint32_t cuts() const noexcept { return cuts_; }
  [[nodiscard]] std::uint32_t last() const noexcept { return places_[head].previous; }
  /// The place with the smallest gap of at least `cells`, or no_place.
  [[nodiscard]] std::uint32_t find_gap(std::uint32_t cells) const noexcept {
    std::size_t word = cells / 64;
    std::uint64_t bits = occupied_[word] >> (cells % 64) << (cells % 64);
    while (bits == 0) {
      if (++word == occupied_.size()) return no_place;
      bits = occupied_[word];
    }
    return first_of_[word * 64 + static_cast<std::size_t>(std::countr_zero(bits))];
  }

  /// The place with the largest gap, or no_place where there is none.
  [[nodiscard]] std::uint32_t find_largest_gap() const noexcept {
    for (std::size_t word = occupied_.size(); word-- > 0;)
      if (occupied_[word] != 0)
        return first_of_[word * 64 + 63 - static_cast<std::size_t>(std::countl_zero(occupied_[word]))];
    return no_place;
  }

  // ---- changes; the cells between two places must stay in order
  void set_length(std::uint32_t length) noexcept {
    length_ = length;
    sort_in(last());
  }
  std::uint32_t insert(std::uint32_t before, std::uint32_t first, std::uint32_t used, std::uint32_t pads) {
    std::uint32_t p = free_;
    if (p == head) {
      p = static_cast<std::uint32_t>(places_.size());
      places_.emplace_back();
    } else {
      free_ = places_[p].next;
    }
    const std::uint32_t after = places_[before].next;
    places_[p] = {first, used, pads, before, after};
    places_[before].next = places_[after].previous = p;
    used_ += used;
    pads_ += pads;
    ++runs_;
    sort_in(before);
    sort_in(p);
    return p;
  }
  void remove(std::uint32_t p) noexcept {
    const Place& gone = places_[p];
    take_out(p);
    places_[gone.previous].next = gone.next;
    places_[gone.next].previous = gone.previous;
    used_ -= gone.used;
    pads_ -= gone.pads;
    cuts_ -= gone.cuts;
    --runs_;
    const std::uint32_t before = gone.previous;
    places_[p].next = free_;
    free_ = p;
    sort_in(before);
  }
  void set(std::uint32_t p, std::uint32_t first, std::uint32_t used, std::uint32_t pads) noexcept {
    Place& place = places_[p];
    used_ += used - place.used;
    pads_ += pads - place.pads;
    place.first = first;
    place.used = used;
    place.pads = pads;
    sort_in(place.previous);
    sort_in(p);
  }

 private:
  struct Place {
    std::uint32_t first = 0;
    std::uint32_t used = 0;
    std::uint32_t pads = 0;  // of the used cells those that draw nothing and could go
    std::uint32_t previous = head;
    std::uint32_t next = head;
    std::uint32_t nearer = no_place;  // places with a gap of the same size
    std::uint32_t farther = no_place;
    std::uint16_t size = 0;  // the gap as it is sorted in; 0: not at all
    std::uint8_t cuts = 0;
    bool touched = false;
    bool claimed = false;
  };

  void take_out(std::uint32_t p) noexcept {
    Place& place = places_[p];
    if (place.size == 0) return;
    if (place.nearer != no_place)
      places_[place.nearer].farther = place.farther;
    else
      first_of_[place.size] = place.farther;
    if (place.farther != no_place) places_[place.farther].nearer = place.nearer;
    if (first_of_[place.size] == no_place) occupied_[place.size / 64U] &= ~(std::uint64_t{1} << (place.size % 64U));
    place.size = 0;
  }
  /// The gap behind p has changed.
  void sort_in(std::uint32_t p) noexcept {
    const std::uint32_t now = gap(p);
    const auto size = static_cast<std::uint16_t>(now < largest_gap ? now : largest_gap);
    Place& place = places_[p];
    if (place.size == size) return;
    take_out(p);
    if (size == 0) return;
    place.size = size;
    place.nearer = no_place;
    place.farther = first_of_[size];
    if (place.farther != no_place) places_[place.farther].nearer = p;
    first_of_[size] = p;
    occupied_[size / 64U] |= std::uint64_t{1} << (size % 64U);
  }

  std::vector<Place> places_;
  std::uint32_t free_ = head;  // places that are free, linked by `next`; the head ends them
  std::uint32_t length_ = 0;
  std::uint32_t used_ = 0;
  std::uint32_t pads_ = 0;
  std::uint32_t cuts_ = 0;
  std::size_t runs_ = 0;
  std::array<std::uint32_t, largest_gap + 1> first_of_{};
  std::array<std::uint64_t, (largest_gap + 1) / 64> occupied_{};
};

}  // namespace restrip::detail
