(** * Finitely many classes, whatever the size

    A fan is drawn along its routes before and after the operation at the same time. What matters of the part drawn so far
    is the frontier before and, for each frontier after, the best score; and of these only the differences, and which
    labels are equal. So there are finitely many classes, and what holds at the end of each holds for fans of every
    size. *)
Require Import Arith Bool List Permutation ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Route Serves Entries.

(** ** Arrows: what is drawn next before and after, from one stage to another *)
Definition template := (kind * bool)%type.
Definition step_from (p : option nat) (t : template) : step :=
  let p' := if snd t then p else None in
  match fst t with put => Put p' | next => Next p' | mark => Mark p' | chord => Chord end.
Record arrow := Arrow { from : nat; to : nat; ported : bool; drawn_before : list template; drawn_after : list template }.

(** The pairs of routes that the arrows allow. *)
Inductive path (arrows : list arrow) : nat -> list step -> list step -> Prop :=
| path_start : path arrows 0 [] []
| path_on a p B A : In a arrows -> path arrows (from a) B A -> (ported a = false -> p = None) ->
    path arrows (to a) (B ++ map (step_from p) (drawn_before a)) (A ++ map (step_from p) (drawn_after a)).

(** ** Classes *)
Record cls := Cls { stage : nat; bef : frontier; aft : scores }.
Definition class_labels (x : cls) : list nat := labels_of (bef x) ++ all_labels (aft x).

(** Every colouring of the edges of a few steps. *)
Fixpoint ways (ss : list step) (f : frontier) (n i : nat) : list (frontier * score) :=
  match ss with
  | [] => [(f, (n, i))]
  | s :: r =>
      match take s false f with Some g => ways r g n (i + left_alone s false f) | None => [] end ++
      match take s true f with Some g => ways r g (S n) (i + left_alone s true f) | None => [] end
  end.

Definition code_place (x : place) : N := (N.of_nat (deg x) + 4 * match port x with None => 0 | Some l => N.of_nat (S l) end)%N.
Definition code_frontier (f : frontier) : N := ((if same f then 1 else 0) + 2 * (code_place (anchor f) + 32 * code_place (tip f)))%N.

(** An order of the entries, by their shapes first: numbers compared one after the other. *)
Definition label_key (p : option nat) : nat := match p with None => 0 | Some l => S l end.
Definition shape_key (f : frontier) : list nat :=
  [deg (anchor f); deg (tip f); if same f then 1 else 0; Nat.min 1 (label_key (port (anchor f))); Nat.min 1 (label_key (port (tip f)));
   label_key (port (anchor f)); label_key (port (tip f))].
Fixpoint in_order (k l : list nat) : bool :=
  match k, l with x :: k', y :: l' => if x =? y then in_order k' l' else x <? y | _, _ => true end.

Fixpoint put_in (e : @entry unit) (D : scores) : scores :=
  match D with
  | [] => [e]
  | x :: r => if in_order (shape_key (fst (fst e))) (shape_key (fst (fst x))) then e :: D else x :: put_in e r
  end.
Definition sorted (D : scores) : scores := fold_right put_in [] D.
Lemma put_in_same e D x : In x (put_in e D) <-> In x (e :: D).
Proof.
  induction D as [|d D IH]; [reflexivity|]. cbn [put_in]. destruct (in_order (shape_key (fst (fst e))) (shape_key (fst (fst d)))); [reflexivity|].
  simpl in *. rewrite IH. tauto.
Qed.
Lemma sorted_same D x : In x (sorted D) <-> In x D.
Proof. induction D as [|d D IH]; [reflexivity|]. simpl. rewrite put_in_same. simpl. now rewrite IH. Qed.

Definition lower (h : score -> nat) (m : nat) (e : @entry unit) : nat := Nat.min m (h (snd (fst e))).
Definition least (h : score -> nat) (D : scores) : nat :=
  match D with [] => 0 | e :: r => fold_left (lower h) r (h (snd (fst e))) end.
