(** * The lists of the shipped linked rules, k = 3 ... 8

    One list serves all positions of a collapse. Of splits the headers have lists for half of the positions, and look up
    the other half with A and D exchanged. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Spec Checker Linked Tables_linked_split Tables_linked_collapse.

Definition split_lists (k a : nat) : coloring -> list alternative := list_for (Tables_linked_split.table [k; a]).
Definition collapse_lists (k : nat) : coloring -> list alternative := list_for (Tables_linked_collapse.table [k]).

Definition split_positions : list (nat * nat) := filter (fun '(k, a) => 2 * a <=? k) (list_prod (seq 3 6) (seq 1 4)).
Definition collapse_positions : list (nat * nat) := filter (fun '(k, a) => a <? k) (list_prod (seq 3 6) (seq 1 7)).

Theorem splits_checked : forallb (fun '(k, a) => check_lists (split k a) (split_lists k a)) split_positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Theorem collapses_checked : forallb (fun '(k, a) => check_lists (collapse k a) (collapse_lists k)) collapse_positions = true.
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
  apply (proj1 (forallb_forall (fun '(k, a) => check_lists (collapse k a) (collapse_lists k)) collapse_positions)
    collapses_checked (k, a)).
  apply filter_In. split; [apply in_prod; apply in_seq; lia|apply Nat.ltb_lt; lia].
Qed.
