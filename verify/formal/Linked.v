(** * Linked rules: the best in this mesh

    Linked rules are chosen when it is known what the strips do outside the patch. For each colouring of the ports there is a
    list of alternatives, best first, each with the pairs of ports that it joins inside. The rule is the first
    alternative that is valid in the given world. Proved here: it is the best possible in *this* world,
    and its pairs and those that the outside joins are all one must know to find it. *)
Require Import Arith Bool List NArith Permutation Lia.
Import ListNotations.
Require Number.
Require Import Statements Graph Locality Table Drawing Checker Rows.
Export Beside.

(** ** Lists as they are printed

    Numbers of four hexadecimal digits. For each colouring of the ports in ascending order: how many alternatives, then
    for each its recolouring and the partners of the ports, p_0 in the lowest digit. A port without a partner has itself. *)
Definition pairs_of (high low : N) : graph :=
  let partner i := N.to_nat (N.land (N.shiftr (if i <? 4 then low else high) (4 * N.of_nat (i mod 4))) 15) in
  filter (fun e => fst e <? snd e) (map (fun i => (i, partner i)) (seq 0 8)).
Fixpoint lists_from (width : nat) (l : list N) (more : nat) (so_far : list alternative) : list (list alternative) :=
  match l with
  | [] => []
  | n :: l' =>
      match more with
      | 0 => lists_from width l' (N.to_nat n) []
      | S m =>
          match l' with
          | high :: low :: l'' =>
              let next := Alternative (coloring_of width n) (pairs_of high low) :: so_far in
              match m with 0 => rev next :: lists_from width l'' 0 [] | _ => lists_from width l'' m next end
          | _ => []
          end
      end
  end.
Definition lists_of (width : nat) (texts : list Number.uint) : list (list alternative) :=
  lists_from width (flat_map read texts) 0 [].

Fixpoint mask (s : coloring) : nat := match s with [] => 0 | b :: r => (if b then 1 else 0) + 2 * mask r end.
Definition list_for (ls : list (list alternative)) (s : coloring) : list alternative := nth (mask s) ls [].