Lemma lower_low h l : forall m, fold_left (lower h) l m <= m /\ forall g w u, In (g, w, u) l -> fold_left (lower h) l m <= h w.
Proof.
  induction l as [|e l IH]; intros m; [split; [simpl; lia|intros ? ? ? []]|]. cbn [fold_left]. destruct (IH (lower h m e)) as [A B].
  assert (L : lower h m e <= m /\ lower h m e <= h (snd (fst e))) by (unfold lower; lia). split; [lia|].
  intros g w u [->|I]; [cbn [fst snd] in L; lia|exact (B g w u I)].
Qed.
Lemma least_low h D g w u : In (g, w, u) D -> least h D <= h w.
Proof.
  destruct D as [|e D]; intros I; [destruct I|]. cbn [least]. destruct (lower_low h D (h (snd (fst e)))) as [A B].
  destruct I as [->|I]; [exact A|exact (B g w u I)].
Qed.

(** What has to be kept of the entries, in order. *)
Definition kept (D : scores) : scores := sorted (prune [] D).
Lemma kept_stands A D h tS tI : stands_for A D h tS tI -> stands_for A (kept D) h tS tI.
Proof. intros St. apply stands_same with (prune [] D); [intros e; symmetry; apply sorted_same|now apply stands_pruned]. Qed.
Lemma kept_labels D : incl (all_labels (kept D)) (all_labels D).
Proof.
  intros l I. apply in_flat_map in I as ([[g' w] u] & I & J). apply sorted_same, prune_incl in I. eauto using in_all_labels.
Qed.

(** The class of what has been drawn, and by how much its scores have been lowered. *)
Definition class_of (q : nat) (f : frontier) (D0 : scores) : cls * score :=
  let ls := nodup Nat.eq_dec (labels_of f ++ all_labels D0) in
  let mS := least fst D0 in
  let mI := least snd D0 in
  (Cls q (relabel (index ls) f) (sorted (map (lowered ls mS mI) D0)), (mS, mI)).

(** ** What a class stands for

    The solid edges after are at least [oS] more than those before, counted from the lowest entry of the class; the isolated
    triangles at most [oI] more. *)
Definition meets (A : list step) (f : frontier) (n i : nat) (x : cls) (oS oI : Z) : Prop :=
  exists h tS tI, tells h (class_labels x) /\ f = relabel h (bef x) /\ stands_for A (aft x) h tS tI /\
    (oS + Z.of_nat n <= Z.of_nat tS)%Z /\ (Z.of_nat tI <= oI + Z.of_nat i)%Z.

Lemma index_tells ls h x y : tells h ls -> In x ls -> In y ls -> h x = h y -> index ls x = index ls y.
Proof. intros T X Y E. now rewrite (T x y X Y E). Qed.

Lemma class_meets A f n i q g D h tS tI (oS oI : Z) : tells h (labels_of g ++ all_labels D) -> f = relabel h g -> stands_for A D h tS tI ->
  (oS + Z.of_nat n <= Z.of_nat tS)%Z -> (Z.of_nat tI <= oI + Z.of_nat i)%Z ->
  let '(x, (mS, mI)) := class_of q g D in meets A f n i x (oS + Z.of_nat mS) (oI + Z.of_nat mI) /\ stage x = q.
Proof.
  intros T E St0 HS HI. unfold class_of. rename D into D0.
  set (ls := nodup Nat.eq_dec (labels_of g ++ all_labels D0)). set (mS := least fst D0). set (mI := least snd D0). split; [|reflexivity].
  assert (Ls : forall l, In l (labels_of g ++ all_labels D0) <-> In l ls) by (intros l; symmetry; apply nodup_In).
  assert (Tl : tells h ls).
  { intros x y X Y. apply T; now apply Ls. }
  exists (fun l => h (nth l ls 0)), (tS + mS), (tI + mI). cbn [bef aft class_labels]. split; [|split; [|split; [|lia]]].
  - assert (W : forall l, In l (class_labels (Cls q (relabel (index ls) g) (sorted (map (lowered ls mS mI) D0)))) ->
      exists l', In l' ls /\ l = index ls l').
    { intros l I. unfold class_labels in I. cbn [bef aft] in I. apply in_app_or in I as [I|I].
      - rewrite labels_relabel in I. apply in_map_iff in I as (l' & <- & I). exists l'. split; [|reflexivity]. apply Ls, in_or_app. now left.
      - apply in_flat_map in I as ([[g' w] u] & I & J). apply sorted_same, in_map_iff in I as ([[g'' w'] u'] & Q & I). injection Q as <- _ _.
        cbn [fst] in J. rewrite labels_relabel in J. apply in_map_iff in J as (l' & <- & J). exists l'. split; [|reflexivity].
        apply Ls, in_or_app. right. eauto using in_all_labels. }
    intros x y X Y Q. apply W in X as (x' & X & ->). apply W in Y as (y' & Y & ->). rewrite !index_nth in Q by assumption.
    now apply (index_tells ls h).
  - rewrite relabel_comp, E. apply relabel_ext. intros l I. rewrite index_nth; [reflexivity|]. apply Ls, in_or_app. now left.
  - apply stands_same with (map (lowered ls mS mI) D0); [intros e; symmetry; apply sorted_same|]. apply stands_lowered; [|intros g' w u I|exact St0].
    + intros l I. apply Ls, in_or_app. now right.
    + split; [apply (least_low fst D0 g' w u I)|apply (least_low snd D0 g' w u I)].
Qed.

(** ** A few steps before *)
Lemma play_relabel h ss : forall c f n i, tells h (labels_of f ++ flat_map step_labels ss) ->
  play (map (relabel_step h) ss) c (relabel h f) n i = option_map (fun r => (relabel h (fst r), snd r)) (play ss c f n i).
Proof.
  induction ss as [|s ss IH]; intros [|b c] f n i T; try reflexivity. cbn [map play flat_map] in *.
  assert (Ts : tells h (labels_of f ++ step_labels s)) by (intros x y X Y; apply T; rewrite !in_app_iff in *; tauto).
  rewrite take_relabel by exact Ts. destruct (take s b f) as [g|] eqn:E; [|reflexivity]. cbn [option_map]. rewrite left_alone_relabel.
  apply IH. pose proof (take_labels _ _ _ _ E) as L. intros x y X Y. apply T; rewrite app_assoc; apply in_or_app;
    [apply in_app_or in X as [X|X]|apply in_app_or in Y as [Y|Y]]; auto.
Qed.
Lemma play_labels ss : forall c f n i g v, play ss c f n i = Some (g, v) -> incl (labels_of g) (labels_of f ++ flat_map step_labels ss).
Proof.
  induction ss as [|s ss IH]; intros [|b c] f n i g v P; try discriminate; cbn [play flat_map] in *.
  - injection P as -> _. apply incl_appl, incl_refl.
  - destruct (take s b f) as [f'|] eqn:E; [|discriminate]. apply IH in P. intros l I. apply P in I. rewrite app_assoc.
    apply in_app_or in I as [I|I]; apply in_or_app; [left; now apply (take_labels _ _ _ _ E)|now right].
Qed.
Lemma play_ways ss : forall c f n i n0 i0 g v, play ss c f (n0 + n) (i0 + i) = Some (g, v) ->
  exists w, In (g, w) (ways ss f n i) /\ v = (n0 + fst w, i0 + snd w).
Proof.
  induction ss as [|s ss IH]; intros [|b c] f n i n0 i0 g v P; try discriminate; cbn [play ways] in *.
  - injection P as <- <-. exists (n, i). split; [now left|reflexivity].
  - destruct (take s b f) as [f'|] eqn:E; [|discriminate].
    rewrite <- Nat.add_assoc in P. destruct b.
    + rewrite <- Nat.add_succ_r in P. apply IH in P as (w & I & Q). exists w. split; [|exact Q]. rewrite E. apply in_or_app. now right.
    + apply IH in P as (w & I & Q). exists w. split; [|exact Q]. rewrite E. apply in_or_app. now left.
Qed.

(** ** One arrow *)
Definition letters (x : cls) : list (option nat) := let ls := class_labels x in None :: Some (S (list_max ls)) :: map Some (nodup Nat.eq_dec ls).
Definition letter_for (x : cls) (a : arrow) : list (option nat) := if ported a then letters x else [None].
(** All classes that follow, with their bounds. *)
Definition bounded := (cls * (Z * Z))%type.
Definition follow (a : arrow) (b : bounded) : list bounded :=
  let '(x, (oS, oI)) := b in
  flat_map (fun p =>
    let D := kept (extends note (map (step_from p) (drawn_after a)) (aft x)) in
    map (fun r : frontier * score => let '(g, (n, i)) := r in
        let '(y, (mS, mI)) := class_of (to a) g D in (y, (oS + Z.of_nat mS - Z.of_nat n, oI + Z.of_nat mI - Z.of_nat i)%Z))
      (ways (map (step_from p) (drawn_before a)) (bef x) 0 0))
    (letter_for x a).

Lemma step_from_relabel h p t : step_from (option_map h p) t = relabel_step h (step_from p t).
Proof. destruct t as [[| | |] [|]]; reflexivity. Qed.
Lemma template_labels p ts : incl (flat_map step_labels (map (step_from p) ts)) (label_list p).
Proof.
  intros l I. apply in_flat_map in I as (s & I & J). apply in_map_iff in I as (t & <- & _). destruct t as [[| | |] [|]]; exact J || destruct J.
Qed.

(** A port of the fan is one of the labels of the class, or a new one. *)
Lemma letter_found x a h p : tells h (class_labels x) -> (ported a = false -> p = None) ->
  exists p' h', In p' (letter_for x a) /\ p = option_map h' p' /\ tells h' (class_labels x ++ label_list p') /\
    forall l, In l (class_labels x) -> h' l = h l.
Proof.
  intros T N. destruct p as [v|].
  2: { exists None, h. repeat split; auto. - unfold letter_for. destruct (ported a); now left. - now rewrite app_nil_r. }
  assert (O : ported a = true) by (destruct (ported a); [reflexivity|discriminate (N eq_refl)]). unfold letter_for. rewrite O. unfold letters.
  destruct (in_dec Nat.eq_dec v (map h (class_labels x))) as [I|I].
  - apply in_map_iff in I as (l & <- & I). exists (Some l), h. split; [right; right; apply in_map; now apply nodup_In|]. repeat split; auto.
    intros y z Y Z. apply T; [apply in_app_or in Y as [Y|[<-|[]]]|apply in_app_or in Z as [Z|[<-|[]]]]; assumption.
  - set (new := S (list_max (class_labels x))).
    assert (F : forall l, In l (class_labels x) -> l <> new).
    { intros l J ->. pose proof (proj1 (list_max_le (class_labels x) (list_max (class_labels x))) (le_n _)) as M.
      rewrite Forall_forall in M. apply M in J. unfold new in J. lia. }
    exists (Some new), (fun l => if l =? new then v else h l). split; [right; now left|]. split; [cbn; now rewrite Nat.eqb_refl|]. split.
    + intros y z Y Z. cbn [label_list] in *. rewrite in_app_iff in Y, Z. simpl in Y, Z.
      destruct (Nat.eqb_spec y new) as [->|Ny], (Nat.eqb_spec z new) as [->|Nz]; intros E; auto.
      * exfalso. apply I. rewrite E. apply in_map. destruct Z as [Z|[Z|[]]]; congruence.
      * exfalso. apply I. rewrite <- E. apply in_map. destruct Y as [Y|[Y|[]]]; congruence.
      * apply T; [destruct Y as [Y|[Y|[]]]|destruct Z as [Z|[Z|[]]]|]; congruence.
    + intros l J. destruct (Nat.eqb_spec l new) as [->|]; [now contradiction (F new J)|reflexivity].
Qed.

Lemma stands_ext A D h h' tS tI : (forall l, In l (all_labels D) -> h' l = h l) -> stands_for A D h tS tI -> stands_for A D h' tS tI.
Proof.
  intros E [So Co]. assert (R : forall g w u, In (g, w, u) D -> relabel h' g = relabel h g).
  { intros g w u I. apply relabel_ext. intros l J. apply E. eauto using in_all_labels. }
  split.
  - intros g w u I. rewrite (R g w u I). now apply So with u.
  - intros c f v P. destruct (Co c f v P) as (g & w & u & I & G). exists g, w, u. split; [exact I|]. now rewrite (R g w u I).
Qed.

Lemma follow_meets A f n i x oS oI a p c f' n' i' : meets A f n i x oS oI -> (ported a = false -> p = None) ->
  play (map (step_from p) (drawn_before a)) c f n i = Some (f', (n', i')) ->
  exists y pS pI, In (y, (pS, pI)) (follow a (x, (oS, oI))) /\ stage y = to a /\
    meets (A ++ map (step_from p) (drawn_after a)) f' n' i' y pS pI.
Proof.
  intros (h & tS & tI & T & E & St & HS & HI) Np P.
  destruct (letter_found x a h p T Np) as (p' & h' & Ip & Ep & T' & Eh).
  assert (Ef : f = relabel h' (bef x)).
  { rewrite E. apply relabel_ext. intros l I. symmetry. apply Eh, in_or_app. now left. }
  apply (stands_ext _ _ _ h') in St; [|intros l I; apply Eh, in_or_app; now right].
  assert (Em : forall ts, map (step_from p) ts = map (relabel_step h') (map (step_from p') ts)).
  { intros ts. rewrite map_map. apply map_ext. intros t. rewrite Ep. apply step_from_relabel. }
  assert (Tb : tells h' (labels_of (bef x) ++ flat_map step_labels (map (step_from p') (drawn_before a)))).
  { intros y z Y Z. apply T'; unfold class_labels; rewrite !in_app_iff in *; [destruct Y as [Y|Y]|destruct Z as [Z|Z]];
      auto; right; eapply template_labels; eassumption. }
  assert (Ta : tells h' (all_labels (aft x) ++ flat_map step_labels (map (step_from p') (drawn_after a)))).
  { intros y z Y Z. apply T'; unfold class_labels; rewrite !in_app_iff in *; [destruct Y as [Y|Y]|destruct Z as [Z|Z]];
      auto; right; eapply template_labels; eassumption. }
  rewrite Em, Ef, play_relabel in P by exact Tb.
  destruct (play (map (step_from p') (drawn_before a)) c (bef x) n i) as [[g v]|] eqn:Q; [|discriminate]. injection P as <- ->.
  pose proof (play_labels _ _ _ _ _ _ _ Q) as Lg. rewrite <- (Nat.add_0_r n), <- (Nat.add_0_r i) in Q.
  apply play_ways in Q as ([dn di] & Iw & Ev). injection Ev as -> ->. cbn [fst snd].
  destruct (stands_extends _ _ _ _ _ _ Ta St) as [Sx Lx]. rewrite <- Em in Sx. apply kept_stands in Sx.
  set (D := kept (extends note (map (step_from p') (drawn_after a)) (aft x))) in *.
  assert (Tg : tells h' (labels_of g ++ all_labels D)).
  { assert (W : forall l, In l (labels_of g ++ all_labels D) -> In l (class_labels x ++ label_list p')).
    { intros l I. unfold class_labels. rewrite !in_app_iff. apply in_app_or in I as [I|I].
      - apply Lg, in_app_or in I as [I|I]; auto. right. eapply template_labels, I.
      - apply kept_labels, Lx, in_app_or in I as [I|I]; auto. right. eapply template_labels, I. }
    intros y z Y Z. apply T'; now apply W. }
  pose proof (class_meets (A ++ map (step_from p) (drawn_after a)) (relabel h' g) (n + dn) (i + di) (to a) g D h' tS tI
    (oS - Z.of_nat dn) (oI - Z.of_nat di) Tg eq_refl Sx ltac:(lia) ltac:(lia)) as M.
  destruct (class_of (to a) g D) as [y [mS mI]] eqn:Ec. destruct M as [M Sy].
  exists y, (oS + Z.of_nat mS - Z.of_nat dn)%Z, (oI + Z.of_nat mI - Z.of_nat di)%Z. split; [|split; [exact Sy|]].
  - unfold follow. apply in_flat_map. exists p'. split; [exact Ip|]. fold D. apply in_map_iff. exists (g, (dn, di)). split; [|exact Iw]. now rewrite Ec.
  - replace (oS + Z.of_nat mS - Z.of_nat dn)%Z with (oS - Z.of_nat dn + Z.of_nat mS)%Z by lia.
    replace (oI + Z.of_nat mI - Z.of_nat di)%Z with (oI - Z.of_nat di + Z.of_nat mI)%Z by lia. exact M.
Qed.
