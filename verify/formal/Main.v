(** * The theorems

    Each is stated with the words of [Spec.v] alone, apart from the tables: [Split.full k a] and its like are the
    shipped tables, [Split.by_key k a] and its like the reduced tables of the certificates. The words for other things come
    from other files: lists of linked rules from [Linked.v], the look-up in the automaton from [Header.v], whole meshes
    from [Sequences.v], [WholeMesh.v] and [LowerBound.v], index buffers from [FlowBound.v], what answers tell from [Told.v].
    For each family:

    - _rules_: the table answers exactly the valid configurations, and its answer is legal and best;
    - _safe_: every answer keeps every mesh around the patch valid;
    - _facts_: how many strips and isolated triangles an answer may add;
    - _reduced_: the certificate's rows, found by key and through their symmetries, say the same as the full table, in
      the positions that certificates have (a <= k / 2, and the like).

    The first three hold in every position, for every answer that the shipped headers give.

    After each theorem Coq prints what it assumes; scripts/prove.sh wants to see "Closed under the global context". *)
Require Import Arith Bool List NArith ZArith.
Import ListNotations.
Require Import Spec Graph Locality Strips Table Rows Linked Sequences WholeMesh.
Require Split Collapse OpenSplit OpenCollapse BoundarySplit BoundaryCollapse Flip Figures Rejects Answers LinkedTables Shipped Met LowerBound FlowBound.
Require EveryFan EverySplit EveryCollapse EveryOpen EveryBoundary EverySize EveryFigures.
Require Header Meetings AutomatonNumbers Automaton Served AutomatonRejects.
Require Told ToldNumbers Tables_split Tables_collapse Tables_open_split Tables_open_collapse Tables_boundary_split Tables_boundary_collapse Tables_flip.

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
Theorem split_rules : forall k a, 3 <= k <= 8 -> 1 <= a < k ->
  correct (split k a) (lookup (Split.full k a)).
Proof. intros k a H0 H1. apply (Split.every_position k a H0 H1). Qed.
Print Assumptions split_rules.
Theorem split_safe : forall k a, 3 <= k <= 8 -> 1 <= a < k ->
  safe (split k a) (lookup (Split.full k a)).
Proof. intros k a H0 H1. apply (Split.every_position k a H0 H1). Qed.
Print Assumptions split_safe.
(** At most one strip more, none when one of the arcs is a single triangle; isolated triangles never increase. *)
Theorem split_facts : forall k a, 3 <= k <= 8 -> 1 <= a < k ->
  within (split k a) (lookup (Split.full k a)) (if Nat.min a (k - a) =? 1 then 0 else 1) 0.
Proof. intros k a H0 H1. apply (Split.every_position k a H0 H1). Qed.
Print Assumptions split_facts.
Theorem split_reduced : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  reduces_to (split k a) true (lookup (Split.full k a)) (lookup (Split.by_key k a)).
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Split.checked k a H0 H1 H2)). Qed.
Print Assumptions split_reduced.

(** ** Closed fans, collapses *)
Theorem collapse_rules : forall k a, 3 <= k <= 8 -> 1 <= a < k ->
  correct (collapse k a) (lookup (Collapse.full k a)).
Proof. intros k a H0 H1. apply (Collapse.every_position k a H0 H1). Qed.
Print Assumptions collapse_rules.
Theorem collapse_safe : forall k a, 3 <= k <= 8 -> 1 <= a < k ->
  safe (collapse k a) (lookup (Collapse.full k a)).
Proof. intros k a H0 H1. apply (Collapse.every_position k a H0 H1). Qed.
Print Assumptions collapse_safe.
(** At most one strip more; isolated triangles never increase. *)
Theorem collapse_facts : forall k a, 3 <= k <= 8 -> 1 <= a < k ->
  within (collapse k a) (lookup (Collapse.full k a)) 1 0.
Proof. intros k a H0 H1. apply (Collapse.every_position k a H0 H1). Qed.
Print Assumptions collapse_facts.
Theorem collapse_reduced : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  reduces_to (collapse k a) true (lookup (Collapse.full k a)) (lookup (Collapse.by_key k)).
Proof. intros k a H0 H1 H2. apply (check_proves _ _ _ _ _ _ (Collapse.checked k a H0 H1 H2)). Qed.
Print Assumptions collapse_reduced.

