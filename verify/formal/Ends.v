(** * The ends of two arcs: scores and labels of a ring *)
Require Import Arith Bool List NArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Entries Arcs Rings Header Kinds.

(** ** Scores of a ring *)
Definition nothing : score := (0, 0).
Definition ring_blank (f1 : frontier) (r1 ch : bool) (f2 : frontier) (r2 : bool) : option score := ring (f1, nothing) r1 ch (f2, nothing) r2.
Lemma add_plus b n m : add b (n + m) = n + add b m.
Proof. destruct b; simpl; lia. Qed.
Lemma ring_left_shift f v w r ch : ring_left (f, plus_score w v) r ch =
  option_map (fun l => (fst l, plus_score w (snd l))) (ring_left (f, v) r ch).
Proof.
  unfold ring_left. cbn [fst snd]. destruct (take (Next None) r f) as [g|]; [|reflexivity]. destruct (take Chord ch g) as [h|]; [|reflexivity].
  cbn [option_map fst snd]. unfold plus_score. cbn [fst snd]. rewrite !add_plus. f_equal. f_equal. f_equal. lia.
Qed.
Lemma ring_right_shift f v w q r : ring_right (f, plus_score w v) q r = option_map (plus_score w) (ring_right (f, v) q r).
Proof.
  unfold ring_right. cbn [fst snd]. destruct (merge f q) as [g|]; [|reflexivity]. destruct (take Chord r g) as [h|]; [|reflexivity].
  cbn [option_map]. unfold plus_score. cbn [fst snd]. rewrite add_plus. f_equal. f_equal. lia.
Qed.
Lemma plus_comm v w : plus_score v w = plus_score w v.
Proof. unfold plus_score. f_equal; lia. Qed.
Lemma plus_zero v : plus_score v nothing = v.
Proof. destruct v. unfold plus_score. cbn. f_equal; lia. Qed.
Lemma option_map_map {A B C} (f : B -> C) (g : A -> B) o : option_map f (option_map g o) = option_map (fun x => f (g x)) o.
Proof. now destruct o. Qed.
Lemma option_map_ext {A B} (f g : A -> B) o : (forall x, f x = g x) -> option_map f o = option_map g o.
Proof. intros E. destruct o; simpl; congruence. Qed.
Lemma ring_shift f1 v1 r1 ch f2 v2 r2 :
  ring (f1, v1) r1 ch (f2, v2) r2 = option_map (plus_score (plus_score v1 v2)) (ring_blank f1 r1 ch f2 r2).
Proof.
  unfold ring_blank, ring. cbn [fst snd]. rewrite <- (plus_zero v1) at 1. rewrite ring_left_shift.
  destruct (ring_left (f1, nothing) r1 ch) as [[f v]|]; [|reflexivity]. cbn [option_map fst snd].
  rewrite ring_right_shift, !option_map_map. apply option_map_ext. intros x. unfold plus_score. cbn. f_equal; lia.
Qed.

