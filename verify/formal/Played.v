(** * Arcs and routes

    The steps of a route, taken arc by arc: what [ring], [close] and [path_end] say is what [play] says. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Arcs Rings Closings.

Lemma books_eq (f : frontier) (n n' i i' : nat) : n = n' -> i = i' -> Some (f, (n, i)) = Some (f, (n', i')).
Proof. now intros -> ->. Qed.
Lemma score_eq (n n' i i' : nat) : n = n' -> i = i' -> Some (n, i) = Some (n', i').
Proof. now intros -> ->. Qed.
Ltac count_up := cbn [add]; (apply books_eq || apply score_eq); lia.

(** The score of what is drawn, the last two vertices counted. *)
Definition total (o : option (frontier * score)) : option score :=
  match o with Some (f, (n, i)) => Some (n, i + at_end f) | None => None end.
Definition two_more (o : option score) : option score := option_map (fun v => (fst v, snd v + 2)) o.

Lemma sane_of_arc q : sane_arc q -> sane q.
Proof.
  intros (T & A & S). split; [|split; [exact T|]].
  - unfold room. split; [lia|]. lia.
  - intros E. destruct (S E) as (A1 & A2 & _). lia.
Qed.

Lemma play_cons s ss b c f n i : play (s :: ss) (b :: c) f n i =
  match take s b f with Some g => play ss c g (if b then S n else n) (i + left_alone s b f) | None => None end.
Proof. reflexivity. Qed.

Lemma play_eq ss c f n n' i i' : n = n' -> i = i' -> total (play ss c f n i) = total (play ss c f n' i').
Proof. now intros -> ->. Qed.

(** ** A ring *)
Lemma left_played its c r ch : no_rim its -> its <> [] -> length c = length its ->
  play (Put None :: steps true its ++ [Next None; Chord]) (false :: rev c ++ [r; ch]) blank_frontier 0 0 =
  match obind (run its c) (fun g => ring_left g r ch) with Some (f, (n, i)) => Some (f, (n, i + 2)) | None => None end.
Proof.
  intros Nr Ne L. rewrite play_cons. change (take (Put None) false blank_frontier) with (Some outer). cbn [left_alone blank_frontier tip deg lone Nat.eqb].
  rewrite play_app by now rewrite rev_length, steps_length. rewrite (play_steps true its Nr c _ _ _ L). fold (run its c).
  destruct (run its c) as [[f [n i]]|]; [|reflexivity]. cbn [obind]. unfold ring_left. cbn [fst snd].
  assert (M : marks true its outer = 1) by (destruct its; [contradiction|reflexivity]). rewrite M. clear M.
  cbn [play]. destruct (take (Next None) r f) as [g|]; [|reflexivity]. destruct (take Chord ch g) as [h|]; [|reflexivity].
  cbn [left_alone]. change (lone 0) with 1. destruct r, ch; cbn [add]; count_up.
Qed.
Lemma left_sane its c r ch f v : obind (run its c) (fun g => ring_left g r ch) = Some (f, v) -> sane f.
Proof.
  intros E. destruct (run its c) as [[g w]|] eqn:R; [|discriminate]. cbn [obind] in E. unfold ring_left in E. cbn [fst] in E.
  apply run_sane in R as [S _]. destruct (take (Next None) r g) as [fd|] eqn:T1; [|discriminate]. destruct (take Chord ch fd) as [fc|] eqn:T2; [|discriminate].
  injection E as <- _. eapply take_sane; [|exact T2]. eapply take_sane; [|exact T1]. now apply sane_of_arc.
Qed.
Lemma from_right its c f n i r : sane f -> its <> [] ->
  total (match from f its c with Some (g, (n', i')) => play [Chord] [r] g (n + n') (i + i') | None => None end) =
  obind (run its c) (fun g2 => option_map (plus_score (snd g2)) (ring_right (f, (n, i)) (fst g2) r)).
Proof.
  intros S N. rewrite (from_merged f its S N c). destruct (run its c) as [[q [n2 i2]]|]; [|reflexivity]. cbn [obind]. unfold merged, ring_right. cbn [fst snd].
  destruct (merge f q) as [g|]; [|reflexivity]. cbn [play]. destruct (take Chord r g) as [h|]; [|reflexivity].
  cbn [total option_map left_alone]. unfold plus_score. cbn [fst snd]. destruct r; cbn [add]; count_up.
Qed.

Definition ring_run (its1 its2 : list item) (c1 : coloring) (r1 ch : bool) (c2 : coloring) (r2 : bool) : option score :=
  obind (run its1 c1) (fun g1 => obind (run its2 c2) (fun g2 => ring g1 r1 ch g2 r2)).
Lemma ring_right_two f n i q r : ring_right (f, (n, i + 2)) q r = two_more (ring_right (f, (n, i)) q r).
Proof.
  unfold ring_right, two_more. cbn [fst snd]. destruct (merge f q) as [g|]; [|reflexivity]. destruct (take Chord r g) as [h|]; [|reflexivity].
  cbn. count_up.
Qed.
Lemma two_plus v o : option_map (plus_score v) (two_more o) = two_more (option_map (plus_score v) o).
Proof. destruct o as [w|]; [|reflexivity]. unfold two_more, plus_score. cbn. count_up. Qed.
Lemma ring_joined its1 its2 c1 r1 ch c2 r2 :
  match obind (run its1 c1) (fun g => ring_left g r1 ch) with
  | Some (f, (n, i)) => obind (run its2 c2) (fun g2 => option_map (plus_score (snd g2)) (ring_right (f, (n, i + 2)) (fst g2) r2))
  | None => None
  end = two_more (ring_run its1 its2 c1 r1 ch c2 r2).
Proof.
  unfold ring_run, ring. destruct (run its1 c1) as [g1|]; [|reflexivity]. cbn [obind]. destruct (ring_left g1 r1 ch) as [[f [n i]]|].
  - destruct (run its2 c2) as [g2|]; [|reflexivity]. cbn [obind]. rewrite ring_right_two.
    apply two_plus.
  - now destruct (run its2 c2).
Qed.

Theorem ring_played its1 its2 c1 r1 ch c2 r2 : no_rim its1 -> its1 <> [] -> length c1 = length its1 ->
  no_rim its2 -> its2 <> [] -> length c2 = length its2 ->
  total (play (Put None :: steps true its1 ++ [Next None; Chord] ++ steps false its2 ++ [Chord])
    (false :: rev c1 ++ [r1; ch] ++ rev c2 ++ [r2]) blank_frontier 0 0) = two_more (ring_run its1 its2 c1 r1 ch c2 r2).
Proof.
  intros N1 E1 L1 N2 E2 L2. rewrite (app_assoc (steps true its1)), (app_assoc (rev c1)), (app_comm_cons (steps true its1 ++ _)), (app_comm_cons (rev c1 ++ _)).
  rewrite play_app by (cbn; now rewrite !app_length, rev_length, steps_length, L1).
  rewrite (left_played its1 c1 r1 ch N1 E1 L1), <- ring_joined.
  destruct (obind (run its1 c1) (fun g => ring_left g r1 ch)) as [[f [n i]]|] eqn:Le; [|reflexivity]. pose proof (left_sane _ _ _ _ _ _ Le) as S.
  rewrite play_app by now rewrite rev_length, steps_length. rewrite (play_steps false its2 N2 c2 _ _ _ L2).
  rewrite <- (from_right its2 c2 f n (i + 2) r2 S E2). unfold from. destruct (grun false f kept its2 c2) as [[g [n' i']]|]; [|reflexivity].
  unfold marks. cbn [andb]. now rewrite Nat.add_0_r.
Qed.

(** The same with the boundary in the second arc, after which an unjoined triangle is placed. *)
Theorem rim_ring_played its1 S c1 r1 ch cS r2 (p : option nat) P cP b : no_rim its1 -> its1 <> [] -> length c1 = length its1 ->
  no_rim S -> length cS = length S -> no_rim P -> length cP = length P ->
  ring_run its1 (P ++ Tri p :: Rim :: S) c1 r1 ch (cP ++ b :: false :: cS) r2 =
  if b then None else ring_run its1 (P ++ Tri p :: Rim :: S) c1 r1 ch (cP ++ false :: false :: cS) r2.
Proof.
  intros. destruct b; [|reflexivity]. unfold ring_run. destruct (run its1 c1) as [g1|]; [|reflexivity]. cbn [obind].
  assert (E : run (P ++ Tri p :: Rim :: S) (cP ++ true :: false :: cS) = None).
  { unfold run. rewrite grun_app by assumption. cbn [grun]. destruct (grun true outer kept S cS) as [[f [n i]]|]; [|reflexivity].
    cbn [enter kept null andb]. destruct (true && null S); reflexivity. }
  now rewrite E.
Qed.
Theorem put_ring_played its1 S c1 r1 ch cS r2 p P cP : no_rim its1 -> its1 <> [] -> length c1 = length its1 ->
  no_rim S -> length cS = length S -> no_rim P -> length cP = length P ->
  total (play (Put None :: steps true its1 ++ [Next None; Chord] ++ steps false S ++ Put p :: steps false P ++ [Chord])
    (false :: rev c1 ++ [r1; ch] ++ rev cS ++ false :: rev cP ++ [r2]) blank_frontier 0 0) =
  two_more (ring_run its1 (P ++ Tri p :: Rim :: S) c1 r1 ch (cP ++ false :: false :: cS) r2).
Proof.
  intros N1 E1 L1 NS LS NP LP. rewrite (app_assoc (steps true its1)), (app_assoc (rev c1)), (app_comm_cons (steps true its1 ++ _)), (app_comm_cons (rev c1 ++ _)).
  rewrite play_app by (cbn; now rewrite !app_length, rev_length, steps_length, L1).
  rewrite (left_played its1 c1 r1 ch N1 E1 L1), <- ring_joined.
  destruct (obind (run its1 c1) (fun g => ring_left g r1 ch)) as [[f [n i]]|] eqn:Le; [|reflexivity]. pose proof (left_sane _ _ _ _ _ _ Le) as Sf.
  rewrite <- (from_right (P ++ Tri p :: Rim :: S) (cP ++ false :: false :: cS) f n (i + 2) r2 Sf) by (destruct P; discriminate).
  rewrite play_app by now rewrite rev_length, steps_length. rewrite (play_steps false S NS cS _ _ _ LS).
  unfold from. rewrite grun_app by exact LP. cbn [grun andb null].
  destruct (grun false f kept S cS) as [[g [n' i']]|]; [|reflexivity].
  rewrite play_cons. cbn [take enter kept anchor].
  change (kept (Frontier (anchor g) (fresh p) false)) with (Frontier (anchor g) (fresh p) false).
  rewrite play_app by now rewrite rev_length, steps_length. rewrite (play_steps false P NP cP _ _ _ LP).
  destruct (grun false (Frontier (anchor g) (fresh p) false) kept P cP) as [[h [n'' i'']]|]; [|reflexivity].
  unfold marks, left_by, left_alone, kept. cbn [andb orb tip deg add]. change (lone 2) with 0. rewrite !Nat.add_0_r.
  apply play_eq; lia.
Qed.
(** The boundary at the end of the second arc: the ring is not closed. *)
Theorem open_ring_played its1 S c1 r1 ch cS r2 : no_rim its1 -> its1 <> [] -> length c1 = length its1 ->
  no_rim S -> length cS = length S ->
  two_more (ring_run its1 (Rim :: S) c1 r1 ch (false :: cS) r2) =
  if r2 then None else
  total (play (Put None :: steps true its1 ++ [Next None; Chord] ++ steps false S) (false :: rev c1 ++ [r1; ch] ++ rev cS) blank_frontier 0 0).
Proof.
  intros N1 E1 L1 NS LS. rewrite (app_assoc (steps true its1)), (app_assoc (rev c1)), (app_comm_cons (steps true its1 ++ _)), (app_comm_cons (rev c1 ++ _)).
  rewrite play_app by (cbn; now rewrite !app_length, rev_length, steps_length, L1).
  rewrite (left_played its1 c1 r1 ch N1 E1 L1), <- ring_joined.
  destruct (obind (run its1 c1) (fun g => ring_left g r1 ch)) as [[f [n i]]|] eqn:Le; [|now destruct r2]. pose proof (left_sane _ _ _ _ _ _ Le) as Sf.
  rewrite <- (from_right (Rim :: S) (false :: cS) f n (i + 2) r2 Sf) by discriminate.
  rewrite (play_steps false S NS cS _ _ _ LS). unfold from. cbn [grun andb].
  destruct (grun false f kept S cS) as [[g [n' i']]|]; [|now destruct r2]. cbn [enter kept play take anchor tip same].
  change (open_end (Place 2 None)) with false. rewrite andb_false_r. cbn [andb]. destruct r2; [reflexivity|].
  unfold total, at_end, left_by, marks, kept. cbn [anchor tip deg add orb left_alone andb]. change (lone 2) with 0. count_up.
Qed.

(** ** One arc *)
Theorem close_played p its c b0 : no_rim its -> its <> [] -> length c = length its ->
  total (play (Put p :: steps true its ++ [Chord]) (false :: rev c ++ [b0]) blank_frontier 0 0) =
  two_more (obind (run (its ++ [Tri p]) (c ++ [b0])) (fun g => close g b0)).
Proof.
  intros Nr Ne L. rewrite (run_attached p its Nr Ne c b0 L). rewrite play_cons. change (take (Put p) false blank_frontier) with (Some (alone_start p)).
  cbn [left_alone blank_frontier tip deg lone Nat.eqb]. rewrite play_app by now rewrite rev_length, steps_length.
  rewrite (play_steps true its Nr c _ _ _ L). destruct (grun true (alone_start p) kept its c) as [[f [n i]]|] eqn:G; [|reflexivity]. cbn [obind].
  assert (M : marks true its (alone_start p) = 1) by (destruct its; [contradiction|reflexivity]). rewrite M. clear M.
  unfold attached, attach. cbn [fst snd]. destruct b0.
  - cbn [play take]. destruct (open_end (anchor f)) eqn:Oa.
    + cbn [obind close anchor tip same deg port Nat.eqb andb].
      destruct (open_end (tip f) && negb (same f) && agree (port (anchor f)) (port (tip f))); [|reflexivity].
      cbn [play total two_more option_map fst snd]. unfold at_end, tidy. cbn [anchor tip left_alone].
      rewrite !tidy_deg. cbn. change (lone 0) with 1. count_up.
    + cbn [andb]. reflexivity.
  - cbn [play take]. cbn [obind close anchor tip same deg port Nat.eqb total two_more option_map fst snd add]. unfold at_end. cbn [left_alone]. change (lone 0) with 1. count_up.
Qed.

Theorem path_played p its c : no_rim its -> length c = length its ->
  total (play (Put p :: steps false its) (false :: rev c) blank_frontier 0 0) =
  two_more (obind (run (its ++ [Tri p]) (c ++ [false])) path_end).
Proof.
  intros Nr L. rewrite play_cons. change (take (Put p) false blank_frontier) with (Some (alone_start p)).
  cbn [left_alone blank_frontier tip deg lone Nat.eqb]. rewrite (play_steps false its Nr c _ _ _ L).
  unfold run. rewrite grun_app by exact L. cbn [grun null andb enter kept].
  change (take (Mark p) false outer) with (Some (alone_start p)). cbv beta iota. change (kept (alone_start p)) with (alone_start p).
  destruct (grun false (alone_start p) kept its c) as [[f [n i]]|] eqn:G; [|reflexivity]. cbn [obind path_end].
  assert (A : deg (anchor f) = 0).
  { assert (W : forall its c f v, grun false (alone_start p) kept its c = Some (f, v) -> deg (anchor f) = 0).
    { clear. induction its as [|it its IH]; intros [|b c] f v E; try discriminate; cbn [grun andb] in E.
      - now injection E as <- _.
      - destruct (grun false (alone_start p) kept its c) as [[g [n i]]|] eqn:G; [|discriminate]. destruct (enter false it b g) as [h|] eqn:N; [|discriminate].
        injection E as <- _. unfold kept. rewrite (enter_anchor _ _ _ _ N). eapply IH, G. }
    eapply W, G. }
  rewrite A. cbn [Nat.eqb total two_more option_map fst snd]. unfold at_end, marks, left_by. cbn [andb orb]. rewrite A. change (lone 0) with 1. count_up.
Qed.
(** An arc whose first link is solid does not end between boundaries. *)
Lemma path_first_dashed p its c : length c = length its -> obind (run (its ++ [Tri p]) (c ++ [true])) path_end = None.
Proof.
  intros L. destruct (run (its ++ [Tri p]) (c ++ [true])) as [[f [n i]]|] eqn:R; [|reflexivity]. cbn [obind path_end].
  unfold run in R. rewrite grun_app in R by exact L. cbn [grun null andb] in R.
  destruct (outer_enters p true) as (f0 & E0). rewrite E0 in R. unfold kept in R at 1.
  assert (W : forall its c f v, deg (anchor f0) <> 0 -> grun false f0 kept its c = Some (f, v) -> deg (anchor f) <> 0).
  { clear. intros its c f v D. revert c f v. induction its as [|it its IH]; intros [|b c] f v E; try discriminate; cbn [grun andb] in E.
    - now injection E as <- _.
    - destruct (grun false f0 kept its c) as [[g [n i]]|] eqn:G; [|discriminate]. destruct (enter false it b g) as [h|] eqn:N; [|discriminate].
      injection E as <- _. unfold kept. rewrite (enter_anchor _ _ _ _ N). eapply IH, G. }
  destruct (grun false f0 kept its c) as [[g [n' i']]|] eqn:G; [|discriminate]. injection R as <- _ _.
  assert (D : deg (anchor f0) <> 0).
  { cbn in E0. injection E0 as <-. unfold tidy. cbn [anchor]. rewrite tidy_deg. cbn. discriminate. }
  specialize (W its c g _ D G). destruct (Nat.eqb_spec (deg (anchor g)) 0); [contradiction|reflexivity].
Qed.
