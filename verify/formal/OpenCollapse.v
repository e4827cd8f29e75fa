(** * Edge collapses into open fans, k = 1 ... 8, of an edge inside the mesh

    One section of the certificate serves all positions of the same k, and the boundary collapses as well. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Table Checker Rows Symmetry Tables_open_collapse Rows_fan_collapse.

Definition full (k i j : nat) : trie := Tables_open_collapse.table [k; i; j].
Definition by_key (k : nat) : trie := reduced false (open_fan k) (Rows_fan_collapse.rows [k]).

Definition positions : list (nat * (nat * nat)) :=
  filter (fun '(k, (i, j)) => (i <? j) && (i + j <=? k)) (list_prod (seq 1 8) (list_prod (seq 0 9) (seq 0 9))).
Definition checks (at_ : nat * (nat * nat)) : bool :=
  let '(k, (i, j)) := at_ in
  check (open_collapse k i j) 1 (if Nat.even k then 0 else 1) (agrees false (by_key k)) (full k i j).

Theorem all_checked : forallb checks positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma checked k i j : 1 <= k <= 8 -> i < j -> i + j <= k -> checks (k, (i, j)) = true.
Proof.
  intros Hk Hi Hj. apply (proj1 (forallb_forall checks positions) all_checked). apply filter_In. split.
  - apply in_prod; [|apply in_prod]; apply in_seq; lia.
  - apply andb_true_intro. split; [now apply Nat.ltb_lt|now apply Nat.leb_le].
Qed.

(** The other positions: the fan is mirrored, and A and D change places. *)
Definition others : list (nat * (nat * nat)) :=
  filter (fun '(k, (i, j)) => (i <? j) && (j <=? k) && (k <? i + j)) (list_prod (seq 1 8) (list_prod (seq 0 9) (seq 0 9))).
Definition compares (at_ : nat * (nat * nat)) : bool :=
  let '(k, (i, j)) := at_ in
  compare (mirrored k [k + 1; k]) (open_collapse k i j) (open_collapse k (k - j) (k - i)) (full k (k - j) (k - i)) (full k i j).

Theorem all_compared : forallb compares others = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem every_position k i j : 1 <= k <= 8 -> i < j <= k -> holds (open_collapse k i j) 1 (if Nat.even k then 0 else 1) (full k i j).
Proof.
  intros Hk Hj. destruct (le_lt_dec (i + j) k) as [H|H].
  - eapply check_holds. apply (checked k i j); lia.
  - apply compare_holds with (mirrored k [k + 1; k]) (open_collapse k (k - j) (k - i)) (full k (k - j) (k - i)).
    + apply (proj1 (forallb_forall compares others) all_compared (k, (i, j))). apply filter_In.
      split; [apply in_prod; [|apply in_prod]; apply in_seq; lia|]. rewrite !andb_true_iff, !Nat.ltb_lt, Nat.leb_le. lia.
    + eapply check_holds. apply (checked k (k - j) (k - i)); lia.
Qed.
