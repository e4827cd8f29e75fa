(** * What the entries of a class stand for *)
Require Import Arith Bool List Permutation ZArith Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Serves.

(** ** Other labels *)
Definition relabel_place (h : nat -> nat) (x : place) : place := Place (deg x) (option_map h (port x)).
Definition relabel (h : nat -> nat) (f : frontier) : frontier :=
  Frontier (relabel_place h (anchor f)) (relabel_place h (tip f)) (same f).
Definition relabel_step (h : nat -> nat) (s : step) : step :=
  match s with Put p => Put (option_map h p) | Next p => Next (option_map h p) | Mark p => Mark (option_map h p) | Chord => Chord end.
Definition label_list (p : option nat) : list nat := match p with Some l => [l] | None => [] end.
Definition labels_of (f : frontier) : list nat := label_list (port (anchor f)) ++ label_list (port (tip f)).
Definition step_labels (s : step) : list nat := label_list (label_of s).

(** [h] separates the labels in [ls]. *)
Definition tells (h : nat -> nat) (ls : list nat) : Prop := forall x y, In x ls -> In y ls -> h x = h y -> x = y.

Lemma agree_relabel h p q ls : tells h ls -> incl (label_list p) ls -> incl (label_list q) ls ->
  agree (option_map h p) (option_map h q) = agree p q.
Proof.
  intros T P Q. destruct p as [a|], q as [b|]; try reflexivity. simpl. destruct (Nat.eqb_spec a b) as [->|N]; [apply Nat.eqb_refl|].
  apply Nat.eqb_neq. intros E. apply N, T; auto; [apply P|apply Q]; now left.
Qed.
Lemma either_relabel h p q : either (option_map h p) (option_map h q) = option_map h (either p q).
Proof. now destruct p. Qed.
Lemma either_incl p q : incl (label_list (either p q)) (label_list p ++ label_list q).
Proof. destruct p; simpl; intros x I; auto. destruct I as [->|[]]. now left. Qed.
Lemma fresh_relabel h p : fresh (option_map h p) = relabel_place h (fresh p).
Proof. now destruct p. Qed.
Lemma tidy_relabel h f : tidy (relabel h f) = relabel h (tidy f).
Proof.
  unfold tidy, relabel. cbn [anchor tip same]. f_equal; unfold tidy_place, relabel_place, open_end; cbn [deg port];
    [destruct (deg (anchor f) <? 2)|destruct (deg (tip f) <? 2)]; reflexivity.
Qed.

Lemma take_relabel h s b f : tells h (labels_of f ++ step_labels s) ->
  take (relabel_step h s) b (relabel h f) = option_map (relabel h) (take s b f).
Proof.
  intros T. assert (Ia : incl (label_list (port (anchor f))) (labels_of f ++ step_labels s)) by (unfold labels_of; intros x I; rewrite !in_app_iff; tauto).
  assert (It : incl (label_list (port (tip f))) (labels_of f ++ step_labels s)) by (unfold labels_of; intros x I; rewrite !in_app_iff; tauto).
  destruct s as [p|p|p|]; destruct b; cbn [take relabel_step option_map]; try reflexivity; cbn [step_labels label_of] in *;
    try (assert (Ip : incl (label_list p) (labels_of f ++ label_list p)) by (intros x I; rewrite in_app_iff; tauto));
    cbn [relabel anchor tip same relabel_place port deg]; rewrite ?fresh_relabel; try reflexivity.
  - rewrite (agree_relabel h _ _ _ T It Ip). unfold open_end at 1. cbn [deg relabel_place]. fold (open_end (tip f)).
    destruct (open_end (tip f) && agree (port (tip f)) p); [|reflexivity]. cbn [option_map]. rewrite <- tidy_relabel. unfold relabel.
    cbn [anchor tip same]. rewrite either_relabel. f_equal. f_equal. f_equal; destruct (same f); reflexivity.
  - rewrite (agree_relabel h _ _ _ T It Ip). unfold open_end at 1. cbn [deg relabel_place]. fold (open_end (tip f)).
    destruct (open_end (tip f) && agree (port (tip f)) p); [|reflexivity]. cbn [option_map]. rewrite <- tidy_relabel. unfold relabel.
    cbn [anchor tip same]. rewrite either_relabel. reflexivity.
  - rewrite (agree_relabel h _ _ _ T Ia It). unfold open_end at 1 2. cbn [deg relabel_place]. fold (open_end (tip f)) (open_end (anchor f)).
    destruct (open_end (anchor f) && open_end (tip f) && negb (same f) && agree (port (anchor f)) (port (tip f))); [|reflexivity].
    cbn [option_map]. rewrite <- tidy_relabel. unfold relabel. cbn [anchor tip same]. rewrite either_relabel. reflexivity.
