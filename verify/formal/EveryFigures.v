(** * The known counts, out of the fold

    The answers of [EveryFan.v] are computed for every configuration of small fans, and counted: the numbers are those that
    [Figures.v] has from the shipped tables. *)
Require Import Arith Bool List NArith.
Import ListNotations.
Require Import Statements Checker EveryFan.

(** How many configurations of position (k, a) are answered, and how many answers cost a strip. *)
Definition split_counts (k a : nat) : N * N :=
  fold_left (fun '(n, m) '(s, c) =>
      match answer_at (split_at k a) s c with
      | Some x => (N.succ n, if solids x <? solids c + 2 then N.succ m else m)
      | None => (n, m)
      end)
    (list_prod (all_colorings k) (all_colorings k)) (0, 0)%N.

Theorem counted : map (fun k => map (split_counts k) (seq 1 (k / 2))) (seq 3 3) =
  [[(44, 0)]; [(160, 0); (160, 2)]; [(572, 0); (572, 6)]]%N.
Proof. vm_cast_no_check (eq_refl ([[(44, 0)]; [(160, 0); (160, 2)]; [(572, 0); (572, 6)]]%N)). Qed.
