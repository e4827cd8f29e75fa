(** * Collapses of closed fans of any size: the facts *)
Require Import Arith Bool List ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements EveryFan Classes Closure Facts.

Definition arrows : list arrow := map swap split_arrows.
Definition ends (q : nat) : option (Z * Z) := match q with 5 | 6 | 7 => Some ((-3)%Z, 0%Z) | _ => None end.
Definition found : classes := explore arrows (2 ^ 18) [start_class] [] (PositiveMap.empty _).
Lemma checked : all_within arrows ends closing closing found = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem collapse_within k a : 3 <= k -> 1 <= a < k -> within (collapse k a) (answer_at (collapse_at k a)) 1 0.
Proof.
  intros Hk Ha. assert (E : ports (collapse k a) = k) by apply seq_length.
  set (q := if a =? 1 then 6 else if k - a =? 1 then 7 else 5).
  apply (fact_within (collapse k a) (ring_route k a) (a + 1) (k - a + 1) 1 (closed_route k) (k - 1) 1 0) with
    (arrows := arrows) (ends := ends) (last_before := closing) (last_after := closing) (R := found) (stage := q)
    (bS := (-3)%Z) (bI := 0%Z).
  - rewrite E. apply ring_along. lia.
  - rewrite E. apply closed_along. lia.
  - exact checked.
  - unfold q. destruct (a =? 1), (k - a =? 1); reflexivity.
  - rewrite E. intros P Pn. destruct (split_words k a P Hk Ha Pn) as (q' & B & A & -> & W & Eq). exists A, B.
    split; [now apply path_swap|]. intros st Est. destruct (Eq st Est). now split.
  - cbn [triangles before after collapse closed_fan ring_with_chord]. lia.
  - lia.
Qed.
