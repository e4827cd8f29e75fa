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

/// The formula, and where its inputs are.
struct Encoding {
  Cnf cnf;
  std::vector<Literal> before;               ///< inner edges
  std::vector<Literal> ports;                ///< before
  std::vector<Literal> after;                ///< inner edges
  std::vector<Literal> ports_after;          ///< the same literals as `ports` unless ports may be given up
  std::vector<std::vector<Literal>> joined;  ///< of the key: joined[j][i] for ports i < j
};

Encoding encode(const Position& position, const std::vector<Bound>& bounds);

}  // namespace restrip::verify::sat
