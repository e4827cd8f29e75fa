(** * The other half of the positions

    Turning or mirroring a fan takes each of its positions to another one: (k, a) to (k, k - a), gaps i, j to k - j,
    k - i. So the checker is run for one half of the positions. For the other half the table is compared, entry by
    entry, with the image of the table that the checker has accepted; this file proves that this is enough. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Locality Strips Table Drawing Checker Rows.

(** ** Renaming the vertices of a graph *)
Section Renamed.
  Variable f : nat -> nat.
  Hypothesis injective : forall u v, f u = f v -> u = v.

  Local Notation moved := (Statements.moved f).
  Local Notation renamed := (Statements.renamed f).

  Lemma degree_moved G v : degree (map moved G) (f v) = degree G v.
  Proof.
    induction G as [|e G IH]; [reflexivity|]. simpl map. rewrite !degree_cons, IH. f_equal. unfold meets, Statements.moved. simpl.
    assert (E : forall u, (f u =? f v) = (u =? v)).
    { intros u. destruct (Nat.eqb_spec u v) as [->|N]; [apply Nat.eqb_refl|]. apply Nat.eqb_neq. intros Q. now apply N, injective. }
    now rewrite !E.
  Qed.

  Lemma linked_moved G u v : linked (map moved G) (f u) (f v) <-> linked G u v.
  Proof.
    split; intros L.
    - assert (W : forall x, linked (map moved G) (f u) x -> exists w, x = f w /\ linked G u w).
      { intros x M. induction M as [|y z _ (w & -> & IH) A]; [exists u; split; [reflexivity|apply here]|].
        destruct A as [A|A]; apply in_map_iff in A as ([a b] & Q & I); injection Q as Qa Qb; simpl in *.
        - apply injective in Qa as ->. exists b. split; [now symmetry|]. apply onward with w; [exact IH|now left].
        - apply injective in Qb as ->. exists a. split; [now symmetry|]. apply onward with w; [exact IH|now right]. }
      destruct (W _ L) as (w & Q & M). now apply injective in Q as ->.
    - induction L as [|v w _ IH A]; [apply here|]. apply onward with (f v); [exact IH|].
      destruct A as [A|A]; [left|right]; exact (in_map moved _ _ A).
  Qed.

  Lemma valid_moved G : valid (map moved G) <-> valid G.
  Proof.
    induction G as [|[a b] G IH]; [reflexivity|]. simpl map. change (moved (a, b)) with (f a, f b).
    now rewrite !valid_cons, IH, !degree_moved, linked_moved.
  Qed.

  Lemma renamed_valid G G' : renamed G G' -> (valid G' <-> valid G).
  Proof.
    intros R. rewrite <- (valid_undirected G'), <- (valid_moved G), <- (valid_undirected (map moved G)).
    split; apply valid_perm; [symmetry|]; exact R.
  Qed.
  Lemma renamed_linked G G' u v : renamed G G' -> (linked G' (f u) (f v) <-> linked G u v).
  Proof.
    intros R. rewrite <- (linked_undirected G'), <- (linked_moved G), <- (linked_undirected (map moved G)).
    split; apply linked_perm; [symmetry|]; exact R.
  Qed.
  Lemma renamed_degree G G' v : renamed G G' -> degree G' (f v) = degree G v.
  Proof.
    intros R. rewrite <- (degree_undirected G'), <- (degree_moved G), <- (degree_undirected (map moved G)).
    apply degree_perm. symmetry. exact R.
  Qed.
End Renamed.

(** ** Colours in another order

    Place n of the new order has the colour of place [nth n places] of the old one. *)
Definition taken (places : list nat) (c : coloring) : coloring := map (fun n => nth n c false) places.

(** Does [l] list each of [m], whose elements differ, once? *)
Definition rearranged (l m : list nat) : bool :=
  (length l =? length m) && forallb (fun i => existsb (Nat.eqb i) l) m.
Lemma rearranged_ok l a n : rearranged l (seq a n) = true -> Permutation (seq a n) l.
Proof.
  unfold rearranged. rewrite andb_true_iff, Nat.eqb_eq, forallb_forall. intros [L F].
  apply NoDup_Permutation_bis; [apply seq_NoDup|lia|]. intros i I. apply F, existsb_exists in I as (j & J & E).
  apply Nat.eqb_eq in E as ->. exact J.
Qed.

Lemma nth_all {A} (l : list A) d : map (fun n => nth n l d) (seq 0 (length l)) = l.
Proof.
  apply nth_ext with d d; [now rewrite map_length, seq_length|]. intros n H. rewrite map_length, seq_length in H.
  exact (nth_map_seq (fun n => nth n l d) _ n d H).
Qed.

Lemma filter_perm {A} (f : A -> bool) l m : Permutation l m -> Permutation (filter f l) (filter f m).
Proof.
  intros P. induction P as [|x l m _ IH|x y l|l m n _ IH _ JH]; simpl; auto.
  - destruct (f x); auto. - destruct (f x), (f y); auto using perm_swap. - now transitivity (filter f m).
Qed.
Lemma filter_map {A B} (f : B -> bool) (g : A -> B) l : filter f (map g l) = map g (filter (fun a => f (g a)) l).
Proof. induction l as [|a l IH]; simpl; [reflexivity|]. destruct (f (g a)); simpl; now rewrite IH. Qed.

Lemma solids_taken places c : Permutation (seq 0 (length c)) places -> solids (taken places c) = solids c.
Proof.
  intros P. unfold solids. apply Permutation_length, filter_perm. unfold taken.
  transitivity (map (fun n => nth n c false) (seq 0 (length c))).
  - apply Permutation_map. now symmetry. - now rewrite nth_all.
Qed.

Lemma seq_shift_by m a n : seq (a + m) n = map (fun t => t + m) (seq a n).
Proof. revert a. induction n as [|n IH]; intros a; simpl; [reflexivity|]. f_equal. apply (IH (S a)). Qed.

(** The solid edges among those with the numbers [ns]. *)
Lemma solid_map (h : edge -> edge) es : forall c, map h (solid es c) = solid (map h es) c.
Proof. induction es as [|e es IH]; intros [|[|] c]; simpl; auto. now rewrite IH. Qed.
Lemma solid_of_map (h : nat -> edge) (b : nat -> bool) ns : solid (map h ns) (map b ns) = map h (filter b ns).
Proof. induction ns as [|n ns IH]; simpl; [reflexivity|]. destruct (b n); simpl; now rewrite IH. Qed.

Lemma port_edges_length d : length (port_edges d) = length (owner d).
Proof. unfold port_edges, edge. rewrite combine_length, seq_length, map_length. lia. Qed.
Lemma inner_edges_length d : length (inner_edges d) = length (inner d).
Proof. apply map_length. Qed.

Section Image.
  (** Vertex v goes to place v of a list, and stays beyond its end. *)
  Variable names : list nat.
  Definition goes_to (v : nat) : nat := nth v names v.
  Definition permutes : bool := rearranged names (seq 0 (length names)).

  Lemma goes_to_injective : permutes = true -> forall u v, goes_to u = goes_to v -> u = v.
  Proof.
    intros P u v. apply rearranged_ok in P. unfold goes_to.
    assert (N : NoDup names) by (eapply Permutation_NoDup; [exact P|apply seq_NoDup]).
    assert (B : forall w, w < length names -> nth w names w < length names).
    { intros w H. assert (I : In (nth w names w) (seq 0 (length names))).
      { eapply Permutation_in; [symmetry; exact P|now apply nth_In]. }
      apply in_seq in I. lia. }
    destruct (lt_dec u (length names)) as [Hu|Hu], (lt_dec v (length names)) as [Hv|Hv].
    - rewrite (nth_indep names v u) by exact Hv. now apply NoDup_nth.
    - rewrite (nth_overflow names v) by lia. specialize (B u Hu). lia.
    - rewrite (nth_overflow names u) by lia. specialize (B v Hv). lia.
    - rewrite !nth_overflow by lia. auto.
  Qed.

  (** The place from which each of the edges [es'] comes. *)
  Definition places (es es' : list edge) : list nat :=
    map (fun e => match place e (map (moved goes_to) es) with Some n => n | None => 0 end) es'.
  Fixpoint same_edges (es es' : list edge) : bool :=
    match es, es' with
    | [], [] => true
    | e :: r, f :: r' => (fst (undirected e) =? fst (undirected f)) && (snd (undirected e) =? snd (undirected f)) && same_edges r r'
    | _, _ => false
    end.
  Definition edges_ok (es es' : list edge) : bool :=
    rearranged (places es es') (seq 0 (length es)) &&
    same_edges (map (fun n => moved goes_to (nth n es (0, 0))) (places es es')) es'.

  Lemma same_edges_ok es : forall es', same_edges es es' = true -> map undirected es = map undirected es'.
  Proof.
    induction es as [|e es IH]; intros [|f es']; simpl; try discriminate; [reflexivity|].
    rewrite !andb_true_iff, !Nat.eqb_eq. intros [[A B] C]. rewrite (IH _ C). f_equal. unfold undirected in *. simpl in *. congruence.
  Qed.

  Lemma solid_image es es' c : edges_ok es es' = true -> length c = length es ->
    renamed goes_to (solid es c) (solid es' (taken (places es es') c)).
  Proof.
    unfold edges_ok. rewrite andb_true_iff. intros [P E] L. apply rearranged_ok in P. apply same_edges_ok in E.
    unfold renamed. rewrite (solid_map undirected es'), <- E, (map_map _ _ (places es es')). unfold taken.
    rewrite (solid_of_map (fun n => undirected (moved goes_to (nth n es (0, 0)))) (fun n => nth n c false)).
    assert (S : solid es c = map (fun n => nth n es (0, 0)) (filter (fun n => nth n c false) (seq 0 (length es)))).
    { rewrite <- (solid_of_map (fun n => nth n es (0, 0)) (fun n => nth n c false)), nth_all, <- L. now rewrite nth_all. }
    rewrite S, !map_map.
    now apply Permutation_map, filter_perm.
  Qed.
  Lemma solids_image es es' c : edges_ok es es' = true -> length c = length es -> solids (taken (places es es') c) = solids c.
  Proof.
    unfold edges_ok. rewrite andb_true_iff. intros [P _] L. apply rearranged_ok in P. rewrite <- L in P. now apply solids_taken.
  Qed.

  (** ** Positions

      The names take the patch [q] to the patch [p]. *)
  Variables q p : patch.
  Let k := ports q.
  Definition image_port : coloring -> coloring := taken (places (port_edges (before q)) (port_edges (before p))).
  Definition inner_places (d e : side) : list nat := places (inner_edges d) (inner_edges e).

  Definition side_ok (d e : side) : bool :=
    well_formed_side q d && (length (owner e) =? k) && (triangles e =? triangles d) &&
    edges_ok (port_edges d) (port_edges e) &&
    same_labels (places (port_edges d) (port_edges e)) (places (port_edges (before q)) (port_edges (before p))) &&
    edges_ok (inner_edges d) (inner_edges e) &&
    rearranged (map goes_to (seq k (triangles d))) (seq k (triangles d)).
  Definition positions_ok : bool :=
    permutes && rearranged (map goes_to (seq 0 k)) (seq 0 k) && side_ok (before q) (before p) && side_ok (after q) (after p).

  Lemma drawing_image d e s x : side_ok d e = true -> length s = k -> length x = length (inner d) ->
    renamed goes_to (drawing d s x) (drawing e (image_port s) (taken (inner_places d e) x)).
  Proof.
    unfold side_ok, well_formed_side. rewrite !andb_true_iff, !Nat.eqb_eq. intros [[[[[[[[W _] _] _] _] Op] E] Oi] _] Ls Lx.
    unfold renamed, drawing, image_port, inner_places. rewrite !map_app. apply same_labels_eq in E. rewrite <- E.
    apply Permutation_app.
    - apply solid_image; [exact Op|]. rewrite port_edges_length. unfold k in Ls. lia.
    - apply solid_image; [exact Oi|]. unfold inner_edges. now rewrite map_length.
  Qed.
  Lemma solids_inner d e x : side_ok d e = true -> length x = length (inner d) -> solids (taken (inner_places d e) x) = solids x.
  Proof.
    unfold side_ok. rewrite !andb_true_iff. intros [[_ Oi] _] Lx. apply solids_image; [exact Oi|].
    unfold inner_edges. now rewrite map_length.
  Qed.
  Lemma length_inner d e x : side_ok d e = true -> length (taken (inner_places d e) x) = length (inner e).
  Proof. intros _. unfold taken, inner_places, places, inner_edges. now rewrite !map_length. Qed.

  Lemma isolated_image d e s x : permutes = true -> side_ok d e = true -> length s = k -> length x = length (inner d) ->
    isolated e (image_port s) (taken (inner_places d e) x) = isolated d s x.
  Proof.
    intros P Q Ls Lx. pose proof (drawing_image d e s x Q Ls Lx) as R.
    unfold side_ok, well_formed_side in Q. rewrite !andb_true_iff, !Nat.eqb_eq in Q.
    destruct Q as [[[[[[[[W _] _] We] T] _] _] _] M]. apply rearranged_ok in M.
    assert (I : forall d' s' x', length (owner d') = k ->
      isolated d' s' x' = length (filter (fun v => degree (drawing d' s' x') v =? 0) (seq k (triangles d')))).
    { intros d' s' x' L. unfold isolated. rewrite L. generalize (triangles d'). intros n.
      transitivity (length (filter (fun v => degree (drawing d' s' x') v =? 0) (map (fun t => k + t) (seq 0 n)))).
      - now rewrite filter_map, map_length.
      - now rewrite (map_ext _ (fun t => t + k) (Nat.add_comm k)), <- (seq_shift_by k 0 n). }
    rewrite !I by assumption. rewrite T.
    transitivity (length (filter (fun v => degree (drawing e (image_port s) (taken (inner_places d e) x)) v =? 0)
      (map goes_to (seq k (triangles d))))); [now apply Permutation_length, filter_perm|].
    rewrite filter_map, map_length. f_equal. apply filter_ext. intros v.
    now rewrite (renamed_degree goes_to (goes_to_injective P) _ _ v R).
  Qed.

  (** ** Tables

      [T] is the table of [p], [U] the table of [q]. *)
  Definition image_before : coloring -> coloring := taken (inner_places (before q) (before p)).
  Definition image_after : coloring -> coloring := taken (inner_places (after q) (after p)).
  Definition image_answer (s c x y : coloring) : Prop :=
    y = image_after x \/
    (legal q s c x /\ solids x = solids y /\ isolated (after q) s x = isolated (after p) (image_port s) y).
  Definition image_table (T U : table) : Prop :=
    forall s c, length s = k -> length c = length (inner (before q)) ->
      match U s c with
      | Some x => length x = length (inner (after q)) /\
                  exists y, T (image_port s) (image_before c) = Some y /\ image_answer s c x y
      | None => T (image_port s) (image_before c) = None
      end.

  Section Carried.
    Hypothesis ok : positions_ok = true.
    Let P : permutes = true.
    Proof. unfold positions_ok in ok. rewrite !andb_true_iff in ok. tauto. Qed.
    Let Before : side_ok (before q) (before p) = true.
    Proof. unfold positions_ok in ok. rewrite !andb_true_iff in ok. tauto. Qed.
    Let After : side_ok (after q) (after p) = true.
    Proof. unfold positions_ok in ok. rewrite !andb_true_iff in ok. tauto. Qed.
    Let ports_p : ports p = k.
    Proof. unfold side_ok in Before. rewrite !andb_true_iff, !Nat.eqb_eq in Before. unfold ports at 1. tauto. Qed.
    Let length_port s : length (image_port s) = ports p.
    Proof. unfold image_port, taken, places. now rewrite !map_length, port_edges_length. Qed.
    Let length_before c : length (image_before c) = length (inner (before p)).
    Proof. apply (length_inner _ _ _ Before). Qed.
    Let length_after x : length (image_after x) = length (inner (after p)).
    Proof. apply (length_inner _ _ _ After). Qed.

    Lemma port_to i : i < k -> goes_to i < k.
    Proof.
      unfold positions_ok in ok. rewrite !andb_true_iff in ok. destruct ok as [[[_ R] _] _]. apply rearranged_ok in R.
      intros H. assert (I : In (goes_to i) (seq 0 k)).
      { eapply Permutation_in; [symmetry; exact R|]. apply in_map, in_seq. lia. }
      apply in_seq in I. lia.
    Qed.
    Lemma port_from i : i < k -> exists j, j < k /\ goes_to j = i.
    Proof.
      unfold positions_ok in ok. rewrite !andb_true_iff in ok. destruct ok as [[[_ R] _] _]. apply rearranged_ok in R.
      intros H. assert (I : In i (map goes_to (seq 0 k))) by (eapply Permutation_in; [exact R|apply in_seq; lia]).
      apply in_map_iff in I as (j & E & I). apply in_seq in I. exists j. split; [lia|exact E].
    Qed.

    Lemma legal_image s c x : length s = k -> length c = length (inner (before q)) -> length x = length (inner (after q)) ->
      (legal p (image_port s) (image_before c) (image_after x) <-> legal q s c x).
    Proof.
      intros Ls Lc Lx. pose proof (drawing_image _ _ s c Before Ls Lc) as R0. pose proof (drawing_image _ _ s x After Ls Lx) as R1.
      change (taken _ c) with (image_before c) in R0. change (taken _ x) with (image_after x) in R1.
      pose proof (goes_to_injective P) as J. unfold legal, sound.
      rewrite (renamed_valid _ J _ _ R1), ports_p. split; intros (_ & V & L).
      - split; [exact Lx|]. split; [exact V|]. intros i j Hi Hj.
        rewrite <- (renamed_linked _ J _ _ i j R1), <- (renamed_linked _ J _ _ i j R0). apply L; now apply port_to.
      - split; [apply length_after|]. split; [exact V|]. intros i' j' Hi Hj.
        apply port_from in Hi as (i & Hi & <-). apply port_from in Hj as (j & Hj & <-).
        rewrite (renamed_linked _ J _ _ i j R1), (renamed_linked _ J _ _ i j R0). now apply L.
    Qed.

    Lemma valid_image s c : length s = k -> length c = length (inner (before q)) ->
      (valid (drawing (before p) (image_port s) (image_before c)) <-> valid (drawing (before q) s c)).
    Proof. intros Ls Lc. exact (renamed_valid _ (goes_to_injective P) _ _ (drawing_image _ _ s c Before Ls Lc)). Qed.

    Lemma score_image s x : length s = k -> length x = length (inner (after q)) ->
      solids (image_after x) = solids x /\ isolated (after p) (image_port s) (image_after x) = isolated (after q) s x.
    Proof. intros Ls Lx. split; [now apply solids_inner|now apply isolated_image]. Qed.

    Lemma same_score s c x y : length s = k -> length x = length (inner (after q)) -> image_answer s c x y ->
      solids x = solids y /\ isolated (after q) s x = isolated (after p) (image_port s) y.
    Proof.
      intros Ls Lx [->|(_ & S & I)]; [|now split]. destruct (score_image s x Ls Lx) as [S I]. now split.
    Qed.

    Theorem carried_correct T U : image_table T U -> correct p T -> correct q U.
    Proof.
      intros I C s c Ls Lc. specialize (I s c Ls Lc).
      specialize (C (image_port s) (image_before c) (length_port s) (length_before c)). rewrite valid_image in C by assumption.
      destruct C as [V N]. destruct (U s c) as [x|].
      - destruct I as (Lx & y & E & A). rewrite E in *. split; [|intros H; apply N in H; discriminate].
        intros H. destruct (V H) as (y' & Q & L & B). injection Q as <-. exists x. split; [reflexivity|].
        destruct (same_score s c x y Ls Lx A) as [Sx Ix]. split.
        { destruct A as [->|[A _]]; [now apply legal_image in L|exact A]. }
        intros z M. pose proof M as (Lz & _). apply (legal_image s c z) in M; [|assumption..]. apply B in M.
        destruct (score_image s z Ls Lz) as [Sz Iz]. unfold as_good in *. now rewrite Sx, Ix, <- Sz, <- Iz.
      - rewrite I in V. split; [|reflexivity]. intros H. destruct (V H) as (x & Q & _). discriminate.
    Qed.

    Theorem carried_within T U strips lonely : image_table T U -> within p T strips lonely -> within q U strips lonely.
    Proof.
      intros I W s c x Ls Lc E. specialize (I s c Ls Lc). rewrite E in I. destruct I as (Lx & y & F & A).
      destruct (same_score s c x y Ls Lx A) as [Sx Ix].
      destruct (W _ _ _ (length_port s) (length_before c) F) as [S L].
      assert (T0 : triangles (before p) = triangles (before q)).
      { unfold side_ok in Before. rewrite !andb_true_iff, !Nat.eqb_eq in Before. tauto. }
      assert (T1 : triangles (after p) = triangles (after q)).
      { unfold side_ok in After. rewrite !andb_true_iff, !Nat.eqb_eq in After. tauto. }
      unfold image_before in *. rewrite (isolated_image _ _ s _ P Before) in L by assumption.
      rewrite (solids_inner _ _ _ Before), T0, T1 in S by assumption. rewrite Sx, Ix. now split.
    Qed.
  End Carried.
End Image.

(** ** The comparison *)
Fixpoint each (n : nat) (t : trie) (key : coloring) (test : coloring -> coloring -> bool) : bool :=
  match t, n with
  | Nothing, _ => true
  | Answer x, 0 => test (rev key) x
  | Fork d s, S m => each m d (false :: key) test && each m s (true :: key) test
  | _, _ => false
  end.
Lemma each_ok n : forall t key test, each n t key test = true ->
  forall r x, length r = n -> find t r = Some x -> test (rev key ++ r) x = true.
Proof.
  induction n as [|n IH]; intros [|x|d s] key test E [|b r] y L F; simpl in *; try discriminate.
  - injection F as <-. now rewrite app_nil_r.
  - assert (N : forall c, find Nothing c = None) by (induction c; auto). now rewrite N in F.
  - apply andb_prop in E as [Ed Es]. injection L as L. rewrite (app_assoc (rev key) [b] r : rev key ++ b :: r = _).
    destruct b; [exact (IH s (true :: key) test Es r y L F)|exact (IH d (false :: key) test Ed r y L F)].
Qed.

Fixpoint index (i : nat) (l : list nat) : nat :=
  match l with [] => 0 | j :: r => if i =? j then 0 else S (index i r) end.

Lemma correct_safe p T : sensible p (before p) -> sensible p (after p) -> correct p T -> safe p T.
Proof.
  intros S0 S1 C s c x O Ls Lc E R V. destruct (C s c Ls Lc) as [H _].
  destruct (H (valid_suffix _ _ V)) as (y & F & [L _]). rewrite E in F. injection F as <-.
  now apply (legal_is_safe p S0 S1 s c).
Qed.

Section Compare.
  Variables (names : list nat) (q p : patch) (T U : trie).
  Let k := ports q.
  Let width := k + length (inner (before q)).
  (** From where the image of a key takes its bits, and the way back. *)
  Definition key_places : list nat :=
    places names (port_edges (before q)) (port_edges (before p)) ++
    map (fun n => k + n) (inner_places names (before q) (before p)).
  Definition key_back : list nat := map (fun i => index i key_places) (seq 0 width).

  Definition legal_by_drawing (s c x : coloring) : bool :=
    match drawn (before q) s c with Some st => legalb q (labels k st) s x | None => false end.

  Definition compare : bool :=
    let there := key_places in
    let back := key_back in
    let answers := inner_places names (after q) (after p) in
    let port := taken (places names (port_edges (before q)) (port_edges (before p))) in
    positions_ok names q p &&
    forallb (fun n => n <? k) (places names (port_edges (before q)) (port_edges (before p))) &&
    same_labels (map (fun i => nth i there width) back) (seq 0 width) &&
    each width U [] (fun key x => (length x =? length (inner (after q))) &&
      match find T (taken there key) with
      | Some y =>
          let s := firstn k key in
          if same_coloring y (taken answers x) then true
          else legal_by_drawing s (skipn k key) x && (solids x =? solids y) &&
               (isolated (after q) s x =? isolated (after p) (port s) y)
      | None => false
      end) &&
    each width T [] (fun key _ => match find U (taken back key) with Some _ => true | None => false end).

  Lemma key_image s c : forallb (fun n => n <? k) (places names (port_edges (before q)) (port_edges (before p))) = true ->
    length s = k -> taken key_places (s ++ c) = image_port names q p s ++ image_before names q p c.
  Proof.
    intros B L. unfold key_places, taken. rewrite map_app. f_equal.
    - apply map_ext_in. intros n I. rewrite forallb_forall in B. apply app_nth1. rewrite L. now apply Nat.ltb_lt, B.
    - rewrite map_map. apply map_ext. intros n. rewrite <- L. rewrite app_nth2 by lia. f_equal. lia.
  Qed.

  Lemma taken_back key : same_labels (map (fun i => nth i key_places width) key_back) (seq 0 width) = true ->
    length key = width -> taken key_back (taken key_places key) = key.
  Proof.
    intros E L. apply same_labels_eq in E. unfold taken.
    transitivity (map (fun n => nth n key false) (map (fun i => nth i key_places width) key_back)).
    - rewrite map_map. apply map_ext. intros i. rewrite <- (map_nth (fun n => nth n key false)).
      now rewrite (nth_overflow key false (n := width)) by lia.
    - rewrite E, <- L. apply nth_all.
  Qed.

  Theorem compare_ok : compare = true -> positions_ok names q p = true /\ image_table names q p (lookup T) (lookup U) /\
    sensible q (before q) /\ sensible q (after q).
  Proof.
    unfold compare. rewrite !andb_true_iff. intros [[[[Ok B] R] EU] ET]. split; [exact Ok|].
    pose proof Ok as Ok'. unfold positions_ok, side_ok in Ok'. rewrite !andb_true_iff, !Nat.eqb_eq in Ok'.
    assert (W : well_formed_side q (before q) = true /\ well_formed_side q (after q) = true) by tauto. destruct W as [W0 W1].
    split; [|split; now apply well_formed_sensible].
    intros s c Ls Lc. unfold lookup.
    assert (Lk : length (s ++ c) = width) by (rewrite app_length; unfold width, k; lia).
    pose proof (each_ok _ _ _ _ EU (s ++ c)) as HU. destruct (find U (s ++ c)) as [x|] eqn:F.
    - specialize (HU x Lk eq_refl). simpl in HU. apply andb_prop in HU as [Lx HU]. split; [now apply Nat.eqb_eq|].
      rewrite (key_image s c B Ls) in HU. destruct (find T _) as [y|]; [|discriminate]. exists y. split; [reflexivity|].
      destruct (same_coloring y _) eqn:Q; [left; now apply same_coloring_eq|right].
      assert (K : k = length s) by (symmetry; exact Ls).
      rewrite K, firstn_app, Nat.sub_diag, firstn_all, skipn_app, Nat.sub_diag, skipn_all in HU. simpl in HU.
      rewrite app_nil_r in HU. rewrite !andb_true_iff, !Nat.eqb_eq in HU. destruct HU as [[L S] A].
      split; [|split; assumption]. unfold legal_by_drawing in L.
      pose proof (drawn_ok q (before q) s c W0) as D. destruct (drawn (before q) s c) as [st|]; [|discriminate].
      destruct D as [D _]. now apply (legalb_ok q s c x st W0 W1 D).
    - clear HU. rewrite <- (key_image s c B Ls).
      destruct (find T (taken key_places (s ++ c))) as [y|] eqn:G; [|reflexivity]. exfalso.
      pose proof (each_ok _ _ _ _ ET (taken key_places (s ++ c)) y) as HT. simpl in HT.
      rewrite (taken_back _ R Lk), F in HT. assert (false = true); [|discriminate]. apply HT; [|exact G].
      unfold taken, key_places, inner_places, places. rewrite map_length, app_length, !map_length, port_edges_length.
      assert (Li : length (inner (before p)) = length (inner (before q))).
      { destruct Ok' as [[_ [[_ Oi] _]] _]. unfold edges_ok, rearranged, places in Oi.
        rewrite !andb_true_iff, Nat.eqb_eq, !map_length, seq_length in Oi. unfold inner_edges in Oi.
        rewrite !map_length in Oi. tauto. }
      rewrite inner_edges_length, Li. unfold width, k. f_equal. tauto.
  Qed.
End Compare.

(** ** What one comparison proves

    For positions that the checker has not seen, [holds] is what [proved] of [Rows.v] is for those that it has, but for
    the certificates, which have rows for half of the positions only. *)
Definition holds (p : patch) (strips lonely : nat) (t : trie) : Prop :=
  correct p (lookup t) /\ safe p (lookup t) /\ within p (lookup t) strips lonely.

Theorem compare_holds names q p strips lonely T U : compare names q p T U = true ->
  holds p strips lonely T -> holds q strips lonely U.
Proof.
  intros E (C & _ & W). apply compare_ok in E as (Ok & I & S0 & S1).
  pose proof (carried_correct _ _ _ Ok _ _ I C) as D. split; [exact D|]. split.
  - exact (correct_safe q _ S0 S1 D).
  - exact (carried_within _ _ _ Ok _ _ _ _ I W).
Qed.
Lemma check_holds p strips lonely also full : check p strips lonely also full = true -> holds p strips lonely full.
Proof.
  intros C. split; [|split].
  - exact (check_correct _ _ _ _ _ C).
  - exact (check_safe _ _ _ _ _ C).
  - exact (check_within _ _ _ _ _ C).
Qed.

(** A turn that takes t_a of a closed fan to t_0, and A to D. Vertices are numbered as in [Statements.v]: ports, fan, inserted
    triangles. *)
Definition turned (k a : nat) : list nat :=
  let f t := (t + (k - a)) mod k in map f (seq 0 k) ++ map (fun t => k + f t) (seq 0 k) ++ [k + (k + 1); k + k].
