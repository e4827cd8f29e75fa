(** * Vertex splits of closed fans, k = 3 ... 8 *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Spec Table Checker Rows Tables_split Rows_split.

(** The shipped table of position (k, a), and the certificate's rows for it. *)
Definition full (k a : nat) : trie := Tables_split.table [k; a].
Definition by_key (k a : nat) : trie := reduced true (after (split k a)) (Rows_split.rows [k; a]).

Definition positions : list (nat * nat) := filter (fun '(k, a) => 2 * a <=? k) (list_prod (seq 3 6) (seq 1 4)).
Definition checks (at_ : nat * nat) : bool :=
  let '(k, a) := at_ in check (split k a) (if a =? 1 then 0 else 1) 0 (agrees true (by_key k a)) (full k a).

Theorem all_checked : forallb checks positions = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma checked k a : 3 <= k <= 8 -> 1 <= a -> 2 * a <= k -> checks (k, a) = true.
Proof.
  intros Hk Ha Hka. apply (proj1 (forallb_forall checks positions) all_checked). apply filter_In. split.
  - apply in_prod; apply in_seq; lia.
  - now apply Nat.leb_le.
Qed.
