(** * What the comparison of reported numbers must reject

    A bit of a reported number is changed, or nothing is reported; a configuration without an answer reports something. In
    two small positions and for flips this is done to every configuration and to each of sixteen bits; in every family, in
    a position with k = 7, to one answer, where the numbers of strips and of isolated triangles become wrong by one, and
    to one configuration without an answer. *)
Require Import Arith Bool List.
Import ListNotations.
Require Import Statements Table Checker Rejects Changes.
Require Tables_split Tables_collapse Tables_open_split Tables_open_collapse Tables_boundary_split Tables_boundary_collapse Tables_flip.
Require Changes_split Changes_collapse Changes_open_split Changes_open_collapse Changes_boundary_split Changes_boundary_collapse Changes_flip.

Definition width (p : patch) : nat := ports p + length (inner (before p)).
Definition damaged (bits : list nat) (u : trie) (c : coloring) : list trie :=
  match find u c with Some y => map (fun n => put u c (Some (flip_bit n y))) bits | None => [] end ++ silenced_or_invented 16 u c.
(** How many, and whether all of them are refused. *)
Definition refused_of (compares : trie -> bool) (bits : list nat) (u : trie) (l : list coloring) : nat * bool :=
  let wrong := flat_map (damaged bits u) l in (length wrong, forallb (fun w => negb (compares w)) wrong).
Definition refused_all (p : patch) (t u : trie) : nat * bool := refused_of (tellsb p t) (seq 0 16) u (all_colorings (width p)).
Definition refused_flips : nat * bool :=
  refused_of (tells_each true flip (Tables_flip.table [])) (seq 0 16) (Changes_flip.table []) (all_colorings (width flip)).

(** The answer in the middle of a table, and all solid, which is never valid. *)
Fixpoint told_under (t : trie) : list coloring :=
  match t with Nothing => [] | Answer _ => [[]] | Fork d s => map (cons false) (told_under d) ++ map (cons true) (told_under s) end.
Definition refused_two (p : patch) (t u : trie) : nat * bool :=
  let l := told_under u in refused_of (tellsb p t) [0; 8] u [nth (length l / 2) l []; repeat true (width p)].

Definition small : list (nat * bool) :=
  [refused_all (split 3 1) (Tables_split.table [3; 1]) (Changes_split.table [3; 1]);
   refused_all (open_collapse 2 0 1) (Tables_open_collapse.table [2; 0; 1]) (Changes_open_collapse.table [2; 0; 1]);
   refused_flips].
Definition large : list (nat * bool) :=
  [refused_two (split 7 3) (Tables_split.table [7; 3]) (Changes_split.table [7; 3]);
   refused_two (collapse 7 3) (Tables_collapse.table [7; 3]) (Changes_collapse.table [7; 3]);
   refused_two (open_split 7 2 5) (Tables_open_split.table [7; 2; 5]) (Changes_open_split.table [7; 2; 5]);
   refused_two (open_collapse 7 2 5) (Tables_open_collapse.table [7; 2; 5]) (Changes_open_collapse.table [7; 2; 5]);
   refused_two (boundary_split 7 3) (Tables_boundary_split.table [7; 3]) (Changes_boundary_split.table [7; 3]);
   refused_two (boundary_collapse 7 3) (Tables_boundary_collapse.table [7; 3]) (Changes_boundary_collapse.table [7; 3])].

Theorem wrong_told_refused : small = [(788, true); (848, true); (439, true)] /\ large = repeat (5, true) 6.
Proof. split; vm_compute; reflexivity. Qed.
