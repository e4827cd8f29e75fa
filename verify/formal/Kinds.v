(** * Finitely many kinds of arcs

    Of an arc, whatever its length, this is kept: its class in the header; the best scores of its colourings, for each of their
    books; and, for each case, the books and the score of the colouring that the header gives. Scores are lowered as far as they
    go. What is left are finitely many kinds. *)
Require Import Arith Bool List NArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Arcs Rings Header.

Record info := Info { count : nat; bit1 : bool; bit2 : bool; rim : bool }.
(** Of the solid ports: how many (three or more are three), whether the first two are joined to the ones before; and whether the
    boundary is there. *)
Definition is_joined (l : letter) : bool := match l with Joined => true | _ => false end.
Definition count_letter (l : letter) (a : info) : info :=
  match l with
  | Plain => a
  | Edge => Info (count a) (bit1 a) (bit2 a) true
  | _ => match count a with
         | 0 => Info 1 (is_joined l) false (rim a)
         | 1 => Info 2 (bit1 a) (is_joined l) (rim a)
         | _ => Info 3 (bit1 a) false (rim a)
         end
  end.
Definition info_of (w : list letter) : info := fold_right count_letter (Info 0 false false false) w.

Definition place_entry := @entry unit.
Record kind := Kind { cl : N; about : info; entries : list place_entry; traced : list (option (frontier * score)) }.
Definition cases : list N := map N.of_nat (seq 0 16).

Definition grow (first : bool) (it : item) (b : bool) (D : list place_entry) (e : place_entry) : list place_entry :=
  let '(f, (n, i), h) := e in
  match enter first it b f with Some g => insert (plain g) (add b n, i + left_by first b f) tt D | None => D end.
Definition grow_all (first : bool) (it : item) (D : list place_entry) : list place_entry :=
  fold_left (fun acc e => grow first it true (grow first it false acc e) e) D [].

(** The books of a case; a colouring that the header would give for another case is not looked at. *)
Definition left_reach (f : frontier) (r : bool) : N :=
  if deg (anchor f) =? 0 then 0%N
  else if same f then (if r then 3 else 1)%N else match port (anchor f) with Some _ => 2 | None => 1 end%N.
Definition right_reach (f : frontier) (r : bool) : N :=
  if r then if same f then 3%N else match port (tip f) with Some _ => 2 | None => 1 end%N else 0%N.
Definition fits (f : frontier) (e : N) : bool := (4 * left_reach f (solid_link e) + right_reach f (solid_link e) =? e)%N.

Definition least (l : list nat) : nat := match l with [] => 0 | x :: r => fold_left Nat.min r x end.
Definition minus_score (m v : score) : score := (fst v - fst m, snd v - snd m).
Definition scores_of (K : kind) : list score :=
  map (fun e => snd (fst e)) (entries K) ++ flat_map (fun t => match t with Some (_, v) => [v] | None => [] end) (traced K).
Definition lowest (K : kind) : score := (least (map fst (scores_of K)), least (map snd (scores_of K))).
Definition lower (K : kind) : kind :=
  let m := lowest K in
  Kind (cl K) (about K) (map (fun e => (fst (fst e), minus_score m (snd (fst e)), tt)) (entries K))
    (map (option_map (fun t => (fst t, minus_score m (snd t)))) (traced K)).
Definition empty_kind : kind := Kind 0 (Info 0 false false false) [(outer, (0, 0), tt)] (map (fun _ => Some (outer, (0, 0))) cases).

(** Equal kinds, and a number to find them by. *)
Definition same_info (a b : info) : bool :=
  (count a =? count b) && eqb (bit1 a) (bit1 b) && eqb (bit2 a) (bit2 b) && eqb (rim a) (rim b).
Definition same_score (v w : score) : bool := (fst v =? fst w) && (snd v =? snd w).
Fixpoint same_list {A} (f : A -> A -> bool) (l m : list A) : bool :=
  match l, m with [], [] => true | a :: l', b :: m' => f a b && same_list f l' m' | _, _ => false end.
Definition same_entry (x y : place_entry) : bool := same_frontier (fst (fst x)) (fst (fst y)) && same_score (snd (fst x)) (snd (fst y)).
Definition same_trace (x y : option (frontier * score)) : bool :=
  match x, y with Some (f, v), Some (g, w) => same_frontier f g && same_score v w | None, None => true | _, _ => false end.
