(** * Collapses of open fans, and operations on the boundary, for fans of any size: the facts *)
Require Import Arith Bool List ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Route EveryFan Classes Closure Facts Parity.

(** The words of an open fan have a step for each of its triangles. *)
Lemma length_open_route k : 1 <= k -> length (open_route k) = k.
Proof. intros H. unfold open_route, route. rewrite (seq_more 0 k) by lia. cbn [app length]. rewrite !app_nil_r, map_length, seq_length. lia. Qed.
Definition some_step (P : nat -> option nat) (x : kind * nat) := step_from (P (snd x)) (fst x, true).

Definition open_back_arrows : list arrow := map swap (with_parity open_arrows).
Definition open_back_ends (q : nat) : option (Z * Z) :=
  match q with 12 | 14 => Some ((-3)%Z, 0%Z) | 13 | 15 => Some ((-3)%Z, 1%Z) | _ => None end.
Definition open_back_found : classes := explore open_back_arrows (2 ^ 16) [start_class] [] (PositiveMap.empty _).
Lemma open_back_checked : all_within open_back_arrows open_back_ends [] [] open_back_found = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem open_collapse_within k i j : 1 <= k -> i < j <= k ->
  within (open_collapse k i j) (answer_at (open_collapse_at k i j)) 1 (if Nat.even k then 0 else 1).
