(** * What the checker must reject

    That it accepts nothing wrong is proved; here it is seen. Every answer of the tables of k = 3 and of k = 4, a = 2
    is taken out, or has one of its bits flipped, and every configuration without an answer is given one: each of the
    tables that arise is refused. So is each reduced table with one bit of a row flipped.

    The positions that are compared with the image of others get the same treatment, and two faults that code for them
    could easily have: a ring turned by one place too few, a path reversed as if it had an edge less. *)
Require Import Arith Bool List.
Import ListNotations.
Require Import Statements Table Checker Rows Symmetry.
Require Split OpenSplit.

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

(** [width]: the colours of an answer; [places]: the colours of a configuration. *)
Definition wrong_tables_of (width places : nat) (t : trie) : list trie :=
  flat_map (fun c => flipped width t c ++ silenced_or_invented width t c) (all_colorings places).
Definition wrong_tables (k a : nat) : list trie := wrong_tables_of (k + 3) (2 * k) (Split.full k a).
Definition refused (k a : nat) : bool :=
  forallb (fun t => negb (check (split k a) 1 0 (fun _ _ _ => true) t)) (wrong_tables k a).

Theorem wrong_tables_refused : length (wrong_tables 3 1) = 348 /\ refused 3 1 && refused 4 2 = true.
Proof. split; vm_compute; reflexivity. Qed.

Definition open_refused (k i j : nat) : bool :=
  forallb (fun t => negb (check (open_split k i j) 1 0 (fun _ _ _ => true) t)) (wrong_tables_of (k + 2) (2 * k - 1) (OpenSplit.full k i j)).
Theorem wrong_open_tables_refused : open_refused 2 0 1 && open_refused 3 0 2 && open_refused 3 1 2 = true.
Proof. vm_compute. reflexivity. Qed.

(** Keys that no configuration has carry no row, so every row matters. *)
Definition wrong_rows (k a : nat) : list trie :=
  flat_map (flipped (k + 3) (Split.by_key k a)) (all_colorings (2 * k)).
Definition rows_refused (k a : nat) : bool :=
  forallb (fun r => negb (check (split k a) 1 0 (agrees true r) (Split.full k a))) (wrong_rows k a).

Theorem wrong_rows_refused : rows_refused 3 1 && rows_refused 4 2 = true.
Proof. vm_compute. reflexivity. Qed.

Definition image_refused (k a : nat) : bool :=
  forallb (fun t => negb (compare (turned k a) (split k a) (split k (k - a)) (Split.full k (k - a)) t)) (wrong_tables k a).
Theorem wrong_images_refused : image_refused 3 2 = true.
Proof. vm_compute. reflexivity. Qed.

Fixpoint with_answers (f : coloring -> coloring) (t : trie) : trie :=
  match t with Nothing => Nothing | Answer x => Answer (f x) | Fork d s => Fork (with_answers f d) (with_answers f s) end.
(** The last edge of the list is the chord. *)
Definition turned_too_little (k : nat) (x : coloring) : coloring := skipn (k + 1) (firstn (k + 2) x) ++ firstn (k + 1) x ++ skipn (k + 2) x.
Theorem careless_images_refused :
  forallb (fun '(k, a) => Split.compares (k, a) &&
      negb (compare (turned k a) (split k a) (split k (k - a)) (Split.full k (k - a))
              (with_answers (turned_too_little k) (Split.full k a))))
    [(3, 2); (4, 3); (5, 3); (5, 4)] = true.
Proof. vm_compute. reflexivity. Qed.
