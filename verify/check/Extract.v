(* Extracts what restrip-check decides: judge and judge_flip of verify/formal/Check.v. `nat` stays what it is in Coq: the numbers are positions in a patch and counts of its edges. *)
From Coq Require Import Extraction ExtrOcamlBasic.
From Restrip Require Import Check.
Extraction Language OCaml.
Extraction "judge.ml" judge judge_flip.
