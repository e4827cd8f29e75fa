(** * Tables as binary tries

    A table of answers, indexed by the colours of the ports and then of the inner edges before, dashed to the left and
    solid to the right. [Nothing] stands for a whole subtree without an answer. *)
Require Import Bool List NArith FMapPositive.
Import ListNotations.
Require Import Spec.

Inductive trie := Nothing | Answer (x : coloring) | Fork (dashed solid : trie).

Definition branch (b : bool) (t : trie) : trie :=
  match t with Fork d s => if b then s else d | _ => Nothing end.
Fixpoint find (t : trie) (c : coloring) : option coloring :=
  match c with
  | [] => match t with Answer x => Some x | _ => None end
  | b :: c' => find (branch b t) c'
  end.
Definition lookup (t : trie) : table := fun s c => find t (s ++ c).

Fixpoint silent (t : trie) : bool :=
  match t with Nothing => true | Answer _ => false | Fork d s => silent d && silent s end.

Lemma silent_find t : silent t = true -> forall c, find t c = None.
Proof.
  induction t as [|x|d IHd s IHs]; simpl; intros S c.
  - induction c as [|b c IH]; [reflexivity|exact IH].
  - discriminate.
  - apply andb_prop in S as [Sd Ss]. destruct c as [|[|] c]; simpl; auto.
Qed.

Lemma find_app t s c : find t (s ++ c) = find (fold_left (fun u b => branch b u) s t) c.
Proof. revert t. induction s as [|b s IH]; intros t; [reflexivity|apply IH]. Qed.

(** ** Masks

    Bit i of the mask is element i of the list. *)
Fixpoint coloring_of (m : nat) (x : N) : coloring :=
  match m with 0 => [] | S m' => N.odd x :: coloring_of m' (N.div2 x) end.

(** ** The form in which tables are printed

    Equal subtrees are printed once. Node 0 is [Nothing]; the list names nodes 1, 2, 3 ... in turn, each a leaf with the
    mask of its answer or a fork of two earlier nodes; the last one is the whole table. *)
Inductive node := Mask (x : N) | Node (dashed solid : N).
Definition named (nodes : PositiveMap.t trie) (n : N) : trie :=
  match n with
  | N0 => Nothing
  | Npos p => match PositiveMap.find p nodes with Some t => t | None => Nothing end
  end.
Fixpoint unfold_nodes (width : nat) (l : list node) (next : positive) (nodes : PositiveMap.t trie) (last : trie) : trie :=
  match l with
  | [] => last
  | n :: l' =>
      let t := match n with Mask x => Answer (coloring_of width x) | Node d s => Fork (named nodes d) (named nodes s) end in
      unfold_nodes width l' (Pos.succ next) (PositiveMap.add next t nodes) t
  end.
Definition table_of (width : nat) (l : list node) : trie := unfold_nodes width l 1 (PositiveMap.empty _) Nothing.
