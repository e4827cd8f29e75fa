(** * Splits of open fans

    They are drawn as a ring is, from A on; where the ring would pass the boundary, a triangle is put down that is joined to
    nothing. *)
Require Import Arith Bool List NArith Permutation Lia.
Import ListNotations.
Require Import Statements Graph Strips Locality Drawing Checker Rows Symmetry Frontier Fold Route EveryFan Entries.
Require Import Arcs Rings Closings Header Kinds Ends Meetings Played Keys Neighbours Walks WalkFamilies.

(** ** Any shape, with colours for its steps *)
Section Shape.
  Variables (d : side) (k : nat) (sh : shape) (s : coloring) (lab : nat -> nat) (ch x : coloring).
  Hypotheses (owners : owner d = seq 0 k) (enough : k <= triangles d)
    (edges_inside : forall e, In e (inner d) -> fst e < triangles d /\ snd e < triangles d)
    (all_drawn : Permutation (triangles_of sh) (seq 0 (triangles d)))
    (colours : length s = k) (len : length ch = length sh)
    (may : feasibles (map (move_of d k s lab) sh) ch)
    (alike : Permutation (map undirected (solid (joins (triangles d) (S (triangles d)) sh) ch)) (map undirected (solid (inner d) x)))
    (count : solids ch = solids x).
  Let z := k + triangles d.
  Let all_parts : length (inner d) = length (inner d) + 0 + 0. Proof. lia. Qed.

  Theorem shape_plays :
    match play (map (step_of k s lab) sh) ch blank_frontier 0 0 with
    | Some (f, (n, i)) => allowed k lab (drawing d s x) /\ n = solids x /\ i + at_end f = isolated d s x + 2
    | None => ~ allowed k lab (drawing d s x)
    end.
  Proof.
    set (e := draw_moves (map (move_of d k s lab) sh) ch (start d k)).
    assert (Al : Permutation (map undirected (graph_of e)) (map undirected (drawing d s x))).
    { unfold e, start. replace (S (k + triangles d)) with (k + S (triangles d)) by lia.
      etransitivity; [apply Permutation_map, (drawn_graph d k s lab sh (triangles d) (S (triangles d)) ch [] [] may)|].
      unfold drawing. rewrite !map_app, app_nil_r. rewrite Permutation_app_comm. apply Permutation_app.
      - apply Permutation_map. rewrite <- (ports_all d k _ _ _ owners enough all_parts s colours). unfold ports_of. now apply Permutation_flat_map.
      - rewrite (inner_shift d k owners), <- !solid_map, !(undirected_shift d k _ _ _ enough all_parts s colours). now apply Permutation_map. }
    pose proof (play_right k lab (map (move_of d k s lab) sh) _ _ _ 0 0 _ (start_right d k _ _ _ enough all_parts s lab colours)
      (all_new d k sh _ _ _ enough all_drawn all_parts s lab colours) may) as P.
    fold e in P. rewrite map_map in P. cbn [what move_of] in P. change (fun y => step_of k s lab y) with (step_of k s lab) in P.
    destruct (play (map (step_of k s lab) sh) ch blank_frontier 0 0) as [[f [n i]]|].
    - destruct P as [Rt ->]. pose proof Rt as (A & _ & _ & _ & Sa & St & _ & Ei & _).
      split; [exact (allowed_alike _ _ _ _ Al A)|]. split; [exact count|]. set (G := graph_of e) in *.
      assert (E : alone_in G (everyone e) = i + at_end f).
      { unfold everyone, at_end. rewrite <- (proj1 Sa), <- (proj1 St), Ei, !alone_cons. lia. }
      rewrite <- E. clear E. unfold e at 1. rewrite (alone_perm _ _ _ (everyone_drawn d k s lab sh _ (start d k) len)).
      rewrite (alone_perm G _ (map (fun t => k + t) (seq 0 (triangles d)) ++ [z; S z]))
        by (apply Permutation_app_tail, Permutation_map, all_drawn).
      rewrite (alone_same (drawing d s x)) by (intros v _; now apply degree_alike').
      unfold alone_in. rewrite filter_app, app_length. f_equal.
      + unfold isolated. rewrite owners, seq_length, filter_map, map_length. reflexivity.
      + cbn [filter]. rewrite !(untouched d k _ _ _ owners enough edges_inside all_parts s colours) by (unfold z; lia). reflexivity.
    - intros A. apply P. eapply allowed_alike; [symmetry; exact Al|exact A].
  Qed.
End Shape.

(** ** The shape of a path with chord *)
Definition behind (i : nat) : shape := match i with 0 => [] | S i' => (put, 0) :: map (pair next) (seq 1 i') ++ [(chord, 0)] end.
Definition open_shape (k i j : nat) : shape :=
  (put, k) :: (mark, i) :: map (pair next) (seq (S i) (j - S i) ++ [k + 1]) ++ (chord, 0) :: map (pair next) (seq j (k - j)) ++ behind i.
