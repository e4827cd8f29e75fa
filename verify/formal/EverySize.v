(** * Rules, and sequences of operations, for fans of any size

    Every table that is correct in the sense of [Statements.v] has the same costs as the answers of [EveryFan.v]. *)
Require Import Arith Bool List ZArith Lia.
Import ListNotations.
Require Import Statements Checker Rows Symmetry Sequences EveryFan.
Require Graph EverySplit EveryCollapse EveryOpen EveryBoundary.

(** Two correct tables agree about everything but which of the best recolourings they give. *)
Theorem correct_agree : Correct_tables_agree.
Proof.
  intros p T U s c x CT CU Ls Lc E. destruct (CT s c Ls Lc) as [Tv Tn], (CU s c Ls Lc) as [Uv _].
  assert (V : valid (drawing (before p) s c)).
  { pose proof (Graph.valid_decided (drawing (before p) s c)) as [V|V]; [exact V|]. rewrite (Tn V) in E. discriminate. }
  destruct (Tv V) as (x' & E' & Lx & Bx). rewrite E in E'. injection E' as <-. destruct (Uv V) as (y & Ey & Ly & By).
  exists y. split; [exact Ey|]. pose proof (Bx y Ly). pose proof (By x Lx). unfold as_good in *. lia.
Qed.
Theorem correct_within : Correct_tables_cost.
Proof.
  intros p T U strips alone CT CU W s c x Ls Lc E. destruct (correct_agree p U T s c x CU CT Ls Lc E) as (y & Ey & S & I).
  destruct (W s c y Ls Lc Ey) as [W1 W2]. rewrite S, I. now split.
Qed.

(** ** The facts, for every position *)
Theorem every_within o : possible o = true -> within (patch_at o) (answer_at o) (strips_at o) (isolated_at o).
Proof.
  destruct o as [k a|k a|k i j|k i j|k i|k i]; cbn [possible patch_at strips_at isolated_at];
    rewrite ?andb_true_iff, ?Nat.leb_le, ?Nat.ltb_lt; intros H.
  - apply EverySplit.split_within; lia.
  - apply EveryCollapse.collapse_within; lia.
  - apply EveryOpen.open_split_within; lia.
  - apply EveryBoundary.open_collapse_within; lia.
  - apply EveryBoundary.boundary_split_within; lia.
  - apply EveryBoundary.boundary_collapse_within; lia.
Qed.
Theorem every_rule_right : Every_rule_right answer_at.
Proof. intros o Po. destruct (every_right o Po) as [C S]. split; [exact C|]. split; [exact S|now apply every_within]. Qed.

(** ** Sequences *)
Lemma correct_fine which p T : by_correct_tables which p T -> sensible p (before p) /\ sensible p (after p) /\ safe p T.
Proof.
  intros (o & Po & _ & -> & C). destruct (course_right o Po) as [W A].
  assert (S0 : sensible (patch_at o) (before (patch_at o))) by now apply well_formed_sensible.
  assert (S1 : sensible (patch_at o) (after (patch_at o))) by (eapply well_formed_sensible, along_well_formed, A).
  split; [exact S0|]. split; [exact S1|]. now apply correct_safe.
Qed.
Lemma correct_isolates_none p T : by_correct_tables isolates_none p T -> exists strips, within p T strips 0.
Proof.
  intros (o & Po & I & -> & C). apply Nat.eqb_eq in I. exists (strips_at o). rewrite <- I.
  exact (correct_within _ _ T _ _ (proj1 (every_right o Po)) C (every_within o Po)).
Qed.
Theorem every_sequence_right : Sequences_right by_correct_tables.
Proof.
  split; intros M told M' Q.
  - split; [exact (sequence_valid _ (correct_fine anywhere) M told M' Q)|exact (sequence_told _ (correct_fine anywhere) M told M' Q)].
  - intros N. assert (N' : none_isolated M').
    { exact (sequence_none_isolated _ (correct_fine isolates_none) M told M' correct_isolates_none Q N). }
    split; [exact N'|]. intros S. apply half_as_many; [exact (sequence_sane _ (correct_fine isolates_none) M told M' Q S)|exact N'].
Qed.

(** Tables that are correct for fans of at most eight triangles are correct tables. *)
Lemma sequence_of_more (A B : patch -> table -> Prop) M told M' : (forall p T, A p T -> B p T) ->
  sequence A M told M' -> sequence B M told M'.
Proof.
  intros I Q. induction Q as [|p T N N' t t' _ IH A' D]; [constructor|].
  apply (one_more B M p T N N' t t' IH (I p T A') D).
Qed.
Theorem sequences_right T : Rules_right T -> Sequences_right (by_tables T).
Proof.
  intros R. assert (I : forall which p U, by_tables T which p U -> by_correct_tables which p U).
  { intros which p U (o & Po & Wo & K & -> & ->). exists o. repeat (split; [easy|]). apply (R o Po K). }
  destruct every_sequence_right as [V N].
  split; intros M told M' Q; [apply (V M told M')|apply (N M told M')]; exact (sequence_of_more _ _ _ _ _ (I _) Q).
Qed.
