(** * Arcs of a fan

    An arc is a row of triangles between two dual edges, its links; among them may be the boundary of the mesh. It is drawn from
    left to right with the books of [Frontier.v], beginning at a vertex on the other side of the left link. Here an arc is a list
    with its *last* triangle first, and so is a colouring of the links to the left of its triangles. *)
Require Import Arith Bool List Lia.
Import ListNotations.
Require Import Statements Checker Frontier.

(** ** Drawing an arc

    A triangle, with the label of its port if that is solid, or the boundary. *)
Inductive item := Tri (p : option nat) | Rim.

(** The first item is joined to the vertex [outer] stands at, which becomes the anchor. The boundary is a tip that has no room. *)
Definition enter (first : bool) (it : item) (b : bool) (f : frontier) : option frontier :=
  match it with
  | Tri p => take (if first then Mark p else Next p) b f
  | Rim => if b then None else Some (Frontier (if first then tip f else anchor f) (Place 2 None) false)
  end.
Definition left_by (first b : bool) (f : frontier) : nat := if first || b then 0 else lone (deg (tip f)).
Definition outer : frontier := Frontier (Place 0 None) (Place 0 None) false.
Definition null {A} (l : list A) : bool := match l with [] => true | _ => false end.
Definition add (b : bool) (n : nat) : nat := if b then S n else n.

(** From any books; [m]: is the first item joined by a [Mark]? *)
Section Run.
  Variables (m : bool) (start : frontier) (norm : frontier -> frontier).
  Fixpoint grun (its : list item) (c : coloring) : option (frontier * score) :=
    match its, c with
    | [], [] => Some (start, (0, 0))
    | it :: r, b :: c' =>
        match grun r c' with
        | Some (f, (n, i)) =>
            match enter (m && null r) it b f with
            | Some g => Some (norm g, (add b n, i + left_by (m && null r) b f))
            | None => None
            end
        | None => None
        end
    | _, _ => None
    end.

  Lemma grun_length its : forall c r, grun its c = Some r -> length c = length its.
  Proof.
    induction its as [|it its IH]; intros [|b c] r E; try discriminate; [reflexivity|]. simpl in *.
    destruct (grun its c) as [[f [n i]]|] eqn:G; [|discriminate]. f_equal. eapply IH, G.
  Qed.
End Run.
Definition kept (f : frontier) : frontier := f.
Definition run : list item -> coloring -> option (frontier * score) := grun true outer kept.
Definition from (f : frontier) : list item -> coloring -> option (frontier * score) := grun false f kept.

(** ** Letters

    The input of the automaton. Of a port's label only one thing matters: whether it equals the label of the solid port before it.
    Label 0 stands for equal, label 1 for different. *)
Definition item_of (l : letter) : item :=
  match l with Plain => Tri None | Alone => Tri (Some 1) | Joined => Tri (Some 0) | Edge => Rim end.
Definition plain_place (x : place) : place := Place (deg x) (option_map (fun _ => 0) (port x)).
Definition plain (f : frontier) : frontier := Frontier (plain_place (anchor f)) (plain_place (tip f)) (same f).
Definition arun (w : list letter) : coloring -> option (frontier * score) := grun true outer plain (map item_of w).

(** Labelled letters, and the labels of the first and the last solid port. *)
Notation labelled := (letter * nat)%type.
Definition is_solid (l : letter) : bool := match l with Alone | Joined => true | _ => false end.
Definition real (x : labelled) : item := match fst x with Plain => Tri None | Edge => Rim | _ => Tri (Some (snd x)) end.
Definition solid_ones (w : list labelled) : list labelled := filter (fun x => is_solid (fst x)) w.
Definition last_label (w : list labelled) : option nat := option_map snd (hd_error (solid_ones w)).
Definition first_label (w : list labelled) : option nat := option_map snd (hd_error (rev (solid_ones w))).
(** The last one since the boundary. *)
Fixpoint near_label (w : list labelled) : option nat :=
  match w with
  | [] => None
  | (Plain, _) :: r => near_label r
  | (Edge, _) :: _ => None
  | (_, x) :: _ => Some x
  end.
