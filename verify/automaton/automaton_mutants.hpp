#pragma once
// Deliberate faults of the automaton's verifier, as those of mutants.hpp: the shipped program is built without any, and
// tests/verify/automaton must notice each.

namespace restrip::verify {

enum class AutomatonMutant {
  none,
  automaton_any_witness,      // witnesses are not compared
  automaton_any_cost,         // a letter may cost anything
  automaton_any_origin,       // a case may come from any case
  automaton_join_anything,    // a meeting may join ports that were not joined
  automaton_any_own_meeting,  // the stated meeting need not be legal
  automaton_never_chord,      // meetings with the chord are not tried
  automaton_any_closing,      // better closings are not looked for
  automaton_loosen_degree,    // a triangle of an arc may have three solid edges
  automaton_first_arcs_only,  // the arcs that longer words lead to are not looked at
  // where swaps have a price
  turns_no_swap_at_ports,  // a port is never a swap
  turns_no_swap_at_chord,  // the chord is never a swap
  turns_search_no_swap,    // whole fans are searched as if nothing were a swap
  turns_search_one_side    // nothing behind a port goes on at its right
};

#ifdef RESTRIP_AUTOMATON_MUTANTS
inline AutomatonMutant active_automaton_mutant =
    AutomatonMutant::none;  // set at most once, before the checker is called
inline bool mutated(AutomatonMutant mutant) { return active_automaton_mutant == mutant; }
#else
constexpr bool mutated(AutomatonMutant /*mutant*/) { return false; }
#endif

}  // namespace restrip::verify