Proof.
  intros Hk Hj. assert (E : ports (open_collapse k i j) = k) by apply seq_length. set (q := if j =? S i then 6 else 7).
  apply (fact_within (open_collapse k i j) (chord_route k i j) (j + 1) (k - j) 1 (open_route k) (k - 1) 0 0) with
    (arrows := open_back_arrows) (ends := open_back_ends) (last_before := []) (last_after := []) (R := open_back_found)
    (stage := 2 * q + parity k) (bS := (-3)%Z) (bI := if Nat.even k then 0%Z else 1%Z).
  - rewrite E. apply chord_along. lia.
  - rewrite E. apply open_along. lia.
  - exact open_back_checked.
  - unfold q, parity. destruct (j =? S i), (Nat.even k); reflexivity.
  - rewrite E. intros P Pn. destruct (open_words k i j P Hk Hj Pn) as (q' & B & A & -> & W & Eq). exists A, B.
    split; [|intros st Est; destruct (Eq st Est); now split]. apply path_swap.
    assert (L : length B = k).
    { destruct (Eq (some_step P) (fun x => eq_refl)) as [L _]. rewrite app_nil_r in L. now rewrite <- L, map_length, length_open_route. }
    rewrite <- L at 1. apply path_parity; [exact open_one|exact W].
  - cbn [triangles before after open_collapse open_fan path_with_chord]. lia.
  - destruct (Nat.even k); lia.
Qed.

Definition boundary_ends (q : nat) : option (Z * Z) :=
  match q with
  | 8 | 9 | 12 | 13 => Some (1%Z, 0%Z)
  | 10 | 14 => Some (0%Z, 1%Z)
  | 11 | 15 => Some (0%Z, 0%Z)
  | _ => None
  end.
Definition boundary_found : classes := explore (with_parity boundary_arrows) (2 ^ 16) [start_class] [] (PositiveMap.empty _).
Lemma boundary_checked : all_within (with_parity boundary_arrows) boundary_ends [] [] boundary_found = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Definition gap_stage (k i : nat) : nat :=
  if i =? 0 then 7 else if i =? 1 then 4 else if k - i =? 0 then 5 else if k - i =? 1 then 6 else 7.

Theorem boundary_split_within k i : 1 <= k -> i <= k ->
  within (boundary_split k i) (answer_at (boundary_split_at k i)) (if Nat.min i (k - i) =? 1 then 0 else 1) (if Nat.even k then 1 else 0).
Proof.
  intros Hk Hi. assert (E : ports (boundary_split k i) = k) by apply seq_length. set (q := gap_stage k i).
  apply (fact_within (boundary_split k i) (open_route k) (k - 1) 0 0 (one_route k i) k 0 0) with
    (arrows := with_parity boundary_arrows) (ends := boundary_ends) (last_before := []) (last_after := []) (R := boundary_found)
    (stage := 2 * q + parity k) (bS := match q with 4 | 6 => 1%Z | _ => 0%Z end)
    (bI := match q with 4 | 6 => 0%Z | _ => if Nat.even k then 1%Z else 0%Z end).
  - rewrite E. apply open_along. lia.
  - rewrite E. apply one_along. lia.
  - exact boundary_checked.
  - unfold q, gap_stage, parity. destruct (i =? 0), (i =? 1), (k - i =? 0), (k - i =? 1), (Nat.even k); reflexivity.
  - rewrite E. intros P Pn. destruct (boundary_words k i P Hk Hi Pn) as (q' & B & A & -> & W & Eq). exists B, A.
    split; [|exact Eq]. fold (gap_stage k i) in W. fold q in W.
    assert (L : length B = k).
    { destruct (Eq (some_step P) (fun x => eq_refl)) as [L _]. rewrite app_nil_r in L. now rewrite <- L, map_length, length_open_route. }
    rewrite <- L at 1. apply path_parity; [exact boundary_one|exact W].
  - cbn [triangles before after boundary_split open_fan path_with_one]. unfold q, gap_stage.
    destruct (Nat.eqb_spec i 0), (Nat.eqb_spec i 1), (Nat.eqb_spec (k - i) 0), (Nat.eqb_spec (k - i) 1), (Nat.eqb_spec (Nat.min i (k - i)) 1); lia.
  - unfold q, gap_stage. destruct (i =? 0), (i =? 1), (k - i =? 0), (k - i =? 1), (Nat.even k); cbn; lia.
Qed.

Definition boundary_back_arrows : list arrow := map swap (with_parity boundary_arrows).
Definition boundary_back_ends (q : nat) : option (Z * Z) :=
  match q with 8 | 10 | 12 | 14 => Some ((-1)%Z, 0%Z) | 9 | 11 | 13 | 15 => Some ((-1)%Z, 1%Z) | _ => None end.
Definition boundary_back_found : classes := explore boundary_back_arrows (2 ^ 16) [start_class] [] (PositiveMap.empty _).
Lemma boundary_back_checked : all_within boundary_back_arrows boundary_back_ends [] [] boundary_back_found = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem boundary_collapse_within k i : 1 <= k -> i <= k ->
  within (boundary_collapse k i) (answer_at (boundary_collapse_at k i)) 0 (if Nat.even k then 0 else 1).
Proof.
  intros Hk Hi. assert (E : ports (boundary_collapse k i) = k) by apply seq_length. set (q := gap_stage k i).
  apply (fact_within (boundary_collapse k i) (one_route k i) k 0 0 (open_route k) (k - 1) 0 0) with
    (arrows := boundary_back_arrows) (ends := boundary_back_ends) (last_before := []) (last_after := []) (R := boundary_back_found)
    (stage := 2 * q + parity k) (bS := (-1)%Z) (bI := if Nat.even k then 0%Z else 1%Z).
  - rewrite E. apply one_along. lia.
  - rewrite E. apply open_along. lia.
  - exact boundary_back_checked.
  - unfold q, gap_stage, parity. destruct (i =? 0), (i =? 1), (k - i =? 0), (k - i =? 1), (Nat.even k); reflexivity.
  - rewrite E. intros P Pn. destruct (boundary_words k i P Hk Hi Pn) as (q' & B & A & -> & W & Eq). exists A, B.
    split; [|intros st Est; destruct (Eq st Est); now split]. apply path_swap. fold (gap_stage k i) in W. fold q in W.
    assert (L : length B = k).
    { destruct (Eq (some_step P) (fun x => eq_refl)) as [L _]. rewrite app_nil_r in L. now rewrite <- L, map_length, length_open_route. }
    rewrite <- L at 1. apply path_parity; [exact boundary_one|exact W].
  - cbn [triangles before after boundary_collapse open_fan path_with_one]. lia.
  - destruct (Nat.even k); lia.
Qed.
