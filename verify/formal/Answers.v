(** * How many answers the theorems speak of

    A configuration is a colouring of the ports and of the inner edges before. The shipped headers answer every one of
    them, valid or not, in every position; [restrip-dump-tables] prints the answers. Here their positions are listed and
    their configurations counted; scripts/prove.sh wants to see the same numbers from the printer of the tables. *)
Require Import Arith Bool List NArith Lia.
Import ListNotations.
Require Import Statements Positions.
Require Shipped.

Definition all_positions : list position :=
  map (fun '(k, a) => split_at k a) arcs ++ map (fun '(k, a) => collapse_at k a) arcs ++
  map (fun '(k, i, j) => open_split_at k i j) gap_pairs ++ map (fun '(k, i, j) => open_collapse_at k i j) gap_pairs ++
  map (fun '(k, i) => boundary_split_at k i) gaps ++ map (fun '(k, i) => boundary_collapse_at k i) gaps.
Lemma all_possible : forallb (fun o => possible o && (valence_at o <=? 8)) all_positions = true.
Proof. vm_compute. reflexivity. Qed.

Theorem all_right : Forall (fun o => right_at o (Shipped.shipped o)) all_positions.
Proof.
  pose proof all_possible as A. rewrite forallb_forall in A. apply Forall_forall. intros o I. apply A in I.
  apply andb_prop in I as [Po K]. apply Nat.leb_le in K. exact (Shipped.rules_right o Po K).
Qed.

(** Positions and answers of split, collapse, open-split, open-collapse, boundary-split, boundary-collapse and
    the flip, in the order of the dump. *)
Definition count {A} (patch_of : A -> patch) (positions : list A) : N * N :=
  (N.of_nat (length positions),
   fold_right N.add 0%N (map (fun at_ => let p := patch_of at_ in 2 ^ N.of_nat (ports p + length (inner (before p))))%N positions)).
Definition counts : list (N * N) :=
  [count (fun '(k, a) => split k a) arcs; count (fun '(k, a) => collapse k a) arcs;
   count (fun '(k, i, j) => open_split k i j) gap_pairs; count (fun '(k, i, j) => open_collapse k i j) gap_pairs;
   count (fun '(k, i) => boundary_split k i) gaps; count (fun '(k, i) => boundary_collapse k i) gaps;
   count (fun _ => flip) [tt]].
