(** * The header's answers to every family of fans *)
Require Import Arith Bool List NArith Permutation Sorted Lia.
Import ListNotations.
Require Import Statements Strips Locality Drawing Checker Rows Symmetry Frontier Fold Route EveryFan Entries.
Require Import Arcs Rings Closings Header Kinds Ends Meetings Played Keys Neighbours Walks.

Lemma links_eq H w e : links H w e = rev (trace H w e) ++ [solid_link e].
Proof. reflexivity. Qed.
Lemma trace_length H w : forall e, length (trace H w e) = length w.
Proof. induction w as [|l w IH]; intros e; [reflexivity|]. cbn. now rewrite IH. Qed.
Lemma letters_length s J i n : length (letters s J i n) = n.
Proof. unfold letters. now rewrite rev_length, map_length, seq_length. Qed.

(** ** Fans before the operation *)
Lemma path_edges_seq n : forall a e, In e (path_edges (seq a n)) -> snd e = S (fst e) /\ a <= fst e /\ snd e < a + n.
Proof.
  induction n as [|n IH]; intros a e I; [destruct I|]. destruct n as [|n]; [destruct I|]. change (path_edges (seq a (S (S n)))) with
    ((a, S a) :: path_edges (seq (S a) (S n))) in I. destruct I as [<-|I]; [cbn; lia|]. apply IH in I. lia.
Qed.
Lemma near_closed k s c : 3 <= k -> length s = k -> valid (drawing (closed_fan k) s c) ->
  forall i j, i < j < k -> linked (drawing (closed_fan k) s c) i j -> none_between s i j \/ (true = true /\ none_outside k s i j).
Proof.
  intros Hk Ls V i j H L. apply (neighbours (closed_fan k) k true s c); auto.
  intros e I. unfold closed_fan, ring_edges in I. cbn [inner] in I. destruct k as [|k]; [lia|]. cbn [seq firstn app] in I.
  rewrite path_edges_snoc in I. apply in_app_or in I as [I|[<-|[]]].
  - left. apply (path_edges_seq (S k) 0) in I. lia.
  - right. cbn [fst snd]. split; [reflexivity|]. split; [|reflexivity]. destruct k as [|k]; [reflexivity|].
    rewrite seq_S, last_last. lia.
Qed.
Lemma near_open k s c : length s = k -> valid (drawing (open_fan k) s c) ->
  forall i j, i < j < k -> linked (drawing (open_fan k) s c) i j -> none_between s i j \/ (false = true /\ none_outside k s i j).
Proof.
  intros Ls V i j H L. apply (neighbours (open_fan k) k false s c); auto.
  intros e I. left. unfold open_fan in I. cbn [inner] in I. apply path_edges_seq in I. lia.
Qed.
Lemma labels_near p k round s c st : ports p = k -> describes (size (before p)) st (drawing (before p) s c) ->
  (forall i j, i < j < k -> linked (drawing (before p) s c) i j -> none_between s i j \/ (round = true /\ none_outside k s i j)) ->
  forall t u, t < u < k -> nth t s false = true -> nth u s false = true -> label_in st t = label_in st u ->
    none_between s t u \/ (round = true /\ none_outside k s t u).
Proof.
  intros Hp D N t u Hu _ _ E. apply N; [exact Hu|]. apply D; [| |exact E]; unfold size, ports in *; lia.
Qed.

(** The colours of a patch, arc by arc. *)
Lemma cut_at {A} (l : list A) n m : length l = n + m -> exists l1 l2, l = l1 ++ l2 /\ length l1 = n /\ length l2 = m.
Proof. intros L. exists (firstn n l), (skipn n l). rewrite firstn_skipn, firstn_length, skipn_length. repeat split; lia. Qed.
Lemma cut_last {A} (l : list A) n : length l = n + 1 -> exists l1 a, l = l1 ++ [a] /\ length l1 = n.
Proof. intros L. destruct (cut_at l n 1 L) as (l1 & [|a [|b l2]] & -> & L1 & L2); try discriminate. now exists l1, a. Qed.
Lemma as_reversed {A} (l : list A) : exists m, l = rev m /\ length m = length l.
Proof. exists (rev l). now rewrite rev_involutive, rev_length. Qed.

Section Families.
  Variable H : header.
  Variable R : kinds.
  Hypotheses (finite : closed H R = true) (meet : meetings_ok H (listed R) = true) (shut : closings_ok H (listed R) = true).

  (** ** Splits of closed fans *)
  Theorem split_walked k a : 3 <= k -> 1 <= a < k -> right_walk (split k a) true (split_walk H k a).
  Proof.
    intros Hk Ha. assert (E : ports (split k a) = k) by apply seq_length.
    assert (A0 : drawn_along (before (split k a)) (ports (split k a)) (closed_route k) (k - 1) 1 0) by (rewrite E; apply closed_along; lia).
    assert (A1 : drawn_along (after (split k a)) (ports (split k a)) (ring_route k a) (a + 1) (k - a + 1) 1) by (rewrite E; apply ring_along; lia).
    split; [eapply along_well_formed, A0|]. split; [eapply along_well_formed, A1|].
    intros s c st J Ls Lc D V T. rewrite E in *. set (lab := label_in st) in *.
    set (w1 := stretch s J lab 0 a). set (w2 := stretch s J lab a (k - a)).
    assert (M1 : w1 = rev (map (mark_any k s J lab) (seq 0 a))) by (apply stretch_any; lia).
    assert (M2 : w2 = rev (map (mark_any k s J lab) (seq a (k - a)))) by (apply stretch_any; lia).
    assert (N1 : w1 <> []) by (intros Q; assert (B := stretch_length s J lab 0 a); fold w1 in B; rewrite Q in B; cbn in B; lia).
    assert (N2 : w2 <> []) by (intros Q; assert (B := stretch_length s J lab a (k - a)); fold w2 in B; rewrite Q in B; cbn in B; lia).
    assert (L1 : length (map real w1) = a) by (rewrite map_length; apply stretch_length).
    assert (L2 : length (map real w2) = k - a) by (rewrite map_length; apply stretch_length).
    assert (G1 : no_rim (map real w1)) by (rewrite M1; apply any_no_rim). assert (G2 : no_rim (map real w2)) by (rewrite M2; apply any_no_rim).
    assert (P1 : map real w1 <> []) by (now destruct w1). assert (P2 : map real w2 <> []) by (now destruct w2).
    assert (C : in_a_round (order w1 ++ order w2)).
    { pose proof (round_right true k s J lab T (labels_near _ k true s c st E D (near_closed k s c Hk Ls V)) 0 ltac:(lia)) as Rr.
      unfold turned_order in Rr. rewrite Nat.sub_0_r in Rr. cbn [seq] in Rr. rewrite app_nil_r in Rr.
      unfold w1, w2. rewrite !order_stretch, <- map_app, <- filter_app.
      replace (seq 0 a ++ seq a (k - a)) with (seq 0 k); [exact Rr|]. replace k with (a + (k - a)) at 1 by lia. now rewrite seq_app. }
    (* every colouring consists of two arcs *)
    assert (Len : length (inner (after (split k a))) = a + 1 + (k - a + 1) + 1) by (rewrite (parts _ _ _ _ _ _ A1); lia).
    assert (Pl : forall c1 r1 c2 r2 ch, length c1 = a -> length c2 = k - a ->
      plays (split k a) s lab ((rev c1 ++ [r1]) ++ (rev c2 ++ [r2]) ++ [ch]) (ring_run (map real w1) (map real w2) c1 r1 ch c2 r2)).
    { intros c1 r1 c2 r2 ch Lc1 Lc2.
      assert (Lx : length ((rev c1 ++ [r1]) ++ (rev c2 ++ [r2]) ++ [ch]) = length (inner (after (split k a)))).
      { rewrite Len, !app_length, !rev_length. cbn. lia. }
      pose proof (along_plays _ _ _ _ _ _ s lab _ A1 Ls Lx) as Q.
      apply (total_plays _ _ _ _ (play (map (step_of k s lab) (ring_route k a)) (choices (a + 1) (k - a + 1) ((rev c1 ++ [r1]) ++ (rev c2 ++ [r2]) ++ [ch])) blank_frontier 0 0)); [|rewrite E; exact Q]. clear Q.
      assert (Ch : choices (a + 1) (k - a + 1) ((rev c1 ++ [r1]) ++ (rev c2 ++ [r2]) ++ [ch]) = false :: rev c1 ++ [r1; ch] ++ rev c2 ++ [r2]).
      { unfold choices. replace (a + 1) with (length (rev c1 ++ [r1])) by (rewrite app_length, rev_length; cbn; lia).
        replace (k - a + 1) with (length (rev c2 ++ [r2])) by (rewrite app_length, rev_length; cbn; lia).
        rewrite arranged_parts, <- !app_assoc. reflexivity. }
      rewrite Ch. clear Ch.
      assert (St : map (step_of k s lab) (ring_route k a) = Put None :: steps true (map real w1) ++ [Next None; Chord] ++ steps false (map real w2) ++ [Chord]).
      { rewrite M1, M2, steps_next. destruct a as [|a']; [lia|]. cbn [seq]. rewrite steps_mark. unfold ring_route, route. cbn [seq app map].
        rewrite !map_app. cbn [map app]. rewrite !map_app. cbn [map app]. unfold step_of at 1. cbn [fst snd].
        assert (O : forall t, k <= t -> port_of k s lab t = None) by (intros t Ht; unfold port_of; destruct (Nat.ltb_spec t k); [lia|reflexivity]).
        rewrite (O k) by lia. f_equal. f_equal. rewrite <- !app_assoc. f_equal. cbn [app]. unfold step_of at 1. cbn [fst snd]. rewrite (O (k + 1)) by lia. reflexivity. }
      rewrite St. apply ring_played; auto; lia. }
    pose proof (ring_best H R finite meet w1 w2 (stretch_fits k s J lab true 0 a T ltac:(lia)) (stretch_fits k s J lab true a (k - a) T ltac:(lia)) N1 N2
      ltac:(rewrite M1; apply any_edges) ltac:(rewrite M2, any_edges; lia) C) as B.
    unfold split_walk, meet_arcs. unfold w1, w2 in B. rewrite !stretch_letters in B. fold w1 w2 in B.
    destruct (meeting H (arc_class H (letters s J 0 a)) (arc_class H (letters s J a (k - a)))) as [[e1 e2] ch].
    destruct B as (v & Rv & B). rewrite !links_eq.
    assert (Lt1 : length (trace H (letters s J 0 a) e1) = a) by now rewrite trace_length, letters_length.
    assert (Lt2 : length (trace H (letters s J a (k - a)) e2) = k - a) by now rewrite trace_length, letters_length.
    apply (played_best _ s c st _ v D).
    - rewrite Len, !app_length, !rev_length, Lt1, Lt2. cbn. lia.
    - rewrite <- Rv. now apply Pl.
    - intros y Ly. rewrite Len in Ly. destruct (cut_last y _ Ly) as (y' & ch' & -> & Ly'). destruct (cut_at y' (a + 1) (k - a + 1) ltac:(lia)) as (x1 & x2 & -> & La & Lb).
      destruct (cut_last x1 _ La) as (y1 & r1 & -> & L3). destruct (cut_last x2 _ Lb) as (y2 & r2 & -> & L4).
      destruct (as_reversed y1) as (c1 & -> & R1). destruct (as_reversed y2) as (c2 & -> & R2).
      exists (ring_run (map real w1) (map real w2) c1 r1 ch' c2 r2). split; [|intros u; apply B].
      rewrite <- (app_assoc _ _ [ch']). apply Pl; lia.
  Qed.

  (** ** Collapses onto closed fans *)
  Lemma round_trip k s J lab : 3 <= k -> tells_labels true k s J lab -> own_round (stretch s J lab 0 k).
  Proof.
    intros Hk T. unfold own_round. pose proof (info_order (stretch s J lab 0 k)) as I. cbn zeta in I. rewrite last_order.
    set (a := info_of (map fst (stretch s J lab 0 k))) in *. clearbody a. rewrite order_stretch in *. set (L := filter (fun t => nth t s false) (seq 0 k)) in *.
    assert (Sd : StronglySorted (earlier k 0) L) by (apply sorted_filter, seq_sorted; lia).
    assert (Mem : forall m, In m L <-> m < k /\ nth m s false = true) by (intros m; unfold L; rewrite filter_In, in_seq; split; intros [? ?]; (split; [lia|assumption])).
    destruct (viewed (map (mark_of s J lab) L)) as [[Q _]|[(x & Q & _)|(x & m & y & Q & Sn)]].
    - now rewrite Q.
    - rewrite Q in I |- *. cbn in I |- *. destruct I as (C & _). unfold own_ends. rewrite C. cbn. now rewrite Nat.eqb_refl.
    - destruct Sn as (Sc & S1 & S2 & _). rewrite Sc, S1, S2 in I. destruct I as (Cn & B1 & B2). rewrite Q. cbn [hd_error].
      rewrite app_comm_cons, rev_app_distr. cbn [rev app hd_error option_map label]. clear Sc S1 S2.
      change (x :: m ++ [y]) with ([] ++ x :: m ++ [y]) in Q. apply map_eq_app in Q as (P & L1 & EL & EP & Q). apply map_eq_nil in EP as ->.
      apply map_eq_cons in Q as (t & L2 & -> & <- & Q). apply map_eq_app in Q as (M & L3 & -> & <- & Q). apply map_eq_cons in Q as (u & L4 & -> & <- & Q).
      apply map_eq_nil in Q as ->. cbn [app] in EL. rewrite EL in Sd, Mem. clear EL. inversion_clear Sd as [|? ? Sd' F]. rewrite Forall_forall in F.
      assert (Bm : forall b, In b M -> earlier k 0 b u).
      { assert (W : forall l, StronglySorted (earlier k 0) (l ++ [u]) -> forall b, In b l -> earlier k 0 b u) by (intros l Sl; apply (sorted_at _ _ _ _ Sl)). now apply W. }
      unfold earlier, pos in F, Bm. cbn in F, Bm.
      assert (Htu : t < u) by (specialize (F u ltac:(apply in_or_app; right; now left)); lia).
      assert (Ht : t < k /\ nth t s false = true) by (apply Mem; now left). assert (Hu : u < k /\ nth u s false = true) by (apply Mem; right; apply in_or_app; right; now left).
      destruct Ht as [Ht St], Hu as [Hu Su].
      assert (NO : none_outside k s t u).
      { intros b Hb O. destruct (nth b s false) eqn:Sb; [exfalso|reflexivity]. assert (I : In b (t :: M ++ [u])) by (apply Mem; auto).
        destruct I as [->|I]; [lia|]. apply in_app_or in I as [I|[->|[]]]; [|lia]. specialize (Bm b I). specialize (F b ltac:(apply in_or_app; now left)). lia. }
      pose proof (by_last _ _ _ _ _ T eq_refl t u ltac:(lia) St Su NO) as Bl. unfold jn, mark_of in B1, B2 |- *. cbn [fst snd] in B1, B2 |- *.
      rewrite joined_letter in B1, B2 by assumption. unfold own_ends. rewrite Cn, B1, B2.
      assert (Nm : M = [] -> (nth u J false = true <-> lab t = lab u)).
      { intros ->. apply (by_predecessor _ _ _ _ _ T t u ltac:(lia) St Su). intros b Hb. destruct (nth b s false) eqn:Sb; [exfalso|reflexivity].
        assert (I : In b (t :: [] ++ [u])) by (apply Mem; split; [lia|exact Sb]). destruct I as [->|[->|[]]]; lia. }
      destruct (Nat.eqb_spec (lab t) (lab u)) as [El|El].
      + apply Bl in El. rewrite El, !orb_true_r. reflexivity.
      + destruct (nth t J false); [now contradiction El; apply Bl|]. rewrite orb_false_r. destruct M as [|m0 M]; cbn.
        * specialize (Nm eq_refl). destruct (nth u J false); [now contradiction El; apply Nm|reflexivity].
        * reflexivity.
  Qed.

  Theorem collapse_walked k a : 3 <= k -> 1 <= a < k -> right_walk (collapse k a) true (collapse_walk H k).
  Proof.
    intros Hk Ha. assert (E : ports (collapse k a) = k) by apply seq_length.
    assert (A0 : drawn_along (before (collapse k a)) (ports (collapse k a)) (ring_route k a) (a + 1) (k - a + 1) 1) by (rewrite E; apply ring_along; lia).
    assert (A1 : drawn_along (after (collapse k a)) (ports (collapse k a)) (closed_route k) (k - 1) 1 0) by (rewrite E; apply closed_along; lia).
    split; [eapply along_well_formed, A0|]. split; [eapply along_well_formed, A1|].
    intros s c st J Ls Lc D V T. rewrite E in *. set (lab := label_in st) in *.
    set (w := stretch s J lab 0 k).
    assert (M : w = rev (map (mark_any k s J lab) (seq 0 k))) by (apply stretch_any; lia).
    assert (N : w <> []) by (intros Q; assert (B := stretch_length s J lab 0 k); fold w in B; rewrite Q in B; cbn in B; lia).
    assert (Len : length (inner (after (collapse k a))) = k - 1 + 1) by (rewrite (parts _ _ _ _ _ _ A1); lia).
    set (its := map real (rev (map (mark_any k s J lab) (seq 1 (k - 1))))).
    assert (Mi : map real w = its ++ [Tri (port_of k s lab 0)]).
    { rewrite M. unfold its. replace (seq 0 k) with (0 :: seq 1 (k - 1)) by (destruct k; [lia|cbn; now rewrite Nat.sub_0_r]).
      cbn [map rev]. rewrite map_app. cbn [map]. now rewrite real_mark. }
    assert (Li : length its = k - 1) by (unfold its; rewrite map_length, rev_length, map_length; apply seq_length).
    assert (Gi : no_rim its) by apply any_no_rim. assert (Pi : its <> []) by (intros Q; rewrite Q in Li; cbn in Li; lia).
    assert (Pl : forall c1 r, length c1 = k - 1 ->
      plays (collapse k a) s lab (rev c1 ++ [r]) (obind (run (map real w) (c1 ++ [r])) (fun g => close g r))).
    { intros c1 r Lc1.
      assert (Lx : length (rev c1 ++ [r]) = length (inner (after (collapse k a)))) by (rewrite Len, app_length, rev_length; cbn; lia).
      pose proof (along_plays _ _ _ _ _ _ s lab _ A1 Ls Lx) as Q.
      apply (total_plays _ _ _ _ (play (map (step_of k s lab) (closed_route k)) (choices (k - 1) 1 (rev c1 ++ [r])) blank_frontier 0 0)); [|rewrite E; exact Q]. clear Q.
      assert (Ch : choices (k - 1) 1 (rev c1 ++ [r]) = false :: rev c1 ++ [r]).
      { unfold choices. replace (k - 1) with (length (rev c1)) by (rewrite rev_length; lia). rewrite <- (app_nil_r [r]).
        change 1 with (length [r]). rewrite arranged_parts. now rewrite app_nil_l, app_nil_r. }
      rewrite Ch. clear Ch.
      assert (St : map (step_of k s lab) (closed_route k) = Put (port_of k s lab 0) :: steps true its ++ [Chord]).
      { unfold its. destruct k as [|[|k']]; [lia|lia|]. cbn [Nat.sub seq]. rewrite steps_mark. unfold closed_route, route.
        cbn [seq Nat.sub app map]. rewrite !map_app. cbn [map app]. reflexivity. }
      rewrite St, Mi. apply close_played; auto. lia. }
    pose proof (close_best H R finite shut w (stretch_fits k s J lab true 0 k T ltac:(lia)) N ltac:(rewrite M; apply any_edges) (round_trip k s J lab Hk T)) as B.
    cbn zeta in B. unfold w in B at 1 2 3 4 5. rewrite !stretch_letters in B. fold w in B. unfold collapse_walk. set (ls := letters s J 0 k) in *.
    set (e := read (closed_case H) (arc_class H ls)) in *. destruct B as (g & v & Rg & Cv & B).
    assert (Lt : length (trace H ls e) = k - 1 + 1) by (rewrite trace_length; unfold ls; rewrite letters_length; lia).
    destruct (cut_last (trace H ls e) _ Lt) as (c1 & b0 & Et & Lc1).
    assert (Eb : b0 = solid_link e).
    { rewrite Et, Mi in Rg. rewrite (run_attached _ its Gi Pi c1 b0 ltac:(lia)) in Rg.
      destruct (grun true (alone_start (port_of k s lab 0)) kept its c1) as [g'|]; [|discriminate]. cbn [obind] in Rg. unfold attached, attach in Rg.
      unfold close in Cv. destruct g as [f [n i]].
      assert (Da : deg (anchor f) = if b0 then 1 else 0).
      { destruct b0; [destruct (open_end (anchor (fst g'))); [|discriminate]|]; injection Rg as <- _ _; reflexivity. }
      rewrite Da in Cv. destruct b0, (solid_link e); cbn in Cv; try discriminate; reflexivity. }
    apply (played_best _ s c st _ v D).
    - rewrite links_eq, Et. rewrite rev_app_distr. cbn [rev app tl]. rewrite Len, app_length, rev_length. cbn. lia.
    - rewrite links_eq, Et. rewrite rev_app_distr. cbn [rev app tl]. rewrite <- Cv. pose proof (Pl c1 (solid_link e) Lc1) as P.
      rewrite <- Eb in P at 2. rewrite <- Et, Rg in P. exact P.
    - intros y Ly. rewrite Len in Ly. destruct (cut_last y _ Ly) as (y1 & r & -> & L3). destruct (as_reversed y1) as (c2 & -> & R1).
      exists (obind (run (map real w) (c2 ++ [r])) (fun g => close g r)). split; [apply Pl; lia|].
      intros u Q. destruct (run (map real w) (c2 ++ [r])) as [h|] eqn:X; [|discriminate]. exact (B _ h r u X Q).
  Qed.

  (** ** Fans between boundaries *)
  Theorem path_walked p k x l (walk : coloring -> coloring -> coloring) sh0 m0 r0 q0 : ports p = k ->
    drawn_along (before p) k sh0 m0 r0 q0 -> drawn_along (after p) k (route (x :: l) [] [] false false) (length l) 0 0 ->
    (forall s J lab, tells_labels false k s J lab -> fitting (rev (map (mark_any k s J lab) (x :: l)))) ->
    (forall s J lab, walk s J = inside (links H (map fst (rev (map (mark_any k s J lab) (x :: l)))) 0)) ->
    right_walk p false walk.
  Proof.
    intros E A0 A1 Fit Wk. split; [eapply along_well_formed; rewrite E; exact A0|]. split; [eapply along_well_formed; rewrite E; exact A1|].
    intros s c st J Ls Lc D V T. rewrite E in *. set (lab := label_in st) in *.
    rewrite (Wk s J lab). specialize (Fit s J lab T). set (w := rev (map (mark_any k s J lab) (x :: l))) in *.
    assert (N : w <> []) by (unfold w; cbn [map rev]; destruct (rev (map (mark_any k s J lab) l)); discriminate).
    assert (Len : length (inner (after p)) = length l) by (rewrite (parts _ _ _ _ _ _ A1); lia).
    set (its := map real (rev (map (mark_any k s J lab) l))).
    assert (Mi : map real w = its ++ [Tri (port_of k s lab x)]) by (unfold w; cbn [map rev]; rewrite map_app; cbn [map]; now rewrite real_mark).
    assert (Li : length its = length l) by (unfold its; now rewrite map_length, rev_length, map_length).
    assert (Gi : no_rim its) by apply any_no_rim.
    assert (Pl : forall c1, length c1 = length l -> plays p s lab (rev c1) (obind (run (map real w) (c1 ++ [false])) path_end)).
    { intros c1 Lc1. assert (Lx : length (rev c1) = length (inner (after p))) by (rewrite Len, rev_length; lia).
      pose proof (along_plays _ _ _ _ _ _ s lab _ A1 Ls Lx) as Q.
      apply (total_plays _ _ _ _ (play (map (step_of k s lab) (route (x :: l) [] [] false false)) (choices (length l) 0 (rev c1)) blank_frontier 0 0)); [|rewrite E; exact Q]. clear Q.
      assert (Ch : choices (length l) 0 (rev c1) = false :: rev c1).
      { unfold choices, arranged. rewrite Nat.add_0_r. cbn [firstn]. now rewrite app_nil_r, firstn_skipn. }
      assert (St : map (step_of k s lab) (route (x :: l) [] [] false false) = Put (port_of k s lab x) :: steps false its).
      { unfold its. rewrite steps_next. unfold route. cbn [app map]. now rewrite !app_nil_r. }
      rewrite Ch, St, Mi. apply path_played; auto. lia. }
    destruct (path_best H R finite shut w Fit N ltac:(apply any_edges)) as (g & v & Rg & Pv & B).
    assert (Lt : length (trace H (map fst w) 0) = length l + 1) by (rewrite trace_length, map_length; unfold w; rewrite rev_length, map_length; cbn; lia).
    destruct (cut_last _ _ Lt) as (c1 & b0 & Et & Lc1).
    assert (Eb : b0 = false).
    { destruct b0; [|reflexivity]. pose proof (path_first_dashed (port_of k s lab x) its c1 ltac:(lia)) as Q. rewrite <- Mi, <- Et, Rg in Q. cbn [obind] in Q. congruence. }
    assert (Ex : inside (links H (map fst w) 0) = rev c1).
    { unfold inside. rewrite links_eq, Et, removelast_last, rev_app_distr. reflexivity. }
    rewrite Ex. apply (played_best _ s c st _ v D).
    - rewrite Len, rev_length. lia.
    - pose proof (Pl c1 Lc1) as P. rewrite <- Eb, <- Et, Rg in P. cbn [obind] in P. rewrite Pv in P. exact P.
    - intros y Ly. rewrite Len in Ly. destruct (as_reversed y) as (c2 & -> & R1).
      exists (obind (run (map real w) (c2 ++ [false])) path_end). split; [apply Pl; lia|].
      intros u Q. destruct (run (map real w) (c2 ++ [false])) as [h|] eqn:X; [|discriminate]. exact (B _ h u X Q).
  Qed.

  Lemma seq_cons k : 1 <= k -> seq 0 k = 0 :: seq 1 (k - 1).
  Proof. intros Hk. destruct k; [lia|]. cbn. now rewrite Nat.sub_0_r. Qed.
  Lemma fan_walked p k sh0 m0 r0 q0 : 1 <= k -> ports p = k -> after p = open_fan k -> drawn_along (before p) k sh0 m0 r0 q0 ->
    right_walk p false (fan_collapse_walk H k).
  Proof.
    intros Hk E Ea A0. apply (path_walked p k 0 (seq 1 (k - 1)) (fan_collapse_walk H k) sh0 m0 r0 q0 E A0).
    - rewrite Ea, <- seq_cons, seq_length by exact Hk. now apply open_along.
    - intros s J lab T. rewrite <- seq_cons, <- stretch_any by lia. apply (stretch_fits k s J lab false 0 k T). lia.
    - intros s J lab. rewrite <- seq_cons, <- stretch_any, stretch_letters by lia. reflexivity.
  Qed.
  Theorem open_collapse_walked k i j : 1 <= k -> i < j <= k -> right_walk (open_collapse k i j) false (fan_collapse_walk H k).
  Proof.
    intros Hk Hj. apply (fan_walked (open_collapse k i j) k (chord_route k i j) (j + 1) (k - j) 1); auto; [apply seq_length|apply chord_along; lia].
  Qed.
  Theorem boundary_collapse_walked k i : 1 <= k -> i <= k -> right_walk (boundary_collapse k i) false (fan_collapse_walk H k).
  Proof.
    intros Hk Hi. apply (fan_walked (boundary_collapse k i) k (one_route k i) k 0 0); auto; [apply seq_length|apply one_along; lia].
  Qed.
  Theorem boundary_split_walked k i : 1 <= k -> i <= k -> right_walk (boundary_split k i) false (boundary_split_walk H k i).
  Proof.
    intros Hk Hi. destruct (seq 0 i ++ k :: seq i (k - i)) as [|x l] eqn:Q; [destruct (seq 0 i); discriminate|].
    assert (Ll : length l = k) by (assert (B := f_equal (@length nat) Q); rewrite app_length in B; cbn in B; rewrite !seq_length in B; lia).
    assert (Rv : forall s J lab, rev (map (mark_any k s J lab) (x :: l)) = stretch s J lab i (k - i) ++ (Plain, 0) :: stretch s J lab 0 i).
    { intros s J lab. rewrite <- Q, map_app, rev_app_distr. cbn [map rev]. rewrite (stretch_any k s J lab i (k - i)), (stretch_any k s J lab 0 i) by lia.
      rewrite <- app_assoc. cbn [app]. unfold mark_any at 2. now rewrite Nat.ltb_irrefl. }
    apply (path_walked (boundary_split k i) k x l (boundary_split_walk H k i) (open_route k) (k - 1) 0 0).
    - apply seq_length.
    - now apply open_along.
    - rewrite Ll, <- Q. now apply one_along.
    - intros s J lab T. rewrite Rv. apply fits_plain. pose proof (stretch_app s J lab 0 i (k - i)) as Sa. cbn [Nat.add] in Sa. rewrite <- Sa.
      apply (stretch_fits k s J lab false 0 (i + (k - i)) T). lia.
    - intros s J lab. rewrite Rv, map_app. cbn [map fst]. now rewrite !stretch_letters.
  Qed.
End Families.
