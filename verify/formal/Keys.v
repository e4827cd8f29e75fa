(** * What a key says about the labels of ports *)
Require Import Arith Bool List Permutation Sorted Lia.
Import ListNotations.
Require Import Statements Checker Frontier Arcs Rings Header Kinds Ends.

(** ** Neighbouring ports of a key *)
Definition none_between (s : coloring) (t u : nat) : Prop := forall m, t < m < u -> nth m s false = false.
Definition none_outside (k : nat) (s : coloring) (t u : nat) : Prop := forall m, m < k -> m < t \/ u < m -> nth m s false = false.

Record tells_labels (round : bool) (k : nat) (s J : coloring) (lab : nat -> nat) : Prop := Tells {
  by_predecessor : forall t u, t < u < k -> nth t s false = true -> nth u s false = true -> none_between s t u ->
    (nth u J false = true <-> lab t = lab u);
  by_last : round = true -> forall t u, t < u < k -> nth t s false = true -> nth u s false = true -> none_outside k s t u ->
    (nth t J false = true <-> lab t = lab u);
  first_free : forall t, t < k -> (round = false \/ forall u, u < k -> u <> t -> nth u s false = false) ->
    (forall m, m < t -> nth m s false = false) -> nth t J false = false
}.

Lemma find_first (f : nat -> bool) l y l' : (forall x, In x l -> f x = false) -> f y = true -> find f (l ++ y :: l') = Some y.
Proof.
  induction l as [|x l IH]; intros N E; simpl; [now rewrite E|]. rewrite N by now left. apply IH; auto. intros z I. apply N. now right.
Qed.
Lemma find_nothing (f : nat -> bool) l : (forall x, In x l -> f x = false) -> find f l = None.
Proof. induction l as [|x l IH]; intros N; simpl; [reflexivity|]. rewrite N by now left. apply IH. intros z I. apply N. now right. Qed.
Lemma seq_at t n : t < n -> seq 0 n = seq 0 t ++ t :: seq (S t) (n - S t).
Proof. intros H. replace n with (t + S (n - S t)) at 1 by lia. rewrite seq_app. reflexivity. Qed.
Lemma seq_from a t n : a <= t < n -> seq a (n - a) = seq a (t - a) ++ t :: seq (S t) (n - S t).
Proof. intros H. replace (n - a) with ((t - a) + S (n - S t)) by lia. rewrite seq_app. cbn [seq]. now replace (a + (t - a)) with t by lia. Qed.

Lemma joined_tells p round s c J lab : joined p round s c J -> length s = ports p ->
  (forall i j, i < ports p -> j < ports p -> (lab i = lab j <-> linked (drawing (before p) s c) i j)) ->
  tells_labels round (ports p) s J lab.
Proof.
  intros [_ Jn] Ls Lb. split.
  - intros t u H St Su N. rewrite Lb by lia. assert (P : preceding round s u = Some t).
    { unfold preceding. rewrite (seq_at t u) by lia. rewrite rev_app_distr. cbn [rev]. rewrite <- !app_assoc. cbn [app]. apply find_first; [|exact St].
      intros x I. apply in_rev in I. apply in_seq in I. apply N. lia. }
    rewrite (Jn u) by lia. split.
    + intros (_ & j & Q & L). rewrite P in Q. injection Q as <-. apply Graph.linked_sym, L.
    + intros L. split; [exact Su|]. exists t. split; [exact P|]. now apply Graph.linked_sym.
  - intros -> t u H St Su N. rewrite Lb by lia. assert (P : preceding true s t = Some u).
    { unfold preceding. rewrite Ls. rewrite (seq_from (S t) u) by lia. rewrite rev_app_distr. cbn [rev].
      rewrite <- (app_assoc _ [u]). cbn [app]. rewrite app_assoc. apply find_first; [|exact Su].
      intros x I. apply in_app_or in I as [I|I]; apply in_rev in I; apply in_seq in I; apply N; lia. }
    rewrite (Jn t) by lia. split.
    + intros (_ & j & Q & L). rewrite P in Q. now injection Q as <-.
    + intros L. split; [exact St|]. now exists u.
  - intros t H O N. destruct (nth t J false) eqn:E; [exfalso|reflexivity]. apply (Jn t H) in E as (_ & j & Q & _).
    assert (P : preceding round s t = None); [|congruence]. unfold preceding. apply find_nothing. intros x I. apply in_app_or in I as [I|I].
    + apply in_rev in I. apply in_seq in I. apply N. lia.
    + destruct round; [|destruct I]. destruct O as [O|O]; [discriminate|]. apply in_rev in I. apply in_seq in I. apply O; lia.
