(** * How many answers the theorems speak of

    A configuration is a colouring of the ports and of the inner edges before. The shipped headers answer every one of
    them, valid or not, in every position; [restrip-dump-tables] prints the answers. Here their positions are listed and
    their configurations counted; scripts/prove.sh wants to see the same numbers from the printer of the tables. *)
Require Import Arith Bool List NArith Lia.
Import ListNotations.
Require Import Spec Table Symmetry.
Require Split Collapse OpenSplit OpenCollapse BoundarySplit BoundaryCollapse LinkedTables.

Definition arcs : list (nat * nat) := flat_map (fun k => map (fun a => (k, a)) (seq 1 (k - 1))) (seq 3 6).
Definition gaps : list (nat * nat) := flat_map (fun k => map (fun i => (k, i)) (seq 0 (S k))) (seq 1 8).
Definition gap_pairs : list (nat * nat * nat) :=
  flat_map (fun '(k, i) => map (fun j => (k, i, j)) (seq (S i) (k - i))) gaps.

Lemma arcs_ok k a : In (k, a) arcs -> 3 <= k <= 8 /\ 1 <= a < k.
Proof.
  intros I. apply in_flat_map in I as (k' & K & I). apply in_map_iff in I as (a' & E & I). injection E as -> ->.
  apply in_seq in K, I. lia.
Qed.
Lemma gaps_ok k i : In (k, i) gaps -> 1 <= k <= 8 /\ i <= k.
Proof.
  intros I. apply in_flat_map in I as (k' & K & I). apply in_map_iff in I as (i' & E & I). injection E as -> ->.
  apply in_seq in K, I. lia.
Qed.
Lemma gap_pairs_ok k i j : In (k, i, j) gap_pairs -> 1 <= k <= 8 /\ i < j <= k.
Proof.
  intros I. apply in_flat_map in I as ([k' i'] & K & I). apply in_map_iff in I as (j' & E & I). injection E as -> -> ->.
  apply gaps_ok in K. apply in_seq in I. lia.
Qed.

Theorem all_correct :
  Forall (fun '(k, a) => correct (split k a) (lookup (Split.full k a))) arcs /\
  Forall (fun '(k, a) => correct (collapse k a) (lookup (Collapse.full k a))) arcs /\
  Forall (fun '(k, i, j) => correct (open_split k i j) (lookup (OpenSplit.full k i j))) gap_pairs /\
  Forall (fun '(k, i, j) => correct (open_collapse k i j) (lookup (OpenCollapse.full k i j))) gap_pairs /\
  Forall (fun '(k, i) => correct (boundary_split k i) (lookup (BoundarySplit.full k i))) gaps /\
  Forall (fun '(k, i) => correct (boundary_collapse k i) (lookup (BoundaryCollapse.full k i))) gaps.
Proof.
  repeat split; apply Forall_forall.
  - intros [k a] I. apply arcs_ok in I as [K A]. apply (Split.every_position k a K A).
  - intros [k a] I. apply arcs_ok in I as [K A]. apply (Collapse.every_position k a K A).
  - intros [[k i] j] I. apply gap_pairs_ok in I as [K J]. apply (OpenSplit.every_position k i j K J).
  - intros [[k i] j] I. apply gap_pairs_ok in I as [K J]. apply (OpenCollapse.every_position k i j K J).
  - intros [k i] I. apply gaps_ok in I as [K J]. apply (BoundarySplit.every_position k i K J).
  - intros [k i] I. apply gaps_ok in I as [K J]. apply (BoundaryCollapse.every_position k i K J).
Qed.

(** Positions and answers of split, collapse, open-split, open-collapse, boundary-split, boundary-collapse; of linked
    splits and collapses positions and lists; and the flip, in the order of the dump. *)
Definition count {A} (patch_of : A -> patch) (positions : list A) : N * N :=
  (N.of_nat (length positions),
   fold_right N.add 0%N (map (fun at_ => let p := patch_of at_ in 2 ^ N.of_nat (ports p + length (inner (before p))))%N positions)).
(** One list for each colouring of the ports. *)
Definition lists (valences : list nat) : N * N :=
  (N.of_nat (length valences), fold_right N.add 0%N (map (fun k => 2 ^ N.of_nat k)%N valences)).
Definition counts : list (N * N) :=
  [count (fun '(k, a) => split k a) arcs; count (fun '(k, a) => collapse k a) arcs;
   count (fun '(k, i, j) => open_split k i j) gap_pairs; count (fun '(k, i, j) => open_collapse k i j) gap_pairs;
   count (fun '(k, i) => boundary_split k i) gaps; count (fun '(k, i) => boundary_collapse k i) gaps;
   lists (map fst LinkedTables.split_positions); lists (seq 3 6);
   count (fun _ => flip) [tt]].
