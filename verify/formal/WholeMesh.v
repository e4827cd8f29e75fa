(** * What holds for the whole mesh

    docs/explanation/theory.md, "What holds for the whole mesh": the number of strips is bounded by what is counted at the strip ends, if no
    dashed dual edge joins ends of two different strips. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Strips Locality Symmetry.
Import Whole.

(** Every valid colouring of a dual graph is spoken of. *)
Theorem whole_mesh_covers : Whole_mesh_covers.
Proof.
  intros ts D c N I D3 L V. destruct (valid_stripped ts (solid D c) N) as (ls & S); [|exact V|now exists ls].
  intros e J. apply I. exact (solid_incl _ _ _ J).
Qed.

(** ** The first inequality

    One inequality for each triangle, added up. Let g of its edges be solid and e dashed, and let w be 1 if the triangle is a
    strip end or isolated (g <= 1), and 0 if not. Then

        6 + (1 - w) e <= 3 g + 1 + 2 [g = 0] + w (3 - (g + e)) + w e.

    For w = 1 the two sides are equal, and for w = 0 there is at most one dashed edge. *)
Lemma sum_cons {A} (f : A -> nat) x l : list_sum (map f (x :: l)) = f x + list_sum (map f l).
Proof. reflexivity. Qed.
Lemma filter_split {A} (f : A -> bool) l : length (filter f l) + length (filter (fun x => negb (f x)) l) = length l.
Proof. induction l as [|x l IH]; [reflexivity|]. cbn [filter]. destruct (f x); cbn [negb length]; lia. Qed.

Lemma two_colors t (D : graph) : forall c, length c = length D -> degree D t = degree (solid D c) t + degree (solid D (map negb c)) t.
Proof.
  induction D as [|e D IH]; intros [|[|] c] L; try discriminate; [reflexivity| |]; simpl map; simpl solid;
    rewrite !degree_cons, (IH c) by (simpl in L; lia); lia.
Qed.

Lemma in_faces M e : well_formed M -> In e (solid_edges M) \/ In e (dashed_edges M) -> In (fst e) (faces M) /\ In (snd e) (faces M).
Proof. intros (_ & I & _) [J|J]; apply I; exact (solid_incl _ _ _ J). Qed.

Definition weight M t := if at_end M t then 1 else 0.

(** Of its two ends a dashed edge has none, one or two at strip ends; a meeting has two. *)
Lemma meetings_counted M : well_formed M ->
  list_sum (map (fun t => weight M t * degree (dashed_edges M) t) (faces M)) <=
  2 * length (meetings M) + list_sum (map (fun t => (1 - weight M t) * degree (dashed_edges M) t) (faces M)).
Proof.
  intros W. pose proof (fun e J => in_faces M e W (or_intror J)) as I.
  rewrite (weighted_handshake (weight M) _ _ (proj1 W) I), (weighted_handshake (fun t => 1 - weight M t) _ _ (proj1 W) I).
  unfold meetings, weight. clear. cbn beta. induction (dashed_edges M) as [|e l IH]; [simpl; lia|].
  rewrite !sum_cons. cbn [filter]. destruct (at_end M (fst e)), (at_end M (snd e)); cbn [andb length]; lia.
Qed.

(** Whatever the ends of different strips do, their meetings counted like a strip's own. *)
Theorem whole_mesh_any : Whole_mesh_any.
Proof.
  intros M W. unfold own_meetings, other_meetings. rewrite filter_split. pose proof W as (N & I & D & L & S).
  pose proof (number_of_strips _ _ _ S) as C.
  pose proof (handshake (faces M) (solid_edges M) N (fun e J => in_faces M e W (or_introl J))) as H.
  pose proof (meetings_counted M W) as K.
  enough (6 * length (faces M) + list_sum (map (fun t => (1 - weight M t) * degree (dashed_edges M) t) (faces M)) <=
    3 * list_sum (map (degree (solid_edges M)) (faces M)) + length (faces M) + 2 * isolated_count M + boundary_sides M +
    list_sum (map (fun t => weight M t * degree (dashed_edges M) t) (faces M))).
  { unfold strip_count, triangle_count, graph, edge in *. lia. }
  pose proof (proj1 (stripped_valid _ _ _ N S)) as T. clear N I C S H K W.
  unfold isolated_count, boundary_sides, weight, at_end. induction (faces M) as [|t l IH]; [simpl; lia|].
  rewrite !sum_cons. cbn [filter length]. specialize (D t). specialize (T t). pose proof (two_colors t _ _ L) as B.
  fold (solid_edges M) in *. fold (dashed_edges M) in *.
  destruct (Nat.leb_spec (degree (solid_edges M) t) 1), (Nat.eqb_spec (degree (solid_edges M) t) 0); rewrite ?sum_cons; cbn [length]; lia.
Qed.

Theorem whole_mesh : Whole_mesh.
Proof. intros M W J. pose proof (whole_mesh_any M W) as A. rewrite J in A. lia. Qed.

(** ** The second inequality

    A strip of several triangles has two ends, and at most one edge joins them; an isolated triangle has no meeting with
    itself. So C <= S - I. *)
Lemma filter_or {A} (f g : A -> bool) (l : list A) :
  length (filter (fun x => f x || g x) l) <= length (filter f l) + length (filter g l).
Proof. induction l as [|x l IH]; [reflexivity|]. cbn [filter]. destruct (f x), (g x); cbn [orb length]; lia. Qed.
Lemma filter_exists {A B} (q : B -> A -> bool) (l : list A) (ls : list B) :
  length (filter (fun x => existsb (fun m => q m x) ls) l) <= list_sum (map (fun m => length (filter (q m) l)) ls).
Proof.
  induction ls as [|m ls IH]; [induction l; simpl; auto|]. rewrite sum_cons.
  pose proof (filter_or (q m) (fun x => existsb (fun m => q m x) ls) l) as O. cbn [existsb]. lia.
Qed.
Lemma filter_none {A} (f : A -> bool) l : (forall x, In x l -> f x = false) -> filter f l = [].
Proof. induction l as [|x l IH]; intros N; [reflexivity|]. simpl. rewrite N by now left. apply IH. intros y I. apply N. now right. Qed.
Lemma nodup_filter {A B} (g : A -> B) (f : A -> bool) l : NoDup (map g l) -> NoDup (map g (filter f l)).
Proof.
  induction l as [|x l IH]; [auto|]. simpl. intros N. inversion_clear N as [|? ? O N']. destruct (f x); [|auto]. simpl. constructor; [|auto].
  intros I. apply O. apply in_map_iff in I as (y & <- & I). apply in_map. now apply filter_In in I.
Qed.
Lemma nodup_solid (D : graph) : forall c, NoDup (map undirected D) -> NoDup (map undirected (solid D c)).
Proof.
  induction D as [|e D IH]; intros [|[|] c] N; try constructor; inversion_clear N as [|? ? O N']; [|now apply IH|now apply IH].
  intros I. apply O. apply in_map_iff in I as (f & <- & I). apply in_map. exact (solid_incl _ _ _ I).
Qed.
Lemma undirected_pair (x y : nat) e : (fst e = x \/ fst e = y) -> (snd e = x \/ snd e = y) -> fst e <> snd e -> undirected e = undirected (x, y).
Proof. destruct e as [a b]. unfold undirected. simpl. intros [->| ->] [->| ->] N; try congruence; f_equal; lia. Qed.

Lemma isolated_by_strip M : well_formed M ->
  isolated_count M = list_sum (map (fun l => length (filter (fun t => degree (solid_edges M) t =? 0) l)) (strips M)).
Proof.
  intros (_ & _ & _ & _ & _ & P & _). unfold isolated_count.
  rewrite <- (Permutation_length (filter_perm (fun t => degree (solid_edges M) t =? 0) _ _ P)). clear.
  induction (strips M) as [|l ls IH]; [reflexivity|]. rewrite sum_cons, <- IH. cbn [concat]. now rewrite filter_app, app_length.
Qed.

Section Strip.
  Variables (M : stripification) (l : list nat).
  Hypotheses (W : well_formed M) (here : In l (strips M)).
  Let G := solid_edges M.

  Lemma strip_degree t : degree (path_edges l) t <= degree G t.
  Proof.
    destruct W as (_ & _ & _ & _ & S). apply in_split in here as (s1 & s2 & E). rewrite E in S.
    apply (stripped_perm _ _ _ (l :: s1 ++ s2)) in S; [|symmetry; apply Permutation_middle]. exact (degree_stripped _ _ _ _ t S).
  Qed.

  Lemma end_of_strip t : In t l -> degree G t <= 1 -> t = hd 0 l \/ t = last l 0.
  Proof.
    intros I D. pose proof (strip_degree t) as B. apply in_split in I as (l1 & l2 & E).
    destruct l2 as [|y l2]; [right; rewrite E; symmetry; apply last_last|].
    destruct l1 as [|x l1]; [left; now rewrite E|].
    pose proof (inner_degree (x :: l1) t (y :: l2)) as Two. rewrite <- E in Two. assert (2 <= 1); [|lia].
    etransitivity; [apply Two; discriminate|]. lia.
  Qed.

  Lemma strip_nodup : NoDup l.
  Proof.
    destruct W as (N & _ & _ & _ & _ & P & _). symmetry in P. apply (Permutation_NoDup P) in N.
    apply in_split in here as (s1 & s2 & E). rewrite E, concat_app in N. simpl in N.
    apply nodup_app in N as (_ & N & _). now apply nodup_app in N as (N & _).
  Qed.

  Lemma not_isolated t : 1 < length l -> In t l -> degree G t <> 0.
  Proof.
    intros Long I D. assert (E : exists u v m, l = u :: v :: m) by (clear - Long; destruct l as [|u [|v m]]; simpl in Long; [lia..|eauto]).
    destruct E as (u & v & m & E). pose proof (strip_degree t) as B. pose proof strip_nodup as N.
    assert (L : forall s, In s l -> t = s).
    { intros s J. apply (linked_lonely (path_edges l)); [lia|]. apply (linked_strip l); [apply incl_refl|exact J|exact I]. }
    assert (u = v) by (rewrite <- (L u), <- (L v); [reflexivity|rewrite E; simpl; tauto..]). subst v.
    rewrite E in N. inversion_clear N as [|? ? O _]. apply O. now left.
  Qed.

  Lemma one_of_each_strip : simple M ->
    length (filter (both_in l) (meetings M)) + length (filter (fun t => degree G t =? 0) l) <= 1.
  Proof.
    intros [U Loop].
    assert (I : forall e, In e (filter (both_in l) (meetings M)) ->
      fst e <> snd e /\ undirected e = undirected (hd 0 l, last l 0) /\ In (fst e) l /\ In (snd e) l).
    { intros e J. apply filter_In in J as [J H]. apply filter_In in J as [J H']. apply solid_incl in J. apply Loop in J.
      apply andb_prop in H as [Hf Hs], H' as [Df Ds]. apply Nat.leb_le in Df, Ds.
      apply existsb_exists in Hf as (f & Hf & Q), Hs as (s & Hs & R). apply Nat.eqb_eq in Q, R. subst f s.
      pose proof (end_of_strip _ Hf Df). pose proof (end_of_strip _ Hs Ds). repeat split; auto. apply undirected_pair; tauto. }
    assert (O : length (filter (both_in l) (meetings M)) <= 1).
    { assert (N : NoDup (map undirected (filter (both_in l) (meetings M)))) by (do 2 apply nodup_filter; now apply nodup_solid).
      destruct (filter (both_in l) (meetings M)) as [|e [|f r]]; simpl; auto. exfalso.
      simpl in N. inversion_clear N as [|? ? A _]. apply A. left.
      transitivity (undirected (hd 0 l, last l 0)); [|symmetry]; apply I; simpl; tauto. }
    destruct (le_lt_dec (length l) 1) as [Short|Long].
    - replace (filter (both_in l) (meetings M)) with (@nil edge).
      + destruct l as [|t [|]]; simpl in *; [lia|destruct (_ =? 0); simpl; lia|lia].
      + symmetry. destruct (filter (both_in l) (meetings M)) as [|e r]; [reflexivity|]. exfalso.
        destruct (I e (or_introl eq_refl)) as (Ne & _ & Hf & Hs). destruct l as [|t [|]]; simpl in *; [tauto| |lia].
        destruct Hf as [Hf|[]], Hs as [Hs|[]]. congruence.
    - rewrite (filter_none (fun t => _ =? 0)); [simpl; lia|]. intros t J. apply Nat.eqb_neq. now apply not_isolated.
  Qed.
End Strip.

Lemma own_bound M : well_formed M -> simple M -> own_meetings M + isolated_count M <= strip_count M.
Proof.
  intros W U. rewrite (isolated_by_strip M W). pose proof (filter_exists both_in (meetings M) (strips M)) as A.
  assert (O : forall l, In l (strips M) -> length (filter (both_in l) (meetings M)) +
    length (filter (fun t => degree (solid_edges M) t =? 0) l) <= 1) by (intros l I; now apply one_of_each_strip).
  etransitivity; [apply Nat.add_le_mono_r, A|]. clear A. unfold strip_count. induction (strips M) as [|l ls IH]; [simpl; lia|].
  rewrite !sum_cons. cbn [length]. specialize (IH (fun m I => O m (or_intror I))). specialize (O l (or_introl eq_refl)). lia.
Qed.

Theorem whole_mesh_quarter : Whole_mesh_quarter.
Proof. intros M W J U. pose proof (whole_mesh M W J). pose proof (own_bound M W U). lia. Qed.

(** ** Meshes that meet the bounds, and meshes that break them

    Drawn strip by strip, triangles in the order of the strips. *)
Definition drawn_as (ls : list (list nat)) (dashed : graph) : stripification :=
  let solids := concat (map path_edges ls) in
  Stripification (concat ls) (solids ++ dashed) (map (fun _ => true) solids ++ map (fun _ => false) dashed) ls.
(** A triangle divided into five, four of them around a vertex; the tetrahedron; two tetrahedra glued along a triangle. *)
Definition five : stripification := drawn_as [[0; 1; 2; 3]; [4]] [(0, 3); (1, 4); (2, 4)].
Definition tetrahedron : stripification := drawn_as [[0; 1; 2; 3]] [(0, 2); (0, 3); (1, 3)].
Definition bipyramid : stripification := drawn_as [[0; 1; 2; 3; 4; 5]] [(0, 3); (0, 4); (5, 1); (5, 2)].
(** The tetrahedron in two strips; a triangle on each side of the same three edges. *)
Definition halves : stripification := drawn_as [[0; 1]; [2; 3]] [(0, 2); (0, 3); (1, 2); (1, 3)].
Definition pillow : stripification := drawn_as [[0; 1]] [(0, 1); (0, 1)].

Lemma drawn_well_formed ls dashed (n := length (concat ls)) : concat ls = seq 0 n -> existsb (fun l => length l =? 0) ls = false ->
  forallb (fun e => (fst e <? n) && (snd e <? n)) dashed = true ->
  forallb (fun t => degree (dual (drawn_as ls dashed)) t <=? 3) (seq 0 n) = true -> well_formed (drawn_as ls dashed).
Proof.
  intros E F In_n D. unfold well_formed. cbn [drawn_as faces dual colors strips]. rewrite E.
  assert (I : forall e, In e (concat (map path_edges ls) ++ dashed) -> In (fst e) (seq 0 n) /\ In (snd e) (seq 0 n)).
  { intros e J. apply in_app_or in J as [J|J]; [rewrite <- E; now apply strips_in|].
    rewrite forallb_forall in In_n. apply In_n, andb_prop in J as [A B]. apply Nat.ltb_lt in A, B. rewrite !in_seq. lia. }
  repeat split; try (apply I; assumption).
  - apply seq_NoDup.
  - intros t. destruct (in_dec Nat.eq_dec t (seq 0 n)) as [J|J].
    + rewrite forallb_forall in D. now apply Nat.leb_le, (D t).
    + rewrite degree_zero; [lia|]. intros e K. apply I in K. split; intros <-; tauto.
  - now rewrite !app_length, !map_length.
  - intros J. assert (existsb (fun l => length l =? 0) ls = true) by (apply existsb_exists; now exists []). congruence.
  - now rewrite E.
  - apply Permutation_map. unfold solid_edges. cbn [drawn_as dual colors]. generalize (concat (map path_edges ls)). intros s. clear.
    induction s as [|e s IH]; [|simpl; now constructor]. simpl. induction dashed as [|e d IH]; [constructor|exact IH].
Qed.

Definition counts (M : stripification) : list nat :=
  [triangle_count M; strip_count M; isolated_count M; own_meetings M; boundary_sides M; other_meetings M].
Ltac is_well_formed := now apply drawn_well_formed.
Ltac is_simple := split; [repeat constructor; simpl; intuition discriminate|simpl; intuition (subst; discriminate)].

(** Both inequalities are equations for the first mesh, the second for the tetrahedron, the first for the bipyramid. *)
Theorem whole_mesh_met : Forall (fun '(M, numbers) => well_formed M /\ ends_joined M /\ simple M /\ counts M = numbers)
  [(five, [5; 2; 1; 1; 3; 0]); (tetrahedron, [4; 1; 0; 1; 0; 0]); (bipyramid, [6; 1; 0; 0; 0; 0])].
Proof. repeat apply Forall_cons; [..|apply Forall_nil]; (split; [is_well_formed|split; [exact eq_refl|split; [is_simple|reflexivity]]]). Qed.

(** Without the assumptions the inequalities fail: 6 * 2 > 4, and 4 * 1 > 2. *)
Theorem whole_mesh_needs :
  well_formed halves /\ simple halves /\ counts halves = [4; 2; 0; 0; 0; 4] /\
  well_formed pillow /\ ends_joined pillow /\ counts pillow = [2; 1; 0; 2; 0; 0].
Proof. split; [is_well_formed|split; [is_simple|split; [reflexivity|split; [is_well_formed|split; [exact eq_refl|reflexivity]]]]]. Qed.