Qed.

(** ** Labelled letters of a stretch of the fan *)
Section Stretch.
  Variables (k : nat) (s J : coloring) (lab : nat -> nat).
  Definition mark_of (t : nat) : labelled := (letter_at s J t, lab t).
  Definition stretch (i n : nat) : list labelled := rev (map mark_of (seq i n)).

  Lemma stretch_S i n : stretch i (S n) = mark_of (i + n) :: stretch i n.
  Proof. unfold stretch. rewrite seq_S, map_app, rev_app_distr. reflexivity. Qed.
  Lemma stretch_app i n m : stretch i (n + m) = stretch (i + n) m ++ stretch i n.
  Proof. unfold stretch. now rewrite seq_app, map_app, rev_app_distr. Qed.
  Lemma stretch_letters i n : map fst (stretch i n) = letters s J i n.
  Proof. unfold stretch, letters. now rewrite map_rev, map_map. Qed.
  Lemma stretch_length i n : length (stretch i n) = n.
  Proof. unfold stretch. now rewrite rev_length, map_length, seq_length. Qed.
  Lemma solid_letter t : is_solid (letter_at s J t) = nth t s false.
  Proof. unfold letter_at. destruct (nth t s false); [|reflexivity]. now destruct (nth t J false). Qed.
  Lemma joined_letter t : nth t s false = true -> is_joined (letter_at s J t) = nth t J false.
  Proof. unfold letter_at. intros ->. now destruct (nth t J false). Qed.

  Lemma near_stretch i n y : near_label (stretch i n) = Some y ->
    exists t, i <= t < i + n /\ nth t s false = true /\ lab t = y /\ none_between s t (i + n).
  Proof.
    induction n as [|n IH]; intros E; [discriminate|]. rewrite stretch_S in E. unfold mark_of in E.
    pose proof (solid_letter (i + n)) as Sl. destruct (letter_at s J (i + n)) eqn:Le; cbn [near_label is_solid] in *.
    - destruct (IH E) as (t & H & St & Lt & N). exists t. repeat split; auto; try lia. intros m Hm.
      destruct (Nat.eq_dec m (i + n)) as [->|]; [congruence|apply N; lia].
    - injection E as <-. exists (i + n). repeat split; auto; try lia. intros m Hm. lia.
    - injection E as <-. exists (i + n). repeat split; auto; try lia. intros m Hm. lia.
    - discriminate.
  Qed.

  Lemma stretch_fits round i n : tells_labels round k s J lab -> i + n <= k -> fitting (stretch i n).
  Proof.
    intros T. induction n as [|n IH]; intros H; [exact I|]. rewrite stretch_S. cbn [fitting mark_of]. split; [apply IH; lia|].
    intros Sl y E. destruct (near_stretch i n y E) as (t & Ht & St & <- & N). rewrite solid_letter in Sl.
    pose proof (by_predecessor _ _ _ _ _ T t (i + n) ltac:(lia) St Sl N) as B. rewrite <- joined_letter in B by exact Sl.
    split.
    - intros Q. rewrite Q in B. symmetry. now apply B.
    - intros Q. symmetry in Q. apply B in Q. now destruct (letter_at s J (i + n)).
  Qed.
End Stretch.

Lemma near_app_edge P x S : near_label (P ++ (Edge, x) :: S) = near_label P.
Proof. induction P as [|[[| | |] y] P IH]; simpl; auto. Qed.
Lemma fits_edge P x S : fitting P -> fitting S -> fitting (P ++ (Edge, x) :: S).
Proof.
  induction P as [|[l y] P IH]; simpl; intros FP FS.
  - split; [exact FS|discriminate].
  - destruct FP as [FP F]. split; [now apply IH|]. rewrite near_app_edge. exact F.
Qed.
Lemma near_app_plain P x S : near_label (P ++ (Plain, x) :: S) = near_label (P ++ S).
Proof. induction P as [|[[| | |] y] P IH]; simpl; auto. Qed.
Lemma fits_plain P x S : fitting (P ++ S) -> fitting (P ++ (Plain, x) :: S).
Proof.
  induction P as [|[l y] P IH]; simpl; intros F.
  - split; [exact F|discriminate].
  - destruct F as [FP F]. split; [now apply IH|]. rewrite near_app_plain. exact F.