(** ** Open fans, splits *)
Theorem open_split_rules : forall k i j, 1 <= k <= 8 -> i < j <= k ->
  correct (open_split k i j) (lookup (OpenSplit.full k i j)).
Proof. intros k i j H0 H1. apply (OpenSplit.every_position k i j H0 H1). Qed.
Print Assumptions open_split_rules.
Theorem open_split_safe : forall k i j, 1 <= k <= 8 -> i < j <= k ->
  safe (open_split k i j) (lookup (OpenSplit.full k i j)).
Proof. intros k i j H0 H1. apply (OpenSplit.every_position k i j H0 H1). Qed.
Print Assumptions open_split_safe.
(** At most one strip more, none for neighbouring gaps; isolated triangles never increase. *)
Theorem open_split_facts : forall k i j, 1 <= k <= 8 -> i < j <= k ->
  within (open_split k i j) (lookup (OpenSplit.full k i j)) (if j =? S i then 0 else 1) 0.
Proof. intros k i j H0 H1. apply (OpenSplit.every_position k i j H0 H1). Qed.
Print Assumptions open_split_facts.
Theorem open_split_reduced : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  reduces_to (open_split k i j) false (lookup (OpenSplit.full k i j)) (lookup (OpenSplit.by_key k i j)).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenSplit.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_split_reduced.

(** ** Open fans, collapses *)
Theorem open_collapse_rules : forall k i j, 1 <= k <= 8 -> i < j <= k ->
  correct (open_collapse k i j) (lookup (OpenCollapse.full k i j)).
Proof. intros k i j H0 H1. apply (OpenCollapse.every_position k i j H0 H1). Qed.
Print Assumptions open_collapse_rules.
Theorem open_collapse_safe : forall k i j, 1 <= k <= 8 -> i < j <= k ->
  safe (open_collapse k i j) (lookup (OpenCollapse.full k i j)).
Proof. intros k i j H0 H1. apply (OpenCollapse.every_position k i j H0 H1). Qed.
Print Assumptions open_collapse_safe.
(** At most one strip more; one isolated triangle more at most, and only when k is odd. *)
Theorem open_collapse_facts : forall k i j, 1 <= k <= 8 -> i < j <= k ->
  within (open_collapse k i j) (lookup (OpenCollapse.full k i j)) 1 (if Nat.even k then 0 else 1).
Proof. intros k i j H0 H1. apply (OpenCollapse.every_position k i j H0 H1). Qed.
Print Assumptions open_collapse_facts.
Theorem open_collapse_reduced : forall k i j, 1 <= k <= 8 -> i < j -> i + j <= k ->
  reduces_to (open_collapse k i j) false (lookup (OpenCollapse.full k i j)) (lookup (OpenCollapse.by_key k)).
Proof. intros k i j H0 H1 H2. apply (check_proves _ _ _ _ _ _ (OpenCollapse.checked k i j H0 H1 H2)). Qed.
Print Assumptions open_collapse_reduced.

(** ** Open fans, splits on the boundary *)
Theorem boundary_split_rules : forall k i, 1 <= k <= 8 -> i <= k ->
  correct (boundary_split k i) (lookup (BoundarySplit.full k i)).
Proof. intros k i H0 H1. apply (BoundarySplit.every_position k i H0 H1). Qed.
Print Assumptions boundary_split_rules.
Theorem boundary_split_safe : forall k i, 1 <= k <= 8 -> i <= k ->
  safe (boundary_split k i) (lookup (BoundarySplit.full k i)).
Proof. intros k i H0 H1. apply (BoundarySplit.every_position k i H0 H1). Qed.
Print Assumptions boundary_split_safe.
(** At most one strip more, none at gaps 1 and k - 1; one isolated triangle more at most, and only when k and the gap are even. *)
Theorem boundary_split_facts : forall k i, 1 <= k <= 8 -> i <= k ->
  within (boundary_split k i) (lookup (BoundarySplit.full k i))
    (if Nat.min i (k - i) =? 1 then 0 else 1) (if Nat.even k && Nat.even i then 1 else 0).
Proof. intros k i H0 H1. apply (BoundarySplit.every_position k i H0 H1). Qed.
Print Assumptions boundary_split_facts.
Theorem boundary_split_reduced : forall k i, 1 <= k <= 8 -> 2 * i <= k ->
  reduces_to (boundary_split k i) false (lookup (BoundarySplit.full k i)) (lookup (BoundarySplit.by_key k i)).
