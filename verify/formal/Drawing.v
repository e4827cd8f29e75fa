(** * Drawing a graph edge by edge

    The checker keeps, for each vertex, its degree and a label; two vertices have the same label exactly when they are
    linked. This file proves that the books are right: [step] draws one edge or refuses to, and it refuses exactly when
    the graph would not be valid any more. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Table.

Definition state := list (nat * nat).
Definition degree_in (st : state) (v : nat) : nat := fst (nth v st (2, 0)).
Definition label_in (st : state) (v : nat) : nat := snd (nth v st (2, 0)).

Definition blank (size : nat) : state := map (fun v => (0, v)) (seq 0 size).

Fixpoint bump (v : nat) (st : state) : state :=
  match st, v with
  | [], _ => []
  | (d, l) :: r, 0 => (S d, l) :: r
  | n :: r, S v' => n :: bump v' r
  end.
Definition relabel (old new : nat) (st : state) : state :=
  map (fun n : nat * nat => if snd n =? old then (fst n, new) else n) st.
(** The smaller label survives, so that the labels of a partition are always the same. *)
Definition step (e : edge) (st : state) : option state :=
  let (da, la) := nth (fst e) st (2, 0) in
  let (db, lb) := nth (snd e) st (2, 0) in
  if (da <? 2) && (db <? 2) && negb (la =? lb)
  then Some (let st' := bump (fst e) (bump (snd e) st) in
             if la <? lb then relabel lb la st' else relabel la lb st')
  else None.

(** The state [st] describes the graph [G] on the vertices below [size]. *)
Definition describes (size : nat) (st : state) (G : graph) : Prop :=
  length st = size /\
  (forall v, v < size -> degree_in st v = degree G v) /\
  (forall u v, u < size -> v < size -> (label_in st u = label_in st v <-> linked G u v)).

Lemma describes_perm size st G H : Permutation G H -> describes size st G -> describes size st H.
Proof.
  intros P (L & D & K). split; [exact L|split].
  - intros v Hv. rewrite D by exact Hv. now apply degree_perm.
  - intros u v Hu Hv. rewrite K by assumption. split; apply linked_perm; [|symmetry]; exact P.
Qed.

Lemma describes_blank size : describes size (blank size) [].
Proof.
  unfold blank. split; [now rewrite map_length, seq_length|].
  assert (E : forall v, v < size -> nth v (map (fun v => (0, v)) (seq 0 size)) (2, 0) = (0, v)).
  { intros v Hv. rewrite (nth_indep _ (2, 0) (0, 0)) by now rewrite map_length, seq_length.
    rewrite (map_nth (fun v => (0, v))). now rewrite seq_nth. }
  split.
  - intros v Hv. unfold degree_in. now rewrite E.
  - intros u v Hu Hv. unfold label_in. rewrite !E by assumption. simpl. split; [intros ->; apply here|].
    intros L. induction L as [|v w L IH [[]|[]]]. reflexivity.
Qed.

Lemma bump_length v st : length (bump v st) = length st.
Proof. revert v. induction st as [|[d l] st IH]; intros [|v]; simpl; auto. Qed.

Lemma bump_nth v st w : v < length st ->
  nth w (bump v st) (2, 0) = ((if v =? w then 1 else 0) + degree_in st w, label_in st w).
Proof.
  unfold degree_in, label_in. revert v w. induction st as [|[d l] st IH]; intros [|v] [|w] H; simpl in *; try lia;
    try reflexivity.
  - destruct (nth w st (2, 0)) as [x y]. reflexivity.
  - rewrite IH by lia. reflexivity.
Qed.

Lemma relabel_length old new st : length (relabel old new st) = length st.
Proof. apply map_length. Qed.

Lemma relabel_nth old new st v : v < length st ->
  nth v (relabel old new st) (2, 0) =
  (degree_in st v, if label_in st v =? old then new else label_in st v).
Proof.
  intros H. unfold relabel, degree_in, label_in.
  set (f := fun n : nat * nat => if snd n =? old then (fst n, new) else n).
  rewrite (nth_indep _ (2, 0) (f (2, 0))) by now rewrite map_length.
  rewrite map_nth. unfold f. destruct (nth v st (2, 0)) as [d l]. simpl. now destruct (l =? old).
Qed.

(** Merging the labels of [a] and [b], whichever of the two survives. *)
Lemma merge_ok size st G a b old new :
  describes size st G -> a < size -> b < size -> label_in st a <> label_in st b ->
  (old = label_in st b /\ new = label_in st a \/ old = label_in st a /\ new = label_in st b) ->
  describes size (relabel old new (bump a (bump b st))) ((a, b) :: G).
Proof.
  intros (L & D & K) Ha Hb N C.
  assert (LB : length (bump a (bump b st)) = size) by now rewrite !bump_length.
  assert (DD : forall v, degree_in (bump a (bump b st)) v = (if a =? v then 1 else 0) + ((if b =? v then 1 else 0) + degree_in st v)).
  { intros v. unfold degree_in at 1. rewrite bump_nth by (rewrite bump_length; lia). simpl. unfold degree_in at 1.
    rewrite bump_nth by lia. reflexivity. }
  assert (LL : forall v, label_in (bump a (bump b st)) v = label_in st v).
  { intros v. unfold label_in at 1. rewrite bump_nth by (rewrite bump_length; lia). simpl. unfold label_in at 1.
    rewrite bump_nth by lia. reflexivity. }
  split; [now rewrite relabel_length|]. split.
  - intros v Hv. unfold degree_in at 1. rewrite relabel_nth by lia. simpl. rewrite DD, degree_cons. unfold meets. simpl.
    rewrite (D v Hv). lia.
  - intros u v Hu Hv. unfold label_in. rewrite !relabel_nth by lia. simpl. rewrite !LL, linked_cons.
    rewrite <- (K u v), <- (K u a), <- (K b v), <- (K u b), <- (K a v) by assumption.
    destruct C as [[-> ->]|[-> ->]].
    + destruct (Nat.eqb_spec (label_in st u) (label_in st b)), (Nat.eqb_spec (label_in st v) (label_in st b)); intuition congruence.
    + destruct (Nat.eqb_spec (label_in st u) (label_in st a)), (Nat.eqb_spec (label_in st v) (label_in st a)); intuition congruence.
Qed.

Lemma step_ok size st G a b : describes size st G -> valid G -> a < size -> b < size ->
  match step (a, b) st with
  | Some st' => describes size st' ((a, b) :: G) /\ valid ((a, b) :: G)
  | None => ~ valid ((a, b) :: G)
  end.
Proof.
  intros Ds V Ha Hb. pose proof Ds as (L & D & K). unfold step. simpl.
  pose proof (D a Ha) as Da. pose proof (D b Hb) as Db. pose proof (K a b Ha Hb) as Kab.
  pose proof (merge_ok size st G a b) as M. unfold degree_in, label_in in *.
  destruct (nth a st (2, 0)) as [da la]. destruct (nth b st (2, 0)) as [db lb]. cbn [fst snd] in *.
  pose proof (valid_cons a b G) as E. rewrite <- Da, <- Db, <- Kab in E.
  destruct (Nat.ltb_spec da 2); simpl; [|rewrite E; intros (_ & ? & _); lia].
  destruct (Nat.ltb_spec db 2); simpl; [|rewrite E; intros (_ & _ & ? & _); lia].
  destruct (Nat.eqb_spec la lb); simpl; [rewrite E; intros (_ & _ & _ & ?); contradiction|].
  split; [|apply E; repeat split; try assumption; try apply V; lia].
  destruct (la <? lb); apply M; auto.
Qed.

(** ** Drawing a colouring *)
Fixpoint draw (es : list edge) (c : coloring) (st : state) : option state :=
  match es, c with
  | e :: es', true :: c' => match step e st with Some st' => draw es' c' st' | None => None end
  | _ :: es', false :: c' => draw es' c' st
  | _, _ => Some st
  end.

Definition inside (size : nat) (es : list edge) : Prop := forall e, In e es -> fst e < size /\ snd e < size.

Lemma inside_cons size a b es : inside size ((a, b) :: es) -> a < size /\ b < size /\ inside size es.
Proof.
  intros I. destruct (I (a, b)) as [Ha Hb]; [now left|]. repeat split; auto; apply I; now right.
Qed.

Lemma shift_middle (e : edge) (G H : graph) : Permutation (H ++ e :: G) ((e :: H) ++ G).
Proof. simpl. symmetry. apply Permutation_middle. Qed.

Lemma draw_ok size es : forall c st G, describes size st G -> valid G -> inside size es ->
  match draw es c st with
  | Some st' => describes size st' (solid es c ++ G) /\ valid (solid es c ++ G)
  | None => ~ valid (solid es c ++ G)
  end.
Proof.
  induction es as [|[a b] es IH]; intros [|[|] c] st G Ds V I; cbn [draw solid app]; auto.
  - apply inside_cons in I as (Ha & Hb & I). pose proof (step_ok size st G a b Ds V Ha Hb) as S.
    destruct (step (a, b) st) as [st'|].
    + destruct S as [Ds' V']. specialize (IH c st' _ Ds' V' I). destruct (draw es c st') as [st''|].
      * destruct IH as [Ds'' V'']. split; [eapply describes_perm; [apply shift_middle|exact Ds'']|].
        eapply valid_perm; [apply shift_middle|exact V''].
      * intros V''. apply IH. eapply valid_perm; [symmetry; apply shift_middle|exact V''].
    + intros V'. apply S. apply valid_suffix with (solid es c).
      eapply valid_perm; [symmetry; apply shift_middle|exact V'].
  - apply inside_cons in I as (_ & _ & I). now apply IH.
Qed.

(** ** Drawing all colourings at once

    [walk] visits every colouring of [es] depth first and gives up a branch as soon as it is not valid. It goes down a
    trie at the same time. For a valid colouring it reports the number of solid edges, the state and the subtrie; for an
    abandoned branch with an answer in the trie it reports [None], an error. *)
Definition leaf := option (nat * state * trie).
Fixpoint walk (es : list edge) (st : state) (n : nat) (t : trie) (found : list leaf) : list leaf :=
  match es with
  | [] => Some (n, st, t) :: found
  | e :: es' =>
      walk es' st n (branch false t)
        (match step e st with
         | Some st' => walk es' st' (S n) (branch true t) found
         | None => if silent (branch true t) then found else None :: found
         end)
  end.

Lemma walk_keeps es : forall st n t found x, In x found -> In x (walk es st n t found).
Proof.
  induction es as [|e es IH]; intros st n t found x I; simpl; [now right|]. apply IH.
  destruct (step e st); [now apply IH|]. destruct (silent (branch true t)); [exact I|now right].
Qed.

Lemma walk_ok size es : forall c st G n t found, describes size st G -> valid G -> inside size es -> length c = length es ->
  (valid (solid es c ++ G) -> exists st',
     In (Some (n + solids c, st', fold_left (fun u b => branch b u) c t)) (walk es st n t found) /\
     describes size st' (solid es c ++ G)) /\
  (~ valid (solid es c ++ G) -> In None (walk es st n t found) \/ find t c = None).
Proof.
  induction es as [|[a b] es IH]; intros [|[|] c] st G n t found Ds V I Len; try discriminate; cbn [walk solid app].
  - split; [|contradiction]. intros _. exists st. split; [left; repeat f_equal; unfold solids; simpl; lia|exact Ds].
  - apply inside_cons in I as (Ha & Hb & I). injection Len as Len.
    pose proof (step_ok size st G a b Ds V Ha Hb) as S. destruct (step (a, b) st) as [st'|].
    + destruct S as [Ds' V']. destruct (IH c st' _ (S n) (branch true t) found Ds' V' I Len) as [IHv IHn]. split.
      * intros V''. destruct IHv as (st'' & J & Ds''); [eapply valid_perm; [symmetry; apply shift_middle|exact V'']|].
        exists st''. split; [|eapply describes_perm; [apply shift_middle|exact Ds'']].
        apply walk_keeps. replace (n + solids (true :: c)) with (S n + solids c) by (unfold solids; simpl; lia). exact J.
      * intros NV. destruct IHn as [J|F].
        { intros V''. apply NV. eapply valid_perm; [apply shift_middle|exact V'']. }
        { left. now apply walk_keeps. } { now right. }
    + split.
      * intros V'. exfalso. apply S. apply valid_suffix with (solid es c).
        eapply valid_perm; [symmetry; apply shift_middle|exact V'].
      * intros _. destruct (silent (branch true t)) eqn:Q; [right; simpl; now apply silent_find|].
        left. apply walk_keeps. now left.
  - apply inside_cons in I as (_ & _ & I). injection Len as Len.
    destruct (IH c st G n (branch false t) (match step (a, b) st with
         | Some st' => walk es st' (S n) (branch true t) found
         | None => if silent (branch true t) then found else None :: found
         end) Ds V I Len) as [IHv IHn]. split; [|exact IHn].
    intros V'. destruct (IHv V') as (st' & J & Ds'). exists st'. split; [|exact Ds']. exact J.
Qed.
