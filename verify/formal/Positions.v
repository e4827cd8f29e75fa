(** * The positions of the shipped tables *)
Require Import List.
Import ListNotations.

Definition arcs : list (nat * nat) := flat_map (fun k => map (fun a => (k, a)) (seq 1 (k - 1))) (seq 3 6).
Definition gaps : list (nat * nat) := flat_map (fun k => map (fun i => (k, i)) (seq 0 (S k))) (seq 1 8).
Definition gap_pairs : list (nat * nat * nat) :=
  flat_map (fun '(k, i) => map (fun j => (k, i, j)) (seq (S i) (k - i))) gaps.
