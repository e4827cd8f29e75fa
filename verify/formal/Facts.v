(** * The facts for every k

    The routes of each family, before and after, as words that arrows allow; and from what holds at the end of every class,
    how many strips and isolated triangles an answer may add. *)
Require Import Arith Bool List Permutation ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Graph Drawing Checker Frontier Fold Route EveryFan Serves Entries Classes Closure.

(** ** From classes to fans *)
Section Fact.
  Variables (p : patch) (sh0 : shape) (m0 r0 q0 : nat) (sh : shape) (m r q : nat).
  Hypotheses (A0 : drawn_along (before p) (ports p) sh0 m0 r0 q0) (A1 : drawn_along (after p) (ports p) sh m r q).
  Variables (arrows : list arrow) (ends : nat -> option (Z * Z)) (last_before last_after : list template) (R : classes).
  Hypothesis checked : all_within arrows ends last_before last_after R = true.
  Variables (stage : nat) (bS bI : Z) (strips alone : nat).
  Hypotheses (at_stage : ends stage = Some (bS, bI))
    (words : forall P : nat -> option nat, (forall t, ports p <= t -> P t = None) -> exists B A, path arrows stage B A /\
      forall st : kind * nat -> step, (forall x, st x = step_from (P (snd x)) (fst x, true)) ->
        map st sh0 = B ++ map (step_from None) last_before /\ map st sh = A ++ map (step_from None) last_after)
    (enough_strips : (Z.of_nat (triangles (after p)) - Z.of_nat (triangles (before p)) - bS <= Z.of_nat strips)%Z)
    (enough_alone : (bI <= Z.of_nat alone)%Z).

  Theorem fact_within : within p (fold_table p sh m q) strips alone.
  Proof.
    intros s c x Ls Lc E. pose proof (along_well_formed p _ _ _ _ _ A0) as W.
    pose proof (fold_correct p sh m r q W A1 s c Ls Lc) as [Cv Cn]. pose proof (drawn_ok p (before p) s c W) as D.
    unfold fold_table in *. destruct (drawn (before p) s c) as [st|]; [|discriminate]. destruct D as [D V].
    destruct (Cv V) as (x' & E' & [Lx Bx]). rewrite E in E'. injection E' as <-. clear Cv Cn.
    set (lab := label_in st) in *.
    destruct (words (port_of (ports p) s lab)) as (B & A & P & Eq).
    { intros t Ht. unfold port_of. destruct (Nat.ltb_spec t (ports p)); [lia|reflexivity]. }
    destruct (Eq (step_of (ports p) s lab)) as [Eb Ea]; [intros [[| | |] t]; reflexivity|].
    assert (Al : allowed (ports p) lab (drawing (before p) s c)).
    { split; [exact V|]. intros i j Hi Hj L. destruct D as (_ & _ & K). apply K; [unfold size, ports in *; lia..|exact L]. }
    pose proof (along_plays _ _ _ _ _ _ s lab c A0 Ls Lc) as Pb.
    destruct (play (map (step_of (ports p) s lab) sh0) (choices m0 r0 c) blank_frontier 0 0) as [[f [n i]]|] eqn:Qb; [|contradiction].
    destruct Pb as (_ & En & Ei). rewrite Eb in Qb.
    destruct (path_within arrows ends last_before last_after R checked stage B A bS bI P at_stage _ _ _ _ Qb)
      as (c' & g & mm & j & Py & HS & HI & Best). rewrite <- Ea in Py, Best.
    destruct (played p sh m r q A1 s lab c' _ Py) as [Ly Ey]. set (y := arranged m q (tl c')) in *. rewrite <- Ey in Py.
    pose proof (along_plays _ _ _ _ _ _ s lab y A1 Ls Ly) as Pl. rewrite Py in Pl. destruct Pl as (Aly & Eny & Eiy).
    apply (allowed_legal p st s c y D Ly) in Aly. specialize (Bx y Aly).
    assert (Lxx : length x = length (inner (after p))) by apply Lx. apply (allowed_legal p st s c x D Lxx) in Lx.
    pose proof (along_plays _ _ _ _ _ _ s lab x A1 Ls Lxx) as Px.
    destruct (play (map (step_of (ports p) s lab) sh) (choices m r x) blank_frontier 0 0) as [[fx [nx ix]]|] eqn:Qx; [|contradiction].
    destruct Px as (_ & Enx & Eix). pose proof (Best _ _ _ Qx) as G. unfold is_good in G. rewrite good_spec in G. cbn [fst snd] in G.
    unfold as_good in Bx. lia.
  Qed.
