#pragma once
// One position as a formula: "some valid configuration has a sound recolouring that beats its row". docs/trust.md
// describes it so that it can be rebuilt. Written from docs/notation.md; of the verifier it uses the parser of
// certificates and nothing else.

#include "certificate/certificate.hpp"
#include "sat/circuit.hpp"
#include "sat/patch_graph.hpp"

namespace restrip::verify::sat {

/// What a row claims of its key: no sound recolouring is better, in this order.
struct Bound {
  Key key;
  PortPairs matter;  ///< pairs of its ports that keys with these ports can tell apart
  int solid = 0;     ///< solid edges after; for a flip with the ports kept
  int isolated = 0;  ///< isolated triangles after; for a flip with the ports given up
  int kept = 0;      ///< ports kept; meant for flips only
};

/// Whether a configuration with these ports that joins these pairs has the bound's key.
inline bool has_key(const Bound& bound, Mask ports, PortPairs joined) {
  return ports == bound.key.ports && joined.both(bound.matter) == bound.key.joined;
}

/// The figures of the rows' recolourings, in the order of the rows.
std::vector<Bound> bounds_of(const Position& position, const std::vector<Row>& rows);

/// Deliberate mistakes, for tests: each must make a formula satisfiable that should not be, or the other way round.
enum class EncodingFault {
  none,
  drop_all_cycles,      // a recolouring may close strips
  drop_outer_cycle,     // … along the ring
  drop_chord_cycles,    // … over the chord
  loosen_degree,        // a recolouring may have triangles with three solid edges
  loosen_new_degree,    // … at A and D
  drop_pairs,           // a recolouring may join what it likes
  forget_some_pairs,    // … port 0 with port 1
  any_degree_before,    // configurations may have triangles with three solid edges
  any_cycle_before,     // … closed strips
  joined_never,         // the key has no joined pair
  joined_by_triangle,   // … only pairs of ports of one triangle
  chord_misplaced,      // the chord ends one triangle too far
  chord_never,          // recolourings that use the chord are left out
  first_edge_never,     // … that use the first edge
  count_one_short,      // "at least m" means m + 1
  count_one_long,       // "at least m" means m - 1
  forget_isolated,      // the second criterion can never be met
  isolated_off_by_one,  // "fewer" means "not more"
  forbid_all_pairs,     // a recolouring may join nothing
  empty_ports_only,     // configurations have no solid port
};
inline constexpr EncodingFault last_encoding_fault = EncodingFault::empty_ports_only;

/// The formula, and where its inputs are.
struct Encoding {
  Cnf cnf;
  std::vector<Literal> before;               ///< inner edges
  std::vector<Literal> ports;                ///< before
  std::vector<Literal> after;                ///< inner edges
  std::vector<Literal> ports_after;          ///< the same literals as `ports` unless ports may be given up
  std::vector<std::vector<Literal>> joined;  ///< of the key: joined[j][i] for ports i < j
};

Encoding encode(const Position& position, const std::vector<Bound>& bounds, EncodingFault fault = EncodingFault::none);

}  // namespace restrip::verify::sat
