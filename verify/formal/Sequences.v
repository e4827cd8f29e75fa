(** * Whole meshes, and sequences of operations

    A mesh is the list of its triangles and the graph of its solid dual edges. An operation sees a mesh as a patch and the
    rest. The port points, which [Statements.v] puts in the middle of the dual edges that leave the patch, are not part of a mesh;
    here they are skipped. Flips are left out: they may give ports up. *)
Require Import Arith Bool List Permutation ZArith Lia.
Import ListNotations.
Require Import Statements Graph Locality Strips Drawing Checker Rows Symmetry.
Export Meshes.

(** ** Points *)
Lemma degree_alike G G' v : Permutation (map undirected G) (map undirected G') -> degree G v = degree G' v.
Proof. intros P. rewrite <- (degree_undirected G), <- (degree_undirected G'). now apply degree_perm. Qed.

Lemma points_valid xs G H : without_points xs G H -> (valid G <-> valid H).
Proof.
  intros W. induction W as [G|x xs G H _ _ IH|x xs u v R G H P Hu Hv Dx _ IH]; [tauto|exact IH|]. rewrite <- IH.
  transitivity (valid ((u, x) :: (x, v) :: R)).
  { rewrite <- (valid_undirected G), <- (valid_undirected (_ :: _)). split; apply valid_perm; [exact P|now symmetry]. }
  rewrite !valid_cons, !degree_cons, linked_cons. unfold meets. cbn [fst snd]. rewrite Nat.eqb_refl, Dx.
  assert (N : forall w, linked R w x -> w = x) by (intros w L; symmetry; exact (linked_lonely R x w Dx L)).
  assert (Nu : ~ linked R u x) by (intros L; apply N in L; contradiction).
  assert (Nv : ~ linked R x v) by (intros L; apply linked_sym, N in L; contradiction).
  destruct (Nat.eqb_spec x u), (Nat.eqb_spec v x); try congruence.
  destruct (Nat.eqb_spec v u) as [->|].
  - assert (linked R u u) by apply here. assert (linked R x x) by apply here. tauto.
  - assert (linked R x x) by apply here. simpl. intuition lia.
Qed.

Lemma points_degree xs G H : without_points xs G H -> forall v, ~ In v xs -> degree H v = degree G v.
Proof.
  intros W. induction W as [G|x xs G H _ _ IH|x xs u v R G H P Hu Hv Dx _ IH]; intros w N; [reflexivity|apply IH; simpl in N; tauto|].
  rewrite IH by (simpl in N; tauto). rewrite (degree_alike _ _ w P), !degree_cons. unfold meets. cbn [fst snd].
  assert (x <> w) by (simpl in N; tauto). destruct (Nat.eqb_spec x w); lia.
Qed.

Lemma points_gone xs G H : without_points xs G H -> forall x, In x xs -> degree H x = 0.
Proof.
  intros W. induction W as [G|x xs G H D W IH|x xs u v R G H P Hu Hv Dx W IH]; intros y I; [destruct I| |].
  - destruct (in_dec Nat.eq_dec y xs) as [J|J]; [now apply IH|]. destruct I as [<-|I]; [|contradiction].
    now rewrite (points_degree _ _ _ W).
  - destruct (in_dec Nat.eq_dec y xs) as [J|J]; [now apply IH|]. destruct I as [<-|I]; [|contradiction].
    rewrite (points_degree _ _ _ W) by exact J. rewrite degree_cons, Dx. unfold meets. cbn [fst snd].
    destruct (Nat.eqb_spec u x), (Nat.eqb_spec v x); congruence || lia.
Qed.

Lemma points_length xs G H : without_points xs G H -> NoDup xs ->
  2 * length G = 2 * length H + list_sum (map (degree G) xs).
Proof.
  intros W. induction W as [G|x xs G H D W IH|x xs u v R G H P Hu Hv Dx W IH]; intros N; [simpl; lia| |];
    inversion_clear N as [|? ? Nx Nxs]; specialize (IH Nxs); simpl map; simpl list_sum.
  - lia.
  - assert (E : map (degree G) xs = map (degree ((u, v) :: R)) xs).
    { apply map_ext_in. intros w I. rewrite (degree_alike _ _ w P), !degree_cons. unfold meets. cbn [fst snd].
      destruct (Nat.eqb_spec x w); [subst; contradiction|lia]. }
    assert (Q : degree G x = 2).
    { rewrite (degree_alike _ _ x P), !degree_cons, Dx. unfold meets. cbn [fst snd]. rewrite Nat.eqb_refl.
      destruct (Nat.eqb_spec u x), (Nat.eqb_spec v x); congruence || lia. }
    assert (L : length G = length R + 2).
    { apply Permutation_length in P. rewrite !map_length in P. etransitivity; [exact P|]. simpl. rewrite Nat.add_comm. reflexivity. }
    rewrite E, Q. simpl length in IH. unfold graph, edge in *. lia.
Qed.

(** ** One operation *)
Lemma moved_from (f : nat -> nat) G v : degree (map (moved f) G) v <> 0 -> exists w, v = f w.
Proof.
  induction G as [|[a b] G IH]; [intros D; now contradiction D|]. simpl map. rewrite degree_cons. unfold meets, moved. cbn [fst snd].
  destruct (Nat.eqb_spec (f a) v) as [<-|]; [now exists a|]. destruct (Nat.eqb_spec (f b) v) as [<-|]; [now exists b|]. exact IH.
Qed.
Lemma renamed_from (f : nat -> nat) G G' v : renamed f G G' -> degree G' v <> 0 -> exists w, v = f w.
Proof. intros R D. apply (moved_from f G). now rewrite (degree_alike _ _ v R). Qed.
Lemma renamed_length (f : nat -> nat) G G' : renamed f G G' -> length G' = length G.
Proof. intros R. apply Permutation_length in R. rewrite !map_length in R. symmetry. exact R. Qed.

Section Operation.
  Variables (p : patch) (T : table) (M M' : mesh) (told : Z).
  Hypothesis (S0 : sensible p (before p)) (S1 : sensible p (after p)).
  Hypothesis done : operation p T M told M'.
  Let k := ports p.
  Let size := k + Nat.max (triangles (before p)) (triangles (after p)).

  Lemma operation_valid : safe p T -> valid (edges M) -> valid (edges M').
  Proof.
    destruct done as (s & c & x & O & others & f & J & Ls & Lc & E & Lx & R & _ & (G & W & Re & _) & (G' & W' & Re' & _) & _).
    intros S V. rewrite (renamed_valid f J _ _ Re'), <- (points_valid _ _ _ W'). apply (S s c x O Ls Lc E R).
    now rewrite (points_valid _ _ _ W), <- (renamed_valid f J _ _ Re).
  Qed.

  Lemma solid_length es : forall c, length c = length es -> length (solid es c) = solids c.
  Proof. induction es as [|e es IH]; intros [|[|] c] L; try discriminate; simpl in *; auto; unfold solids in *; simpl; auto. Qed.
  Lemma drawing_length d s x : length (owner d) = length s -> length x = length (inner d) ->
    length (drawing d s x) = solids s + solids x.
  Proof.
    intros Ls Lx. unfold drawing. rewrite app_length, !solid_length; [reflexivity|now rewrite inner_edges_length|].
    now rewrite port_edges_length.
  Qed.

  Lemma operation_told : (strips_of M' = strips_of M + told)%Z.
  Proof.
    destruct done as (s & c & x & O & others & f & J & Ls & Lc & E & Lx & R & _ & (G & W & Re & N) & (G' & W' & Re' & N') & ->).
    apply points_length in W, W'; try apply seq_NoDup. apply renamed_length in Re, Re'.
    apply Permutation_length in N, N'. rewrite map_length, app_length, seq_length in N, N'.
    assert (D : map (degree (O ++ drawing (before p) s c)) (seq 0 (ports p)) = map (degree (O ++ drawing (after p) s x)) (seq 0 (ports p))).
    { apply map_ext_in. intros i I. apply in_seq in I. rewrite !degree_app. f_equal.
      rewrite !(degree_point p) by (assumption || apply S0 || apply S1 || lia). reflexivity. }
    rewrite D in W. rewrite app_length, drawing_length in W, W' by (rewrite ?Ls; try assumption; try apply S0; apply S1).
    unfold strips_of. rewrite N, N', Re, Re'. lia.
  Qed.

  (** The degree of a triangle, in the mesh and in the drawing. *)
  Lemma triangle_degree d s x O others f N : looks_like p d s x O others f N -> (forall u v, f u = f v -> u = v) ->
    forall v, k <= v -> degree (edges N) (f v) = degree (O ++ drawing d s x) v.
  Proof.
    intros (G & W & Re & _) J v Hv. rewrite (renamed_degree f J _ _ v Re). apply (points_degree _ _ _ W).
    intros I. apply in_seq in I. unfold k in *. lia.
  Qed.

  Lemma operation_sane : sane M -> sane M'.
  Proof.
    destruct done as (s & c & x & O & others & f & J & Ls & Lc & E & Lx & R & Far & L & L' & _). intros [Nd Ends].
    pose proof L as (G & W & Re & N). pose proof L' as (G' & W' & Re' & N'). split.
    - eapply Permutation_NoDup; [symmetry; exact N'|]. eapply Permutation_NoDup in Nd; [|exact N].
      apply FinFun.Injective_map_NoDup; [exact J|]. rewrite map_app in Nd. apply nodup_app in Nd as (_ & Nd & _).
      apply NoDup_map_inv in Nd. clear - Nd Far.
      assert (A : forall n a, a + n <= ports p + Nat.max (triangles (before p)) (triangles (after p)) -> NoDup (seq a n ++ others)).
      { induction n as [|n IH]; intros a B; [exact Nd|]. simpl. constructor; [|apply IH; lia].
        intros I. apply in_app_or in I as [I|I]; [apply in_seq in I; lia|]. apply Far in I. lia. }
      apply A. lia.
    - intros v D. pose proof (renamed_from f _ _ v Re' D) as (w & ->).
      eapply Permutation_in; [symmetry; exact N'|]. apply in_map. apply in_or_app.
      rewrite (renamed_degree f J _ _ w Re') in D.
      destruct (le_lt_dec k w) as [Hk|Hk].
      2: { exfalso. apply D. apply (points_gone _ _ _ W'). apply in_seq. unfold k in *. lia. }
      rewrite (points_degree _ _ _ W') in D by (intros I; apply in_seq in I; unfold k in *; lia).
      destruct (le_lt_dec size w) as [Hs|Hs].
      + right. rewrite degree_app, (degree_far p (after p)) in D by (assumption || apply Nat.le_max_r).
        assert (I : In (f w) (nodes M)).
        { apply Ends. rewrite (triangle_degree _ _ _ _ _ _ _ L J w Hk), degree_app. lia. }
        eapply Permutation_in in I; [|exact N]. apply in_map_iff in I as (w' & Q & I). apply J in Q as ->.
        apply in_app_or in I as [I|I]; [|exact I]. apply in_seq in I. unfold size, k in *. lia.
      + left. rewrite degree_app, (degree_outer p O w R) in D by (unfold within_patch; unfold size, k in *; lia).
        apply in_seq. split; [exact Hk|]. destruct (lt_dec w (k + triangles (after p))) as [H|H]; [exact H|]. exfalso. apply D.
        simpl. apply degree_zero. intros e I. unfold drawing in I. apply in_app_or in I as [I|I]; apply solid_incl in I.
        * unfold port_edges in I. destruct e as [i t]. pose proof (in_combine_l _ _ _ _ I) as Hi. apply in_combine_r in I.
          apply in_seq in Hi. apply in_map_iff in I as (u & <- & I). apply S1 in I. destruct S1 as [Lo _]. rewrite Lo in *.
          simpl. unfold k in *. lia.
        * unfold inner_edges in I. apply in_map_iff in I as (g & <- & I). apply S1 in I. destruct S1 as [Lo _]. rewrite Lo in *.
          simpl. unfold k in *. lia.
  Qed.

  Lemma operation_none_isolated strips : within p T strips 0 -> none_isolated M -> none_isolated M'.
  Proof.
    destruct done as (s & c & x & O & others & f & J & Ls & Lc & E & Lx & R & Far & L & L' & _). intros Wi No v I.
    pose proof L as (_ & _ & _ & N). pose proof L' as (_ & _ & _ & N').
    eapply Permutation_in in I; [|exact N']. apply in_map_iff in I as (w & <- & I).
    assert (Inside : forall d s x t, sensible p d -> triangles d <= Nat.max (triangles (before p)) (triangles (after p)) ->
      t < triangles d -> degree (O ++ drawing d s x) (k + t) = degree (drawing d s x) (length (owner d) + t)).
    { intros d s' x' t [-> _] Le Ht. rewrite degree_app, (degree_outer p O (k + t) R); [reflexivity|].
      unfold within_patch, k. lia. }
    apply in_app_or in I as [I|I].
    - apply in_seq in I. fold k in I. rewrite (triangle_degree _ _ _ _ _ _ _ L' J w) by lia. replace w with (k + (w - k)) by lia.
      rewrite Inside by (assumption || apply Nat.le_max_r || lia). intros Z.
      destruct (Wi s c x Ls Lc E) as [_ Iso].
      assert (Before : isolated (before p) s c = 0).
      { unfold isolated. destruct (filter _ _) as [|t l] eqn:F; [reflexivity|]. exfalso.
        assert (A : In t (t :: l)) by now left. rewrite <- F in A. apply filter_In in A as [A B]. apply in_seq in A.
        apply Nat.eqb_eq in B. apply (No (f (k + t))).
        - eapply Permutation_in; [symmetry; exact N|]. apply in_map, in_or_app. left. apply in_seq. unfold k. lia.
        - rewrite (triangle_degree _ _ _ _ _ _ _ L J (k + t)) by lia. rewrite Inside by (assumption || apply Nat.le_max_l || lia).
          exact B. }
      assert (A : In (w - k) (filter (fun t => degree (drawing (after p) s x) (length (owner (after p)) + t) =? 0) (seq 0 (triangles (after p))))).
      { apply filter_In. split; [apply in_seq; lia|]. now apply Nat.eqb_eq. }
      unfold isolated in Iso at 1. destruct (filter _ _); [destruct A|simpl in Iso; lia].
    - pose proof (Far w I) as B. fold k in B. rewrite (triangle_degree _ _ _ _ _ _ _ L' J w) by lia.
      rewrite degree_app, (degree_far p (after p)) by (assumption || apply Nat.le_max_r).
      assert (Q : degree (edges M) (f w) <> 0).
      { apply No. eapply Permutation_in; [symmetry; exact N|]. apply in_map, in_or_app. now right. }
      rewrite (triangle_degree _ _ _ _ _ _ _ L J w), degree_app, (degree_far p (before p)) in Q
        by (assumption || apply Nat.le_max_l || lia).
      exact Q.
  Qed.
End Operation.

(** ** Sequences *)
Section Sequence.
  Variable allowed : patch -> table -> Prop.
  Hypothesis fine : forall p T, allowed p T -> sensible p (before p) /\ sensible p (after p) /\ safe p T.

  Theorem sequence_valid M told M' : sequence allowed M told M' -> valid (edges M) -> valid (edges M').
  Proof.
    intros Q V. induction Q as [|p T N N' t t' Q IH A D]; [exact V|]. destruct (fine p T A) as (S0 & S1 & S).
    exact (operation_valid p T N N' t' D S IH).
  Qed.
  Theorem sequence_told M told M' : sequence allowed M told M' -> (strips_of M' = strips_of M + told)%Z.
  Proof.
    intros Q. induction Q as [|p T N N' t t' Q IH A D]; [lia|]. destruct (fine p T A) as (S0 & S1 & _).
    rewrite (operation_told p T N N' t' S0 S1 D), IH. lia.
  Qed.
  Theorem sequence_sane M told M' : sequence allowed M told M' -> sane M -> sane M'.
  Proof.
    intros Q V. induction Q as [|p T N N' t t' Q IH A D]; [exact V|]. destruct (fine p T A) as (S0 & S1 & S).
    exact (operation_sane p T N N' t' S1 D IH).
  Qed.
  Theorem sequence_none_isolated M told M' : (forall p T, allowed p T -> exists strips, within p T strips 0) ->
    sequence allowed M told M' -> none_isolated M -> none_isolated M'.
  Proof.
    intros Never Q V. induction Q as [|p T N N' t t' Q IH A D]; [exact V|]. destruct (fine p T A) as (S0 & S1 & S).
    destruct (Never p T A) as (strips & Wi). exact (operation_none_isolated p T N N' t' S0 S1 D strips Wi IH).
  Qed.
End Sequence.

(** ** Without isolated triangles strips are at most half of the triangles *)
Theorem half_as_many M : sane M -> none_isolated M -> (2 * strips_of M <= Z.of_nat (length (nodes M)))%Z.
Proof.
  intros [N Ends] No. assert (H : list_sum (map (degree (edges M)) (nodes M)) = 2 * length (edges M)).
  { apply handshake; [exact N|]. intros [a b] I. split; apply Ends.
    - apply (adjacent_degree _ a b). now left. - apply (adjacent_degree _ b a). now right. }
  assert (G : length (nodes M) <= list_sum (map (degree (edges M)) (nodes M))).
  { clear - No. unfold none_isolated in No. induction (nodes M) as [|v vs IH]; [simpl; lia|]. simpl.
    assert (degree (edges M) v <> 0) by (apply No; now left). assert (length vs <= list_sum (map (degree (edges M)) vs)); [|lia].
    apply IH. intros w I. apply No. now right. }
  unfold strips_of. lia.
Qed.

(** [strips_of] is the number of strips, however they are listed. *)
Theorem strips_counted : Strips_counted.
Proof. intros M strips S. apply number_of_strips in S. unfold strips_of. lia. Qed.
