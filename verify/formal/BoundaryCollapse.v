(** * Edge collapses into open fans, k = 1 ... 8, of an edge on the boundary

    The automaton answers them; every position is checked. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Table Checker Rows Symmetry Tables_boundary_collapse.

Definition full (k i : nat) : trie := Tables_boundary_collapse.table [k; i].

Definition positions : list (nat * nat) := filter (fun '(k, i) => i <=? k) (list_prod (seq 1 8) (seq 0 9)).
Definition checks (at_ : nat * nat) : bool :=
  let '(k, i) := at_ in check (boundary_collapse k i) 0 (if Nat.even k then 0 else 1) (fun _ _ _ => true) (full k i).

Theorem all_checked : forallb checks positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem every_position k i : 1 <= k <= 8 -> i <= k ->
  holds (boundary_collapse k i) 0 (if Nat.even k then 0 else 1) (full k i).
Proof.
  intros Hk Hi. eapply check_holds. apply (proj1 (forallb_forall checks positions) all_checked (k, i)). apply filter_In.
  split; [apply in_prod; apply in_seq; lia|now apply Nat.leb_le].
Qed.