(** The letters determine the labels. *)
Fixpoint fitting (w : list labelled) : Prop :=
  match w with
  | [] => True
  | (l, x) :: u => fitting u /\ (is_solid l = true -> forall y, near_label u = Some y -> (l = Joined <-> x = y))
  end.

Definition paint_place (l : nat) (x : place) : place := Place (deg x) (option_map (fun _ => l) (port x)).
Definition paint (F L : nat) (f : frontier) : frontier := Frontier (paint_place F (anchor f)) (paint_place L (tip f)) (same f).
Definition label (o : option nat) : nat := match o with Some x => x | None => 0 end.
Definition painted (w : list labelled) (r : frontier * score) : frontier * score :=
  (paint (label (first_label w)) (label (last_label w)) (fst r), snd r).

Definition zero (o : option nat) : Prop := o = None \/ o = Some 0.
Definition well_read (w : list labelled) (f : frontier) : Prop :=
  zero (port (anchor f)) /\ zero (port (tip f)) /\ (first_label w = None -> port (anchor f) = None) /\
  (near_label w = None -> port (tip f) = None) /\ (same f = true -> first_label w = None).

Lemma near_last w x : near_label w = Some x -> last_label w = Some x.
Proof.
  induction w as [|[[| | |] y] w IH]; simpl; intros E; try discriminate; unfold last_label in *; simpl in *; auto.
Qed.
Lemma first_cons_plain l x w : is_solid l = false -> first_label ((l, x) :: w) = first_label w.
Proof. intros E. unfold first_label, solid_ones. simpl. now rewrite E. Qed.
Lemma first_cons_solid l x w : is_solid l = true ->
  first_label ((l, x) :: w) = match first_label w with Some y => Some y | None => Some x end.
Proof.
  intros E. unfold first_label. assert (Q : solid_ones ((l, x) :: w) = (l, x) :: solid_ones w) by (unfold solid_ones; simpl; now rewrite E).
  rewrite Q. cbn [rev]. now destruct (rev (solid_ones w)).
Qed.
Lemma last_cons_plain l x w : is_solid l = false -> last_label ((l, x) :: w) = last_label w.
Proof. intros E. unfold last_label, solid_ones. simpl. now rewrite E. Qed.
Lemma last_cons_solid l x w : is_solid l = true -> last_label ((l, x) :: w) = Some x.
Proof. intros E. unfold last_label, solid_ones. simpl. now rewrite E. Qed.
Lemma first_none_near w : first_label w = None -> near_label w = None.
Proof.
  induction w as [|[[| | |] y] w IH]; intros E; [reflexivity|..]; simpl; try reflexivity.
  - apply IH. now rewrite first_cons_plain in E.
  - rewrite first_cons_solid in E by reflexivity. destruct (first_label w); discriminate.
  - rewrite first_cons_solid in E by reflexivity. destruct (first_label w); discriminate.
Qed.

Ltac read_on := unfold zero in *; repeat match goal with H : _ = None \/ _ = Some 0 |- _ => destruct H; subst end; cbn in *;
  repeat match goal with |- _ /\ _ => split end; intros; cbn in *; try (left; congruence); try (right; congruence); try congruence; intuition congruence.

(** One step: [enter] on labels is [enter] on letters, painted. *)
Lemma enter_painted w l x b f : fitting ((l, x) :: w) -> well_read w f -> (w = [] -> f = outer) ->
  let F := label (first_label w) in let L := label (last_label w) in
  let w' := (l, x) :: w in
  match enter (null w) (item_of l) b f with
  | Some g => enter (null w) (real (l, x)) b (paint F L f) = Some (paint (label (first_label w')) (label (last_label w')) (plain g)) /\
      well_read w' (plain g)
  | None => enter (null w) (real (l, x)) b (paint F L f) = None
  end.
