(** * Exploring the classes, and what holds at the end of each *)
Require Import Arith Bool List Permutation ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Route Serves Entries Classes.

(** ** Equal classes, and a number for each to find it by *)
Fixpoint same_scores (D E : scores) : bool :=
  match D, E with
  | [], [] => true
  | (f, (n, i), _) :: D', (g, (m, j), _) :: E' => same_frontier f g && (n =? m) && (i =? j) && same_scores D' E'
  | _, _ => false
  end.
Definition same_class (x y : cls) : bool := (stage x =? stage y) && same_frontier (bef x) (bef y) && same_scores (aft x) (aft y).
Lemma same_scores_eq D : forall E, same_scores D E = true -> D = E.
Proof.
  induction D as [|[[f [n i]] []] D IH]; intros [|[[g [m j]] []] E] H; try discriminate; [reflexivity|]. cbn [same_scores] in H.
  rewrite !andb_true_iff, !Nat.eqb_eq, same_frontier_eq in H. destruct H as [[[-> ->] ->] H]. f_equal. now apply IH.
Qed.
Lemma same_class_eq x y : same_class x y = true -> x = y.
Proof.
  destruct x as [q f D], y as [r g E]. unfold same_class. cbn [stage bef aft]. rewrite !andb_true_iff, Nat.eqb_eq, same_frontier_eq.
  intros [[-> ->] H]. f_equal. now apply same_scores_eq.
Qed.

Definition code (x : cls) : positive :=
  N.succ_pos (fold_left (fun acc e => let '(f, (n, i), _) := e in
      (N.shiftl acc 17 + (code_frontier f + 2048 * (N.of_nat n + 8 * N.of_nat i)))%N)
    (aft x) (N.of_nat (stage x) + 16 * code_frontier (bef x))%N).

(** ** The table of classes, each with its bounds *)
Definition classes := PositiveMap.t bounded.
Definition no_worse (b c : Z * Z) : bool := ((fst b <=? fst c) && (snd c <=? snd b))%Z.
Definition known (R : classes) (b : bounded) : bool :=
  match PositiveMap.find (code (fst b)) R with Some c => same_class (fst c) (fst b) && no_worse (snd c) (snd b) | None => false end.
Definition followers (arrows : list arrow) (b : bounded) : list bounded :=
  flat_map (fun a => if from a =? stage (fst b) then follow a b else []) arrows.

