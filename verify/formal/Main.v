(** * The theorems

    [Statements.v] defines each of them; this file names the tables and numbers of the shipped headers to which they apply.
    Printed from the headers, [Shipped.shipped o] is the table of position [o], [Flip.full] the table of flips, and
    [Automaton.automaton] holds the numbers of the automaton; [Shipped.by_key o] are rows of the certificates.

    After each theorem Coq prints its assumptions; scripts/prove.sh requires "Closed under the global context". *)
Require Import Arith Bool List NArith.
Import ListNotations.
Require Import Statements.
Require Locality Strips Shipped Answers Flip EveryFan EverySize EveryFigures Figures Rejects Met WholeMesh LowerBound Check Step.
Require Header Meetings AutomatonNumbers Automaton Served AutomatonRejects ChangesRejects.
Require Split OpenSplit Symmetry Sequences.
Require Positions Changes Tables_split Tables_collapse Tables_open_split Tables_open_collapse Tables_boundary_split Tables_boundary_collapse Tables_flip.
Require Changes_split Changes_collapse Changes_open_split Changes_open_collapse Changes_boundary_split Changes_boundary_collapse Changes_flip.

(** ** Statements *)
Theorem locality : Locality.
Proof. exact Locality.locality. Qed.
Print Assumptions locality.
Theorem valid_is_stripped : Valid_is_stripped.
Proof. exact Strips.valid_is_stripped. Qed.
Print Assumptions valid_is_stripped.
Theorem rules_right : Rules_right Shipped.shipped.
Proof. exact Shipped.rules_right. Qed.
Print Assumptions rules_right.
Theorem even_gaps : Even_gaps Shipped.shipped.
Proof. exact Shipped.even_gaps. Qed.
Print Assumptions even_gaps.
Theorem rows_say_the_same : Rows_say_the_same Shipped.shipped Shipped.by_key.
Proof. exact Shipped.rows_say_the_same. Qed.
Print Assumptions rows_say_the_same.
Theorem flip_right : Flip_right (Table.lookup Flip.full).
Proof. exact (conj Flip.flip_rules (conj Flip.flip_is_safe Flip.flip_facts)). Qed.
Print Assumptions flip_right.
Theorem every_rule_right : Every_rule_right EveryFan.answer_at.
Proof. exact EverySize.every_rule_right. Qed.
Print Assumptions every_rule_right.
Theorem correct_tables_agree : Correct_tables_agree.
Proof. exact EverySize.correct_agree. Qed.
Print Assumptions correct_tables_agree.
Theorem correct_tables_cost : Correct_tables_cost.
Proof. exact EverySize.correct_within. Qed.
Print Assumptions correct_tables_cost.
Theorem automaton_serves : Automaton_serves Automaton.automaton.
Proof. exact (Served.automaton_serves _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_serves.
Theorem automaton_inside : Automaton_inside Automaton.automaton.
Proof. exact (Served.automaton_inside _ Automaton.automaton_ok). Qed.
Print Assumptions automaton_inside.
Theorem sequences_right : Sequences_right (Meshes.by_tables Shipped.shipped).
Proof. exact (EverySize.sequences_right _ Shipped.rules_right). Qed.
Print Assumptions sequences_right.
Theorem every_sequence_right : Sequences_right Meshes.by_correct_tables.
Proof. exact EverySize.every_sequence_right. Qed.
Print Assumptions every_sequence_right.
Theorem strips_counted : Strips_counted.
Proof. exact Sequences.strips_counted. Qed.
Print Assumptions strips_counted.
Theorem operation_met : Operation_met Shipped.shipped.
Proof. exact Met.operation_met. Qed.
Print Assumptions operation_met.
Theorem whole_mesh : Whole_mesh.
Proof. exact WholeMesh.whole_mesh. Qed.
Print Assumptions whole_mesh.
Theorem whole_mesh_quarter : Whole_mesh_quarter.
Proof. exact WholeMesh.whole_mesh_quarter. Qed.
Print Assumptions whole_mesh_quarter.
Theorem whole_mesh_any : Whole_mesh_any.
Proof. exact WholeMesh.whole_mesh_any. Qed.
Print Assumptions whole_mesh_any.
Theorem whole_mesh_covers : Whole_mesh_covers.
Proof. exact WholeMesh.whole_mesh_covers. Qed.
Print Assumptions whole_mesh_covers.
Theorem every_rule_pays : Every_rule_pays.
Proof. exact LowerBound.every_rule_pays. Qed.
Print Assumptions every_rule_pays.
Theorem one_strip_before : One_strip_before.
Proof. exact LowerBound.one_strip_before. Qed.
Print Assumptions one_strip_before.
Theorem no_rule_competes : No_rule_competes.
Proof. exact LowerBound.no_rule_competes. Qed.
Print Assumptions no_rule_competes.
Theorem one_strip_would_do : One_strip_would_do.
Proof. exact LowerBound.one_strip_would_do. Qed.
Print Assumptions one_strip_would_do.
Theorem judge_right : Judge_right (@Check.judge).
Proof. exact @Check.judge_right. Qed.
Print Assumptions judge_right.
Theorem judge_flip_right : Judge_flip_right (@Check.judge_flip).
Proof. exact @Check.judge_flip_right. Qed.
Print Assumptions judge_flip_right.
Theorem judge_step_right : Judge_step_right (@Step.judge_step).
Proof. exact @Step.judge_step_right. Qed.
Print Assumptions judge_step_right.
Theorem chosen_is_safe : Chosen_is_safe.
Proof. exact Check.chosen_is_safe. Qed.
Print Assumptions chosen_is_safe.

(** ** Comparisons, by computation

    Every position of which prove.sh counts the answers is one that [rules_right] speaks of. *)
Theorem answers : Forall (fun o => right_at o (Shipped.shipped o)) Answers.all_positions.
Proof. exact Answers.all_right. Qed.
Print Assumptions answers.
(** The look-up of [Statements.v] and the compiled one give the same answers and the same numbers of solid edges and isolated
    triangles, for every key of every position up to k = 7. *)
Theorem automaton_looked_up : map fst AutomatonNumbers.digests = Header.positions 7 /\
  forallb (fun d => N.eqb (Header.digest_at Automaton.automaton (fst (fst d)) (snd (fst d))) (snd d)) AutomatonNumbers.digests = true.
Proof. exact Automaton.looked_up. Qed.
Print Assumptions automaton_looked_up.
Theorem automaton_told : map fst AutomatonNumbers.told_digests = Header.positions 7 /\
  forallb (fun d => N.eqb (Automaton.told_at Automaton.automaton (fst (fst d)) (snd (fst d))) (snd d)) AutomatonNumbers.told_digests = true.
Proof. exact Automaton.looked_up_told. Qed.
Print Assumptions automaton_told.
(** The changes in strips and isolated triangles that every answer of the headers reports; [Telling.tells] defines correctness. *)
Theorem answers_tell :
  Forall (fun at_ => Telling.tells false (Changes.of_two split at_) (Changes.two Tables_split.table at_) (Changes.two Changes_split.table at_)) Positions.arcs /\
  Forall (fun at_ => Telling.tells false (Changes.of_two collapse at_) (Changes.two Tables_collapse.table at_) (Changes.two Changes_collapse.table at_)) Positions.arcs /\
  Forall (fun at_ => Telling.tells false (Changes.of_three open_split at_) (Changes.three Tables_open_split.table at_) (Changes.three Changes_open_split.table at_)) Positions.gap_pairs /\
  Forall (fun at_ => Telling.tells false (Changes.of_three open_collapse at_) (Changes.three Tables_open_collapse.table at_) (Changes.three Changes_open_collapse.table at_)) Positions.gap_pairs /\
  Forall (fun at_ => Telling.tells false (Changes.of_two boundary_split at_) (Changes.two Tables_boundary_split.table at_) (Changes.two Changes_boundary_split.table at_)) Positions.gaps /\
  Forall (fun at_ => Telling.tells false (Changes.of_two boundary_collapse at_) (Changes.two Tables_boundary_collapse.table at_) (Changes.two Changes_boundary_collapse.table at_)) Positions.gaps /\
  Telling.tells true flip (Tables_flip.table []) (Changes_flip.table []).
Proof. exact Changes.answers_tell. Qed.
Print Assumptions answers_tell.
(** Meshes to which the bounds apply, and of which they are equations: T, S, I, C, B, and the meetings of two strips. Without the
    assumptions the inequalities fail. *)
Import Whole WholeMesh.
Theorem whole_mesh_met : Forall (fun '(M, numbers) => well_formed M /\ ends_joined M /\ simple M /\ counts M = numbers)
  [(five, [5; 2; 1; 1; 3; 0]); (tetrahedron, [4; 1; 0; 1; 0; 0]); (bipyramid, [6; 1; 0; 0; 0; 0])].
Proof. exact WholeMesh.whole_mesh_met. Qed.
Print Assumptions whole_mesh_met.
Theorem whole_mesh_needs :
  well_formed halves /\ simple halves /\ counts halves = [4; 2; 0; 0; 0; 4] /\
  well_formed pillow /\ ends_joined pillow /\ counts pillow = [2; 1; 0; 2; 0; 0].
Proof. exact WholeMesh.whole_mesh_needs. Qed.
Print Assumptions whole_mesh_needs.
(** The known counts, for k = 3, 4, ... and a = 1, 2, ...: valid configurations, and those that cost a strip; out of the shipped
    tables, and out of the answers for every k. *)
Theorem valid_splits : map (fun k => map (fun a => Figures.valid_configurations k (Split.full k a)) (seq 1 (k / 2))) (seq 3 6) =
  [[44]; [160; 160]; [572; 572]; [2040; 2040; 2040]; [7268; 7268; 7268]; [25888; 25888; 25888; 25888]]%N.
Proof. exact Figures.valid_splits. Qed.
Print Assumptions valid_splits.
Theorem costing_splits : map (fun k => map (fun a => Figures.costing_split k (Split.full k a)) (seq 1 (k / 2))) (seq 3 6) =
  [[0]; [0; 2]; [0; 6]; [0; 14; 19]; [0; 40; 44]; [0; 102; 118; 110]]%N.
Proof. exact Figures.costing_splits. Qed.
Print Assumptions costing_splits.
Theorem valid_collapses : map (fun k => map (fun a => Figures.valid_configurations k (Collapse.full k a)) (seq 1 (k / 2))) (seq 3 5) =
  [[278]; [998; 1016]; [3562; 3640]; [12694; 12988; 13032]; [45218; 46280; 46492]]%N.
Proof. exact Figures.valid_collapses. Qed.
Print Assumptions valid_collapses.
Theorem costing_collapses : map (fun k => map (fun a => Figures.costing_collapse k (Collapse.full k a)) (seq 1 (k / 2))) (seq 3 5) =
  [[0]; [1; 4]; [7; 28]; [23; 83; 104]; [67; 238; 321]]%N.
Proof. exact Figures.costing_collapses. Qed.
Print Assumptions costing_collapses.
Theorem every_counts : map (fun k => map (EveryFigures.split_counts k) (seq 1 (k / 2))) (seq 3 3) =
  [[(44, 0)]; [(160, 0); (160, 2)]; [(572, 0); (572, 6)]]%N.
Proof. exact EveryFigures.counted. Qed.
Print Assumptions every_counts.
(** Wrong tables, wrong rows, wrong reported numbers (how many, and whether all of them are refused) and wrong automata are refused:
    of these one bit was changed, one answer left out or made up, or an array is too short. *)
Theorem wrong_tables_refused : length (Rejects.wrong_tables 3 1) = 348 /\ Rejects.refused 3 1 && Rejects.refused 4 2 = true.
Proof. exact Rejects.wrong_tables_refused. Qed.
Print Assumptions wrong_tables_refused.
Theorem wrong_open_tables_refused : Rejects.open_refused 2 0 1 && Rejects.open_refused 3 0 2 && Rejects.open_refused 3 1 2 = true.
Proof. exact Rejects.wrong_open_tables_refused. Qed.
Print Assumptions wrong_open_tables_refused.
Theorem wrong_rows_refused : Rejects.rows_refused 3 1 && Rejects.rows_refused 4 2 = true.
Proof. exact Rejects.wrong_rows_refused. Qed.
Print Assumptions wrong_rows_refused.
Theorem wrong_images_refused : Rejects.image_refused 3 2 = true.
Proof. exact Rejects.wrong_images_refused. Qed.
Print Assumptions wrong_images_refused.
Theorem careless_images_refused :
  forallb (fun '(k, a) => Split.compares (k, a) &&
      negb (Symmetry.compare (Symmetry.turned k a) (split k a) (split k (k - a)) (Split.full k (k - a))
              (Rejects.with_answers (Rejects.turned_too_little k) (Split.full k a))))
    [(3, 2); (4, 3); (5, 3); (5, 4)] = true.
Proof. exact Rejects.careless_images_refused. Qed.
Print Assumptions careless_images_refused.
Theorem wrong_told_refused : ChangesRejects.small = [(788, true); (848, true); (439, true)] /\ ChangesRejects.large = repeat (5, true) 6.
Proof. exact ChangesRejects.wrong_told_refused. Qed.
Print Assumptions wrong_told_refused.
Theorem wrong_automata_refused : forallb (fun H => negb (Meetings.header_ok H)) AutomatonRejects.wrong_automata = true.
Proof. exact AutomatonRejects.wrong_automata_refused. Qed.
Print Assumptions wrong_automata_refused.