(** ** The labels at the ends of two arcs *)
Record ends := Ends { first1 : nat; last1 : nat; first2 : nat; last2 : nat }.
Definition some (n : nat) : bool := 0 <? n.
(** Which of them are equal, according to the kinds: two solid ports of a fan have the same label if they follow each other and the
    later one's bit is set. *)
Record equalities := Eq { f1l1 : bool; f2l2 : bool; f1f2 : bool; f1l2 : bool; l1f2 : bool; l1l2 : bool }.
Definition told (a b : info) : equalities :=
  let m := count a in let n := count b in let both := some m && some n in
  Eq ((m <=? 1) || ((m =? 2) && bit2 a) || ((n =? 0) && bit1 a))
     ((n <=? 1) || ((n =? 2) && bit2 b) || ((m =? 0) && bit1 b))
     (both && (((m =? 1) && bit1 b) || ((n =? 1) && bit1 a)))
     (both && (((m =? 1) && (n =? 1) && bit1 b) || bit1 a))
     (both && (bit1 b || ((m =? 1) && (n =? 1) && bit1 a)))
     (both && (((n =? 1) && bit1 b) || ((m =? 1) && bit1 a))).
Definition equalities_of (e : ends) : equalities :=
  Eq (first1 e =? last1 e) (first2 e =? last2 e) (first1 e =? first2 e) (first1 e =? last2 e) (last1 e =? first2 e) (last1 e =? last2 e).
Definition same_equalities (x y : equalities) : bool :=
  eqb (f1l1 x) (f1l1 y) && eqb (f2l2 x) (f2l2 y) && eqb (f1f2 x) (f1f2 y) && eqb (f1l2 x) (f1l2 y) && eqb (l1f2 x) (l1f2 y) && eqb (l1l2 x) (l1l2 y).
Definition small_labels (x : equalities) : ends :=
  let L1 := if f1l1 x then 0 else 1 in
  let F2 := if f1f2 x then 0 else if l1f2 x then L1 else 2 in
  let L2 := if f1l2 x then 0 else if l1l2 x then L1 else if f2l2 x then F2 else 3 in Ends 0 L1 F2 L2.
Definition pattern (a b : info) : option ends :=
  let e := small_labels (told a b) in if same_equalities (equalities_of e) (told a b) then Some e else None.

(** Any labels with the same equalities serve as well. *)
Definition large (e : ends) (l : nat) : nat :=
  match l with 0 => first1 e | 1 => last1 e | 2 => first2 e | _ => last2 e end.

Lemma paint_relabel h F L f : paint (h F) (h L) f = relabel h (paint F L f).
Proof. destruct f as [[d [l|]] [e [m|]] s]; reflexivity. Qed.
Lemma paint_labels F L f l : In l (labels_of (paint F L f)) -> l = F \/ l = L.
Proof.
  destruct f as [[d [x|]] [e [m|]] s]; unfold labels_of; cbn; intuition.
Qed.
Lemma tidy_labels f : incl (labels_of (tidy f)) (labels_of f).
Proof.
  unfold labels_of, tidy. cbn [anchor tip]. intros x I. apply in_app_or in I as [I|I]; apply in_or_app; [left|right]; revert I; apply tidy_place_labels.
Qed.
Lemma merge_relabel h f q : tells h (labels_of f ++ labels_of q) ->
  merge (relabel h f) (relabel h q) = option_map (relabel h) (merge f q).
Proof.
  intros T. unfold merge. cbn [anchor tip same relabel relabel_place deg port]. destruct (deg (anchor q) =? 0); [reflexivity|].
  change (open_end (relabel_place h (tip f))) with (open_end (tip f)). destruct (open_end (tip f)); [|reflexivity].
  destruct (same q).
  - cbn [option_map]. rewrite <- tidy_relabel. unfold relabel. cbn [anchor tip same]. destruct (same f); reflexivity.
  - rewrite (agree_relabel h _ _ _ T).
    + destruct (agree (port (tip f)) (port (anchor q))); [|reflexivity]. cbn [option_map]. rewrite <- tidy_relabel, either_relabel. unfold relabel.
      cbn [anchor tip same]. destruct (same f); reflexivity.
    + intros x I. unfold labels_of. rewrite !in_app_iff. auto.
    + intros x I. unfold labels_of. rewrite !in_app_iff. auto.
Qed.
Lemma merge_labels f q g : merge f q = Some g -> incl (labels_of g) (labels_of f ++ labels_of q).
Proof.
  unfold merge. destruct (deg (anchor q) =? 0).
  - intros E. injection E as <-. intros x. unfold labels_of. cbn [anchor tip]. rewrite !in_app_iff. tauto.
  - destruct (open_end (tip f)); [|discriminate]. destruct (same q).
    + intros E. injection E as <-. intros x I. apply tidy_labels in I. unfold labels_of in *. cbn [anchor tip port] in I. rewrite !in_app_iff in *.
      destruct (same f); cbn [port] in I; tauto.
    + destruct (agree _ _); [|discriminate]. intros E. injection E as <-. intros x I. apply tidy_labels in I. unfold labels_of in *. cbn [anchor tip port] in I.
      rewrite !in_app_iff in *. destruct I as [I|I]; [|tauto]. destruct (same f); cbn [port] in I; [|tauto]. apply either_incl in I. rewrite in_app_iff in I. tauto.
Qed.

Lemma ring_relabel h f1 v1 r1 ch f2 v2 r2 : tells h (labels_of f1 ++ labels_of f2) ->
  ring (relabel h f1, v1) r1 ch (relabel h f2, v2) r2 = ring (f1, v1) r1 ch (f2, v2) r2.
Proof.
  intros T. unfold ring, ring_left, ring_right. cbn [fst snd].
  pose proof (take_relabel h (Next None) r1 f1) as E1. cbn [relabel_step option_map] in E1. rewrite E1.
  2: { unfold step_labels. cbn. rewrite app_nil_r. intros x y X Y. apply T; apply in_or_app; now left. }
  destruct (take (Next None) r1 f1) as [fd|] eqn:Td; [|reflexivity]. cbn [option_map].
  pose proof (take_labels _ _ _ _ Td) as Id. unfold step_labels in Id. cbn in Id. rewrite app_nil_r in Id.
  pose proof (take_relabel h Chord ch fd) as E2. cbn [relabel_step] in E2. rewrite E2.
  2: { unfold step_labels. cbn. rewrite app_nil_r. intros x y X Y. apply T; apply in_or_app; left; now apply Id. }
  destruct (take Chord ch fd) as [fc|] eqn:Tc; [|reflexivity]. cbn [option_map fst snd].
  pose proof (take_labels _ _ _ _ Tc) as Ic. unfold step_labels in Ic. cbn in Ic. rewrite app_nil_r in Ic.
  assert (I1 : incl (labels_of fc) (labels_of f1)) by (intros x I; apply Id; now apply Ic).
  rewrite merge_relabel.
  2: { intros x y X Y. apply T; apply in_or_app; [apply in_app_or in X as [X|X]|apply in_app_or in Y as [Y|Y]]; auto. }
  destruct (merge fc f2) as [fm|] eqn:M; [|reflexivity]. cbn [option_map].
  pose proof (merge_labels _ _ _ M) as Im.
  pose proof (take_relabel h Chord r2 fm) as E3. cbn [relabel_step] in E3. rewrite E3.
  2: { unfold step_labels. cbn. rewrite app_nil_r.
       assert (W : incl (labels_of fm) (labels_of f1 ++ labels_of f2)).
       { intros x I. apply Im in I. apply in_app_or in I as [I|I]; apply in_or_app; auto. }
       intros x y X Y. apply T; now apply W. }
  destruct (take Chord r2 fm) as [fe|]; [|reflexivity]. cbn [option_map]. reflexivity.
Qed.

Definition ring_of (e : ends) (g1 : frontier * score) (r1 ch : bool) (g2 : frontier * score) (r2 : bool) : option score :=
  ring (paint (first1 e) (last1 e) (fst g1), snd g1) r1 ch (paint (first2 e) (last2 e) (fst g2), snd g2) r2.

Lemma ring_of_small e x g1 r1 ch g2 r2 : same_equalities (equalities_of e) x = true ->
  same_equalities (equalities_of (small_labels x)) x = true /\
  ring_of e g1 r1 ch g2 r2 = ring_of (small_labels x) g1 r1 ch g2 r2.
Proof.
  intros S. unfold same_equalities in S. rewrite !andb_true_iff, !eqb_true_iff in S. destruct S as [[[[[S1 S2] S3] S4] S5] S6].
  assert (Ex : x = equalities_of e) by (destruct x; unfold equalities_of in *; cbn in *; congruence). subst x. clear.
  destruct e as [a b c d]. unfold equalities_of at 1 2 3 4. cbn [first1 last1 first2 last2].
  set (h := large (Ends a b c d)).
  assert (Q : small_labels (Eq (a =? b) (c =? d) (a =? c) (a =? d) (b =? c) (b =? d)) = small_labels (equalities_of (Ends a b c d))) by reflexivity.
  unfold ring_of. cbn [first1 last1 first2 last2].
  assert (W : let s := small_labels (equalities_of (Ends a b c d)) in
     same_equalities (equalities_of s) (equalities_of (Ends a b c d)) = true /\ h (first1 s) = a /\ h (last1 s) = b /\ h (first2 s) = c /\ h (last2 s) = d /\
     tells h [first1 s; last1 s; first2 s; last2 s]).
  { unfold small_labels, equalities_of, h, large, same_equalities, tells. cbn.
    destruct (Nat.eqb_spec a b), (Nat.eqb_spec c d), (Nat.eqb_spec a c), (Nat.eqb_spec a d), (Nat.eqb_spec b c), (Nat.eqb_spec b d); subst; try congruence; cbn;
      (split; [reflexivity|]); repeat (split; [reflexivity|]); intros u v U V E; 
      repeat match goal with H : _ \/ _ |- _ => destruct H end; subst; try (cbn in E); try congruence; try contradiction. }
  cbn zeta in W. set (s := small_labels (equalities_of (Ends a b c d))) in *. destruct W as (W1 & Wa & Wb & Wc & Wd & Wt).
  split; [exact W1|]. rewrite <- Wa at 1. rewrite <- Wb at 1. rewrite <- Wc at 1. rewrite <- Wd at 1. rewrite !paint_relabel.
  fold s. apply ring_relabel. intros u v U V. apply Wt.
  - apply in_app_or in U as [U|U]; apply paint_labels in U as [-> | ->]; simpl; auto.
  - apply in_app_or in V as [V|V]; apply paint_labels in V as [-> | ->]; simpl; auto.
Qed.
