(** * The best of all recolourings, kept step by step

    [play] draws one colouring. Here all of them are drawn at once: for each frontier that can be reached, the score of a
    best colouring that reaches it, and something to remember that colouring by. Two colourings with the same frontier have
    the same future, so the worse one can be dropped. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Checker Frontier.

Definition same_label (a b : option nat) : bool :=
  match a, b with Some x, Some y => x =? y | None, None => true | _, _ => false end.
Definition same_place (x y : place) : bool := (deg x =? deg y) && same_label (port x) (port y).
Definition same_frontier (f g : frontier) : bool :=
  same_place (anchor f) (anchor g) && same_place (tip f) (tip g) && eqb (same f) (same g).

Lemma same_label_eq a b : same_label a b = true <-> a = b.
Proof.
  destruct a as [x|], b as [y|]; simpl; split; intros H; try discriminate; try reflexivity.
  - apply Nat.eqb_eq in H. now subst. - injection H as ->. apply Nat.eqb_refl.
Qed.
Lemma same_place_eq x y : same_place x y = true <-> x = y.
Proof.
  destruct x as [d l], y as [e m]. unfold same_place. cbn [deg port]. rewrite andb_true_iff, Nat.eqb_eq, same_label_eq.
  split; [intros [-> ->]; reflexivity|intros H; injection H; auto].
Qed.
Lemma same_frontier_eq f g : same_frontier f g = true <-> f = g.
Proof.
  destruct f as [a t s], g as [b u r]. unfold same_frontier. cbn [anchor tip same].
  rewrite !andb_true_iff, !same_place_eq, eqb_true_iff.
  split; [intros [[-> ->] ->]; reflexivity|intros H; injection H; auto].
Qed.

Section Fold.
  (** What is remembered of a colouring: [note b h] is [h] and one colour more. *)
  Context {H : Type}.
  Variables (note : bool -> H -> H).

  Definition entry := (frontier * score * H)%type.
  Fixpoint insert (f : frontier) (v : score) (h : H) (D : list entry) : list entry :=
    match D with
    | [] => [(f, v, h)]
    | (g, w, k) :: r =>
        if same_frontier f g then (if good w v then (g, w, k) else (g, v, h)) :: r else (g, w, k) :: insert f v h r
    end.
  Definition add_choice (s : step) (b : bool) (D : list entry) (e : entry) : list entry :=
    let '(f, (n, i), h) := e in
    match take s b f with
    | Some g => insert g ((if b then S n else n), i + left_alone s b f) (note b h) D
    | None => D
    end.
  Definition add_both (s : step) (D : list entry) (e : entry) : list entry := add_choice s true (add_choice s false D e) e.
  Definition extend (s : step) (D : list entry) : list entry := fold_left (add_both s) D [].
  Definition extends (ss : list step) (D : list entry) : list entry := fold_left (fun D s => extend s D) ss D.

  (** Every entry of [D] has the property [P]; [D] has an entry for [f] as good as [v]. *)
  Definition covers (D : list entry) (f : frontier) (v : score) : Prop := exists w h, In (f, w, h) D /\ is_good w v.

  Lemma insert_in f v h D e : In e (insert f v h D) -> e = (f, v, h) \/ In e D.
  Proof.
    induction D as [|[[g w] k] D IH]; simpl; [intuition|]. destruct (same_frontier f g) eqn:E.
    - apply same_frontier_eq in E as ->. destruct (good w v); simpl; intuition.
    - simpl. intuition.
  Qed.
  Lemma insert_covers f v h D : covers (insert f v h D) f v.
  Proof.
    induction D as [|[[g w] k] D IH]; simpl.
    - exists v, h. split; [now left|apply is_good_refl].
    - destruct (same_frontier f g) eqn:E.
      + apply same_frontier_eq in E as ->. destruct (good w v) eqn:G.
        * exists w, k. split; [now left|exact G]. * exists v, h. split; [now left|apply is_good_refl].
      + destruct IH as (x & y & I & G). exists x, y. split; [now right|exact G].
  Qed.
  Lemma good_total v w : good w v = false -> is_good v w.
  Proof. intros F. apply not_true_iff_false in F. unfold is_good. rewrite good_spec in *. lia. Qed.
  Lemma insert_keeps f v h D g w : covers D g w -> covers (insert f v h D) g w.
  Proof.
    intros (x & y & I & G). induction D as [|[[g' w'] k] D IH]; simpl; [destruct I|]. destruct (same_frontier f g') eqn:E.
    - apply same_frontier_eq in E as ->. destruct I as [I|I].
      + injection I as -> -> ->. destruct (good x v) eqn:F.
        * exists x, y. split; [now left|exact G].
        * exists v, h. split; [now left|]. exact (is_good_trans _ _ _ (good_total _ _ F) G).
      + exists x, y. split; [|exact G]. destruct (good w' v); now right.
    - destruct I as [I|I].
      + exists x, y. split; [now left|exact G].
      + destruct (IH I) as (x' & y' & J & G'). exists x', y'. split; [now right|exact G'].
  Qed.

  Lemma add_choice_keeps s b D e g w : covers D g w -> covers (add_choice s b D e) g w.
  Proof. intros C. destruct e as [[f [n i]] h]. unfold add_choice. destruct (take s b f) as [g0|]; [apply insert_keeps; exact C|exact C]. Qed.

  (** Where an entry after a step comes from. *)
  Definition stems (s : step) (D : list entry) (e : entry) : Prop :=
    exists f n i h b g, In (f, (n, i), h) D /\ take s b f = Some g /\
      e = (g, ((if b then S n else n), i + left_alone s b f), note b h).

  Lemma extend_stems s D e : In e (extend s D) -> stems s D e.
  Proof.
    unfold extend. assert (W : forall l acc, In e (fold_left (add_both s) l acc) -> In e acc \/ stems s l e).
    { induction l as [|x l IH]; intros acc I; [now left|]. simpl in I. apply IH in I as [I|I].
      - unfold add_both in I. destruct x as [[f [n i]] h].
        assert (C : forall b acc', In e (add_choice s b acc' (f, (n, i), h)) -> In e acc' \/ stems s ((f, (n, i), h) :: l) e).
        { intros b acc' J. unfold add_choice in J. destruct (take s b f) as [g|] eqn:T; [|now left].
          apply insert_in in J as [->|J]; [|now left]. right. exists f, n, i, h, b, g. repeat split; auto. now left. }
        apply C in I as [I|I]; [|now right]. apply C in I as [I|I]; [now left|now right].
      - right. destruct I as (f & n & i & h & b & g & J & T & ->). exists f, n, i, h, b, g. repeat split; auto. now right. }
    intros I. apply W in I as [[]|I]. exact I.
  Qed.

  Lemma extend_covers s D f n i h b g : In (f, (n, i), h) D -> take s b f = Some g ->
    covers (extend s D) g ((if b then S n else n), i + left_alone s b f).
  Proof.
    intros I T. unfold extend.
    assert (K : forall l acc, covers acc g ((if b then S n else n), i + left_alone s b f) ->
      covers (fold_left (add_both s) l acc) g ((if b then S n else n), i + left_alone s b f)).
    { induction l as [|x l IH]; intros acc C; [exact C|]. apply IH. unfold add_both. now apply add_choice_keeps, add_choice_keeps. }
    generalize (@nil entry). induction D as [|x D IH]; intros acc; [destruct I|]. simpl. destruct I as [->|I]; [|now apply IH].
    apply K. unfold add_both.
    assert (E : forall acc', covers (add_choice s b acc' (f, (n, i), h)) g ((if b then S n else n), i + left_alone s b f)).
    { intros acc'. unfold add_choice. rewrite T. apply insert_covers. }
    destruct b; [apply E|apply add_choice_keeps, E].
  Qed.
End Fold.

(** What is remembered is the colouring itself, last colour first. *)
Definition coloring_entry := @entry coloring.
Definition remember (b : bool) (h : coloring) : coloring := b :: h.
Definition blank_entries : list coloring_entry := [(blank_frontier, (0, 0), [])].

Lemma play_app ss : forall c ss' c' f n i, length c = length ss ->
  play (ss ++ ss') (c ++ c') f n i =
  match play ss c f n i with Some (g, (n', i')) => play ss' c' g n' i' | None => None end.
Proof.
  induction ss as [|s ss IH]; intros [|b c] ss' c' f n i L; try discriminate; [reflexivity|]. injection L as L. simpl.
  destruct (take s b f); [now apply IH|reflexivity].
Qed.
Lemma play_length ss : forall c f n i r, play ss c f n i = Some r -> length c = length ss.
Proof.
  induction ss as [|s ss IH]; intros [|b c] f n i r P; try discriminate; [reflexivity|]. simpl in *.
  destruct (take s b f); [|discriminate]. f_equal. eapply IH, P.
Qed.
Lemma good_shift v w n i : is_good v w -> is_good (n + fst v, snd v + i) (n + fst w, snd w + i).
Proof. unfold is_good. rewrite !good_spec. simpl. lia. Qed.

(** The entries after any steps: each is the result of a colouring, and every colouring is covered. *)
Theorem extends_right ss :
  (forall f v h, In (f, v, h) (extends remember ss blank_entries) -> play ss (rev h) blank_frontier 0 0 = Some (f, v)) /\
  (forall c f v, play ss c blank_frontier 0 0 = Some (f, v) -> covers (extends remember ss blank_entries) f v).
Proof.
  induction ss as [|s ss [IHs IHc]] using rev_ind.
  - split.
    + intros f v h [E|[]]. injection E as <- <- <-. reflexivity.
    + intros [|b c] f v E; [|discriminate]. injection E as <- <-. exists (0, 0), []. split; [now left|apply is_good_refl].
  - unfold extends in *. rewrite fold_left_app. cbn [fold_left]. split.
    + intros f v h I. apply extend_stems in I as (f' & n & i & h' & b & g & J & T & E). injection E as -> -> ->.
      apply IHs in J. unfold remember. cbn [rev]. pose proof (play_length _ _ _ _ _ _ J) as L. rewrite play_app by exact L.
      rewrite J. cbn [play]. now rewrite T.
    + intros c f v P. pose proof (play_length _ _ _ _ _ _ P) as L. rewrite app_length, Nat.add_comm in L. simpl in L.
      destruct c as [|b c] using rev_ind; [discriminate|]. clear IHc0. rewrite app_length, Nat.add_comm in L. simpl in L.
      rewrite play_app in P by lia. destruct (play ss c blank_frontier 0 0) as [[g [n i]]|] eqn:Q; [|discriminate].
      cbn [play] in P. destruct (take s b g) as [g'|] eqn:T; [|discriminate]. injection P as <- <-.
      destruct (IHc c g (n, i) Q) as ([n' i'] & h & I & G).
      destruct (extend_covers remember s _ g n' i' h b g' I T) as (w & h' & J & G').
      exists w, h'. split; [exact J|]. eapply is_good_trans; [exact G'|].
      apply (good_shift _ _ (if b then 1 else 0) (left_alone s b g)) in G. cbn [fst snd] in G. destruct b; exact G.
Qed.

(** The best entry, the last two vertices counted. *)
Definition finished {H} (e : @entry H) : score := let '(f, (n, i), h) := e in (n, i + at_end f).
Definition best_entry {H} (D : list (@entry H)) : option (@entry H) :=
  fold_right (fun e o => match o with Some d => if good (finished d) (finished e) then Some d else Some e | None => Some e end) None D.
Lemma best_entry_ok {H} (D : list (@entry H)) :
  match best_entry D with
  | Some e => In e D /\ forall d, In d D -> is_good (finished e) (finished d)
  | None => D = []
  end.
Proof.
  induction D as [|e D IH]; [reflexivity|]. simpl. destruct (best_entry D) as [d|].
  - destruct IH as [I B]. destruct (good (finished d) (finished e)) eqn:G.
    + split; [now right|]. intros x [<-|X]; [exact G|now apply B].
    + apply good_total in G. split; [now left|]. intros x [<-|X]; [apply is_good_refl|]. eapply is_good_trans; [exact G|now apply B].
  - subst. split; [now left|]. intros x [<-|[]]. apply is_good_refl.
Qed.
Definition best_coloring (ss : list step) : option coloring :=
  option_map (fun e => rev (snd e)) (best_entry (extends remember ss blank_entries)).