End Fact.

(** ** Words *)
Definition nx : list template := [(next, true)].
Definition mk : list template := [(mark, true)].
Definition pt : list template := [(put, true)].
Definition new_chord : list template := [(next, false); (chord, false)].
Definition closing : list template := [(chord, false)].
Definition swap (a : arrow) : arrow := Arrow (from a) (to a) (ported a) (drawn_after a) (drawn_before a).

(** Stages of a split: 1, 2 before D (one triangle, more), 3, 4 after D; 6 when the first arc is a single triangle, 7 when
    the second one is (so far), 5 otherwise. *)
Definition split_arrows : list arrow := [
  Arrow 0 1 true pt [(put, false); (mark, true)];
  Arrow 1 2 true mk nx; Arrow 2 2 true nx nx;
  Arrow 1 3 false [] new_chord; Arrow 2 4 false [] new_chord;
  Arrow 3 6 true mk nx; Arrow 6 6 true nx nx;
  Arrow 4 7 true nx nx; Arrow 7 5 true nx nx; Arrow 5 5 true nx nx].
(** Stages of an open split: 1 before A, 2 and 3 after A (at gap 0, later), 4 and 5 after one triangle and more between A and
    D, 6 and 7 the same after D. *)
Definition open_arrows : list arrow := [
  Arrow 0 1 true pt pt; Arrow 1 1 true nx nx;
  Arrow 0 2 false [] [(put, false)]; Arrow 1 3 false [] [(next, false)];
  Arrow 2 4 true pt mk; Arrow 3 4 true nx mk;
  Arrow 4 5 true nx nx; Arrow 5 5 true nx nx;
  Arrow 4 6 false [] new_chord; Arrow 5 7 false [] new_chord;
  Arrow 6 6 true nx nx; Arrow 7 7 true nx nx].
(** Stages of a boundary split: 1, 2 before A, 3 after A at gap 0, 4 after A at gap 1, 5 directly after A, 6 one triangle
    later, 7 more. *)
Definition boundary_arrows : list arrow := [
  Arrow 0 1 true pt pt; Arrow 1 2 true nx nx; Arrow 2 2 true nx nx;
  Arrow 0 3 false [] [(put, false)]; Arrow 3 7 true pt nx;
  Arrow 1 4 false [] [(next, false)]; Arrow 4 4 true nx nx;
  Arrow 2 5 false [] [(next, false)]; Arrow 5 6 true nx nx; Arrow 6 7 true nx nx; Arrow 7 7 true nx nx].

Lemma path_swap arrows q B A : path arrows q B A -> path (map swap arrows) q A B.
Proof.
  intros P. induction P as [|a p B A I P IH N]; [constructor|]. exact (path_on (map swap arrows) (swap a) p A B (in_map swap _ _ I) IH N).
Qed.

Section Words.
  Variables (arrows : list arrow) (P : nat -> option nat).
  Definition N (t : nat) : step := Next (P t).

  Lemma path_to a t q B A B' A' : path arrows q B A -> In a arrows -> from a = q ->
    B' = B ++ map (step_from (if ported a then P t else None)) (drawn_before a) ->
    A' = A ++ map (step_from (if ported a then P t else None)) (drawn_after a) -> path arrows (to a) B' A'.
  Proof. intros Pq I <- -> ->. apply path_on; auto. intros E. now rewrite E. Qed.

  Lemma path_nexts q l : In (Arrow q q true nx nx) arrows -> forall B A, path arrows q B A ->
    path arrows q (B ++ map N l) (A ++ map N l).
  Proof.
    intros I. induction l as [|t l IH]; intros B A Pq; [now rewrite !app_nil_r|]. cbn [map].
    change (N t :: map N l) with ([N t] ++ map N l). rewrite !app_assoc. apply IH.
    exact (path_to (Arrow q q true nx nx) t q B A _ _ Pq I eq_refl eq_refl eq_refl).
  Qed.
End Words.

Lemma seq_more a n : 1 <= n -> seq a n = a :: seq (S a) (n - 1).
Proof. destruct n as [|n]; [lia|]. intros _. simpl. now rewrite Nat.sub_0_r. Qed.
Lemma map_nexts (st : kind * nat -> step) P l : (forall x, st x = step_from (P (snd x)) (fst x, true)) ->
  map st (map (pair next) l) = map (N P) l.
Proof. intros E. rewrite map_map. apply map_ext. intros t. apply E. Qed.

