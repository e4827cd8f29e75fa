(** * Reduced tables: rules by key, copies by symmetry

    The rows of a certificate (docs/reference/certificate.md). A rule states its recolouring. Of a copy only the symmetry is
    kept; its recolouring is worked out here, from the rule that it is a copy of. *)
Require Import Arith Bool List NArith Lia.
Import ListNotations.
Require Import Statements Graph Locality Table Drawing Checker.

Inductive symmetry := Turn (n : nat) | Mirror (n : nat).
Inductive row := Rule (ports joined recoloring : N) | Copy (ports joined : N) (by_symmetry : symmetry).

(** Where a symmetry takes port i of a fan of k. *)
Definition image (k : nat) (g : symmetry) (i : nat) : nat :=
  match g with Turn n => (i + n) mod k | Mirror n => (n + k - i) mod k end.

(** Where it takes a mask of ports. *)
Definition image_ports (k : nat) (g : symmetry) (s : coloring) : coloring :=
  map (fun j => existsb (fun i => nth i s false && (image k g i =? j)) (seq 0 k)) (seq 0 k).

(** It acts on [joined] through the pairs that the mask stands for. *)
Definition image_joined (closed : bool) (k : nat) (g : symmetry) (s J : coloring) : coloring :=
  let s' := image_ports k g s in
  map (fun j => match preceding closed s' j with
                | None => false
                | Some j' =>
                    existsb (fun i => nth i J false &&
                      match preceding closed s i with
                      | None => false
                      | Some i' => (image k g i =? j) && (image k g i' =? j') || (image k g i =? j') && (image k g i' =? j)
                      end) (seq 0 k)
                end) (seq 0 k).

(** Where it takes an inner edge after. It may swap A and D; whether it does is seen from the edges. *)
Definition same_edge (e f : edge) : bool :=
  (fst e =? fst f) && (snd e =? snd f) || (fst e =? snd f) && (snd e =? fst f).
Fixpoint place (e : edge) (es : list edge) : option nat :=
  match es with
  | [] => None
  | f :: es' => if same_edge e f then Some 0 else option_map S (place e es')
  end.
Definition image_triangle (k : nat) (g : symmetry) (swap : bool) (t : nat) : nat :=
  if t <? k then image k g t else if swap then 2 * k + 1 - t else t.
Definition edge_places (d : side) (g : symmetry) (swap : bool) : list (option nat) :=
  let k := length (owner d) in
  map (fun e => place (image_triangle k g swap (fst e), image_triangle k g swap (snd e)) (inner d)) (inner d).
Definition known (o : option nat) : bool := match o with Some _ => true | None => false end.
Definition preimage_coloring (d : side) (g : symmetry) (x : coloring) : coloring :=
  let straight := edge_places d g false in
  let places := if forallb known straight then straight else edge_places d g true in
  map (fun o => match o with Some n => nth n x false | None => false end) places.

(** The reduced table: first the rules, then the copies, each looked up at the image of its key. *)
Fixpoint insert (key x : coloring) (t : trie) : trie :=
  match key with
  | [] => Answer x
  | b :: r => if b then Fork (branch false t) (insert r x (branch true t))
              else Fork (insert r x (branch false t)) (branch true t)
  end.
Definition insert_rule (k width : nat) (t : trie) (r : row) : trie :=
  match r with
  | Rule s J x => insert (coloring_of k s ++ coloring_of k J) (coloring_of width x) t
  | Copy _ _ _ => t
  end.
Definition insert_copy (closed : bool) (d : side) (rules t : trie) (r : row) : trie :=
  let k := length (owner d) in
  match r with
  | Rule _ _ _ => t
  | Copy s J g =>
      let s := coloring_of k s in let J := coloring_of k J in
      match find rules (image_ports k g s ++ image_joined closed k g s J) with
      | Some x => insert (s ++ J) (preimage_coloring d g x) t
      | None => t
      end
  end.
Definition reduced (closed : bool) (d : side) (rows : list row) : trie :=
  let rules := fold_left (insert_rule (length (owner d)) (length (inner d))) rows Nothing in
  fold_left (insert_copy closed d rules) rows rules.

(** ** The check *)
Definition joined_of (closed : bool) (s : coloring) (l : list nat) : coloring :=
  map (fun i => nth i s false &&
                match preceding closed s i with Some j => nth i l 0 =? nth j l 0 | None => false end)
    (seq 0 (length s)).
Definition agrees (closed : bool) (r : trie) (s : coloring) (l : list nat) (x : coloring) : bool :=
  match find r (s ++ joined_of closed s l) with Some y => same_coloring x y | None => false end.

