(** * Every meeting of two kinds, and every closing of one *)
Require Import Arith Bool List NArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Arcs Rings Header Kinds Ends Bounds.

Definition colors : list bool := [false; true].
Lemma in_colors b : In b colors.
Proof. destruct b; simpl; auto. Qed.

(** ** The best of many *)
Definition best_of (l : list score) : option score :=
  fold_right (fun v o => match o with Some w => Some (better v w) | None => Some v end) None l.
Lemma best_of_ok l v : In v l -> exists w, best_of l = Some w /\ is_good w v.
Proof.
  induction l as [|u l IH]; intros I; [destruct I|]. simpl. destruct I as [->|I].
  - destruct (best_of l) as [w|]; eexists; (split; [reflexivity|]); [apply better_left|apply is_good_refl].
  - destruct (IH I) as (w & -> & G). eexists. split; [reflexivity|]. eapply is_good_trans; [apply better_right|exact G].
Qed.
Definition gather (l : list (frontier * score)) : list place_entry := fold_left (fun acc x => insert (fst x) (snd x) tt acc) l [].
Lemma gather_ok l f v : In (f, v) l -> exists w, In (f, w, tt) (gather l) /\ is_good w v.
Proof.
  intros I. assert (C : covers (gather l) f v).
  { unfold gather. assert (K : forall m acc, covers acc f v -> covers (fold_left (fun acc x => insert (fst x) (snd x) tt acc) m acc) f v).
    { induction m as [|x m IH]; intros acc C; [exact C|]. apply IH. now apply insert_keeps. }
    assert (W : forall m acc, In (f, v) m -> covers (fold_left (fun acc x => insert (fst x) (snd x) tt acc) m acc) f v).
    { induction m as [|x m IH]; intros acc J; [destruct J|]. simpl. destruct J as [->|J]; [|now apply IH]. apply K, insert_covers. }
    now apply W. }
  destruct C as (w & [] & J & G). eauto.
Qed.
(** A function of books, tabulated for some of them. *)
Definition memo {A} (f : frontier -> A) (known : list (frontier * A)) (q : frontier) : A :=
  match find (fun x => same_frontier (fst x) q) known with Some x => snd x | None => f q end.
Lemma memo_ok {A} (f : frontier -> A) l q : memo f (map (fun x => (x, f x)) l) q = f q.
Proof.
  unfold memo. destruct (find _ _) as [x|] eqn:F; [|reflexivity]. apply find_some in F as [I E]. apply in_map_iff in I as (y & <- & _).
  cbn [fst snd] in *. apply same_frontier_eq in E. now subst.
Qed.

(** [forallb], but the first failure ends it. *)
Fixpoint every {A} (f : A -> bool) (l : list A) : bool := match l with [] => true | a :: r => if f a then every f r else false end.
Lemma every_in {A} (f : A -> bool) l : every f l = true -> forall a, In a l -> f a = true.
Proof.
  induction l as [|b l IH]; intros E a [].
  - subst. simpl in E. now destruct (f a).
  - simpl in E. destruct (f b); [now apply IH|discriminate].
Qed.

