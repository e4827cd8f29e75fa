(** * Facts about graphs

    What it means for [linked], [acyclic] and [valid] to put one more edge in; and sums of degrees. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements.

Lemma adjacent_sym G v w : adjacent G v w -> adjacent G w v.
Proof. unfold adjacent. tauto. Qed.

Lemma linked_trans G u v w : linked G u v -> linked G v w -> linked G u w.
Proof. intros L M. induction M as [|x y _ IH A]; [exact L|]. exact (onward _ _ _ _ IH A). Qed.

Lemma linked_edge G v w : adjacent G v w -> linked G v w.
Proof. intros A. exact (onward _ _ _ _ (here _ _) A). Qed.

Lemma linked_sym G u v : linked G u v -> linked G v u.
Proof.
  intros L. induction L as [|v w _ IH A]; [apply here|].
  apply linked_trans with v; [|exact IH]. now apply linked_edge, adjacent_sym.
Qed.

Lemma linked_mono G H u v : incl G H -> linked G u v -> linked H u v.
Proof.
  intros I L. induction L as [|v w _ IH A]; [apply here|]. apply onward with v; [exact IH|].
  destruct A as [A|A]; [left|right]; now apply I.
Qed.

Lemma linked_perm G H u v : Permutation G H -> linked G u v -> linked H u v.
Proof. intros P. apply linked_mono. intros e. now apply Permutation_in. Qed.

(** A walk in [e :: G] avoids [e], or crosses it from one side or the other. *)
Lemma linked_cons a b G u v :
  linked ((a, b) :: G) u v <->
  linked G u v \/ (linked G u a /\ linked G b v) \/ (linked G u b /\ linked G a v).
Proof.
  assert (W : forall x y, linked G x y -> linked ((a, b) :: G) x y).
  { intros x y. apply linked_mono. intros e. now right. }
  assert (E : linked ((a, b) :: G) a b) by (apply linked_edge; left; now left).
  split.
  - intros L. induction L as [|v w _ IH A]; [left; apply here|].
    assert (C : v = a /\ w = b \/ v = b /\ w = a \/ adjacent G v w).
    { destruct A as [[A|A]|[A|A]]; [injection A; auto|right; right; now left|injection A; auto|right; right; now right]. }
    destruct C as [[-> ->]|[[-> ->]|C]].
    + destruct IH as [IH|[[IH _]|[IH _]]]; [right; left; split; auto using here|right; left; split; auto using here|].
      left. exact IH.
    + destruct IH as [IH|[[IH _]|[IH _]]]; [right; right; split; auto using here|left; exact IH|].
      right; right; split; auto using here.
    + destruct IH as [IH|[[I J]|[I J]]]; [left|right; left; split|right; right; split]; eauto using onward.
  - intros [L|[[L M]|[L M]]]; [now apply W| |].
    + eapply linked_trans; [apply W, L|]. eapply linked_trans; [exact E|apply W, M].
    + eapply linked_trans; [apply W, L|]. eapply linked_trans; [apply linked_sym, E|apply W, M].
Qed.

Lemma linked_nil u v : linked [] u v -> u = v.
Proof. intros L. induction L as [|v w _ _ [[]|[]]]. reflexivity. Qed.

Lemma linked_or_not G : forall u v, linked G u v \/ ~ linked G u v.
Proof.
  induction G as [|[a b] G IH]; intros u v.
  - destruct (Nat.eq_dec u v) as [->|N]; [left; apply here|right; intros L; now apply N, linked_nil].
  - rewrite linked_cons. destruct (IH u v), (IH u a), (IH b v), (IH u b), (IH a v); tauto.
Qed.

Lemma cons_cases (e f : edge) G H : Permutation (e :: G) (f :: H) ->
  (e = f /\ Permutation G H) \/ exists K, Permutation G (f :: K) /\ Permutation H (e :: K).
Proof.
  intros P. assert (I : In f (e :: G)) by (apply (Permutation_in _ (Permutation_sym P)); now left).
  destruct I as [->|I]; [left; split; [reflexivity|exact (Permutation_cons_inv P)]|].
  right. apply in_split in I as (G1 & G2 & ->). exists (G1 ++ G2). split; [symmetry; apply Permutation_middle|].
  apply Permutation_cons_inv with f. rewrite <- P. rewrite perm_swap. apply perm_skip. symmetry. apply Permutation_middle.
Qed.

Lemma acyclic_perm G H : Permutation G H -> acyclic G -> acyclic H.
Proof. intros P A e rest Q. apply A. now rewrite P. Qed.

(** One more edge keeps a forest a forest exactly when its ends were not linked. *)
Lemma acyclic_cons a b G : acyclic ((a, b) :: G) <-> acyclic G /\ ~ linked G a b.
Proof.
  split.
  - intros A. split.
    + intros [c d] rest P L. apply (A (c, d) ((a, b) :: rest)).
      * rewrite P. apply perm_swap.
      * apply linked_mono with rest; [intros e; now right|exact L].
    + exact (A (a, b) G (Permutation_refl _)).
  - intros [A N] [c d] rest P L. simpl in L. apply cons_cases in P as [[E P]|(K & P & Q)].
    + injection E as -> ->. apply N. exact (linked_perm _ _ _ _ (Permutation_sym P) L).
    + apply (linked_perm _ _ _ _ Q) in L. apply linked_cons in L.
      assert (W : forall x y, linked K x y -> linked G x y).
      { intros x y. apply linked_mono. intros e I. apply (Permutation_in _ (Permutation_sym P)). now right. }
      assert (E : linked G c d).
      { apply linked_edge. left. apply (Permutation_in _ (Permutation_sym P)). now left. }
      destruct L as [L|[[L M]|[L M]]].
      * exact (A _ _ P L).
      * apply N. eapply linked_trans; [apply linked_sym, W, L|]. eapply linked_trans; [exact E|]. apply linked_sym, W, M.
      * apply N. eapply linked_trans; [apply W, M|]. eapply linked_trans; [apply linked_sym, E|]. apply W, L.
Qed.

Lemma acyclic_nil : acyclic [].
Proof. intros e rest P. apply Permutation_nil in P. discriminate. Qed.

Lemma degree_cons e G v : degree (e :: G) v = meets e v + degree G v.
Proof. reflexivity. Qed.

Lemma degree_app G H v : degree (G ++ H) v = degree G v + degree H v.
Proof. unfold degree. now rewrite map_app, list_sum_app. Qed.

Lemma degree_zero G v : (forall e, In e G -> fst e <> v /\ snd e <> v) -> degree G v = 0.
Proof.
  induction G as [|e G IH]; intros N; [reflexivity|]. rewrite degree_cons, IH by (intros f I; apply N; now right).
  destruct (N e (or_introl eq_refl)). unfold meets. destruct (Nat.eqb_spec (fst e) v), (Nat.eqb_spec (snd e) v); tauto.
Qed.

Lemma degree_perm G H v : Permutation G H -> degree G v = degree H v.
Proof. intros P. induction P; rewrite ?degree_cons; lia. Qed.

Lemma valid_perm G H : Permutation G H -> valid G -> valid H.
Proof.
  intros P [D A]. split; [|exact (acyclic_perm _ _ P A)]. intros v. rewrite <- (degree_perm _ _ v P). apply D.
Qed.

Lemma valid_nil : valid [].
Proof. split; [intros v; simpl; auto|apply acyclic_nil]. Qed.

(** The test that a checker makes when it draws one more edge. *)
Lemma valid_cons a b G :
  valid ((a, b) :: G) <-> valid G /\ degree G a <= 1 /\ degree G b <= 1 /\ ~ linked G a b.
Proof.
  unfold valid. rewrite acyclic_cons. split.
  - intros [D [A N]]. repeat split; auto.
    + intros v. specialize (D v). rewrite degree_cons in D. lia.
    + specialize (D a). rewrite degree_cons in D. unfold meets in D. simpl in D. rewrite Nat.eqb_refl in D. lia.
    + specialize (D b). rewrite degree_cons in D. unfold meets in D. simpl in D. rewrite Nat.eqb_refl in D. lia.
  - intros [[D A] [Da [Db N]]]. repeat split; auto. intros v. rewrite degree_cons. unfold meets. simpl.
    assert (a <> b) by (intros ->; apply N, here). specialize (D v).
    destruct (Nat.eqb_spec a v), (Nat.eqb_spec b v); subst; lia.
Qed.

Lemma valid_decided G : valid G \/ ~ valid G.
Proof.
  induction G as [|[a b] G IH]; [left; apply valid_nil|]. rewrite valid_cons.
  destruct IH as [V|V]; [|tauto]. destruct (linked_or_not G a b); [tauto|].
  destruct (le_dec (degree G a) 1), (le_dec (degree G b) 1); tauto.
Qed.

Lemma valid_tail e G : valid (e :: G) -> valid G.
Proof. destruct e. rewrite valid_cons. tauto. Qed.

Lemma valid_suffix G H : valid (G ++ H) -> valid H.
Proof. induction G as [|e G IH]; simpl; [auto|]. intros V. exact (IH (valid_tail _ _ V)). Qed.

(** The sum of the degrees, with a weight for each vertex: every edge counts at both of its ends. *)
Lemma sum_at (w : nat -> nat) vs a : NoDup vs -> In a vs -> list_sum (map (fun v => w v * if a =? v then 1 else 0) vs) = w a.
Proof.
  assert (Out : forall vs, ~ In a vs -> list_sum (map (fun v => w v * if a =? v then 1 else 0) vs) = 0).
  { clear vs. induction vs as [|v vs IH]; [reflexivity|]. simpl. intros O. rewrite IH by tauto. destruct (Nat.eqb_spec a v); [subst; tauto|lia]. }
  intros N. induction N as [|v vs Nv N IH]; [intros []|]. simpl. intros [->|I].
  - rewrite Nat.eqb_refl, (Out vs Nv). lia.
  - destruct (Nat.eqb_spec a v); [subst; contradiction|]. rewrite IH by exact I. lia.
Qed.
Lemma weighted_handshake (w : nat -> nat) vs G : NoDup vs -> (forall e, In e G -> In (fst e) vs /\ In (snd e) vs) ->
  list_sum (map (fun v => w v * degree G v) vs) = list_sum (map (fun e => w (fst e) + w (snd e)) G).
Proof.
  intros N. induction G as [|e G IH]; intros I.
  - simpl. clear. induction vs as [|v vs IH]; simpl; [reflexivity|]. rewrite IH. unfold degree. simpl. lia.
  - simpl. destruct (I e (or_introl eq_refl)) as [A B]. rewrite <- IH by (intros f J; apply I; now right).
    rewrite <- (sum_at w vs (fst e) N A), <- (sum_at w vs (snd e) N B). clear.
    induction vs as [|v vs IH]; [reflexivity|]. simpl. rewrite IH, degree_cons. unfold meets. lia.
Qed.
Lemma handshake vs G : NoDup vs -> (forall e, In e G -> In (fst e) vs /\ In (snd e) vs) ->
  list_sum (map (degree G) vs) = 2 * length G.
Proof.
  intros N I. transitivity (list_sum (map (fun v => 1 * degree G v) vs)); [f_equal; apply map_ext; intros v; lia|].
  rewrite (weighted_handshake (fun _ => 1) vs G N I). clear. induction G as [|e G IH]; [reflexivity|]. simpl in *. lia.
Qed.
