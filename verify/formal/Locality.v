(** * The locality lemma

    The rest of the mesh is any graph [O] that meets the patch in nothing but the port points. A recolouring of the
    patch is safe whatever [O] is if and only if it is legal: a patch can be judged once and for all, without its
    surroundings. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph.

Definition within_patch (k size v : nat) : Prop := k <= v < size.
(** The edges of [I] lie inside: they join triangles of the patch and port points. *)
Definition in_patch (k size : nat) (I : graph) : Prop := forall e, In e I -> fst e < size /\ snd e < size.

Section Swap.
  (** Two graphs [I] and [I'] inside the same hole of [O], with the same port points [0 ... k-1]. *)
  Variables (k size : nat) (I I' : graph).
  Hypothesis inside : in_patch k size I.
  Hypothesis inside' : in_patch k size I'.
  Hypothesis links : forall i j, i < k -> j < k -> linked I' i j -> linked I i j.

  Definition outer (O : graph) : Prop :=
    forall e, In e O -> ~ within_patch k size (fst e) /\ ~ within_patch k size (snd e).

  (** A walk after the change can be led along the old links before the change, up to the last port it passed. *)
  Lemma reroute O u v : outer O -> ~ within_patch k size u -> linked (O ++ I') u v ->
    (~ within_patch k size v /\ linked (O ++ I) u v) \/
    (within_patch k size v /\ exists i, i < k /\ linked (O ++ I) u i /\ linked I' i v).
  Proof.
    intros Out Hu L.
    assert (Win : forall x y, linked I x y -> linked (O ++ I) x y).
    { intros x y. apply linked_mono. intros e H. apply in_or_app. now right. }
    induction L as [|v w L IH A]; [left; split; [exact Hu|apply here]|].
    assert (C : adjacent O v w \/ adjacent I' v w).
    { destruct A as [A|A]; apply in_app_or in A as [A|A]; unfold adjacent; auto. }
    destruct C as [C|C].
    - assert (Hv : ~ within_patch k size v /\ ~ within_patch k size w).
      { destruct C as [C|C]; apply Out in C; simpl in C; tauto. }
      destruct IH as [[_ IH]|[B _]]; [|tauto]. left. split; [tauto|]. apply onward with v; [exact IH|].
      destruct C as [C|C]; [left|right]; apply in_or_app; now left.
    - assert (Hvw : v < size /\ w < size) by (destruct C as [C|C]; apply inside' in C; simpl in C; lia).
      assert (E : exists i, i < k /\ linked (O ++ I) u i /\ linked I' i w).
      { destruct IH as [[Hv IH]|[_ (i & Hi & IH & M)]].
        - exists v. unfold within_patch in Hv. split; [lia|]. split; [exact IH|now apply linked_edge].
        - exists i. split; [exact Hi|]. split; [exact IH|now apply onward with v]. }
      destruct (le_lt_dec k w) as [Hw|Hw]; [right; split; [unfold within_patch; lia|exact E]|].
      left. split; [unfold within_patch; lia|]. destruct E as (i & Hi & M & N).
      apply linked_trans with i; [exact M|]. apply Win. now apply links.
  Qed.

  Lemma swap_links O u v : outer O -> ~ within_patch k size u -> ~ within_patch k size v ->
    linked (O ++ I') u v -> linked (O ++ I) u v.
  Proof. intros Out Hu Hv L. destruct (reroute O u v Out Hu L) as [[_ H]|[H _]]; tauto. Qed.

  Lemma swap_acyclic O : outer O -> acyclic I' -> acyclic (O ++ I) -> acyclic (O ++ I').
  Proof.
    intros Out A'. induction O as [|[a b] O IH]; simpl; [auto|]. rewrite !acyclic_cons. intros [A N].
    assert (Out' : outer O) by (intros e H; apply Out; now right).
    split; [now apply IH|]. intros L. apply N. apply swap_links; auto; apply (Out (a, b)); now left.
  Qed.
End Swap.

(** ** The lemma for patches *)
Section Patch.
  Variable p : patch.
  Let k := ports p.
  Let size := k + Nat.max (triangles (before p)) (triangles (after p)).
  Hypothesis sensible_before : sensible p (before p).
  Hypothesis sensible_after : sensible p (after p).

  Lemma solid_incl es c e : In e (solid es c) -> In e es.
  Proof.
    revert c. induction es as [|f es IH]; intros [|[|] c]; simpl; try tauto.
    - intros [H|H]; eauto. - eauto.
  Qed.

  Lemma drawing_inside d s x : sensible p d -> triangles d <= Nat.max (triangles (before p)) (triangles (after p)) ->
    in_patch k size (drawing d s x).
  Proof.
    intros (O & T & E) M e H. unfold size, k. unfold drawing in H. apply in_app_or in H as [H|H]; apply solid_incl in H.
    - unfold port_edges in H. destruct e as [i t]. pose proof (in_combine_l _ _ _ _ H) as Hi. apply in_combine_r in H.
      apply in_seq in Hi. apply in_map_iff in H as (u & <- & H). apply T in H. simpl. lia.
    - unfold inner_edges in H. apply in_map_iff in H as (f & <- & H). apply E in H. simpl. lia.
  Qed.

  (** A port point has the same degree in every drawing: its port's half edge, when the port is solid. *)
  Lemma inner_away d x v : length (owner d) = k -> v < k -> degree (solid (inner_edges d) x) v = 0.
  Proof.
    intros L H. apply degree_zero. intros e I. apply solid_incl in I. apply in_map_iff in I as (f & <- & _). simpl. lia.
  Qed.

  Lemma degree_ports l : forall lo s v, lo <= v < lo + length l -> (forall t, In t l -> v < t) ->
    degree (solid (combine (seq lo (length l)) l) s) v = (if nth (v - lo) s false then 1 else 0).
  Proof.
    induction l as [|t l IH]; intros lo s v Hv B; simpl in *; [lia|].
    destruct s as [|b s]; [destruct (v - lo); reflexivity|].
    assert (Ht : v < t) by (apply B; now left).
    destruct (Nat.eq_dec v lo) as [->|N].
    - assert (Z : degree (solid (combine (seq (S lo) (length l)) l) s) lo = 0).
      { apply degree_zero. intros [u w] I. apply solid_incl in I. pose proof (in_combine_l _ _ _ _ I) as J.
        apply in_combine_r in I. apply in_seq in J. specialize (B w (or_intror I)). simpl. lia. }
      rewrite Nat.sub_diag. destruct b; [|exact Z]. rewrite degree_cons, Z. unfold meets. simpl.
      rewrite Nat.eqb_refl. destruct (Nat.eqb_spec t lo); [lia|reflexivity].
    - assert (R : degree (solid (combine (seq (S lo) (length l)) l) s) v = (if nth (v - lo) (b :: s) false then 1 else 0)).
      { replace (v - lo) with (S (v - S lo)) by lia. apply IH; [lia|]. intros u Hu. apply B. now right. }
      destruct b; [|exact R]. rewrite degree_cons. unfold meets. simpl fst. simpl snd.
      destruct (Nat.eqb_spec lo v), (Nat.eqb_spec t v); lia.
  Qed.

  Lemma degree_point d s x i : length (owner d) = k -> i < k ->
    degree (drawing d s x) i = (if nth i s false then 1 else 0).
  Proof.
    intros L H. unfold drawing. rewrite degree_app, inner_away, Nat.add_0_r by assumption. unfold port_edges. rewrite L.
    replace k with (length (map (fun t => k + t) (owner d))) at 1 by now rewrite map_length.
    rewrite degree_ports.
    - now rewrite Nat.sub_0_r.
    - rewrite map_length. lia.
    - intros t Ht. apply in_map_iff in Ht as (u & <- & _). lia.
  Qed.

  Lemma degree_far d s x v : sensible p d -> triangles d <= Nat.max (triangles (before p)) (triangles (after p)) ->
    size <= v -> degree (drawing d s x) v = 0.
  Proof. intros S M H. apply degree_zero. intros e I. apply (drawing_inside d s x S M) in I. lia. Qed.

  Lemma degree_outer O v : rest_of_mesh p O -> within_patch k size v -> degree O v = 0.
  Proof.
    intros R H. apply degree_zero. intros e I. apply R in I. unfold within_patch, size, k in *. lia.
  Qed.

  (** Sound recolourings are safe in every mesh, also when they give ports up ... *)
  Theorem sound_is_safe s c s' x O : sound p s c s' x -> kept s s' -> rest_of_mesh p O ->
    valid (O ++ drawing (before p) s c) -> valid (O ++ drawing (after p) s' x).
  Proof.
    intros (_ & V & Links) [_ Kept] R [D A].
    assert (M0 : triangles (before p) <= Nat.max (triangles (before p)) (triangles (after p))) by lia.
    assert (M1 : triangles (after p) <= Nat.max (triangles (before p)) (triangles (after p))) by lia.
    split.
    - intros v. specialize (D v). rewrite degree_app in *. destruct (le_lt_dec k v) as [Hk|Hk].
      + destruct (le_lt_dec size v) as [Hs|Hs].
        * rewrite (degree_far (after p)) by assumption. lia.
        * rewrite (degree_outer O v R) by (unfold within_patch; lia). apply V.
      + rewrite degree_point in * by (assumption || apply sensible_before || apply sensible_after).
        specialize (Kept v). destruct (nth v s' false), (nth v s false); intuition (discriminate || lia).
    - apply swap_acyclic with (k := k) (size := size) (I := drawing (before p) s c); try apply R; try assumption.
      + now apply drawing_inside.
      + apply V.
  Qed.

  Corollary legal_is_safe s c x O : legal p s c x -> rest_of_mesh p O ->
    valid (O ++ drawing (before p) s c) -> valid (O ++ drawing (after p) s x).
  Proof. intros L. apply sound_is_safe; [exact L|]. split; auto. Qed.

  (** ... and nothing else is: a valid recolouring that is not legal goes wrong in some mesh, one in which a single
      edge outside joins two ports. *)
  Theorem illegal_is_unsafe s c x i j : valid (drawing (before p) s c) -> i < k -> j < k ->
    linked (drawing (after p) s x) i j -> ~ linked (drawing (before p) s c) i j ->
    let O := [(i, j)] in
    rest_of_mesh p O /\ valid (O ++ drawing (before p) s c) /\ ~ valid (O ++ drawing (after p) s x).
  Proof.
    intros V Hi Hj L N. simpl. split; [|split].
    - intros e [<-|[]]. simpl. unfold within_patch, k in *. lia.
    - apply valid_cons. split; [exact V|].
      rewrite !degree_point by (assumption || apply sensible_before).
      destruct (nth i s false), (nth j s false); repeat split; auto.
    - rewrite valid_cons. tauto.
  Qed.

  (** The locality lemma. *)
  Theorem locality s c x : length x = length (inner (after p)) -> valid (drawing (before p) s c) ->
    (legal p s c x <->
     forall O, rest_of_mesh p O -> valid (O ++ drawing (before p) s c) -> valid (O ++ drawing (after p) s x)).
  Proof.
    intros Lx V. split; [intros L O; now apply legal_is_safe|]. intros S. split; [exact Lx|]. split.
    - apply (S []); [intros e []|exact V].
    - intros i j Hi Hj L.
      destruct (linked_or_not (drawing (before p) s c) i j) as [H|H]; [exact H|]. exfalso.
      destruct (illegal_is_unsafe s c x i j V Hi Hj L H) as (R & B & A). exact (A (S _ R B)).
  Qed.
End Patch.
