(** * What answers tell

    Each answer of the shipped headers tells how the numbers of strips and of isolated triangles change. ToldNumbers.v
    holds what they tell, in the order of the dump, for fans of up to five triangles and for flips. *)
Require Import Arith Bool List NArith ZArith.
Import ListNotations.
Require Import Statements Table.
Require ToldNumbers Tables_split Tables_collapse Tables_open_split Tables_open_collapse Tables_boundary_split Tables_boundary_collapse Tables_flip.

(** The changes when ports [s] and inner edges [c] become [s'] and [x]: in strips, which are triangles less solid edges
    ([Strips.v]), and in isolated triangles of the patch. *)
Definition changes (p : patch) (s c s' x : coloring) : Z * Z :=
  let strips d ports inner := (Z.of_nat (triangles d) - Z.of_nat (solids ports) - Z.of_nat (solids inner))%Z in
  (strips (after p) s' x - strips (before p) s c,
   Z.of_nat (isolated (after p) s' x) - Z.of_nat (isolated (before p) s c))%Z.

(** All colourings, in ascending order of their masks. *)
Fixpoint ascending (n : nat) : list coloring :=
  match n with 0 => [[]] | S m => flat_map (fun r => [false :: r; true :: r]) (ascending m) end.

(** The changes that the answers of a table make, in the order of the dump. The answer of a flip lists its inner edge,
    then the ports that it keeps. *)
Definition all_changes (flips : bool) (p : patch) (t : trie) : list (Z * Z) :=
  flat_map (fun c => flat_map (fun s =>
    match lookup t s c with
    | Some x => [if flips then changes p s c (tl x) (firstn 1 x) else changes p s c s x]
    | None => []
    end) (ascending (ports p))) (ascending (length (inner (before p)))).

(** A printed number is 256 (strips + 128) + isolated + 128. *)
Definition told (texts : list Number.uint) : list (Z * Z) :=
  map (fun n => (Z.of_N (n / 256) - 128, Z.of_N (n mod 256) - 128)%Z) (flat_map read texts).
Definition tells (flips : bool) (p : patch) (t : trie) (texts : list Number.uint) : Prop :=
  told texts = all_changes flips p t.

(** Equality, computed. *)
Fixpoint same (l m : list (Z * Z)) : bool :=
  match l, m with
  | [], [] => true
  | (a, b) :: l', (a', b') :: m' => (a =? a')%Z && (b =? b')%Z && same l' m'
  | _, _ => false
  end.
Lemma same_ok l : forall m, same l m = true -> l = m.
Proof.
  induction l as [|[a b] l IH]; intros [|[a' b'] m]; simpl; try discriminate; [reflexivity|].
  rewrite !andb_true_iff, !Z.eqb_eq. intros [[-> ->] S]. now rewrite (IH m S).
Qed.
Definition tellsb (flips : bool) (p : patch) (t : trie) (texts : list Number.uint) : bool :=
  same (told texts) (all_changes flips p t).
Lemma all_tell {A} (flips : bool) (p : A -> patch) (t : A -> trie) (texts : A -> list Number.uint) l :
  forallb (fun at_ => tellsb flips (p at_) (t at_) (texts at_)) l = true ->
  Forall (fun at_ => tells flips (p at_) (t at_) (texts at_)) l.
Proof.
  rewrite forallb_forall, Forall_forall. intros H at_ I. exact (same_ok _ _ (H at_ I)).
Qed.

Definition arcs : list (nat * nat) := flat_map (fun k => map (fun a => (k, a)) (seq 1 (k - 1))) (seq 3 3).
Definition gaps : list (nat * nat) := flat_map (fun k => map (fun i => (k, i)) (seq 0 (S k))) (seq 1 5).
Definition gap_pairs : list (nat * nat * nat) :=
  flat_map (fun '(k, i) => map (fun j => (k, i, j)) (seq (S i) (k - i))) gaps.
Definition of_two (f : nat -> nat -> patch) (at_ : nat * nat) : patch := f (fst at_) (snd at_).
Definition of_three (f : nat -> nat -> nat -> patch) (at_ : nat * nat * nat) : patch := f (fst (fst at_)) (snd (fst at_)) (snd at_).
Definition two {A} (f : list nat -> A) (at_ : nat * nat) : A := f [fst at_; snd at_].
Definition three {A} (f : list nat -> A) (at_ : nat * nat * nat) : A := f [fst (fst at_); snd (fst at_); snd at_].

Theorem answers_tell :
  Forall (fun at_ => tells false (of_two split at_) (two Tables_split.table at_) (two ToldNumbers.split at_)) arcs /\
  Forall (fun at_ => tells false (of_two collapse at_) (two Tables_collapse.table at_) (two ToldNumbers.collapse at_)) arcs /\
  Forall (fun at_ => tells false (of_three open_split at_) (three Tables_open_split.table at_) (three ToldNumbers.open_split at_)) gap_pairs /\
  Forall (fun at_ => tells false (of_three open_collapse at_) (three Tables_open_collapse.table at_) (three ToldNumbers.open_collapse at_)) gap_pairs /\
  Forall (fun at_ => tells false (of_two boundary_split at_) (two Tables_boundary_split.table at_) (two ToldNumbers.boundary_split at_)) gaps /\
  Forall (fun at_ => tells false (of_two boundary_collapse at_) (two Tables_boundary_collapse.table at_) (two ToldNumbers.boundary_collapse at_)) gaps /\
  tells true flip (Tables_flip.table []) (ToldNumbers.flip []).
Proof.
  repeat split; try apply all_tell; try apply same_ok; vm_cast_no_check (eq_refl true).
Qed.

(** They do tell something. *)
Theorem answers_counted : length (told (ToldNumbers.flip [])) = 25 /\ length (told (ToldNumbers.split [5; 2])) = 572.
Proof. split; vm_compute; reflexivity. Qed.
