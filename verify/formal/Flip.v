(** * Edge flips

    Thirty-two configurations, and thirty-two answers to each: everything is tried. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Locality Table Drawing Checker Rows Tables_flip.

Definition full : trie := Tables_flip.table [].

Fixpoint keptb (s s' : coloring) : bool :=
  match s, s' with
  | [], [] => true
  | b :: r, b' :: r' => (b || negb b') && keptb r r'
  | _, _ => false
  end.
Lemma keptb_ok s : forall s', keptb s s' = true <-> kept s s'.
Proof.
  unfold kept. induction s as [|b s IH]; intros [|b' s']; simpl.
  - split; auto.
  - split; [discriminate|intros [E _]; discriminate].
  - split; [discriminate|intros [E _]; discriminate].
  - rewrite andb_true_iff, IH. split.
    + intros [B [L H]]. split; [now f_equal|]. intros [|i]; [|apply H]. intros ->. now destruct b.
    + intros [L H]. injection L as L. split; [|split; [exact L|intros i; apply (H (S i))]].
      specialize (H 0). simpl in H. destruct b, b'; auto.
Qed.

(** The labels before are given; legal or not? *)
Definition flip_legalb (l : list nat) (s s' x : coloring) : bool :=
  keptb s s' && (length x =? 1) &&
  match drawn (after flip) s' x with Some st => refines (labels 4 st) l | None => false end.

Lemma flip_legalb_ok st s c s' x : describes (size (before flip)) st (drawing (before flip) s c) ->
  (flip_legalb (labels 4 st) s s' x = true <-> flip_legal s c s' x).
Proof.
  intros D. unfold flip_legalb, flip_legal, sound. rewrite !andb_true_iff, keptb_ok, Nat.eqb_eq.
  pose proof (drawn_ok flip (after flip) s' x eq_refl) as E. destruct (drawn (after flip) s' x) as [st'|].
  - destruct E as [E V]. rewrite (labels_below flip (before flip) st _ (after flip) st' _ eq_refl eq_refl D E). simpl. tauto.
  - split; [intros [_ F]; discriminate|]. intros (_ & _ & V & _). contradiction.
Qed.

Definition flip_good (s s' x t' y : coloring) : bool :=
  let edges_x := solids s' + solids x in let edges_y := solids t' + solids y in
  let lone_x := lone_or_given_up s s' x in let lone_y := lone_or_given_up s t' y in
  (edges_y <? edges_x) || ((edges_y =? edges_x) && ((lone_x <? lone_y) || ((lone_x =? lone_y) && (solids t' <=? solids s')))).

Lemma flip_good_ok s s' x t' y : flip_good s s' x t' y = true -> flip_as_good s s' x t' y.
Proof.
  unfold flip_good, flip_as_good. rewrite !orb_true_iff, !andb_true_iff, !orb_true_iff, !andb_true_iff.
  rewrite !Nat.ltb_lt, !Nat.eqb_eq, Nat.leb_le. tauto.
Qed.

Definition judge_flip (s c : coloring) : bool :=
  match drawn (before flip) s c, lookup full s c with
  | None, None => true
  | Some st, Some (b :: s') =>
      let x := [b] in let l := labels 4 st in
      flip_legalb l s s' x &&
      (solids s + solids c <=? solids s' + solids x + 1) &&
      (lone_or_given_up s s' x <=? isolated (before flip) s c + 2) &&
      forallb (fun t' => forallb (fun y => negb (flip_legalb l s t' y) || flip_good s s' x t' y) (all_colorings 1))
        (all_colorings 4)
  | _, _ => false
  end.

Theorem all_checked : forallb (fun s => forallb (judge_flip s) (all_colorings 1)) (all_colorings 4) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma judged s c : length s = 4 -> length c = 1 ->
  (valid (drawing (before flip) s c) -> exists b s', lookup full s c = Some (b :: s') /\ flip_best s c s' [b] /\
     solids s + solids c <= solids s' + solids [b] + 1 /\
     lone_or_given_up s s' [b] <= isolated (before flip) s c + 2) /\
  (~ valid (drawing (before flip) s c) -> lookup full s c = None).
Proof.
  intros Ls Lc. pose proof all_checked as A. rewrite forallb_forall in A.
  specialize (A s (proj2 (all_colorings_ok 4 s) Ls)). rewrite forallb_forall in A.
  specialize (A c (proj2 (all_colorings_ok 1 c) Lc)). unfold judge_flip in A.
  pose proof (drawn_ok flip (before flip) s c eq_refl) as D. destruct (drawn (before flip) s c) as [st|].
  - destruct D as [D V]. split; [|contradiction]. intros _. destruct (lookup full s c) as [[|b s']|]; try discriminate.
    exists b, s'. split; [reflexivity|]. rewrite !andb_true_iff, !Nat.leb_le in A. destruct A as [[[L S] I] B].
    split; [|split; assumption].
    apply (flip_legalb_ok st s c s' [b] D) in L. split; [exact L|]. intros t' y M.
    assert (Lt : length t' = 4) by (destruct M as [[E _] _]; congruence).
    assert (Ly : length y = 1) by (destruct M as [_ [E _]]; exact E).
    rewrite forallb_forall in B. specialize (B t' (proj2 (all_colorings_ok 4 t') Lt)).
    rewrite forallb_forall in B. specialize (B y (proj2 (all_colorings_ok 1 y) Ly)).
    apply (flip_legalb_ok st s c t' y D) in M. rewrite M in B. now apply flip_good_ok.
  - split; [contradiction|]. intros _. destruct (lookup full s c) as [[|b s']|]; try discriminate. reflexivity.
Qed.

Theorem flip_rules : flip_correct (lookup full).
Proof.
  intros s c Ls Lc. destruct (judged s c Ls Lc) as [V N]. split; [|exact N].
  intros H. destruct (V H) as (b & s' & E & B & _). now exists [b], s'.
Qed.

Lemma answered_valid s c a : length s = 4 -> length c = 1 -> lookup full s c = Some a ->
  valid (drawing (before flip) s c).
Proof.
  intros Ls Lc E. destruct (valid_or_not flip (before flip) s c eq_refl) as [H|H]; [exact H|].
  rewrite (proj2 (judged s c Ls Lc) H) in E. discriminate.
Qed.

Theorem flip_facts : flip_within (lookup full) 1 2.
Proof.
  intros s c x s' Ls Lc Lx E. pose proof (answered_valid s c _ Ls Lc E) as H.
  destruct (proj1 (judged s c Ls Lc) H) as (b & t' & F & _ & S & I). rewrite E in F. injection F as F.
  destruct x as [|b' [|]]; try discriminate. injection F as -> ->. now split.
Qed.

Theorem flip_is_safe : flip_safe (lookup full).
Proof.
  intros s c x s' O Ls Lc Lx E R V. pose proof (answered_valid s c _ Ls Lc E) as H.
  destruct (proj1 (judged s c Ls Lc) H) as (b & t' & F & [[K S] _] & _). rewrite E in F. injection F as F.
  destruct x as [|b' [|]]; try discriminate. injection F as -> ->.
  apply (sound_is_safe flip (well_formed_sensible flip (before flip) eq_refl)
      (well_formed_sensible flip (after flip) eq_refl) s c); assumption.
Qed.