(** ** The checker *)
Section Checker.
  Variable p : patch.
  Let k := ports p.
  Variable L : coloring -> list alternative.

  Definition enter (start : state) (a : alternative) : list nat * score :=
    match draw (inner_edges (after p)) (recoloring a) start with
    | Some st => (labels k st, (solids (recoloring a), alone k st))
    | None => ([], (0, 0))
    end.
  Fixpoint in_order (scores : list score) : bool :=
    match scores with v :: (w :: _) as r => good v w && in_order r | _ => true end.
  Fixpoint distinct (l : list nat) : bool :=
    match l with [] => true | a :: r => negb (existsb (Nat.eqb a) r) && distinct r end.
  (** Do the pairs link the ports with equal labels, and no others? *)
  Definition pairs_ok (l : list nat) (P : graph) : bool :=
    forallb (fun e => (fst e <? k) && (snd e <? k)) P &&
    match draw P (map (fun _ => true) P) (blank k) with
    | Some st => refines (labels k st) l && refines l (labels k st)
    | None => false
    end.

  Definition alternative_ok (start : state) (a : alternative) : bool :=
    (length (recoloring a) =? length (inner (after p))) &&
    match draw (inner_edges (after p)) (recoloring a) start with
    | Some st => pairs_ok (labels k st) (pairs a)
    | None => false
    end.
  (** The alternatives are valid by themselves and in order of preference, one of them joins nothing, and for every
      valid colouring there is one that is as good and joins nothing else. *)
  Definition check_list (s : coloring) : bool :=
    match draw (port_edges (after p)) s (blank (size (after p))) with
    | None => false
    | Some start =>
        let entries := map (enter start) (L s) in
        forallb (alternative_ok start) (L s) && in_order (map snd entries) &&
        existsb (fun v => distinct (fst v)) entries &&
        forallb (fun h => existsb (fun v => good (snd v) (snd h) && refines (fst v) (fst h)) entries)
          (groups_after k (walk (inner_edges (after p)) start 0 Nothing []))
    end.
  Definition check_lists : bool :=
    well_formed_side p (before p) && well_formed_side p (after p) && forallb check_list (all_colorings k).

  (** ** Its correctness *)
  Lemma valid_decided G : valid G \/ ~ valid G.
  Proof.
    induction G as [|[a b] G IH]; [left; apply valid_nil|]. rewrite valid_cons.
    destruct IH as [V|V]; [|tauto]. destruct (linked_or_not G a b); [tauto|].
    destruct (le_dec (degree G a) 1), (le_dec (degree G b) 1); tauto.
  Qed.

  Lemma first_exists {A} (ok : A -> Prop) l b : (forall a, ok a \/ ~ ok a) -> In b l -> ok b ->
    exists a, first_that ok l a.
  Proof.
    intros D. induction l as [|x l IH]; intros I H; [destruct I|]. destruct (D x) as [X|X].
    - exists x, [], l. split; [reflexivity|]. split; [exact X|]. intros c [].
    - destruct I as [->|I]; [contradiction|]. destruct (IH I H) as (a & l1 & l2 & -> & G & N).
      exists a, (x :: l1), l2. split; [reflexivity|]. split; [exact G|]. intros c [<-|C]; auto.
  Qed.

  Lemma in_order_ok {A} (f : A -> score) l1 a l2 b : in_order (map f (l1 ++ a :: l2)) = true -> In b l2 ->
    is_good (f a) (f b).
  Proof.
    induction l1 as [|x l1 IH].
    - simpl app. revert a. induction l2 as [|y l2 IH]; intros a O I; [destruct I|].
      change (good (f a) (f y) && in_order (map f (y :: l2)) = true) in O. apply andb_prop in O as [G O].
      destruct I as [<-|I]; [exact G|]. apply is_good_trans with (f y); [exact G|]. now apply IH.
    - intros O. apply IH. destruct l1 as [|z l1]; simpl in O |- *; apply andb_prop in O; tauto.
  Qed.

  Lemma distinct_ok l : distinct l = true -> NoDup l.
  Proof.
    induction l as [|a l IH]; simpl; intros D; constructor; apply andb_prop in D as [N D]; [|now apply IH].
    intros I. apply negb_true_iff in N. assert (E : existsb (Nat.eqb a) l = true); [|congruence].
    apply existsb_exists. exists a. split; [exact I|apply Nat.eqb_refl].
  Qed.

  Hypothesis checked : check_lists = true.
  Let W0 : well_formed_side p (before p) = true.
  Proof. unfold check_lists in checked. rewrite !andb_true_iff in checked. tauto. Qed.
  Let W1 : well_formed_side p (after p) = true.
  Proof. unfold check_lists in checked. rewrite !andb_true_iff in checked. tauto. Qed.
  Let S0 : sensible p (before p).
  Proof. now apply well_formed_sensible. Qed.
  Let S1 : sensible p (after p).
  Proof. now apply well_formed_sensible. Qed.
  Let owners : length (owner (after p)) = k.
  Proof. apply S1. Qed.

  Lemma list_checked s : length s = k -> check_list s = true.
  Proof.
    intros Ls. unfold check_lists in checked. rewrite !andb_true_iff, forallb_forall in checked.
    apply checked. now apply all_colorings_ok.
  Qed.

  (** Of two colourings after, the one that links no ports but those that the other one links is safe where that is. *)
  Lemma safe_after s x y O : length x = length (inner (after p)) -> valid (drawing (after p) s x) ->
    (forall i j, i < k -> j < k -> linked (drawing (after p) s x) i j -> linked (drawing (after p) s y) i j) ->
    rest_of_mesh p O -> valid (O ++ drawing (after p) s y) -> valid (O ++ drawing (after p) s x).
  Proof.
    intros Lx Vx J R V.
    assert (E : ports (Patch (after p) (after p)) = ports p) by exact owners.
    assert (S : sensible (Patch (after p) (after p)) (after p)) by (destruct S1 as (A & B & C); now split; [rewrite E|split]).
    apply (legal_is_safe (Patch (after p) (after p)) S S s y x O); [|intros e I|exact V].
    - split; [exact Lx|]. split; [exact Vx|]. intros i j. rewrite E. simpl. apply J.
    - apply R in I. rewrite E. simpl. lia.
  Qed.

  Theorem lists_best : linked_best p L.
  Proof.
    intros s c O Ls Lc R V. pose proof (list_checked s Ls) as C. unfold check_list in C.
    pose proof (draw_ports p (after p) s W1) as D1.
    destruct (draw (port_edges (after p)) s (blank (size (after p)))) as [start|]; [|discriminate].
    destruct D1 as [D1 V1]. rewrite !andb_true_iff in C. destruct C as [[[Ok Order] Nothing_joined] Complete].
    rewrite forallb_forall in Ok, Complete.
    assert (Known : forall a, In a (L s) -> length (recoloring a) = length (inner (after p)) /\ exists st,
      enter start a = (labels k st, (solids (recoloring a), isolated (after p) s (recoloring a))) /\
      describes (size (after p)) st (drawing (after p) s (recoloring a)) /\ valid (drawing (after p) s (recoloring a))).
    { intros a I. apply Ok in I. unfold alternative_ok in I. apply andb_prop in I as [La I]. apply Nat.eqb_eq in La.
      split; [exact La|]. unfold enter.
      pose proof (draw_ok (size (after p)) (inner_edges (after p)) (recoloring a) start _ D1 V1 (inside_inner p _ W1)) as E.
      destruct (draw (inner_edges (after p)) (recoloring a) start) as [st|]; [|discriminate]. destruct E as [Ds Va].
      eapply describes_perm in Ds; [|apply drawing_perm]. eapply valid_perm in Va; [|apply drawing_perm].
      exists st. split; [|now split].
      now replace (isolated (after p) s (recoloring a)) with (alone k st) by exact (alone_isolated p (after p) st s _ owners Ds). }
    assert (Safe : forall a y, In a (L s) -> valid (O ++ drawing (after p) s y) ->
      (forall i j, i < k -> j < k -> linked (drawing (after p) s (recoloring a)) i j -> linked (drawing (after p) s y) i j) ->
      valid (O ++ drawing (after p) s (recoloring a))).
    { intros a y I Vy J. destruct (Known a I) as (La & st & _ & _ & Va). now apply safe_after with y. }
    (* The alternative that joins nothing is valid in every world. *)
    assert (Some_valid : exists b, In b (L s) /\ valid (O ++ drawing (after p) s (recoloring b))).
    { apply existsb_exists in Nothing_joined as (v & I & N). apply in_map_iff in I as (b & <- & I).
      destruct (Known b I) as (Lb & st & E & Ds & Vb). exists b. split; [exact I|].
      apply (legal_is_safe p S0 S1 s c); [|exact R|exact V]. split; [exact Lb|]. split; [exact Vb|].
      rewrite E in N. apply distinct_ok in N. intros i j Hi Hj J.
      assert (Size : k <= length st) by (destruct Ds as [-> _]; unfold size; rewrite owners; lia).
      assert (Q : i = j); [|subst; apply here].
      apply (proj1 (NoDup_nth (labels k st) 0) N); rewrite ?labels_length; try assumption.
      rewrite !labels_nth by assumption. apply Ds; [..|exact J]; unfold size; rewrite owners; lia. }
    destruct Some_valid as (b & Ib & Vb).
    destruct (first_exists (fun b => valid (O ++ drawing (after p) s (recoloring b))) (L s) b) as (a & First);
      [intros a; apply valid_decided|exact Ib|exact Vb|].
    exists a. split; [exact First|]. destruct First as (l1 & l2 & E & _ & N).
    assert (Ia : In a (L s)) by (rewrite E; apply in_or_app; right; now left).
    split; [apply (Known a Ia)|]. intros y Ly Vy.
    assert (Liy : length y = length (inner_edges (after p))) by (unfold inner_edges; now rewrite map_length).
    destruct (walk_ok (size (after p)) (inner_edges (after p)) y start _ 0 Nothing [] D1 V1 (inside_inner p _ W1) Liy) as [Wy _].
    destruct Wy as (sty & Iy & Dsy).
    { eapply valid_perm; [symmetry; apply drawing_perm|]. exact (valid_suffix _ _ Vy). }
    eapply describes_perm in Dsy; [|apply drawing_perm].
    destruct (groups_cover same_labels better is_good) with
      (items := flat_map (fun l => match l with Some (n, st, _) => [(labels k st, (n, alone k st))] | None => [] end)
                  (walk (inner_edges (after p)) start 0 Nothing []))
      (k := labels k sty) (v := (solids y, alone k sty)) as (w & Jw & Gw);
      [exact same_labels_eq|exact is_good_refl|exact is_good_trans|exact better_left|exact better_right| |].
    { apply in_flat_map. eexists. split; [exact Iy|]. now left. }
    apply Complete in Jw. apply existsb_exists in Jw as (v & Iv & G). apply in_map_iff in Iv as (d & <- & Id).
    destruct (Known d Id) as (Ld & std & Ed & Dsd & Vd). rewrite Ed in G. simpl in G. apply andb_prop in G as [G Rf].
    pose proof (Safe d y Id Vy (proj1 (labels_below p _ _ _ _ _ _ owners owners Dsy Dsd) Rf)) as Vdo.
    assert (Gad : is_good (snd (enter start a)) (snd (enter start d))).
    { rewrite E in Id. apply in_app_or in Id as [Id|[<-|Id]].
      - exfalso. exact (N d Id Vdo). - apply is_good_refl.
      - apply (in_order_ok (fun a => snd (enter start a)) l1 a l2 d); [|exact Id].
        rewrite <- E. rewrite map_map in Order. exact Order. }
    rewrite Ed in Gad. destruct (Known a Ia) as (_ & sta & Ea & _ & _). rewrite Ea in Gad. simpl in Gad.
    pose proof (is_good_trans _ _ _ (is_good_trans _ _ _ Gad G) Gw) as Q. apply good_spec in Q. simpl in Q.
    replace (alone k sty) with (isolated (after p) s y) in Q by (symmetry; exact (alone_isolated p (after p) sty s y owners Dsy)).
    exact Q.
  Qed.

  Lemma solid_all (P : graph) : solid P (map (fun _ => true) P) = P.
  Proof. induction P as [|e P IH]; simpl; [reflexivity|now rewrite IH]. Qed.

  (** Some number above all vertices of a graph. *)
  Lemma bounded (G : graph) : exists m, forall e, In e G -> fst e < m /\ snd e < m.
  Proof.
    induction G as [|[a b] G (m & B)]; [exists 0; intros e []|]. exists (S (a + b + m)). intros e [<-|I]; simpl; [lia|].
    apply B in I. lia.
  Qed.

  Theorem lists_tell : pairs_tell p L.
  Proof.
    intros s c O Q a Ls Lc R V (Qk & Qa & Ql) Ia. pose proof (list_checked s Ls) as C. unfold check_list in C.
    pose proof (draw_ports p (after p) s W1) as D1.
    destruct (draw (port_edges (after p)) s (blank (size (after p)))) as [start|]; [|discriminate].
    destruct D1 as [D1 V1]. rewrite !andb_true_iff in C. destruct C as [[[Ok _] _] _]. rewrite forallb_forall in Ok.
    apply Ok in Ia. unfold alternative_ok in Ia. apply andb_prop in Ia as [_ Ia].
    pose proof (draw_ok (size (after p)) (inner_edges (after p)) (recoloring a) start _ D1 V1 (inside_inner p _ W1)) as E.
    destruct (draw (inner_edges (after p)) (recoloring a) start) as [st|]; [|discriminate]. destruct E as [Ds Va].
    eapply describes_perm in Ds; [|apply drawing_perm]. eapply valid_perm in Va; [|apply drawing_perm].
    set (I := drawing (after p) s (recoloring a)) in *.
    unfold pairs_ok in Ia. apply andb_prop in Ia as [Pk Ia]. rewrite forallb_forall in Pk.
    assert (Pk' : forall e, In e (pairs a) -> fst e < k /\ snd e < k).
    { intros e J. apply Pk, andb_prop in J as [A B]. now apply Nat.ltb_lt in A, B. }
    pose proof (draw_ok k (pairs a) (map (fun _ => true) (pairs a)) (blank k) [] (describes_blank k) valid_nil Pk') as DP.
    destruct (draw (pairs a) (map (fun _ => true) (pairs a)) (blank k)) as [stp|]; [|discriminate].
    rewrite solid_all, app_nil_r in DP. destruct DP as [(Lp & _ & Kp) Vp]. apply andb_prop in Ia as [R1 R2].
    assert (Sz : k <= length st) by (destruct Ds as [-> _]; unfold size; rewrite owners; lia).
    assert (Lab : forall i j, i < k -> j < k -> (linked (pairs a) i j <-> linked I i j)).
    { intros i j Hi Hj. rewrite refines_ok in R1, R2 by (rewrite !labels_length; lia). unfold below in R1, R2.
      rewrite labels_length in R1, R2 by lia. specialize (R1 i j Hi Hj). specialize (R2 i j Hi Hj).
      rewrite !labels_nth in R1, R2 by lia. destruct Ds as (_ & _ & Ki).
      rewrite <- (Kp i j Hi Hj), <- (Ki i j) by (unfold size; rewrite owners; lia). tauto. }
    (* Degrees take care of themselves: ports are kept. *)
    assert (Deg : forall v, degree (O ++ I) v <= 2).
    { intros v. destruct V as [D _]. specialize (D v). rewrite degree_app in *.
      destruct (le_lt_dec k v) as [Hk|Hk].
      - destruct (le_lt_dec (k + Nat.max (triangles (before p)) (triangles (after p))) v) as [Hs|Hs].
        + unfold I. rewrite (degree_far p (after p)) by (assumption || apply Nat.le_max_r). lia.
        + rewrite (degree_outer p O v R) by (unfold within_patch; lia). apply Va.
      - unfold I. rewrite (degree_point p) in * by (assumption || apply S0 || exact owners). exact D. }
    assert (Ao : acyclic O).
    { destruct V as [_ A]. apply (acyclic_perm _ (drawing (before p) s c ++ O)) in A; [|apply Permutation_app_comm].
      clear - A. induction (drawing (before p) s c) as [|[u w] G IH]; [exact A|]. simpl in A. apply acyclic_cons in A. tauto. }
    (* First the inside is replaced by its pairs, then the outside. *)
    assert (Inside : acyclic (O ++ I) <-> acyclic (O ++ pairs a)).
    { set (sz := k + Nat.max (triangles (before p)) (triangles (after p))).
      assert (I0 : in_patch k sz I) by (apply (drawing_inside p); [exact S1|apply Nat.le_max_r]).
      assert (I1 : in_patch k sz (pairs a)) by (intros e J; apply Pk' in J; unfold sz; lia).
      assert (Out : outer k sz O) by exact R.
      split; apply (swap_acyclic k sz); try assumption; try (intros i j Hi Hj; apply Lab; assumption); [apply Vp|apply Va]. }
    destruct (bounded (O ++ Q)) as (m & B).
    assert (Outside : acyclic (pairs a ++ O) <-> acyclic (pairs a ++ Q)).
    { assert (O0 : in_patch k m O) by (intros e J; apply B, in_or_app; now left).
      assert (Q0 : in_patch k m Q) by (intros e J; apply B, in_or_app; now right).
      assert (Out : outer k m (pairs a)) by (intros e J; apply Pk' in J; unfold within_patch; lia).
      split; apply (swap_acyclic k m); try assumption; intros i j Hi Hj; apply Ql; assumption. }
    rewrite <- Outside. unfold valid. rewrite Inside.
    assert (Perm : acyclic (O ++ pairs a) <-> acyclic (pairs a ++ O)) by (split; apply acyclic_perm, Permutation_app_comm).
    rewrite Perm. tauto.
  Qed.
End Checker.
