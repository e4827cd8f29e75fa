(** * The lists of the shipped linked rules, k = 3 ... 8

    One list serves all positions of a collapse. Of splits the headers have lists for half of the positions, and look up
    the other half with A and D exchanged. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Checker Linked Tables_linked_split Tables_linked_collapse.

Definition split_lists (k a : nat) : coloring -> list alternative := list_for (Tables_linked_split.table [k; a]).
Definition collapse_lists (k : nat) : coloring -> list alternative := list_for (Tables_linked_collapse.table [k]).

Definition split_positions : list (nat * nat) := filter (fun '(k, a) => 2 * a <=? k) (list_prod (seq 3 6) (seq 1 4)).
Definition collapse_positions : list (nat * nat) := filter (fun '(k, a) => a <? k) (list_prod (seq 3 6) (seq 1 7)).

Theorem splits_checked : forallb (fun '(k, a) => check_lists (split k a) (split_lists k a)) split_positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
(** What is checked of a list speaks of the fan after the collapse only, so once for each k will do; a is in the fan before. *)
Theorem collapses_checked : forallb (fun k => check_lists (collapse k 1) (collapse_lists k)) (seq 3 6) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Theorem collapses_well_formed :
  forallb (fun '(k, a) => well_formed_side (collapse k a) (before (collapse k a))) collapse_positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma split_checked k a : 3 <= k <= 8 -> 1 <= a -> 2 * a <= k -> check_lists (split k a) (split_lists k a) = true.
Proof.
  intros Hk Ha H.
  apply (proj1 (forallb_forall (fun '(k, a) => check_lists (split k a) (split_lists k a)) split_positions) splits_checked (k, a)).
  apply filter_In. split; [apply in_prod; apply in_seq; lia|now apply Nat.leb_le].
Qed.
Lemma collapse_checked k a : 3 <= k <= 8 -> 1 <= a < k -> check_lists (collapse k a) (collapse_lists k) = true.
Proof.
  intros Hk Ha.
  assert (C : check_lists (collapse k 1) (collapse_lists k) = true).
  { apply (proj1 (forallb_forall (fun k => check_lists (collapse k 1) (collapse_lists k)) (seq 3 6)) collapses_checked k).
    apply in_seq. lia. }
  assert (W : well_formed_side (collapse k a) (before (collapse k a)) = true).
  { apply (proj1 (forallb_forall (fun '(k, a) => well_formed_side (collapse k a) (before (collapse k a))) collapse_positions)
      collapses_well_formed (k, a)).
    apply filter_In. split; [apply in_prod; apply in_seq; lia|apply Nat.ltb_lt; lia]. }
  unfold check_lists in *. rewrite W. rewrite <- !andb_assoc in C. apply andb_prop in C as [_ C]. exact C.
Qed.
