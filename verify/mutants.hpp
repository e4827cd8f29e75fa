#pragma once
// Deliberate faults of this checker. The shipped program is built without any: there `mutated` is false at compile
// time. With RESTRIP_MUTANTS a program chooses one when it starts; tests/verify builds the checker so, and must notice
// every fault: a checker that has never been seen to reject is no checker.

namespace restrip::verify {

enum class Mutant {
  none,
  // a colouring is called valid although ...
  drop_all_cycles,    // ... strips close
  drop_outer_cycle,   // ... a strip closes without using the chord
  drop_chord_cycles,  // ... a strip closes over the chord
  loosen_degree,      // ... a triangle has three solid edges
  loosen_new_degree,  // ... a triangle without a port has three solid edges
  // the search, or the judgement of a row, forgets something
  drop_pairing,              // pairings are not looked at
  skip_own_pairing,          // the row's own pairing is not looked at
  skip_own_validity,         // the row's own degrees and cycles are not looked at
  ignore_chord_recolorings,  // the search never uses the chord
  skip_last_recoloring,      // the search stops one short
  skip_first_configuration,  // the walk over configurations starts one late
  strips_off_by_one,         // a row may be one edge short
  ignore_isolated,           // the second criterion is dropped
  ignore_ports_kept,         // the third criterion of flips is dropped
  // the second formulation forgets some of its forbidden sets
  sets_drop_all_cycles,
  sets_drop_outer_cycle,
  sets_drop_path,      // some path between two ports
  sets_loosen_degree,  // a triangle may have three solid edges
  // a reason is taken although ...
  reason_any,                  // ... it was not looked at
  reason_off_by_one,           // ... it shows one dashed edge too few
  reason_only_dashed,          // ... it shows nothing of isolated triangles
  reason_sound_sets,           // ... the edges of a set may all be solid
  reason_overlapping_sets,     // ... one dashed edge may serve two sets
  reason_count_dashed_twice,   // ... the dashed edge of a case serves a set, too
  reason_foreign_edges,        // ... it counts edges that could not be solid
  reason_skip_solid_case,      // ... it shows nothing where the edge is solid
  reason_skip_dashed_case,     // ... it shows nothing where the edge is dashed
  reason_solid_in_both_cases,  // ... it takes the edge for solid where it is dashed
  // coverage
  accept_missing,
  accept_extra,
  // the patch itself is wrong
  at_most_less,         // <= is read as < where a family says which positions there are
  off_by_one_arc,       // D sits one place too far
  chord_misplaced,      // the chord of a ring ends one triangle too far
  swapped_port_joined,  // the key's `joined` looks at the next port, not at the preceding one
  // witnesses, claims, files
  skip_witness,
  skip_representative,
  skip_claims,
  accept_disorder,
  accept_any_checksum,
  skip_row_count,
  skip_sums,
  accept_unlisted,
  // linked rules: a list is taken although ...
  accept_disorder_of_lists,  // ... it stands in the wrong place
  lists_missing,             // ... it is none
  lists_illegal,             // ... an alternative has a triangle with three solid edges, or a cycle
  lists_disorder,            // ... an alternative is preferred to the one before
  lists_covered,             // ... an alternative is never reached
  lists_incomplete,          // ... something as good as nothing in it has been left out
  lists_complete_by_merit,   // ... what is as good as the one left out joins other ports
  lists_complete_by_pairs,   // ... what joins no other ports than the one left out is not as good
  lists_ignore_isolated,     // ... isolated triangles are not in order
  lists_skip_claims,         // ... its claims are wrong
  // what lies outside is seen wrongly
  outside_ignored,         // it is not looked at
  outside_one_pair,        // one strip joins ports there at most
  forget_partners,         // the pairs of an alternative are not followed
  beside_first_is_best,    // no recolouring is tried against the first sound alternative
  beside_ignore_isolated,  // ... but those with more solid edges
  local_any_outside,       // what closes a cycle with the colours before is thought possible
  local_unequal            // any alternative is as good as the local rule
};

#ifdef RESTRIP_MUTANTS
inline Mutant active_mutant = Mutant::none;  // set at most once, before the checker is called
inline bool mutated(Mutant mutant) { return active_mutant == mutant; }
#else
inline constexpr Mutant active_mutant = Mutant::none;
constexpr bool mutated(Mutant mutant) { return active_mutant == mutant; }
#endif

}  // namespace restrip::verify
