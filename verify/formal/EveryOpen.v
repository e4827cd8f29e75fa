(** * Open fans of any size: the facts *)
Require Import Arith Bool List ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements EveryFan Classes Closure Facts.

Definition ends (q : nat) : option (Z * Z) := match q with 6 => Some (2%Z, 0%Z) | 7 => Some (1%Z, 0%Z) | _ => None end.
Definition found : classes := explore open_arrows (2 ^ 18) [start_class] [] (PositiveMap.empty _).
Lemma checked : all_within open_arrows ends [] [] found = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem open_split_within k i j : 1 <= k -> i < j <= k ->
  within (open_split k i j) (answer_at (open_split_at k i j)) (if j =? S i then 0 else 1) 0.
Proof.
  intros Hk Hj. assert (E : ports (open_split k i j) = k) by apply seq_length. set (q := if j =? S i then 6 else 7).
  apply (fact_within (open_split k i j) (open_route k) (k - 1) 0 0 (chord_route k i j) (j + 1) (k - j) 1) with
    (arrows := open_arrows) (ends := ends) (last_before := []) (last_after := []) (R := found) (stage := q)
    (bS := if j =? S i then 2%Z else 1%Z) (bI := 0%Z).
  - rewrite E. apply open_along. lia.
  - rewrite E. apply chord_along. lia.
  - exact checked.
  - unfold q. destruct (j =? S i); reflexivity.
  - rewrite E. intros P Pn. destruct (open_words k i j P Hk Hj Pn) as (q' & B & A & -> & W). now exists B, A.
  - cbn [triangles before after open_split open_fan path_with_chord]. destruct (j =? S i); lia.
  - lia.
Qed.
