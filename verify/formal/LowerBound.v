(** * A lower bound for every rule that reads only its patch

    The fan has k = 4 triangles and is split at a = 2. Before the split its strip enters by port p_3, runs through t_3, t_2, t_1,
    t_0 and leaves by port p_0: loop 0111, ports 1001. Every recolouring that keeps the ports and is sound in every
    outside has at most four solid edges, one less than would keep the number of strips.

    From this fan and one triangle more a *block* is made, and of n blocks a mesh that is one strip. After a split in
    each block, all by rules of that kind, it has at least n + 1 strips. And yet it could be one strip still. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Locality Strips Drawing Checker Rows.
Import Blocks.

(** ** One patch *)
Definition pays (x : coloring) : bool :=
  match drawn (before (split 4 2)) the_ports the_loop with
  | Some st => negb (legalb (split 4 2) (labels 4 st) the_ports x) || (solids x <=? 4)
  | None => false
  end.
Lemma all_pay : forallb pays (all_colorings 7) = true.
Proof. vm_compute. reflexivity. Qed.

Theorem legal_pays x : legal (split 4 2) the_ports the_loop x -> solids x <= 4.
Proof.
  intros L. pose proof all_pay as A. rewrite forallb_forall in A. pose proof L as [Lx _].
  specialize (A x (proj2 (all_colorings_ok 7 x) Lx)). unfold pays in A.
  pose proof (drawn_ok (split 4 2) (before (split 4 2)) the_ports the_loop eq_refl) as D.
  destruct (drawn _ _ _) as [st|]; [|discriminate]. destruct D as [D _].
  apply (legalb_ok (split 4 2) the_ports the_loop x st eq_refl eq_refl D) in L.
  change (ports (split 4 2)) with 4 in L. rewrite L in A. simpl negb in A. now apply Nat.leb_le.
Qed.

(** A rule that reads only its patch is a function of the colours of the patch. If it keeps every mesh valid, it pays. *)
Lemma legal_of_safe (T : table) x : safe (split 4 2) T -> length x = 7 -> T the_ports the_loop = Some x ->
  legal (split 4 2) the_ports the_loop x.
Proof.
  intros S Lx E. apply (locality (split 4 2)); [now apply (well_formed_sensible (split 4 2))..|exact Lx| |].
  - pose proof (drawn_ok (split 4 2) (before (split 4 2)) the_ports the_loop eq_refl) as D. exact (proj2 D).
  - intros O R V. exact (S the_ports the_loop x O eq_refl eq_refl E R V).
Qed.
Theorem every_rule_pays : Every_rule_pays.
Proof.
  intros T x S Lx E. pose proof (legal_pays x (legal_of_safe T x S Lx E)) as L. change (6 + 3 >= 4 + solids x + 1). lia.
Qed.

(** ** A mesh of n blocks *)
Definition walk_from (order : list nat) (m n : nat) : list nat := flat_map (fun m => map (fun t => 7 * m + t) order) (seq m n).

Lemma path_from order m n : hd 6 order = 0 -> last order 0 = 6 ->
  path_edges (walk_from order m (S n)) =
  path_edges (map (fun t => 7 * m + t) order) ++
  match n with 0 => [] | S _ => port_0 (S m) ++ path_edges (walk_from order (S m) n) end.
Proof.
  intros H L. unfold walk_from. destruct n as [|n]; [simpl; now rewrite !app_nil_r|].
  destruct order as [|z o]; [discriminate|]. simpl in H. subst z.
  assert (E : exists l, map (fun t => 7 * m + t) (0 :: o) = l ++ [7 * m + 6]).
  { exists (map (fun t => 7 * m + t) (removelast (0 :: o))).
    assert (Q : 0 :: o = removelast (0 :: o) ++ [last (0 :: o) 0]) by (apply app_removelast_last; discriminate).
    rewrite L in Q. rewrite Q at 1. now rewrite map_app. }
  assert (F : exists r, flat_map (fun m => map (fun t => 7 * m + t) (0 :: o)) (seq (S m) (S n)) = 7 * S m + 0 :: r)
    by (eexists; reflexivity).
  destruct E as (l & E), F as (r & F). change (seq m (S (S n))) with (m :: seq (S m) (S n)). cbn [flat_map].
  rewrite E. change (flat_map _ (seq (S m) (S n))) with (flat_map (fun m => map (fun t => 7 * m + t) (0 :: o)) (seq (S m) (S n))).
  rewrite F, <- app_assoc. apply path_edges_app.
Qed.

Lemma permutes_with (l : list nat) order n : Permutation order l ->
  Permutation (walk_from order 0 n) (flat_map (fun m => map (fun t => 7 * m + t) l) (seq 0 n)).
Proof.
  intros P. unfold walk_from. induction (seq 0 n) as [|b bs IH]; simpl; [constructor|].
  apply Permutation_app; [now apply Permutation_map|exact IH].
Qed.

(** Before: one strip. *)
Lemma solid_before m n : Permutation (port_0 m ++ path_edges (walk_from [0; 1; 2; 3; 6] m (S n)))
  (solid_from before_splits m (repeat the_loop (S n))).
Proof.
  revert m. induction n as [|n IH]; intros m; rewrite path_from by reflexivity.
  - simpl repeat. cbn [solid_from]. rewrite !app_nil_r.
    change (path_edges (map (fun t => 7 * m + t) [0; 1; 2; 3; 6])) with
      (map (in_block m) (solid (inner before_splits) the_loop) ++ port_3 m).
    rewrite !app_assoc. apply Permutation_app_tail, Permutation_app_comm.
  - change (repeat the_loop (S (S n))) with (the_loop :: repeat the_loop (S n)). cbn [solid_from].
    rewrite <- (IH (S m)).
    change (path_edges (map (fun t => 7 * m + t) [0; 1; 2; 3; 6])) with
      (map (in_block m) (solid (inner before_splits) the_loop) ++ port_3 m).
    rewrite !app_assoc. do 3 apply Permutation_app_tail. apply Permutation_app_comm.
Qed.

Theorem one_strip_before : One_strip_before.
Proof.
  intros n H. exists (walk_from [0; 1; 2; 3; 6] 0 n). destruct n as [|n]; [lia|]. split; [|split].
  - intros [E|[]]. discriminate.
  - cbn [concat]. rewrite app_nil_r. now apply permutes_with.
  - cbn [map concat]. rewrite app_nil_r. apply Permutation_map. exact (solid_before 0 n).
Qed.

(** After: whatever legal recolourings the blocks get, n solid edges are missing. *)
Lemma few_solid xs : Forall (legal (split 4 2) the_ports the_loop) xs ->
  forall m, length (solid_from after_splits m xs) <= 6 * length xs - (if m =? 0 then 1 else 0).
Proof.
  intros F. induction F as [|x xs L F IH]; intros m; [simpl; lia|]. cbn [solid_from].
  pose proof L as [Lx _]. apply legal_pays in L.
  assert (Q : length (solid (inner after_splits) x) = solids x).
  { clear - Lx. unfold solids. change (inner (after (split 4 2))) with (inner after_splits) in Lx.
    revert x Lx. induction (inner after_splits) as [|e es IH]; intros [|[|] x] Lx; try discriminate; simpl; auto. }
  rewrite !app_length, map_length, Q. specialize (IH (S m)). simpl Nat.eqb in IH. simpl length.
  destruct m; simpl Nat.eqb; simpl length; cbv iota; lia.
Qed.

Theorem many_strips_after n xs : 0 < n -> length xs = n -> Forall (legal (split 4 2) the_ports the_loop) xs ->
  n + 1 + length (solid_edges after_splits xs) <= length (all_triangles after_splits n).
Proof.
  intros H L F. pose proof (few_solid xs F 0) as S. simpl Nat.eqb in S. cbv iota in S. unfold solid_edges.
  assert (T : forall a, length (flat_map (fun m => map (fun t => 7 * m + t) (seq 0 6 ++ [6])) (seq a n)) = 7 * n).
  { clear. induction n as [|n IH]; intros a; [reflexivity|]. cbn [seq flat_map]. rewrite app_length, IH, map_length. simpl. lia. }
  unfold all_triangles. change (triangles after_splits) with 6. rewrite T. lia.
Qed.

(** And yet one strip would do: t_0 t_1 D A t_3 t_2 w in each block. *)
Lemma undirected_block m G : map undirected (map (in_block m) G) = map (in_block m) (map undirected G).
Proof.
  rewrite !map_map. apply map_ext. intros [a b]. unfold undirected, in_block. cbn [fst snd]. f_equal; lia.
Qed.
Lemma detour_inside m : incl (map undirected (path_edges (map (fun t => 7 * m + t) [0; 1; 5; 4; 3; 2; 6])))
  (map undirected (map (in_block m) (inner after_splits) ++ port_0 m ++ port_3 m ++ port_2 m)).
Proof.
  change (path_edges (map (fun t => 7 * m + t) [0; 1; 5; 4; 3; 2; 6])) with
    (map (in_block m) [(0, 1); (1, 5); (5, 4); (4, 3); (3, 2); (2, 6)]).
  change (port_2 m) with (map (in_block m) [(2, 6)]). rewrite !map_app, !undirected_block. intros e I.
  assert (J : In e (map (in_block m) (map undirected (inner after_splits)) ++ map (in_block m) (map undirected [(2, 6)]))).
  { rewrite <- map_app. revert e I. apply incl_map. intros e I. vm_compute in I |- *. tauto. }
  rewrite !in_app_iff in *. tauto.
Qed.
Lemma detours_inside n : forall m, incl (map undirected (port_0 m ++ path_edges (walk_from [0; 1; 5; 4; 3; 2; 6] m (S n))))
  (map undirected
    (flat_map (fun m => map (in_block m) (inner after_splits) ++ port_0 m ++ port_3 m ++ port_2 m) (seq m (S n)))).
Proof.
  induction n as [|n IH]; intros m e; rewrite path_from by reflexivity; change (seq m (S ?n)) with (m :: seq (S m) n);
    cbn [flat_map]; rewrite !(map_app undirected), !in_app_iff; pose proof (detour_inside m e) as D;
    rewrite !(map_app undirected), !in_app_iff in D.
  - simpl (map undirected []). tauto.
  - specialize (IH (S m) e). rewrite !(map_app undirected), !in_app_iff in IH. tauto.
Qed.

Theorem one_strip_would_do : One_strip_would_do.
Proof.
  intros n H. exists (path_edges (walk_from [0; 1; 5; 4; 3; 2; 6] 0 n)). split.
  - destruct n as [|n]; [lia|]. exact (detours_inside n 0).
  - exists (walk_from [0; 1; 5; 4; 3; 2; 6] 0 n). split; [|split].
    + intros [E|[]]. destruct n; [lia|discriminate].
    + cbn [concat]. rewrite app_nil_r. apply permutes_with.
      change (seq 0 (triangles after_splits) ++ [6]) with [0; 1; 2; 3; 4; 5; 6].
      apply NoDup_Permutation_bis; [|simpl; lia|intros t J; simpl in *; tauto].
      repeat (apply NoDup_cons; [simpl; lia|]). apply NoDup_nil.
    + cbn [map concat]. now rewrite app_nil_r.
Qed.

(** The same of a rule, in strips: n disjoint copies, one strip before, at least n + 1 after. *)
Theorem no_rule_competes : No_rule_competes.
Proof.
  intros n T x strips H S Lx E St. apply number_of_strips in St.
  pose proof (many_strips_after n (repeat x n) H (repeat_length x n)) as M.
  assert (F : Forall (legal (split 4 2) the_ports the_loop) (repeat x n)).
  { apply Forall_forall. intros y I. apply repeat_spec in I as ->. now apply (legal_of_safe T). }
  specialize (M F). lia.
Qed.