Proof.
  intros [_ Fit] (Za & Zt & Na & Nt & Ns) O. cbn zeta.
  destruct w as [|y w].
  - rewrite (O eq_refl). clear. unfold outer. destruct l, b; cbn; try reflexivity; (split; [reflexivity|]);
      unfold well_read, zero; cbn; intuition congruence.
  - clear O. set (u := y :: w) in *. assert (Nu : null u = false) by reflexivity. rewrite Nu.
    destruct f as [[da pa] [dt pt] sm]. cbn [anchor tip deg port same] in *.
    assert (Sp : sm = true -> pa = None /\ pt = None).
    { intros Q. specialize (Ns Q). split; [now apply Na|]. apply Nt. now apply first_none_near. }
    destruct l; cbn [enter item_of real fst snd is_solid] in *.
    + rewrite first_cons_plain, last_cons_plain by reflexivity. unfold well_read. rewrite first_cons_plain by reflexivity.
      destruct b; cbn [take tip anchor same port deg paint paint_place].
      * unfold open_end, paint_place. cbn [deg]. destruct (dt <? 2) eqn:D; cbn [andb].
        -- assert (Ea : forall q : option nat, agree q None = true) by (intros [|]; reflexivity). rewrite !Ea. split.
           ++ unfold tidy, plain, paint, plain_place, paint_place, tidy_place, open_end. cbn.
              destruct sm; [destruct (Sp eq_refl) as [-> ->]|]; cbn; destruct (da <=? 1); cbn; try reflexivity;
                destruct Za as [Q1|Q1], Zt as [Q2|Q2]; try rewrite Q1; try rewrite Q2; cbn; reflexivity.
           ++ unfold tidy, plain, plain_place, tidy_place, open_end, zero. cbn. cbn [near_label].
              destruct sm; [destruct (Sp eq_refl) as [-> ->]|]; cbn; destruct (da <=? 1); cbn; read_on.
        -- reflexivity.
      * split; [|unfold plain, plain_place; cbn; read_on].
        unfold plain, paint, plain_place, paint_place. cbn. destruct Za as [-> | ->]; reflexivity.
    + (* Alone *)
      rewrite first_cons_solid, last_cons_solid by reflexivity. unfold well_read. rewrite first_cons_solid by reflexivity.
      specialize (Fit eq_refl).
      assert (Ag : agree (option_map (fun _ => label (last_label u)) pt) (Some x) = agree pt (Some 1)).
      { destruct Zt as [-> | ->]; [reflexivity|]. cbn. destruct (near_label u) as [z|] eqn:Nz; [|now specialize (Nt eq_refl)].
        rewrite (near_last _ _ Nz). cbn [label]. apply Nat.eqb_neq. intros ->. specialize (Fit x eq_refl). destruct Fit as [_ Fit]. now specialize (Fit eq_refl). }
      destruct b; cbn [take tip anchor same port deg paint paint_place].
      * rewrite Ag. unfold open_end, paint_place. cbn [deg]. destruct (dt <? 2) eqn:D; cbn [andb]; [|reflexivity].
        destruct Zt as [-> | ->]; [|reflexivity]. cbn [agree either option_map].
        destruct sm.
        -- rewrite (Ns eq_refl) in *. specialize (Na eq_refl). subst pa. split.
           ++ unfold tidy, plain, paint, plain_place, paint_place, tidy_place, open_end. cbn. destruct (da <=? 1); reflexivity.
           ++ unfold tidy, plain, plain_place, tidy_place, open_end, zero. cbn. destruct (da <=? 1); destruct (first_label u); read_on.
        -- split.
           ++ unfold tidy, plain, paint, plain_place, paint_place, tidy_place, open_end. cbn. destruct Za as [-> | ->]; cbn; destruct (da <=? 1); cbn; try reflexivity;
                destruct (first_label u); try reflexivity; now specialize (Na eq_refl).
           ++ unfold tidy, plain, plain_place, tidy_place, open_end, zero. cbn. destruct (da <=? 1); destruct (first_label u); read_on.
      * split.
        -- unfold plain, paint, plain_place, paint_place. cbn. destruct Za as [-> | ->]; cbn; try reflexivity.
           destruct (first_label u); try reflexivity. now specialize (Na eq_refl).
        -- unfold plain, plain_place. cbn. destruct (first_label u); read_on.
    + (* Joined *)
      rewrite first_cons_solid, last_cons_solid by reflexivity. unfold well_read. rewrite first_cons_solid by reflexivity.
      specialize (Fit eq_refl).
      assert (Ag : agree (option_map (fun _ => label (last_label u)) pt) (Some x) = agree pt (Some 0) /\ (pt = Some 0 -> label (last_label u) = x)).
      { destruct Zt as [-> | ->]; [now split|]. cbn. destruct (near_label u) as [z|] eqn:Nz; [|now specialize (Nt eq_refl)].
        rewrite (near_last _ _ Nz). cbn [label]. specialize (Fit z eq_refl). assert (x = z) by now apply Fit. subst. split; [apply Nat.eqb_refl|reflexivity]. }
      destruct Ag as [Ag Ex].
      destruct b; cbn [take tip anchor same port deg paint paint_place].
      * rewrite Ag. unfold open_end, paint_place. cbn [deg]. destruct (dt <? 2) eqn:D; cbn [andb]; [|reflexivity].
        assert (At : agree pt (Some 0) = true) by (destruct Zt as [-> | ->]; reflexivity). rewrite At.
        destruct sm.
        -- rewrite (Ns eq_refl) in *. specialize (Na eq_refl). subst pa. rewrite (Nt (first_none_near _ (Ns eq_refl))). split.
           ++ unfold tidy, plain, paint, plain_place, paint_place, tidy_place, open_end. cbn. destruct (da <=? 1); reflexivity.
           ++ unfold tidy, plain, plain_place, tidy_place, open_end, zero. cbn. destruct (da <=? 1); destruct (first_label u); read_on.
        -- split.
           ++ unfold tidy, plain, paint, plain_place, paint_place, tidy_place, open_end. cbn.
              destruct Za as [-> | ->]; cbn; destruct (da <=? 1); cbn; try reflexivity;
                destruct (first_label u); try reflexivity; now specialize (Na eq_refl).
           ++ unfold tidy, plain, plain_place, tidy_place, open_end, zero. cbn. destruct (da <=? 1); destruct (first_label u); read_on.
      * split.
        -- unfold plain, paint, plain_place, paint_place. cbn. destruct Za as [-> | ->]; cbn; try reflexivity.
           destruct (first_label u); try reflexivity. now specialize (Na eq_refl).
        -- unfold plain, plain_place. cbn. destruct (first_label u); read_on.
    + rewrite first_cons_plain, last_cons_plain by reflexivity. unfold well_read. rewrite first_cons_plain by reflexivity.
      destruct b; [reflexivity|]. cbn [anchor tip same paint]. split.
      * unfold plain, paint, plain_place, paint_place. cbn. destruct Za as [-> | ->]; reflexivity.
      * unfold plain, plain_place. cbn. read_on.
