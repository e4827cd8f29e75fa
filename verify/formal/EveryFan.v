(** * Fans of every size

    The tables end at k = 8. What [Fold.v] keeps, step by step along the route of [Route.v], is an answer for every k; this
    file proves it [correct], in the sense of [Statements.v], for all six families of fans, every k and every position. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Strips Locality Drawing Checker Rows Symmetry Frontier Fold Route.

(** The side [d] is drawn along the shape [sh]; [m], [r] and [q] say in which order the inner edges are met. *)
Record drawn_along (d : side) (k : nat) (sh : shape) (m r q : nat) : Prop := Along {
  owners : owner d = seq 0 k;
  enough : k <= triangles d;
  edges_inside : forall e, In e (inner d) -> fst e < triangles d /\ snd e < triangles d;
  all_drawn : Permutation (triangles_of sh) (seq 0 (triangles d));
  first : starts sh;
  parts : length (inner d) = m + r + q;
  edges_met : forall a t, map undirected (tl (joins a t sh)) = map undirected (arranged m r (inner d))
}.

Lemma along_plays d k sh m r q s lab x : drawn_along d k sh m r q -> length s = k -> length x = length (inner d) ->
  match play (map (step_of k s lab) sh) (choices m r x) blank_frontier 0 0 with
  | Some (f, (n, i)) => allowed k lab (drawing d s x) /\ n = solids x /\ i + at_end f = isolated d s x + 2
  | None => ~ allowed k lab (drawing d s x)
  end.
Proof. intros [H1 H2 H3 H4 H5 H6 H7] Ls Lx. now apply (route_plays d k sh m r q). Qed.

Lemma along_well_formed p d sh m r q : drawn_along d (ports p) sh m r q -> well_formed_side p d = true.
Proof.
  intros [H1 H2 H3 _ _ _ _]. unfold well_formed_side. rewrite H1, seq_length, Nat.eqb_refl, !andb_true_iff, !forallb_forall.
  repeat split.
  - intros t I. apply in_seq in I. apply Nat.ltb_lt. lia.
  - intros e I. apply H3 in I. rewrite !(proj2 (Nat.ltb_lt _ _)); tauto.
Qed.

(** The answer: a best way along the route after the operation, the ports labelled by how they are linked before. *)
Definition fold_table (p : patch) (sh : shape) (m q : nat) : table := fun s c =>
  match drawn (before p) s c with
  | Some st => option_map (fun l => arranged m q (tl l)) (best_coloring (map (step_of (ports p) s (label_in st)) sh))
  | None => None
  end.

Section Patch.
  Variables (p : patch) (sh : shape) (m r q : nat).
  Hypotheses (W : well_formed_side p (before p) = true) (A : drawn_along (after p) (ports p) sh m r q).

  Lemma allowed_legal st s c x : describes (size (before p)) st (drawing (before p) s c) -> length x = length (inner (after p)) ->
    (allowed (ports p) (label_in st) (drawing (after p) s x) <-> legal p s c x).
  Proof.
    intros (_ & _ & K) L. unfold allowed, legal, sound.
    assert (E : forall i j, i < ports p -> j < ports p -> (label_in st i = label_in st j <-> linked (drawing (before p) s c) i j)).
    { intros i j Hi Hj. apply K; unfold size, ports in *; lia. }
    split.
    - intros [V B]. split; [exact L|]. split; [exact V|]. intros i j Hi Hj I. apply E; auto.
    - intros (_ & V & B). split; [exact V|]. intros i j Hi Hj I. apply E; auto.
  Qed.

  Lemma shape_size : length sh = S (length (inner (after p))).
  Proof. destruct A as [H1 H2 H3 H4 H5 H6 H7]. eapply (shape_length (after p) sh m r q); eassumption. Qed.

  Lemma all_dashed ss : forall f n i, exists v, play ss (repeat false (length ss)) f n i = Some v.
  Proof.
    induction ss as [|s ss IH]; intros f n i; [now eexists|]. cbn [length repeat play].
    assert (T : exists g, take s false f = Some g) by (destruct s; eexists; reflexivity). destruct T as (g & ->). apply IH.
  Qed.

  (** Every colouring that can be played belongs to a recolouring. *)
  Lemma played s lab c v : play (map (step_of (ports p) s lab) sh) c blank_frontier 0 0 = Some v ->
    let x := arranged m q (tl c) in length x = length (inner (after p)) /\ choices m r x = c.
  Proof.
    intros P. pose proof (play_length _ _ _ _ _ _ P) as L. rewrite map_length, shape_size in L.
    destruct A as [_ _ _ _ (t & l & E & _) Pa _]. rewrite E in P. destruct c as [|b c]; [discriminate|].
    cbn [map play] in P. unfold step_of at 1 in P. cbn [fst take] in P. destruct b; [discriminate|]. cbn [tl]. injection L as L.
    split.
    - rewrite Pa in *. rewrite (arranged_length c m q r) by lia. lia.
    - unfold choices. f_equal. apply arranged_back with (q := r). lia.
  Qed.

  Theorem fold_best s c st : length s = ports p -> describes (size (before p)) st (drawing (before p) s c) ->
    exists x, option_map (fun l => arranged m q (tl l)) (best_coloring (map (step_of (ports p) s (label_in st)) sh)) = Some x /\
      best p s c x.
  Proof.
    intros Ls D. set (ss := map (step_of (ports p) s (label_in st)) sh). unfold best_coloring.
    destruct (extends_right ss) as [Es Ec]. pose proof (best_entry_ok (extends remember ss blank_entries)) as B.
    destruct (best_entry (extends remember ss blank_entries)) as [[[f [n i]] h]|].
    - destruct B as [I B]. apply Es in I. cbn [option_map snd]. eexists. split; [reflexivity|].
      destruct (played _ _ _ _ I) as [Lx Ex]. set (x := arranged m q (tl (rev h))) in *.
      pose proof (along_plays _ _ _ _ _ _ s (label_in st) x A Ls Lx) as P. fold ss in P. rewrite Ex, I in P.
      destruct P as (Al & En & Ei). split; [now apply (allowed_legal st)|]. intros y Ly.
      pose proof Ly as (Lly & _ & _). apply (allowed_legal st s c y D Lly) in Ly.
      pose proof (along_plays _ _ _ _ _ _ s (label_in st) y A Ls Lly) as P. fold ss in P.
      destruct (play ss (choices m r y) blank_frontier 0 0) as [[g [n' i']]|] eqn:Q; [|contradiction].
      destruct P as (_ & En' & Ei'). apply Ec in Q as ([n'' i''] & h' & J & G). apply B in J. unfold is_good in *.
      rewrite good_spec in *. cbn [finished fst snd] in *. unfold as_good. lia.
    - destruct (all_dashed ss blank_frontier 0 0) as ([f v] & P). apply Ec in P as (w & h & I & _). rewrite B in I. destruct I.
  Qed.

  Theorem fold_correct : correct p (fold_table p sh m q).
  Proof.
    intros s c Ls Lc. pose proof (drawn_ok p (before p) s c W) as D. unfold fold_table.
    destruct (drawn (before p) s c) as [st|]; [|tauto]. destruct D as [D V]. split; [|contradiction]. intros _.
    now apply fold_best.
  Qed.
  Theorem fold_safe : safe p (fold_table p sh m q).
  Proof.
    apply correct_safe; [now apply well_formed_sensible|eapply well_formed_sensible, along_well_formed, A|exact fold_correct].
  Qed.
End Patch.

(** ** The routes

    First [l1], whose last triangle is the anchor, then [l2], at whose end the chord may lead back to the anchor, then [l3],
    from whose end the ring may be closed. *)
Definition route (l1 l2 l3 : list nat) (chorded closed : bool) : shape :=
  match l1 with [] => [] | x :: l => (put, x) :: map (pair next) l end ++
  match l2 with [] => [] | y :: l => (mark, y) :: map (pair next) l end ++
  (if chorded then [(chord, 0)] else []) ++ map (pair next) l3 ++ (if closed then [(chord, 0)] else []).
Definition side_of (n k : nat) (l1 l2 l3 : list nat) (chorded closed : bool) : side :=
  let a := last l1 0 in
  Side n (path_edges (l1 ++ l2 ++ l3 ++ if closed then [a] else []) ++ if chorded then [(a, last l2 0)] else []) (seq 0 k).

Lemma triangles_app sh sh' : triangles_of (sh ++ sh') = triangles_of sh ++ triangles_of sh'.
Proof. induction sh as [|[[| | |] n] sh IH]; simpl; auto; now rewrite IH. Qed.
Lemma triangles_next l : triangles_of (map (pair next) l) = l.
Proof. induction l as [|n l IH]; simpl; [reflexivity|]. now rewrite IH. Qed.
Lemma last_cons (l : list nat) : forall x y, last (x :: l) y = last l x.
Proof. induction l as [|a l IH]; intros x y; [reflexivity|]. change (last (a :: l) y = last (a :: l) x). now rewrite !IH. Qed.
Lemma last_in (l : list nat) : forall x, In (last l x) (x :: l).
Proof. induction l as [|a l IH]; intros x; [now left|]. right. rewrite last_cons. apply IH. Qed.
Lemma joins_next l : forall a t rest, joins a t (map (pair next) l ++ rest) = path_edges (t :: l) ++ joins a (last l t) rest.
Proof.
  induction l as [|n l IH]; intros a t rest; [reflexivity|]. rewrite last_cons. cbn [map app joins]. now rewrite IH.
Qed.
Lemma last_default (l : list nat) x y : l <> [] -> last l x = last l y.
Proof. induction l as [|a [|b l] IH]; intros N; [contradiction|reflexivity|]. apply IH. discriminate. Qed.
Lemma path_edges_join l x l' : path_edges (l ++ x :: l') = path_edges (l ++ [x]) ++ path_edges (x :: l').
Proof. induction l as [|a [|b l] IH]; [reflexivity|reflexivity|]. cbn [app path_edges] in *. now rewrite IH. Qed.
Lemma path_edges_snoc l x y : path_edges (x :: l ++ [y]) = path_edges (x :: l) ++ [(last l x, y)].
Proof.
  revert x. induction l as [|a l IH]; intros x; [reflexivity|]. cbn [app path_edges] in *. rewrite IH. now rewrite last_cons.
Qed.
Lemma path_edges_bound l n : (forall t, In t l -> t < n) -> forall e, In e (path_edges l) -> fst e < n /\ snd e < n.
Proof.
  induction l as [|x [|y l] IH]; intros B e I; try destruct I. 2: { apply IH; [intros t J; apply B; now right|assumption]. }
  subst e. split; apply B; [now left|right; now left].
Qed.

Section Route.
  Variables (n k x y : nat) (l1 l2 l3 : list nat) (chorded closed : bool).
  (** The anchor is the last triangle of the first part. *)
  Let p1 := x :: l1.
  Let p2 := y :: l2.
  Let q : nat := if chorded then 1 else 0.
  Let e : nat := if closed then 1 else 0.

  Hypotheses (enough : k <= n) (all : Permutation (p1 ++ p2 ++ l3) (seq 0 n)).

  Lemma route_triangles : triangles_of (route p1 p2 l3 chorded closed) = p1 ++ p2 ++ l3.
  Proof.
    unfold route, p1, p2. cbn [app triangles_of]. f_equal. rewrite triangles_app, triangles_next. f_equal.
    cbn [app triangles_of]. f_equal. rewrite !triangles_app, !triangles_next. f_equal.
    destruct chorded, closed; cbn [triangles_of app]; now rewrite app_nil_r.
  Qed.

  Let a1 := last l1 x.
  Let t2 := last l2 y.
  Let e1 : list edge := path_edges p1 ++ (a1, y) :: path_edges p2.
  Let e2 : list edge := path_edges (t2 :: l3 ++ if closed then [a1] else []).
  Let e3 : list edge := if chorded then [(a1, t2)] else [].

  Lemma length_path (l : list nat) : forall u, length (path_edges (u :: l)) = length l.
  Proof. induction l as [|v l IH]; intros u; [reflexivity|]. cbn [path_edges length] in *. now rewrite IH. Qed.
  Lemma length_e1 : length e1 = length l1 + 1 + length l2.
  Proof. unfold e1, p1, p2. rewrite app_length. cbn [length]. rewrite !length_path. lia. Qed.
  Lemma length_e2 : length e2 = length l3 + e.
  Proof. unfold e2, e. rewrite length_path, app_length. now destruct closed. Qed.

  Lemma path_edges_append l : forall u v l', path_edges (u :: l ++ v :: l') = path_edges (u :: l) ++ (last l u, v) :: path_edges (v :: l').
  Proof.
    induction l as [|w l IH]; intros u v l'; [reflexivity|]. rewrite last_cons. change (path_edges (u :: (w :: l) ++ v :: l')) with
      ((u, w) :: path_edges (w :: l ++ v :: l')). now rewrite IH.
  Qed.
  Lemma path_edges_on l l' : forall u, path_edges (u :: l ++ l') = path_edges (u :: l) ++ path_edges (last l u :: l').
  Proof.
    induction l as [|w l IH]; intros u; [reflexivity|]. rewrite last_cons. change (path_edges (u :: (w :: l) ++ l')) with
      ((u, w) :: path_edges (w :: l ++ l')). now rewrite IH.
  Qed.

  Lemma inner_parts : inner (side_of n k p1 p2 l3 chorded closed) = e1 ++ e2 ++ e3.
  Proof.
    rewrite (app_assoc e1). unfold side_of, e1, e2, e3, p1, p2. cbn [inner]. rewrite !last_cons. fold a1 t2. f_equal.
    cbn [app]. rewrite (path_edges_append l1 x y), path_edges_on, <- app_assoc. reflexivity.
  Qed.

  Lemma joins_parts a t : map undirected (tl (joins a t (route p1 p2 l3 chorded closed))) = map undirected (e1 ++ e3 ++ e2).
  Proof.
    unfold route, e1, e2, e3, p1, p2. cbn [app joins tl]. rewrite joins_next. cbn [app joins]. rewrite joins_next. fold a1 t2.
    rewrite path_edges_on.
    assert (T : forall b, map undirected (joins a1 t2 (map (pair next) l3 ++ (if b : bool then [(chord, 0)] else []))) =
      map undirected (path_edges (t2 :: l3) ++ path_edges (last l3 t2 :: if b then [a1] else []))).
    { intros b. rewrite joins_next, !map_app. f_equal. destruct b; [|reflexivity]. cbn. f_equal. unfold undirected. cbn [fst snd]. f_equal; lia. }
    rewrite !map_app. cbn [map]. rewrite !map_app, <- !app_assoc. f_equal. cbn [app]. f_equal. f_equal.
    destruct chorded; cbn [app joins map]; [f_equal|]; rewrite T, map_app; reflexivity.
  Qed.

  Lemma route_along : drawn_along (side_of n k p1 p2 l3 chorded closed) k (route p1 p2 l3 chorded closed)
    (length l1 + 1 + length l2) (length l3 + e) q.
  Proof.
    assert (B : forall t, In t (p1 ++ p2 ++ l3) -> t < n).
    { intros t I. eapply Permutation_in in I; [|exact all]. apply in_seq in I. lia. }
    assert (La : In (last p1 0) p1 /\ In (last p2 0) p2).
    { unfold p1, p2. rewrite !last_cons. split; apply last_in. }
    split; [reflexivity|exact enough|..].
    - intros f I. unfold side_of in *. cbn [inner triangles] in *. apply in_app_or in I as [I|I].
      + revert I. apply path_edges_bound. intros t I. rewrite !app_assoc in I. apply in_app_or in I as [I|I].
        * apply B. now rewrite <- app_assoc in I. * destruct closed; [|destruct I]. destruct I as [<-|[]]. apply B.
          apply in_or_app. now left.
      + destruct chorded; [|destruct I]. destruct I as [<-|[]]. cbn [fst snd]. split; apply B; apply in_or_app; [now left|right].
        apply in_or_app. now left.
    - rewrite route_triangles. exact all.
    - exists x. eexists. split; [reflexivity|]. intros [y' t] I. cbn [fst].
      assert (N : forall l, In (y', t) (map (pair next) l) -> y' <> put).
      { intros l J. apply in_map_iff in J as (u & E & _). injection E as <- _. discriminate. }
      assert (C : forall b, In (y', t) (if b : bool then [(chord, 0)] else []) -> y' <> put).
      { intros [|] J; [|destruct J]. destruct J as [E|[]]. injection E as <- _. discriminate. }
      repeat (apply in_app_or in I as [I|I]); eauto. destruct I as [E|I]; eauto. injection E as <- _. discriminate.
    - rewrite inner_parts, !app_length, length_e1, length_e2. unfold e3, q. destruct chorded; simpl; lia.
    - intros a t. rewrite inner_parts, <- length_e1, <- length_e2, arranged_parts. apply joins_parts.
  Qed.
End Route.

Lemma route_along_parts n k p1 p2 l3 chorded closed : p1 <> [] -> p2 <> [] -> k <= n -> Permutation (p1 ++ p2 ++ l3) (seq 0 n) ->
  drawn_along (side_of n k p1 p2 l3 chorded closed) k (route p1 p2 l3 chorded closed)
    (length p1 + length p2 - 1) (length l3 + if closed then 1 else 0) (if chorded then 1 else 0).
Proof.
  intros N1 N2 E P. destruct p1 as [|x l1]; [contradiction|]. destruct p2 as [|y l2]; [contradiction|].
  replace (length (x :: l1) + length (y :: l2) - 1) with (length l1 + 1 + length l2) by (simpl; lia). apply route_along; assumption.
Qed.

(** A path without anchor. *)
Lemma path_along n k l : l <> [] -> k <= n -> Permutation l (seq 0 n) ->
  drawn_along (Side n (path_edges l) (seq 0 k)) k (route l [] [] false false) (length l - 1) 0 0.
Proof.
  intros N E P. destruct l as [|x l]; [contradiction|]. unfold route. cbn [app map]. rewrite !app_nil_r.
  split; cbn [owner triangles inner]; auto.
  - apply path_edges_bound. intros t I. eapply Permutation_in in I; [|exact P]. apply in_seq in I. lia.
  - cbn [triangles_of]. now rewrite triangles_next.
  - exists x. eexists. split; [reflexivity|]. intros y I. apply in_map_iff in I as (u & <- & _). discriminate.
  - rewrite length_path. simpl. lia.
  - intros a t. cbn [joins tl]. rewrite <- (app_nil_r (map (pair next) l)), joins_next. cbn [joins]. rewrite app_nil_r. f_equal.
    unfold arranged. replace (length (x :: l) - 1 + 0) with (length (path_edges (x :: l))) by (rewrite length_path; simpl; lia).
    replace (length (x :: l) - 1) with (length (path_edges (x :: l))) by (rewrite length_path; simpl; lia).
    rewrite firstn_all, skipn_all. cbn [firstn app]. now rewrite app_nil_r.
Qed.

(** ** The sides of the families *)
Definition closed_route (k : nat) : shape := route [0] (seq 1 (k - 1)) [] false true.
Definition ring_route (k a : nat) : shape := route [k] (seq 0 a ++ [k + 1]) (seq a (k - a)) true true.
Definition open_route (k : nat) : shape := route (seq 0 k) [] [] false false.
Definition chord_route (k i j : nat) : shape := route (seq 0 i ++ [k]) (seq i (j - i) ++ [k + 1]) (seq j (k - j)) true false.
Definition one_route (k i : nat) : shape := route (seq 0 i ++ k :: seq i (k - i)) [] [] false false.

Lemma closed_along k : 2 <= k -> drawn_along (closed_fan k) k (closed_route k) (k - 1) 1 0.
Proof.
  intros H. replace (closed_fan k) with (side_of k k [0] (seq 1 (k - 1)) [] false true).
  2: { unfold side_of, closed_fan, ring_edges. f_equal. destruct k as [|k]; [lia|]. cbn [seq firstn last app Nat.sub].
       rewrite Nat.sub_0_r, !app_nil_r. reflexivity. }
  replace (k - 1) with (length [0] + length (seq 1 (k - 1)) - 1) at 2 by (rewrite seq_length; simpl; lia).
  apply route_along_parts; [discriminate| |lia|].
  - replace (k - 1) with (S (k - 2)) by lia. discriminate.
  - rewrite app_nil_r. replace (seq 0 k) with (seq 0 (1 + (k - 1))) by (f_equal; lia). reflexivity.
Qed.

Lemma seq_parts a n : a <= n -> seq 0 n = seq 0 a ++ seq a (n - a).
Proof. intros H. replace n with (a + (n - a)) at 1 by lia. now rewrite seq_app. Qed.
Lemma seq_two k : seq 0 (k + 2) = seq 0 k ++ [k; k + 1].
Proof. rewrite seq_app. simpl. now rewrite (Nat.add_1_r k). Qed.

Lemma ring_along k a : 1 <= a <= k -> drawn_along (ring_with_chord k a) k (ring_route k a) (a + 1) (k - a + 1) 1.
Proof.
  intros H. replace (ring_with_chord k a) with (side_of (k + 2) k [k] (seq 0 a ++ [k + 1]) (seq a (k - a)) true true).
  2: { unfold side_of, ring_with_chord, ring_edges. f_equal. cbn [last firstn app]. rewrite last_last, <- !app_assoc. cbn [app].
       rewrite <- ?app_assoc. reflexivity. }
  replace (a + 1) with (length [k] + length (seq 0 a ++ [k + 1]) - 1) by (rewrite app_length, seq_length; simpl; lia).
  replace (k - a + 1) with (length (seq a (k - a)) + 1) by now rewrite seq_length.
  apply route_along_parts; [discriminate| |lia|].
  - intros E. apply app_eq_nil in E as [_ E]. discriminate.
  - rewrite seq_two, (seq_parts a k), <- !app_assoc by lia. cbn [app].
    rewrite Permutation_middle. apply Permutation_app_head. exact (Permutation_app_comm [k; k + 1] (seq a (k - a))).
Qed.

Lemma open_along k : 1 <= k -> drawn_along (open_fan k) k (open_route k) (k - 1) 0 0.
Proof.
  intros H. replace (k - 1) with (length (seq 0 k) - 1) by now rewrite seq_length. apply path_along; auto.
  destruct k; [lia|discriminate].
Qed.
Lemma one_along k i : i <= k -> drawn_along (path_with_one k i) k (one_route k i) k 0 0.
Proof.
  intros H. replace k with (length (seq 0 i ++ k :: seq i (k - i)) - 1) at 4 by (rewrite app_length; simpl; rewrite !seq_length; lia).
  apply path_along; [|lia|].
  - destruct (seq 0 i); discriminate.
  - rewrite Nat.add_1_r, seq_S, (seq_parts i k) by lia. rewrite <- app_assoc. apply Permutation_app_head. cbn [app].
    apply Permutation_cons_append.
Qed.
Lemma chord_along k i j : i < j <= k -> drawn_along (path_with_chord k i j) k (chord_route k i j) (j + 1) (k - j) 1.
Proof.
  intros H. replace (path_with_chord k i j) with (side_of (k + 2) k (seq 0 i ++ [k]) (seq i (j - i) ++ [k + 1]) (seq j (k - j)) true false).
  2: { unfold side_of, path_with_chord. f_equal. rewrite !last_last, app_nil_r, <- !app_assoc. reflexivity. }
  replace (j + 1) with (length (seq 0 i ++ [k]) + length (seq i (j - i) ++ [k + 1]) - 1)
    by (rewrite !app_length, !seq_length; simpl; lia).
  replace (k - j) with (length (seq j (k - j)) + 0) at 2 by (rewrite seq_length; lia).
  apply route_along_parts; [| |lia|].
  - intros E. apply app_eq_nil in E as [_ E]. discriminate.
  - intros E. apply app_eq_nil in E as [_ E]. discriminate.
  - rewrite seq_two, (seq_parts j k) by lia. replace (seq 0 j) with (seq 0 i ++ seq i (j - i)).
    2: { symmetry. apply seq_parts. lia. }
    rewrite <- !app_assoc. apply Permutation_app_head. cbn [app]. etransitivity; [apply Permutation_middle|]. apply Permutation_app_head.
    exact (Permutation_app_comm [k; k + 1] (seq j (k - j))).
Qed.

(** ** The answers for every k

    How the side after is drawn ([drawn_along]). *)
Record course := Course { way : shape; met_first : nat; met_last : nat; left_over : nat }.
Definition course_at (o : position) : course :=
  match o with
  | split_at k a => Course (ring_route k a) (a + 1) (k - a + 1) 1
  | collapse_at k _ => Course (closed_route k) (k - 1) 1 0
  | open_split_at k i j => Course (chord_route k i j) (j + 1) (k - j) 1
  | open_collapse_at k _ _ | boundary_collapse_at k _ => Course (open_route k) (k - 1) 0 0
  | boundary_split_at k i => Course (one_route k i) k 0 0
  end.

Lemma course_right o : possible o = true ->
  well_formed_side (patch_at o) (before (patch_at o)) = true /\
  drawn_along (after (patch_at o)) (ports (patch_at o)) (way (course_at o))
    (met_first (course_at o)) (met_last (course_at o)) (left_over (course_at o)).
Proof.
  destruct o as [k a|k a|k i j|k i j|k i|k i]; cbn [possible patch_at course_at way met_first met_last left_over];
    rewrite ?andb_true_iff, ?Nat.leb_le, ?Nat.ltb_lt; intros H;
    match goal with |- context [ports ?p] => assert (E : ports p = k) by apply seq_length end; rewrite E; split;
    try (eapply along_well_formed; rewrite E);
    [apply closed_along|apply ring_along|apply ring_along|apply closed_along|apply open_along|apply chord_along
    |apply chord_along|apply open_along|apply open_along|apply one_along|apply one_along|apply open_along]; lia.
Qed.

Definition answer_at (o : position) : table := let r := course_at o in fold_table (patch_at o) (way r) (met_first r) (left_over r).
Theorem every_right o : possible o = true -> correct (patch_at o) (answer_at o) /\ safe (patch_at o) (answer_at o).
Proof.
  intros Po. destruct (course_right o Po) as [W A].
  split; [eapply fold_correct|eapply fold_safe]; eassumption.
Qed.