Proof. intros k i H0 H1. apply (check_proves _ _ _ _ _ _ (BoundarySplit.checked k i H0 H1)). Qed.
Print Assumptions boundary_split_reduced.

(** ** Open fans, collapses on the boundary *)
Theorem boundary_collapse_rules : forall k i, 1 <= k <= 8 -> i <= k ->
  correct (boundary_collapse k i) (lookup (BoundaryCollapse.full k i)).
Proof. intros k i H0 H1. apply (BoundaryCollapse.every_position k i H0 H1). Qed.
Print Assumptions boundary_collapse_rules.
Theorem boundary_collapse_safe : forall k i, 1 <= k <= 8 -> i <= k ->
  safe (boundary_collapse k i) (lookup (BoundaryCollapse.full k i)).
Proof. intros k i H0 H1. apply (BoundaryCollapse.every_position k i H0 H1). Qed.
Print Assumptions boundary_collapse_safe.
(** Never a strip more; one isolated triangle more at most, and only when k is odd. *)
Theorem boundary_collapse_facts : forall k i, 1 <= k <= 8 -> i <= k ->
  within (boundary_collapse k i) (lookup (BoundaryCollapse.full k i)) 0 (if Nat.even k then 0 else 1).
Proof. intros k i H0 H1. apply (BoundaryCollapse.every_position k i H0 H1). Qed.
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

(** ** All of it together

    Every answer of the shipped headers to a fan of at most eight triangles, position by position; [Answers.counts] says
    how many there are. *)
Theorem answers : Forall (fun '(k, a) => correct (split k a) (lookup (Split.full k a))) Answers.arcs /\
  Forall (fun '(k, a) => correct (collapse k a) (lookup (Collapse.full k a))) Answers.arcs /\
  Forall (fun '(k, i, j) => correct (open_split k i j) (lookup (OpenSplit.full k i j))) Answers.gap_pairs /\
  Forall (fun '(k, i, j) => correct (open_collapse k i j) (lookup (OpenCollapse.full k i j))) Answers.gap_pairs /\
  Forall (fun '(k, i) => correct (boundary_split k i) (lookup (BoundarySplit.full k i))) Answers.gaps /\
  Forall (fun '(k, i) => correct (boundary_collapse k i) (lookup (BoundaryCollapse.full k i))) Answers.gaps.
Proof. exact Answers.all_correct. Qed.
Print Assumptions answers.

(** ** Every k

    The answers of [EveryFan.v] are computed by a fold along the fan that keeps, for each way in which what has been drawn so
    far can meet the rest, one best colouring. They are correct for every number of triangles and every position, and keep
    every mesh valid. The facts hold for every k, too, and with them for every correct table ([correct_tables_cost]): two correct
    tables differ only in which of the best recolourings they give. *)
Theorem every_split : forall k a, 3 <= k -> 1 <= a < k ->
  correct (split k a) (EveryFan.split_answer k a) /\ safe (split k a) (EveryFan.split_answer k a).
Proof. exact EveryFan.split_right. Qed.
Print Assumptions every_split.
(** At most one strip more, none when one of the arcs is a single triangle; isolated triangles never increase. *)
Theorem every_split_facts : forall k a, 3 <= k -> 1 <= a < k ->
  within (split k a) (EveryFan.split_answer k a) (if Nat.min a (k - a) =? 1 then 0 else 1) 0.
Proof. exact EverySplit.split_within. Qed.
Print Assumptions every_split_facts.
Theorem every_collapse : forall k a, 3 <= k -> 1 <= a < k ->
  correct (collapse k a) (EveryFan.collapse_answer k a) /\ safe (collapse k a) (EveryFan.collapse_answer k a).
Proof. exact EveryFan.collapse_right. Qed.
Print Assumptions every_collapse.
(** At most one strip more; isolated triangles never increase. *)
Theorem every_collapse_facts : forall k a, 3 <= k -> 1 <= a < k ->
  within (collapse k a) (EveryFan.collapse_answer k a) 1 0.
