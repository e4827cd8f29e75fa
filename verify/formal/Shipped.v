(** * The shipped tables, position by position *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Table Checker Rows Symmetry.
Require Split Collapse OpenSplit OpenCollapse BoundarySplit BoundaryCollapse.

(** What the shipped headers answer to fans of at most eight triangles, and the reduced tables of the certificates. *)
Definition shipped (o : position) : table :=
  lookup match o with
         | split_at k a => Split.full k a | collapse_at k a => Collapse.full k a
         | open_split_at k i j => OpenSplit.full k i j | open_collapse_at k i j => OpenCollapse.full k i j
         | boundary_split_at k i => BoundarySplit.full k i | boundary_collapse_at k i => BoundaryCollapse.full k i
         end.
Definition by_key (o : position) : table :=
  lookup match o with
         | split_at k a => Split.by_key k a | collapse_at k _ => Collapse.by_key k
         | _ => Nothing
         end.
Ltac bounds := cbn [possible valence_at listed] in *; rewrite ?andb_true_iff, ?Nat.leb_le, ?Nat.ltb_lt in *.

Lemma within_more p T strips alone alone' : within p T strips alone -> alone <= alone' -> within p T strips alone'.
Proof. intros W H s c x Ls Lc E. destruct (W s c x Ls Lc E). split; lia. Qed.

Theorem rules_right : Rules_right shipped.
Proof.
  intros [k a|k a|k i j|k i j|k i|k i] Po K; bounds.
  - apply (Split.every_position k a); lia.
  - apply (Collapse.every_position k a); lia.
  - apply (OpenSplit.every_position k i j); lia.
  - apply (OpenCollapse.every_position k i j); lia.
  - destruct (BoundarySplit.every_position k i) as (C & S & W); [lia|lia|]. split; [exact C|]. split; [exact S|].
    eapply within_more; [exact W|]. cbn [isolated_at]. destruct (Nat.even k), (Nat.even i); cbn; lia.
  - apply (BoundaryCollapse.every_position k i); lia.
Qed.
Theorem even_gaps : Even_gaps shipped.
Proof. intros k i K Hi. apply (BoundarySplit.every_position k i K Hi). Qed.

Theorem rows_say_the_same : Rows_say_the_same shipped by_key.
Proof.
  intros [k a|k a|k i j|k i j|k i|k i] Po K L; bounds; try discriminate.
  - apply (check_proves _ _ _ _ _ _ (Split.checked k a ltac:(lia) ltac:(lia) ltac:(lia))).
  - apply (check_proves _ _ _ _ _ _ (Collapse.checked k a ltac:(lia) ltac:(lia) ltac:(lia))).
Qed.
