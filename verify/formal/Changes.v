(** * The stated changes of answers

    Each answer of the shipped headers reports how the numbers of strips and of isolated triangles change. Changes_FAMILY.v holds
    these reports: for each position a trie over the same colourings as the table of answers. *)
Require Import List.
Import ListNotations.
Require Import Statements Table Positions.
Require Export Telling.
Require Tables_split Tables_collapse Tables_open_split Tables_open_collapse Tables_boundary_split Tables_boundary_collapse Tables_flip.
Require Changes_split Changes_collapse Changes_open_split Changes_open_collapse Changes_boundary_split Changes_boundary_collapse Changes_flip.

Lemma all_tell {A} (p : A -> patch) (t u : A -> trie) l :
  forallb (fun at_ => tellsb (p at_) (t at_) (u at_)) l = true -> Forall (fun at_ => tells false (p at_) (t at_) (u at_)) l.
Proof. rewrite forallb_forall, Forall_forall. intros H at_ I. exact (tellsb_ok _ _ _ (H at_ I)). Qed.

Definition of_two (f : nat -> nat -> patch) (at_ : nat * nat) : patch := f (fst at_) (snd at_).
Definition of_three (f : nat -> nat -> nat -> patch) (at_ : nat * nat * nat) : patch := f (fst (fst at_)) (snd (fst at_)) (snd at_).
Definition two {A} (f : list nat -> A) (at_ : nat * nat) : A := f [fst at_; snd at_].
Definition three {A} (f : list nat -> A) (at_ : nat * nat * nat) : A := f [fst (fst at_); snd (fst at_); snd at_].

Theorem answers_tell :
  Forall (fun at_ => tells false (of_two split at_) (two Tables_split.table at_) (two Changes_split.table at_)) arcs /\
  Forall (fun at_ => tells false (of_two collapse at_) (two Tables_collapse.table at_) (two Changes_collapse.table at_)) arcs /\
  Forall (fun at_ => tells false (of_three open_split at_) (three Tables_open_split.table at_) (three Changes_open_split.table at_)) gap_pairs /\
  Forall (fun at_ => tells false (of_three open_collapse at_) (three Tables_open_collapse.table at_) (three Changes_open_collapse.table at_)) gap_pairs /\
  Forall (fun at_ => tells false (of_two boundary_split at_) (two Tables_boundary_split.table at_) (two Changes_boundary_split.table at_)) gaps /\
  Forall (fun at_ => tells false (of_two boundary_collapse at_) (two Tables_boundary_collapse.table at_) (two Changes_boundary_collapse.table at_)) gaps /\
  tells true flip (Tables_flip.table []) (Changes_flip.table []).
Proof.
  repeat split; try apply all_tell; try apply tells_each_ok; vm_cast_no_check (eq_refl true).
Qed.