Proof. exact EveryCollapse.collapse_within. Qed.
Print Assumptions every_collapse_facts.
Theorem every_open_split : forall k i j, 1 <= k -> i < j <= k ->
  correct (open_split k i j) (EveryFan.open_split_answer k i j) /\ safe (open_split k i j) (EveryFan.open_split_answer k i j).
Proof. exact EveryFan.open_split_right. Qed.
Print Assumptions every_open_split.
(** At most one strip more, none for neighbouring gaps; isolated triangles never increase. *)
Theorem every_open_split_facts : forall k i j, 1 <= k -> i < j <= k ->
  within (open_split k i j) (EveryFan.open_split_answer k i j) (if j =? S i then 0 else 1) 0.
Proof. exact EveryOpen.open_split_within. Qed.
Print Assumptions every_open_split_facts.
Theorem every_open_collapse : forall k i j, 1 <= k -> i < j <= k ->
  correct (open_collapse k i j) (EveryFan.open_collapse_answer k i j) /\ safe (open_collapse k i j) (EveryFan.open_collapse_answer k i j).
Proof. exact EveryFan.open_collapse_right. Qed.
Print Assumptions every_open_collapse.
(** At most one strip more; one isolated triangle more at most, and only when k is odd. *)
Theorem every_open_collapse_facts : forall k i j, 1 <= k -> i < j <= k ->
  within (open_collapse k i j) (EveryFan.open_collapse_answer k i j) 1 (if Nat.even k then 0 else 1).
Proof. exact EveryBoundary.open_collapse_within. Qed.
Print Assumptions every_open_collapse_facts.
Theorem every_boundary_split : forall k i, 1 <= k -> i <= k ->
  correct (boundary_split k i) (EveryFan.boundary_split_answer k i) /\ safe (boundary_split k i) (EveryFan.boundary_split_answer k i).
Proof. exact EveryFan.boundary_split_right. Qed.
Print Assumptions every_boundary_split.
(** At most one strip more, none at gaps 1 and k - 1; one isolated triangle more at most, and only when k is even. *)
Theorem every_boundary_split_facts : forall k i, 1 <= k -> i <= k ->
  within (boundary_split k i) (EveryFan.boundary_split_answer k i) (if Nat.min i (k - i) =? 1 then 0 else 1) (if Nat.even k then 1 else 0).
Proof. exact EveryBoundary.boundary_split_within. Qed.
Print Assumptions every_boundary_split_facts.
Theorem every_boundary_collapse : forall k i, 1 <= k -> i <= k ->
  correct (boundary_collapse k i) (EveryFan.boundary_collapse_answer k i) /\ safe (boundary_collapse k i) (EveryFan.boundary_collapse_answer k i).
Proof. exact EveryFan.boundary_collapse_right. Qed.
Print Assumptions every_boundary_collapse.
(** Never a strip more; one isolated triangle more at most, and only when k is odd. *)
Theorem every_boundary_collapse_facts : forall k i, 1 <= k -> i <= k ->
  within (boundary_collapse k i) (EveryFan.boundary_collapse_answer k i) 0 (if Nat.even k then 0 else 1).
Proof. exact EveryBoundary.boundary_collapse_within. Qed.
Print Assumptions every_boundary_collapse_facts.
(** The known counts of valid configurations and of those that cost a strip, k = 3, 4, 5, out of these answers. *)
Theorem every_counts : map (fun k => map (EveryFigures.split_counts k) (seq 1 (k / 2))) (seq 3 3) =
  [[(44, 0)]; [(160, 0); (160, 2)]; [(572, 0); (572, 6)]]%N.
Proof. exact EveryFigures.counted. Qed.
Print Assumptions every_counts.
Theorem correct_tables_agree : forall p T U s c x, correct p T -> correct p U -> length s = ports p ->
  length c = length (inner (before p)) -> T s c = Some x ->
  exists y, U s c = Some y /\ solids x = solids y /\ isolated (after p) s x = isolated (after p) s y.
Proof. exact EverySize.correct_agree. Qed.
Print Assumptions correct_tables_agree.
Theorem correct_tables_cost : forall p T U strips alone, correct p T -> correct p U ->
  within p T strips alone -> within p U strips alone.
Proof. exact EverySize.correct_within. Qed.
Print Assumptions correct_tables_cost.

