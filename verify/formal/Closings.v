(** * One arc by itself: a closed fan, and a fan between two boundaries *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Arcs Rings.

Local Arguments open_end : simpl never.
Local Arguments tidy_place : simpl never.
Local Arguments fresh : simpl never.
Local Arguments more : simpl never.
Local Arguments agree : simpl never.
Local Arguments either : simpl never.

(** ** A closed fan

    It is drawn from its first triangle, which is the anchor; the arc begins one link earlier. *)
Definition alone_start (p : option nat) : frontier := Frontier (Place 0 None) (fresh p) false.
Definition attach (b : bool) (f : frontier) : option frontier :=
  if b then if open_end (anchor f) then Some (Frontier (Place 1 (port (anchor f))) (tip f) (same f)) else None
  else Some (Frontier (Place 0 None) (tip f) false).

Lemma attach_enter b0 f it b : it <> Rim -> sane f ->
  obind (attach b0 f) (enter false it b) = obind (enter false it b f) (attach b0).
Proof.
  intros Nr (Fa & Ft & Fs). destruct it as [p|]; [|contradiction]. destruct f as [xa xt sf]. cbn [anchor tip same] in *.
  assert (T1 : forall l, tidy_place (Place 1 l) = Place 1 l) by reflexivity.
  assert (O1 : forall l, open_end (Place 1 l) = true) by reflexivity.
  assert (T0 : forall l, tidy_place (Place 0 l) = Place 0 l) by reflexivity.
  unfold attach. cbn [anchor tip same]. destruct b0.
  - destruct (open_end xa) eqn:Oa.
    + cbn [obind]. destruct b; cbn [enter take anchor tip same deg port].
      * destruct (open_end xt && agree (port xt) p); [|reflexivity]. cbn [obind]. unfold tidy. cbn [anchor tip same].
        assert (E : open_end (if sf then Place (deg xa) (either (port xt) p) else xa) = true) by (destruct sf; exact Oa).
        rewrite open_tidy, E, (tidy_open _ E). destruct sf; cbn [deg port]; rewrite ?T1, ?O1, ?andb_true_r; reflexivity.
      * cbn [obind anchor tip same]. now rewrite Oa.
    + cbn [obind]. destruct b; cbn [enter take anchor tip same deg port].
      * destruct (open_end xt && agree (port xt) p); [|reflexivity]. cbn [obind]. unfold tidy. cbn [anchor tip same].
        rewrite open_tidy. assert (E : open_end (if sf then Place (deg xa) (either (port xt) p) else xa) = false) by (destruct sf; exact Oa).
        now rewrite E.
      * cbn [obind anchor tip same]. now rewrite Oa.
  - cbn [obind]. destruct b; cbn [enter take anchor tip same deg port].
    + destruct (open_end xt && agree (port xt) p); [|reflexivity]. cbn [obind]. unfold tidy. cbn [anchor tip same]. now rewrite T0.
    + reflexivity.
Qed.

(** The books after two triangles. *)
Lemma attach_first b0 p p' b :
  obind (enter true (Tri p) b0 outer) (enter false (Tri p') b) = obind (enter true (Tri p') b (alone_start p)) (attach b0).
Proof.
  unfold alone_start, outer. destruct p as [l|], p' as [l'|], b0, b; cbn [enter take obind anchor tip same]; try reflexivity;
    unfold fresh, more, either, tidy, tidy_place, attach, open_end; cbn; try reflexivity; unfold agree; try reflexivity;
    destruct (l =? l'); reflexivity.
Qed.
Lemma alone_sane p : sane (alone_start p).
Proof. unfold sane, alone_start. cbn. split; [|split; [apply fresh_sane|discriminate]]. unfold room. cbn. split; [lia|discriminate]. Qed.

Definition attached (b0 : bool) (r : frontier * score) : option (frontier * score) :=
  match attach b0 (fst r) with
  | Some q => Some (q, (add b0 (fst (snd r)), snd (snd r) + if b0 then 0 else lone (deg (anchor (fst r)))))
  | None => None
  end.

Lemma first_anchor p it b f : enter true it b (alone_start p) = Some f -> it <> Rim ->
  deg (anchor f) = deg (fresh p) + if b then 1 else 0.
Proof.
  intros E N. destruct it as [p'|]; [|contradiction]. destruct b; cbn [enter take alone_start tip anchor same] in E.
  - destruct (_ && _); [|discriminate]. injection E as <-. unfold tidy. cbn [anchor]. rewrite tidy_deg. cbn. unfold more. cbn. lia.
  - injection E as <-. cbn. lia.
Qed.
Lemma outer_tip p b f : enter true (Tri p) b outer = Some f -> deg (tip f) = deg (fresh p) + if b then 1 else 0.
Proof.
  intros E. destruct b; cbn [enter take outer tip anchor same] in E.
  - change (open_end (Place 0 None)) with true in E. cbn in E. change (agree None p) with true in E. injection E as <-. unfold tidy. cbn [tip]. rewrite tidy_deg. unfold more. cbn. lia.
  - injection E as <-. cbn. lia.
Qed.
Lemma outer_enters p b : exists f, enter true (Tri p) b outer = Some f.
Proof. destruct b; eexists; reflexivity. Qed.

Lemma grun_sane m f its : sane f -> forall c g v, grun m f kept its c = Some (g, v) -> sane g.
Proof.
  intros S. induction its as [|it its IH]; intros [|b c] g v E; try discriminate; cbn [grun] in E.
  - now injection E as <- _.
  - destruct (grun m f kept its c) as [[h [n i]]|] eqn:G; [|discriminate]. specialize (IH c h (n, i) G).
    destruct (enter (m && null its) it b h) as [h'|] eqn:N; [|discriminate]. injection E as <- _. unfold kept.
    destruct it as [p|]; cbn [enter] in N.
    + eapply take_sane; [exact IH|exact N].
    + destruct b; [discriminate|]. injection N as <-. destruct IH as (A & T & Sa). unfold sane. cbn [anchor tip same].
      split; [now destruct (m && null its)|]. split; [|discriminate]. unfold room. cbn. split; auto; lia.
Qed.

Theorem run_attached p r : no_rim r -> r <> [] -> forall c b0, length c = length r ->
  run (r ++ [Tri p]) (c ++ [b0]) = obind (grun true (alone_start p) kept r c) (attached b0).
Proof.
  intros Nr Ne c b0 L. unfold run. rewrite grun_app by exact L. cbn [null andb app grun]. unfold kept at 1.
  destruct (outer_enters p b0) as (f0 & E0). rewrite E0. pose proof (outer_tip _ _ _ E0) as Dt.
  assert (W : forall r c, no_rim r -> r <> [] -> length c = length r ->
    match grun false f0 kept r c with Some (h, (n', i')) => Some (h, (add b0 0 + n', 0 + left_by true b0 outer + i')) | None => None end =
    obind (grun true (alone_start p) kept r c) (attached b0)).
  { clear r c Nr Ne L. induction r as [|it r IH]; intros c Nr Ne L; [contradiction|]. clear Ne. destruct c as [|b c]; [discriminate|]. injection L as L.
    assert (Nr' : no_rim r) by (intros I; apply Nr; now right). assert (Ni : it <> Rim) by (intros ->; apply Nr; now left).
    destruct r as [|it' r].
    - destruct c; [|discriminate]. cbn [grun null andb]. destruct it as [p'|]; [|contradiction].
      pose proof (attach_first b0 p p' b) as A. rewrite E0 in A. cbn [obind] in A.
      destruct (enter true (Tri p') b (alone_start p)) as [g|] eqn:E; cbn [obind] in A |- *.
      + pose proof (first_anchor _ _ _ _ E Ni) as Da. unfold attached, kept. cbn [fst snd]. rewrite A. destruct (attach b0 g) as [q|]; [|reflexivity].
        f_equal. f_equal. f_equal; [destruct b0, b; reflexivity|]. unfold left_by. cbn [orb]. rewrite Dt, Da.
        destruct b0, b; cbn; unfold lone; repeat match goal with |- context [?x =? 0] => destruct (Nat.eqb_spec x 0) end; lia.
      + now rewrite A.
    - specialize (IH c Nr' ltac:(discriminate) L).
      change (grun false f0 kept (it :: it' :: r) (b :: c)) with
        (match grun false f0 kept (it' :: r) c with
         | Some (g, (n, i)) => match enter false it b g with Some h => Some (kept h, (add b n, i + left_by false b g)) | None => None end
         | None => None end).
      change (grun true (alone_start p) kept (it :: it' :: r) (b :: c)) with
        (match grun true (alone_start p) kept (it' :: r) c with
         | Some (g, (n, i)) => match enter false it b g with Some h => Some (kept h, (add b n, i + left_by false b g)) | None => None end
         | None => None end).
      destruct (grun true (alone_start p) kept (it' :: r) c) as [[g [n i]]|] eqn:G; cbn [obind] in IH |- *.
      + pose proof (grun_sane true (alone_start p) (it' :: r) (alone_sane p) c g (n, i) G) as Sg.
        pose proof (attach_enter b0 g it b Ni Sg) as A. unfold attached in IH. cbn [fst snd] in IH.
        destruct (attach b0 g) as [q|] eqn:At; cbn [obind] in A.
        * destruct (grun false f0 kept (it' :: r) c) as [[q' [n' i']]|]; [|discriminate]. injection IH as -> En Ei. rewrite A.
          destruct (enter false it b g) as [g'|] eqn:Eg; [|reflexivity]. cbn [obind]. unfold attached, kept. cbn [fst snd].
          destruct (attach b0 g') as [q''|]; [|reflexivity]. rewrite (enter_anchor _ _ _ _ Eg).
          assert (Tq : deg (tip q) = deg (tip g)).
          { unfold attach in At. destruct b0; [destruct (open_end (anchor g)); [|discriminate]|]; now injection At as <-. }
          f_equal. f_equal. unfold left_by in *. cbn [orb] in *. rewrite Tq. f_equal; [destruct b0, b; cbn in *; lia|lia].
        * destruct (grun false f0 kept (it' :: r) c) as [[q' [n' i']]|]; [discriminate|].
          destruct (enter false it b g) as [g'|]; [|reflexivity]. cbn [obind] in A |- *. unfold attached, kept. cbn [fst]. now rewrite <- A.
      + destruct (grun false f0 kept (it' :: r) c) as [[q' [n' i']]|]; [discriminate|reflexivity]. }
  now apply W.
Qed.
