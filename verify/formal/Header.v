(** * The automaton of the header, and the look-up in it

    This file says in Coq what runtime/include/restrip/rules/impl/arc_walk.hpp does with the numbers of automaton.hpp; it is all
    of that code that the theorems know. docs/automaton.md explains letters, classes and cases. *)
Require Import Arith Bool List NArith FMapPositive.
Import ListNotations.
Require Import Spec Arcs.
Local Open Scope N_scope.

(** The arrays of automaton.hpp, found by index. *)
Definition array := PositiveMap.t N.
Definition array_of (l : list N) : array :=
  fst (fold_left (fun '(t, p) n => (PositiveMap.add p n t, Pos.succ p)) l (PositiveMap.empty N, 1%positive)).
Definition read (t : array) (n : N) : N := match PositiveMap.find (N.succ_pos n) t with Some x => x | None => 0 end.
(** Beyond its end an array of C++ has no value, and here 0. [Bounds.v] proves that the look-up does not go there: it answers
    alike whatever lies behind the arrays. *)
Definition inside_array (t : array) (n : N) : bool := match PositiveMap.find (N.succ_pos n) t with Some _ => true | None => false end.
Record header := Header { next_class : array; before_case : array; closed_case : array; first_row : array; second_column : array;
  meet_index : array; meetings : array; seconds : N }.

Definition longer (t t' : array) : Prop := forall n x, PositiveMap.find n t = Some x -> PositiveMap.find n t' = Some x.
Definition same_inside (H H' : header) : Prop :=
  longer (next_class H) (next_class H') /\ longer (before_case H) (before_case H') /\ longer (closed_case H) (closed_case H') /\
  longer (first_row H) (first_row H') /\ longer (second_column H) (second_column H') /\ longer (meet_index H) (meet_index H') /\
  longer (meetings H) (meetings H') /\ seconds H' = seconds H.

Definition number (l : letter) : N := match l with Plain => 0 | Alone => 1 | Joined => 2 | Edge => 3 end.
Definition solid_link (e : N) : bool := negb (N.land e 3 =? 0).

Section Walk.
  Variable H : header.

  (** An arc is a list with its last letter first, as in [Arcs.v]. [trace w e]: the colours of the links to the left of its
      letters, the last first, when [e] is the case of the whole arc. *)
  Definition go (x : N) (l : letter) : N := read (next_class H) (4 * x + number l).
  Definition came (x : N) (l : letter) (e : N) : N := N.land (N.shiftr (read (before_case H) (4 * x + number l)) (4 * e)) 15.
  Fixpoint arc_class (w : list letter) : N := match w with [] => 0 | l :: u => go (arc_class u) l end.
  Fixpoint trace (w : list letter) (e : N) : coloring :=
    match w with
    | [] => []
    | l :: u => let e' := came (arc_class u) l e in solid_link e' :: trace u e'
    end.

  (** The cases of two arcs that meet, and the chord. *)
  Definition meeting (x y : N) : N * N * bool :=
    let m := read (meetings H) (read (meet_index H) (seconds H * read (first_row H) x + read (second_column H) y)) in
    (N.land m 15, N.land (N.shiftr m 4) 15, negb (N.land (N.shiftr m 8) 1 =? 0)).

  (** The links of an arc, from left to right. *)
  Definition links (w : list letter) (e : N) : coloring := rev (solid_link e :: trace w e).
  Definition inside (l : coloring) : coloring := tl (removelast l).

  (** The letter of a triangle. *)
  Definition letter_at (s J : coloring) (i : nat) : letter :=
    if nth i s false then if nth i J false then Joined else Alone else Plain.
  (** Letters [i], ..., [i + n - 1], the last first. *)
  Definition letters (s J : coloring) (i n : nat) : list letter := rev (map (letter_at s J) (seq i n)).

  (** The answers, in the order of edges of [Spec.v]. *)
  Definition meet_arcs (w1 w2 : list letter) : coloring * coloring * bool :=
    let '(e1, e2, ch) := meeting (arc_class w1) (arc_class w2) in (links w1 e1, links w2 e2, ch).
  Definition split_walk (k a : nat) (s J : coloring) : coloring :=
    let '(l1, l2, ch) := meet_arcs (letters s J 0 a) (letters s J a (k - a)) in
    l1 ++ l2 ++ [ch].
  Definition collapse_walk (k : nat) (s J : coloring) : coloring :=
    let w := letters s J 0 k in tl (links w (read (closed_case H) (arc_class w))).
  Definition open_split_walk (k i j : nat) (s J : coloring) : coloring :=
    let '(l1, l2, ch) := meet_arcs (letters s J i (j - i)) (letters s J 0 i ++ Edge :: letters s J j (k - j)) in
    skipn (k - j + 2) l2 ++ l1 ++ firstn (k - j) l2 ++ [ch].
  Definition boundary_split_walk (k i : nat) (s J : coloring) : coloring :=
    inside (links (letters s J i (k - i) ++ Plain :: letters s J 0 i) 0).
  Definition fan_collapse_walk (k : nat) (s J : coloring) : coloring :=
    inside (links (letters s J 0 k) 0).

  (** From keys: with exactly two solid ports in a closed fan either bit stands for the pair; in an open fan nothing lies before
      the first solid port. *)
  Definition of_closed (s J : coloring) : coloring :=
    let both := map (fun i => nth i s false && nth i J false)%bool (seq 0 (length s)) in
    if ((length (filter id s) =? 2)%nat && existsb id both)%bool then s else both.
  Definition of_open (s J : coloring) : coloring :=
    map (fun i => nth i s false && nth i J false && existsb (fun m => nth m s false) (seq 0 i))%bool (seq 0 (length s)).
  Definition split_answer (k a : nat) (s J : coloring) : coloring := split_walk k a s (of_closed s J).
  Definition collapse_answer (k : nat) (s J : coloring) : coloring := collapse_walk k s (of_closed s J).
  Definition open_split_answer (k i j : nat) (s J : coloring) : coloring := open_split_walk k i j s (of_open s J).
  Definition boundary_split_answer (k i : nat) (s J : coloring) : coloring := boundary_split_walk k i s (of_open s J).
  Definition fan_collapse_answer (k : nat) (s J : coloring) : coloring := fan_collapse_walk k s (of_open s J).
End Walk.

(** ** Digests

    What a look-up answers to all keys of a position, in one number. Header and [dump_automaton.cpp] compute the same; ports that
    are not solid are not joined. *)
Inductive walked_family := Splits | Collapses | OpenSplits | BoundarySplits | FanCollapses.
Definition answer_at (H : header) (f : walked_family) (position : list nat) : coloring -> coloring -> coloring :=
  match f, position with
  | Splits, [k; a] => split_answer H k a
  | Collapses, [k] => collapse_answer H k
  | OpenSplits, [k; i; j] => open_split_answer H k i j
  | BoundarySplits, [k; i] => boundary_split_answer H k i
  | FanCollapses, [k] => fan_collapse_answer H k
  | _, _ => fun _ _ => []
  end.
Fixpoint keys (k : nat) : list (coloring * coloring) :=
  match k with
  | O => [([], [])]
  | S k' =>
      let r := keys k' in
      map (fun key => (false :: fst key, false :: snd key)) r ++ map (fun key => (true :: fst key, false :: snd key)) r ++
      map (fun key => (true :: fst key, true :: snd key)) r
  end.
Fixpoint mask (c : coloring) : N := match c with [] => 0 | b :: r => (if b then 1 else 0) + 2 * mask r end.
Definition digest (answer : coloring -> coloring -> coloring) (k : nat) : N :=
  fold_left (fun h key => N.land (h * 1000003 + mask (answer (fst key) (snd key))) 0xffffffffffffffff) (keys k) 0.
Definition digest_at (H : header) (f : walked_family) (position : list nat) : N := digest (answer_at H f position) (hd O position).

(** Every position with at most [n] triangles, in the order of the dump. *)
Definition positions (n : nat) : list (walked_family * list nat) :=
  let sizes := seq 1 n in let closed_sizes := seq 3 (n - 2) in
  flat_map (fun k => map (fun a => (Splits, [k; a])) (seq 1 (k - 1))) closed_sizes ++ map (fun k => (Collapses, [k])) closed_sizes ++
  flat_map (fun k => flat_map (fun i => map (fun j => (OpenSplits, [k; i; j])) (seq (S i) (k - i))) (seq 0 k)) sizes ++
  flat_map (fun k => map (fun i => (BoundarySplits, [k; i])) (seq 0 (S k))) sizes ++ map (fun k => (FanCollapses, [k])) sizes.
