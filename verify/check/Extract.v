(* Extracts judge and judge_flip, of which verify/formal/Check.v proves judge_right and judge_flip_right, into judge.ml. `nat` stays what it is in Coq: the
   numbers are positions in a patch and counts of its edges. *)
From Coq Require Import Extraction ExtrOcamlBasic.
From Restrip Require Import Check.
Extraction Language OCaml.
Extraction "judge.ml" judge judge_flip.
Print Assumptions judge_right.
Print Assumptions judge_flip_right.
Print Assumptions chosen_is_safe.
