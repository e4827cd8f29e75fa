(** * Checking a run

    What [restrip-check] decides of one split or collapse of a run (docs/trace.md). [judge] is extracted; the reader around
    it is written by hand. It is given the raw triangles of the patch before and after, by their vertices, the mesh edges
    where the ports are, and what the mesh says of colours and neighbours. It makes sure that the triangles lie as a patch
    of [Spec.v], and answers how good a recolouring of that patch can be, and whether the one at hand is a best one
    ([judge_right]). *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Spec Graph Strips Locality Drawing Checker Rows Symmetry Frontier Fold Route EveryFan.

(** ** The families and their positions *)
Inductive position :=
| split_at (k a : nat) | collapse_at (k a : nat)
| open_split_at (k i j : nat) | open_collapse_at (k i j : nat)
| boundary_split_at (k i : nat) | boundary_collapse_at (k i : nat).

Definition possible (o : position) : bool :=
  match o with
  | split_at k a | collapse_at k a => (3 <=? k) && (1 <=? a) && (a <? k)
  | open_split_at k i j | open_collapse_at k i j => (1 <=? k) && (i <? j) && (j <=? k)
  | boundary_split_at k i | boundary_collapse_at k i => (1 <=? k) && (i <=? k)
  end.
Definition patch_at (o : position) : patch :=
  match o with
  | split_at k a => split k a | collapse_at k a => collapse k a
  | open_split_at k i j => open_split k i j | open_collapse_at k i j => open_collapse k i j
  | boundary_split_at k i => boundary_split k i | boundary_collapse_at k i => boundary_collapse k i
  end.
(** How the side after is drawn ([drawn_along]). *)
Record course := Course { way : shape; met_first : nat; met_last : nat; left_over : nat }.
Definition course_at (o : position) : course :=
  match o with
  | split_at k a => Course (ring_route k a) (a + 1) (k - a + 1) 1
  | collapse_at k _ => Course (closed_route k) (k - 1) 1 0
  | open_split_at k i j => Course (chord_route k i j) (j + 1) (k - j) 1
  | open_collapse_at k _ _ | boundary_collapse_at k _ => Course (open_route k) (k - 1) 0 0
  | boundary_split_at k i => Course (one_route k i) k 0 0
  end.

Lemma course_right o : possible o = true ->
  well_formed_side (patch_at o) (before (patch_at o)) = true /\
  drawn_along (after (patch_at o)) (ports (patch_at o)) (way (course_at o)) (met_first (course_at o)) (met_last (course_at o)) (left_over (course_at o)).
Proof.
  destruct o as [k a|k a|k i j|k i j|k i|k i]; cbn [possible patch_at course_at way met_first met_last left_over];
    rewrite ?andb_true_iff, ?Nat.leb_le, ?Nat.ltb_lt; intros H;
    match goal with |- context [ports ?p] => assert (E : ports p = k) by apply seq_length end; rewrite E; split;
    try (eapply along_well_formed; rewrite E);
    [apply closed_along|apply ring_along|apply ring_along|apply closed_along|apply open_along|apply chord_along
    |apply chord_along|apply open_along|apply open_along|apply one_along|apply one_along|apply open_along]; lia.
Qed.

(** ** What is best *)
Record verdict := Verdict {
  solid_before : nat; alone_before : nat;  (** solid inner edges and isolated triangles of the patch before *)
  solid_best : nat; alone_best : nat;      (** those after a best recolouring *)
  chosen : bool                            (** the recolouring at hand is a best one *)
}.

(** Of the patch at [o] with the ports [s] and the inner edges [c]; [x] is the recolouring at hand. The route counts two
    vertices more than there are triangles, which are isolated. *)
Definition weigh (o : position) (s c x : coloring) : option verdict :=
  let p := patch_at o in let r := course_at o in
  match drawn (before p) s c with
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

(** ** Raw triangles

    [V] are the vertices, of which nothing is known but [same]. A mesh edge is named in the direction in which the triangle
    to its left has it. *)
Section Raw.
  Context {V : Type} (same : V -> V -> bool).
  Definition corners : Type := V * V * V.
  Definition mesh_edge : Type := V * V.
  Definition rim (t : corners) : list mesh_edge := let '(a, b, c) := t in [(a, b); (b, c); (c, a)].
  Definition turned (e : mesh_edge) : mesh_edge := (snd e, fst e).
  Definition same_edge (e f : mesh_edge) : bool := same (fst e) (fst f) && same (snd e) (snd f).
  Definition among (e : mesh_edge) (l : list mesh_edge) : bool := existsb (same_edge e) l.
  Definition either_way (e : mesh_edge) (l : list mesh_edge) : bool := among e l || among (turned e) l.
  (** No triangle is listed twice, from whichever corner on. *)
  Fixpoint distinct (ts : list corners) : bool :=
    match ts with
    | [] => true
    | t :: r => match rim t with e :: _ => negb (existsb (fun u => among e (rim u)) r) | [] => false end && distinct r
    end.

  (** The mesh edge between two triangles, and those between the triangles that dual edges join. *)
  Definition between (t u : corners) : option mesh_edge := List.find (fun e => among (turned e) (rim u)) (rim t).
  Fixpoint crossed (ts : list corners) (es : list edge) : option (list mesh_edge) :=
    match es with
    | [] => Some []
    | (i, j) :: r =>
        match nth_error ts i, nth_error ts j with
        | Some t, Some u =>
            match between t u, crossed ts r with Some e, Some l => Some (e :: l) | _, _ => None end
        | _, _ => None
        end
    end.

  (** The triangles [ts] lie as the side [d]: its inner edges cross the mesh edges [es], its ports [ps], and every other edge of the triangles has no [neighbour], a triangle on its other side. *)
  Definition lies (d : side) (ts : list corners) (ps es : list mesh_edge) (neighbour : mesh_edge -> bool) : bool :=
    (length ts =? triangles d) && (length ps =? length (owner d)) && distinct ts &&
    forallb (fun x => match nth_error ts (fst x) with Some t => among (snd x) (rim t) | None => false end)
      (combine (owner d) ps) &&
    forallb (fun e => among e ps || either_way e es || negb (neighbour e)) (flat_map rim ts).

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
    induction l as [|[i j] l IH]; intros es E; [now injection E as <-|]. cbn [crossed] in E.
    destruct (nth_error ts i) as [t|]; [|discriminate]. destruct (nth_error ts j) as [u|]; [|discriminate].
    destruct (between t u); [|discriminate]. destruct (crossed ts l) as [r|]; [|discriminate]. injection E as <-.
    simpl. f_equal. now apply IH.
  Qed.

  Theorem judge_right o olds news ps was is beside beside' altered v :
    judge o olds news ps was is beside beside' altered = Some v ->
    let p := patch_at o in
    exists es fs,
      crossed olds (inner (before p)) = Some es /\ crossed news (inner (after p)) = Some fs /\
      possible o = true /\ lies (before p) olds ps es beside = true /\ lies (after p) news ps fs beside' = true /\
      let s := map was ps in let c := map was es in
      valid (drawing (before p) s c) /\
      solid_before v = solids c /\ alone_before v = isolated (before p) s c /\
      (exists y, best p s c y /\ solids y = solid_best v /\ isolated (after p) s y = alone_best v) /\
      (chosen v = true ->
        best p s c (map is fs) /\ map is ps = s /\
        forall e, In e altered -> either_way e es = true \/ either_way e fs = true).
  Proof.
    intros E p. unfold judge in E. fold p in E.
    destruct (crossed olds (inner (before p))) as [es|] eqn:Ce; [|discriminate].
    destruct (crossed news (inner (after p))) as [fs|] eqn:Cf; [|discriminate].
    destruct (possible o && lies (before p) olds ps es beside && lies (after p) news ps fs beside') eqn:L; [|discriminate].
    destruct (weigh o (map was ps) (map was es) (map is fs)) as [w|] eqn:Wg; [|discriminate]. injection E as <-.
    apply andb_prop in L as [L Lf]. apply andb_prop in L as [Po Le]. exists es, fs. repeat (split; [reflexivity || assumption|]).
    cbn [solid_before alone_before solid_best alone_best chosen].
    assert (Lp : length ps = ports p).
    { unfold lies in Le. rewrite !andb_true_iff in Le. destruct Le as [[[[_ Le] _] _] _]. now apply Nat.eqb_eq in Le. }
    destruct (weigh_right o (map was ps) (map was es) (map is fs) w Po) as (V0 & B1 & B2 & B3 & B4);
      [now rewrite map_length|rewrite map_length; now apply crossed_length with olds|exact Wg|].
    fold p in V0, B1, B2, B3, B4. repeat (split; [assumption|]). rewrite !andb_true_iff, !forallb_forall. intros [[Ch K] In'].
    split; [now apply B4|]. split.
    - apply map_ext_in. intros e I. apply K in I. now apply eqb_prop in I.
    - intros e I. apply In' in I. now apply orb_prop in I.
  Qed.
End Raw.

(** A best recolouring is safe in every mesh, by the locality lemma. *)
Corollary chosen_is_safe o s c x O : possible o = true -> best (patch_at o) s c x -> rest_of_mesh (patch_at o) O ->
  valid (O ++ drawing (before (patch_at o)) s c) -> valid (O ++ drawing (after (patch_at o)) s x).
Proof.
  intros Po [L _] R V. destruct (course_right o Po) as [W A].
  eapply legal_is_safe; [now apply well_formed_sensible|eapply well_formed_sensible, along_well_formed, A|exact L|exact R|exact V].
Qed.
