(** * Vertex splits of open fans whose new edge lies on the boundary, k = 1 ... 8

    The automaton answers them; every position is checked. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Table Checker Rows Symmetry Tables_boundary_split.

Definition full (k i : nat) : trie := Tables_boundary_split.table [k; i].

Definition positions : list (nat * nat) := filter (fun '(k, i) => i <=? k) (list_prod (seq 1 8) (seq 0 9)).
Definition checks (at_ : nat * nat) : bool :=
  let '(k, i) := at_ in
  check (boundary_split k i) (if Nat.min i (k - i) =? 1 then 0 else 1) (if Nat.even k && Nat.even i then 1 else 0)
    (fun _ _ _ => true) (full k i).

Theorem all_checked : forallb checks positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem every_position k i : 1 <= k <= 8 -> i <= k ->
  holds (boundary_split k i) (if Nat.min i (k - i) =? 1 then 0 else 1) (if Nat.even k && Nat.even i then 1 else 0) (full k i).
Proof.
  intros Hk Hi. eapply check_holds. apply (proj1 (forallb_forall checks positions) all_checked (k, i)). apply filter_In.
  split; [apply in_prod; apply in_seq; lia|now apply Nat.leb_le].
Qed.
