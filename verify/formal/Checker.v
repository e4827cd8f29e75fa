(** * The checker, proved correct once for all patches

    For each colouring of the ports the checker visits all valid colourings before and all valid colourings after the
    operation. It sorts both by the *labels* of the port points, which say which ports are linked: of the colourings
    after with the same labels only the score of a best one matters, and all configurations with the same labels and
    the same answer can be judged together. Then every pair of groups is compared. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Table Drawing.

(** ** Grouping

    Each item of a list has a key and a value; a group is a key and a value above all values with that key. *)
Section Grouping.
  Context {K V : Type} (same : K -> K -> bool) (merge : V -> V -> V) (above : V -> V -> Prop).
  Hypothesis same_eq : forall a b, same a b = true -> a = b.
  Hypothesis above_refl : forall v, above v v.
  Hypothesis above_trans : forall u v w, above u v -> above v w -> above u w.
  Hypothesis merge_left : forall v w, above (merge v w) v.
  Hypothesis merge_right : forall v w, above (merge v w) w.

  Fixpoint add (k : K) (v : V) (gs : list (K * V)) : list (K * V) :=
    match gs with
    | [] => [(k, v)]
    | (k', v') :: r => if same k k' then (k', merge v v') :: r else (k', v') :: add k v r
    end.
  Definition groups (items : list (K * V)) : list (K * V) := fold_left (fun gs i => add (fst i) (snd i) gs) items [].

  Definition covered (gs : list (K * V)) (k : K) (v : V) : Prop := exists v', In (k, v') gs /\ above v' v.

  Lemma add_covers k v gs : covered (add k v gs) k v.
  Proof.
    induction gs as [|[k' v'] gs IH]; simpl.
    - exists v. split; [now left|apply above_refl].
    - destruct (same k k') eqn:E.
      + apply same_eq in E as <-. exists (merge v v'). split; [now left|apply merge_left].
      + destruct IH as (w & I & A). exists w. split; [now right|exact A].
  Qed.

  Lemma add_keeps k v gs l w : covered gs l w -> covered (add k v gs) l w.
  Proof.
    intros (x & I & A). induction gs as [|[k' v'] gs IH]; simpl; [destruct I|]. destruct I as [I|I].
    - injection I as -> ->. destruct (same k l) eqn:E.
      + exists (merge v x). split; [now left|]. eapply above_trans; [apply merge_right|exact A].
      + exists x. split; [now left|exact A].
    - destruct (same k k').
      + exists x. split; [now right|exact A].
      + destruct (IH I) as (y & J & B). exists y. split; [now right|exact B].
  Qed.

  Lemma groups_cover items k v : In (k, v) items -> covered (groups items) k v.
  Proof.
    unfold groups. generalize (@nil (K * V)).
    assert (W : forall its gs l w, covered gs l w -> covered (fold_left (fun gs i => add (fst i) (snd i) gs) its gs) l w).
    { induction its as [|i its IH]; intros gs l w C; [exact C|]. apply IH, add_keeps, C. }
    induction items as [|i items IH]; intros gs I; [destruct I|]. simpl. destruct I as [->|I]; [|now apply IH].
    apply W, add_covers.
  Qed.
End Grouping.

Fixpoint same_labels (l m : list nat) : bool :=
  match l, m with
  | [], [] => true
  | a :: l', b :: m' => (a =? b) && same_labels l' m'
  | _, _ => false
  end.
Fixpoint same_coloring (l m : coloring) : bool :=
  match l, m with
  | [], [] => true
  | a :: l', b :: m' => eqb a b && same_coloring l' m'
  | _, _ => false
  end.

Lemma same_labels_eq l : forall m, same_labels l m = true -> l = m.
Proof.
  induction l as [|a l IH]; intros [|b m] E; try discriminate; [reflexivity|]. apply andb_prop in E as [E F].
  apply Nat.eqb_eq in E as ->. f_equal. now apply IH.
Qed.
Lemma same_coloring_eq l : forall m, same_coloring l m = true -> l = m.
Proof.
  induction l as [|a l IH]; intros [|b m] E; try discriminate; [reflexivity|]. apply andb_prop in E as [E F].
  apply eqb_prop in E as ->. f_equal. now apply IH.
Qed.

(** ** Labels

    [refines l m]: ports with equal labels in [l] have equal labels in [m]. *)
Definition labels (k : nat) (st : state) : list nat := map snd (firstn k st).
Fixpoint refines_head (a b : nat) (l m : list nat) : bool :=
  match l, m with
  | a' :: l', b' :: m' => (if a =? a' then b =? b' else true) && refines_head a b l' m'
  | _, _ => true
  end.
Fixpoint refines (l m : list nat) : bool :=
  match l, m with
  | a :: l', b :: m' => refines_head a b l' m' && refines l' m'
  | _, _ => true
  end.

Definition below (k : nat) (l m : nat -> nat) : Prop := forall i j, i < k -> j < k -> l i = l j -> m i = m j.

Lemma refines_head_ok a b l : forall m, length l = length m ->
  (refines_head a b l m = true <-> forall i, i < length l -> a = nth i l 0 -> b = nth i m 0).
Proof.
  induction l as [|a' l IH]; intros [|b' m] Len; try discriminate; simpl in *; [split; [lia|reflexivity]|].
  injection Len as Len. rewrite andb_true_iff, (IH m Len). split.
  - intros [H T] [|i] Hi; [intros ->; rewrite Nat.eqb_refl in H; now apply Nat.eqb_eq|apply T; lia].
  - intros H. split; [|intros i Hi; apply (H (S i)); lia].
    destruct (Nat.eqb_spec a a'); [|reflexivity]. apply Nat.eqb_eq. apply (H 0); [lia|assumption].
Qed.

Lemma refines_ok l : forall m, length l = length m ->
  (refines l m = true <-> below (length l) (fun i => nth i l 0) (fun i => nth i m 0)).
Proof.
  unfold below. induction l as [|a l IH]; intros [|b m] Len; try discriminate; simpl in *; [split; [lia|reflexivity]|].
  injection Len as Len. rewrite andb_true_iff, (IH m Len), (refines_head_ok a b l m Len). split.
  - intros [H T] [|i] [|j] Hi Hj E; auto.
    + apply H; [lia|exact E]. + symmetry. apply H; [lia|now symmetry]. + apply T; (lia || exact E).
  - intros H. split.
    + intros i Hi E. apply (H 0 (S i)); (lia || exact E).
    + intros i j Hi Hj E. apply (H (S i) (S j)); (lia || exact E).
Qed.

Lemma labels_length k st : k <= length st -> length (labels k st) = k.
Proof. intros H. unfold labels. rewrite map_length, firstn_length. lia. Qed.

Lemma labels_nth k st i : i < k -> k <= length st -> nth i (labels k st) 0 = label_in st i.
Proof.
  intros Hi Hk. unfold labels, label_in. change 0 with (snd (2, 0)) at 1. rewrite map_nth. f_equal.
  rewrite <- (firstn_skipn k st) at 2. rewrite app_nth1; [reflexivity|]. rewrite firstn_length. lia.
Qed.

(** ** Scores *)
Definition alone (k : nat) (st : state) : nat := length (filter (fun n : nat * nat => fst n =? 0) (skipn k st)).
Definition score := (nat * nat)%type.
Definition good (v w : score) : bool := (fst w <? fst v) || ((fst v =? fst w) && (snd v <=? snd w)).

Lemma good_spec v w : good v w = true <-> fst w < fst v \/ (fst w = fst v /\ snd v <= snd w).
Proof.
  unfold good. rewrite orb_true_iff, andb_true_iff, Nat.ltb_lt, Nat.eqb_eq, Nat.leb_le. intuition.
Qed.

Definition better (v w : score) : score := if good v w then v else w.
Definition is_good (v w : score) : Prop := good v w = true.
Lemma is_good_refl v : is_good v v.
Proof. apply good_spec. lia. Qed.
Lemma is_good_trans u v w : is_good u v -> is_good v w -> is_good u w.
Proof. unfold is_good. rewrite !good_spec. lia. Qed.
Lemma better_left v w : is_good (better v w) v.
Proof. unfold better. destruct (good v w) eqn:E; [apply is_good_refl|]. unfold is_good. destruct (good w v) eqn:F; [reflexivity|].
  apply not_true_iff_false in E, F. rewrite good_spec in E, F. lia. Qed.
Lemma better_right v w : is_good (better v w) w.
Proof. unfold better. destruct (good v w) eqn:E; [exact E|apply is_good_refl]. Qed.

(** The groups after: which ports are linked, and the best score. *)
Definition groups_after (k : nat) (leaves : list leaf) : list (list nat * score) :=
  groups same_labels better
    (flat_map (fun l => match l with Some (n, st, _) => [(labels k st, (n, alone k st))] | None => [] end) leaves).

(** The groups before: which ports are linked and the answer; the most solid edges and the fewest isolated triangles. *)
Definition same_case (a b : list nat * coloring) : bool :=
  same_labels (fst a) (fst b) && same_coloring (snd a) (snd b).
Definition extremes (v w : score) : score := (Nat.max (fst v) (fst w), Nat.min (snd v) (snd w)).
Definition extreme (v w : score) : Prop := fst w <= fst v /\ snd v <= snd w.
Definition groups_before (k : nat) (leaves : list leaf) : list (list nat * coloring * score) :=
  groups same_case extremes
    (flat_map (fun l => match l with Some (n, st, Answer x) => [((labels k st, x), (n, alone k st))] | _ => [] end) leaves).

Definition answered (l : leaf) : bool := match l with Some (_, _, Answer _) => true | _ => false end.

(** ** The checker *)
Section Checker.
  Variable p : patch.
  (** At most N more strips and M more isolated triangles. *)
  Variables strips lonely : nat.
  (** What else is to be checked of (ports, labels before, answer): the reduced tables, in [Rows.v]. *)
  Variable also : coloring -> list nat -> coloring -> bool.

  Let k := ports p.
  Definition size (d : side) : nat := length (owner d) + triangles d.

  Definition judge (s : coloring) (start : state) (after_groups : list (list nat * score))
      (g : list nat * coloring * score) : bool :=
    let '(l, x, (most, fewest)) := g in
    (length x =? length (inner (after p))) &&
    match draw (inner_edges (after p)) x start with
    | None => false
    | Some st =>
        let v := (solids x, alone k st) in
        refines (labels k st) l &&
        forallb (fun h => good v (snd h) || negb (refines (fst h) l)) after_groups &&
        (triangles (after p) + most <=? triangles (before p) + fst v + strips) &&
        (snd v <=? fewest + lonely) &&
        also s l x
    end.

  Definition check_ports (s : coloring) (t : trie) : bool :=
    match draw (port_edges (before p)) s (blank (size (before p))) with
    | None => silent t
    | Some start0 =>
        let leaves := walk (inner_edges (before p)) start0 0 t [] in
        forallb answered leaves &&
        match draw (port_edges (after p)) s (blank (size (after p))) with
        | None => match leaves with [] => true | _ => false end
        | Some start1 =>
            let after_groups := groups_after k (walk (inner_edges (after p)) start1 0 Nothing []) in
            forallb (judge s start1 after_groups) (groups_before k leaves)
        end
    end.

  Fixpoint for_all_ports (n : nat) (s : coloring) (t : trie) : bool :=
    match n with
    | 0 => check_ports (rev s) t
    | S n' => for_all_ports n' (false :: s) (branch false t) && for_all_ports n' (true :: s) (branch true t)
    end.

  (** Is the patch well formed? *)
  Definition well_formed_side (d : side) : bool :=
    (length (owner d) =? k) && forallb (fun t => t <? triangles d) (owner d) &&
    forallb (fun e => (fst e <? triangles d) && (snd e <? triangles d)) (inner d).
  Definition check (t : trie) : bool :=
    well_formed_side (before p) && well_formed_side (after p) && for_all_ports k [] t.

  (** ** Its correctness *)
  Lemma inside_ports d : well_formed_side d = true -> inside (size d) (port_edges d).
  Proof.
    unfold well_formed_side, inside, port_edges, size. rewrite !andb_true_iff, !forallb_forall. intros [[_ O] _] [i t] I.
    pose proof (in_combine_l _ _ _ _ I) as Hi. apply in_combine_r in I. apply in_seq in Hi.
    apply in_map_iff in I as (u & <- & Hu). apply O, Nat.ltb_lt in Hu. simpl. lia.
  Qed.
  Lemma inside_inner d : well_formed_side d = true -> inside (size d) (inner_edges d).
  Proof.
    unfold well_formed_side, inside, inner_edges, size. rewrite !andb_true_iff, !forallb_forall. intros [_ E] e I.
    apply in_map_iff in I as (f & <- & Hf). apply E in Hf. apply andb_prop in Hf as [A B].
    apply Nat.ltb_lt in A, B. simpl. lia.
  Qed.

  Lemma drawing_perm d s x : Permutation (solid (inner_edges d) x ++ solid (port_edges d) s) (drawing d s x).
  Proof. apply Permutation_app_comm. Qed.

  Lemma draw_ports d s : well_formed_side d = true ->
    match draw (port_edges d) s (blank (size d)) with
    | Some st => describes (size d) st (solid (port_edges d) s) /\ valid (solid (port_edges d) s)
    | None => ~ valid (solid (port_edges d) s)
    end.
  Proof.
    intros W. pose proof (draw_ok (size d) (port_edges d) s _ _ (describes_blank _) valid_nil (inside_ports d W)) as D.
    now rewrite app_nil_r in D.
  Qed.

  Lemma alone_isolated d st s x : length (owner d) = k -> describes (size d) st (drawing d s x) ->
    alone k st = isolated d s x.
  Proof.
    intros O (L & D & _). unfold alone, isolated. rewrite O. unfold size in *.
    assert (E : skipn k st = map (fun t => nth (k + t) st (2, 0)) (seq 0 (triangles d))).
    { apply nth_ext with (d := (2, 0)) (d' := nth (k + 0) st (2, 0)).
      - rewrite skipn_length, map_length, seq_length. lia.
      - intros n Hn. rewrite skipn_length in Hn.
        rewrite (map_nth (fun t => nth (k + t) st (2, 0))). rewrite seq_nth by lia. simpl.
        rewrite <- (firstn_skipn k st) at 2. rewrite app_nth2; rewrite firstn_length; [|lia]. f_equal. lia. }
    rewrite E. clear E. assert (B : forall t, In t (seq 0 (triangles d)) -> t < triangles d).
    { intros t Ht. apply in_seq in Ht. lia. }
    revert B. induction (seq 0 (triangles d)) as [|t l IH]; intros B; [reflexivity|]. simpl.
    specialize (D (k + t)). unfold degree_in in D. rewrite D by (specialize (B t (or_introl eq_refl)); lia).
    destruct (degree (drawing d s x) (k + t) =? 0); simpl; [f_equal|]; apply IH; intros u Hu; apply B; now right.
  Qed.

  Lemma labels_below d0 st0 G0 d1 st1 G1 : length (owner d0) = k -> length (owner d1) = k ->
    describes (size d0) st0 G0 -> describes (size d1) st1 G1 ->
    (refines (labels k st1) (labels k st0) = true <->
     forall i j, i < k -> j < k -> linked G1 i j -> linked G0 i j).
  Proof.
    intros O0 O1 (L0 & _ & K0) (L1 & _ & K1). unfold size in *.
    rewrite refines_ok by (rewrite !labels_length; lia). rewrite labels_length by lia. unfold below.
    split; intros H i j Hi Hj; specialize (H i j Hi Hj).
    - intros L. apply K0; [lia|lia|]. rewrite !labels_nth in H by lia. apply H. apply K1; (lia || exact L).
    - rewrite !labels_nth by lia. intros E. apply K0; [lia|lia|]. apply H. apply K1; (lia || exact E).
  Qed.

  (** What the theorem says of one configuration. *)
  Definition sound_at (s c : coloring) (answer : option coloring) : Prop :=
    (valid (drawing (before p) s c) -> exists x, answer = Some x /\ best p s c x /\
       triangles (after p) + solids c <= triangles (before p) + solids x + strips /\
       isolated (after p) s x <= isolated (before p) s c + lonely /\
       exists st, describes (size (before p)) st (drawing (before p) s c) /\ also s (labels k st) x = true) /\
    (~ valid (drawing (before p) s c) -> answer = None).

  Lemma check_ports_ok s t : well_formed_side (before p) = true -> well_formed_side (after p) = true ->
    check_ports s t = true -> forall c, length c = length (inner (before p)) -> sound_at s c (find t c).
  Proof.
    intros W0 W1 C c Lc. unfold check_ports in C. pose proof (draw_ports (before p) s W0) as D0.
    pose proof (draw_ports (after p) s W1) as D1.
    assert (O0 : length (owner (before p)) = k) by reflexivity.
    assert (O1 : length (owner (after p)) = k).
    { unfold well_formed_side in W1. rewrite !andb_true_iff in W1. apply Nat.eqb_eq. tauto. }
    destruct (draw (port_edges (before p)) s (blank (size (before p)))) as [start0|].
    2: { split; [|intros _; now apply silent_find]. intros V. exfalso. apply D0.
         apply valid_suffix with (solid (inner_edges (before p)) c).
         eapply valid_perm; [symmetry; apply drawing_perm|exact V]. }
    destruct D0 as [D0 V0]. apply andb_prop in C as [A C]. rewrite forallb_forall in A.
    assert (Li : length c = length (inner_edges (before p))) by (unfold inner_edges; now rewrite map_length).
    destruct (walk_ok (size (before p)) (inner_edges (before p)) c start0 _ 0 t [] D0 V0 (inside_inner _ W0) Li) as [Wv Wn].
    split.
    2: { intros NV. destruct Wn as [I|F]; [|apply A in I; discriminate|exact F].
         intros V. apply NV. eapply valid_perm; [apply drawing_perm|exact V]. }
    intros V. destruct Wv as (st0 & I & Ds0); [eapply valid_perm; [symmetry; apply drawing_perm|exact V]|].
    eapply describes_perm in Ds0; [|apply drawing_perm].
    assert (N : exists x, fold_left (fun u b => branch b u) c t = Answer x).
    { apply A in I. simpl in I. destruct (fold_left (fun u b => branch b u) c t); try discriminate. now eexists. }
    destruct N as [x E]. exists x. split.
    { pose proof (find_app t c []) as F. rewrite app_nil_r in F. rewrite F, E. reflexivity. }
    rewrite E in I.
    destruct (draw (port_edges (after p)) s (blank (size (after p)))) as [start1|].
    2: { destruct (walk (inner_edges (before p)) start0 0 t []); [destruct I|discriminate]. }
    destruct D1 as [D1 V1]. rewrite forallb_forall in C.
    destruct (groups_cover same_case extremes extreme) with
      (items := flat_map (fun l => match l with Some (n, st, Answer x) => [((labels k st, x), (n, alone k st))] | _ => [] end)
                  (walk (inner_edges (before p)) start0 0 t []))
      (k := (labels k st0, x)) (v := (solids c, alone k st0)) as ([most fewest] & J & [Mo Fe]).
    { intros [l y] [m z] Q. apply andb_prop in Q as [Q R]. simpl in *. f_equal; [now apply same_labels_eq|now apply same_coloring_eq]. }
    { intros v. split; lia. }
    { unfold extreme. lia. }
    { unfold extreme, extremes. simpl. lia. }
    { unfold extreme, extremes. simpl. lia. }
    { apply in_flat_map. exists (Some (0 + solids c, st0, Answer x)). split; [exact I|]. now left. }
    apply C in J. unfold judge in J. apply andb_prop in J as [Lx J]. apply Nat.eqb_eq in Lx.
    pose proof (draw_ok (size (after p)) (inner_edges (after p)) x start1 _ D1 V1 (inside_inner _ W1)) as Dx.
    destruct (draw (inner_edges (after p)) x start1) as [st1|]; [|discriminate]. destruct Dx as [Ds1 Vx].
    rewrite !andb_true_iff in J. destruct J as [[[[R F] S] T] X]. simpl in Mo, Fe, S, T. apply Nat.leb_le in S, T.
    eapply describes_perm in Ds1; [|apply drawing_perm]. eapply valid_perm in Vx; [|apply drawing_perm].
    pose proof (alone_isolated _ _ _ _ O1 Ds1) as I1. pose proof (alone_isolated _ _ _ _ O0 Ds0) as I0.
    split.
    - split.
      + split; [exact Lx|]. split; [exact Vx|]. now apply (labels_below _ _ _ _ _ _ O0 O1 Ds0 Ds1).
      + intros y (Ly & Vy & Py). rewrite forallb_forall in F.
        assert (Liy : length y = length (inner_edges (after p))) by (unfold inner_edges; now rewrite map_length).
        destruct (walk_ok (size (after p)) (inner_edges (after p)) y start1 _ 0 Nothing [] D1 V1 (inside_inner _ W1) Liy)
          as [Wy _].
        destruct Wy as (sty & Iy & Dsy); [eapply valid_perm; [symmetry; apply drawing_perm|exact Vy]|].
        eapply describes_perm in Dsy; [|apply drawing_perm].
        destruct (groups_cover same_labels better is_good) with
          (items := flat_map (fun l => match l with Some (n, st, _) => [(labels k st, (n, alone k st))] | None => [] end)
                      (walk (inner_edges (after p)) start1 0 Nothing []))
          (k := labels k sty) (v := (solids y, alone k sty)) as (w & Jw & Gw);
          [exact same_labels_eq|exact is_good_refl|exact is_good_trans|exact better_left|exact better_right| |].
        { apply in_flat_map. eexists. split; [exact Iy|]. now left. }
        apply F in Jw. simpl in Jw. apply orb_prop in Jw as [Jw|Jw].
        * pose proof (is_good_trans _ _ _ Jw Gw) as Q. apply good_spec in Q. simpl in Q.
          rewrite I1, (alone_isolated _ _ _ _ O1 Dsy) in Q. exact Q.
        * apply (labels_below _ _ _ _ _ _ O0 O1 Ds0 Dsy) in Py. rewrite Py in Jw. discriminate.
    - split; [lia|]. split; [lia|]. exists st0. split; [exact Ds0|exact X].
  Qed.

  Lemma for_all_ports_ok n : well_formed_side (before p) = true -> well_formed_side (after p) = true ->
    forall s t, for_all_ports n s t = true -> forall r c, length r = n -> length c = length (inner (before p)) ->
    sound_at (rev s ++ r) c (find t (r ++ c)).
  Proof.
    intros W0 W1. induction n as [|n IH]; intros s t F r c Lr Lc; simpl in F.
    - destruct r; [|discriminate]. rewrite app_nil_r. simpl. now apply check_ports_ok.
    - apply andb_prop in F as [F0 F1]. destruct r as [|b r]; [discriminate|]. injection Lr as Lr. simpl.
      destruct b; [specialize (IH _ _ F1 r c Lr Lc)|specialize (IH _ _ F0 r c Lr Lc)]; simpl in IH;
        rewrite <- app_assoc in IH; exact IH.
  Qed.

  Theorem check_ok t : check t = true -> forall s c, length s = ports p -> length c = length (inner (before p)) ->
    sound_at s c (lookup t s c).
  Proof.
    intros C s c Ls Lc. unfold check in C. rewrite !andb_true_iff in C. destruct C as [[W0 W1] F].
    exact (for_all_ports_ok k W0 W1 [] t F s c Ls Lc).
  Qed.

  Corollary check_correct t : check t = true -> correct p (lookup t).
  Proof.
    intros C s c Ls Lc. destruct (check_ok t C s c Ls Lc) as [V N]. split; [|exact N].
    intros H. destruct (V H) as (x & E & B & _). now exists x.
  Qed.

  (** Validity is decidable: the checker decides it. *)
  Lemma valid_or_not d s x : well_formed_side d = true -> valid (drawing d s x) \/ ~ valid (drawing d s x).
  Proof.
    intros W. pose proof (draw_ports d s W) as D. destruct (draw (port_edges d) s (blank (size d))) as [st|].
    - destruct D as [D V]. pose proof (draw_ok (size d) (inner_edges d) x st _ D V (inside_inner d W)) as E.
      destruct (draw (inner_edges d) x st).
      + left. eapply valid_perm; [apply drawing_perm|apply E].
      + right. intros Q. apply E. eapply valid_perm; [symmetry; apply drawing_perm|exact Q].
    - right. intros Q. apply D. apply valid_suffix with (solid (inner_edges d) x).
      eapply valid_perm; [symmetry; apply drawing_perm|exact Q].
  Qed.

  Corollary check_within t : check t = true -> within p (lookup t) strips lonely.
  Proof.
    intros C s c x Ls Lc E. destruct (check_ok t C s c Ls Lc) as [V N].
    assert (W : well_formed_side (before p) = true) by (unfold check in C; rewrite !andb_true_iff in C; tauto).
    destruct (valid_or_not (before p) s c W) as [H|H]; [|rewrite (N H) in E; discriminate].
    destruct (V H) as (y & F & _ & S & A & _). rewrite E in F. injection F as <-. now split.
  Qed.
End Checker.

(** ** One drawing by itself

    Where there are few colourings, or little to be asked of them, each is drawn from the beginning. *)
(** Ports first; [None] when it is not valid. *)
Definition drawn (d : side) (s x : coloring) : option state :=
  match draw (port_edges d) s (blank (size d)) with Some st => draw (inner_edges d) x st | None => None end.
Lemma drawn_ok p d s x : well_formed_side p d = true ->
  match drawn d s x with
  | Some st => describes (size d) st (drawing d s x) /\ valid (drawing d s x)
  | None => ~ valid (drawing d s x)
  end.
Proof.
  intros W. unfold drawn. pose proof (draw_ports p d s W) as D.
  destruct (draw (port_edges d) s (blank (size d))) as [st|].
  - destruct D as [D V]. pose proof (draw_ok (size d) (inner_edges d) x st _ D V (inside_inner p d W)) as E.
    destruct (draw (inner_edges d) x st) as [st'|].
    + destruct E as [E F]. split; [eapply describes_perm|eapply valid_perm]; try apply drawing_perm; assumption.
    + intros Q. apply E. eapply valid_perm; [symmetry; apply drawing_perm|exact Q].
  - intros Q. apply D. apply valid_suffix with (solid (inner_edges d) x).
    eapply valid_perm; [symmetry; apply drawing_perm|exact Q].
Qed.

(** The labels before are given; legal or not? *)
Definition legalb (p : patch) (l : list nat) (s x : coloring) : bool :=
  (length x =? length (inner (after p))) &&
  match drawn (after p) s x with Some st => refines (labels (ports p) st) l | None => false end.
Lemma legalb_ok p s c x st : well_formed_side p (before p) = true -> well_formed_side p (after p) = true ->
  describes (size (before p)) st (drawing (before p) s c) -> (legalb p (labels (ports p) st) s x = true <-> legal p s c x).
Proof.
  intros W0 W1 D. unfold legalb, legal, sound. rewrite andb_true_iff, Nat.eqb_eq.
  pose proof (drawn_ok p (after p) s x W1) as E. destruct (drawn (after p) s x) as [st'|].
  - destruct E as [E V].
    assert (O1 : length (owner (after p)) = ports p).
    { unfold well_formed_side in W1. rewrite !andb_true_iff, Nat.eqb_eq in W1. tauto. }
    rewrite (labels_below p (before p) st _ (after p) st' _ eq_refl O1 D E). tauto.
  - split; [intros [_ F]; discriminate|]. intros (_ & V & _). contradiction.
Qed.

Fixpoint all_colorings (n : nat) : list coloring :=
  match n with 0 => [[]] | S n' => map (cons false) (all_colorings n') ++ map (cons true) (all_colorings n') end.
Lemma all_colorings_ok n : forall c, In c (all_colorings n) <-> length c = n.
Proof.
  induction n as [|n IH]; intros c; simpl.
  - destruct c; simpl; intuition discriminate.
  - rewrite in_app_iff, !in_map_iff. split.
    + intros [(d & <- & I)|(d & <- & I)]; simpl; f_equal; now apply IH.
    + destruct c as [|[|] c]; simpl; intros E; try discriminate; injection E as E; [right|left]; exists c;
        (split; [reflexivity|now apply IH]).
Qed.
