(** * Checking a run

    What [restrip-check] decides of one operation of a run (docs/how-to/check-a-run.md). [judge] and, for flips, [judge_flip] are
    extracted; the reader around them is written by hand. They are given the raw triangles of the patch before and after,
    by their vertices, the mesh edges where the ports are, and what the mesh says of colours and neighbours. They make sure
    that the triangles lie as a patch of [Statements.v], and answer how good a recolouring of that patch can be, and whether the
    one at hand is a best one ([judge_right], [judge_flip_right]). *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Strips Locality Drawing Checker Labels Rows Symmetry Frontier Fold Route EveryFan.
Import Runs.

(** Of the patch at [o] with the ports [s] and the inner edges [c]; [x] is the recolouring at hand. The route counts two
    vertices more than there are triangles, which are isolated. *)
Definition weigh (o : position) (s c x : coloring) : option verdict :=
  let p := patch_at o in let r := course_at o in
  match drawn_with_labels (before p) s c with
  | None => None
  | Some st =>
      let ss := map (step_of (ports p) s (label_in st)) (way r) in
      match best_entry (extends remember ss blank_entries) with
      | None => None
      | Some e =>
          let found := match play ss (choices (met_first r) (met_last r) x) blank_frontier 0 0 with
                       | Some (f, (n, i)) => good (n, i + at_end f) (finished e) | None => false end in
          Some (Verdict (solids c) (alone (ports p) st) (fst (finished e)) (snd (finished e) - 2)
                        ((length x =? length (inner (after p))) && found))
      end
  end.

Theorem weigh_right o s c x v : possible o = true -> length s = ports (patch_at o) ->
  length c = length (inner (before (patch_at o))) -> weigh o s c x = Some v ->
  let p := patch_at o in
  valid (drawing (before p) s c) /\
  solid_before v = solids c /\ alone_before v = isolated (before p) s c /\
  (exists y, best p s c y /\ solids y = solid_best v /\ isolated (after p) s y = alone_best v) /\
  (chosen v = true <-> best p s c x).
Proof.
  intros Po Ls Lc E p. destruct (course_right o Po) as [W A]. fold p in W, A, Ls, Lc.
  set (r := course_at o) in *. unfold weigh in E. fold p in E. fold r in E.
  rewrite labels_drawn in E.
  pose proof (drawn_ok p (before p) s c W) as D. destruct (drawn (before p) s c) as [st|]; [|discriminate].
  destruct D as [D V]. set (ss := map (step_of (ports p) s (label_in st)) (way r)) in *.
  destruct (fold_best p (way r) (met_first r) (met_last r) (left_over r) A s c st Ls D) as (y & Ey & By).
  fold ss in Ey. unfold best_coloring in Ey.
  destruct (extends_right ss) as [Es Ec]. pose proof (best_entry_ok (extends remember ss blank_entries)) as B.
  destruct (best_entry (extends remember ss blank_entries)) as [[[f [n i]] h]|]; [|discriminate].
  injection E as <-. cbn [solid_before alone_before solid_best alone_best chosen].
  destruct B as [I B]. apply Es in I. cbn [option_map snd] in Ey. injection Ey as Ey.
  destruct (played p (way r) (met_first r) (met_last r) (left_over r) A _ _ _ _ I) as [Ly Cy]. rewrite Ey in Ly, Cy.
  pose proof (along_plays _ _ _ _ _ _ s (label_in st) y A Ls Ly) as Q. fold ss in Q. rewrite Cy, I in Q.
  destruct Q as (_ & En & Ei).
  split; [exact V|]. split; [reflexivity|]. split; [now apply alone_isolated with (s := s) (x := c)|]. split.
  - exists y. split; [exact By|]. cbn [finished fst snd]. lia.
  - rewrite andb_true_iff, Nat.eqb_eq. split.
    + intros [Lx F]. pose proof (along_plays _ _ _ _ _ _ s (label_in st) x A Ls Lx) as Q. fold ss in Q.
      destruct (play ss (choices (met_first r) (met_last r) x) blank_frontier 0 0) as [[g [n' i']]|]; [|discriminate].
      destruct Q as (Al & En' & Ei'). rewrite good_spec in F. cbn [finished fst snd] in F.
      split; [exact (proj1 (allowed_legal p st s c x D Lx) Al)|]. intros z Lz. destruct By as [_ By]. specialize (By z Lz).
      unfold as_good in *. lia.
    + intros [Lx Bx]. pose proof Lx as (Len & _ & _). split; [exact Len|].
      apply (allowed_legal p st s c x D Len) in Lx.
      pose proof (along_plays _ _ _ _ _ _ s (label_in st) x A Ls Len) as Q. fold ss in Q.
      destruct (play ss (choices (met_first r) (met_last r) x) blank_frontier 0 0) as [[g [n' i']]|]; [|contradiction].
      destruct Q as (_ & En' & Ei'). apply good_spec. cbn [finished fst snd]. destruct By as [Ly' _].
      specialize (Bx y Ly'). unfold as_good in Bx. lia.
Qed.

(** ** Flips

    There are at most 32 recolourings: any subset of the solid ports kept, the new edge solid or dashed. A verdict counts
    the ports among the edges, and each port given up among the isolated triangles, as [flip_as_good] does. *)
Definition way_on := (coloring * coloring)%type.
Fixpoint all_colorings (n : nat) : list coloring :=
  match n with 0 => [[]] | S m => map (cons false) (all_colorings m) ++ map (cons true) (all_colorings m) end.
Definition keeps (s s' : coloring) : bool :=
  (length s' =? length s) && forallb (fun i => implb (nth i s' false) (nth i s false)) (seq 0 (length s')).
Definition flip_allowed (st : state) (s : coloring) (w : way_on) : bool :=
  keeps s (fst w) && (length (snd w) =? 1) &&
  match drawn (after flip) (fst w) (snd w) with
  | Some st' => forallb (fun i => forallb (fun j =>
      implb (label_in st' i =? label_in st' j) (label_in st i =? label_in st j)) (seq 0 4)) (seq 0 4)
  | None => false
  end.
Definition flip_alone (s : coloring) (w : way_on) : nat := lone_or_given_up s (fst w) (snd w).
Definition flip_edges (w : way_on) : nat := solids (fst w) + solids (snd w).
Definition flip_good (s : coloring) (v w : way_on) : bool :=
  (flip_edges w <? flip_edges v) ||
  ((flip_edges w =? flip_edges v) &&
   ((flip_alone s v <? flip_alone s w) || ((flip_alone s v =? flip_alone s w) && (solids (fst w) <=? solids (fst v))))).
Definition ways_on (st : state) (s : coloring) : list way_on :=
  filter (flip_allowed st s) (flat_map (fun s' => [(s', [false]); (s', [true])]) (all_colorings 4)).
Definition first_of (s : coloring) (l : list way_on) : option way_on :=
  fold_right (fun w o => match o with Some v => if flip_good s v w then Some v else Some w | None => Some w end) None l.

(** Of a flip with the ports [s] and the inner edge [c] before, [w] being what was done. *)
Definition weigh_flip (s c : coloring) (w : way_on) : option verdict :=
  match drawn (before flip) s c with
  | None => None
  | Some st =>
      match first_of s (ways_on st s) with
      | None => None
      | Some v => Some (Verdict (solids s + solids c) (isolated (before flip) s c) (flip_edges v) (flip_alone s v)
                                (flip_allowed st s w && flip_good s w v))
      end
  end.

Lemma all_colorings_all n : forall c, length c = n -> In c (all_colorings n).
Proof.
  induction n as [|n IH]; intros [|b c] L; try discriminate; [now left|]. injection L as L. cbn [all_colorings].
  apply in_or_app. destruct b; [right|left]; apply in_map, IH, L.
Qed.
Lemma keeps_kept s s' : keeps s s' = true <-> kept s s'.
Proof.
  unfold keeps, kept. rewrite andb_true_iff, Nat.eqb_eq, forallb_forall. split; intros [L K]; split; auto.
  - intros i H. destruct (Nat.lt_ge_cases i (length s')) as [B|B]; [|rewrite nth_overflow in H by exact B; discriminate].
    specialize (K i (proj2 (in_seq _ _ _) (conj (Nat.le_0_l _) B))). now rewrite H in K.
  - intros i _. specialize (K i). destruct (nth i s' false); [now rewrite K|reflexivity].
Qed.
Lemma flip_good_spec s v w : flip_good s v w = true <-> flip_as_good s (fst v) (snd v) (fst w) (snd w).
Proof.
  unfold flip_good, flip_as_good, flip_edges, flip_alone.
  rewrite orb_true_iff, andb_true_iff, orb_true_iff, andb_true_iff, !Nat.ltb_lt, !Nat.eqb_eq, Nat.leb_le. intuition lia.
Qed.
Lemma flip_good_total s v w : flip_good s v w = false -> flip_good s w v = true.
Proof. intros F. apply not_true_iff_false in F. rewrite flip_good_spec in *. unfold flip_as_good in *. lia. Qed.
Lemma flip_good_trans s u v w : flip_good s u v = true -> flip_good s v w = true -> flip_good s u w = true.
Proof. rewrite !flip_good_spec. unfold flip_as_good. lia. Qed.
Lemma first_of_ok s l : match first_of s l with
  | Some v => In v l /\ forall w, In w l -> flip_good s v w = true | None => l = [] end.
Proof.
  induction l as [|w l IH]; [reflexivity|]. simpl. destruct (first_of s l) as [v|].
  - destruct IH as [I B]. destruct (flip_good s v w) eqn:G.
    + split; [now right|]. intros x [<-|X]; [exact G|now apply B].
    + apply flip_good_total in G. split; [now left|].
      assert (R : flip_good s w w = true) by (apply flip_good_spec; unfold flip_as_good; lia).
      intros x [<-|X]; [exact R|]. eapply flip_good_trans; [exact G|now apply B].
  - subst. split; [now left|]. intros x [<-|[]]. apply flip_good_spec. unfold flip_as_good. lia.
Qed.

Lemma flip_allowed_right st s c w : describes (size (before flip)) st (drawing (before flip) s c) -> length s = 4 ->
  (flip_allowed st s w = true <-> flip_legal s c (fst w) (snd w)).
Proof.
  intros (_ & _ & K) Ls. destruct w as [s' x]. cbn [fst snd]. unfold flip_allowed, flip_legal, sound. cbn [fst snd].
  rewrite !andb_true_iff, keeps_kept, Nat.eqb_eq.
  pose proof (drawn_ok flip (after flip) s' x eq_refl) as D. change (size (before flip)) with 6 in K.
  destruct (drawn (after flip) s' x) as [st'|].
  - destruct D as [(_ & _ & K') V]. change (size (after flip)) with 6 in K'. rewrite forallb_forall. split.
    + intros [[Ke Lx] F]. split; [exact Ke|]. split; [exact Lx|]. split; [exact V|]. intros i j Hi Hj L.
      change (ports flip) with 4 in Hi, Hj.
      specialize (F i (proj2 (in_seq 4 0 i) ltac:(lia))). rewrite forallb_forall in F.
      specialize (F j (proj2 (in_seq 4 0 j) ltac:(lia))).
      apply (K' i j) in L; [|lia|lia]. apply Nat.eqb_eq in L. rewrite L in F. cbn [implb] in F. apply Nat.eqb_eq in F.
      apply K; [lia|lia|exact F].
    + intros [Ke (Lx & _ & J)]. split; [split; [exact Ke|exact Lx]|]. intros i Hi. apply in_seq in Hi. rewrite forallb_forall.
      intros j Hj. apply in_seq in Hj. destruct (Nat.eqb_spec (label_in st' i) (label_in st' j)) as [E|E]; [|reflexivity].
      cbn [implb]. apply Nat.eqb_eq. apply (K i j); [lia|lia|]. change (ports flip) with 4 in J. apply J; [lia|lia|].
      apply (K' i j); [lia|lia|exact E].
  - split; [intros [_ F]; discriminate|]. intros [_ (_ & V & _)]. contradiction.
Qed.

Theorem weigh_flip_right s c w v : length s = 4 -> weigh_flip s c w = Some v ->
  valid (drawing (before flip) s c) /\
  solid_before v = solids s + solids c /\ alone_before v = isolated (before flip) s c /\
  (exists t y, flip_best s c t y /\ solids t + solids y = solid_best v /\ lone_or_given_up s t y = alone_best v) /\
  (chosen v = true <-> flip_best s c (fst w) (snd w)).
Proof.
  intros Ls E. unfold weigh_flip in E. pose proof (drawn_ok flip (before flip) s c eq_refl) as D.
  destruct (drawn (before flip) s c) as [st|]; [|discriminate]. destruct D as [D V].
  pose proof (fun u => flip_allowed_right st s c u D Ls) as A. pose proof (first_of_ok s (ways_on st s)) as F.
  assert (All : forall t y, flip_legal s c t y -> In (t, y) (ways_on st s)).
  { intros t y L. apply filter_In. split; [|now apply A]. destruct L as [[Lt _] (Ly & _)]. apply in_flat_map. exists t.
    split; [apply all_colorings_all; congruence|]. destruct y as [|[|] [|? ?]]; try discriminate; [right; now left|now left]. }
  destruct (first_of s (ways_on st s)) as [[t y]|]; [|discriminate]. injection E as <-.
  cbn [solid_before alone_before solid_best alone_best chosen]. destruct F as [I B].
  assert (Best : flip_best s c t y).
  { split; [apply (A (t, y)); apply filter_In in I; tauto|]. intros u z L. apply All, B in L. now apply flip_good_spec in L. }
  split; [exact V|]. split; [reflexivity|]. split; [reflexivity|]. split; [now exists t, y|].
  rewrite andb_true_iff, A. split.
  - intros [L G]. split; [exact L|]. intros u z Lu. apply All, B in Lu.
    apply (flip_good_spec s w (u, z)). eapply flip_good_trans; [exact G|exact Lu].
  - intros [L G]. split; [exact L|]. destruct Best as [Lt _]. apply flip_good_spec. now apply G.
Qed.

(** ** Raw triangles

    [V] are the vertices, of which nothing is known but [same]. A mesh edge is named in the direction in which the triangle
    to its left has it. *)
Section Raw.
  Context {V : Type} (same : V -> V -> bool).
  Local Notation crossed := (Runs.crossed same).
  Local Notation lies := (Runs.lies same).
  Local Notation either_way := (Runs.either_way same).

  (** [olds] and [news] are the patch at [o] before and after, [was] and [is] the colours of the mesh, [beside] and [beside']
      its neighbours, and [altered] are the mesh edges whose colour has changed. *)
  Definition judge (o : position) (olds news : list corners) (ps : list mesh_edge) (was is beside beside' : mesh_edge -> bool)
      (altered : list mesh_edge) : option verdict :=
    let p := patch_at o in
    match crossed olds (inner (before p)), crossed news (inner (after p)) with
    | Some es, Some fs =>
        if possible o && lies (before p) olds ps es beside && lies (after p) news ps fs beside' then
          match weigh o (map was ps) (map was es) (map is fs) with
          | Some v =>
              let kept := forallb (fun e => eqb (is e) (was e)) ps in
              let inside := forallb (fun e => either_way e es || either_way e fs) altered in
              Some (Verdict (solid_before v) (alone_before v) (solid_best v) (alone_best v) (chosen v && kept && inside))
          | None => None
          end
        else None
    | _, _ => None
    end.

  Lemma crossed_length ts l : forall es, crossed ts l = Some es -> length es = length l.
  Proof.
    induction l as [|[i j] l IH]; intros es E; [now injection E as <-|]. cbn [Runs.crossed] in E.
    destruct (nth_error ts i) as [t|]; [|discriminate]. destruct (nth_error ts j) as [u|]; [|discriminate].
    destruct (between same t u); [|discriminate]. destruct (crossed ts l) as [r|]; [|discriminate]. injection E as <-.
    simpl. f_equal. now apply IH.
  Qed.

  (** The same of a flip; its ports may change. *)
  Definition judge_flip (olds news : list corners) (ps : list mesh_edge) (was is beside beside' : mesh_edge -> bool)
      (altered : list mesh_edge) : option verdict :=
    match crossed olds (inner (before flip)), crossed news (inner (after flip)) with
    | Some es, Some fs =>
        if lies (before flip) olds ps es beside && lies (after flip) news ps fs beside' then
          match weigh_flip (map was ps) (map was es) (map is ps, map is fs) with
          | Some v =>
              let inside := forallb (fun e => either_way e ps || either_way e es || either_way e fs) altered in
              Some (Verdict (solid_before v) (alone_before v) (solid_best v) (alone_best v) (chosen v && inside))
          | None => None
          end
        else None
    | _, _ => None
    end.

End Raw.

Theorem judge_right : Judge_right (@judge).
Proof.
  intros V same o olds news ps was is beside beside' altered v E p. unfold judge in E. fold p in E.
  destruct (crossed same olds (inner (before p))) as [es|] eqn:Ce; [|discriminate].
  destruct (crossed same news (inner (after p))) as [fs|] eqn:Cf; [|discriminate].
  destruct (possible o && lies same (before p) olds ps es beside && lies same (after p) news ps fs beside') eqn:L; [|discriminate].
  destruct (weigh o (map was ps) (map was es) (map is fs)) as [w|] eqn:Wg; [|discriminate]. injection E as <-.
  apply andb_prop in L as [L Lf]. apply andb_prop in L as [Po Le]. exists es, fs. repeat (split; [reflexivity || assumption|]).
  cbn [solid_before alone_before solid_best alone_best chosen].
  assert (Lp : length ps = ports p).
  { unfold lies in Le. rewrite !andb_true_iff in Le. destruct Le as [[[[_ Le] _] _] _]. now apply Nat.eqb_eq in Le. }
  destruct (weigh_right o (map was ps) (map was es) (map is fs) w Po) as (V0 & B1 & B2 & B3 & B4);
    [now rewrite map_length|rewrite map_length; exact (crossed_length same olds _ _ Ce)|exact Wg|].
  fold p in V0, B1, B2, B3, B4. repeat (split; [assumption|]). rewrite !andb_true_iff, !forallb_forall. intros [[Ch K] In'].
  split; [now apply B4|]. split.
  - apply map_ext_in. intros e I. apply K in I. now apply eqb_prop in I.
  - intros e I. apply In' in I. now apply orb_prop in I.
Qed.
Theorem judge_flip_right : Judge_flip_right (@judge_flip).
Proof.
  intros V same olds news ps was is beside beside' altered v E. unfold judge_flip in E.
  destruct (crossed same olds (inner (before flip))) as [es|]; [|discriminate].
  destruct (crossed same news (inner (after flip))) as [fs|]; [|discriminate].
  destruct (lies same (before flip) olds ps es beside && lies same (after flip) news ps fs beside') eqn:L; [|discriminate].
  destruct (weigh_flip (map was ps) (map was es) (map is ps, map is fs)) as [w|] eqn:Wg; [|discriminate].
  injection E as <-. apply andb_prop in L as [Le Lf]. exists es, fs. repeat (split; [reflexivity || assumption|]).
  cbn [solid_before alone_before solid_best alone_best chosen].
  assert (Lp : length (map was ps) = 4).
  { rewrite map_length. unfold lies in Le. rewrite !andb_true_iff in Le. destruct Le as [[[[_ Le] _] _] _].
    now apply Nat.eqb_eq in Le. }
  destruct (weigh_flip_right _ _ _ _ Lp Wg) as (V0 & B1 & B2 & B3 & B4). repeat (split; [assumption|]).
  rewrite andb_true_iff, forallb_forall. intros [Ch In']. split; [now apply B4|].
  intros e I. apply In' in I. rewrite !orb_true_iff in I. tauto.
Qed.

(** A best recolouring is safe in every mesh, by the locality lemma. *)
Theorem chosen_is_safe : Chosen_is_safe.
Proof.
  intros o s c x O Po [L _] R V. destruct (course_right o Po) as [W A].
  eapply legal_is_safe; [now apply well_formed_sensible|eapply well_formed_sensible, along_well_formed, A|exact L|exact R|exact V].
Qed.