Qed.
Lemma left_alone_relabel h s b f : left_alone (relabel_step h s) b (relabel h f) = left_alone s b f.
Proof. now destruct s. Qed.
Lemma at_end_relabel h f : at_end (relabel h f) = at_end f.
Proof. reflexivity. Qed.

Lemma tidy_place_labels x : incl (label_list (port (tidy_place x))) (label_list (port x)).
Proof. unfold tidy_place. destruct (open_end x); [apply incl_refl|intros y []]. Qed.
Lemma fresh_labels p : label_list (port (fresh p)) = label_list p.
Proof. now rewrite fresh_port. Qed.
Lemma take_labels s b f g : take s b f = Some g -> incl (labels_of g) (labels_of f ++ step_labels s).
Proof.
  intros T x I. unfold labels_of, step_labels in *. rewrite !in_app_iff.
  assert (E : forall p q y, In y (label_list (either p q)) -> In y (label_list p) \/ In y (label_list q)).
  { intros p q y J. apply either_incl in J. now apply in_app_or. }
  assert (Y : forall z y, In y (label_list (port (tidy_place z))) -> In y (label_list (port z))) by (intros z; apply tidy_place_labels).
  destruct s as [p|p|p|]; destruct b; cbn [take label_of] in *; try discriminate;
    repeat match type of T with (if ?c then _ else _) = _ => destruct c; [|discriminate] end; injection T as <-;
    apply in_app_or in I as [I|I]; cbn [tidy anchor tip] in I; rewrite ?fresh_labels in I; try apply Y in I; cbn [more port] in I; auto;
    try (apply E in I; tauto).
  destruct (same f); cbn [port] in I; [apply E in I|]; tauto.
Qed.

Lemma relabel_ext h h' f : (forall l, In l (labels_of f) -> h l = h' l) -> relabel h f = relabel h' f.
Proof.
  intros E. unfold relabel, relabel_place, labels_of in *. destruct f as [[d p] [e q] s]. cbn [anchor tip same deg port] in *.
  destruct p as [l|], q as [m|]; cbn [option_map label_list app] in *; rewrite ?(E l), ?(E m) by (simpl; auto); reflexivity.
