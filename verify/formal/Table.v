(** * Tables as binary tries

    A table of answers, indexed by the colours of the ports and then of the inner edges before, dashed to the left and
    solid to the right. [Nothing] stands for a whole subtree without an answer. *)
Require Import Bool List NArith FMapPositive Number Hexadecimal.
Import ListNotations.
Require Import Statements.

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
    mask of its answer or a fork of two earlier nodes; the last one is the whole table. A node is eight hexadecimal
    digits, four for each branch of a fork; ffff and the mask for a leaf. *)
Fixpoint numbers (digits : Hexadecimal.uint) (more : nat) (n : N) : list N :=
  let next rest digit :=
    let n' := (16 * n + digit)%N in match more with 0 => n' :: numbers rest 3 0%N | S m => numbers rest m n' end in
  match digits with
  | Nil => []
  | D0 r => next r 0%N | D1 r => next r 1%N | D2 r => next r 2%N | D3 r => next r 3%N
  | D4 r => next r 4%N | D5 r => next r 5%N | D6 r => next r 6%N | D7 r => next r 7%N
  | D8 r => next r 8%N | D9 r => next r 9%N | Da r => next r 10%N | Db r => next r 11%N
  | Dc r => next r 12%N | Dd r => next r 13%N | De r => next r 14%N | Df r => next r 15%N
  end.
(** A text begins with a 1, so that no zero is lost, and has a few hundred nodes. *)
Definition read (text : Number.uint) : list N :=
  match text with Number.UIntHexadecimal (D1 digits) => numbers digits 3 0%N | _ => [] end.

Definition named (nodes : PositiveMap.t trie) (n : N) : trie :=
  match n with
  | N0 => Nothing
  | Npos p => match PositiveMap.find p nodes with Some t => t | None => Nothing end
  end.
Fixpoint unfold_nodes (width : nat) (l : list N) (next : positive) (nodes : PositiveMap.t trie) (last : trie) : trie :=
  match l with
  | d :: s :: l' =>
      let t := if N.eqb d 65535 then Answer (coloring_of width s) else Fork (named nodes d) (named nodes s) in
      unfold_nodes width l' (Pos.succ next) (PositiveMap.add next t nodes) t
  | _ => last
  end.
Definition table_of (width : nat) (texts : list Number.uint) : trie :=
  unfold_nodes width (flat_map read texts) 1 (PositiveMap.empty _) Nothing.
