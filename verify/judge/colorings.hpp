#pragma once
// All colourings of one side: which are valid, and which of these fit the same worlds.

#include <cstdint>
#include <vector>

#include "judge/fit_table.hpp"

namespace restrip::verify {

/// The valid colourings of a side that fit the same worlds.
struct ColoringClass {
  std::uint32_t fit_class = 0;
  Colors first;
  std::uint64_t colorings = 0;
  std::array<std::uint32_t, most_colors + 1> with_solid{};        ///< how many have so many solid edges, ports included
  std::array<std::uint32_t, most_triangles + 1> with_isolated{};  ///< or so many isolated triangles
};

class Colorings {
 public:
  static constexpr std::uint32_t not_valid = 0xffffffff;

  /// `visit` is called with each valid colouring and the number of its class.
  template <class Visit>
  Colorings(const Side& side, unsigned most_solid, FitTable& table, Visit visit)
      : ports_(side.ports()), of_ports_(mask_count(side.ports())), class_of_(mask_count(side.colors()), not_valid) {
    classify(side, most_solid, table);
    for (Mask both = 0; both < class_of_.size(); ++both)
      if (class_of_[both] != not_valid) visit(coloring(both), class_of_[both]);
  }
  Colorings(const Side& side, unsigned most_solid, FitTable& table)
      : Colorings(side, most_solid, table, [](Colors /*colors*/, std::uint32_t /*number*/) {}) {}

  std::uint32_t class_of(Colors colors) const { return class_of_[concatenated(colors.inner, colors.ports, ports_)]; }
  bool valid(Colors colors) const { return class_of(colors) != not_valid; }
  const std::vector<ColoringClass>& classes() const { return classes_; }
  /// The classes of colourings with these solid ports.
  const std::vector<std::uint32_t>& of_ports(Mask ports) const { return of_ports_[ports]; }
  std::size_t size() const { return class_of_.size(); }
  Colors coloring(Mask both) const { return {high_part(both, ports_), low_part(both, ports_)}; }

  /// Pairs of a valid colouring and a world.
  std::uint64_t tested() const { return tested_; }
  /// A valid colouring that does not join the same ports as the first of its class; not_valid when there is none.
  std::uint32_t odd_one() const { return odd_one_; }

 private:
  void classify(const Side& side, unsigned most_solid, FitTable& table);

  unsigned ports_;
  std::vector<ColoringClass> classes_;
  std::vector<std::vector<std::uint32_t>> of_ports_;
  std::vector<std::uint32_t> class_of_;  ///< by concatenated(inner, ports)
  std::uint64_t tested_ = 0;
  std::uint32_t odd_one_ = not_valid;
};

}  // namespace restrip::verify