Definition same_kind (x y : kind) : bool :=
  (cl x =? cl y)%N && same_info (about x) (about y) && same_list same_entry (entries x) (entries y) && same_list same_trace (traced x) (traced y).

Lemma same_info_eq a b : same_info a b = true -> a = b.
Proof.
  destruct a, b. unfold same_info. cbn. rewrite !andb_true_iff, Nat.eqb_eq, !eqb_true_iff. intros [[[-> ->] ->] ->]. reflexivity.
Qed.
Lemma same_score_eq v w : same_score v w = true -> v = w.
Proof. destruct v, w. unfold same_score. cbn. rewrite andb_true_iff, !Nat.eqb_eq. now intros [-> ->]. Qed.
Lemma same_list_eq {A} (f : A -> A -> bool) : (forall a b, f a b = true -> a = b) -> forall l m, same_list f l m = true -> l = m.
Proof.
  intros E. induction l as [|a l IH]; intros [|b m] H; try discriminate; [reflexivity|]. simpl in H. apply andb_prop in H as [H1 H2].
  f_equal; auto.
Qed.
Lemma same_kind_eq x y : same_kind x y = true -> x = y.
Proof.
  destruct x, y. unfold same_kind. cbn. rewrite !andb_true_iff, N.eqb_eq. intros [[[-> H1] H2] H3]. f_equal.
  - now apply same_info_eq.
  - revert H2. apply same_list_eq. intros [[f v] []] [[g w] []] H. unfold same_entry in H. cbn in H. apply andb_prop in H as [H H'].
    apply same_frontier_eq in H. apply same_score_eq in H'. congruence.
  - revert H3. apply same_list_eq. intros [[f v]|] [[g w]|] H; try discriminate; [|reflexivity]. cbn in H. apply andb_prop in H as [H H'].
    apply same_frontier_eq in H. apply same_score_eq in H'. congruence.
Qed.

Definition code_place (x : place) : N := (N.of_nat (deg x) + match port x with Some _ => 4 | None => 0 end)%N.
Definition code_books (f : frontier) : N := (code_place (anchor f) + 8 * code_place (tip f) + if same f then 64 else 0)%N.
Definition code_more (acc : N) (f : frontier) (v : score) : N :=
  (N.shiftl acc 14 + code_books f + 128 * (N.of_nat (fst v) + 8 * N.of_nat (snd v)))%N.
Definition code_bit (b : bool) : N := if b then 1%N else 0%N.
Definition code (K : kind) : positive :=
  N.succ_pos (fold_left (fun acc t => match t with Some (f, v) => code_more acc f v | None => N.shiftl acc 14 end) (traced K)
    (fold_left (fun acc e => code_more acc (fst (fst e)) (snd (fst e))) (entries K)
      (cl K + 256 * (N.of_nat (count (about K)) +
        4 * (code_bit (bit1 (about K)) + 2 * code_bit (bit2 (about K)) + 4 * code_bit (rim (about K)))))))%N.

Section Kinds.
  Variable H : header.

  Definition trace_on (first : bool) (x : N) (l : letter) (ts : list (option (frontier * score))) (e : N) : option (frontier * score) :=
    let e' := came H x l e in
    match nth (N.to_nat e') ts None with
    | Some (f, (n, i)) =>
        match enter first (item_of l) (solid_link e') f with
        | Some g => if fits (plain g) e then Some (plain g, (add (solid_link e') n, i + left_by first (solid_link e') f)) else None
        | None => None
        end
    | None => None
    end.
  Definition follow (first : bool) (K : kind) (l : letter) : kind :=
    Kind (go H (cl K) l) (count_letter l (about K)) (grow_all first (item_of l) (entries K)) (map (trace_on first (cl K) l (traced K)) cases).

  (** ** Exploring *)
  Definition kinds := PositiveMap.t kind.
  Definition known (R : kinds) (K : kind) : bool :=
    match PositiveMap.find (code K) R with Some K' => same_kind K' K | None => false end.
  Definition letters_after (K : kind) : list letter := if rim (about K) then [Plain; Alone; Joined] else [Plain; Alone; Joined; Edge].
  Definition first_kinds : list kind := map (fun l => lower (follow true empty_kind l)) (letters_after empty_kind).
  Definition next_kinds (K : kind) : list kind := map (fun l => lower (follow false K l)) (letters_after K).
  Fixpoint explore (fuel : nat) (todo later : list kind) (R : kinds) : kinds :=
    match fuel with
    | 0 => R
    | S n =>
        match todo with
        | [] => match later with [] => R | _ => explore n (rev' later) [] R end
        | K :: todo' =>
            match PositiveMap.find (code K) R with
            | Some _ => explore n todo' later R
            | None => explore n todo' (rev_append (next_kinds K) later) (PositiveMap.add (code K) K R)
            end
        end
    end.
  (** What is found is only proposed; this checks it. *)
  Definition closed (R : kinds) : bool :=
    forallb (known R) first_kinds && forallb (fun kb => forallb (known R) (next_kinds (snd kb))) (PositiveMap.elements R).
  Definition found : kinds := explore (N.to_nat 20000) first_kinds [] (PositiveMap.empty kind).
  Definition listed (R : kinds) : list kind := map snd (PositiveMap.elements R).

  (** ** What a kind says of an arc *)
  Definition stands (w : list letter) (K : kind) (m : score) : Prop :=
    cl K = arc_class H w /\ about K = info_of w /\
    (forall c f v, arun w c = Some (f, v) -> exists u, In (f, u, tt) (entries K) /\ is_good (plus_score u m) v) /\
    (forall e f v, nth (N.to_nat e) (traced K) None = Some (f, v) -> arun w (trace H w e) = Some (f, plus_score v m)).

  Lemma plus_good v w m : is_good v w -> is_good (plus_score v m) (plus_score w m).
  Proof. unfold is_good, plus_score. rewrite !good_spec. cbn. lia. Qed.

  Lemma empty_stands : stands [] empty_kind (0, 0).
  Proof.
    split; [reflexivity|]. split; [reflexivity|]. split.
    - intros [|b c] f v E; [|discriminate]. injection E as <- <-. exists (0, 0). split; [now left|apply is_good_refl].
    - intros e f v E. cbn [trace]. destruct (nth_in_or_default (N.to_nat e) (traced empty_kind) None) as [I|I]; [|congruence].
      rewrite E in I. cbn [traced empty_kind] in I. apply in_map_iff in I as (x & Q & _). injection Q as <- <-. reflexivity.
  Qed.

  Lemma grow_keeps first it b D e g w : covers D g w -> covers (grow first it b D e) g w.
  Proof. intros C. destruct e as [[f [n i]] u]. unfold grow. destruct (enter first it b f); [now apply insert_keeps|exact C]. Qed.
  Lemma grow_all_covers first it D f n i b g : In (f, (n, i), tt) D -> enter first it b f = Some g ->
    covers (grow_all first it D) (plain g) (add b n, i + left_by first b f).
  Proof.
    intros I E. unfold grow_all.
    assert (K : forall l acc, covers acc (plain g) (add b n, i + left_by first b f) ->
      covers (fold_left (fun acc e => grow first it true (grow first it false acc e) e) l acc) (plain g) (add b n, i + left_by first b f)).
    { induction l as [|x l IH]; intros acc C; [exact C|]. apply IH. now apply grow_keeps, grow_keeps. }
    generalize (@nil place_entry). induction D as [|x D IH]; intros acc; [destruct I|]. simpl. destruct I as [->|I]; [|now apply IH].
    apply K. assert (Q : forall acc', covers (grow first it b acc' (f, (n, i), tt)) (plain g) (add b n, i + left_by first b f)).
    { intros acc'. unfold grow. rewrite E. apply insert_covers. }
    destruct b; [apply Q|apply grow_keeps, Q].
  Qed.

  Lemma came_bound x l e : (came H x l e < 16)%N.
  Proof. unfold came. change 15%N with (N.ones 4). rewrite N.land_ones. apply N.mod_lt. discriminate. Qed.

  Lemma follow_stands w K m l : stands w K m -> stands (l :: w) (follow (null w) K l) m.
  Proof.
    intros (Ec & Ea & Co & Tr). assert (N2 : null (map item_of w) = null w) by now destruct w.
    split; [cbn; now rewrite Ec|]. split; [cbn; now rewrite Ea|]. split.
    - intros [|b c] f v E; [discriminate|]. unfold arun in *. cbn [map grun andb] in E. rewrite N2 in E.
      destruct (grun true outer plain (map item_of w) c) as [[g [n i]]|] eqn:G; [|discriminate].
      destruct (enter (null w) (item_of l) b g) as [h|] eqn:En; [|discriminate]. injection E as <- <-.
      destruct (Co c g (n, i) G) as ([n' i'] & I & Go). destruct (grow_all_covers _ _ _ _ _ _ _ _ I En) as (u & [] & J & Gu).
      exists u. split; [exact J|]. eapply is_good_trans; [apply plus_good, Gu|]. unfold is_good, plus_score in *. rewrite good_spec in *. cbn [fst snd] in *.
      destruct b; cbn [add]; lia.
    - intros e f v E. cbn [follow traced] in E.
      destruct (nth_in_or_default (N.to_nat e) (map (trace_on (null w) (cl K) l (traced K)) cases) None) as [I|I]; [|congruence].
      assert (Ee : nth (N.to_nat e) (map (trace_on (null w) (cl K) l (traced K)) cases) None = trace_on (null w) (cl K) l (traced K) e).
      { assert (B : N.to_nat e < 16). { destruct (Nat.lt_ge_cases (N.to_nat e) 16) as [B|B]; [exact B|]. rewrite nth_overflow in E; [discriminate|exact B]. }
        unfold cases. rewrite map_map. set (g := fun x => trace_on (null w) (cl K) l (traced K) (N.of_nat x)).
        rewrite (nth_indep _ None (g 0)) by (rewrite map_length, seq_length; exact B).
        rewrite (map_nth g), seq_nth by exact B. unfold g. cbn [Nat.add]. now rewrite N2Nat.id. }
      rewrite Ee in E. clear I Ee. unfold trace_on in E. rewrite Ec in E. set (e' := came H (arc_class H w) l e) in *.
      destruct (nth (N.to_nat e') (traced K) None) as [[g [n i]]|] eqn:Q; [|discriminate].
      destruct (enter (null w) (item_of l) (solid_link e') g) as [h|] eqn:En; [|discriminate].
      destruct (fits (plain h) e); [|discriminate]. injection E as <- <-. apply Tr in Q. unfold arun in *. cbn [trace map grun andb]. fold e'. rewrite N2.
      rewrite Q. rewrite En. unfold plus_score. cbn [fst snd]. f_equal. f_equal. f_equal; [destruct (solid_link e'); reflexivity|lia].
  Qed.

  Lemma least_le l x : In x l -> least l <= x.
  Proof.
    assert (W : forall r a, fold_left Nat.min r a <= a /\ forall y, In y r -> fold_left Nat.min r a <= y).
    { induction r as [|b r IH]; intros a; [split; [reflexivity|intros y []]|]. simpl. destruct (IH (Nat.min a b)) as [H1 H2]. split; [lia|].
      intros y [->|I]; [lia|now apply H2]. }
    destruct l as [|a l]; [intros []|]. simpl. destruct (W l a) as [H1 H2]. intros [->|I]; auto.
  Qed.
  Lemma lowered_back K v : In v (scores_of K) -> plus_score (minus_score (lowest K) v) (lowest K) = v.
  Proof.
    intros I. destruct v as [n i]. unfold plus_score, minus_score, lowest. cbn [fst snd].
    assert (A : In n (map fst (scores_of K))) by (apply in_map_iff; now exists (n, i)).
    assert (B : In i (map snd (scores_of K))) by (apply in_map_iff; now exists (n, i)).
    apply least_le in A, B. f_equal; lia.
  Qed.
  Lemma plus_assoc u v w : plus_score (plus_score u v) w = plus_score u (plus_score v w).
  Proof. unfold plus_score. cbn. f_equal; lia. Qed.
  Lemma lower_stands w K m : stands w K m -> stands w (lower K) (plus_score (lowest K) m).
  Proof.
    intros (Ec & Ea & Co & Tr). split; [exact Ec|]. split; [exact Ea|]. split.
    - intros c f v E. destruct (Co c f v E) as (u & I & G). exists (minus_score (lowest K) u). split.
      + cbn [lower entries]. apply in_map_iff. now exists (f, u, tt).
      + rewrite <- plus_assoc, lowered_back; [exact G|]. apply in_or_app. left. apply in_map_iff. now exists (f, u, tt).
    - intros e f v E. cbn [lower traced] in E.
      destruct (nth (N.to_nat e) (traced K) None) as [[g u]|] eqn:Q.
      + rewrite (nth_indep _ None (option_map (fun t => (fst t, minus_score (lowest K) (snd t))) None)) in E.
        * rewrite map_nth, Q in E. injection E as <- <-. rewrite <- plus_assoc, lowered_back; [now apply Tr|].
          apply in_or_app. right. apply in_flat_map. exists (Some (g, u)). split; [|now left]. rewrite <- Q. apply nth_In.
          destruct (Nat.lt_ge_cases (N.to_nat e) (length (traced K))) as [B|B]; [exact B|]. rewrite nth_overflow in Q by exact B. discriminate.
        * rewrite map_length. destruct (Nat.lt_ge_cases (N.to_nat e) (length (traced K))) as [B|B]; [exact B|]. rewrite nth_overflow in Q by exact B. discriminate.
      + exfalso. destruct (Nat.lt_ge_cases (N.to_nat e) (length (traced K))) as [B|B].
        * rewrite (nth_indep _ None (option_map (fun t => (fst t, minus_score (lowest K) (snd t))) None)) in E by now rewrite map_length.
          rewrite map_nth, Q in E. discriminate.
        * rewrite nth_overflow in E by now rewrite map_length. discriminate.
  Qed.

  (** At most one boundary in an arc. *)
  Fixpoint edges (w : list letter) : nat := match w with [] => 0 | Edge :: u => S (edges u) | _ :: u => edges u end.
  Lemma rim_edges w : rim (info_of w) = negb (edges w =? 0).
  Proof.
    induction w as [|l w IH]; [reflexivity|]. cbn [info_of fold_right]. fold (info_of w).
    destruct l; cbn [count_letter edges]; try (destruct (count (info_of w)) as [|[|]]); cbn [rim]; auto.
  Qed.

  Theorem every_kind R : closed R = true -> forall w, w <> [] -> edges w <= 1 ->
    exists K m, In K (listed R) /\ stands w K m.
  Proof.
    unfold closed. rewrite andb_true_iff, !forallb_forall. intros [K1 K2].
    assert (F : forall K, known R K = true -> In K (listed R)).
    { intros K E. unfold known in E. destruct (PositiveMap.find (code K) R) as [K'|] eqn:Q; [|discriminate]. apply same_kind_eq in E as ->.
      unfold listed. apply in_map_iff. exists (code K, K). split; [reflexivity|]. now apply PositiveMap.elements_correct. }
    induction w as [|l w IH]; intros N E; [contradiction|]. destruct w as [|l' w].
    - exists (lower (follow true empty_kind l)), (plus_score (lowest (follow true empty_kind l)) (0, 0)). split.
      + apply F, K1. unfold first_kinds. apply in_map_iff. exists l. split; [reflexivity|]. destruct l; simpl; auto.
      + apply lower_stands. exact (follow_stands [] empty_kind (0, 0) l empty_stands).
    - destruct IH as (K & m & I & S); [discriminate|destruct l; cbn [edges] in E |- *; lia|].
      exists (lower (follow false K l)), (plus_score (lowest (follow false K l)) m). split.
      + apply F. unfold listed in I. apply in_map_iff in I as (kb & Q & I). specialize (K2 kb I). rewrite Q in K2.
        rewrite forallb_forall in K2. apply K2. unfold next_kinds. apply in_map_iff. exists l. split; [reflexivity|].
        unfold letters_after. destruct S as (_ & -> & _). rewrite rim_edges.
        destruct l; destruct (Nat.eqb_spec (edges (l' :: w)) 0); cbn [negb]; simpl; auto. cbn [edges] in E. destruct l'; cbn [edges] in *; lia.
      + apply lower_stands. exact (follow_stands (l' :: w) K m l S).
  Qed.
End Kinds.
