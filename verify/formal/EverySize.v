(** * Sequences of operations on fans of any size

    Whatever table answers, as long as it is correct in the sense of [Spec.v]: its answers cost what those of [EveryFan.v]
    cost. *)
Require Import Arith Bool List ZArith Lia.
Import ListNotations.
Require Import Spec Checker Rows Symmetry Sequences EveryFan.
Require Linked EverySplit EveryCollapse EveryOpen.

(** Two correct tables agree about everything but which of the best recolourings they give. *)
Theorem correct_agree p T U s c x : correct p T -> correct p U -> length s = ports p -> length c = length (inner (before p)) ->
  T s c = Some x -> exists y, U s c = Some y /\ solids x = solids y /\ isolated (after p) s x = isolated (after p) s y.
Proof.
  intros CT CU Ls Lc E. destruct (CT s c Ls Lc) as [Tv Tn], (CU s c Ls Lc) as [Uv _].
  assert (V : valid (drawing (before p) s c)).
  { pose proof (Linked.valid_decided (drawing (before p) s c)) as [V|V]; [exact V|]. rewrite (Tn V) in E. discriminate. }
  destruct (Tv V) as (x' & E' & Lx & Bx). rewrite E in E'. injection E' as <-. destruct (Uv V) as (y & Ey & Ly & By).
  exists y. split; [exact Ey|]. pose proof (Bx y Ly). pose proof (By x Lx). unfold as_good in *. lia.
Qed.
Theorem correct_within p T U strips alone : correct p T -> correct p U -> within p T strips alone -> within p U strips alone.
Proof.
  intros CT CU W s c x Ls Lc E. destruct (correct_agree p U T s c x CU CT Ls Lc E) as (y & Ey & S & I).
  destruct (W s c y Ls Lc Ey) as [W1 W2]. rewrite S, I. now split.
Qed.

(** A correct table for a fan of any size, in any position. *)
Inductive of_any_size : patch -> table -> Prop :=
| any_split k a T : 3 <= k -> 1 <= a < k -> correct (split k a) T -> of_any_size (split k a) T
| any_collapse k a T : 3 <= k -> 1 <= a < k -> correct (collapse k a) T -> of_any_size (collapse k a) T
| any_open_split k i j T : 1 <= k -> i < j <= k -> correct (open_split k i j) T -> of_any_size (open_split k i j) T
| any_open_collapse k i j T : 1 <= k -> i < j <= k -> correct (open_collapse k i j) T -> of_any_size (open_collapse k i j) T
| any_boundary_split k i T : 1 <= k -> i <= k -> correct (boundary_split k i) T -> of_any_size (boundary_split k i) T
| any_boundary_collapse k i T : 1 <= k -> i <= k -> correct (boundary_collapse k i) T -> of_any_size (boundary_collapse k i) T.
(** Around a vertex inside the mesh, or a split of a boundary vertex whose new edge lies inside. *)
Inductive inside_of_any_size : patch -> table -> Prop :=
| inside_any_split k a T : 3 <= k -> 1 <= a < k -> correct (split k a) T -> inside_of_any_size (split k a) T
| inside_any_collapse k a T : 3 <= k -> 1 <= a < k -> correct (collapse k a) T -> inside_of_any_size (collapse k a) T
| inside_any_open_split k i j T : 1 <= k -> i < j <= k -> correct (open_split k i j) T -> inside_of_any_size (open_split k i j) T.

Lemma along_sensible p d sh m r q : drawn_along d (ports p) sh m r q -> sensible p d.
Proof. intros A. eapply well_formed_sensible, along_well_formed, A. Qed.
Lemma any_sensible p T : of_any_size p T -> sensible p (before p) /\ sensible p (after p).
Proof.
  assert (W : forall p k sh0 m0 r0 q0 sh m r q, ports p = k -> drawn_along (before p) k sh0 m0 r0 q0 -> drawn_along (after p) k sh m r q ->
    sensible p (before p) /\ sensible p (after p)).
  { intros p' k sh0 m0 r0 q0 sh m r q <- A B. split; eapply along_sensible; eassumption. }
  intros [k a U Hk Ha _|k a U Hk Ha _|k i j U Hk Hj _|k i j U Hk Hj _|k i U Hk Hi _|k i U Hk Hi _]; eapply (W _ k); try apply seq_length.
  - apply closed_along; lia. - apply ring_along; lia. - apply ring_along; lia. - apply closed_along; lia.
  - apply open_along; lia. - apply chord_along; lia. - apply chord_along; lia. - apply open_along; lia.
  - apply open_along; lia. - apply one_along; lia. - apply one_along; lia. - apply open_along; lia.
Qed.
Lemma any_correct p T : of_any_size p T -> correct p T.
Proof. now intros []. Qed.
Lemma any_fine p T : of_any_size p T -> sensible p (before p) /\ sensible p (after p) /\ safe p T.
Proof.
  intros A. destruct (any_sensible p T A) as [S0 S1]. split; [exact S0|]. split; [exact S1|].
  now apply correct_safe, any_correct.
Qed.
Lemma inside_any p T : inside_of_any_size p T -> of_any_size p T.
Proof. intros [k a U Hk Ha C|k a U Hk Ha C|k i j U Hk Hj C]; now constructor. Qed.
Lemma inside_any_fine p T : inside_of_any_size p T -> sensible p (before p) /\ sensible p (after p) /\ safe p T.
Proof. intros I. now apply any_fine, inside_any. Qed.
Lemma inside_any_never_isolates p T : inside_of_any_size p T -> exists strips, within p T strips 0.
Proof.
  intros [k a U Hk Ha C|k a U Hk Ha C|k i j U Hk Hj C]; eexists.
  - eapply correct_within; [apply (split_right k a Hk Ha)|exact C|exact (EverySplit.split_within k a Hk Ha)].
  - eapply correct_within; [apply (collapse_right k a Hk Ha)|exact C|exact (EveryCollapse.collapse_within k a Hk Ha)].
  - eapply correct_within; [apply (open_split_right k i j Hk Hj)|exact C|exact (EveryOpen.open_split_within k i j Hk Hj)].
Qed.

Theorem stays_valid M told M' : sequence of_any_size M told M' -> valid (edges M) -> valid (edges M').
Proof. exact (sequence_valid of_any_size any_fine M told M'). Qed.
Theorem strips_told M told M' : sequence of_any_size M told M' -> (strips_of M' = strips_of M + told)%Z.
Proof. exact (sequence_told of_any_size any_fine M told M'). Qed.
Theorem never_isolated M told M' : sequence inside_of_any_size M told M' -> none_isolated M -> none_isolated M'.
Proof. exact (sequence_none_isolated inside_of_any_size inside_any_fine M told M' inside_any_never_isolates). Qed.
Theorem half_as_many_strips M told M' : sequence inside_of_any_size M told M' -> sane M -> none_isolated M ->
  (2 * strips_of M' <= Z.of_nat (length (nodes M')))%Z.
Proof.
  intros Q S N. apply half_as_many; [exact (sequence_sane inside_of_any_size inside_any_fine M told M' Q S)|].
  exact (never_isolated M told M' Q N).
Qed.
