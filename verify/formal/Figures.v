(** * The reference figures

    Counts that anybody can make by brute force without reading a definition of ours: how many configurations are
    valid, and how many of them cost a strip. That the proved tables give the known numbers is evidence that [Statements.v]
    says what it means to say. *)
Require Import Arith Bool List NArith.
Import ListNotations.
Require Import Statements Table.
Require Split Collapse.

(** How many answers of a trie satisfy [costs], a test of the solid edges before and after. The first [skip] levels are
    ports and do not count. *)
Fixpoint count (costs : nat -> nat -> bool) (skip solid_before : nat) (t : trie) : N :=
  match t with
  | Nothing => 0%N
  | Answer x => if costs solid_before (solids x) then 1%N else 0%N
  | Fork d s =>
      (count costs (pred skip) solid_before d +
       count costs (pred skip) (match skip with O => S solid_before | _ => solid_before end) s)%N
  end.

Definition valid_configurations (k : nat) (t : trie) : N := count (fun _ _ => true) k 0 t.
(** A split adds two triangles, a collapse removes two; more triangles than edges gained is a strip more. *)
Definition costing_split (k : nat) (t : trie) : N := count (fun b a => a <? b + 2) k 0 t.
Definition costing_collapse (k : nat) (t : trie) : N := count (fun b a => a + 2 <? b) k 0 t.

Definition arcs (k : nat) : list nat := seq 1 (k / 2).

Theorem valid_splits : map (fun k => map (fun a => valid_configurations k (Split.full k a)) (arcs k)) (seq 3 6) =
  [[44]; [160; 160]; [572; 572]; [2040; 2040; 2040]; [7268; 7268; 7268]; [25888; 25888; 25888; 25888]]%N.
Proof. vm_compute. reflexivity. Qed.

Theorem costing_splits : map (fun k => map (fun a => costing_split k (Split.full k a)) (arcs k)) (seq 3 6) =
  [[0]; [0; 2]; [0; 6]; [0; 14; 19]; [0; 40; 44]; [0; 102; 118; 110]]%N.
Proof. vm_compute. reflexivity. Qed.

Theorem valid_collapses : map (fun k => map (fun a => valid_configurations k (Collapse.full k a)) (arcs k)) (seq 3 5) =
  [[278]; [998; 1016]; [3562; 3640]; [12694; 12988; 13032]; [45218; 46280; 46492]]%N.
Proof. vm_compute. reflexivity. Qed.

Theorem costing_collapses : map (fun k => map (fun a => costing_collapse k (Collapse.full k a)) (arcs k)) (seq 3 5) =
  [[0]; [1; 4]; [7; 28]; [23; 83; 104]; [67; 238; 321]]%N.
Proof. vm_compute. reflexivity. Qed.
