(** * What the checker must reject

    That it accepts nothing wrong is proved; here it is seen. Every answer of the tables of k = 3 and of k = 4, a = 2
    is taken out, or has one of its bits flipped, and every configuration without an answer is given one: each of the
    tables that arise is refused. So is each reduced table with one bit of a row flipped. *)
Require Import Arith Bool List.
Import ListNotations.
Require Import Spec Table Checker Rows.
Require Split Flip.

Fixpoint put (t : trie) (c : coloring) (answer : option coloring) : trie :=
  match c with
  | [] => match answer with Some x => Answer x | None => Nothing end
  | b :: r => if b then Fork (branch false t) (put (branch true t) r answer)
              else Fork (put (branch false t) r answer) (branch true t)
  end.
Fixpoint flip_bit (n : nat) (x : coloring) : coloring :=
  match x, n with [], _ => [] | b :: r, 0 => negb b :: r | b :: r, S m => b :: flip_bit m r end.

(** Tables that differ from [t] in the answer to [c]; [width] is the number of inner edges after. *)
Definition flipped (width : nat) (t : trie) (c : coloring) : list trie :=
  match find t c with Some x => map (fun n => put t c (Some (flip_bit n x))) (seq 0 width) | None => [] end.
Definition silenced_or_invented (width : nat) (t : trie) (c : coloring) : list trie :=
  match find t c with
  | Some _ => [put t c None]
  | None => [put t c (Some (repeat false width)); put t c (Some (repeat true width))]
  end.

Definition wrong_tables (k a : nat) : list trie :=
  flat_map (fun c => flipped (k + 3) (Split.full k a) c ++ silenced_or_invented (k + 3) (Split.full k a) c)
    (Flip.all_colorings (2 * k)).
Definition refused (k a : nat) : bool :=
  forallb (fun t => negb (check (split k a) 1 0 (fun _ _ _ => true) t)) (wrong_tables k a).

Theorem wrong_tables_refused : length (wrong_tables 3 1) = 348 /\ refused 3 1 && refused 4 2 = true.
Proof. split; vm_compute; reflexivity. Qed.

(** Keys that no configuration has carry no row, so every row matters. *)
Definition wrong_rows (k a : nat) : list trie :=
  flat_map (flipped (k + 3) (Split.by_key k a)) (Flip.all_colorings (2 * k)).
Definition rows_refused (k a : nat) : bool :=
  forallb (fun r => negb (check (split k a) 1 0 (agrees true r) (Split.full k a))) (wrong_rows k a).

Theorem wrong_rows_refused : rows_refused 3 1 && rows_refused 4 2 = true.
Proof. vm_compute. reflexivity. Qed.
