(** * An operation that is done

    [operation] speaks of a mesh, a patch and a table. Here it is met: a fan of three triangles, with two
    others, is split by the shipped rule; a strip comes into it from outside. *)
Require Import Arith Bool List Permutation ZArith Lia.
Import ListNotations.
Require Import Statements Table Strips Symmetry Sequences.
Require Split Shipped.

(** Vertices 0, 1, 2 are the points of the ports; 3, 4, 5 are the fan, 6 and 7 the two new triangles; 8 and 9 lie outside.
    The strips are 9, 8, 3, 4, which comes in at port 0, and 5 alone; afterwards 9, 8, 3, 6, 7, 4, 5. *)
Definition ports_met : coloring := [true; false; false].
Definition loop_met : coloring := [true; false; false].
Definition outside_met : graph := [(9, 8); (8, 0)].
Definition mesh_before : mesh := Mesh [3; 4; 5; 8; 9] [(8, 3); (9, 8); (3, 4)].
Definition answer_met : coloring :=
  match lookup (Split.full 3 1) ports_met loop_met with Some x => x | None => [] end.
Definition mesh_after : mesh :=
  Mesh [3; 4; 5; 6; 7; 8; 9] ((8, 3) :: (9, 8) :: solid (inner_edges (after (split 3 1))) answer_met).

Lemma found_met : answer_met = [true; false; true; true; false; true].
Proof. vm_compute. reflexivity. Qed.
Lemma second_last {A} (a b c : A) l : Permutation (a :: b :: c :: l) (b :: c :: a :: l).
Proof. eapply perm_trans; [apply perm_swap|]. constructor. apply perm_swap. Qed.

Lemma looks_met d c R : drawing d ports_met c = (0, 3) :: R -> (forall v, v <= 2 -> degree R v = 0) ->
  forall M, edges M = (8, 3) :: (9, 8) :: R -> Permutation (nodes M) (seq 3 (triangles d) ++ [8; 9]) ->
  looks_like (split 3 1) d ports_met c outside_met [8; 9] (fun v => v) M.
Proof.
  intros D Z M E P. exists ((8, 3) :: (9, 8) :: R). rewrite D. split; [|split].
  - change (seq 0 (ports (split 3 1))) with [0; 1; 2]. apply (through 0 [1; 2] 8 3 ((9, 8) :: R)).
    + apply Permutation_map. exact (second_last (9, 8) (8, 0) (0, 3) R).
    + discriminate.
    + discriminate.
    + exact (Z 0 (Nat.le_0_l 2)).
    + apply dashed; [exact (Z 1 (le_S 1 1 (le_n 1)))|]. apply dashed; [exact (Z 2 (le_n 2))|apply no_points].
  - unfold renamed. rewrite E. apply Permutation_map. rewrite (map_ext _ (fun e => e)) by now intros []. now rewrite map_id.
  - change (ports (split 3 1)) with 3. now rewrite map_id.
Qed.

Theorem operation_met : Operation_met Shipped.shipped.
Proof.
  exists mesh_before, mesh_after. split; [|split; [|split; [|split]]].
  - split; [repeat constructor; simpl; lia|]. intros v D. change (In v [3; 4; 5; 8; 9]).
    destruct (in_dec Nat.eq_dec v [3; 4; 5; 8; 9]) as [I|N]; [exact I|]. exfalso. apply D. simpl in N.
    unfold degree, meets. cbn [edges mesh_before map fst snd].
    repeat match goal with |- context [?a =? v] => destruct (Nat.eqb_spec a v); [subst; tauto|] end. reflexivity.
  - apply (valid_is_stripped (nodes mesh_before)).
    + repeat constructor; simpl; lia.
    + simpl. intros e I. intuition (subst; simpl; tauto).
    + exists [[9; 8; 3; 4]; [5]]. split; [|reflexivity]. split; [intros [E|[E|[]]]; discriminate|]. split.
      * apply NoDup_Permutation; [repeat constructor; simpl; lia|repeat constructor; simpl; lia|]. simpl. intros x. tauto.
      * apply perm_swap.
  - reflexivity.
  - exists ports_met, loop_met, answer_met, outside_met, [8; 9], (fun v => v). rewrite found_met.
    split; [easy|]. split; [reflexivity|]. split; [reflexivity|]. split; [vm_compute; reflexivity|]. split; [reflexivity|].
    split; [intros e [<-|[<-|[]]]; cbn; lia|]. split; [intros v [<-|[<-|[]]]; cbn; lia|]. split; [|split].
    + apply (looks_met _ _ [(3, 4)]); [reflexivity|intros [|[|[|]]] L; try reflexivity; lia|reflexivity|].
      apply Permutation_refl.
    + apply (looks_met _ _ [(6, 3); (7, 4); (4, 5); (6, 7)]); [reflexivity|intros [|[|[|]]] L; try reflexivity; lia|now unfold mesh_after; rewrite found_met|].
      apply Permutation_refl.
    + reflexivity.
  - unfold mesh_after. now rewrite found_met.
Qed.