Qed.

(** A colouring of an arc with labels is one of the letters, painted. *)
Theorem run_painted w : fitting w -> forall c,
  run (map real w) c = option_map (painted w) (arun (map fst w) c) /\
  (forall f v, arun (map fst w) c = Some (f, v) -> well_read w f /\ (w = [] -> f = outer)).
Proof.
  induction w as [|[l x] w IH]; intros Fit c.
  - destruct c; split; try reflexivity; try discriminate. intros f v E. injection E as <- <-. split; [|reflexivity].
    unfold well_read, zero. cbn. intuition congruence.
  - destruct c as [|b c]; [split; [reflexivity|discriminate]|]. specialize (IH (proj1 Fit) c). destruct IH as [IH1 IH2].
    unfold run, arun in *. cbn [map grun fst andb]. rewrite IH1. clear IH1.
    assert (N1 : null (map real w) = null w) by now destruct w. assert (N2 : null (map item_of (map fst w)) = null w) by now destruct w.
    rewrite N1, N2. destruct (grun true outer plain (map item_of (map fst w)) c) as [[f [n i]]|]; cbn [option_map]; [|split; [reflexivity|discriminate]].
    destruct (IH2 f (n, i) eq_refl) as [W O]. pose proof (enter_painted w l x b f Fit W O) as E. cbn zeta in E.
    unfold painted at 1. cbn [fst snd]. revert E. destruct (enter (null w) (item_of l) b f) as [g|]; intros E.
    + destruct E as [E W']. rewrite E. cbn [option_map]. split; [reflexivity|]. intros f' v Q. injection Q as <- <-. split; [exact W'|discriminate].
    + rewrite E. split; [reflexivity|discriminate].
Qed.
