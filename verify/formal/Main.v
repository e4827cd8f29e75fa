(** * The theorems

    Each is stated with the words of [Spec.v] alone, apart from the tables: [Split.full k a] and its like are the
    shipped tables, [Split.by_key k a] and its like the reduced tables of the certificates. For each family:

    - _rules_: the table answers exactly the valid configurations, and its answer is legal and best;
    - _safe_: every answer keeps every mesh around the patch valid;
    - _facts_: how many strips and isolated triangles an answer may add;
    - _reduced_: the certificate's rows, found by key and through their symmetries, say the same as the full table.

    After each theorem Coq prints what it assumes; scripts/prove.sh wants to see "Closed under the global context". *)
Require Import Arith Bool List NArith.
Import ListNotations.
Require Import Spec Graph Locality Strips Table Rows.
Require Split Collapse OpenSplit OpenCollapse BoundarySplit BoundaryCollapse Flip Figures Rejects.

(** ** Graphs *)
Theorem locality : forall p, sensible p (before p) -> sensible p (after p) -> forall s c x,
  length x = length (inner (after p)) -> valid (drawing (before p) s c) ->
  (legal p s c x <->
   forall O, rest_of_mesh p O -> valid (O ++ drawing (before p) s c) -> valid (O ++ drawing (after p) s x)).
Proof. exact Locality.locality. Qed.
Print Assumptions locality.

(** "strips = nodes - solid edges" *)
Theorem valid_is_stripped : forall vs G, NoDup vs -> (forall e, In e G -> In (fst e) vs /\ In (snd e) vs) ->
  (valid G <-> exists strips, stripped vs G strips /\ length strips + length G = length vs).
Proof. exact Strips.valid_is_stripped. Qed.
Print Assumptions valid_is_stripped.

(** ** Closed fans, splits *)
Theorem split_rules : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  correct (split k a) (lookup (Split.full k a)).
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Split.checked k a H0 H1 H2)). Qed.
Print Assumptions split_rules.
Theorem split_safe : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  safe (split k a) (lookup (Split.full k a)).
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Split.checked k a H0 H1 H2)). Qed.
Print Assumptions split_safe.
(** At most one strip more, none when a = 1; isolated triangles never increase. *)
Theorem split_facts : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  within (split k a) (lookup (Split.full k a)) (if a =? 1 then 0 else 1) 0.
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Split.checked k a H0 H1 H2)). Qed.
Print Assumptions split_facts.
Theorem split_reduced : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  reduces_to (split k a) true (lookup (Split.full k a)) (lookup (Split.by_key k a)).
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Split.checked k a H0 H1 H2)). Qed.
Print Assumptions split_reduced.

(** ** Closed fans, collapses *)
Theorem collapse_rules : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  correct (collapse k a) (lookup (Collapse.full k a)).
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Collapse.checked k a H0 H1 H2)). Qed.
Print Assumptions collapse_rules.
Theorem collapse_safe : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  safe (collapse k a) (lookup (Collapse.full k a)).
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Collapse.checked k a H0 H1 H2)). Qed.
Print Assumptions collapse_safe.
(** At most one strip more; isolated triangles never increase. *)
Theorem collapse_facts : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  within (collapse k a) (lookup (Collapse.full k a)) 1 0.
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Collapse.checked k a H0 H1 H2)). Qed.
Print Assumptions collapse_facts.
Theorem collapse_reduced : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  reduces_to (collapse k a) true (lookup (Collapse.full k a)) (lookup (Collapse.by_key k)).
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Collapse.checked k a H0 H1 H2)). Qed.
Print Assumptions collapse_reduced.

(** ** Open fans, splits *)
Theorem open_split_rules : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  correct (open_split k i j) (lookup (OpenSplit.full k i j)).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenSplit.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_split_rules.
Theorem open_split_safe : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  safe (open_split k i j) (lookup (OpenSplit.full k i j)).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenSplit.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_split_safe.
(** At most one strip more, none for neighbouring gaps; isolated triangles never increase. *)
Theorem open_split_facts : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  within (open_split k i j) (lookup (OpenSplit.full k i j)) (if j =? S i then 0 else 1) 0.
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenSplit.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_split_facts.
Theorem open_split_reduced : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  reduces_to (open_split k i j) false (lookup (OpenSplit.full k i j)) (lookup (OpenSplit.by_key k i j)).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenSplit.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_split_reduced.

(** ** Open fans, collapses *)
Theorem open_collapse_rules : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  correct (open_collapse k i j) (lookup (OpenCollapse.full k i j)).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenCollapse.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_collapse_rules.
Theorem open_collapse_safe : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  safe (open_collapse k i j) (lookup (OpenCollapse.full k i j)).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenCollapse.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_collapse_safe.
(** At most one strip more; one isolated triangle more at most, and only when k is odd. *)
Theorem open_collapse_facts : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  within (open_collapse k i j) (lookup (OpenCollapse.full k i j)) 1 (if Nat.even k then 0 else 1).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenCollapse.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_collapse_facts.
Theorem open_collapse_reduced : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  reduces_to (open_collapse k i j) false (lookup (OpenCollapse.full k i j)) (lookup (OpenCollapse.by_key k)).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenCollapse.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_collapse_reduced.

