(** * The header's answers to one and to two arcs *)
Require Import Arith Bool List NArith Permutation Lia.
Import ListNotations.
Require Import Statements Strips Locality Drawing Checker Rows Symmetry Frontier Fold Route EveryFan Entries.
Require Import Arcs Rings Closings Header Kinds Ends Meetings Played Keys.

(** ** From arcs with labels to letters *)
Lemma paint_unseen F L F' L' f : port (anchor f) = None -> port (tip f) = None -> paint F L f = paint F' L' f.
Proof. destruct f as [[d p] [e q] r]. cbn. intros -> ->. reflexivity. Qed.

(** The labels that an arc of letters is painted with. *)
Definition shown (w : list labelled) (F L : nat) : Prop :=
  match order w with [] => True | x :: _ => F = snd x /\ L = label (last_label w) end.
Lemma run_shown w F L c : fitting w -> shown w F L ->
  run (map real w) c = option_map (fun r => (paint F L (fst r), snd r)) (arun (map fst w) c).
Proof.
  intros Fit Sh. destruct (run_painted w Fit c) as [E W]. rewrite E. destruct (arun (map fst w) c) as [[f v]|]; [|reflexivity]. cbn [option_map].
  unfold painted. cbn [fst snd]. f_equal. f_equal. destruct (W f v eq_refl) as [(Za & Zt & Na & Nt & _) _].
  unfold shown in Sh. destruct (order w) as [|x S] eqn:O.
  - apply paint_unseen; [apply Na|apply Nt].
    + unfold first_label. fold (order w). now rewrite O.
    + apply first_none_near. unfold first_label. fold (order w). now rewrite O.
  - destruct Sh as [-> ->]. unfold first_label. fold (order w). now rewrite O.
Qed.

Definition ring_of_arcs (e : ends) (w1 w2 : list letter) (c1 : coloring) (r1 ch : bool) (c2 : coloring) (r2 : bool) : option score :=
  obind (arun w1 c1) (fun h1 => obind (arun w2 c2) (fun h2 => ring_of e h1 r1 ch h2 r2)).
Lemma ring_shown w1 w2 c1 r1 ch c2 r2 : fitting w1 -> fitting w2 ->
  ring_run (map real w1) (map real w2) c1 r1 ch c2 r2 =
  ring_of_arcs (ends_of (order w1) (order w2)) (map fst w1) (map fst w2) c1 r1 ch c2 r2.
Proof.
  intros F1 F2. set (e := ends_of (order w1) (order w2)).
  assert (L : forall w z, order w <> [] -> last (map snd (order w)) z = label (last_label w)).
  { intros w z N. rewrite last_order. destruct (@exists_last _ (order w) N) as (m & y & E). rewrite E, map_app, rev_app_distr. cbn. apply last_snoc. }
  assert (S1 : shown w1 (first1 e) (last1 e)).
  { unfold shown. pose proof (L w1 (S (list_max (map snd (order w1 ++ order w2))))) as Lw. unfold e, ends_of. cbn [first1 last1].
    destruct (order w1) as [|x S]; [exact I|]. split; [reflexivity|]. apply Lw. discriminate. }
  assert (S2 : shown w2 (first2 e) (last2 e)).
  { unfold shown. pose proof (L w2 (S (S (list_max (map snd (order w1 ++ order w2)))))) as Lw. unfold e, ends_of. cbn [first2 last2].
    destruct (order w2) as [|x S]; [exact I|]. split; [reflexivity|]. apply Lw. discriminate. }
  unfold ring_run, ring_of_arcs. rewrite (run_shown w1 _ _ c1 F1 S1), (run_shown w2 _ _ c2 F2 S2).
  destruct (arun (map fst w1) c1) as [h1|]; [|reflexivity]. cbn [option_map obind]. destruct (arun (map fst w2) c2) as [h2|]; reflexivity.
Qed.

Section Checked.
  Variable H : header.
  Variable R : kinds.
  Hypotheses (finite : closed H R = true) (meet : meetings_ok H (listed R) = true) (shut : closings_ok H (listed R) = true).

  Theorem ring_best w1 w2 : fitting w1 -> fitting w2 -> w1 <> [] -> w2 <> [] -> edges (map fst w1) = 0 -> edges (map fst w2) <= 1 ->
    in_a_round (order w1 ++ order w2) ->
    let '(e1, e2, ch) := meeting H (arc_class H (map fst w1)) (arc_class H (map fst w2)) in
    exists v, ring_run (map real w1) (map real w2) (trace H (map fst w1) e1) (solid_link e1) ch (trace H (map fst w2) e2) (solid_link e2) = Some v /\
      forall c1 r1 ch' c2 r2 u, ring_run (map real w1) (map real w2) c1 r1 ch' c2 r2 = Some u -> is_good v u.
  Proof.
    intros F1 F2 N1 N2 E1 E2 C. pose proof (told_right w1 w2 C) as T.
    assert (M1 : map fst w1 <> []) by (now destruct w1). assert (M2 : map fst w2 <> []) by (now destruct w2).
    pose proof (meetings_met H R finite meet (map fst w1) (map fst w2) (ends_of (order w1) (order w2)) M1 M2 E1 E2 T) as M. unfold well_met in M.
    destruct (meeting H (arc_class H (map fst w1)) (arc_class H (map fst w2))) as [[e1 e2] ch].
    destruct M as (g1 & g2 & v & A1 & A2 & Rv & B). exists v. split.
    - rewrite ring_shown by assumption. unfold ring_of_arcs. now rewrite A1, A2.
    - intros c1 r1 ch' c2 r2 u Ru. rewrite ring_shown in Ru by assumption. unfold ring_of_arcs in Ru.
      destruct (arun (map fst w1) c1) as [h1|] eqn:X1; [|discriminate]. destruct (arun (map fst w2) c2) as [h2|] eqn:X2; [|discriminate].
      exact (B c1 c2 h1 h2 r1 ch' r2 u X1 X2 Ru).
  Qed.

  (** One arc that is closed to a ring. *)
  Definition own_round (w : list labelled) : Prop :=
    match order w with [] => True | x :: _ => (snd x =? label (last_label w)) = (own_ends (info_of (map fst w)) =? 0) end.
  Theorem close_best w : fitting w -> w <> [] -> edges (map fst w) = 0 -> own_round w ->
    let e := read (closed_case H) (arc_class H (map fst w)) in
    exists g v, run (map real w) (trace H (map fst w) e) = Some g /\ close g (solid_link e) = Some v /\
      forall c h r u, run (map real w) c = Some h -> close h r = Some u -> is_good v u.
  Proof.
    intros Fit N E O. cbn zeta. set (e := read (closed_case H) (arc_class H (map fst w))).
    assert (M : map fst w <> []) by (now destruct w).
    assert (W : exists F L, shown w F L /\ (F =? L) = (own_ends (info_of (map fst w)) =? 0)).
    { unfold shown, own_round in *. destruct (order w) as [|x S] eqn:Ow.
      - exists 0, 0. split; [exact I|]. unfold own_ends. pose proof (info_order w) as (-> & -> & ->). rewrite Ow. reflexivity.
      - exists (snd x), (label (last_label w)). auto. }
    destruct W as (F & L & Sh & EL). destruct (closings_closed H R finite shut (map fst w) M E) as [C _].
    destruct (C F L EL) as (g & v & A & Cv & B). fold e in A, Cv. exists (paint F L (fst g), snd g), v.
    split; [rewrite (run_shown w F L _ Fit Sh), A; reflexivity|]. split; [exact Cv|].
    intros c h r u X Cu. rewrite (run_shown w F L _ Fit Sh) in X. destruct (arun (map fst w) c) as [h'|] eqn:Xa; [|discriminate].
    injection X as <-. exact (B c h' r u Xa Cu).
  Qed.
  Theorem path_best w : fitting w -> w <> [] -> edges (map fst w) = 0 ->
    exists g v, run (map real w) (trace H (map fst w) 0) = Some g /\ path_end g = Some v /\
      forall c h u, run (map real w) c = Some h -> path_end h = Some u -> is_good v u.
  Proof.
    intros Fit N E. assert (M : map fst w <> []) by (now destruct w). destruct (closings_closed H R finite shut (map fst w) M E) as [_ C].
    destruct C as (g & v & A & Pv & B).
    assert (Pe : forall F L h, path_end (paint F L (fst h), snd h) = path_end h).
    { intros F L [f [n i]]. reflexivity. }
    pose proof (fun c => proj1 (run_painted w Fit c)) as Rp. exists (painted w g), v. split; [rewrite Rp, A; reflexivity|].
    split; [unfold painted; rewrite Pe; exact Pv|]. intros c h u X Pu. rewrite Rp in X. destruct (arun (map fst w) c) as [h'|] eqn:Xa; [|discriminate].
    injection X as <-. unfold painted in Pu. rewrite Pe in Pu. exact (B c h' u Xa Pu).
  Qed.
End Checked.

(** ** Steps of a route are the steps of its arcs *)
Section Stretches.
  Variables (k : nat) (s J : coloring) (lab : nat -> nat).
  (** Triangles outside the fan have no port. *)
  Definition mark_any (t : nat) : labelled := if t <? k then mark_of s J lab t else (Plain, 0).
  Lemma real_mark t : real (mark_any t) = Tri (port_of k s lab t).
  Proof.
    unfold mark_any, port_of, mark_of, real, letter_at. destruct (t <? k); [|reflexivity]. cbn [fst snd andb].
    destruct (nth t s false); [|reflexivity]. now destruct (nth t J false).
  Qed.
  Lemma stretch_any i n : i + n <= k -> stretch s J lab i n = rev (map mark_any (seq i n)).
  Proof.
    intros H. unfold stretch. f_equal. apply map_ext_in. intros t I. apply in_seq in I. unfold mark_any. destruct (Nat.ltb_spec t k); [reflexivity|lia].
  Qed.
  Lemma steps_next l : steps false (map real (rev (map mark_any l))) = map (step_of k s lab) (map (pair next) l).
  Proof.
    induction l as [|t l IH] using rev_ind; [reflexivity|]. rewrite map_app, rev_app_distr. cbn [map rev app steps andb]. rewrite IH, !map_app.
    rewrite real_mark. reflexivity.
  Qed.
  Lemma steps_mark x l : steps true (map real (rev (map mark_any (x :: l)))) =
    Mark (port_of k s lab x) :: map (step_of k s lab) (map (pair next) l).
  Proof.
    induction l as [|t l IH] using rev_ind.
    - cbn. now rewrite real_mark.
    - rewrite app_comm_cons, map_app, rev_app_distr. cbn [map rev app steps]. cbn [map rev app] in IH. rewrite IH, !map_app.
      rewrite real_mark. match goal with |- context [null ?z] => assert (Q : null z = false) by (destruct (rev (map mark_any l)); reflexivity) end.
      rewrite Q. reflexivity.
  Qed.
  Lemma any_no_rim l : no_rim (map real (rev (map mark_any l))).
  Proof.
    intros I. apply in_map_iff in I as (x & E & I). apply in_rev in I. apply in_map_iff in I as (t & <- & _). rewrite real_mark in E. discriminate.
  Qed.
  Lemma any_edges l : edges (map fst (rev (map mark_any l))) = 0.
  Proof.
    assert (W : forall w : list labelled, (forall x, In x w -> fst x <> Edge) -> edges (map fst w) = 0).
    { induction w as [|[l0 x] w IH]; intros N; [reflexivity|]. pose proof (N _ (or_introl eq_refl)) as N0. cbn in *. destruct l0; auto; contradiction. }
    apply W. intros x I. apply in_rev in I. apply in_map_iff in I as (t & <- & _). unfold mark_any, mark_of, letter_at.
    destruct (t <? k); [|discriminate]. cbn [fst]. destruct (nth t s false), (nth t J false); discriminate.
  Qed.
End Stretches.

(** ** A colouring that is played best is best *)
Definition plays (p : patch) (s : coloring) (lab : nat -> nat) (x : coloring) (o : option score) : Prop :=
  match o with
  | Some v => allowed (ports p) lab (drawing (after p) s x) /\ fst v = solids x /\ snd v = isolated (after p) s x
  | None => ~ allowed (ports p) lab (drawing (after p) s x)
  end.
Lemma total_plays p s lab x o o' : total o = two_more o' ->
  match o with
  | Some (f, (n, i)) => allowed (ports p) lab (drawing (after p) s x) /\ n = solids x /\ i + at_end f = isolated (after p) s x + 2
  | None => ~ allowed (ports p) lab (drawing (after p) s x)
  end -> plays p s lab x o'.
Proof.
  intros E P. unfold plays. destruct o as [[f [n i]]|], o' as [[n' i']|]; try discriminate; [|exact P]. cbn [total two_more option_map fst snd] in E. injection E as -> E. cbn [fst snd].
  destruct P as (A & B & C). split; [exact A|]. split; [exact B|lia].
Qed.
Theorem played_best p s c st x v :
  describes (size (before p)) st (drawing (before p) s c) -> length x = length (inner (after p)) -> plays p s (label_in st) x (Some v) ->
  (forall y, length y = length (inner (after p)) -> exists o, plays p s (label_in st) y o /\ forall u, o = Some u -> is_good v u) -> best p s c x.
Proof.
  intros D Lx (A & En & Ei) B. split; [now apply (allowed_legal p st)|].
  intros y Ly. pose proof Ly as (Lly & _). apply (allowed_legal p st s c y D Lly) in Ly. destruct (B y Lly) as (o & Py & Bo).
  destruct o as [u|]; [|contradiction]. destruct Py as (_ & En' & Ei'). specialize (Bo u eq_refl). unfold is_good in Bo. rewrite good_spec in Bo.
  unfold as_good. lia.
Qed.

(** What is to be shown of a family: for every key the walk gives a best recolouring. *)
Definition right_walk (p : patch) (round : bool) (walk : coloring -> coloring -> coloring) : Prop :=
  well_formed_side p (before p) = true /\ well_formed_side p (after p) = true /\
  forall s c st J, length s = ports p -> length c = length (inner (before p)) -> describes (size (before p)) st (drawing (before p) s c) ->
    valid (drawing (before p) s c) -> tells_labels round (ports p) s J (label_in st) -> best p s c (walk s J).

(** The answer is a function of the key; as a table it is correct. *)
Lemma served p round walk clean : right_walk p round walk ->
  (forall s J lab, length s = ports p -> tells_labels round (ports p) s J lab -> tells_labels round (ports p) s (clean s J) lab) ->
  serves_keys p round (fun s J => walk s (clean s J)).
Proof.
  intros (W0 & W1 & B) Cl.
  set (T := (fun s c => match drawn (before p) s c with
     | Some st => Some (walk s (clean s (joined_of round s (labels (ports p) st)))) | None => None end) : table).
  assert (C : correct p T).
  { intros s c Ls Lc. unfold T. pose proof (drawn_ok p (before p) s c W0) as D. destruct (drawn (before p) s c) as [st|]; [|tauto].
    destruct D as [D V]. split; [intros _|contradiction]. eexists. split; [reflexivity|]. apply (B s c st); auto. apply Cl; [exact Ls|].
    apply (joined_tells p round s c); auto; [now apply joined_of_ok|]. intros i j Hi Hj. apply D; unfold size, ports in *; lia. }
  exists T. split; [exact C|]. split; [now apply correct_safe; [apply well_formed_sensible|apply well_formed_sensible|]|].
  intros s c Ls Lc V. pose proof (drawn_ok p (before p) s c W0) as D. unfold T. destruct (drawn (before p) s c) as [st|]; [|contradiction].
  exists (joined_of round s (labels (ports p) st)). split; [|reflexivity]. apply joined_of_ok; [exact Ls|apply D].
Qed.

(** Cleaning a key changes nothing. *)
Lemma nth_built (f : nat -> bool) k i : i < k -> nth i (map f (seq 0 k)) false = f i.
Proof. intros H. rewrite (nth_indep _ false (f 0)) by (rewrite map_length, seq_length; exact H). now rewrite map_nth, seq_nth. Qed.
Lemma solids_counted s : length (filter id s) = length (filter (fun t => nth t s false) (seq 0 (length s))).
Proof.
  rewrite <- (nth_all s false) at 1. generalize (seq 0 (length s)). intros l. induction l as [|t l IH]; [reflexivity|]. simpl. unfold id at 1.
  destruct (nth t s false); simpl; now rewrite IH.
Qed.
Lemma only_two s t u m : length (filter id s) = 2 -> t < u < length s -> nth t s false = true -> nth u s false = true ->
  m < length s -> nth m s false = true -> m = t \/ m = u.
Proof.
  intros L H St Su Hm Sm. destruct (Nat.eq_dec m t) as [|Nt]; [now left|]. destruct (Nat.eq_dec m u) as [|Nu]; [now right|]. exfalso.
  rewrite solids_counted in L. assert (Nd : NoDup [t; u; m]) by (repeat constructor; simpl; intuition lia).
  apply (NoDup_incl_length (l' := filter (fun t => nth t s false) (seq 0 (length s)))) in Nd; [simpl in Nd; lia|].
  intros x I. apply filter_In. rewrite in_seq. destruct I as [<-|[<-|[<-|[]]]]; (split; [lia|assumption]).
Qed.
Lemma closed_clean k s J lab : length s = k -> tells_labels true k s J lab -> tells_labels true k s (of_closed s J) lab.
Proof.
  intros Ls T. unfold of_closed. rewrite Ls. destruct ((length (filter id s) =? 2) && existsb id (map (fun i => nth i s false && nth i J false) (seq 0 k))) eqn:Q.
  - apply andb_prop in Q as [Q1 Q2]. apply Nat.eqb_eq in Q1. apply existsb_exists in Q2 as (b & I & E). unfold id in E. subst b.
    apply in_map_iff in I as (i & E & I). apply in_seq in I. apply andb_prop in E as [Si Ji].
    assert (Both : forall t u, t < u < k -> nth t s false = true -> nth u s false = true -> lab t = lab u).
    { intros t u H St Su. assert (Two : forall m, m < k -> nth m s false = true -> m = t \/ m = u) by (intros m Hm; apply only_two; auto; lia).
      destruct (Two i ltac:(lia) Si) as [->| ->].
      - apply (by_last _ _ _ _ _ T eq_refl t u H St Su); [|exact Ji]. intros m Hm O. destruct (nth m s false) eqn:Sm; [|reflexivity]. destruct (Two m Hm Sm); lia.
      - apply (by_predecessor _ _ _ _ _ T t u H St Su); [|exact Ji]. intros m Hm. destruct (nth m s false) eqn:Sm; [|reflexivity]. destruct (Two m ltac:(lia) Sm); lia. }
    split.
    + intros t u H St Su _. rewrite Su. split; [intros _; now apply Both|reflexivity].
    + intros _ t u H St Su _. rewrite St. split; [intros _; now apply Both|reflexivity].
    + intros t H [O|O] _; [discriminate|]. destruct (nth t s false) eqn:St; [exfalso|reflexivity]. rewrite solids_counted, Ls in Q1.
      assert (Nd : NoDup (filter (fun t => nth t s false) (seq 0 k))) by (apply NoDup_filter, seq_NoDup).
      apply (NoDup_incl_length (l' := [t])) in Nd; [simpl in Nd; lia|]. intros x X. apply filter_In in X as [X1 X2]. apply in_seq in X1.
      destruct (Nat.eq_dec x t) as [->|N]; [now left|]. rewrite O in X2 by (auto; lia). discriminate.
  - clear Q. destruct T as [T1 T2 T3]. split.
    + intros t u H St Su N. rewrite nth_built, Su by lia. now apply T1.
    + intros R t u H St Su N. rewrite nth_built, St by lia. now apply T2.
    + intros t H O N. rewrite nth_built, (T3 t H O N) by lia. apply andb_false_r.
Qed.
Lemma open_clean k s J lab : length s = k -> tells_labels false k s J lab -> tells_labels false k s (of_open s J) lab.
Proof.
  intros Ls [T1 T2 T3]. unfold of_open. rewrite Ls. split.
  - intros t u H St Su N. rewrite nth_built, Su by lia.
    assert (Q : existsb (fun m => nth m s false) (seq 0 u) = true) by (apply existsb_exists; exists t; split; [apply in_seq; lia|exact St]).
    rewrite Q, andb_true_r. now apply T1.
  - discriminate.
  - intros t H O N. rewrite nth_built, (T3 t H O N) by lia. now rewrite andb_false_r.
Qed.
