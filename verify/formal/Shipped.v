(** * Sequences of operations by the shipped local rules

    The rules of every fan of at most eight triangles, in every position; not those of longer fans, and not flips. *)
Require Import Arith Bool List ZArith Lia.
Import ListNotations.
Require Import Spec Table Checker Rows Symmetry Sequences Answers.
Require Split Collapse OpenSplit OpenCollapse BoundarySplit BoundaryCollapse.

Inductive local : patch -> table -> Prop :=
| by_split k a : In (k, a) arcs -> local (split k a) (lookup (Split.full k a))
| by_collapse k a : In (k, a) arcs -> local (collapse k a) (lookup (Collapse.full k a))
| by_open_split k i j : In (k, i, j) gap_pairs -> local (open_split k i j) (lookup (OpenSplit.full k i j))
| by_open_collapse k i j : In (k, i, j) gap_pairs -> local (open_collapse k i j) (lookup (OpenCollapse.full k i j))
| by_boundary_split k i : In (k, i) gaps -> local (boundary_split k i) (lookup (BoundarySplit.full k i))
| by_boundary_collapse k i : In (k, i) gaps -> local (boundary_collapse k i) (lookup (BoundaryCollapse.full k i)).

(** Those that never isolate a triangle: around vertices inside the mesh, and splits of a boundary vertex whose new edge lies
    inside. *)
Inductive local_inside : patch -> table -> Prop :=
| inside_split k a : In (k, a) arcs -> local_inside (split k a) (lookup (Split.full k a))
| inside_collapse k a : In (k, a) arcs -> local_inside (collapse k a) (lookup (Collapse.full k a))
| inside_open_split k i j : In (k, i, j) gap_pairs -> local_inside (open_split k i j) (lookup (OpenSplit.full k i j)).

Definition well_formed (p : patch) : bool := well_formed_side p (before p) && well_formed_side p (after p).
Lemma all_well_formed :
  forallb (fun '(k, a) => well_formed (split k a) && well_formed (collapse k a)) arcs &&
  forallb (fun '(k, i, j) => well_formed (open_split k i j) && well_formed (open_collapse k i j)) gap_pairs &&
  forallb (fun '(k, i) => well_formed (boundary_split k i) && well_formed (boundary_collapse k i)) gaps = true.
Proof. vm_compute. reflexivity. Qed.
Lemma sensible_sides p : well_formed p = true -> sensible p (before p) /\ sensible p (after p).
Proof. unfold well_formed. rewrite andb_true_iff. intros [W0 W1]. split; now apply well_formed_sensible. Qed.

Lemma local_fine p T : local p T -> sensible p (before p) /\ sensible p (after p) /\ safe p T.
Proof.
  pose proof all_well_formed as W. rewrite !andb_true_iff, !forallb_forall in W. destruct W as [[Wa Wp] Wg].
  intros [k a I|k a I|k i j I|k i j I|k i I|k i I]; pose proof I as R.
  1, 2: apply Wa in I; apply arcs_ok in R as [K R].
  3, 4: apply Wp in I; apply gap_pairs_ok in R as [K R].
  5, 6: apply Wg in I; apply gaps_ok in R as [K R].
  all: apply andb_prop in I as [I0 I1].
  - apply sensible_sides in I0 as [S0 S1]. split; [exact S0|]. split; [exact S1|]. apply (Split.every_position k a K R).
  - apply sensible_sides in I1 as [S0 S1]. split; [exact S0|]. split; [exact S1|]. apply (Collapse.every_position k a K R).
  - apply sensible_sides in I0 as [S0 S1]. split; [exact S0|]. split; [exact S1|]. apply (OpenSplit.every_position k i j K R).
  - apply sensible_sides in I1 as [S0 S1]. split; [exact S0|]. split; [exact S1|]. apply (OpenCollapse.every_position k i j K R).
  - apply sensible_sides in I0 as [S0 S1]. split; [exact S0|]. split; [exact S1|]. apply (BoundarySplit.every_position k i K R).
  - apply sensible_sides in I1 as [S0 S1]. split; [exact S0|]. split; [exact S1|]. apply (BoundaryCollapse.every_position k i K R).
Qed.
Lemma inside_local p T : local_inside p T -> local p T.
Proof. intros [k a I|k a I|k i j I]; now constructor. Qed.
Lemma inside_fine p T : local_inside p T -> sensible p (before p) /\ sensible p (after p) /\ safe p T.
Proof. intros I. now apply local_fine, inside_local. Qed.
Lemma inside_never_isolates p T : local_inside p T -> exists strips, within p T strips 0.
Proof.
  intros [k a I|k a I|k i j I].
  - apply arcs_ok in I as [K R]. eexists. apply (Split.every_position k a K R).
  - apply arcs_ok in I as [K R]. eexists. apply (Collapse.every_position k a K R).
  - apply gap_pairs_ok in I as [K R]. eexists. apply (OpenSplit.every_position k i j K R).
Qed.

Theorem stays_valid M told M' : sequence local M told M' -> valid (edges M) -> valid (edges M').
Proof. exact (sequence_valid local local_fine M told M'). Qed.
Theorem strips_told M told M' : sequence local M told M' -> (strips_of M' = strips_of M + told)%Z.
Proof. exact (sequence_told local local_fine M told M'). Qed.
Theorem never_isolated M told M' : sequence local_inside M told M' -> none_isolated M -> none_isolated M'.
Proof. exact (sequence_none_isolated local_inside inside_fine M told M' inside_never_isolates). Qed.
Theorem half_as_many_strips M told M' : sequence local_inside M told M' -> sane M -> none_isolated M ->
  (2 * strips_of M' <= Z.of_nat (length (nodes M')))%Z.
Proof.
  intros Q S N. apply half_as_many; [exact (sequence_sane local_inside inside_fine M told M' Q S)|].
  exact (never_isolated M told M' Q N).
Qed.