Definition closing (i : nat) (xP : coloring) : coloring := match i with 0 => [] | _ => false :: xP end.

Lemma solids_cons b c : solids (b :: c) = (if b then 1 else 0) + solids c.
Proof. unfold solids. now destruct b. Qed.
Lemma seq_head i n : 1 <= n -> seq i n = i :: seq (S i) (n - 1).
Proof. intros H. destruct n; [lia|]. cbn. now rewrite Nat.sub_0_r. Qed.
Lemma path_length (l : list nat) : forall u, length (path_edges (u :: l)) = length l.
Proof. induction l as [|v l IH]; intros u; [reflexivity|]. cbn [path_edges length] in *. now rewrite IH. Qed.

Lemma open_possible k i j d s lab xM xS xP c : i < j <= k -> length xM = j - i + 1 -> length xS = k - j -> length xP = i ->
  length (false :: xM ++ c :: xS ++ closing i xP) = length (open_shape k i j) /\
  feasibles (map (move_of d k s lab) (open_shape k i j)) (false :: xM ++ c :: xS ++ closing i xP).
Proof.
  intros H LM LS LP.
  assert (Lb : length (closing i xP) = length (behind i)).
  { destruct i as [|i']; [reflexivity|]. cbn [closing behind length]. rewrite app_length, map_length, seq_length. cbn. lia. }
  assert (Ln : length (false :: xM ++ c :: xS ++ closing i xP) = length (open_shape k i j)).
  { unfold open_shape. cbn [length]. rewrite !app_length. cbn [length]. rewrite !app_length, Lb, !map_length, !app_length, !seq_length. cbn [length]. lia. }
  split; [exact Ln|].
  assert (W : forall l c', length c' = length l -> (forall y, In y l -> fst y <> put) -> forall l2 c2, feasibles (map (move_of d k s lab) l2) c2 ->
    feasibles (map (move_of d k s lab) (l ++ l2)) (c' ++ c2)).
  { induction l as [|[y n] l IH]; intros [|b c'] L N l2 c2 P; try discriminate; [exact P|]. injection L as L. cbn [map app feasibles]. split.
    - specialize (N (y, n) (or_introl eq_refl)). cbn [fst] in N. destruct y; cbn; auto. contradiction.
    - apply IH; auto. intros y' I. apply N. now right. }
  assert (Tail : feasibles (map (move_of d k s lab) (((mark, i) :: map (pair next) (seq (S i) (j - S i) ++ [k + 1]) ++ (chord, 0) :: map (pair next) (seq j (k - j))) ++ behind i))
    ((xM ++ c :: xS) ++ closing i xP)).
  { apply W.
    - cbn [length]. rewrite !app_length. cbn [length]. rewrite !map_length, app_length, !seq_length. cbn [length]. lia.
    - intros y [<-|I]; [discriminate|]. apply in_app_or in I as [I|[<-|I]]; [|discriminate|];
        apply in_map_iff in I as (u & <- & _); discriminate.
    - destruct i as [|i']; [exact I|]. split; [reflexivity|]. rewrite <- (app_nil_r xP).
      rewrite <- (app_nil_r (map (pair next) (seq 1 i') ++ [(chord, 0)])).
      apply W; [rewrite app_length, map_length, seq_length; cbn; lia| |exact I].
      intros y I. apply in_app_or in I as [I|[<-|[]]]; [|discriminate]. apply in_map_iff in I as (u & <- & _). discriminate. }
  cbn [app] in Tail. rewrite <- !app_assoc in Tail. split; [reflexivity|exact Tail].
Qed.

Lemma open_alike k i j xM xS xP c : i < j <= k -> length xM = j - i + 1 -> length xS = k - j -> length xP = i ->
  let d := path_with_chord k i j in let ch := false :: xM ++ c :: xS ++ closing i xP in let x := xP ++ xM ++ xS ++ [c] in
  Permutation (map undirected (solid (joins (triangles d) (S (triangles d)) (open_shape k i j)) ch)) (map undirected (solid (inner d) x)) /\
  solids ch = solids x.
Proof.
  intros H LM LS LP. cbn zeta. unfold path_with_chord. cbn [triangles inner]. split.
  2: { assert (Q : solids (closing i xP) = solids xP) by (destruct i; [destruct xP; [reflexivity|discriminate]|apply solids_cons]).
       change (false :: xM ++ c :: xS ++ closing i xP) with ([false] ++ xM ++ [c] ++ xS ++ closing i xP). rewrite !solids_app, Q.
       change (solids [false]) with 0. lia. }
  set (n := k + 2).
  assert (J : joins n (S n) (open_shape k i j) = (S n, k) :: path_edges (k :: seq i (j - i) ++ [k + 1]) ++ (k, k + 1) ::
    path_edges (k + 1 :: seq j (k - j)) ++ joins k (last (seq j (k - j)) (k + 1)) (behind i)).
  { unfold open_shape. cbn [joins]. f_equal. rewrite (seq_head i (j - i)) by lia. cbn [app path_edges]. rewrite joins_next.
    replace (j - i - 1) with (j - S i) by lia. cbn [app]. f_equal. f_equal. rewrite last_last. cbn [joins]. f_equal. now rewrite joins_next. }
  rewrite J. clear J. cbn [solid].
  assert (Lb : forall t, length (joins k t (behind i)) = length (closing i xP)).
  { intros t. rewrite joins_length. destruct i as [|i']; [reflexivity|]. cbn [closing behind length]. rewrite app_length, map_length, seq_length. cbn. lia. }
  assert (L1 : length (path_edges (k :: seq i (j - i) ++ [k + 1])) = length xM) by (rewrite path_length, app_length, seq_length; cbn; lia).
  assert (L2 : length (path_edges (k + 1 :: seq j (k - j))) = length xS) by (rewrite path_length, seq_length; lia).
  rewrite solid_app by congruence. cbn [app].
  change ((k, k + 1) :: path_edges (k + 1 :: seq j (k - j)) ++ joins k (last (seq j (k - j)) (k + 1)) (behind i)) with
    ([(k, k + 1)] ++ path_edges (k + 1 :: seq j (k - j)) ++ joins k (last (seq j (k - j)) (k + 1)) (behind i)).
  change (c :: xS ++ closing i xP) with ([c] ++ xS ++ closing i xP). rewrite solid_app by reflexivity. rewrite solid_app by congruence.
  assert (P0 : path_edges (seq 0 i ++ k :: seq i (j - i) ++ k + 1 :: seq j (k - j)) =
    path_edges (seq 0 i ++ [k]) ++ path_edges (k :: seq i (j - i) ++ [k + 1]) ++ path_edges (k + 1 :: seq j (k - j))).
  { rewrite path_edges_join. f_equal. exact (path_edges_join (k :: seq i (j - i)) (k + 1) (seq j (k - j))). }
  rewrite P0. clear P0. rewrite <- !app_assoc.
  assert (L0 : length (path_edges (seq 0 i ++ [k])) = length xP).
  { destruct i as [|i']; [cbn; lia|]. cbn [seq app]. rewrite path_length, app_length, seq_length. cbn. lia. }
  rewrite (solid_app (path_edges (seq 0 i ++ [k]))) by congruence. rewrite (solid_app (path_edges (k :: seq i (j - i) ++ [k + 1]))) by congruence.
  rewrite (solid_app (path_edges (k + 1 :: seq j (k - j)))) by congruence. rewrite !map_app.
  assert (Q : map undirected (solid (joins k (last (seq j (k - j)) (k + 1)) (behind i)) (closing i xP)) = map undirected (solid (path_edges (seq 0 i ++ [k])) xP)).
  { destruct i as [|i']; [reflexivity|]. cbn [behind closing joins solid]. rewrite joins_next. cbn [joins seq app].
    rewrite path_edges_snoc. destruct (cut_last xP i' ltac:(lia)) as (x1 & b & -> & Lx).
    rewrite !solid_app by (rewrite path_length, seq_length; lia). rewrite !map_app. f_equal. destruct b; [|reflexivity]. cbn. f_equal. unfold undirected. cbn. f_equal; lia. }
  rewrite Q. clear Q. set (SP := map undirected (solid (path_edges (seq 0 i ++ [k])) xP)). set (SM := map undirected (solid (path_edges (k :: _)) xM)).
  set (SS := map undirected (solid (path_edges (k + 1 :: _)) xS)). set (SC := map undirected (solid [(k, k + 1)] [c])).
  rewrite (Permutation_app_comm SP). rewrite <- !app_assoc. apply Permutation_app_head. rewrite (app_assoc SC), (Permutation_app_comm SC SS), <- app_assoc. reflexivity.
Qed.

Section Open.
  Variable H : header.
  Variable R : kinds.
  Hypotheses (finite : closed H R = true) (meet : meetings_ok H (listed R) = true).

  Theorem open_split_walked k i j : 1 <= k -> i < j <= k -> right_walk (open_split k i j) false (open_split_walk H k i j).
  Proof.
    intros Hk Hj. assert (E : ports (open_split k i j) = k) by apply seq_length.
    assert (A0 : drawn_along (before (open_split k i j)) (ports (open_split k i j)) (open_route k) (k - 1) 0 0) by (rewrite E; apply open_along; lia).
    assert (A1 : drawn_along (after (open_split k i j)) (ports (open_split k i j)) (chord_route k i j) (j + 1) (k - j) 1) by (rewrite E; apply chord_along; lia).
    split; [eapply along_well_formed, A0|]. split; [eapply along_well_formed, A1|].
    intros s c st J Ls Lc D V T. rewrite E in *. set (lab := label_in st) in *.
    set (w1 := stretch s J lab i (j - i)). set (wS := stretch s J lab j (k - j)). set (wP := stretch s J lab 0 i). set (w2 := wP ++ (Edge, 0) :: wS).
    assert (M1 : w1 = rev (map (mark_any k s J lab) (seq i (j - i)))) by (apply stretch_any; lia).
    assert (MS : wS = rev (map (mark_any k s J lab) (seq j (k - j)))) by (apply stretch_any; lia).
    assert (MP : wP = rev (map (mark_any k s J lab) (seq 0 i))) by (apply stretch_any; lia).
    assert (N1 : w1 <> []) by (intros Q; assert (B := stretch_length s J lab i (j - i)); fold w1 in B; rewrite Q in B; cbn in B; lia).
    assert (N2 : w2 <> []) by (unfold w2; destruct wP; discriminate).
    assert (L1 : length (map real w1) = j - i) by (rewrite map_length; apply stretch_length).
    assert (LS : length (map real wS) = k - j) by (rewrite map_length; apply stretch_length).
    assert (G1 : no_rim (map real w1)) by (rewrite M1; apply any_no_rim). assert (GS : no_rim (map real wS)) by (rewrite MS; apply any_no_rim).
    assert (P1 : map real w1 <> []) by (now destruct w1).
    assert (C : in_a_round (order w1 ++ order w2)).
    { pose proof (round_right false k s J lab T (labels_near _ k false s c st E D (near_open k s c Ls V)) i ltac:(lia)) as Rr.
      unfold turned_order in Rr. rewrite filter_app, map_app in Rr. unfold w1, w2, wS, wP. rewrite order_app.
      change (order ((Edge, 0) :: stretch s J lab j (k - j))) with (order (stretch s J lab j (k - j))). rewrite !order_stretch, app_assoc, <- map_app, <- filter_app.
      replace (seq i (j - i) ++ seq j (k - j)) with (seq i (k - i)); [exact Rr|]. replace (k - i) with ((j - i) + (k - j)) by lia. rewrite seq_app.
      now replace (i + (j - i)) with j by lia. }
    assert (F2 : fitting w2) by (apply fits_edge; [apply (stretch_fits k s J lab false 0 i T); lia|apply (stretch_fits k s J lab false j (k - j) T); lia]).
    assert (E2 : edges (map fst w2) <= 1).
    { unfold w2. rewrite map_app. cbn [map fst].
      assert (Ed : forall a b, edges (a ++ b) = edges a + edges b) by (induction a as [|[| | |] a IH]; intros b; cbn; rewrite ?IH; reflexivity).
      rewrite Ed. cbn [edges]. rewrite MP, MS, !any_edges. lia. }
    assert (Len : length (inner (after (open_split k i j))) = i + (j - i + 1) + (k - j) + 1) by (rewrite (parts _ _ _ _ _ _ A1); lia).
    (* what is played along the shape *)
    assert (Sh : forall xP xM xS ch, length xP = i -> length xM = j - i + 1 -> length xS = k - j -> forall o,
      total (play (map (step_of k s lab) (open_shape k i j)) (false :: xM ++ ch :: xS ++ closing i xP) blank_frontier 0 0) = two_more o ->
      plays (open_split k i j) s lab (xP ++ xM ++ xS ++ [ch]) o).
    { intros xP xM xS ch LxP LxM LxS o Q. eapply total_plays; [exact Q|]. rewrite E. clear Q.
      destruct (open_possible k i j (path_with_chord k i j) s lab xM xS xP ch Hj LxM LxS LxP) as [Q1 Q2].
      destruct (open_alike k i j xM xS xP ch Hj LxM LxS LxP) as [Q3 Q4]. destruct A1 as [O1 O2 O3 _ _ _ _].
      apply (shape_plays (path_with_chord k i j) k (open_shape k i j) s lab); auto.
      unfold open_shape. cbn [triangles_of triangles path_with_chord]. rewrite triangles_app, triangles_next. cbn [triangles_of]. rewrite triangles_app, triangles_next.
      assert (Qb : triangles_of (behind i) = seq 0 i).
      { destruct i as [|i']; [reflexivity|]. cbn [behind triangles_of seq]. rewrite triangles_app, triangles_next. cbn. now rewrite app_nil_r. }
      rewrite Qb, seq_two, (seq_parts j k), (seq_parts i j) by lia. rewrite (seq_head i (j - i)) by lia. replace (j - i - 1) with (j - S i) by lia.
      rewrite <- !app_assoc. cbn [app].
      set (X := seq (S i) (j - S i)). set (Y := seq j (k - j)). set (Z := seq 0 i).
      change (Permutation ([k; i] ++ X ++ [k + 1] ++ Y ++ Z) (Z ++ [i] ++ X ++ Y ++ [k; k + 1])).
      rewrite (Permutation_app_comm Z). rewrite <- !app_assoc. rewrite (Permutation_app_comm [k; i]). rewrite <- !app_assoc.
      change ([i] ++ X ++ Y ++ [k; k + 1] ++ Z) with ([i] ++ (X ++ Y ++ [k; k + 1] ++ Z)). rewrite (Permutation_app_comm [i]). rewrite <- !app_assoc.
      apply Permutation_app_head. rewrite (app_assoc [k + 1]), (Permutation_app_comm [k + 1]), <- !app_assoc. apply Permutation_app_head.
      change ([k; k + 1] ++ Z ++ [i]) with ([k] ++ [k + 1] ++ Z ++ [i]). rewrite (app_assoc [k]), (Permutation_app_comm [k] [k + 1]), <- app_assoc.
      apply Permutation_app_head. rewrite (Permutation_app_comm Z [k; i]), (Permutation_app_comm Z [i]). reflexivity. }
    assert (St : map (step_of k s lab) (open_shape k i j) = Put None :: steps true (map real w1) ++ [Next None; Chord] ++ steps false (map real wS) ++
      map (step_of k s lab) (behind i)).
    { rewrite M1, MS, steps_next. rewrite (seq_head i (j - i)) by lia. rewrite steps_mark. replace (j - i - 1) with (j - S i) by lia.
      unfold open_shape. cbn [map]. rewrite !map_app. cbn [map app]. rewrite !map_app. rewrite <- !app_assoc.
      assert (O : forall t, k <= t -> port_of k s lab t = None) by (intros t Ht; unfold port_of; destruct (Nat.ltb_spec t k); [lia|reflexivity]).
      unfold step_of at 1 2. cbn [fst snd]. rewrite (O k) by lia. do 3 f_equal. cbn [map app]. unfold step_of at 1. cbn [fst snd]. rewrite (O (k + 1)) by lia. reflexivity. }
    pose proof (ring_best H R finite meet w1 w2 (stretch_fits k s J lab false i (j - i) T ltac:(lia)) F2 N1 N2 ltac:(rewrite M1; apply any_edges) E2 C) as B.
    unfold open_split_walk, meet_arcs.
    assert (B1 : map fst w1 = letters s J i (j - i)) by apply stretch_letters.
    assert (B2 : map fst w2 = letters s J 0 i ++ Edge :: letters s J j (k - j)) by (unfold w2; rewrite map_app; cbn [map fst]; unfold wP, wS; now rewrite !stretch_letters).
    rewrite B1, B2 in B. set (ls1 := letters s J i (j - i)) in *. set (ls2 := letters s J 0 i ++ Edge :: letters s J j (k - j)) in *.
    destruct (meeting H (arc_class H ls1) (arc_class H ls2)) as [[e1 e2] ch]. destruct B as (v & Rv & B).
    assert (Lt1 : length (trace H ls1 e1) = j - i) by (rewrite trace_length; apply letters_length).
    assert (Lt2 : length (trace H ls2 e2) = i + S (k - j)) by (rewrite trace_length; unfold ls2; rewrite app_length; cbn; now rewrite !letters_length).
    (* the boundary's links are dashed *)
    assert (Rim_dashed : forall a b' cS q, length a = length (map real wP) -> length cS = length (map real wS) ->
      run (map real w2) (a ++ b' :: cS) = Some q -> b' = false).
    { intros a b' cS q La LcS Q. unfold w2 in Q. rewrite map_app in Q. cbn [map real fst] in Q. unfold run in Q. rewrite grun_app in Q by exact La.
      destruct b'; [|reflexivity]. cbn [grun] in Q. destruct (grun true outer kept (map real wS) cS) as [[f [n m]]|]; [|discriminate].
      destruct (true && null (map real wS)); discriminate. }
    destruct (cut_at (trace H ls2 e2) i (S (k - j)) Lt2) as (tP & [|b' tS] & Et & LtP & LtS); [discriminate|]. injection LtS as LtS.
    assert (LwP : length (map real wP) = i) by (rewrite map_length; apply stretch_length).
    assert (Eb : b' = false).
    { unfold ring_run in Rv. destruct (run (map real w1) (trace H ls1 e1)) as [g1|]; [|discriminate]. cbn [obind] in Rv. rewrite Et in Rv.
      destruct (run (map real w2) (tP ++ b' :: tS)) as [q|] eqn:Q; [|discriminate]. eapply Rim_dashed; [| |exact Q]; lia. }
    subst b'.
    destruct i as [|i'].
    - (* nothing after the boundary *)
      destruct tP; [|discriminate]. cbn [app] in Et. assert (W2 : map real w2 = Rim :: map real wS) by reflexivity.
      assert (Pl : forall c1 r1 c' cS, length c1 = j - 0 -> length cS = k - j ->
        plays (open_split k 0 j) s lab ([] ++ (rev c1 ++ [r1]) ++ rev cS ++ [c']) (ring_run (map real w1) (map real w2) c1 r1 c' (false :: cS) false)).
      { intros c1 r1 c' cS K1 K2. apply Sh; [reflexivity|rewrite app_length, rev_length; cbn; lia|rewrite rev_length; lia|].
        rewrite St, W2. rewrite (open_ring_played (map real w1) (map real wS) c1 r1 c' cS false G1 P1 ltac:(lia) GS ltac:(lia)).
        cbn [closing behind map]. rewrite !app_nil_r. rewrite <- !app_assoc. reflexivity. }
      assert (Es : solid_link e2 = false).
      { rewrite Et, W2 in Rv. pose proof (open_ring_played (map real w1) (map real wS) (trace H ls1 e1) (solid_link e1) ch tS (solid_link e2) G1 P1 ltac:(lia) GS ltac:(lia)) as Q.
        rewrite Rv in Q. destruct (solid_link e2); [discriminate|reflexivity]. }
      assert (Ex : skipn (k - j + 2) (links H ls2 e2) ++ links H ls1 e1 ++ firstn (k - j) (links H ls2 e2) ++ [ch] =
        [] ++ (rev (trace H ls1 e1) ++ [solid_link e1]) ++ rev tS ++ [ch]).
      { rewrite !links_eq, Et. cbn [rev]. rewrite <- app_assoc. cbn [app].
        rewrite skipn_all2 by (rewrite app_length, rev_length; cbn; lia). cbn [app]. do 2 f_equal.
        rewrite firstn_app, rev_length. replace (k - j - length tS) with 0 by lia. cbn [firstn]. rewrite app_nil_r. rewrite <- LtS at 1. rewrite <- (rev_length tS), firstn_all. reflexivity. }
      rewrite Ex. apply (played_best _ s c st _ v D).
      + rewrite Len, !app_length, !rev_length, Lt1. cbn. lia.
      + rewrite Et, Es in Rv. rewrite <- Rv. apply Pl; lia.
      + intros y Ly. rewrite Len in Ly. destruct (cut_last y _ Ly) as (y' & c' & -> & Ly'). destruct (cut_at y' (j - 0 + 1) (k - j) ltac:(lia)) as (x1 & x2 & -> & La & Lb).
        destruct (cut_last x1 _ La) as (y1 & r1 & -> & L3). destruct (as_reversed y1) as (c1 & -> & R1). destruct (as_reversed x2) as (cS & -> & R2).
        exists (ring_run (map real w1) (map real w2) c1 r1 c' (false :: cS) false). split; [|intros u; apply B].
        rewrite <- app_assoc. apply (Pl c1 r1 c' cS); lia.
    - (* triangles after it *)
      set (P := map real (rev (map (mark_any k s J lab) (seq 1 i')))).
      assert (W2 : map real w2 = P ++ Tri (port_of k s lab 0) :: Rim :: map real wS).
      { unfold w2. rewrite map_app, MP. cbn [seq map rev]. rewrite map_app, <- app_assoc. cbn [map app]. rewrite real_mark. reflexivity. }
      assert (GP : no_rim P) by apply any_no_rim. assert (LP : length P = i') by (unfold P; rewrite map_length, rev_length, map_length; apply seq_length).
      assert (Pl : forall c1 r1 c' cS cP r2, length c1 = j - S i' -> length cS = k - j -> length cP = i' ->
        plays (open_split k (S i') j) s lab ((rev cP ++ [r2]) ++ (rev c1 ++ [r1]) ++ rev cS ++ [c'])
          (ring_run (map real w1) (map real w2) c1 r1 c' (cP ++ false :: false :: cS) r2)).
      { intros c1 r1 c' cS cP r2 K1 K2 K3. apply Sh; [rewrite app_length, rev_length; cbn; lia|rewrite app_length, rev_length; cbn; lia|rewrite rev_length; lia|].
        rewrite St, W2. rewrite <- (put_ring_played (map real w1) (map real wS) c1 r1 c' cS r2 (port_of k s lab 0) P cP G1 P1 ltac:(lia) GS ltac:(lia) GP ltac:(lia)).
        cbn [closing behind map]. rewrite map_app. unfold P. rewrite steps_next. rewrite <- !app_assoc. cbn [app]. reflexivity. }
      assert (Lp' : length tP = i' + 1) by lia. destruct (cut_last tP _ Lp') as (cP & b & -> & LcP).
      assert (Eb : b = false).
      { destruct b; [|reflexivity]. rewrite Et, W2 in Rv. rewrite <- app_assoc in Rv. cbn [app] in Rv.
        rewrite (rim_ring_played (map real w1) (map real wS) (trace H ls1 e1) (solid_link e1) ch tS (solid_link e2) (port_of k s lab 0) P cP true G1 P1 ltac:(lia) GS ltac:(lia) GP ltac:(lia)) in Rv.
        discriminate. }
      subst b.
      assert (Ex : skipn (k - j + 2) (links H ls2 e2) ++ links H ls1 e1 ++ firstn (k - j) (links H ls2 e2) ++ [ch] =
        (rev cP ++ [solid_link e2]) ++ (rev (trace H ls1 e1) ++ [solid_link e1]) ++ rev tS ++ [ch]).
      { rewrite !links_eq, Et. rewrite !rev_app_distr. cbn [rev app]. rewrite <- !app_assoc. cbn [app].
        assert (Z1 : skipn (k - j + 2) (rev tS ++ false :: false :: rev cP ++ [solid_link e2]) = rev cP ++ [solid_link e2]).
        { rewrite skipn_app, rev_length. rewrite skipn_all2 by (rewrite rev_length; lia). replace (k - j + 2 - length tS) with 2 by lia. reflexivity. }
        assert (Z2 : firstn (k - j) (rev tS ++ false :: false :: rev cP ++ [solid_link e2]) = rev tS).
        { rewrite firstn_app, rev_length. replace (k - j - length tS) with 0 by lia. cbn [firstn]. rewrite app_nil_r. apply firstn_all2. rewrite rev_length. lia. }
        rewrite Z1, Z2. rewrite <- !app_assoc. reflexivity. }
      rewrite Ex. apply (played_best _ s c st _ v D).
      + rewrite Len, !app_length, !rev_length, Lt1. cbn. lia.
      + rewrite Et in Rv. rewrite <- app_assoc in Rv. cbn [app] in Rv. rewrite <- Rv. apply Pl; lia.
      + intros y Ly. rewrite Len in Ly. destruct (cut_last y _ Ly) as (y' & c' & -> & Ly'). destruct (cut_at y' (S i') ((j - S i' + 1) + (k - j)) ltac:(lia)) as (x0 & y'' & -> & L0 & Lr).
        destruct (cut_at y'' _ _ Lr) as (x1 & x2 & -> & La & Lb). destruct (cut_last x0 i' ltac:(lia)) as (y0 & r2 & -> & L5).
        destruct (cut_last x1 _ La) as (y1 & r1 & -> & L3). destruct (as_reversed y0) as (c0 & -> & R0). destruct (as_reversed y1) as (c1 & -> & R1). destruct (as_reversed x2) as (cS & -> & R2).
        exists (ring_run (map real w1) (map real w2) c1 r1 c' (c0 ++ false :: false :: cS) r2). split; [|intros u; apply B].
        match goal with |- plays _ _ _ ?z _ => replace z with ((rev c0 ++ [r2]) ++ (rev c1 ++ [r1]) ++ rev cS ++ [c']) by now rewrite <- !app_assoc end.
        apply Pl; lia.
  Qed.
End Open.