Section Meetings.
  Variable H : header.

  (** ** Two arcs *)
  Definition lefts (F L : nat) (K : kind) : list place_entry :=
    gather (flat_map (fun e => flat_map (fun r => flat_map (fun ch =>
      match ring_left (paint F L (fst (fst e)), snd (fst e)) r ch with Some x => [x] | None => [] end) colors) colors) (entries K)).
  Definition best_right (ls : list place_entry) (q : frontier) : option score :=
    best_of (flat_map (fun l => flat_map (fun r => match ring_right (fst l) q r with Some v => [v] | None => [] end) colors) ls).
  Definition beats (v : score) (w : option score) (u : score) : bool := match w with Some w => good v (plus_score u w) | None => true end.

  Lemma best_right_ok e K q2 v2 g v r1 ch r2 u : In (g, v, tt) (entries K) ->
    ring_of e (g, v) r1 ch (q2, v2) r2 = Some u ->
    exists w, best_right (lefts (first1 e) (last1 e) K) (paint (first2 e) (last2 e) q2) = Some w /\ is_good (plus_score v2 w) u.
  Proof.
    intros I R. unfold ring_of, ring in R. cbn [fst snd] in R.
    destruct (ring_left (paint (first1 e) (last1 e) g, v) r1 ch) as [[f s]|] eqn:Le; [|discriminate].
    destruct (ring_right (f, s) (paint (first2 e) (last2 e) q2) r2) as [x|] eqn:Ri; [|discriminate]. cbn [option_map] in R. injection R as <-.
    destruct (gather_ok (flat_map (fun e0 => flat_map (fun r => flat_map (fun ch =>
      match ring_left (paint (first1 e) (last1 e) (fst (fst e0)), snd (fst e0)) r ch with Some x => [x] | None => [] end) colors) colors) (entries K)) f s)
      as (s' & J & G).
    { apply in_flat_map. exists (g, v, tt). split; [exact I|]. apply in_flat_map. exists r1. split; [apply in_colors|].
      apply in_flat_map. exists ch. split; [apply in_colors|]. cbn [fst snd]. rewrite Le. now left. }
    assert (Ri' : exists x', ring_right (f, s') (paint (first2 e) (last2 e) q2) r2 = Some x' /\ is_good x' x).
    { rewrite <- (plus_zero s) in Ri. rewrite <- (plus_zero s'). rewrite ring_right_shift in Ri |- *.
      destruct (ring_right (f, nothing) (paint (first2 e) (last2 e) q2) r2) as [y|]; [|discriminate]. cbn [option_map] in *. injection Ri as <-.
      eexists. split; [reflexivity|]. rewrite !(plus_comm _ y). rewrite (plus_comm y s'), (plus_comm y s). now apply plus_good. }
    destruct Ri' as (x' & Ri' & G'). unfold best_right.
    destruct (best_of_ok (flat_map (fun l => flat_map (fun r => match ring_right (fst l) (paint (first2 e) (last2 e) q2) r with Some v => [v] | None => [] end) colors)
      (lefts (first1 e) (last1 e) K)) x') as (w & E & Gw).
    { apply in_flat_map. exists (f, s', tt). split; [exact J|]. apply in_flat_map. exists r2. split; [apply in_colors|]. cbn [fst]. rewrite Ri'. now left. }
    exists w. split; [exact E|]. rewrite !(plus_comm v2). apply plus_good. eapply is_good_trans; eassumption.
  Qed.

  Definition answer_of (e : ends) (K1 K2 : kind) : option score :=
    let '(e1, e2, ch) := meeting H (cl K1) (cl K2) in
    match nth (N.to_nat e1) (traced K1) None, nth (N.to_nat e2) (traced K2) None with
    | Some g1, Some g2 => ring_of e g1 (solid_link e1) ch g2 (solid_link e2)
    | _, _ => None
    end.
  Definition pair_ok (e : ends) (K1 : kind) (look : frontier -> option score) (K2 : kind) : bool :=
    match answer_of e K1 K2 with
    | Some v => forallb (fun x => beats v (look (fst (fst x))) (snd (fst x))) (entries K2)
    | None => false
    end.
  (** The kinds of second arcs, by what is known of their ports. *)
  Definition like (a b : info) : bool := (count a =? count b) && eqb (bit1 a) (bit1 b) && eqb (bit2 a) (bit2 b).
  Definition grouped (Ks : list kind) : list (info * list kind) :=
    fold_left (fun gs K =>
      if existsb (fun g => like (fst g) (about K)) gs
      then map (fun g : info * list kind => if like (fst g) (about K) then (fst g, K :: snd g) else g) gs
      else (about K, [K]) :: gs) Ks [].
  Definition known_books (Ks : list kind) : list frontier :=
    map (fun e => fst (fst e)) (gather (flat_map (fun K => map (fun e => (fst (fst e), (0, 0))) (entries K)) Ks)).
  (** Every kind is in the group of its ports. *)
  Definition all_grouped (Ks : list kind) (gs : list (info * list kind)) : bool :=
    forallb (fun K => existsb (fun g => like (fst g) (about K) && existsb (same_kind K) (snd g)) gs) Ks.
  Definition first_ok (gs : list (info * list kind)) (books : list frontier) (K1 : kind) : bool :=
    forallb (fun g : info * list kind =>
      match pattern (about K1) (fst g) with
      | None => true
      | Some e =>
          let ls := lefts (first1 e) (last1 e) K1 in
          let f := fun q => best_right ls (paint (first2 e) (last2 e) q) in
          let known := map (fun q => (q, f q)) books in
          forallb (pair_ok e K1 (memo f known)) (snd g)
      end) gs.
  Definition meetings_ok (Ks : list kind) : bool :=
    let gs := grouped Ks in let books := known_books Ks in
    all_grouped Ks gs && every (first_ok gs books) (filter rimless Ks).

  (** The header's answer to two arcs, and that none is better. *)
  Definition well_met (e : ends) (w1 w2 : list letter) : Prop :=
    let '(e1, e2, ch) := meeting H (arc_class H w1) (arc_class H w2) in
    exists g1 g2 v, arun w1 (trace H w1 e1) = Some g1 /\ arun w2 (trace H w2 e2) = Some g2 /\
      ring_of e g1 (solid_link e1) ch g2 (solid_link e2) = Some v /\
      forall c1 c2 h1 h2 r1 ch' r2 u, arun w1 c1 = Some h1 -> arun w2 c2 = Some h2 -> ring_of e h1 r1 ch' h2 r2 = Some u -> is_good v u.

  Lemma ring_of_shift e f1 v1 m1 r1 ch f2 v2 m2 r2 :
    ring_of e (f1, plus_score v1 m1) r1 ch (f2, plus_score v2 m2) r2 =
    option_map (plus_score (plus_score m1 m2)) (ring_of e (f1, v1) r1 ch (f2, v2) r2).
  Proof.
    unfold ring_of. cbn [fst snd]. rewrite !(ring_shift _ _ _ _ _ (_ : score)). rewrite option_map_map. apply option_map_ext. intros x. unfold plus_score. cbn. f_equal; lia.
  Qed.

  Lemma like_pattern a b c : like b c = true -> pattern a b = pattern a c.
  Proof.
    unfold like. rewrite !andb_true_iff, Nat.eqb_eq, !eqb_true_iff. intros [[E1 E2] E3]. unfold pattern, told. now rewrite E1, E2, E3.
  Qed.

  Theorem meetings_met R : closed H R = true -> meetings_ok (listed R) = true ->
    forall w1 w2 e, w1 <> [] -> w2 <> [] -> edges w1 = 0 -> edges w2 <= 1 ->
    same_equalities (equalities_of e) (told (info_of w1) (info_of w2)) = true -> well_met e w1 w2.
  Proof.
    intros C M w1 w2 e N1 N2 E1 E2 Sm. unfold meetings_ok in M. apply andb_prop in M as [Mg M].
    unfold all_grouped in Mg. rewrite forallb_forall in Mg. pose proof (every_in _ _ M) as M'. clear M. rename M' into M.
    destruct (every_kind H R C w1 N1 ltac:(lia)) as (K1 & m1 & I1 & (C1 & A1 & Co1 & T1)).
    destruct (every_kind H R C w2 N2 E2) as (K2 & m2 & I2 & (C2 & A2 & Co2 & T2)).
    assert (Rl : rimless K1 = true) by (unfold rimless; rewrite A1, rim_edges, E1; reflexivity).
    specialize (M K1 ltac:(apply filter_In; now split)). unfold first_ok in M. rewrite forallb_forall in M.
    specialize (Mg K2 I2). apply existsb_exists in Mg as (g & Ig & Q). apply andb_prop in Q as [Lk Q]. apply existsb_exists in Q as (K2' & J2 & Q).
    apply same_kind_eq in Q. subst K2'. specialize (M g Ig). rewrite (like_pattern _ _ _ Lk), A1, A2 in M.
    destruct (ring_of_small e _ (outer, nothing) false false (outer, nothing) false Sm) as [Sm' _]. unfold pattern in M. rewrite Sm' in M.
    set (e' := small_labels (told (info_of w1) (info_of w2))) in *. cbn zeta in M. rewrite forallb_forall in M. specialize (M K2 J2).
    unfold pair_ok, answer_of in M. rewrite C1, C2 in M. unfold well_met.
    destruct (meeting H (arc_class H w1) (arc_class H w2)) as [[e1 e2] ch].
    destruct (nth (N.to_nat e1) (traced K1) None) as [[q1 v1]|] eqn:Q1; [|discriminate].
    destruct (nth (N.to_nat e2) (traced K2) None) as [[q2 v2]|] eqn:Q2; [|discriminate].
    destruct (ring_of e' (q1, v1) (solid_link e1) ch (q2, v2) (solid_link e2)) as [v|] eqn:Rv; [|discriminate].
    apply T1 in Q1. apply T2 in Q2. rewrite forallb_forall in M.
    exists (q1, plus_score v1 m1), (q2, plus_score v2 m2), (plus_score (plus_score m1 m2) v).
    split; [exact Q1|]. split; [exact Q2|].
    assert (Sl : forall g1 r1 ch g2 r2, ring_of e g1 r1 ch g2 r2 = ring_of e' g1 r1 ch g2 r2) by (intros; now apply ring_of_small).
    split; [rewrite Sl, ring_of_shift, Rv; reflexivity|].
    intros c1 c2 [f1 u1] [f2 u2] r1 ch' r2 u X1 X2 Ru. rewrite Sl in Ru.
    destruct (Co1 c1 f1 u1 X1) as (w1' & J1 & G1). destruct (Co2 c2 f2 u2 X2) as (w2' & J2' & G2).
    assert (Rw : exists x, ring_of e' (f1, w1') r1 ch' (f2, w2') r2 = Some x /\ is_good (plus_score (plus_score m1 m2) x) u).
    { unfold ring_of in Ru |- *. cbn [fst snd] in Ru |- *. rewrite ring_shift in Ru |- *. destruct (ring_blank _ _ _ _ _) as [y|]; [|discriminate].
      cbn [option_map] in *. injection Ru as <-. eexists. split; [reflexivity|]. unfold is_good, plus_score in *. rewrite good_spec in *. cbn [fst snd] in *. lia. }
    destruct Rw as (x & Rx & Gx). destruct (best_right_ok e' K1 f2 w2' f1 w1' r1 ch' r2 x J1 Rx) as (w & Ew & Gw).
    specialize (M _ J2'). cbn [fst snd] in M. rewrite memo_ok, Ew in M. cbn [beats] in M.
    eapply is_good_trans; [|exact Gx]. rewrite !(plus_comm (plus_score m1 m2)). apply plus_good. eapply is_good_trans; [exact M|exact Gw].
  Qed.

  (** ** One arc *)
  Definition own_ends (a : info) : nat := if (count a <=? 1) || ((count a =? 2) && bit2 a) || bit1 a then 0 else 1.
  Definition close_of (F L : nat) (g : frontier * score) (r : bool) : option score := close (paint F L (fst g), snd g) r.
  Definition close_ok (K : kind) : bool :=
    let e := read (closed_case H) (cl K) in let L := own_ends (about K) in
    match nth (N.to_nat e) (traced K) None with
    | Some g =>
        match close_of 0 L g (solid_link e) with
        | Some v => forallb (fun x => forallb (fun r => match close_of 0 L (fst x) r with Some w => good v w | None => true end) colors) (entries K)
        | None => false
        end
    | None => false
    end.
  Definition path_ok (K : kind) : bool :=
    match nth 0 (traced K) None with
    | Some g => match path_end g with
                | Some v => forallb (fun x => match path_end (fst x) with Some w => good v w | None => true end) (entries K)
                | None => false
                end
    | None => false
    end.
  Definition closings_ok (Ks : list kind) : bool := every (fun K => close_ok K && path_ok K) (filter rimless Ks).

  Lemma close_shift F L f v m r : close_of F L (f, plus_score v m) r = option_map (plus_score m) (close_of F L (f, v) r).
  Proof.
    unfold close_of, close. destruct v as [n i]. unfold plus_score. cbn [fst snd]. destruct (_ =? _); [|reflexivity]. destruct r.
    - destruct (_ && _); [|reflexivity]. cbn. f_equal. f_equal; lia.
    - cbn. f_equal. f_equal; lia.
  Qed.
  Lemma path_shift f v m : path_end (f, plus_score v m) = option_map (plus_score m) (path_end (f, v)).
  Proof.
    unfold path_end. destruct v as [n i]. unfold plus_score. cbn [fst snd]. destruct (_ =? _); [|reflexivity]. cbn. f_equal. f_equal; lia.
  Qed.
  Lemma close_labels F L f v r : close_of F L (f, v) r = close_of 0 (if F =? L then 0 else 1) (f, v) r.
  Proof.
    unfold close_of, close. destruct v as [n i]. cbn [fst snd]. destruct f as [[d p] [d' p'] s]. unfold paint, paint_place. cbn [anchor tip same deg port].
    destruct (d =? _); [|reflexivity]. destruct r; [|reflexivity].
    assert (E : agree (option_map (fun _ => F) p) (option_map (fun _ => L) p') =
      agree (option_map (fun _ => 0) p) (option_map (fun _ => if F =? L then 0 else 1) p')).
    { destruct p, p'; try reflexivity. simpl. now destruct (F =? L). }
    rewrite E. reflexivity.
  Qed.

  Definition well_closed (F L : nat) (w : list letter) : Prop :=
    let e := read (closed_case H) (arc_class H w) in
    exists g v, arun w (trace H w e) = Some g /\ close_of F L g (solid_link e) = Some v /\
      forall c h r u, arun w c = Some h -> close_of F L h r = Some u -> is_good v u.
  Definition well_ended (w : list letter) : Prop :=
    exists g v, arun w (trace H w 0) = Some g /\ path_end g = Some v /\
      forall c h u, arun w c = Some h -> path_end h = Some u -> is_good v u.

  Theorem closings_closed R : closed H R = true -> closings_ok (listed R) = true ->
    forall w, w <> [] -> edges w = 0 ->
    (forall F L, (F =? L) = (own_ends (info_of w) =? 0) -> well_closed F L w) /\ well_ended w.
  Proof.
    intros C M w N E. destruct (every_kind H R C w N ltac:(lia)) as (K & m & I & (Cl & A & Co & T)).
    assert (Rl : rimless K = true) by (unfold rimless; rewrite A, rim_edges, E; reflexivity).
    unfold closings_ok in M. pose proof (every_in _ _ M) as M'. clear M. rename M' into M. specialize (M K ltac:(apply filter_In; now split)). apply andb_prop in M as [Mc Mp]. split.
    - intros F L EL. unfold close_ok in Mc. rewrite Cl, A in Mc. unfold well_closed. set (e := read (closed_case H) (arc_class H w)) in *.
      assert (Q : (if F =? L then 0 else 1) = own_ends (info_of w)).
      { rewrite EL. unfold own_ends. destruct (_ || _); reflexivity. }
      destruct (nth (N.to_nat e) (traced K) None) as [[f v]|] eqn:Q1; [|discriminate]. apply T in Q1.
      destruct (close_of 0 (own_ends (info_of w)) (f, v) (solid_link e)) as [u|] eqn:Cu; [|discriminate].
      rewrite <- Q, <- close_labels in Cu. exists (f, plus_score v m), (plus_score m u). split; [exact Q1|]. split; [now rewrite close_shift, Cu|].
      intros c [h hv] r x X Cx. destruct (Co c h hv X) as (y & J & G). rewrite forallb_forall in Mc. specialize (Mc _ J). rewrite forallb_forall in Mc.
      specialize (Mc r (in_colors r)). cbn [fst] in Mc. rewrite <- Q, <- close_labels in Mc.
      rewrite <- (plus_zero hv), (plus_comm hv), close_shift in Cx. rewrite <- (plus_zero y), (plus_comm y), close_shift in Mc.
      destruct (close_of F L (h, nothing) r) as [z|]; [|discriminate]. cbn [option_map] in *. injection Cx as <-.
      apply is_good_trans with (plus_score m (plus_score y z)).
      + rewrite !(plus_comm m). now apply plus_good.
      + unfold is_good, plus_score in *. rewrite good_spec in *. cbn [fst snd] in *. lia.
    - unfold path_ok in Mp. unfold well_ended. destruct (nth 0 (traced K) None) as [[f v]|] eqn:Q1; [|discriminate].
      apply (T 0%N) in Q1. destruct (path_end (f, v)) as [u|] eqn:Cu; [|discriminate].
      exists (f, plus_score v m), (plus_score m u). split; [exact Q1|]. split; [now rewrite path_shift, Cu|].
      intros c [h hv] x X Cx. destruct (Co c h hv X) as (y & J & G). rewrite forallb_forall in Mp. specialize (Mp _ J). cbn [fst] in Mp.
      rewrite <- (plus_zero hv), (plus_comm hv), path_shift in Cx. rewrite <- (plus_zero y), (plus_comm y), path_shift in Mp.
      destruct (path_end (h, nothing)) as [z|]; [|discriminate]. cbn [option_map] in *. injection Cx as <-.
      apply is_good_trans with (plus_score m (plus_score y z)).
      + rewrite !(plus_comm m). now apply plus_good.
      + unfold is_good, plus_score in *. rewrite good_spec in *. cbn [fst snd] in *. lia.
  Qed.

  (** Whether the header passes. *)
  Definition header_ok : bool :=
    let R := found H in
    if closed H R then if bounds_ok H (listed R) then if closings_ok (listed R) then meetings_ok (listed R) else false else false else false.
End Meetings.
