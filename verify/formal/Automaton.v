(** * The shipped automaton

    AutomatonNumbers.v holds the numbers of automaton.hpp, as `restrip-dump-tables --automaton` prints them. *)
Require Import Arith Bool List NArith.
Import ListNotations.
Require Import Spec Header AutomatonNumbers Kinds Meetings Walks WalkFamilies WalkOpen.

Definition automaton : header :=
  Header (array_of next_numbers) (array_of before_numbers) (array_of closed_numbers) (array_of first_numbers) (array_of second_numbers)
    (array_of meet_numbers) (array_of meetings_numbers) (hd 0%N seconds_numbers).

Theorem automaton_ok : header_ok automaton = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** The look-up of this theory and the compiled one answer alike, in every position up to some size. *)
Definition compared (n : nat) : Prop :=
  map fst digests = positions n /\ forallb (fun d => N.eqb (digest_at automaton (fst (fst d)) (snd (fst d))) (snd d)) digests = true.
Theorem looked_up : compared 7.
Proof. split; [vm_compute; reflexivity|vm_cast_no_check (eq_refl true)]. Qed.