Qed.

(** ** Solid ports in the order of reading *)
Definition order (w : list labelled) : list labelled := rev (solid_ones w).
Definition jn (x : labelled) : bool := is_joined (fst x).
(** Round the fan two ports have the same label when they follow each other and the later one's bit is set. *)
Definition in_a_round (S : list labelled) : Prop := forall pre x mid y post, S = pre ++ x :: mid ++ y :: post ->
  (snd x =? snd y) = (null mid && jn y) || (null pre && null post && jn x).

Lemma filter_rev' {A} (f : A -> bool) l : filter f (rev l) = rev (filter f l).
Proof. induction l as [|a l IH]; [reflexivity|]. simpl. rewrite filter_app, IH. simpl. destruct (f a); [reflexivity|now rewrite app_nil_r]. Qed.
Lemma order_app w w' : order (w ++ w') = order w' ++ order w.
Proof. unfold order, solid_ones. now rewrite filter_app, rev_app_distr. Qed.
Lemma order_stretch s J lab i n : order (stretch s J lab i n) = map (mark_of s J lab) (filter (fun t => nth t s false) (seq i n)).
Proof.
  unfold order, solid_ones, stretch. rewrite filter_rev', rev_involutive. generalize (seq i n). intros l. induction l as [|t l IH]; [reflexivity|].
  simpl. rewrite (solid_letter s J t). destruct (nth t s false); simpl; now rewrite IH.
Qed.

Lemma info_order w : let S := map fst (order w) in
  count (info_of (map fst w)) = Nat.min 3 (length S) /\
  bit1 (info_of (map fst w)) = match S with x :: _ => is_joined x | [] => false end /\
  bit2 (info_of (map fst w)) = match S with [_; y] => is_joined y | _ => false end.
Proof.
  cbn zeta. induction w as [|[l x] w IH]; [repeat split|]. cbn [map info_of fold_right fst]. fold (info_of (map fst w)).
  destruct (is_solid l) eqn:Sl.
  - assert (E : order ((l, x) :: w) = order w ++ [(l, x)]) by (unfold order, solid_ones; simpl; now rewrite Sl). rewrite E, map_app. clear E.
    destruct IH as (C & B1 & B2). destruct (map fst (order w)) as [|a [|b [|c S]]]; cbn [length Nat.min app map fst] in *;
      destruct l; try discriminate Sl; cbn [count_letter]; rewrite C; cbn [count bit1 bit2]; rewrite ?B1; repeat split; try reflexivity;
      rewrite ?app_length; cbn [length]; rewrite ?Nat.add_1_r; reflexivity || (destruct S; reflexivity).
  - assert (E : order ((l, x) :: w) = order w) by (unfold order, solid_ones; simpl; now rewrite Sl). rewrite E. clear E.
    destruct l; try discriminate Sl; cbn [count_letter count bit1 bit2]; exact IH.
Qed.
Lemma first_order w : first_label w = option_map snd (hd_error (order w)).
Proof. reflexivity. Qed.
Lemma last_order w : last_label w = option_map snd (hd_error (rev (order w))).
Proof. unfold last_label, order. now rewrite rev_involutive. Qed.

(** ** The labels at the ends of two arcs *)
Definition ends_of (S1 S2 : list labelled) : ends :=
  let z := S (list_max (map snd (S1 ++ S2))) in
  Ends (hd z (map snd S1)) (last (map snd S1) z) (hd (S z) (map snd S2)) (last (map snd S2) (S z)).
Lemma last_snoc (m : list nat) b z : last (m ++ [b]) z = b.
Proof. induction m as [|x [|y m] IH]; auto. Qed.
Lemma below_max (S : list labelled) x : In x S -> snd x <= list_max (map snd S).
Proof. intros I. assert (F : Forall (fun n => n <= list_max (map snd S)) (map snd S)) by now apply list_max_le. rewrite Forall_forall in F. apply F, in_map, I. Qed.

(** Of a list of solid ports: how many, the first bit, the second of two, the first and the last label. *)
Definition seen_as (S : list labelled) (n : nat) (b1 b2 : bool) (F L : nat -> nat) : Prop :=
  Nat.min 3 (length (map fst S)) = n /\ match map fst S with x :: _ => is_joined x | [] => false end = b1 /\
  match map fst S with [_; y] => is_joined y | _ => false end = b2 /\ (forall z, hd z (map snd S) = F z) /\ (forall z, last (map snd S) z = L z).
