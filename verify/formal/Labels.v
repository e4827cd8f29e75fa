(** * Drawing with labels in binary

    [drawn] with the same books but for their labels, which are binary numbers: whether two are the same then takes a step
    for each bit, not one for each vertex below them. [restrip-check] draws with these, because it meets fans of any size. *)
Require Import Arith Bool List PArith Lia.
Import ListNotations.
Require Import Statements Drawing Checker.

Definition binary_state := list (nat * positive).
(** Label [l] of [drawn] is l + 1 here. *)
Definition unary (n : nat * positive) : nat * nat := (fst n, pred (Pos.to_nat (snd n))).
Definition books (st : binary_state) : state := map unary st.

Definition blank_labels (size : nat) : binary_state := map (fun v => (0, Pos.of_succ_nat v)) (seq 0 size).
Fixpoint count_edge (v : nat) (st : binary_state) : binary_state :=
  match st, v with
  | [], _ => []
  | (d, l) :: r, 0 => (S d, l) :: r
  | n :: r, S v' => n :: count_edge v' r
  end.
Definition replace (old new : positive) (st : binary_state) : binary_state :=
  map (fun n : nat * positive => if Pos.eqb (snd n) old then (fst n, new) else n) st.
Definition add_edge (e : edge) (st : binary_state) : option binary_state :=
  let (da, la) := nth (fst e) st (2, xH) in
  let (db, lb) := nth (snd e) st (2, xH) in
  if (da <? 2) && (db <? 2) && negb (Pos.eqb la lb)
  then Some (let st' := count_edge (fst e) (count_edge (snd e) st) in
             if Pos.ltb la lb then replace lb la st' else replace la lb st')
  else None.
Fixpoint add_edges (es : list edge) (c : coloring) (st : binary_state) : option binary_state :=
  match es, c with
  | e :: es', true :: c' => match add_edge e st with Some st' => add_edges es' c' st' | None => None end
  | _ :: es', false :: c' => add_edges es' c' st
  | _, _ => Some st
  end.
Definition drawn_with_labels (d : side) (s x : coloring) : option state :=
  match add_edges (port_edges d) s (blank_labels (size d)) with
  | Some st => option_map books (add_edges (inner_edges d) x st)
  | None => None
  end.

Lemma unary_eqb l m : Pos.eqb l m = (pred (Pos.to_nat l) =? pred (Pos.to_nat m)).
Proof.
  pose proof (Pos2Nat.is_pos l). pose proof (Pos2Nat.is_pos m).
  destruct (Pos.eqb_spec l m) as [->|N]; [now rewrite Nat.eqb_refl|]. symmetry. apply Nat.eqb_neq.
  intros E. apply N, Pos2Nat.inj. lia.
Qed.
Lemma unary_ltb l m : Pos.ltb l m = (pred (Pos.to_nat l) <? pred (Pos.to_nat m)).
Proof.
  pose proof (Pos2Nat.is_pos l). pose proof (Pos2Nat.is_pos m).
  destruct (Pos.ltb_spec l m) as [H1|H1]; symmetry; [apply Nat.ltb_lt; apply Pos2Nat.inj_lt in H1|apply Nat.ltb_ge; apply Pos2Nat.inj_le in H1]; lia.
Qed.
Lemma books_blank size : books (blank_labels size) = blank size.
Proof.
  unfold books, blank_labels, blank. rewrite map_map. apply map_ext. intros v. unfold unary. cbn [fst snd].
  now rewrite SuccNat2Pos.id_succ.
Qed.
Lemma books_bump v st : books (count_edge v st) = bump v (books st).
Proof. revert v. induction st as [|[d l] st IH]; intros [|v]; simpl; try reflexivity. now rewrite IH. Qed.
Lemma books_relabel old new st :
  books (replace old new st) = relabel (pred (Pos.to_nat old)) (pred (Pos.to_nat new)) (books st).
Proof.
  unfold books, replace, relabel. rewrite !map_map. apply map_ext. intros [d l]. unfold unary. cbn [fst snd].
  rewrite unary_eqb. now destruct (_ =? _).
Qed.
Lemma books_nth v st : nth v (books st) (2, 0) = unary (nth v st (2, xH)).
Proof. exact (map_nth unary st (2, xH) v). Qed.
Lemma books_step e st : option_map books (add_edge e st) = step e (books st).
Proof.
  unfold add_edge, step. rewrite !books_nth.
  destruct (nth (fst e) st (2, xH)) as [da la]. destruct (nth (snd e) st (2, xH)) as [db lb].
  unfold unary. cbn [fst snd]. rewrite unary_eqb, unary_ltb. destruct ((da <? 2) && (db <? 2) && _); [|reflexivity].
  cbn [option_map]. f_equal. rewrite <- !books_bump. destruct (_ <? _); apply books_relabel.
Qed.
Lemma books_draw es : forall c st, option_map books (add_edges es c st) = draw es c (books st).
Proof.
  induction es as [|e es IH]; intros [|[|] c] st; try reflexivity; cbn [add_edges draw]; [|apply IH].
  rewrite <- books_step. destruct (add_edge e st) as [st'|]; [apply IH|reflexivity].
Qed.

Theorem labels_drawn d s x : drawn_with_labels d s x = drawn d s x.
Proof.
  unfold drawn_with_labels, drawn. rewrite <- books_blank, <- books_draw.
  destruct (add_edges (port_edges d) s (blank_labels (size d))) as [st|]; [apply books_draw|reflexivity].
Qed.