(** What is found is only proposed; [closed] checks it. *)
Definition widened (b c : Z * Z) : Z * Z := (Z.min (fst b) (fst c), Z.max (snd b) (snd c)).
Fixpoint explore (arrows : list arrow) (fuel : nat) (todo later : list bounded) (R : classes) : classes :=
  match fuel with
  | 0 => R
  | S n =>
      match todo with
      | [] => match later with [] => R | _ => explore arrows n (rev' later) [] R end
      | b :: todo' =>
          if known R b then explore arrows n todo' later R
          else
            let b' := match PositiveMap.find (code (fst b)) R with Some c => (fst b, widened (snd b) (snd c)) | None => b end in
            explore arrows n todo' (rev_append (followers arrows b') later) (PositiveMap.add (code (fst b)) b' R)
      end
  end.

Definition start_class : bounded := let '(x, _) := class_of 0 blank_frontier [(blank_frontier, (0, 0), tt)] in (x, (0, 0)%Z).
Definition closed (arrows : list arrow) (R : classes) : bool :=
  known R start_class && forallb (fun kb => forallb (known R) (followers arrows (snd kb))) (PositiveMap.elements R).

(** ** The end

    [ends q]: at stage q a fan may be complete; after the last steps it has at least N solid edges more, and at most M
    many isolated triangles more. *)
Definition limits (ends : nat -> option (Z * Z)) (last_before last_after : list template) (b : bounded) : bool :=
  match ends (stage (fst b)) with
  | None => true
  | Some (bS, bI) =>
      match best_entry (extends note (map (step_from None) last_after) (aft (fst b))) with
      | None => false
      | Some e =>
          forallb (fun r : frontier * score => let '(g, (n, i)) := r in
              (bS <=? fst (snd b) + Z.of_nat (fst (finished e)) - Z.of_nat n)%Z &&
              (snd (snd b) + Z.of_nat (snd (finished e)) - Z.of_nat (i + at_end g) <=? bI)%Z)
            (ways (map (step_from None) last_before) (bef (fst b)) 0 0)
      end
  end.
Definition all_within (arrows : list arrow) (ends : nat -> option (Z * Z)) (last_before last_after : list template) (R : classes) : bool :=
  closed arrows R && forallb (fun kb => limits ends last_before last_after (snd kb)) (PositiveMap.elements R).

Lemma known_found R x b : known R (x, b) = true -> exists c, In (code x, (x, c)) (PositiveMap.elements R) /\ no_worse c b = true.
Proof.
  unfold known. cbn [fst snd]. destruct (PositiveMap.find (code x) R) as [[y c]|] eqn:F; [|discriminate]. cbn [fst snd]. intros H.
  apply andb_prop in H as [H1 H2]. apply same_class_eq in H1 as ->. exists c. split; [now apply PositiveMap.elements_correct|exact H2].
Qed.
Lemma meets_weaker A f n i x b c : no_worse c b = true -> meets A f n i x (fst b) (snd b) -> meets A f n i x (fst c) (snd c).
Proof.
  unfold no_worse. rewrite andb_true_iff, !Z.leb_le. intros [L M] (h & tS & tI & T & E & St & HS & HI). exists h, tS, tI. repeat split; auto; lia || apply St.
Qed.

Section Explored.
  Variables (arrows : list arrow) (ends : nat -> option (Z * Z)) (last_before last_after : list template) (R : classes).
  Hypothesis checked : all_within arrows ends last_before last_after R = true.

  Lemma start_meets : let '(x, (oS, oI)) := start_class in meets [] blank_frontier 0 0 x oS oI /\ stage x = 0.
  Proof.
    unfold start_class. set (D := [(blank_frontier, (0, 0), tt)]).
    assert (St : stands_for [] D (fun l => l) 0 0).
    { split.
      - intros g w u [E|[]]. injection E as <- <- <-. exists []. reflexivity.
      - intros [|b c] f v E; [|discriminate]. injection E as <- <-. exists blank_frontier, (0, 0), tt. split; [now left|]. apply as_good_refl. }
    pose proof (class_meets [] blank_frontier 0 0 0 blank_frontier D (fun l => l) 0 0 0 0) as M.
    destruct (class_of 0 blank_frontier D) as [x [mS mI]] eqn:E.
    assert (Z0 : mS = 0 /\ mI = 0) by (injection E as _ <- <-; split; reflexivity). destruct Z0 as [-> ->].
    cbn [Z.of_nat] in M. rewrite !Z.add_0_r in M. apply M; [|reflexivity|exact St|lia|lia]. intros y z [].
  Qed.

  Lemma path_meets q B A : path arrows q B A -> forall c f n i, play B c blank_frontier 0 0 = Some (f, (n, i)) ->
    exists x b, In (code x, (x, b)) (PositiveMap.elements R) /\ stage x = q /\ meets A f n i x (fst b) (snd b).
  Proof.
    unfold all_within, closed in checked. rewrite !andb_true_iff, !forallb_forall in checked. destruct checked as [[Ks Kc] _].
    intros P. induction P as [|a p B A Ia P IH Np]; intros c f n i Q.
    - destruct c; [|discriminate]. injection Q as <- <- <-. pose proof start_meets as M. destruct start_class as [x [oS oI]].
      destruct M as [M E]. apply known_found in Ks as (b & I & W). exists x, b. split; [exact I|]. split; [exact E|].
      now apply meets_weaker with (oS, oI).
    - assert (L : length c = length B + length (map (step_from p) (drawn_before a))) by now rewrite (play_length _ _ _ _ _ _ Q), app_length.
      rewrite <- (firstn_skipn (length B) c) in Q. rewrite play_app in Q by (rewrite firstn_length; lia).
      destruct (play B (firstn (length B) c) blank_frontier 0 0) as [[g [m j]]|] eqn:Qb; [|discriminate].
      destruct (IH _ _ _ _ Qb) as (x & b & I & E & M).
      destruct (follow_meets _ _ _ _ _ _ _ a p _ _ _ _ M Np Q) as (y & pS & pI & J & Ey & My).
      assert (K : known R (y, (pS, pI)) = true).
      { specialize (Kc _ I). rewrite forallb_forall in Kc. apply Kc. cbn [snd]. unfold followers. apply in_flat_map. exists a.
        split; [exact Ia|]. cbn [fst]. rewrite E, Nat.eqb_refl. destruct b as [bS bI]. exact J. }
      apply known_found in K as (c' & I' & W). exists y, c'. split; [exact I'|]. split; [exact Ey|]. now apply meets_weaker with (pS, pI).
  Qed.

  (** The best colouring after, against any colouring before. *)
  Theorem path_within q B A bS bI : path arrows q B A -> ends q = Some (bS, bI) ->
    forall c f n i, play (B ++ map (step_from None) last_before) c blank_frontier 0 0 = Some (f, (n, i)) ->
    exists c' g m j, play (A ++ map (step_from None) last_after) c' blank_frontier 0 0 = Some (g, (m, j)) /\
      (Z.of_nat n + bS <= Z.of_nat m)%Z /\ (Z.of_nat (j + at_end g) <= Z.of_nat (i + at_end f) + bI)%Z /\
      forall d f' v, play (A ++ map (step_from None) last_after) d blank_frontier 0 0 = Some (f', v) ->
        is_good (m, j + at_end g) (fst v, snd v + at_end f').
  Proof.
    intros P En c f n i Q.
    assert (L : length c = length B + length (map (step_from None) last_before)) by now rewrite (play_length _ _ _ _ _ _ Q), app_length.
    rewrite <- (firstn_skipn (length B) c) in Q. rewrite play_app in Q by (rewrite firstn_length; lia).
    destruct (play B (firstn (length B) c) blank_frontier 0 0) as [[g0 [n0 i0]]|] eqn:Qb; [|discriminate].
    destruct (path_meets q B A P _ _ _ _ Qb) as (x & b & I & E & (h & tS & tI & T & Eg & St & HS & HI)).
    unfold all_within in checked. rewrite andb_true_iff, !forallb_forall in checked. destruct checked as [_ Kl]. apply Kl in I.
    cbn [snd] in I. unfold limits in I. cbn [fst snd] in I. rewrite E, En in I.
    assert (N : forall ts, flat_map step_labels (map (step_from None) ts) = []).
    { intros ts. destruct (flat_map step_labels (map (step_from None) ts)) as [|l r] eqn:F; [reflexivity|]. exfalso.
      assert (J : In l (flat_map step_labels (map (step_from None) ts))) by (rewrite F; now left). apply template_labels in J. destruct J. }
    assert (Em : forall ts, map (relabel_step h) (map (step_from None) ts) = map (step_from None) ts).
    { intros ts. rewrite map_map. apply map_ext. intros t. symmetry. exact (step_from_relabel h None t). }
    destruct (stands_extends (map (step_from None) last_after) A (aft x) h tS tI) as [[So Co] _]; [|exact St|].
    { rewrite N, app_nil_r. intros y z Y Z. apply T; apply in_or_app; now right. }
    rewrite Em in So, Co. set (D := extends note (map (step_from None) last_after) (aft x)) in *.
    pose proof (best_entry_ok D) as Be. destruct (best_entry D) as [[[g [m j]] u]|]; [|discriminate]. destruct Be as [Ie Be].
    destruct (So g (m, j) u Ie) as (c' & Pc). exists c', (relabel h g), (m + tS), (j + tI). split; [exact Pc|].
    rewrite Eg in Q. rewrite <- (Em last_before) in Q. rewrite play_relabel in Q.
    2: { rewrite N, app_nil_r. intros y z Y Z. apply T; apply in_or_app; now left. }
    destruct (play (map (step_from None) last_before) (skipn (length B) c) (bef x) n0 i0) as [[g1 v1]|] eqn:Q1; [|discriminate].
    injection Q as <- ->. rewrite <- (Nat.add_0_r n0), <- (Nat.add_0_r i0) in Q1. apply play_ways in Q1 as ([dn di] & Iw & Ev).
    injection Ev as -> ->. rewrite forallb_forall in I. apply I in Iw. rewrite andb_true_iff, !Z.leb_le in Iw. cbn [finished fst snd] in *.
    rewrite !at_end_relabel in *. split; [lia|]. split; [lia|]. intros d f' v Pd. destruct (Co d f' v Pd) as (g2 & w2 & u2 & I2 & V2 & G2).
    apply Be in I2. unfold is_good in *. rewrite good_spec in *. destruct w2 as [n2 i2]. cbn [finished raised fst snd] in *.
    pose proof (at_end_serves (relabel h g2) f'). rewrite at_end_relabel in *. lia.
  Qed.
End Explored.
