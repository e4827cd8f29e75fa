(** * The sides of all families as routes

    Each side of [Statements.v]'s families is drawn triangle by triangle along a route. This file proves that the drawing along the
    route is the drawing of the side, and that the best colouring which [Fold.v] keeps is best among all that are legal. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Strips Locality Drawing Checker Rows Symmetry Frontier Fold.

(** ** Shapes: what is drawn, whatever the colours *)
Inductive kind := put | next | mark | chord.
Definition shape := list (kind * nat).

Fixpoint triangles_of (sh : shape) : list nat :=
  match sh with [] => [] | (chord, _) :: r => triangles_of r | (_, n) :: r => n :: triangles_of r end.
(** The edge of each step, when [a] is the anchor and [t] the tip. *)
Fixpoint joins (a t : nat) (sh : shape) : list edge :=
  match sh with
  | [] => []
  | (put, n) :: r | (next, n) :: r => (t, n) :: joins a n r
  | (mark, n) :: r => (t, n) :: joins t n r
  | (chord, _) :: r => (a, t) :: joins a t r
  end.
Definition starts (sh : shape) : Prop := exists t r, sh = (put, t) :: r /\ forall x, In x r -> fst x <> put.

(** [m] things, then [r], then the others: the others are moved in front of the [r]. *)
Definition arranged {A} (m r : nat) (l : list A) : list A := firstn m l ++ skipn (m + r) l ++ firstn r (skipn m l).

Lemma arranged_parts {A} (l1 l2 l3 : list A) : arranged (length l1) (length l2) (l1 ++ l2 ++ l3) = l1 ++ l3 ++ l2.
Proof.
  unfold arranged. rewrite firstn_app, Nat.sub_diag, firstn_all, firstn_O, app_nil_r. f_equal.
  rewrite skipn_app, skipn_all2, Nat.add_comm, Nat.add_sub, skipn_app, skipn_all, Nat.sub_diag by lia. cbn [app skipn]. f_equal.
  rewrite skipn_app, skipn_all, Nat.sub_diag. cbn [app skipn]. rewrite firstn_app, Nat.sub_diag, firstn_all, firstn_O. apply app_nil_r.
Qed.
Lemma three_parts {A} (l : list A) m r q : length l = m + r + q ->
  exists l1 l2 l3, l = l1 ++ l2 ++ l3 /\ length l1 = m /\ length l2 = r /\ length l3 = q.
Proof.
  intros L. exists (firstn m l), (firstn r (skipn m l)), (skipn r (skipn m l)). rewrite !firstn_skipn.
  rewrite !firstn_length, !skipn_length. repeat split; lia.
Qed.
Lemma arranged_back {A} (l : list A) m r q : length l = m + r + q -> arranged m q (arranged m r l) = l.
Proof.
  intros L. destruct (three_parts l m r q L) as (l1 & l2 & l3 & -> & <- & <- & <-). now rewrite !arranged_parts.
Qed.
Lemma arranged_length {A} (l : list A) m r q : length l = m + r + q -> length (arranged m r l) = m + r + q.
Proof.
  intros L. destruct (three_parts l m r q L) as (l1 & l2 & l3 & -> & <- & <- & <-). rewrite arranged_parts, !app_length. lia.
Qed.
Lemma solid_app es fs : forall c, length c = length es -> forall e, solid (es ++ fs) (c ++ e) = solid es c ++ solid fs e.
Proof. induction es as [|e es IH]; intros [|[|] c] L f; try discriminate; simpl in *; auto. now rewrite IH by auto. Qed.
Lemma solid_arranged es (c : coloring) m r q : length es = m + r + q -> length c = m + r + q ->
  Permutation (solid (arranged m r es) (arranged m r c)) (solid es c).
Proof.
  intros Le Lc. destruct (three_parts es m r q Le) as (e1 & e2 & e3 & -> & M1 & M2 & M3).
  destruct (three_parts c m r q Lc) as (c1 & c2 & c3 & -> & N1 & N2 & N3).
  rewrite <- M1, <- M2 at 1. rewrite <- N1, <- N2. rewrite !arranged_parts, !solid_app by congruence.
  apply Permutation_app_head, Permutation_app_comm.
Qed.
Lemma solids_app c d : solids (c ++ d) = solids c + solids d.
Proof. unfold solids. now rewrite filter_app, app_length. Qed.
Lemma solids_arranged (c : coloring) m r q : length c = m + r + q -> solids (arranged m r c) = solids c.
Proof.
  intros L. destruct (three_parts c m r q L) as (c1 & c2 & c3 & -> & <- & <- & _). rewrite arranged_parts, !solids_app. lia.
Qed.

Lemma flat_map_same {A B} (f g : A -> list B) l : (forall a, In a l -> f a = g a) -> flat_map f l = flat_map g l.
Proof. induction l as [|a l IH]; intros E; [reflexivity|]. simpl. rewrite E by now left. f_equal. apply IH. intros b I. apply E. now right. Qed.

Lemma degree_alike' G G' v : Permutation (map undirected G) (map undirected G') -> degree G v = degree G' v.
Proof. intros P. rewrite <- (degree_undirected G), <- (degree_undirected G'). now apply degree_perm. Qed.

(** ** A side and its shape *)
Section Side.
  Variables (d : side) (k : nat) (sh : shape) (m r q : nat).
  Hypotheses (owners : owner d = seq 0 k) (enough : k <= triangles d)
    (edges_inside : forall e, In e (inner d) -> fst e < triangles d /\ snd e < triangles d)
    (all_drawn : Permutation (triangles_of sh) (seq 0 (triangles d))) (first : starts sh)
    (parts : length (inner d) = m + r + q)
    (same_edges : forall a t, map undirected (tl (joins a t sh)) = map undirected (arranged m r (inner d))).
  Variables (s : coloring) (lab : nat -> nat).
  Hypothesis (colours : length s = k).
  Let z := k + triangles d.

  Definition port_of (t : nat) : option nat := if (t <? k) && nth t s false then Some (lab t) else None.
  Definition step_of (x : kind * nat) : step :=
    match fst x with put => Put (port_of (snd x)) | next => Next (port_of (snd x)) | mark => Mark (port_of (snd x)) | chord => Chord end.
  Definition move_of (x : kind * nat) : move := Move (step_of x) (k + snd x) (if snd x <? k then snd x else z).
  Definition start : picture := Drawn [] z (S z) [].

  (** *** The graph that is drawn *)
  Definition shift (e : edge) : edge := (k + fst e, k + snd e).
  Definition ports_of (l : list nat) : graph := flat_map (fun t => if (t <? k) && nth t s false then [(t, k + t)] else []) l.

  Lemma port_edge_of t : port_edge (port_of t) (if t <? k then t else z) (k + t) = ports_of [t].
  Proof. unfold port_of, ports_of, port_edge. simpl. destruct (t <? k); [|reflexivity]. now destruct (nth t s false). Qed.

  Lemma ports_cons n l : ports_of (n :: l) = ports_of [n] ++ ports_of l.
  Proof. exact (flat_map_app _ [n] l). Qed.
  Lemma parts_swap (A B C : graph) : Permutation (A ++ B ++ C) ((B ++ A) ++ C).
  Proof. rewrite app_assoc. apply Permutation_app_tail, Permutation_app_comm. Qed.
  Lemma parts_swap_edge (e : edge) (E A B C : graph) : Permutation (E ++ A ++ e :: B ++ C) (e :: E ++ (B ++ A) ++ C).
  Proof.
    rewrite (app_assoc E). rewrite <- Permutation_middle. apply perm_skip. rewrite <- app_assoc.
    apply Permutation_app_head, parts_swap.
  Qed.

  Lemma drawn_graph l : forall a t c G gone, feasibles (map move_of l) c ->
    Permutation (graph_of (draw_moves (map move_of l) c (Drawn G (k + a) (k + t) gone)))
      (solid (map shift (joins a t l)) c ++ ports_of (triangles_of l) ++ G).
  Proof.
    induction l as [|[[| | |] n] l IH]; intros a t [|b c] G gone Po; cbn [map feasibles] in Po; try contradiction; [reflexivity|..];
      destruct Po as [Pb Po]; cbn [map draw_moves joins triangles_of fst snd app];
      unfold draw_move at 1; cbn [what move_of step_of fst snd vertex point label_of edge_of at_tip at_anchor graph_of Frontier.gone].
    - cbn [feasible what move_of step_of fst] in Pb. subst b. cbn [app solid]. rewrite (IH a n c _ _ Po), port_edge_of, (ports_cons n (triangles_of l)).
      apply Permutation_app_head, parts_swap.
    - rewrite (IH a n c _ _ Po), port_edge_of, (ports_cons n (triangles_of l)). destruct b; cbn [app solid]; [apply parts_swap_edge|].
      apply Permutation_app_head, parts_swap.
    - rewrite (IH t n c _ _ Po), port_edge_of, (ports_cons n (triangles_of l)). destruct b; cbn [app solid]; [apply parts_swap_edge|].
      apply Permutation_app_head, parts_swap.
    - rewrite (IH a t c _ _ Po). destruct b; cbn [app solid]; [|reflexivity].
      change (shift (a, t)) with (k + a, k + t). rewrite !app_assoc. now rewrite <- Permutation_middle.
  Qed.

  Lemma ports_drawn : ports_of (seq 0 k) = solid (port_edges d) s.
  Proof.
    unfold port_edges. rewrite owners, seq_length. unfold ports_of.
    assert (W : forall n a c, length c = n -> a + n <= k -> (forall i, i < n -> nth (a + i) s false = nth i c false) ->
      flat_map (fun t => if (t <? k) && nth t s false then [(t, k + t)] else []) (seq a n) =
      solid (combine (seq a n) (map (fun t => k + t) (seq a n))) c).
    { induction n as [|n IH]; intros a [|b c] L B E; try discriminate; [reflexivity|]. injection L as L. simpl.
      rewrite <- (Nat.add_0_r a) at 2. rewrite (E 0) by lia. destruct (Nat.ltb_spec a k); [|lia]. cbn [andb nth].
      rewrite (IH (S a) c L); [now destruct b|lia|]. intros i Hi.
      transitivity (nth (a + S i) s false); [f_equal; lia|]. apply (E (S i)). lia. }
    apply W; auto.
  Qed.
  Lemma ports_all : ports_of (seq 0 (triangles d)) = solid (port_edges d) s.
  Proof.
    rewrite <- ports_drawn. replace (triangles d) with (k + (triangles d - k)) by lia. unfold ports_of. rewrite seq_app, flat_map_app.
    rewrite <- app_nil_r. f_equal. simpl.
    assert (W : forall l, (forall t, In t l -> k <= t) -> flat_map (fun t => if (t <? k) && nth t s false then [(t, k + t)] else []) l = []).
    { induction l as [|t l IH]; intros B; [reflexivity|]. simpl. destruct (Nat.ltb_spec t k) as [C|C].
      - specialize (B t (or_introl eq_refl)). lia. - apply IH. intros u I. apply B. now right. }
    apply W. intros t I. apply in_seq in I. lia.
  Qed.

  Lemma solid_undirected es : forall c, map undirected (solid es c) = solid (map undirected es) c.
  Proof. exact (solid_map undirected es). Qed.
  Lemma undirected_shift es : map undirected (map shift es) = map shift (map undirected es).
  Proof.
    rewrite !map_map. apply map_ext. intros [a b]. unfold undirected, shift. cbn [fst snd]. f_equal; lia.
  Qed.
  Lemma inner_shift : inner_edges d = map shift (inner d).
  Proof. unfold inner_edges. now rewrite owners, seq_length. Qed.
  Lemma map_arranged {A B} (f : A -> B) l : map f (arranged m r l) = arranged m r (map f l).
  Proof. unfold arranged. now rewrite !map_app, !firstn_map, !skipn_map, firstn_map. Qed.

  (** The choices of a colouring of the inner edges: the first triangle is joined to nothing. *)
  Definition choices (x : coloring) : coloring := false :: arranged m r x.

  Lemma all_possible l : forall c, (forall x, In x l -> fst x <> put) -> length c = length l -> feasibles (map move_of l) c.
  Proof.
    induction l as [|[y n] l IH]; intros [|b c] N L; try discriminate; [exact I|]. injection L as L. cbn [map feasibles]. split.
    - specialize (N (y, n) (or_introl eq_refl)). cbn [fst] in N. destruct y; cbn; auto. contradiction.
    - apply IH; [intros y' J; apply N; now right|exact L].
  Qed.
  Lemma possible_choices x : length (choices x) = length sh -> feasibles (map move_of sh) (choices x).
  Proof.
    destruct first as (t & l & E & N). unfold choices. intros L. rewrite E in *. injection L as L. cbn [map feasibles].
    split; [reflexivity|]. now apply all_possible.
  Qed.

  Lemma joins_length l : forall a t, length (joins a t l) = length l.
  Proof. induction l as [|[[| | |] n] l IH]; intros a t; simpl; auto. Qed.
  Lemma shape_length : length sh = S (length (inner d)).
  Proof.
    destruct first as (t & l & E & _). rewrite <- (joins_length sh 0 0). rewrite E at 1. cbn [joins length]. f_equal.
    assert (Q : length (tl (joins 0 0 sh)) = length (arranged m r (inner d))).
    { now rewrite <- (map_length undirected), same_edges, map_length. }
    rewrite E in Q. cbn [joins tl] in Q. rewrite Q. rewrite parts. now apply arranged_length.
  Qed.
  Lemma choices_length x : length x = length (inner d) -> length (choices x) = length sh.
  Proof. intros L. rewrite shape_length. unfold choices. cbn [length]. f_equal. rewrite parts in *. now apply arranged_length. Qed.

  Definition after_all (x : coloring) : picture := draw_moves (map move_of sh) (choices x) start.

  Lemma drawn_alike x : length x = length (inner d) ->
    Permutation (map undirected (graph_of (after_all x))) (map undirected (drawing d s x)).
  Proof.
    intros L. pose proof (choices_length x L) as Lc. pose proof (possible_choices x Lc) as Po. unfold after_all, start, z.
    replace (S (k + triangles d)) with (k + S (triangles d)) by lia.
    etransitivity; [apply Permutation_map, (drawn_graph sh (triangles d) (S (triangles d)) (choices x) [] [] Po)|].
    unfold drawing. rewrite !map_app, app_nil_r. rewrite Permutation_app_comm. apply Permutation_app.
    - apply Permutation_map. rewrite <- ports_all. unfold ports_of. now apply Permutation_flat_map.
    - pose proof (same_edges (triangles d) (S (triangles d))) as E. destruct first as (t & l & Q & _). rewrite Q in *. unfold choices.
      cbn [joins tl] in *. cbn [map solid]. rewrite !solid_undirected, undirected_shift, E, <- undirected_shift, <- !solid_undirected.
      apply Permutation_map. rewrite map_arranged, <- inner_shift. apply solid_arranged with q; [|now rewrite L].
      now rewrite inner_edges_length.
  Qed.

  (** *** The books are right at the beginning, and every step is new *)
  Lemma start_right : right k lab [z; S z] start blank_frontier 0.
  Proof.
    assert (A : allowed k lab []) by (split; [apply valid_nil|]; intros i j _ _ L; now apply linked_nil in L as ->).
    assert (S0 : forall v, k <= v -> seen k lab [] v (Place 0 None)).
    { intros v Hv. split; [reflexivity|]. intros _ i Hi L. apply linked_nil in L. lia. }
    unfold right, start. cbn [graph_of at_anchor at_tip Frontier.gone anchor tip same blank_frontier]. unfold z.
    split; [exact A|]. split; [lia|]. split; [lia|]. split; [lia|]. split; [apply S0; lia|]. split; [apply S0; lia|].
    split; [intros _ _; split; [discriminate|intros L; apply linked_nil in L; lia]|]. split; [reflexivity|].
    split; [intros v D; now contradiction D|]. split; [now left|]. split; [right; now left|]. split; [intros v []|].
    split; [intros v []|]. split; intros [].
  Qed.

  Lemma shape_new l : NoDup (triangles_of l) -> (forall t, In t (triangles_of l) -> t < triangles d) ->
    forall used, (forall t, In t (triangles_of l) -> ~ In (k + t) used /\ (t < k -> ~ In t used)) -> new_moves k lab used (map move_of l).
  Proof.
    induction l as [|[y n] l IH]; intros Nd B used U; [exact I|]. cbn [map new_moves].
    destruct (match y with chord => true | _ => false end) eqn:Y.
    - destruct y; try discriminate. split; [exact I|]. apply IH; auto.
    - assert (E : triangles_of ((y, n) :: l) = n :: triangles_of l) by (destruct y; try discriminate; reflexivity).
      rewrite E in *. inversion_clear Nd as [|? ? Nn Nd']. pose proof (U n (or_introl eq_refl)) as [U1 U2].
      assert (W : forall st, match st with Chord => False | _ => True end -> label_of st = port_of n ->
        k <= k + n /\ ~ In (k + n) used /\ match label_of st with Some l0 =>
          (if n <? k then n else z) < k /\ l0 = lab (if n <? k then n else z) /\ ~ In (if n <? k then n else z) used | None => True end).
      { intros st _ ->. split; [lia|]. split; [exact U1|]. unfold port_of. destruct (Nat.ltb_spec n k) as [C|C]; [|exact I].
        simpl. destruct (nth n s false); [|exact I]. auto. }
      split.
      + unfold new_move, move_of. cbn [what vertex point]. destruct y; try discriminate; cbn [step_of fst snd]; now apply (W (_ (port_of n))).
      + apply IH; auto. { intros t I. apply B. now right. }
        intros t I. pose proof (U t (or_intror I)) as [V1 V2]. pose proof (B t (or_intror I)) as Bt.
        assert (Q : use (move_of (y, n)) used = k + n :: (if n <? k then n else z) :: used) by (destruct y; try discriminate; reflexivity).
        rewrite Q. assert (t <> n) by (intros ->; contradiction). unfold z. simpl. split.
        * intros [J|[J|J]]; [lia| |contradiction]. destruct (Nat.ltb_spec n k); lia.
        * intros C [J|[J|J]]; [lia| |now apply V2]. destruct (Nat.ltb_spec n k); lia.
  Qed.
  Lemma all_new : new_moves k lab [z; S z] (map move_of sh).
  Proof.
    apply shape_new.
    - eapply Permutation_NoDup; [symmetry; exact all_drawn|apply seq_NoDup].
    - intros t I. eapply Permutation_in in I; [|exact all_drawn]. apply in_seq in I. lia.
    - intros t I. eapply Permutation_in in I; [|exact all_drawn]. apply in_seq in I. unfold z. simpl. lia.
  Qed.

  (** *** The forgotten vertices and the last two are all there are *)
  Definition everyone (e : picture) : list nat := at_anchor e :: at_tip e :: Frontier.gone e.
  Lemma everyone_drawn l : forall c e, length c = length l ->
    Permutation (everyone (draw_moves (map move_of l) c e)) (map (fun t => k + t) (triangles_of l) ++ everyone e).
  Proof.
    induction l as [|[y n] l IH]; intros [|b c] e L; try discriminate; [reflexivity|]. injection L as L. cbn [map draw_moves].
    rewrite (IH c _ L). destruct y; cbn [triangles_of fst snd app map];
      unfold draw_move, everyone; cbn [what move_of step_of fst snd Frontier.gone at_anchor at_tip vertex]; [..|reflexivity];
      rewrite Permutation_middle; apply Permutation_app_head; [apply perm_swap|apply perm_swap|].
    rewrite perm_swap. apply perm_skip, perm_swap.
  Qed.

  Lemma alone_perm G l l' : Permutation l l' -> alone_in G l = alone_in G l'.
  Proof. intros P. apply Permutation_length, filter_perm, P. Qed.

  Lemma untouched x v : k + triangles d <= v -> degree (drawing d s x) v = 0.
  Proof.
    intros H. apply degree_zero. intros e I. unfold drawing in I. apply in_app_or in I as [I|I]; apply solid_incl in I.
    - unfold port_edges in I. rewrite owners, seq_length in I. destruct e as [i t]. pose proof (in_combine_l _ _ _ _ I) as J.
      apply in_combine_r in I. apply in_seq in J. apply in_map_iff in I as (u & <- & I). apply in_seq in I. simpl. lia.
    - rewrite inner_shift in I. apply in_map_iff in I as (f & <- & I). apply edges_inside in I. simpl. lia.
  Qed.

  Lemma allowed_alike G G' : Permutation (map undirected G) (map undirected G') -> allowed k lab G -> allowed k lab G'.
  Proof.
    intros P [V L]. split.
    - apply valid_undirected. eapply valid_perm; [exact P|]. now apply valid_undirected.
    - intros i j Hi Hj I. apply L; auto. apply linked_undirected. apply linked_undirected in I.
      exact (linked_perm _ _ _ _ (Permutation_sym P) I).
  Qed.

  (** A colouring along the route is allowed exactly when it can be played, and the score is right. *)
  Theorem route_plays x : length x = length (inner d) ->
    match play (map step_of sh) (choices x) blank_frontier 0 0 with
    | Some (f, (n, i)) => allowed k lab (drawing d s x) /\ n = solids x /\ i + at_end f = isolated d s x + 2
    | None => ~ allowed k lab (drawing d s x)
    end.
  Proof.
    intros L. pose proof (choices_length x L) as Lc. pose proof (drawn_alike x L) as Al.
    pose proof (play_right k lab (map move_of sh) _ _ _ 0 0 _ start_right all_new (possible_choices x Lc)) as P.
    rewrite map_map in P. cbn [what move_of] in P. change (fun y => step_of y) with step_of in P.
    destruct (play (map step_of sh) (choices x) blank_frontier 0 0) as [[f [n i]]|].
    - destruct P as [R ->]. fold (after_all x) in R. pose proof R as (A & _ & _ & _ & Sa & St & _ & Ei & _).
      split; [exact (allowed_alike _ _ Al A)|]. split.
      + unfold choices. change (solids (false :: arranged m r x)) with (solids (arranged m r x)). cbn [Nat.add].
        apply solids_arranged with q. congruence.
      + set (G := graph_of (after_all x)) in *.
        assert (E : alone_in G (everyone (after_all x)) = i + at_end f).
        { unfold everyone, at_end. rewrite <- (proj1 Sa), <- (proj1 St), Ei, !alone_cons. lia. }
        rewrite <- E. clear E. unfold after_all at 1. rewrite (alone_perm _ _ _ (everyone_drawn sh _ start Lc)).
        rewrite (alone_perm G _ (map (fun t => k + t) (seq 0 (triangles d)) ++ [z; S z]))
          by (apply Permutation_app_tail, Permutation_map, all_drawn).
        rewrite (alone_same (drawing d s x)) by (intros v _; now apply degree_alike').
        unfold alone_in. rewrite filter_app, app_length. f_equal.
        * unfold isolated. rewrite owners, seq_length, filter_map, map_length. reflexivity.
        * cbn [filter]. rewrite !untouched by (unfold z; lia). reflexivity.
    - intros A. apply P. fold (after_all x). eapply allowed_alike; [symmetry; exact Al|exact A].
  Qed.
End Side.
