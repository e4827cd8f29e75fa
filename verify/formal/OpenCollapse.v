(** * Edge collapses into open fans, k = 1 ... 8, of an edge inside the mesh

    The automaton answers them; every position is checked. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Table Checker Rows Symmetry Tables_open_collapse.

Definition full (k i j : nat) : trie := Tables_open_collapse.table [k; i; j].

Definition positions : list (nat * (nat * nat)) :=
  filter (fun '(k, (i, j)) => (i <? j) && (j <=? k)) (list_prod (seq 1 8) (list_prod (seq 0 9) (seq 0 9))).
Definition checks (at_ : nat * (nat * nat)) : bool :=
  let '(k, (i, j)) := at_ in check (open_collapse k i j) 1 (if Nat.even k then 0 else 1) (fun _ _ _ => true) (full k i j).

Theorem all_checked : forallb checks positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem every_position k i j : 1 <= k <= 8 -> i < j <= k -> holds (open_collapse k i j) 1 (if Nat.even k then 0 else 1) (full k i j).
Proof.
  intros Hk Hj. eapply check_holds. apply (proj1 (forallb_forall checks positions) all_checked (k, (i, j))). apply filter_In.
  split; [apply in_prod; [|apply in_prod]; apply in_seq; lia|]. rewrite andb_true_iff, Nat.ltb_lt, Nat.leb_le. lia.
Qed.
