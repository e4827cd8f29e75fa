// The look-up of row.hpp: a row read by the automaton of rows, and the one recolouring beside its answer that joins the
// first and the last solid port over all others.
#pragma once

#include <cstddef>

#include "restrip/rules/bits.hpp"
#include "restrip/rules/impl/arc_walk.hpp"

namespace restrip::detail {

inline constexpr const char* no_such_row =
    "the row is out of range: 1 <= triangles; first < ports; on masks, at most 64 ports";

/// Letters and cases of rows in restrip/tables/automaton_format.hpp: the letter of a solid port at an end, 0 in
/// `joined`, and the bit of a case before a letter that says that the letter's port is given up.
inline constexpr unsigned end_port = 3;
inline constexpr unsigned given_up_bit = 4;

struct Row {
  std::size_t triangles = 0;
  bool front = false;     ///< the first triangle has another port, before its own
  bool back = false;      ///< the last triangle has another port, behind its own
  std::size_t first = 0;  ///< the number of the first port

  [[nodiscard]] constexpr std::size_t ports() const noexcept { return triangles + (front ? 1 : 0) + (back ? 1 : 0); }
  /// The number of the port at a place of the row, the one in front included.
  [[nodiscard]] constexpr std::size_t port(std::size_t place) const noexcept {
    return first + place < ports() ? first + place : first + place - ports();
  }
  /// The triangle that has it.
  [[nodiscard]] constexpr std::size_t owner(std::size_t place) const noexcept {
    const std::size_t own = place - (front && place > 0 ? 1 : 0);
    return own < triangles ? own : triangles - 1;
  }
};

struct RowValue {
  int solid = 0;
  int isolated = 0;
  int given_up = 0;

  friend constexpr bool operator==(const RowValue&, const RowValue&) noexcept = default;
  /// In the order of preference.
  [[nodiscard]] constexpr bool better_than(const RowValue& other) const noexcept {
    const int more = solid - given_up - (other.solid - other.given_up);
    if (more != 0) return more > 0;
    const int fewer = other.isolated + other.given_up - (isolated + given_up);
    return fewer != 0 ? fewer > 0 : given_up < other.given_up;
  }
};

/// The solid ports of a row, by their places.
struct RowPorts {
  std::size_t first = nowhere;
  std::size_t last = nowhere;
  std::size_t count = 0;

  constexpr RowPorts(const Row& row, BitSpan ports) noexcept {
    for (std::size_t place = 0; place < row.ports(); ++place) {
      if (!ports[row.port(place)]) continue;
      if (count++ == 0) first = place;
      last = place;
    }
  }
};

/// The best recolouring of a row. `room` has an entry for each port.
template <const auto& automaton>
constexpr RowValue walk_row(const Row& row, BitSpan ports, BitSpan joined, ArcEntry* room, MutableBitSpan colors,
                            MutableBitSpan kept) noexcept {
  const std::size_t behind = row.ports() - 1;  // the place of the port behind the row, if it has one
  const RowPorts solid(row, ports);
  const bool ends_joined = solid.count > 1 && joined[row.port(solid.first)];
  const auto letter_at = [&](std::size_t place) -> unsigned {
    if (!ports[row.port(place)]) return 0;
    return joined[row.port(place)] || (solid.count == 2 && ends_joined) ? 2 : 1;
  };
  ArcWalk<automaton> walk(room);
  const bool reads_front = row.front && letter_at(0) != 0;
  if (reads_front) walk.read(end_port + letter_at(0) - 1);
  for (std::size_t i = 0; i < row.triangles; ++i) walk.read(letter_at(i + (row.front ? 1 : 0)));
  if (row.back && letter_at(behind) != 0) walk.read(end_port + letter_at(behind) - 1);

  colors.clear(row.triangles - 1);
  kept.clear(row.ports());
  RowValue value;
  const auto port = [&](std::size_t place, bool is_kept) {
    if (is_kept)
      kept.set(row.port(place));
    else
      ++value.given_up;
  };
  unsigned end = 0;
  for (std::size_t m = walk.size(); m-- > 0;) {
    const bool right = end != 0;
    end = walk.before(m, end);
    const bool given = (end & given_up_bit) != 0;
    end &= ~given_up_bit;
    const bool left = end != 0;
    const std::size_t i = m - (reads_front ? 1 : 0);
    if (reads_front && m == 0) {
      port(0, right);
    } else if (i == row.triangles) {
      port(behind, left);
    } else {
      const std::size_t own = i + (row.front ? 1 : 0);
      const bool has_port = ports[row.port(own)];
      if (has_port) port(own, !given);
      if (!left && !right && (!has_port || given)) ++value.isolated;
      if (right && i + 1 < row.triangles) {
        colors.set(i);
        ++value.solid;
      }
    }
  }

  // A strand from the first triangle to the last gives up all ports but the first and the last. One that leaves out
  // triangles at an end is no better than the automaton's answer (docs/automaton.md, "Families of your own").
  if (solid.count < 3 || !ends_joined || row.owner(solid.first) != 0 || row.owner(solid.last) + 1 != row.triangles)
    return value;
  const RowValue across{static_cast<int>(row.triangles) - 1, 0, static_cast<int>(solid.count) - 2};
  if (!across.better_than(value)) return value;
  for (std::size_t i = 0; i + 1 < row.triangles; ++i) colors.set(i);
  kept.clear(row.ports());
  kept.set(row.port(solid.first));
  kept.set(row.port(solid.last));
  return across;
}

}  // namespace restrip::detail
