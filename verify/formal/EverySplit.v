(** * Splits of closed fans of any size: the facts *)
Require Import Arith Bool List ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements EveryFan Classes Closure Facts.

Definition ends (q : nat) : option (Z * Z) :=
  match q with 5 => Some (1%Z, 0%Z) | 6 | 7 => Some (2%Z, 0%Z) | _ => None end.
Definition found : classes := explore split_arrows (2 ^ 18) [start_class] [] (PositiveMap.empty _).
Lemma checked : all_within split_arrows ends closing closing found = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem split_within k a : 3 <= k -> 1 <= a < k ->
  within (split k a) (answer_at (split_at k a)) (if Nat.min a (k - a) =? 1 then 0 else 1) 0.
Proof.
  intros Hk Ha. assert (E : ports (split k a) = k) by apply seq_length.
  set (q := if a =? 1 then 6 else if k - a =? 1 then 7 else 5).
  apply (fact_within (split k a) (closed_route k) (k - 1) 1 0 (ring_route k a) (a + 1) (k - a + 1) 1) with
    (arrows := split_arrows) (ends := ends) (last_before := closing) (last_after := closing) (R := found) (stage := q)
    (bS := if Nat.min a (k - a) =? 1 then 2%Z else 1%Z) (bI := 0%Z).
  - rewrite E. apply closed_along. lia.
  - rewrite E. apply ring_along. lia.
  - exact checked.
  - unfold q. destruct (Nat.eqb_spec a 1) as [->|]; [|destruct (Nat.eqb_spec (k - a) 1) as [->|]].
    + rewrite Nat.min_l by lia. reflexivity. + rewrite Nat.min_r by lia. reflexivity.
    + destruct (Nat.eqb_spec (Nat.min a (k - a)) 1); [lia|reflexivity].
  - rewrite E. intros P Pn. destruct (split_words k a P Hk Ha Pn) as (q' & B & A & -> & W). now exists B, A.
  - cbn [triangles before after split closed_fan ring_with_chord]. destruct (Nat.min a (k - a) =? 1); lia.
  - lia.
Qed.