(** The steps of a route, spelt out on both sides. *)
Ltac spell k P E Pn :=
  cbn [seq app map Nat.sub]; repeat (rewrite ?map_app; cbn [app map]); repeat rewrite (map_nexts _ P) by exact E;
  rewrite ?E; cbn; rewrite ?(Pn k (le_n k)), ?(Pn (k + 1) (Nat.le_add_r k 1)); split; repeat (rewrite <- ?app_assoc; cbn [app]); reflexivity.

Lemma split_words k a (P : nat -> option nat) : 3 <= k -> 1 <= a < k -> (forall t, k <= t -> P t = None) ->
  exists q B A, (q = if a =? 1 then 6 else if k - a =? 1 then 7 else 5) /\ path split_arrows q B A /\
    forall st : kind * nat -> step, (forall x, st x = step_from (P (snd x)) (fst x, true)) ->
      map st (closed_route k) = B ++ map (step_from None) closing /\ map st (ring_route k a) = A ++ map (step_from None) closing.
Proof.
  intros Hk Ha Pn.
  assert (P1 : path split_arrows 1 [Put (P 0)] [Put None; Mark (P 0)]).
  { apply (path_to split_arrows P (Arrow 0 1 true pt [(put, false); (mark, true)]) 0 0 [] []); [constructor|now left|reflexivity..]. }
  destruct (Nat.eqb_spec a 1) as [->|Na].
  - pose proof (path_to split_arrows P (Arrow 1 3 false [] new_chord) 0 1 _ _ _ _ P1 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P3.
    pose proof (path_to split_arrows P (Arrow 3 6 true mk nx) 1 3 _ _ _ _ P3 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P6.
    apply (path_nexts split_arrows P 6 (seq 2 (k - 2))) in P6; [|simpl; tauto]. eexists 6, _, _. split; [reflexivity|]. split; [exact P6|].
    intros st E. unfold closed_route, ring_route, route. rewrite (seq_more 1 (k - 1)) by lia.
    replace (k - 1 - 1) with (k - 2) by lia. spell k P E Pn.
  - pose proof (path_to split_arrows P (Arrow 1 2 true mk nx) 1 1 _ _ _ _ P1 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P2.
    apply (path_nexts split_arrows P 2 (seq 2 (a - 2))) in P2; [|simpl; tauto].
    pose proof (path_to split_arrows P (Arrow 2 4 false [] new_chord) 0 2 _ _ _ _ P2 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P4.
    pose proof (path_to split_arrows P (Arrow 4 7 true nx nx) a 4 _ _ _ _ P4 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P7.
    assert (S1 : seq 1 (k - 1) = 1 :: seq 2 (a - 2) ++ a :: seq (S a) (k - a - 1)).
    { rewrite (seq_more 1) by lia. f_equal. replace (k - 1 - 1) with ((a - 2) + (k - a)) by lia. rewrite seq_app. f_equal.
      replace (2 + (a - 2)) with a by lia. now rewrite (seq_more a) by lia. }
    assert (S2 : seq 0 a = 0 :: 1 :: seq 2 (a - 2)) by (rewrite (seq_more 0), (seq_more 1) by lia; f_equal; f_equal; f_equal; lia).
    destruct (Nat.eqb_spec (k - a) 1) as [E1|N1].
    + eexists 7, _, _. split; [reflexivity|]. split; [exact P7|]. intros st E. unfold closed_route, ring_route, route. rewrite S1, S2, E1.
      spell k P E Pn.
    + pose proof (path_to split_arrows P (Arrow 7 5 true nx nx) (S a) 7 _ _ _ _ P7 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P5.
      apply (path_nexts split_arrows P 5 (seq (S (S a)) (k - a - 2))) in P5; [|simpl; tauto].
      eexists 5, _, _. split; [reflexivity|]. split; [exact P5|]. intros st E. unfold closed_route, ring_route, route.
      rewrite S1, S2, (seq_more a (k - a)), (seq_more (S a)) by lia. replace (k - a - 1 - 1) with (k - a - 2) by lia.
      spell k P E Pn.
Qed.

Lemma seq_shift_start a b n : a = b -> seq a n = seq b n.
Proof. now intros ->. Qed.
(** From a on: first up to b, then the rest. *)
Lemma seq_cut a b n : a <= b <= a + n -> seq a n = seq a (b - a) ++ seq b (a + n - b).
Proof. intros H. replace n with ((b - a) + (a + n - b)) at 1 by lia. rewrite seq_app. f_equal. apply seq_shift_start. lia. Qed.

Lemma open_words k i j (P : nat -> option nat) : 1 <= k -> i < j <= k -> (forall t, k <= t -> P t = None) ->
  exists q B A, (q = if j =? S i then 6 else 7) /\ path open_arrows q B A /\
    forall st : kind * nat -> step, (forall x, st x = step_from (P (snd x)) (fst x, true)) ->
      map st (open_route k) = B ++ map (step_from None) [] /\ map st (chord_route k i j) = A ++ map (step_from None) [].
Proof.
  intros Hk Hj Pn.
  assert (P4 : exists B A, path open_arrows 4 B A /\ forall st : kind * nat -> step, (forall x, st x = step_from (P (snd x)) (fst x, true)) ->
    B = map st ((put, 0) :: map (pair next) (seq 1 i)) /\
    A = map st (match seq 0 i ++ [k] with [] => [] | x :: l => (put, x) :: map (pair next) l end ++ [(mark, i)])).
  { destruct i as [|i].
    - pose proof (path_to open_arrows P (Arrow 0 2 false [] [(put, false)]) 0 0 [] [] _ _ (path_start _) ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P2.
      pose proof (path_to open_arrows P (Arrow 2 4 true pt mk) 0 2 _ _ _ _ P2 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P4.
      eexists _, _. split; [exact P4|]. intros st E. cbn [seq app map]. rewrite !E. cbn. rewrite ?(Pn k (le_n k)). split; reflexivity.
    - pose proof (path_to open_arrows P (Arrow 0 1 true pt pt) 0 0 [] [] _ _ (path_start _) ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P1.
      apply (path_nexts open_arrows P 1 (seq 1 i)) in P1; [|simpl; tauto].
      pose proof (path_to open_arrows P (Arrow 1 3 false [] [(next, false)]) 0 1 _ _ _ _ P1 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P3.
      pose proof (path_to open_arrows P (Arrow 3 4 true nx mk) (S i) 3 _ _ _ _ P3 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P4.
      eexists _, _. split; [exact P4|]. intros st E. rewrite seq_S. change (seq 0 (S i)) with (0 :: seq 1 i). cbn [app map Nat.add].
      repeat (rewrite ?map_app; cbn [map app]). repeat rewrite (map_nexts _ P) by exact E. rewrite !E. cbn. rewrite ?(Pn k (le_n k)).
      split; rewrite <- ?app_assoc; reflexivity. }
  destruct P4 as (B & A & P4 & EBA). destruct (Nat.eqb_spec j (S i)) as [->|Nj].
  - pose proof (path_to open_arrows P (Arrow 4 6 false [] new_chord) 0 4 _ _ _ _ P4 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P6.
    apply (path_nexts open_arrows P 6 (seq (S i) (k - S i))) in P6; [|simpl; tauto].
    eexists 6, _, _. split; [reflexivity|]. split; [exact P6|]. intros st E. destruct (EBA st E) as [-> ->].
    unfold open_route, chord_route, route. rewrite (seq_more 0 k) by lia. rewrite (seq_cut 1 (S i) (k - 1)) by lia.
    replace (S i - 1) with i by lia. replace (1 + (k - 1) - S i) with (k - S i) by lia. replace (S i - i) with 1 by lia. cbn [seq app].
    destruct (seq 0 i ++ [k]) as [|x l]; spell k P E Pn.
  - pose proof (path_to open_arrows P (Arrow 4 5 true nx nx) (S i) 4 _ _ _ _ P4 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P5.
    apply (path_nexts open_arrows P 5 (seq (S (S i)) (j - i - 2))) in P5; [|simpl; tauto].
    pose proof (path_to open_arrows P (Arrow 5 7 false [] new_chord) 0 5 _ _ _ _ P5 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P7.
    apply (path_nexts open_arrows P 7 (seq j (k - j))) in P7; [|simpl; tauto].
    eexists 7, _, _. split; [reflexivity|]. split; [exact P7|]. intros st E. destruct (EBA st E) as [-> ->].
    unfold open_route, chord_route, route. rewrite (seq_more 0 k) by lia. rewrite (seq_cut 1 (S i) (k - 1)) by lia.
    rewrite (seq_more (S i)) by lia. rewrite (seq_cut (S (S i)) j) by lia.
    replace (S i - 1) with i by lia. replace (j - S (S i)) with (j - i - 2) by lia.
    replace (S (S i) + (1 + (k - 1) - S i - 1) - j) with (k - j) by lia.
    rewrite (seq_more i (j - i)), (seq_more (S i) (j - i - 1)) by lia. replace (j - i - 1 - 1) with (j - i - 2) by lia. cbn [app].
    destruct (seq 0 i ++ [k]) as [|x l]; spell k P E Pn.
Qed.

Lemma boundary_words k i (P : nat -> option nat) : 1 <= k -> i <= k -> (forall t, k <= t -> P t = None) ->
  exists q B A, (q = if i =? 0 then 7 else if i =? 1 then 4 else if k - i =? 0 then 5 else if k - i =? 1 then 6 else 7) /\
    path boundary_arrows q B A /\
    forall st : kind * nat -> step, (forall x, st x = step_from (P (snd x)) (fst x, true)) ->
      map st (open_route k) = B ++ map (step_from None) [] /\ map st (one_route k i) = A ++ map (step_from None) [].
Proof.
  intros Hk Hi Pn. destruct (Nat.eqb_spec i 0) as [->|N0].
  - pose proof (path_to boundary_arrows P (Arrow 0 3 false [] [(put, false)]) 0 0 [] [] _ _ (path_start _) ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P3.
    pose proof (path_to boundary_arrows P (Arrow 3 7 true pt nx) 0 3 _ _ _ _ P3 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P7.
    apply (path_nexts boundary_arrows P 7 (seq 1 (k - 1))) in P7; [|simpl; tauto]. eexists 7, _, _. split; [reflexivity|]. split; [exact P7|].
    intros st E. unfold open_route, one_route, route. rewrite (seq_more 0 k), Nat.sub_0_r, (seq_more 0 k) by lia. spell k P E Pn.
  - pose proof (path_to boundary_arrows P (Arrow 0 1 true pt pt) 0 0 [] [] _ _ (path_start _) ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P1.
    destruct (Nat.eqb_spec i 1) as [->|N1].
    + pose proof (path_to boundary_arrows P (Arrow 1 4 false [] [(next, false)]) 0 1 _ _ _ _ P1 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P4.
      apply (path_nexts boundary_arrows P 4 (seq 1 (k - 1))) in P4; [|simpl; tauto]. eexists 4, _, _. split; [reflexivity|]. split; [exact P4|].
      intros st E. unfold open_route, one_route, route. rewrite (seq_more 0 k) by lia. spell k P E Pn.
    + pose proof (path_to boundary_arrows P (Arrow 1 2 true nx nx) 1 1 _ _ _ _ P1 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P2.
      apply (path_nexts boundary_arrows P 2 (seq 2 (i - 2))) in P2; [|simpl; tauto].
      pose proof (path_to boundary_arrows P (Arrow 2 5 false [] [(next, false)]) 0 2 _ _ _ _ P2 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P5.
      assert (S0 : seq 0 k = 0 :: 1 :: seq 2 (i - 2) ++ seq i (k - i)).
      { rewrite (seq_more 0 k), (seq_more 1 (k - 1)) by lia. f_equal. f_equal. rewrite (seq_cut 2 i) by lia. f_equal. f_equal. lia. }
      assert (S1 : seq 0 i = 0 :: 1 :: seq 2 (i - 2)) by (rewrite (seq_more 0), (seq_more 1) by lia; f_equal; f_equal; f_equal; lia).
      destruct (Nat.eqb_spec (k - i) 0) as [E0|M0]; [|destruct (Nat.eqb_spec (k - i) 1) as [E1|M1]].
      * eexists 5, _, _. split; [reflexivity|]. split; [exact P5|]. intros st E. unfold open_route, one_route, route. rewrite S0, S1, E0. spell k P E Pn.
      * pose proof (path_to boundary_arrows P (Arrow 5 6 true nx nx) i 5 _ _ _ _ P5 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P6.
        eexists 6, _, _. split; [reflexivity|]. split; [exact P6|]. intros st E. unfold open_route, one_route, route. rewrite S0, S1, E1. spell k P E Pn.
      * pose proof (path_to boundary_arrows P (Arrow 5 6 true nx nx) i 5 _ _ _ _ P5 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P6.
        pose proof (path_to boundary_arrows P (Arrow 6 7 true nx nx) (S i) 6 _ _ _ _ P6 ltac:(simpl; tauto) eq_refl eq_refl eq_refl) as P7.
        apply (path_nexts boundary_arrows P 7 (seq (S (S i)) (k - i - 2))) in P7; [|simpl; tauto].
        eexists 7, _, _. split; [reflexivity|]. split; [exact P7|]. intros st E. unfold open_route, one_route, route.
        rewrite S0, S1, (seq_more i), (seq_more (S i)) by lia. replace (k - i - 1 - 1) with (k - i - 2) by lia. spell k P E Pn.
Qed.