Qed.
Lemma relabel_comp h h' f : relabel h (relabel h' f) = relabel (fun l => h (h' l)) f.
Proof. destruct f as [[d [l|]] [e [m|]] s]; reflexivity. Qed.
Lemma labels_relabel h f : labels_of (relabel h f) = map h (labels_of f).
Proof. destruct f as [[d [l|]] [e [m|]] s]; reflexivity. Qed.

Lemma under_relabel h x y : under x y -> under (relabel_place h x) (relabel_place h y).
Proof. intros [A B]. split; [exact A|]. intros O. cbn [port relabel_place]. destruct (B O) as [->| ->]; auto. Qed.
Lemma serves_relabel h g f : serves g f -> serves (relabel h g) (relabel h f).
Proof.
  intros (A & T & S). split; [now apply under_relabel|]. split; [now apply under_relabel|]. cbn [anchor tip same relabel deg port relabel_place].
  intros Oa Ot. destruct (S Oa Ot) as [S1 S2]. split; [exact S1|]. intros E F. destruct (S2 E F) as [->| ->]; auto.
Qed.
Lemma slack_relabel h g f : slack (relabel h g) (relabel h f) = slack g f.
Proof. reflexivity. Qed.

(** ** What the entries of a class stand for

    [D] holds the scores less [tS], [tI], in other labels; it may lack what is served as well by another entry. *)
Definition scores := list (@entry unit).
Definition note (b : bool) (h : unit) : unit := h.
Definition as_good_on (g : frontier) (w : score) (f : frontier) (v : score) : Prop :=
  serves g f /\ (fst v < fst w \/ (fst v = fst w /\ snd w + slack g f <= snd v)).
Definition raised (tS tI : nat) (v : score) : score := (fst v + tS, snd v + tI).

Definition stands_for (A : list step) (D : scores) (h : nat -> nat) (tS tI : nat) : Prop :=
  (forall g w u, In (g, w, u) D -> exists c, play A c blank_frontier 0 0 = Some (relabel h g, raised tS tI w)) /\
  (forall c f v, play A c blank_frontier 0 0 = Some (f, v) ->
     exists g w u, In (g, w, u) D /\ as_good_on (relabel h g) (raised tS tI w) f v).

Definition all_labels (D : scores) : list nat := flat_map (fun e => labels_of (fst (fst e))) D.
Lemma in_all_labels D g w u l : In (g, w, u) D -> In l (labels_of g) -> In l (all_labels D).
Proof. intros I J. apply in_flat_map. now exists (g, w, u). Qed.

Lemma play_snoc A s c b : length c = length A -> play (A ++ [s]) (c ++ [b]) blank_frontier 0 0 =
  match play A c blank_frontier 0 0 with
  | Some (f, (n, i)) => match take s b f with Some g => Some (g, ((if b then S n else n), i + left_alone s b f)) | None => None end
  | None => None
  end.
Proof. intros L. rewrite play_app by exact L. destruct (play A c blank_frontier 0 0) as [[f [n i]]|]; [|reflexivity]. simpl. now destruct (take s b f). Qed.
Lemma play_snoc_inv A s c r : play (A ++ [s]) c blank_frontier 0 0 = Some r -> exists c' b, c = c' ++ [b] /\ length c' = length A.
Proof.
  intros P. pose proof (play_length _ _ _ _ _ _ P) as L. rewrite app_length, Nat.add_comm in L. simpl in L.
  destruct c as [|b c _] using rev_ind; [discriminate|]. exists c, b. rewrite app_length, Nat.add_comm in L. simpl in L. split; [reflexivity|lia].
Qed.

Lemma stands_extend A D h tS tI s : tells h (all_labels D ++ step_labels s) -> stands_for A D h tS tI ->
  stands_for (A ++ [relabel_step h s]) (extend note s D) h tS tI.
Proof.
  intros T [So Co].
  assert (Td : forall g w u, In (g, w, u) D -> tells h (labels_of g ++ step_labels s)).
  { intros g w u I x y X Y. apply T; apply in_or_app; [apply in_app_or in X as [X|X]|apply in_app_or in Y as [Y|Y]]; eauto using in_all_labels. }
  split.
  - intros g w u I. apply extend_stems in I as (f & n & i & u' & b & g' & I & K & E). injection E as -> -> _.
    destruct (So f (n, i) u' I) as (c & P). exists (c ++ [b]). rewrite play_snoc by exact (play_length _ _ _ _ _ _ P). rewrite P.
    cbn [raised fst snd]. rewrite take_relabel by eauto. rewrite K. cbn [option_map]. rewrite left_alone_relabel. unfold raised. cbn [fst snd].
    f_equal. f_equal. f_equal; [now destruct b|lia].
  - intros c f v P. destruct (play_snoc_inv _ _ _ _ P) as (c' & b & -> & L). rewrite play_snoc in P by exact L.
    destruct (play A c' blank_frontier 0 0) as [[f' [n i]]|] eqn:Q; [|discriminate].
    destruct (take (relabel_step h s) b f') as [f''|] eqn:K; [|discriminate]. injection P as <- <-.
    destruct (Co c' f' (n, i) Q) as (g & [wn wi] & u & I & V & G). destruct (take_serves _ _ _ _ _ V K) as (g' & K' & V' & Le).
    rewrite take_relabel in K' by eauto. destruct (take s b g) as [g''|] eqn:K''; [|discriminate]. injection K' as <-.
    destruct (extend_covers note s D g wn wi u b g'' I K'') as (w' & u' & J & G'). exists g'', w', u'. split; [exact J|].
    split; [exact V'|]. rewrite left_alone_relabel in Le. unfold is_good in G'. rewrite good_spec in G'. unfold raised in *. cbn [fst snd] in *.
    destruct b; lia.
Qed.
Lemma extend_labels s D l : In l (all_labels (extend note s D)) -> In l (all_labels D ++ step_labels s).
Proof.
  intros I. apply in_flat_map in I as ([[g w] u] & I & J). apply extend_stems in I as (f & n & i & u' & b & g' & I & K & E).
  injection E as -> _ _. cbn [fst] in J. apply (take_labels _ _ _ _ K) in J. apply in_app_or in J as [J|J]; apply in_or_app; eauto using in_all_labels.
Qed.

Lemma stands_extends ss : forall A D h tS tI, tells h (all_labels D ++ flat_map step_labels ss) -> stands_for A D h tS tI ->
  stands_for (A ++ map (relabel_step h) ss) (extends note ss D) h tS tI /\
  incl (all_labels (extends note ss D)) (all_labels D ++ flat_map step_labels ss).
Proof.
  induction ss as [|s ss IH]; intros A D h tS tI T St.
  - cbn [map extends fold_left flat_map]. rewrite app_nil_r. split; [exact St|]. apply incl_appl, incl_refl.
  - cbn [map flat_map] in *. change (extends note (s :: ss) D) with (extends note ss (extend note s D)).
    assert (Inc : incl (all_labels (extend note s D) ++ flat_map step_labels ss) (all_labels D ++ step_labels s ++ flat_map step_labels ss)).
    { intros l I. rewrite app_assoc. apply in_app_or in I as [I|I]; apply in_or_app; [left; now apply extend_labels|now right]. }
    destruct (IH (A ++ [relabel_step h s]) (extend note s D) h tS tI) as [IH1 IH2].
    + intros x y X Y. apply T; now apply Inc.
    + apply stands_extend; [|exact St]. intros x y X Y. apply T; rewrite app_assoc; apply in_or_app; now left.
    + rewrite <- app_assoc in IH1. split; [exact IH1|]. intros l I. now apply Inc, IH2.
Qed.

(** ** Leaving out what is served by another entry *)
Definition dominates (e d : @entry unit) : bool :=
  let '(g, w, _) := e in let '(f, v, _) := d in
  simulates g f && ((fst v <? fst w) || ((fst v =? fst w) && (snd w + slack g f <=? snd v))).
Fixpoint prune (kept D : scores) : scores :=
  match D with
  | [] => kept
  | d :: r => if existsb (fun e => dominates e d) kept then prune kept r
              else prune (d :: filter (fun e => negb (dominates d e)) kept) r
  end.

Definition Dominates (e d : @entry unit) : Prop :=
  let '(g, w, _) := e in let '(f, v, _) := d in as_good_on g w f v.
Lemma dominates_ok e d : dominates e d = true <-> Dominates e d.
Proof.
  destruct e as [[g w] u], d as [[f v] u']. unfold dominates, Dominates, as_good_on.
  rewrite andb_true_iff, simulates_ok, orb_true_iff, andb_true_iff, Nat.ltb_lt, Nat.eqb_eq, Nat.leb_le. tauto.
Qed.
Lemma as_good_trans e x g w f v : as_good_on e x g w -> as_good_on g w f v -> as_good_on e x f v.
Proof. intros [S G] [S' G']. split; [now apply serves_trans with g|]. pose proof (slack_trans e g f). lia. Qed.
Lemma as_good_refl g w : as_good_on g w g w.
Proof. split; [apply serves_refl|]. rewrite slack_refl. lia. Qed.
Lemma Dominates_refl e : Dominates e e.
Proof. destruct e as [[g w] u]. apply as_good_refl. Qed.
Lemma Dominates_trans a b c : Dominates a b -> Dominates b c -> Dominates a c.
Proof. destruct a as [[g w] u], b as [[f v] u'], c as [[f' v'] u'']. apply as_good_trans. Qed.

Lemma prune_incl D : forall kept, incl (prune kept D) (kept ++ D).
Proof.
  induction D as [|d D IH]; intros kept; [rewrite app_nil_r; apply incl_refl|]. simpl. destruct (existsb _ kept).
  - intros e I. apply IH in I. rewrite in_app_iff in *. simpl. tauto.
  - intros e I. apply IH in I. simpl in I. rewrite in_app_iff, filter_In in *. simpl. tauto.
Qed.
Lemma prune_covers D : forall kept d, In d (kept ++ D) -> exists e, In e (prune kept D) /\ Dominates e d.
Proof.
  induction D as [|x D IH]; intros kept d I; [rewrite app_nil_r in I; exists d; split; [exact I|apply Dominates_refl]|]. simpl.
  destruct (existsb (fun e => dominates e x) kept) eqn:E.
  - apply in_app_or in I as [I|[<-|I]]; try (apply IH; apply in_or_app; tauto).
    apply existsb_exists in E as (e & J & F). apply dominates_ok in F. destruct (IH kept e) as (e' & K & F'); [apply in_or_app; now left|].
    exists e'. split; [exact K|now apply Dominates_trans with e].
  - apply in_app_or in I as [I|[<-|I]].
    + destruct (dominates x d) eqn:F.
      * apply dominates_ok in F. destruct (IH (x :: filter (fun e => negb (dominates x e)) kept) x) as (e' & K & F'); [now left|].
        exists e'. split; [exact K|now apply Dominates_trans with x].
      * apply IH. right. apply in_or_app. left. apply filter_In. split; [exact I|]. now rewrite F.
    + apply IH. now left.
    + apply IH. right. apply in_or_app. now right.
Qed.
Lemma as_good_relabel h tS tI g w f v : as_good_on g w f v -> as_good_on (relabel h g) (raised tS tI w) (relabel h f) (raised tS tI v).
Proof. intros [S G]. split; [now apply serves_relabel|]. rewrite slack_relabel. unfold raised. cbn [fst snd]. lia. Qed.

(** A smaller list stands for the same when each entry that is left out is dominated. *)
Lemma stands_pruned A D h tS tI : stands_for A D h tS tI -> stands_for A (prune [] D) h tS tI.
Proof.
  intros [So Co]. split.
  - intros g w u I. apply prune_incl in I. now apply (So g w u).
  - intros c f v P. destruct (Co c f v P) as (g & w & u & I & G). destruct (prune_covers D [] (g, w, u) I) as ([[g' w'] u'] & J & F).
    exists g', w', u'. split; [exact J|]. eapply as_good_trans; [apply as_good_relabel, F|exact G].
Qed.

(** ** Other labels, smaller scores, another order *)
Fixpoint index (ls : list nat) (x : nat) : nat := match ls with [] => 0 | y :: r => if x =? y then 0 else S (index r x) end.
Lemma index_nth ls x : In x ls -> nth (index ls x) ls 0 = x.
Proof. induction ls as [|y ls IH]; intros I; [destruct I|]. simpl. destruct (Nat.eqb_spec x y) as [->|N]; [reflexivity|]. destruct I; [congruence|auto]. Qed.

Definition lowered (ls : list nat) (mS mI : nat) (e : @entry unit) : @entry unit :=
  let '(g, w, u) := e in (relabel (index ls) g, (fst w - mS, snd w - mI), u).
Lemma stands_lowered A D h tS tI ls mS mI : incl (all_labels D) ls -> (forall g w u, In (g, w, u) D -> mS <= fst w /\ mI <= snd w) ->
  stands_for A D h tS tI -> stands_for A (map (lowered ls mS mI) D) (fun l => h (nth l ls 0)) (tS + mS) (tI + mI).
Proof.
  intros Inc Low [So Co].
  assert (E : forall g w u, In (g, w, u) D -> relabel (fun l => h (nth l ls 0)) (relabel (index ls) g) = relabel h g /\
    raised (tS + mS) (tI + mI) (fst w - mS, snd w - mI) = raised tS tI w).
  { intros g w u I. split.
    - rewrite relabel_comp. apply relabel_ext. intros l J. f_equal. apply index_nth, Inc. eauto using in_all_labels.
    - destruct (Low g w u I). unfold raised. cbn [fst snd]. f_equal; lia. }
  split.
  - intros g w u I. apply in_map_iff in I as ([[g' w'] u'] & Q & I). injection Q as <- <- <-. destruct (E g' w' u' I) as [-> ->]. now apply So with u'.
  - intros c f v P. destruct (Co c f v P) as (g & w & u & I & G). exists (relabel (index ls) g), (fst w - mS, snd w - mI), u. split.
    + apply in_map_iff. exists (g, w, u). now split.
    + destruct (E g w u I) as [-> ->]. exact G.
Qed.
Lemma stands_same A D D' h tS tI : (forall e, In e D <-> In e D') -> stands_for A D h tS tI -> stands_for A D' h tS tI.
Proof.
  intros E [So Co]. split.
  - intros g w u I. apply (So g w u). now apply E.
  - intros c f v P. destruct (Co c f v P) as (g & w & u & I & G). exists g, w, u. split; [now apply E|exact G].
Qed.
