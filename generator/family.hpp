// The families of docs/notation.md as data: what tables/families.json says of them (docs/operation-file.md,
// "Families"). No other code knows one by its name.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::generator {

/// The numbers that say where an operation of a family happens, the valence first; unused ones are 0.
using PositionNumbers = std::array<unsigned, 3>;

/// "2 a + 1": what each number counts, and a constant.
struct Sum {
  PositionNumbers factors{};
  unsigned constant = 0;
  [[nodiscard]] unsigned at(const PositionNumbers& numbers) const;
};

struct Comparison {
  Sum left;
  std::string sign;  ///< "<", "<=", ">=" or "="
  Sum right;
};

/// All of them hold.
using Conditions = std::vector<Comparison>;
[[nodiscard]] bool hold(const Conditions& conditions, const PositionNumbers& numbers);

/// Triangles of a side in the order of the ring or path that they form: one by its name, or t_from … t_(to - 1).
struct Stretch {
  std::string name;
  Sum from;
  Sum to;
};

struct SidePattern {
  bool ring = false;
  std::vector<Stretch> stretches;
  std::vector<std::string> chord;  ///< the triangles that an edge more joins: two, or none
  std::vector<std::string> ports;  ///< the triangle of each port; where there are none, t_i has port i
};

struct Family {
  std::string name;                  ///< "open-collapse"
  std::string certificate;           ///< whose rules it shares: "fan-collapse"
  std::vector<std::string> numbers;  ///< of its positions: "k", "i", "j"; none when there is only one position
  std::string range;                 ///< `where`, for people
  Conditions where;                  ///< which positions there are
  Conditions listed;                 ///< and which of them are not images of others
  std::string section;               ///< "k {k} gaps {i} {j}", as certificates write a position after `section`
  bool keyed_by_inner = false;       ///< a key has the colours of the inner edges, not `joined`
  bool gives_ports_up = false;
  bool linked = false;  ///< there are linked rules as well
  SidePattern before;
  SidePattern after;
};

/// Throws std::runtime_error with what was expected.
[[nodiscard]] std::vector<Family> parse_families(std::string_view text);

/// The families of the shipped file, in its order.
[[nodiscard]] const std::vector<Family>& families();

/// Throws std::invalid_argument.
[[nodiscard]] const Family& family_named(const std::string& name);

}  // namespace restrip::generator
