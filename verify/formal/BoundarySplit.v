(** * Vertex splits of open fans whose new edge lies on the boundary, k = 1 ... 8 *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Table Checker Rows Symmetry Tables_boundary_split Rows_boundary_split.

Definition full (k i : nat) : trie := Tables_boundary_split.table [k; i].
Definition by_key (k i : nat) : trie := reduced false (after (boundary_split k i)) (Rows_boundary_split.rows [k; i]).

Definition positions : list (nat * nat) := filter (fun '(k, i) => 2 * i <=? k) (list_prod (seq 1 8) (seq 0 5)).
Definition checks (at_ : nat * nat) : bool :=
  let '(k, i) := at_ in
  check (boundary_split k i) (if i =? 1 then 0 else 1) (if Nat.even k && Nat.even i then 1 else 0)
    (agrees false (by_key k i)) (full k i).

Theorem all_checked : forallb checks positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma checked k i : 1 <= k <= 8 -> 2 * i <= k -> checks (k, i) = true.
Proof.
  intros Hk Hi. apply (proj1 (forallb_forall checks positions) all_checked). apply filter_In. split.
  - apply in_prod; apply in_seq; lia.
  - now apply Nat.leb_le.
Qed.

(** The other positions: the fan is mirrored. *)
Definition others : list (nat * nat) := filter (fun '(k, i) => (i <=? k) && (k <? 2 * i)) (list_prod (seq 1 8) (seq 0 9)).
Definition compares (at_ : nat * nat) : bool :=
  let '(k, i) := at_ in compare (mirrored k [k]) (boundary_split k i) (boundary_split k (k - i)) (full k (k - i)) (full k i).

Theorem all_compared : forallb compares others = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem every_position k i : 1 <= k <= 8 -> i <= k ->
  holds (boundary_split k i) (if Nat.min i (k - i) =? 1 then 0 else 1) (if Nat.even k && Nat.even i then 1 else 0) (full k i).
Proof.
  intros Hk Hi. destruct (le_lt_dec (2 * i) k) as [H|H].
  - replace (Nat.min i (k - i)) with i by lia. eapply check_holds. apply (checked k i); lia.
  - apply compare_holds with (mirrored k [k]) (boundary_split k (k - i)) (full k (k - i)).
    + apply (proj1 (forallb_forall compares others) all_compared (k, i)). apply filter_In.
      split; [apply in_prod; apply in_seq; lia|]. rewrite andb_true_iff, Nat.ltb_lt, Nat.leb_le. lia.
    + replace (Nat.min i (k - i)) with (k - i) by lia.
      replace (Nat.even k && Nat.even i) with (Nat.even k && Nat.even (k - i)).
      * eapply check_holds. apply (checked k (k - i)); lia.
      * rewrite Nat.even_sub by exact Hi. now destruct (Nat.even k), (Nat.even i).
Qed.
