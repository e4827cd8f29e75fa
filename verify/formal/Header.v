(** * The automaton of the header, and the look-up in it

    [Lookup] of [Statements.v] says in Coq what the header's look-up does. Here are digests of what it answers. *)
Require Import Arith Bool List NArith FMapPositive.
Import ListNotations.
Require Import Statements Arcs.
Export Lookup.
Local Open Scope N_scope.

(** What a look-up answers to all keys of a position, in one number. Header and [dump_automaton.cpp] compute the same; ports that
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
