#pragma once
// Deliberate faults of the verifier of operations, as in mutants.hpp: the shipped program has none, and the tests of
// tests/verify/operations must notice every one.

namespace restrip::verify::operations {

enum class OperationMutant {
  none,
  // what a colouring may be
  loosen_degree,       // a triangle may have one solid edge more
  forget_port_degree,  // solid ports are no solid edges of their triangle
  forget_cycles,       // solid inner edges may close a cycle
  // what lies outside
  no_cycle_outside,   // no cycle runs through it
  no_distant_pairs,   // of the ports that one could be connected with it knows the first
  blocks_of_one,      // its first block of connected ports is the only one
  worlds_stop_early,  // the last world is not looked at
  // which recolourings there are
  take_ports,         // a dashed port may become solid
  give_up_any_port,   // any port may be given up
  best_keeps_ports,   // the best gives no port up
  skip_last_cost,     // the last criterion is not compared
  accept_worse,       // a sound recolouring is good enough
  forget_last_class,  // the best is not looked for among the last recolourings
  // what is counted
  ends_are_lonely,       // triangles without a solid edge count as ends
  squares_of_solid,      // only solid ports are counted
  isolated_but_for_one,  // the last triangle is never isolated
  worst_without_ports,   // ports given up isolate nothing
  // symmetries
  symmetries_move_cost,   // they need not keep the cost
  symmetries_move_ports,  // nor the ports that may be given up
  // rows
  accept_missing_rows,
  accept_extra_rows,
  accept_any_witness,
  accept_any_representative,
  skip_last_number,
  // a reason is taken although ...
  reason_of_dashed_alone,    // ... it shows nothing of isolated triangles
  reason_with_sound_sets,    // ... the edges of a set may all be solid
  reason_with_shared_edges,  // ... two sets share an edge
  reason_without_case,       // ... nothing is shown where the edge is dashed
  reason_of_staying_ports,   // ... it counts a port that stays
  // dumps
  answer_the_invalid,  // a configuration that is not valid may have an answer
  skip_certificate     // the answers need not be the certificate's
};

#ifdef RESTRIP_OPERATION_MUTANTS
inline OperationMutant active_operation_mutant = OperationMutant::none;  // set at most once, before all else
inline bool mutated(OperationMutant mutant) { return active_operation_mutant == mutant; }
#else
constexpr bool mutated(OperationMutant /*mutant*/) { return false; }
#endif

}  // namespace restrip::verify::operations
