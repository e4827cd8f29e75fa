(** * What a header that passes serves *)
Require Import Arith Bool List NArith Lia.
Import ListNotations.
Require Import Statements Header Kinds Bounds Meetings Walks WalkFamilies WalkOpen.

(** What the header's check has found is never looked into here. *)
Local Opaque found closed bounds_ok closings_ok meetings_ok.
Lemma all_four (a b c d : bool) : (if a then if b then if c then d else false else false else false) = true ->
  (a = true /\ d = true /\ c = true) /\ b = true.
Proof. destruct a, b, c, d; auto. Qed.

Section Served.
  Variable H : header.
  Hypothesis ok : header_ok H = true.
  Lemma parts_ok : closed H (found H) = true /\ meetings_ok H (listed (found H)) = true /\ closings_ok H (listed (found H)) = true.
  Proof. exact (proj1 (all_four _ _ _ _ ok)). Qed.

  Theorem split_served k a : 3 <= k -> 1 <= a < k -> serves_keys (split k a) true (split_answer H k a).
  Proof.
    intros Hk Ha. destruct parts_ok as (F & M & S). apply (served _ _ _ of_closed); [exact (split_walked H (found H) F M k a Hk Ha)|]. intros s J lab Ls. apply closed_clean. exact Ls.
  Qed.
  Theorem collapse_served k a : 3 <= k -> 1 <= a < k -> serves_keys (collapse k a) true (collapse_answer H k).
  Proof.
    intros Hk Ha. destruct parts_ok as (F & M & S). apply (served _ _ _ of_closed); [exact (collapse_walked H (found H) F S k a Hk Ha)|]. intros s J lab Ls. apply closed_clean. exact Ls.
  Qed.
  Theorem open_split_served k i j : 1 <= k -> i < j <= k -> serves_keys (open_split k i j) false (open_split_answer H k i j).
  Proof.
    intros Hk Hj. destruct parts_ok as (F & M & S). apply (served _ _ _ of_open); [exact (open_split_walked H (found H) F M k i j Hk Hj)|]. intros s J lab Ls. apply open_clean. exact Ls.
  Qed.
  Theorem open_collapse_served k i j : 1 <= k -> i < j <= k -> serves_keys (open_collapse k i j) false (fan_collapse_answer H k).
  Proof.
    intros Hk Hj. destruct parts_ok as (F & M & S). apply (served _ _ _ of_open); [exact (open_collapse_walked H (found H) F S k i j Hk Hj)|]. intros s J lab Ls. apply open_clean. exact Ls.
  Qed.
  Theorem boundary_split_served k i : 1 <= k -> i <= k -> serves_keys (boundary_split k i) false (boundary_split_answer H k i).
  Proof.
    intros Hk Hi. destruct parts_ok as (F & M & S). apply (served _ _ _ of_open); [exact (boundary_split_walked H (found H) F S k i Hk Hi)|]. intros s J lab Ls. apply open_clean. exact Ls.
  Qed.
  Theorem boundary_collapse_served k i : 1 <= k -> i <= k -> serves_keys (boundary_collapse k i) false (fan_collapse_answer H k).
  Proof.
    intros Hk Hi. destruct parts_ok as (F & M & S). apply (served _ _ _ of_open); [exact (boundary_collapse_walked H (found H) F S k i Hk Hi)|]. intros s J lab Ls. apply open_clean. exact Ls.
  Qed.

  Theorem automaton_serves : Automaton_serves H.
  Proof.
    intros [k a|k a|k i j|k i j|k i|k i]; cbn [possible patch_at closed_at answer];
      rewrite ?andb_true_iff, ?Nat.leb_le, ?Nat.ltb_lt; intros Po.
    - apply split_served; lia.
    - apply collapse_served; lia.
    - apply open_split_served; lia.
    - apply open_collapse_served; lia.
    - apply boundary_split_served; lia.
    - apply boundary_collapse_served; lia.
  Qed.
  Theorem automaton_inside : Automaton_inside H.
  Proof.
    intros H' L o Po s J. destruct (answers_inside H (found H) (proj1 parts_ok) (proj2 (all_four _ _ _ _ ok)) H' L) as (A & B & C & D & E).
    destruct o as [k a|k a|k i j|k i j|k i|k i]; cbn [possible answer] in *;
      rewrite ?andb_true_iff, ?Nat.leb_le, ?Nat.ltb_lt in Po.
    - apply A; lia.
    - apply B; lia.
    - apply C; lia.
    - apply E.
    - apply D.
    - apply E.
  Qed.
End Served.
