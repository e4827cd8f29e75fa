(** * The shipped automaton

    AutomatonNumbers.v holds the numbers of automaton.hpp, as `restrip-dump-tables --automaton` prints them. *)
Require Import Arith Bool List NArith.
Import ListNotations.
Require Import Statements Marks Header AutomatonNumbers Kinds Meetings Walks WalkFamilies WalkOpen.

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

(** With each answer come the number of solid inner edges and the number of isolated triangles of the patch after. *)
Definition side_at (f : walked_family) (position : list nat) : side :=
  match f, position with
  | Splits, [k; a] => after (split k a)
  | Collapses, [k] => after (collapse k 1)
  | OpenSplits, [k; i; j] => after (open_split k i j)
  | BoundarySplits, [k; i] => after (boundary_split k i)
  | FanCollapses, [k] => open_fan k
  | _, _ => closed_fan 0
  end.
Definition told_at (H : header) (f : walked_family) (position : list nat) : N :=
  fold_left (fun h key =>
    let x := answer_at H f position (fst key) (snd key) in
    N.land (h * 1000003 + 64 * N.of_nat (solids x) + N.of_nat (isolated (side_at f position) (fst key) x)) 0xffffffffffffffff)
    (keys (hd O position)) 0%N.
(** The same, computed with marks. *)
Definition marked_told_at (H : header) (f : walked_family) (position : list nat) : N :=
  let d := side_at f position in
  fold_left (fun h key =>
    let x := answer_at H f position (fst key) (snd key) in
    N.land (h * 1000003 + 64 * N.of_nat (solids x) +
            N.of_nat (unmarked (mark_inner (inner d) x (mark_owners (owner d) (fst key) (no_marks d))))) 0xffffffffffffffff)
    (keys (hd O position)) 0%N.
Lemma marked_told H f position : marked_told_at H f position = told_at H f position.
Proof.
  unfold marked_told_at, told_at. generalize (keys (hd O position)) 0%N. intros l.
  induction l as [|key l IH]; intros h; [reflexivity|]. cbn [fold_left]. now rewrite IH, unmarked_isolated.
Qed.
(** The changes that they state are right. *)
Theorem looked_up_told : map fst told_digests = positions 7 /\
  forallb (fun d => N.eqb (told_at automaton (fst (fst d)) (snd (fst d))) (snd d)) told_digests = true.
Proof.
  split; [vm_compute; reflexivity|]. rewrite forallb_forall. intros d I. rewrite <- marked_told. revert d I.
  apply (proj1 (forallb_forall (fun d => N.eqb (marked_told_at automaton (fst (fst d)) (snd (fst d))) (snd d)) told_digests)).
  vm_cast_no_check (eq_refl true).
Qed.