Lemma viewed S : (S = [] /\ seen_as S 0 false false (fun z => z) (fun z => z)) \/
  (exists x, S = [x] /\ seen_as S 1 (jn x) false (fun _ => snd x) (fun _ => snd x)) \/
  (exists x m y, S = x :: m ++ [y] /\ seen_as S (if null m then 2 else 3) (jn x) (null m && jn y) (fun _ => snd x) (fun _ => snd y)).
Proof.
  destruct S as [|x S]; [left; repeat split|]. right. destruct S as [|c S]; [left; exists x; repeat split|]. right.
  destruct (@exists_last _ (c :: S) ltac:(discriminate)) as (m & y & E). rewrite E. clear E. exists x, m, y. split; [reflexivity|].
  unfold seen_as. cbn [map hd]. rewrite !map_app. cbn [map]. repeat split.
  - cbn [length]. rewrite app_length. cbn [length]. destruct m; cbn [null length map]; lia.
  - destruct m as [|d [|e m]]; reflexivity.
  - intros z. change (last ((snd x :: map snd m) ++ [snd y]) z = snd y). apply last_snoc.
Qed.

Lemma told_right w1 w2 : in_a_round (order w1 ++ order w2) ->
  same_equalities (equalities_of (ends_of (order w1) (order w2))) (told (info_of (map fst w1)) (info_of (map fst w2))) = true.
