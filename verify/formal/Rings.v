(** * Arcs in a ring

    What drawing an arc does to the rest of a patch is known from the books of the arc alone: this is the interface lemma of
    docs/explanation/automaton.md, on the books of [Frontier.v]. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Arcs.

Definition plus_score (v w : score) : score := (fst v + fst w, snd v + snd w).

(** ** An arc drawn from books that are not blank *)

(** The books [f], and then an arc whose own books are [q]: the vertex at which the arc begins is the tip of [f]. *)
Definition merge (f q : frontier) : option frontier :=
  if deg (anchor q) =? 0 then Some (Frontier (anchor f) (tip q) false)
  else if open_end (tip f) then
    if same q then
      Some (tidy (Frontier (if same f then Place (deg (anchor f)) (port (tip f)) else anchor f)
        (Place (deg (tip q)) (port (tip f))) (same f)))
    else if agree (port (tip f)) (port (anchor q)) then
      Some (tidy (Frontier (if same f then Place (deg (anchor f)) (either (port (tip f)) (port (anchor q))) else anchor f) (tip q) false))
    else None
  else None.

Definition room (x : place) : Prop := deg x <= 2 /\ (deg x = 2 -> port x = None).
Definition sane (f : frontier) : Prop := room (anchor f) /\ room (tip f) /\ (same f = true -> deg (anchor f) < 2 /\ deg (tip f) < 2).
Definition sane_arc (q : frontier) : Prop :=
  room (tip q) /\ deg (anchor q) <= 1 /\ (same q = true -> deg (anchor q) = 1 /\ deg (tip q) < 2 /\ port (anchor q) = None /\ port (tip q) = None).

Lemma room_cases x : room x -> (deg x = 0 \/ deg x = 1 \/ (deg x = 2 /\ x = Place 2 None)).
Proof. destruct x as [d p]. unfold room. cbn. intros [H E]. assert (d = 0 \/ d = 1 \/ d = 2) as [->|[->| ->]] by lia; auto. rewrite E; auto. Qed.

Lemma outer_sane : sane_arc outer.
Proof. unfold sane_arc, room. cbn. repeat split; try lia; try discriminate. Qed.

Lemma tidy_room x : deg x <= 2 -> room (tidy_place x).
Proof.
  intros H. unfold room, tidy_place, open_end. destruct (Nat.ltb_spec (deg x) 2); cbn; split; auto; lia.
Qed.
Lemma fresh_more p l : deg (more (fresh p) l) <= 2.
Proof. destruct p; cbn; lia. Qed.
Lemma fresh_sane p : room (fresh p).
Proof. unfold room. destruct p; cbn; split; auto; lia. Qed.
Lemma take_sane s b f g : sane f -> take s b f = Some g -> sane g.
Proof.
  intros (A & T & S) E. unfold sane.
  assert (Tidy : forall x y sm, deg x <= 2 -> deg y <= 2 -> sane (tidy (Frontier x y sm))).
  { intros x y sm Hx Hy. unfold sane, tidy. cbn [anchor tip same]. split; [now apply tidy_room|]. split; [now apply tidy_room|].
    rewrite !andb_true_iff, !tidy_deg. unfold open_end. rewrite !Nat.ltb_lt. tauto. }
  assert (Plain_ : forall x p, room x -> sane (Frontier x (fresh p) false)).
  { intros x p H. unfold sane. cbn. split; [exact H|]. split; [apply fresh_sane|discriminate]. }
  fold (sane g). unfold room in A, T.
  destruct s as [p|p|p|], b; cbn [take] in E; try discriminate;
    try (match type of E with (if ?c then _ else _) = _ => destruct c eqn:Q; [|discriminate] end); injection E as <-; auto using Plain_;
    try (now split); try (apply Tidy); rewrite ?andb_true_iff in Q; unfold open_end in Q; rewrite ?Nat.ltb_lt in Q;
    try (destruct (same f)); cbn [deg more]; try (pose proof (fresh_room p)); lia.
Qed.
Lemma enter_sane first it b q g : sane_arc q -> (first = true -> q = outer) -> enter first it b q = Some g -> sane_arc g.
Proof.
  intros (T & A & S) O E. destruct q as [[da pa] [dt pt] sm]. unfold sane_arc, room in *. cbn [anchor tip same deg port] in *.
  destruct first.
  - injection (O eq_refl) as -> -> -> -> ->. destruct it as [[l|]|], b; cbn in E; try discriminate; injection E as <-; cbn; repeat split; intros; try lia; try discriminate; auto.
  - destruct it as [p|], b; cbn [enter take anchor tip same deg port] in E; try discriminate.
    + unfold open_end in E. cbn [deg] in E. destruct (Nat.ltb_spec dt 2); [|discriminate]. destruct (agree pt p) eqn:Ag; [|discriminate]. injection E as <-.
      destruct sm; [destruct (S eq_refl) as (-> & _ & -> & ->)|]; destruct p as [l|]; unfold tidy, tidy_place, open_end; cbn;
        try (destruct (Nat.leb_spec da 1); [|lia]); cbn; repeat split; intros; try lia; try discriminate; auto.
    + injection E as <-. destruct p; cbn; repeat split; intros; try lia; try discriminate; auto.
    + injection E as <-. cbn. repeat split; intros; try lia; try discriminate; auto.
Qed.
Lemma run_sane its : forall c q v, run its c = Some (q, v) -> sane_arc q /\ (its = [] -> q = outer).
Proof.
  induction its as [|it its IH]; intros [|b c] q v E; try discriminate; unfold run in *; cbn [grun] in E.
  - injection E as <- _. split; [apply outer_sane|reflexivity].
  - destruct (grun true outer kept its c) as [[f [n i]]|] eqn:G; [|discriminate]. destruct (IH _ _ _ G) as [Sf O].
    destruct (enter (true && null its) it b f) as [g|] eqn:N; [|discriminate]. injection E as <- _. split; [|discriminate].
    eapply enter_sane; [exact Sf| |exact N]. destruct its; [auto|discriminate].
Qed.

Definition obind {A B} (o : option A) (f : A -> option B) : option B := match o with Some a => f a | None => None end.

Lemma tidy_kept x : room x -> tidy_place x = x.
Proof. intros R. destruct (room_cases x R) as [E|[E|[E ->]]]; unfold tidy_place, open_end; try rewrite E; reflexivity. Qed.
Lemma fresh_open p : open_end (fresh p) = true.
Proof. now destruct p. Qed.
Lemma tidy_fresh p : tidy_place (fresh p) = fresh p.
Proof. now destruct p. Qed.
Lemma tidy_twice x : tidy_place (tidy_place x) = tidy_place x.
Proof. unfold tidy_place at 2 3. destruct (open_end x) eqn:E; unfold tidy_place; rewrite ?E; [reflexivity|]. now destruct (open_end _). Qed.
Lemma open_tidy x : open_end (tidy_place x) = open_end x.
Proof. unfold open_end. now rewrite tidy_deg. Qed.
Lemma open_port x : open_end x = true -> port (tidy_place x) = port x.
Proof. intros E. unfold tidy_place. now rewrite E. Qed.
Lemma agree_none p : agree p None = true. Proof. now destruct p. Qed.
Lemma either_none p : either p None = p. Proof. now destruct p. Qed.

Local Arguments open_end : simpl never.
Local Arguments tidy_place : simpl never.
Local Arguments fresh : simpl never.
Local Arguments more : simpl never.
Local Arguments agree : simpl never.
Local Arguments either : simpl never.

Lemma room_open x l : open_end x = true -> open_end (Place (deg x) l) = true.
Proof. intros E. exact E. Qed.
Lemma tidy_open x : open_end x = true -> tidy_place x = x.
Proof. intros E. unfold tidy_place. now rewrite E. Qed.

(** The next item, before or after merging. *)
Lemma merge_enter f q it b : sane f -> sane_arc q ->
  obind (merge f q) (enter false it b) = obind (enter false it b q) (merge f).
Proof.
  intros (Fa & Ft & Fs) (Qt & Qa & Qs).
  pose proof (tidy_kept _ Fa) as Ta. pose proof (tidy_kept _ Qt) as Tq.
  destruct f as [xa xt sf]. destruct q as [[da pa] qt sq]. cbn [anchor tip same deg port] in *.
  assert (T1 : forall l, tidy_place (Place 1 l) = Place 1 l) by reflexivity.
  assert (O1 : forall l, open_end (Place 1 l) = true) by reflexivity.
  destruct da as [|[|da]]; [| |lia].
  - (* the link is dashed *)
    assert (sq = false) as -> by (destruct sq; [destruct (Qs eq_refl); discriminate|reflexivity]).
    unfold merge at 1. cbn [anchor deg Nat.eqb obind].
    destruct it as [p|], b; cbn [enter take anchor tip same obind]; try reflexivity.
    destruct (open_end qt && agree (port qt) p); cbn [obind]; [|reflexivity].
    unfold merge, tidy. cbn [anchor tip same]. rewrite tidy_deg. cbn. now rewrite Ta.
  - unfold merge at 1. cbn [anchor tip same deg port Nat.eqb].
    destruct (open_end xt) eqn:Ot.
    2: { cbn [obind]. destruct it as [p|], b; cbn [enter take anchor tip same deg obind]; try reflexivity;
           [destruct (open_end qt && agree (port qt) p); [|reflexivity]; destruct sq|..]; unfold merge, tidy; cbn; rewrite ?T1; cbn; now rewrite Ot. }
    destruct sq.
    + destruct (Qs eq_refl) as (_ & Dt & -> & Pt). clear Qs.
      assert (Eo : open_end qt = true) by now apply Nat.ltb_lt.
      assert (Eo' : forall l, open_end (Place (deg qt) l) = true) by (intros l; now apply Nat.ltb_lt).
      assert (Sf : sf = true -> open_end xa = true) by (intros E; apply Nat.ltb_lt; cbn; now apply Fs).
      assert (Sf' : forall l, sf = true -> open_end (Place (deg xa) l) = true) by (intros l E; now apply Sf).
      set (A := if sf then Place (deg xa) (port xt) else xa).
      assert (TA : tidy_place A = A) by (unfold A; destruct sf; [apply tidy_open, Sf'; reflexivity|exact Ta]).
      assert (OA : sf && open_end A = sf) by (unfold A; destruct sf; [now rewrite Sf'|reflexivity]).
      cbn [obind]. unfold tidy at 1. cbn [anchor tip same]. rewrite TA, OA, (tidy_open (Place (deg qt) _)), Eo', andb_true_r by apply Eo'.
      destruct it as [p|], b; cbn [enter take anchor tip same deg port]; try reflexivity.
      * rewrite Eo', Eo, Pt, !andb_true_l. change (agree None p) with true. change (either None p) with p. cbn [obind].
        destruct p as [l|].
        -- unfold merge, tidy. cbn [anchor tip same]. rewrite T1. cbn [deg Nat.eqb port same]. rewrite Ot.
           change (open_end (more (fresh (Some l)) (Some l))) with false. rewrite !andb_false_r.
           destruct (agree (port xt) (Some l)); [|reflexivity]. f_equal. f_equal.
           unfold A. now destruct sf.
        -- rewrite agree_none, either_none. unfold merge, tidy. cbn [anchor tip same]. rewrite T1. cbn [deg Nat.eqb port same]. rewrite Ot, O1.
           change (open_end (more (fresh None) None)) with true. cbn [andb]. fold A.
           change (more (fresh None) (port xt)) with (Place 1 (port xt)). change (tidy_place (more (fresh None) None)) with (Place 1 None).
           cbn [deg]. rewrite T1, O1, TA, OA, !andb_true_r. f_equal. f_equal; [|].
           ++ unfold A. destruct sf; [|exact Ta]. cbn [deg]. now rewrite tidy_open by now apply Sf'.
           ++ unfold A in *. destruct sf; [|reflexivity]. cbn [deg]. now rewrite Sf'.
      * cbn [obind]. unfold merge, tidy. cbn [anchor tip same deg port Nat.eqb]. rewrite Ot, agree_none, either_none, tidy_fresh. fold A. now rewrite TA.
      * cbn [obind]. unfold merge, tidy. cbn [anchor tip same deg port Nat.eqb]. rewrite Ot, agree_none, either_none. fold A. now rewrite TA.
    + clear Qs. destruct (agree (port xt) pa) eqn:Ag.
      2: { cbn [obind]. destruct it as [p|], b; cbn [enter take anchor tip same deg obind]; try reflexivity;
           [destruct (open_end qt && agree (port qt) p); [|reflexivity]|..]; unfold merge, tidy; cbn; rewrite ?T1; cbn; now rewrite Ot, Ag. }
      cbn [obind]. unfold tidy at 1. cbn [anchor tip same]. rewrite Tq. set (A := if sf then Place (deg xa) (either (port xt) pa) else xa).
      cbn [andb].
      destruct it as [p|], b; cbn [enter take anchor tip same deg port]; try reflexivity.
      * destruct (open_end qt && agree (port qt) p); [|reflexivity]. cbn [obind].
        unfold merge, tidy. cbn [anchor tip same]. rewrite T1. cbn [deg Nat.eqb port same andb]. rewrite Ot, Ag. fold A. now rewrite !tidy_twice.
      * cbn [obind]. unfold merge, tidy. cbn [anchor tip same deg port Nat.eqb andb]. rewrite Ot, Ag, tidy_fresh. reflexivity.
      * cbn [obind]. unfold merge, tidy. cbn [anchor tip same deg port Nat.eqb andb]. rewrite Ot, Ag. reflexivity.
Qed.

Lemma merge_deg f q g : merge f q = Some g -> deg (tip g) = deg (tip q).
Proof.
  unfold merge, tidy. destruct (deg (anchor q) =? 0); [intros E; now injection E as <-|]. destruct (open_end (tip f)); [|discriminate].
  destruct (same q); [intros E; injection E as <-; cbn [tip]; now rewrite tidy_deg|].
  destruct (agree _ _); [|discriminate]. intros E. injection E as <-. cbn [tip]. now rewrite tidy_deg.
Qed.
Lemma enter_anchor it b q g : enter false it b q = Some g -> deg (anchor g) = deg (anchor q).
Proof.
  destruct it as [p|], b; cbn [enter take]; try discriminate.
  - destruct (_ && _); [|discriminate]. intros E. injection E as <-. unfold tidy. cbn [anchor]. rewrite tidy_deg. now destruct (same q).
  - intros E. now injection E as <-. - intros E. now injection E as <-.
Qed.
Lemma merge_first f it b : sane f -> enter false it b f = obind (enter true it b outer) (merge f).
Proof.
  intros (Fa & Ft & Fs). pose proof (tidy_kept _ Fa) as Ta. destruct f as [xa xt sf]. cbn [anchor tip same] in *.
  assert (T1 : forall l, tidy_place (Place 1 l) = Place 1 l) by reflexivity.
  assert (O1 : forall l, open_end (Place 1 l) = true) by reflexivity.
  destruct it as [p|], b; cbn [enter take anchor tip same obind outer deg port]; try reflexivity.
  change (open_end (Place 0 None)) with true. cbn [andb]. change (agree None p) with true. change (either None p) with p. cbn [obind].
  unfold merge, tidy. cbn [anchor tip same]. change (more (Place 0 None) p) with (Place 1 p). rewrite T1, O1. cbn [deg Nat.eqb port same andb].
  destruct (open_end xt) eqn:Ot; [|reflexivity]. cbn [andb]. destruct p as [l|].
  - change (open_end (more (fresh (Some l)) (Some l))) with false. destruct (agree (port xt) (Some l)); [|reflexivity].
    cbn [andb]. change (more (fresh (Some l)) (either (port xt) (Some l))) with (Place 2 (either (port xt) (Some l))).
    change (more (fresh (Some l)) (Some l)) with (Place 2 (Some l)). change (open_end (Place 2 (either (port xt) (Some l)))) with false.
    change (tidy_place (Place 2 (either (port xt) (Some l)))) with (Place 2 None). change (tidy_place (tidy_place (Place 2 (Some l)))) with (Place 2 None).
    now rewrite andb_false_r.
  - rewrite agree_none, either_none. change (open_end (more (fresh None) None)) with true. cbn [andb].
    change (tidy_place (more (fresh None) None)) with (Place 1 None). cbn [deg]. reflexivity.
Qed.

(** An arc drawn from the frontier [f]: the arc's frontier, merged with it. The vertex where it begins may stay isolated. *)
Definition merged (f : frontier) (r : frontier * score) : option (frontier * score) :=
  match merge f (fst r) with
  | Some g => Some (g, (fst (snd r), snd (snd r) + lone (deg (tip f) + deg (anchor (fst r)))))
  | None => None
  end.
Theorem from_merged f its : sane f -> its <> [] -> forall c, from f its c = obind (run its c) (merged f).
Proof.
  intros Sf N. destruct its as [|it its]; [contradiction|]. clear N. revert it.
  induction its as [|it' its IH]; intros it [|b c]; try reflexivity.
  - unfold from, run. cbn [grun null andb]. destruct c as [|b' c]; [|reflexivity]. rewrite (merge_first f it b Sf). cbn [obind].
    destruct (enter true it b outer) as [q|] eqn:E; [|reflexivity]. cbn [obind]. unfold merged. cbn [fst snd kept].
    assert (D : left_by false b f = lone (deg (tip f) + deg (anchor q))).
    { unfold left_by. destruct it as [p|], b; cbn [enter take outer] in E; try discriminate.
      - change (open_end (tip outer)) with true in E. cbn in E. injection E as <-. unfold tidy. cbn. change (tidy_place (more (Place 0 None) (either None p))) with (Place 1 p).
        cbn. unfold lone. destruct (Nat.eqb_spec (deg (tip f) + 1) 0); [lia|reflexivity].
      - injection E as <-. cbn. now rewrite Nat.add_0_r. - injection E as <-. cbn. now rewrite Nat.add_0_r. }
    unfold kept. destruct (merge f q) as [g|]; [|reflexivity]. rewrite D. reflexivity.
  - specialize (IH it' c). unfold from, run in *. change (grun false f kept (it :: it' :: its) (b :: c)) with
      (match grun false f kept (it' :: its) c with
       | Some (g, (n, i)) => match enter false it b g with Some h => Some (kept h, (add b n, i + left_by false b g)) | None => None end
       | None => None end).
    change (grun true outer kept (it :: it' :: its) (b :: c)) with
      (match grun true outer kept (it' :: its) c with
       | Some (g, (n, i)) => match enter false it b g with Some h => Some (kept h, (add b n, i + left_by false b g)) | None => None end
       | None => None end).
    rewrite IH. clear IH. destruct (grun true outer kept (it' :: its) c) as [[q [n i]]|] eqn:R; [|reflexivity]. cbn [obind].
    destruct (run_sane (it' :: its) c q (n, i) R) as [Sq _]. pose proof (merge_enter f q it b Sf Sq) as M. unfold merged at 1. cbn [fst snd].
    destruct (merge f q) as [g|] eqn:Mg; cbn [obind] in M.
    + pose proof (merge_deg _ _ _ Mg) as Dt. destruct (enter false it b q) as [q'|] eqn:E; cbn [obind] in M |- *.
      * unfold kept, merged. cbn [fst snd]. rewrite (enter_anchor _ _ _ _ E), M. destruct (merge f q') as [g'|]; [|reflexivity].
        f_equal. f_equal. f_equal. unfold left_by. rewrite Dt. lia.
      * now rewrite M.
    + destruct (enter false it b q) as [q'|]; cbn [obind] in M |- *; [|reflexivity]. unfold merged, kept. cbn [fst snd]. now rewrite <- M.
Qed.

(** ** What becomes of a ring

    Two arcs between A and D, the first of which begins at A. [r1], [ch] and [r2] are the colours of the first arc's right link,
    of the chord and of the second arc's right link. *)
Definition ring_left (g : frontier * score) (r ch : bool) : option (frontier * score) :=
  match take (Next None) r (fst g) with
  | None => None
  | Some fd =>
      match take Chord ch fd with
      | None => None
      | Some fc => Some (fc, (add ch (add r (fst (snd g))), snd (snd g) + left_alone (Next None) r (fst g)))
      end
  end.
Definition ring_right (l : frontier * score) (q : frontier) (r : bool) : option score :=
  match merge (fst l) q with
  | None => None
  | Some f =>
      match take Chord r f with
      | None => None
      | Some e => Some (add r (fst (snd l)), snd (snd l) + lone (deg (tip (fst l)) + deg (anchor q)) + at_end e)
      end
  end.
Definition ring (g1 : frontier * score) (r1 ch : bool) (g2 : frontier * score) (r2 : bool) : option score :=
  match ring_left g1 r1 ch with
  | None => None
  | Some l => option_map (plus_score (snd g2)) (ring_right l (fst g2) r2)
  end.

(** One arc whose two links are the same edge, and one arc between two boundaries. *)
Definition close (g : frontier * score) (r : bool) : option score :=
  let '(f, (n, i)) := g in
  if deg (anchor f) =? (if r then 1 else 0) then
    if r then if open_end (tip f) && negb (same f) && agree (port (anchor f)) (port (tip f)) then Some (n, i) else None
    else Some (n, i + lone (deg (tip f)))
  else None.
Definition path_end (g : frontier * score) : option score :=
  let '(f, (n, i)) := g in if deg (anchor f) =? 0 then Some (n, i + lone (deg (tip f))) else None.

(** ** Steps of [Frontier.v] *)
Definition step_for (first : bool) (it : item) : step :=
  match it with Tri p => if first then Mark p else Next p | Rim => Chord end.
Fixpoint steps (m : bool) (its : list item) : list step :=
  match its with [] => [] | it :: r => steps m r ++ [step_for (m && null r) it] end.
Definition no_rim (its : list item) : Prop := ~ In Rim its.
Lemma steps_length m its : length (steps m its) = length its.
Proof. induction its as [|it its IH]; [reflexivity|]. cbn [steps]. rewrite app_length, IH. simpl. lia. Qed.

Definition marks (m : bool) (its : list item) (f : frontier) : nat := if m && negb (null its) then lone (deg (anchor f)) else 0.
Lemma play_steps m its : no_rim its -> forall c f n i, length c = length its ->
  play (steps m its) (rev c) f n i =
  match grun m f kept its c with Some (g, (n', i')) => Some (g, (n + n', i + i' + marks m its f)) | None => None end.
Proof.
  induction its as [|it its IH]; intros Nr c f n i L.
  - destruct c; [|discriminate]. cbn. unfold marks. rewrite andb_false_r, !Nat.add_0_r. reflexivity.
  - destruct c as [|b c]; [discriminate|]. injection L as L. cbn [steps rev grun].
    assert (Nr' : no_rim its) by (intros I; apply Nr; now right). assert (Ni : it <> Rim) by (intros ->; apply Nr; now left).
    rewrite play_app by now rewrite rev_length, steps_length. rewrite (IH Nr' c f n i L).
    destruct (grun m f kept its c) as [[g [n' i']]|] eqn:G; [|reflexivity]. destruct it as [p|]; [|contradiction].
    cbn [play step_for enter]. destruct (m && null its) eqn:Em.
    + destruct its; [|rewrite andb_false_r in Em; discriminate]. destruct c; [|discriminate]. cbn in G. injection G as <- <- <-. rewrite andb_true_r in Em. subst m.
      destruct (take (Mark p) b f) as [h|]; [|reflexivity]. unfold kept, marks, left_by, left_alone. cbn [andb negb null orb].
      f_equal. f_equal. f_equal; [destruct b; simpl; lia|lia].
    + destruct (take (Next p) b g) as [h|]; [|reflexivity]. unfold kept, left_by, left_alone. cbn [orb].
      assert (Q : marks m (Tri p :: its) f = marks m its f).
      { unfold marks. cbn [null negb]. destruct m; [|reflexivity]. destruct its; [discriminate|reflexivity]. }
      rewrite Q. f_equal. f_equal. f_equal; [destruct b; simpl; lia|lia].
Qed.

Lemma grun_app m f r : forall u c cu, length c = length r ->
  grun m f kept (r ++ u) (c ++ cu) =
  match grun m f kept u cu with
  | Some (g, (n, i)) =>
      match grun (m && null u) g kept r c with Some (h, (n', i')) => Some (h, (n + n', i + i')) | None => None end
  | None => None
  end.
Proof.
  induction r as [|it r IH]; intros u c cu L.
  - destruct c; [|discriminate]. cbn [app grun]. destruct (grun m f kept u cu) as [[g [n i]]|]; [|reflexivity]. now rewrite !Nat.add_0_r.
  - destruct c as [|b c]; [discriminate|]. injection L as L. cbn [app grun]. rewrite (IH u c cu L).
    destruct (grun m f kept u cu) as [[g [n i]]|]; [|reflexivity].
    assert (Q : m && null (r ++ u) = m && null u && null r).
    { destruct r; cbn [app null]; [now rewrite andb_true_r|now rewrite !andb_false_r]. }
    rewrite Q. destruct (grun (m && null u) g kept r c) as [[h [n' i']]|]; [|reflexivity].
    destruct (enter (m && null u && null r) it b h) as [h'|]; [|reflexivity]. f_equal. f_equal. f_equal; [destruct b; simpl; lia|lia].
Qed.
