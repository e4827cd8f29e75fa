(** * Counting isolated triangles without a graph

    For each triangle a mark: does it have a solid edge? *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Graph.

Definition marks := list bool.
Fixpoint mark (t : nat) (m : marks) : marks :=
  match m, t with [], _ => [] | _ :: r, 0 => true :: r | b :: r, S t' => b :: mark t' r end.
Definition mark_both (e : edge) (m : marks) : marks := mark (fst e) (mark (snd e) m).
Fixpoint mark_owners (owners : list nat) (s : coloring) (m : marks) : marks :=
  match owners, s with t :: o, b :: s' => mark_owners o s' (if b then mark t m else m) | _, _ => m end.
Fixpoint mark_inner (es : list edge) (c : coloring) (m : marks) : marks :=
  match es, c with e :: es', b :: c' => mark_inner es' c' (if b then mark_both e m else m) | _, _ => m end.
Fixpoint unmarked (m : marks) : nat := match m with [] => 0 | b :: r => if b then unmarked r else S (unmarked r) end.
Definition no_marks (d : side) : marks := repeat false (triangles d).

(** [n] ports are numbered before the triangles. *)
Definition marked (n : nat) (m : marks) (G : graph) : Prop := forall t, t < length m -> nth t m false = negb (degree G (n + t) =? 0).

Lemma mark_length m : forall t, length (mark t m) = length m.
Proof. induction m as [|b m IH]; intros [|t]; simpl; auto. Qed.
Lemma mark_nth m : forall t v, v < length m -> nth v (mark t m) false = (t =? v) || nth v m false.
Proof. induction m as [|b m IH]; intros [|t] [|v] H; simpl in *; try lia; auto. apply IH. lia. Qed.
Lemma marked_both n m G e : marked n m G -> marked n (mark_both e m) ((n + fst e, n + snd e) :: G).
Proof.
  intros M t H. unfold mark_both in *. rewrite !mark_length in H. rewrite !mark_nth, (M t H) by (rewrite ?mark_length; exact H).
  rewrite degree_cons. unfold meets. cbn [fst snd].
  destruct (Nat.eqb_spec (fst e) t), (Nat.eqb_spec (snd e) t), (Nat.eqb_spec (n + fst e) (n + t)), (Nat.eqb_spec (n + snd e) (n + t)); try lia; reflexivity.
Qed.
Lemma marked_owner n m G i t : i < n -> marked n m G -> marked n (mark t m) ((i, n + t) :: G).
Proof.
  intros I M v H. rewrite mark_length in H. rewrite mark_nth, (M v H) by exact H.
  rewrite degree_cons. unfold meets. cbn [fst snd].
  destruct (Nat.eqb_spec t v), (Nat.eqb_spec i (n + v)), (Nat.eqb_spec (n + t) (n + v)); try lia; reflexivity.
Qed.
Lemma marked_degrees n m G H : (forall v, degree G v = degree H v) -> marked n m G -> marked n m H.
Proof. intros E M t L. now rewrite <- E, (M t L). Qed.
Lemma marked_inner n es : forall c m G, marked n m G ->
  marked n (mark_inner es c m) (solid (map (fun e => (n + fst e, n + snd e)) es) c ++ G).
Proof.
  induction es as [|e es IH]; intros [|[|] c] m G M; try exact M; cbn [mark_inner map solid app]; [|now apply IH].
  eapply marked_degrees, IH, marked_both, M. intros v. rewrite degree_app, !degree_cons, degree_app. lia.
Qed.
Lemma marked_owners n o : forall i s m G, i + length o <= n -> marked n m G ->
  marked n (mark_owners o s m) (solid (combine (seq i (length o)) (map (fun t => n + t) o)) s ++ G).
Proof.
  induction o as [|t o IH]; intros i [|[|] s] m G L M; try exact M; cbn [length] in L; cbn [mark_owners length seq map combine solid app];
    [|apply IH; [lia|exact M]].
  eapply marked_degrees; [|apply (IH (S i) s _ ((i, n + t) :: G)); [lia|apply marked_owner; [lia|exact M]]]. intros v. rewrite degree_app, !degree_cons, degree_app. lia.
Qed.
Lemma mark_inner_length es : forall c m, length (mark_inner es c m) = length m.
Proof. induction es as [|e es IH]; intros [|[|] c] m; try reflexivity; cbn [mark_inner]; rewrite IH; [|reflexivity]. unfold mark_both. now rewrite !mark_length. Qed.
Lemma mark_owners_length o : forall s m, length (mark_owners o s m) = length m.
Proof. induction o as [|t o IH]; intros [|[|] s] m; try reflexivity; cbn [mark_owners]; rewrite IH; [|reflexivity]. apply mark_length. Qed.
Lemma unmarked_count (f : nat -> bool) m : forall i, (forall t, t < length m -> nth t m false = negb (f (i + t))) ->
  unmarked m = length (filter f (seq i (length m))).
Proof.
  induction m as [|b m IH]; intros i H; [reflexivity|]. cbn [unmarked length seq filter].
  rewrite (IH (S i)) by (intros t L; rewrite Nat.add_succ_l, <- Nat.add_succ_r; apply (H (S t)); simpl; lia).
  pose proof (H 0 ltac:(simpl; lia)) as E. rewrite Nat.add_0_r in E. cbn [nth] in E. rewrite E. now destruct (f i).
Qed.
Theorem unmarked_isolated d s x : unmarked (mark_inner (inner d) x (mark_owners (owner d) s (no_marks d))) = isolated d s x.
Proof.
  unfold isolated. erewrite unmarked_count with (i := 0) (f := fun t => degree (drawing d s x) (length (owner d) + t) =? 0).
  - rewrite mark_inner_length, mark_owners_length. unfold no_marks. now rewrite repeat_length.
  - intros t L. cbn [Nat.add]. refine (marked_degrees _ _ _ _ _ (marked_inner _ _ x _ _ (marked_owners (length (owner d)) (owner d) 0 s _ [] (le_n _) _)) t L).
    + intros v. unfold drawing. rewrite app_nil_r, !degree_app. apply Nat.add_comm.
    + intros v H. unfold no_marks. rewrite nth_repeat. reflexivity.
Qed.