(** ** The shipped automaton

    The numbers of automaton.hpp, and the look-up of [Header.v], which says what arc_walk.hpp does with them. For every k and every
    position: the table of its answers is correct, keeps every mesh valid, and the answer is a function of the key. No read of
    the look-up leaves its array ([automaton_inside]). [automaton_looked_up] and [automaton_told] compare what the look-up
    says with what the compiled one says, for every key of every position with k <= 7 and k <= 5; the last theorem sees
    automata refused in which one bit was changed or an array is too short. *)
Definition serves (p : patch) (closed : bool) (answer : coloring -> coloring -> coloring) : Prop :=
  exists T, correct p T /\ safe p T /\ reduces_to p closed T (fun s J => Some (answer s J)).
Theorem automaton_split : forall k a, 3 <= k -> 1 <= a < k ->
  serves (split k a) true (Header.split_answer Automaton.automaton k a).
Proof. exact (Served.split_served _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_split.
Theorem automaton_collapse : forall k a, 3 <= k -> 1 <= a < k ->
  serves (collapse k a) true (Header.collapse_answer Automaton.automaton k).
Proof. exact (Served.collapse_served _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_collapse.
Theorem automaton_open_split : forall k i j, 1 <= k -> i < j <= k ->
  serves (open_split k i j) false (Header.open_split_answer Automaton.automaton k i j).
Proof. exact (Served.open_split_served _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_open_split.
Theorem automaton_open_collapse : forall k i j, 1 <= k -> i < j <= k ->
  serves (open_collapse k i j) false (Header.fan_collapse_answer Automaton.automaton k).
Proof. exact (Served.open_collapse_served _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_open_collapse.
Theorem automaton_boundary_split : forall k i, 1 <= k -> i <= k ->
  serves (boundary_split k i) false (Header.boundary_split_answer Automaton.automaton k i).
Proof. exact (Served.boundary_split_served _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_boundary_split.
Theorem automaton_boundary_collapse : forall k i, 1 <= k -> i <= k ->
  serves (boundary_collapse k i) false (Header.fan_collapse_answer Automaton.automaton k).
Proof. exact (Served.boundary_collapse_served _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_boundary_collapse.
(** Whatever is behind the arrays of an automaton, in memory that is not theirs, the answers are the same. *)
Theorem automaton_inside : forall H, Header.same_inside Automaton.automaton H ->
  (forall k a s J, 1 <= a < k -> Header.split_answer H k a s J = Header.split_answer Automaton.automaton k a s J) /\
  (forall k s J, 1 <= k -> Header.collapse_answer H k s J = Header.collapse_answer Automaton.automaton k s J) /\
  (forall k i j s J, i < j <= k -> Header.open_split_answer H k i j s J = Header.open_split_answer Automaton.automaton k i j s J) /\
  (forall k i s J, Header.boundary_split_answer H k i s J = Header.boundary_split_answer Automaton.automaton k i s J) /\
  (forall k s J, Header.fan_collapse_answer H k s J = Header.fan_collapse_answer Automaton.automaton k s J).
Proof. exact (Served.served_inside _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_inside.
Theorem automaton_looked_up : map fst AutomatonNumbers.digests = Header.positions 7 /\
  forallb (fun d => N.eqb (Header.digest_at Automaton.automaton (fst (fst d)) (snd (fst d))) (snd d)) AutomatonNumbers.digests = true.
Proof. exact Automaton.looked_up. Qed.
Print Assumptions automaton_looked_up.
(** What it tells of them: solid inner edges, and isolated triangles. *)
Theorem automaton_told :
  map fst (filter (Automaton.small 5) AutomatonNumbers.told_digests) = Header.positions 5 /\
  forallb (fun d => N.eqb (Automaton.told_at Automaton.automaton (fst (fst d)) (snd (fst d))) (snd d))
    (filter (Automaton.small 5) AutomatonNumbers.told_digests) = true.
Proof. exact Automaton.looked_up_told. Qed.
Print Assumptions automaton_told.
Theorem wrong_automata_refused : forallb (fun H => negb (Meetings.header_ok H)) AutomatonRejects.wrong_automata = true.
Proof. exact AutomatonRejects.wrong_automata_refused. Qed.
Print Assumptions wrong_automata_refused.

(** ** What answers tell

    What the headers tell of strips and isolated triangles, for fans of up to five triangles and for flips; [Told.v] says
    what is listed. [sequence_told] below speaks of the changes that are told. *)
Theorem answers_tell :
  Forall (fun at_ => Told.tells false (Told.of_two split at_) (Told.two Tables_split.table at_) (Told.two ToldNumbers.split at_)) Told.arcs /\
  Forall (fun at_ => Told.tells false (Told.of_two collapse at_) (Told.two Tables_collapse.table at_) (Told.two ToldNumbers.collapse at_)) Told.arcs /\
  Forall (fun at_ => Told.tells false (Told.of_three open_split at_) (Told.three Tables_open_split.table at_) (Told.three ToldNumbers.open_split at_)) Told.gap_pairs /\
  Forall (fun at_ => Told.tells false (Told.of_three open_collapse at_) (Told.three Tables_open_collapse.table at_) (Told.three ToldNumbers.open_collapse at_)) Told.gap_pairs /\
  Forall (fun at_ => Told.tells false (Told.of_two boundary_split at_) (Told.two Tables_boundary_split.table at_) (Told.two ToldNumbers.boundary_split at_)) Told.gaps /\
  Forall (fun at_ => Told.tells false (Told.of_two boundary_collapse at_) (Told.two Tables_boundary_collapse.table at_) (Told.two ToldNumbers.boundary_collapse at_)) Told.gaps /\
  Told.tells true flip (Tables_flip.table []) (ToldNumbers.flip []).
Proof. exact Told.answers_tell. Qed.
Print Assumptions answers_tell.

(** ** Linked rules

    Beside every outside the first alternative that is valid is as good as every recolouring that is valid there; and
    the pairs that an alternative joins, together with those that the outside joins, tell whether it is valid. *)
Theorem linked_split_best : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  linked_best (split k a) (LinkedTables.split_lists k a).
Proof. intros k a H0 H1 H2. exact (lists_best _ _ (LinkedTables.split_checked k a H0 H1 H2)). Qed.
Print Assumptions linked_split_best.
Theorem linked_split_pairs : forall k a, 3 <= k <= 8 -> 1 <= a -> 2 * a <= k ->
  pairs_tell (split k a) (LinkedTables.split_lists k a).
Proof. intros k a H0 H1 H2. exact (lists_tell _ _ (LinkedTables.split_checked k a H0 H1 H2)). Qed.
Print Assumptions linked_split_pairs.
Theorem linked_collapse_best : forall k a, 3 <= k <= 8 -> 1 <= a < k ->
  linked_best (collapse k a) (LinkedTables.collapse_lists k).
Proof. intros k a H0 H1. exact (lists_best _ _ (LinkedTables.collapse_checked k a H0 H1)). Qed.
Print Assumptions linked_collapse_best.
Theorem linked_collapse_pairs : forall k a, 3 <= k <= 8 -> 1 <= a < k ->
  pairs_tell (collapse k a) (LinkedTables.collapse_lists k).
Proof. intros k a H0 H1. exact (lists_tell _ _ (LinkedTables.collapse_checked k a H0 H1)). Qed.
Print Assumptions linked_collapse_pairs.

(** ** Sequences of operations

    [Sequences.v] says what a mesh and an operation are. The rules are the shipped local ones for fans of at most eight
    triangles; flips are left out. A valid mesh stays valid, and what the rules say of the number of strips adds up to the
    truth. Where no operation is of an edge on the boundary, or a collapse into a boundary vertex, a mesh without isolated
    triangles stays one, and then it never has more strips than half its triangles. *)
(** There are such operations: a split in a mesh of five triangles in two strips makes them one. *)
Theorem operation_met : Shipped.local (split 3 1) (lookup (Split.full 3 1)) /\
  valid (edges Met.mesh_before) /\ strips_of Met.mesh_before = 2%Z /\
  operation (split 3 1) (lookup (Split.full 3 1)) Met.mesh_before (-1) Met.mesh_after /\ strips_of Met.mesh_after = 1%Z.
Proof. exact Met.operation_met. Qed.
Print Assumptions operation_met.
Theorem sequence_valid : forall M told M', sequence Shipped.local M told M' -> valid (edges M) -> valid (edges M').
Proof. exact Shipped.stays_valid. Qed.
Print Assumptions sequence_valid.
Theorem sequence_told : forall M told M', sequence Shipped.local M told M' -> (strips_of M' = strips_of M + told)%Z.
Proof. exact Shipped.strips_told. Qed.
Print Assumptions sequence_told.
Theorem strips_counted : forall M strips, stripped (nodes M) (edges M) strips -> strips_of M = Z.of_nat (length strips).
Proof. exact Sequences.strips_counted. Qed.
Print Assumptions strips_counted.
Theorem sequence_never_isolated : forall M told M', sequence Shipped.local_inside M told M' ->
  none_isolated M -> none_isolated M'.
Proof. exact Shipped.never_isolated. Qed.
Print Assumptions sequence_never_isolated.
Theorem half_as_many_strips : forall M told M', sequence Shipped.local_inside M told M' -> sane M -> none_isolated M ->
  (2 * strips_of M' <= Z.of_nat (length (nodes M')))%Z.
Proof. exact Shipped.half_as_many_strips. Qed.
Print Assumptions half_as_many_strips.

(** The same for fans of any size, whatever correct tables answer. *)
Theorem every_sequence_valid : forall M told M', sequence EverySize.of_any_size M told M' -> valid (edges M) -> valid (edges M').
Proof. exact EverySize.stays_valid. Qed.
Print Assumptions every_sequence_valid.
Theorem every_sequence_told : forall M told M', sequence EverySize.of_any_size M told M' -> (strips_of M' = strips_of M + told)%Z.
Proof. exact EverySize.strips_told. Qed.
Print Assumptions every_sequence_told.
Theorem every_sequence_never_isolated : forall M told M', sequence EverySize.inside_of_any_size M told M' ->
  none_isolated M -> none_isolated M'.
Proof. exact EverySize.never_isolated. Qed.
Print Assumptions every_sequence_never_isolated.
Theorem every_sequence_half_as_many_strips : forall M told M', sequence EverySize.inside_of_any_size M told M' -> sane M ->
  none_isolated M -> (2 * strips_of M' <= Z.of_nat (length (nodes M')))%Z.
Proof. exact EverySize.half_as_many_strips. Qed.
Print Assumptions every_sequence_half_as_many_strips.

(** ** What holds for the whole mesh

    With the definitions at the head of [WholeMesh.v], down to [simple]. In docs/theory.md the five counts are S, T, I, C, B. *)
Theorem whole_mesh : forall M, well_formed M -> ends_joined M ->
  6 * strip_count M <= triangle_count M + 2 * isolated_count M + 2 * own_meetings M + boundary_sides M.
Proof. exact WholeMesh.whole_mesh. Qed.
Print Assumptions whole_mesh.
Theorem whole_mesh_quarter : forall M, well_formed M -> ends_joined M -> simple M ->
  4 * strip_count M <= triangle_count M + boundary_sides M.
Proof. exact WholeMesh.whole_mesh_quarter. Qed.
Print Assumptions whole_mesh_quarter.
(** Every valid colouring of a dual graph is spoken of; and if ends of two strips lie side by side, each such pair counts as well. *)
Theorem whole_mesh_covers : forall ts D c, NoDup ts -> (forall e, In e D -> In (fst e) ts /\ In (snd e) ts) ->
  (forall t, degree D t <= 3) -> length c = length D -> valid (solid D c) ->
  exists ls, well_formed (Stripification ts D c ls).
Proof. exact WholeMesh.whole_mesh_covers. Qed.
Print Assumptions whole_mesh_covers.
Theorem whole_mesh_any : forall M, well_formed M ->
  6 * strip_count M <= triangle_count M + 2 * isolated_count M + 2 * (own_meetings M + other_meetings M) + boundary_sides M.
Proof. exact WholeMesh.whole_mesh_any. Qed.
Print Assumptions whole_mesh_any.
(** The assumptions can be met, and the inequalities be equations: T, S, I, C, B, and the meetings of two strips. Without the
    assumptions the inequalities fail. *)
Theorem whole_mesh_met : Forall (fun '(M, numbers) => well_formed M /\ ends_joined M /\ simple M /\ counts M = numbers)
  [(five, [5; 2; 1; 1; 3; 0]); (tetrahedron, [4; 1; 0; 1; 0; 0]); (bipyramid, [6; 1; 0; 0; 0; 0])].
Proof. exact WholeMesh.whole_mesh_met. Qed.
Print Assumptions whole_mesh_met.
Theorem whole_mesh_needs :
  well_formed halves /\ simple halves /\ counts halves = [4; 2; 0; 0; 0; 4] /\
  well_formed pillow /\ ends_joined pillow /\ counts pillow = [2; 1; 0; 2; 0; 0].
Proof. exact WholeMesh.whole_mesh_needs. Qed.
Print Assumptions whole_mesh_needs.

(** ** A lower bound

    A fan of k = 4, split at a = 2, of which no rule that reads only its patch and keeps its ports avoids a strip more. *)
Theorem every_rule_pays : forall (T : table) x, safe (split 4 2) T -> length x = 7 ->
  T [true; false; false; true] [true; true; true; false] = Some x ->
  triangles (after (split 4 2)) + solids [true; true; true; false] >= triangles (before (split 4 2)) + solids x + 1.
Proof. exact LowerBound.every_rule_pays. Qed.
Print Assumptions every_rule_pays.
(** A mesh of n such fans ([LowerBound.v] draws it) is one strip before; after a split of each by such a rule it has at
    least n + 1; but the mesh after could be one strip. *)
Theorem one_strip_before : forall n, 0 < n ->
  exists strip, stripped (LowerBound.all_triangles (before (split 4 2)) n)
    (LowerBound.solid_edges (before (split 4 2)) (repeat [true; true; true; false] n)) [strip].
Proof. intros n H. eexists. exact (LowerBound.one_strip_before n H). Qed.
Print Assumptions one_strip_before.
Theorem no_rule_competes : forall n (T : table) x strips, 0 < n -> safe (split 4 2) T -> length x = 7 ->
  T [true; false; false; true] [true; true; true; false] = Some x ->
  stripped (LowerBound.all_triangles (after (split 4 2)) n) (LowerBound.solid_edges (after (split 4 2)) (repeat x n)) strips ->
  n + 1 <= length strips.
Proof. exact LowerBound.no_rule_competes. Qed.
Print Assumptions no_rule_competes.
Theorem one_strip_would_do : forall n, 0 < n -> exists G,
  incl (map undirected G) (map undirected (LowerBound.dual_edges (after (split 4 2)) n)) /\
  exists strip, stripped (LowerBound.all_triangles (after (split 4 2)) n) G [strip].
Proof. exact LowerBound.one_strip_would_do. Qed.
Print Assumptions one_strip_would_do.

(** ** Indices

    A buffer draws a mesh when its windows of three different vertices are the triangles. Cuts are sets of vertices with
    multipliers; proper ones are those whose triangles are no multiple of three. *)
Theorem no_buffer_has_fewer : forall mesh runs cuts unit,
  FlowBound.draws mesh runs -> Forall (fun run => 3 <= length run) runs -> runs <> [] ->
  Forall (FlowBound.proper mesh) cuts ->
  (forall x y, FlowBound.edge mesh x y = true -> FlowBound.load cuts (x, y) <= 2 * unit) ->
  unit * length mesh + FlowBound.total FlowBound.multiplier cuts <= unit * FlowBound.buffer_length runs.
Proof. exact FlowBound.no_buffer_has_fewer. Qed.
Print Assumptions no_buffer_has_fewer.

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
Theorem wrong_images_refused : Rejects.image_refused 3 2 = true.
Proof. exact Rejects.wrong_images_refused. Qed.
Print Assumptions wrong_images_refused.
Theorem careless_images_refused :
  forallb (fun '(k, a) => Split.compares (k, a) &&
      negb (Symmetry.compare (Symmetry.turned k a) (split k a) (split k (k - a)) (Split.full k (k - a))
              (Rejects.with_answers (Rejects.turned_too_little k) (Split.full k a))))
    [(3, 2); (4, 3); (5, 3); (5, 4)] &&
  forallb (fun '(k, (i, j)) => OpenSplit.compares (k, (i, j)) &&
      negb (Symmetry.compare (Symmetry.mirrored k [k + 1; k]) (open_split k i j) (open_split k (k - j) (k - i)) (OpenSplit.full k (k - j) (k - i))
              (Rejects.with_answers (Rejects.reversed_too_short k) (OpenSplit.full k i j))))
    [(2, (1, 2)); (3, (2, 3)); (3, (1, 3)); (4, (3, 4))] = true.
Proof. exact Rejects.careless_images_refused. Qed.
Print Assumptions careless_images_refused.
