(* Extracts what restrip-check decides: judge and judge_flip of verify/formal/Check.v, judge_step of verify/formal/Step.v. `nat` stays what it is in Coq: the numbers are positions in a patch and counts of its edges, or a bound that is never reached. *)
From Coq Require Import Extraction ExtrOcamlBasic.
From Restrip Require Import Check Step.
Extraction Language OCaml.
Extraction "judge.ml" judge judge_flip judge_step.