Lemma preceding_bound closed s i j : i < length s -> preceding closed s i = Some j -> j < length s.
Proof.
  intros H F. apply find_some in F as [I _]. apply in_app_or in I as [I|I].
  - apply in_rev, in_seq in I. lia.
  - destruct closed; [apply in_rev, in_seq in I; lia|destruct I].
Qed.

Lemma nth_map_seq {A} (f : nat -> A) n i d : i < n -> nth i (map f (seq 0 n)) d = f i.
Proof.
  intros H. rewrite (nth_indep _ d (f 0)) by now rewrite map_length, seq_length.
  rewrite map_nth. now rewrite seq_nth.
Qed.

Lemma joined_of_ok p closed s c st : length s = ports p ->
  describes (size (before p)) st (drawing (before p) s c) ->
  joined p closed s c (joined_of closed s (labels (ports p) st)).
Proof.
  intros Ls (L & _ & K). assert (B : ports p <= length st) by (rewrite L; unfold size, ports; lia).
  unfold joined_of. split; [now rewrite map_length, seq_length|].
  intros i Hi. rewrite nth_map_seq, andb_true_iff by lia.
  assert (Q : forall j, preceding closed s i = Some j ->
    (linked (drawing (before p) s c) i j <-> nth i (labels (ports p) st) 0 = nth j (labels (ports p) st) 0)).
  { intros j P. apply preceding_bound in P; [|lia]. rewrite !labels_nth by lia. unfold size in *. symmetry.
    apply K; unfold ports in *; lia. }
  destruct (preceding closed s i) as [j|].
  - rewrite Nat.eqb_eq, <- (Q j eq_refl). split; intros [S H]; split; auto.
    + now exists j.
    + destruct H as (j' & F & H). injection F as ->. exact H.
  - split; [intros [_ F]|intros [_ (j & F & _)]]; discriminate.
Qed.

Theorem rows_ok p strips lonely closed r t : check p strips lonely (agrees closed r) t = true ->
  reduces_to p closed (lookup t) (lookup r).
Proof.
  intros C s c Ls Lc V. destruct (check_ok _ _ _ _ t C s c Ls Lc) as [H _].
  destruct (H V) as (x & E & _ & _ & _ & st & D & A). exists (joined_of closed s (labels (ports p) st)).
  split; [now apply joined_of_ok|]. rewrite E. unfold agrees in A. unfold lookup.
  destruct (find r _) as [y|]; [|discriminate]. now rewrite (same_coloring_eq _ _ A).
Qed.

(** ** All that one run of the checker proves *)
Lemma well_formed_sensible p d : well_formed_side p d = true -> sensible p d.
Proof.
  unfold well_formed_side, sensible. rewrite !andb_true_iff, !forallb_forall. intros [[L T] E]. split; [|split].
  - now apply Nat.eqb_eq.
  - intros t I. now apply Nat.ltb_lt, T.
  - intros e I. apply E, andb_prop in I as [A B]. now rewrite <- !Nat.ltb_lt.
Qed.

Theorem check_safe p strips lonely also t : check p strips lonely also t = true -> safe p (lookup t).
Proof.
  intros C s c x O Ls Lc E R V.
  assert (W : well_formed_side p (before p) = true /\ well_formed_side p (after p) = true).
  { unfold check in C. rewrite !andb_true_iff in C. tauto. }
  destruct W as [W0 W1]. pose proof (check_correct _ _ _ _ t C s c Ls Lc) as [H _].
  destruct (H (valid_suffix _ _ V)) as (y & F & [L _]). rewrite E in F. injection F as <-.
  now apply (legal_is_safe p (well_formed_sensible p _ W0) (well_formed_sensible p _ W1) s c).
Qed.

Definition proved (p : patch) (strips lonely : nat) (closed : bool) (full by_key : trie) : Prop :=
  correct p (lookup full) /\ safe p (lookup full) /\ within p (lookup full) strips lonely /\
  reduces_to p closed (lookup full) (lookup by_key).

Theorem check_proves p strips lonely closed full by_key :
  check p strips lonely (agrees closed by_key) full = true -> proved p strips lonely closed full by_key.
Proof.
  intros C. split; [|split; [|split]].
  - exact (check_correct _ _ _ _ _ C).
  - exact (check_safe _ _ _ _ _ C).
  - exact (check_within _ _ _ _ _ C).
  - exact (rows_ok _ _ _ _ _ _ C).
Qed.
