(** * Edge collapses into closed fans, k = 3 ... 8

    One section of the certificate serves all positions of the same k. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Table Checker Rows Symmetry Tables_collapse Rows_collapse.

Definition full (k a : nat) : trie := Tables_collapse.table [k; a].
Definition by_key (k : nat) : trie := reduced true (closed_fan k) (Rows_collapse.rows [k]).

Definition positions : list (nat * nat) := filter (fun '(k, a) => 2 * a <=? k) (list_prod (seq 3 6) (seq 1 4)).
Definition checks (at_ : nat * nat) : bool :=
  let '(k, a) := at_ in check (collapse k a) 1 0 (agrees true (by_key k)) (full k a).

Theorem all_checked : forallb checks positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma checked k a : 3 <= k <= 8 -> 1 <= a -> 2 * a <= k -> checks (k, a) = true.
Proof.
  intros Hk Ha Hka. apply (proj1 (forallb_forall checks positions) all_checked). apply filter_In. split.
  - apply in_prod; apply in_seq; lia.
  - now apply Nat.leb_le.
Qed.

(** The other positions: the fan is turned so that A and D change places. *)
Definition others : list (nat * nat) := filter (fun '(k, a) => (a <? k) && (k <? 2 * a)) (list_prod (seq 3 6) (seq 1 7)).
Definition compares (at_ : nat * nat) : bool :=
  let '(k, a) := at_ in compare (turned k a) (collapse k a) (collapse k (k - a)) (full k (k - a)) (full k a).

Theorem all_compared : forallb compares others = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem every_position k a : 3 <= k <= 8 -> 1 <= a < k ->
  holds (collapse k a) 1 0 (full k a).
Proof.
  intros Hk Ha. destruct (le_lt_dec (2 * a) k) as [H|H].
  - eapply check_holds. apply (checked k a); lia.
  - apply compare_holds with (turned k a) (collapse k (k - a)) (full k (k - a)).
    + apply (proj1 (forallb_forall compares others) all_compared (k, a)). apply filter_In.
      split; [apply in_prod; apply in_seq; lia|]. apply andb_true_intro. split; apply Nat.ltb_lt; lia.
    + eapply check_holds. apply (checked k (k - a)); lia.
Qed.
