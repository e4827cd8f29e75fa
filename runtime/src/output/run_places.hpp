// The places of runs in a strip buffer: a list in the order of the buffer, with the gaps between them sorted by size.
// Knows neither indices nor meshes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace restrip::detail {

/// Consecutive indices that draw a part of a strip, the last of them separates it from the next run.
struct Run {
  std::uint32_t first = 0;
  std::uint32_t length = 0;
  std::uint32_t triangles = 0;
  std::uint32_t cuts = 0;  ///< its ends where the strip continues in another run
  [[nodiscard]] std::uint32_t end() const noexcept { return first + length; }
};

/// Place 0 is the head: it lies at the beginning, its run is empty, and its gap lies before the first run. Places are
/// named by numbers that are used again. All functions take constant time but make_room(), which may copy and throw;
/// runs must not overlap.
class RunPlaces {
 public:
  static constexpr std::uint32_t head = 0;
  static constexpr std::uint32_t no_place = 0xFFFFFFFFU;
  static constexpr std::uint32_t largest_gap = 127;  ///< gaps of this size and above are not distinguished
  enum class State : std::uint8_t { settled, dirty, claimed };

  RunPlaces() { totals_.first_of.fill(no_place); }
  /// Room for this many more runs, which insert() needs.
  void make_room(std::size_t runs) {
    if (places_.size() + runs > places_.capacity()) places_.reserve(2 * (places_.size() + runs));
  }

  // ---- one place
  [[nodiscard]] const Run& run(std::uint32_t p) const noexcept { return places_[p].run; }
  [[nodiscard]] std::uint32_t previous(std::uint32_t p) const noexcept { return places_[p].previous; }
  [[nodiscard]] std::uint32_t next(std::uint32_t p) const noexcept { return places_[p].next; }
  /// Where the next run begins, or the buffer ends.
  [[nodiscard]] std::uint32_t limit(std::uint32_t p) const noexcept {
    return next(p) == head ? totals_.length : run(next(p)).first;
  }
  /// Unused cells after its run.
  [[nodiscard]] std::uint32_t gap(std::uint32_t p) const noexcept { return limit(p) - run(p).end(); }
  [[nodiscard]] State state(std::uint32_t p) const noexcept { return places_[p].state; }
  void set_state(std::uint32_t p, State state) noexcept { places_[p].state = state; }

  // ---- all of them
  [[nodiscard]] std::size_t runs() const noexcept { return totals_.runs; }
  [[nodiscard]] std::uint32_t length() const noexcept { return totals_.length; }
  [[nodiscard]] std::uint32_t used() const noexcept { return totals_.used; }
  [[nodiscard]] std::uint32_t cuts() const noexcept { return totals_.cuts; }
  [[nodiscard]] std::uint32_t last() const noexcept { return previous(head); }
  /// The place with the smallest gap of at least `cells`; if none exists, the place with the largest gap, or no_place.
  [[nodiscard]] std::uint32_t find_gap(std::uint32_t cells) const noexcept {
    const std::size_t size = (std::min)(cells, largest_gap);
    std::size_t word = size / 64;
    std::uint64_t bits = totals_.sizes[word] >> (size % 64) << (size % 64);
    while (bits == 0 && ++word < totals_.sizes.size()) bits = totals_.sizes[word];
    if (bits != 0) return totals_.first_of[word * 64 + static_cast<std::size_t>(std::countr_zero(bits))];
    for (word = totals_.sizes.size(); word-- > 0;)
      if (totals_.sizes[word] != 0)
        return totals_.first_of[word * 64 + 63 - static_cast<std::size_t>(std::countl_zero(totals_.sizes[word]))];
    return no_place;
  }

  // ---- changes
  void set_length(std::uint32_t length) noexcept {
    totals_.length = length;
    sort_in(last());
  }
  /// Another run in place p, between the same neighbours.
  void set(std::uint32_t p, const Run& run) noexcept {
    Place& place = places_[p];
    totals_.used += run.length - place.run.length;
    totals_.cuts += run.cuts - place.run.cuts;
    place.run = run;
    sort_in(place.previous);
    sort_in(p);
  }
  /// Inserts a run into the gap after `before`. Returns its place.
  std::uint32_t insert(std::uint32_t before, const Run& run) noexcept {
    std::uint32_t p = totals_.free;
    if (p == head) {
      p = static_cast<std::uint32_t>(places_.size());
      places_.emplace_back();
    } else {
      totals_.free = next(p);
    }
    ++totals_.runs;
    Place& place = places_[p];
    place.previous = before;
    place.next = next(before);
    places_[place.next].previous = places_[before].next = p;
    set(p, run);
    return p;
  }
  void remove(std::uint32_t p) noexcept {
    set(p, {run(p).first, 0, 0, 0});
    Place& place = places_[p];
    take_out(p);
    places_[place.previous].next = place.next;
    places_[place.next].previous = place.previous;
    sort_in(place.previous);
    place.state = State::settled;
    place.next = std::exchange(totals_.free, p);
    --totals_.runs;
  }

 private:
  struct Place {
    Run run;
    std::uint32_t previous = head;
    std::uint32_t next = head;
    std::uint32_t nearer = no_place;  // places with a gap of the same size
    std::uint32_t farther = no_place;
    std::uint16_t size = 0;  // the size that the gap is sorted by; 0: not sorted
    State state = State::settled;
  };

  void take_out(std::uint32_t p) noexcept {
    if (places_[p].size == 0) return;
    Place& place = places_[p];
    (place.nearer != no_place ? places_[place.nearer].farther : totals_.first_of[place.size]) = place.farther;
    if (place.farther != no_place) places_[place.farther].nearer = place.nearer;
    if (totals_.first_of[place.size] == no_place)
      totals_.sizes[place.size / 64U] &= ~(std::uint64_t{1} << (place.size % 64U));
    place.size = 0;
  }
  // Sorts the gap after p in again, after it has changed.
  void sort_in(std::uint32_t p) noexcept {
    const auto size = static_cast<std::uint16_t>((std::min)(gap(p), largest_gap));
    if (places_[p].size == size) return;
    take_out(p);
    if (size == 0) return;
    Place& place = places_[p];
    place.size = size;
    place.nearer = no_place;
    place.farther = std::exchange(totals_.first_of[size], p);
    if (place.farther != no_place)
      places_[place.farther].nearer = p;
    else
      totals_.sizes[size / 64U] |= std::uint64_t{1} << (size % 64U);
  }

  // Data on all places together.
  struct Totals {
    std::uint32_t free = head;  // places that are free, linked by `next`; the head ends them
    std::uint32_t length = 0;
    std::uint32_t used = 0;
    std::uint32_t cuts = 0;
    std::size_t runs = 0;
    std::array<std::uint32_t, largest_gap + 1> first_of{};      // by size of a gap
    std::array<std::uint64_t, (largest_gap + 1) / 64> sizes{};  // that exist, a bit each
  };

  std::vector<Place> places_ = std::vector<Place>(1);
  Totals totals_;
};

}  // namespace restrip::detail