(** ** Open fans, splits on the boundary *)
Theorem boundary_split_rules : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  correct (boundary_split k i) (lookup (BoundarySplit.full k i)).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundarySplit.checked k i H0 H1)). Qed.
Print Assumptions boundary_split_rules.
Theorem boundary_split_safe : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  safe (boundary_split k i) (lookup (BoundarySplit.full k i)).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundarySplit.checked k i H0 H1)). Qed.
Print Assumptions boundary_split_safe.
(** At most one strip more, none at gap 1; one isolated triangle more at most, and only when k and the gap are even. *)
Theorem boundary_split_facts : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  within (boundary_split k i) (lookup (BoundarySplit.full k i))
    (if i =? 1 then 0 else 1) (if Nat.even k && Nat.even i then 1 else 0).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundarySplit.checked k i H0 H1)). Qed.
Print Assumptions boundary_split_facts.
Theorem boundary_split_reduced : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  reduces_to (boundary_split k i) false (lookup (BoundarySplit.full k i)) (lookup (BoundarySplit.by_key k i)).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundarySplit.checked k i H0 H1)). Qed.
Print Assumptions boundary_split_reduced.

(** ** Open fans, collapses on the boundary *)
Theorem boundary_collapse_rules : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  correct (boundary_collapse k i) (lookup (BoundaryCollapse.full k i)).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundaryCollapse.checked k i H0 H1)). Qed.
Print Assumptions boundary_collapse_rules.
Theorem boundary_collapse_safe : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  safe (boundary_collapse k i) (lookup (BoundaryCollapse.full k i)).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundaryCollapse.checked k i H0 H1)). Qed.
Print Assumptions boundary_collapse_safe.
(** At most one strip more; one isolated triangle more at most, and only when k is odd. *)
Theorem boundary_collapse_facts : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  within (boundary_collapse k i) (lookup (BoundaryCollapse.full k i)) 1 (if Nat.even k then 0 else 1).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundaryCollapse.checked k i H0 H1)). Qed.
Print Assumptions boundary_collapse_facts.
Theorem boundary_collapse_reduced : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  reduces_to (boundary_collapse k i) false (lookup (BoundaryCollapse.full k i)) (lookup (BoundaryCollapse.by_key k)).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundaryCollapse.checked k i H0 H1)). Qed.
Print Assumptions boundary_collapse_reduced.

(** ** Flips *)
Theorem flip_rules : flip_correct (lookup Flip.full).
Proof. exact Flip.flip_rules. Qed.
Print Assumptions flip_rules.
Theorem flip_safe : flip_safe (lookup Flip.full).
Proof. exact Flip.flip_is_safe. Qed.
Print Assumptions flip_safe.
(** At most one strip more; at most two isolated triangles more, a port given up counted as one. *)
Theorem flip_facts : flip_within (lookup Flip.full) 1 2.
Proof. exact Flip.flip_facts. Qed.
Print Assumptions flip_facts.

(** ** The known counts, for k = 3, 4, ... and a = 1, 2, ...: valid configurations, and those that cost a strip *)
Theorem valid_splits : map (fun k => map (fun a => Figures.valid_configurations k (Split.full k a)) (seq 1 (k / 2))) (seq 3 6) =
  [[44]; [160; 160]; [572; 572]; [2040; 2040; 2040]; [7268; 7268; 7268]; [25888; 25888; 25888; 25888]]%N.
Proof. exact Figures.valid_splits. Qed.
Print Assumptions valid_splits.
Theorem costing_splits : map (fun k => map (fun a => Figures.costing_split k (Split.full k a)) (seq 1 (k / 2))) (seq 3 6) =
  [[0]; [0; 2]; [0; 6]; [0; 14; 19]; [0; 40; 44]; [0; 102; 118; 110]]%N.
Proof. exact Figures.costing_splits. Qed.
Print Assumptions costing_splits.
Theorem valid_collapses : map (fun k => map (fun a => Figures.valid_configurations k (Collapse.full k a)) (seq 1 (k / 2))) (seq 3 5) =
  [[278]; [998; 1016]; [3562; 3640]; [12694; 12988; 13032]; [45218; 46280; 46492]]%N.
Proof. exact Figures.valid_collapses. Qed.
Print Assumptions valid_collapses.
Theorem costing_collapses : map (fun k => map (fun a => Figures.costing_collapse k (Collapse.full k a)) (seq 1 (k / 2))) (seq 3 5) =
  [[0]; [1; 4]; [7; 28]; [23; 83; 104]; [67; 238; 321]]%N.
Proof. exact Figures.costing_collapses. Qed.
Print Assumptions costing_collapses.

(** ** Wrong tables are refused *)
Theorem wrong_tables_refused : length (Rejects.wrong_tables 3 1) = 348 /\ Rejects.refused 3 1 && Rejects.refused 4 2 = true.
Proof. exact Rejects.wrong_tables_refused. Qed.
Print Assumptions wrong_tables_refused.
Theorem wrong_rows_refused : Rejects.rows_refused 3 1 && Rejects.rows_refused 4 2 = true.
Proof. exact Rejects.wrong_rows_refused. Qed.
Print Assumptions wrong_rows_refused.