Proof.
  intros C. pose proof (info_order w1) as I1. pose proof (info_order w2) as I2. cbn zeta in *.
  set (a := info_of (map fst w1)) in *. set (b := info_of (map fst w2)) in *. clearbody a b.
  assert (Bd : forall x, In x (order w1 ++ order w2) -> let z := S (list_max (map snd (order w1 ++ order w2))) in
    (z =? snd x) = false /\ (snd x =? z) = false /\ (S z =? snd x) = false /\ (snd x =? S z) = false).
  { intros x I z. apply below_max in I. repeat split; apply Nat.eqb_neq; lia. }
  unfold ends_of. cbn zeta in Bd. set (z := S (list_max (map snd (order w1 ++ order w2)))) in *. clearbody z.
  assert (Nz : (z =? S z) = false) by (apply Nat.eqb_neq; lia).
  unfold same_equalities, equalities_of, told. cbn [first1 last1 first2 last2 f1l1 f2l2 f1f2 f1l2 l1f2 l1l2].
  destruct I1 as (-> & -> & ->), I2 as (-> & -> & ->). clear a b.
  destruct (viewed (order w1)) as [[E1 V1]|[(x & E1 & V1)|(x & m & y & E1 & V1)]], (viewed (order w2)) as [[E2 V2]|[(x' & E2 & V2)|(x' & m' & y' & E2 & V2)]];
    destruct V1 as (-> & -> & -> & F1 & L1), V2 as (-> & -> & -> & F2 & L2); rewrite F1, F2, L1, L2; rewrite E1, E2 in C, Bd; clear E1 E2 F1 F2 L1 L2.
  - now rewrite !Nat.eqb_refl, !Nz.
  - destruct (Bd x' ltac:(now left)) as (-> & _). now rewrite !Nat.eqb_refl.
  - rewrite (C [] x' m' y' [] ltac:(reflexivity)). destruct (Bd x' ltac:(now left)) as (-> & _).
    destruct (Bd y' ltac:(right; apply in_or_app; right; now left)) as (-> & _). rewrite !Nat.eqb_refl. destruct m', (jn x'), (jn y'); reflexivity.
  - destruct (Bd x ltac:(now left)) as (_ & _ & _ & ->). rewrite !Nat.eqb_refl. reflexivity.
  - rewrite (C [] x [] x' [] ltac:(reflexivity)), !Nat.eqb_refl. destruct (jn x), (jn x'); reflexivity.
  - rewrite (C [] x [] x' (m' ++ [y']) ltac:(reflexivity)), (C [] x (x' :: m') y' [] ltac:(reflexivity)), (C [x] x' m' y' [] ltac:(reflexivity)), !Nat.eqb_refl.
    destruct m', (jn x), (jn x'), (jn y'); reflexivity.
  - rewrite (C [] x m y [] ltac:(now rewrite app_nil_r)). destruct (Bd x ltac:(now left)) as (_ & _ & _ & ->).
    destruct (Bd y ltac:(right; apply in_or_app; left; apply in_or_app; right; now left)) as (_ & _ & _ & ->). rewrite !Nat.eqb_refl.
    destruct m, (jn x), (jn y); reflexivity.
  - rewrite (C [] x m y [x'] ltac:(cbn; now rewrite <- app_assoc)), (C [] x (m ++ [y]) x' [] ltac:(reflexivity)),
      (C (x :: m) y [] x' [] ltac:(cbn; now rewrite <- app_assoc)), !Nat.eqb_refl.
    destruct m, (jn x), (jn x'), (jn y); reflexivity.
  - rewrite (C [] x m y (x' :: m' ++ [y']) ltac:(cbn; now rewrite <- app_assoc)), (C [] x (m ++ [y]) x' (m' ++ [y']) ltac:(reflexivity)),
      (C [] x (m ++ [y] ++ x' :: m') y' [] ltac:(cbn; now rewrite <- !app_assoc)),
      (C (x :: m) y [] x' (m' ++ [y']) ltac:(cbn; now rewrite <- app_assoc)), (C (x :: m) y (x' :: m') y' [] ltac:(cbn; now rewrite <- app_assoc)),
      (C (x :: m ++ [y]) x' m' y' [] ltac:(reflexivity)).
    destruct m, m', (jn x), (jn x'), (jn y), (jn y'); reflexivity.
Qed.

(** ** Labels round a fan *)
Section Round.
  Variables (round : bool) (k : nat) (s J : coloring) (lab : nat -> nat).
  Hypotheses (T : tells_labels round k s J lab)
    (near : forall t u, t < u < k -> nth t s false = true -> nth u s false = true -> lab t = lab u ->
      none_between s t u \/ (round = true /\ none_outside k s t u)).

  Lemma key_formula t u : t < u < k -> nth t s false = true -> nth u s false = true ->
    (lab t = lab u <-> (none_between s t u /\ nth u J false = true) \/ (none_outside k s t u /\ nth t J false = true)).
  Proof.
    intros H St Su. split.
    - intros E. destruct (near t u H St Su E) as [N|[R N]].
      + left. split; [exact N|]. now apply (by_predecessor _ _ _ _ _ T t u).
      + right. split; [exact N|]. now apply (by_last _ _ _ _ _ T R t u).
    - intros [[N E]|[N E]].
      + now apply (by_predecessor _ _ _ _ _ T t u).
      + destruct round eqn:R.
        * now apply (by_last _ _ _ _ _ T eq_refl t u).
        * rewrite (first_free _ _ _ _ _ T t ltac:(lia) (or_introl eq_refl)) in E; [discriminate|]. intros m Hm. apply N; lia.
  Qed.

  Variable r : nat.
  Hypothesis turn : r <= k.
  Definition turned_order : list nat := seq r (k - r) ++ seq 0 r.
  Definition pos (x : nat) : nat := if r <=? x then x - r else x + k - r.
  Definition earlier (a b : nat) : Prop := pos a < pos b.

  Lemma seq_sorted a n : (r <= a \/ a + n <= r) -> StronglySorted earlier (seq a n).
  Proof.
    revert a. induction n as [|n IH]; intros a H; [constructor|]. cbn [seq]. constructor; [apply IH; lia|].
    apply Forall_forall. intros x I. apply in_seq in I. unfold earlier, pos. destruct (Nat.leb_spec r a), (Nat.leb_spec r x); lia.
  Qed.
  Lemma sorted_app {A} (R : A -> A -> Prop) l m : StronglySorted R l -> StronglySorted R m -> (forall a b, In a l -> In b m -> R a b) ->
    StronglySorted R (l ++ m).
  Proof.
    intros Sl Sm H. induction Sl as [|a l Sl IH F]; [exact Sm|]. simpl. constructor.
    - apply IH. intros x y I I2. apply H; [now right|exact I2].
    - apply Forall_app. split; [exact F|]. apply Forall_forall. intros b I. apply H; [now left|exact I].
  Qed.
  Lemma sorted_filter {A} (R : A -> A -> Prop) f l : StronglySorted R l -> StronglySorted R (filter f l).
  Proof.
    intros Sl. induction Sl as [|a l Sl IH F]; [constructor|]. simpl. destruct (f a); [|exact IH]. constructor; [exact IH|].
    rewrite Forall_forall in *. intros x I. apply filter_In in I as [I _]. now apply F.
  Qed.
  Lemma sorted_at {A} (R : A -> A -> Prop) l x m : StronglySorted R (l ++ x :: m) -> (forall a, In a l -> R a x) /\ (forall b, In b m -> R x b) /\ StronglySorted R m.
  Proof.
    induction l as [|a l IH]; simpl; intros S; inversion_clear S as [|? ? S' F].
    - rewrite Forall_forall in F. repeat split; auto. intros a [].
    - destruct (IH S') as (H1 & H2 & H3). rewrite Forall_forall in F. repeat split; auto. intros b [<-|I]; [|now apply H1].
      apply F, in_or_app. right. now left.
  Qed.

  Theorem round_right : in_a_round (map (mark_of s J lab) (filter (fun t => nth t s false) turned_order)).
  Proof.
    intros pre x mid y post E.
    apply map_eq_app in E as (P & L1 & EL & <- & E). apply map_eq_cons in E as (t & L2 & -> & <- & E).
    apply map_eq_app in E as (M & L3 & -> & <- & E). apply map_eq_cons in E as (u & Q & -> & <- & <-).
    assert (Sd : StronglySorted earlier (P ++ t :: M ++ u :: Q)).
    { rewrite <- EL. apply sorted_filter. unfold turned_order. apply sorted_app; [apply seq_sorted; lia|apply seq_sorted; lia|].
      intros a b I K. apply in_seq in I, K. unfold earlier, pos. destruct (Nat.leb_spec r a), (Nat.leb_spec r b); lia. }
    assert (Mem : forall m, m < k /\ nth m s false = true <-> In m P \/ m = t \/ In m M \/ m = u \/ In m Q).
    { intros m. transitivity (In m (P ++ t :: M ++ u :: Q)).
      - rewrite <- EL, filter_In. unfold turned_order. rewrite in_app_iff, !in_seq. split; intros [H1 H2]; (split; [lia|exact H2]).
      - rewrite in_app_iff. simpl. rewrite in_app_iff. simpl. intuition congruence. }
    destruct (sorted_at _ _ _ _ Sd) as (Bp & Bt & Sd'). destruct (sorted_at _ _ _ _ Sd') as (Bm & Bq & _). clear Sd Sd'.
    assert (Btu : earlier t u) by (apply Bt, in_or_app; right; now left).
    assert (Btm : forall m, In m M -> earlier t m) by (intros m I; apply Bt, in_or_app; now left).
    assert (Ht : t < k /\ nth t s false = true) by (apply Mem; auto). assert (Hu : u < k /\ nth u s false = true) by (apply Mem; auto).
    destruct Ht as [Ht St], Hu as [Hu Su]. unfold jn, mark_of. cbn [fst snd]. rewrite !joined_letter by assumption.
    assert (NM : null (map (mark_of s J lab) M) = true <-> forall m, m < k -> nth m s false = true -> ~ (earlier t m /\ earlier m u)).
    { destruct M as [|m0 M]; cbn [map null].
      - split; [|reflexivity]. intros _ m Hm Sm [E1 E2]. assert (W : In m P \/ m = t \/ In m [] \/ m = u \/ In m Q) by now apply Mem.
        unfold earlier in *. destruct W as [W|[->|[[]|[->|W]]]]; try lia; [specialize (Bp m W)|specialize (Bq m W)]; lia.
      - split; [discriminate|]. intros N. exfalso. assert (W : m0 < k /\ nth m0 s false = true) by (apply Mem; simpl; auto).
        apply (N m0); try apply W. split; [apply Btm; now left|apply Bm; now left]. }
    assert (NO : null (map (mark_of s J lab) P) && null (map (mark_of s J lab) Q) = true <->
      forall m, m < k -> nth m s false = true -> ~ (earlier m t \/ earlier u m)).
    { split.
      - rewrite andb_true_iff. destruct P as [|p P]; [|intros [? _]; discriminate]. destruct Q as [|q Q]; [|intros [_ ?]; discriminate].
        intros _ m Hm Sm E1. assert (W : In m [] \/ m = t \/ In m M \/ m = u \/ In m []) by now apply Mem.
        unfold earlier in *. destruct W as [[]|[->|[W|[->|[]]]]]; try lia. specialize (Btm m W). specialize (Bm m W). lia.
      - intros N. destruct P as [|p P].
        + destruct Q as [|q Q]; [reflexivity|exfalso]. assert (W : q < k /\ nth q s false = true) by (apply Mem; simpl; auto 10).
          apply (N q); try apply W. right. apply Bq. now left.
        + exfalso. assert (W : p < k /\ nth p s false = true) by (apply Mem; simpl; auto). apply (N p); try apply W. left. apply Bp. now left. }
    clear Mem Bp Bt Bm Bq Btm EL. apply eq_true_iff_eq. rewrite Nat.eqb_eq, orb_true_iff, !andb_true_iff. rewrite NM. rewrite <- andb_true_iff. rewrite NO. clear NM NO.
    unfold earlier, pos in *. destruct (Nat.lt_trichotomy t u) as [C|[C|C]]; [|subst; lia|].
    - rewrite (key_formula t u ltac:(lia) St Su).
      assert (A : none_between s t u <-> forall m, m < k -> nth m s false = true ->
        ~ ((if r <=? t then t - r else t + k - r) < (if r <=? m then m - r else m + k - r) /\
           (if r <=? m then m - r else m + k - r) < (if r <=? u then u - r else u + k - r))).
      { unfold none_between. split.
        - intros N m Hm Sm E1. rewrite N in Sm; [discriminate|]. destruct (Nat.leb_spec r t), (Nat.leb_spec r m), (Nat.leb_spec r u); lia.
        - intros N m Hm. destruct (nth m s false) eqn:Sm; [exfalso|reflexivity]. apply (N m); [lia|exact Sm|].
          destruct (Nat.leb_spec r t), (Nat.leb_spec r m), (Nat.leb_spec r u); lia. }
      assert (B : none_outside k s t u <-> forall m, m < k -> nth m s false = true ->
        ~ ((if r <=? m then m - r else m + k - r) < (if r <=? t then t - r else t + k - r) \/
           (if r <=? u then u - r else u + k - r) < (if r <=? m then m - r else m + k - r))).
      { unfold none_outside. split.
        - intros N m Hm Sm E1. rewrite N in Sm; [discriminate|exact Hm|]. destruct (Nat.leb_spec r t), (Nat.leb_spec r m), (Nat.leb_spec r u); lia.
        - intros N m Hm O. destruct (nth m s false) eqn:Sm; [exfalso|reflexivity]. apply (N m); [lia|exact Sm|].
          destruct (Nat.leb_spec r t), (Nat.leb_spec r m), (Nat.leb_spec r u); lia. }
      rewrite <- A, <- B. reflexivity.
    - assert (Sy : lab t = lab u <-> lab u = lab t) by (split; congruence). rewrite Sy, (key_formula u t ltac:(lia) Su St).
      assert (A : none_outside k s u t <-> forall m, m < k -> nth m s false = true ->
        ~ ((if r <=? t then t - r else t + k - r) < (if r <=? m then m - r else m + k - r) /\
           (if r <=? m then m - r else m + k - r) < (if r <=? u then u - r else u + k - r))).
      { unfold none_outside. split.
        - intros N m Hm Sm E1. rewrite N in Sm; [discriminate|exact Hm|]. destruct (Nat.leb_spec r t), (Nat.leb_spec r m), (Nat.leb_spec r u); lia.
        - intros N m Hm O. destruct (nth m s false) eqn:Sm; [exfalso|reflexivity]. apply (N m); [lia|exact Sm|].
          destruct (Nat.leb_spec r t), (Nat.leb_spec r m), (Nat.leb_spec r u); lia. }
      assert (B : none_between s u t <-> forall m, m < k -> nth m s false = true ->
        ~ ((if r <=? m then m - r else m + k - r) < (if r <=? t then t - r else t + k - r) \/
           (if r <=? u then u - r else u + k - r) < (if r <=? m then m - r else m + k - r))).
      { unfold none_between. split.
        - intros N m Hm Sm E1. rewrite N in Sm; [discriminate|]. destruct (Nat.leb_spec r t), (Nat.leb_spec r m), (Nat.leb_spec r u); lia.
        - intros N m Hm. destruct (nth m s false) eqn:Sm; [exfalso|reflexivity]. apply (N m); [lia|exact Sm|].
          destruct (Nat.leb_spec r t), (Nat.leb_spec r m), (Nat.leb_spec r u); lia. }
      rewrite <- A, <- B. tauto.
  Qed.
End Round.
