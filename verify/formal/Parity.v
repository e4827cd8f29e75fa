(** * Odd and even fans

    The same stages, each twice: after an even number of triangles of the fan and after an odd one. *)
Require Import Arith Bool List ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Frontier Classes Facts.

Definition parity (n : nat) : nat := if Nat.even n then 0 else 1.
Definition with_parity (arrows : list arrow) : list arrow :=
  flat_map (fun a =>
    let flip := if ported a then 1 else 0 in
    [Arrow (2 * from a) (2 * to a + flip) (ported a) (drawn_before a) (drawn_after a);
     Arrow (2 * from a + 1) (2 * to a + (1 - flip)) (ported a) (drawn_before a) (drawn_after a)]) arrows.

Lemma path_parity arrows : (forall a, In a arrows -> length (drawn_before a) = if ported a then 1 else 0) ->
  forall q B A, path arrows q B A -> path (with_parity arrows) (2 * q + parity (length B)) B A.
Proof.
  intros One q B A P. induction P as [|a p B A I P IH N]; [constructor|].
  pose (flip := if ported a then 1 else 0).
  pose (a0 := Arrow (2 * from a) (2 * to a + flip) (ported a) (drawn_before a) (drawn_after a)).
  pose (a1 := Arrow (2 * from a + 1) (2 * to a + (1 - flip)) (ported a) (drawn_before a) (drawn_after a)).
  assert (I0 : In a0 (with_parity arrows)) by (apply in_flat_map; exists a; split; [exact I|now left]).
  assert (I1 : In a1 (with_parity arrows)) by (apply in_flat_map; exists a; split; [exact I|right; now left]).
  assert (E : parity (length (B ++ map (step_from p) (drawn_before a))) =
    if Nat.even (length B) then flip else 1 - flip).
  { rewrite app_length, map_length, (One a I). unfold parity, flip. destruct (ported a); rewrite ?Nat.add_1_r, ?Nat.add_0_r.
    - rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even (length B)).
    - now destruct (Nat.even (length B)). }
  rewrite E. unfold parity in IH. destruct (Nat.even (length B)).
  - apply (path_on (with_parity arrows) a0 p B A I0); [cbn [from]; now rewrite Nat.add_0_r in IH|exact N].
  - exact (path_on (with_parity arrows) a1 p B A I1 IH N).
Qed.

Lemma open_one : forall a, In a open_arrows -> length (drawn_before a) = if ported a then 1 else 0.
Proof. intros a I. repeat (destruct I as [<-|I]; [reflexivity|]). destruct I. Qed.
Lemma boundary_one : forall a, In a boundary_arrows -> length (drawn_before a) = if ported a then 1 else 0.
Proof. intros a I. repeat (destruct I as [<-|I]; [reflexivity|]). destruct I. Qed.
