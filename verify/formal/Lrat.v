(** * Checking a proof that a formula has no model

    What [restrip-lrat] decides: [refutes]. A proof is a list of clauses, each with hints: the clauses that, one after the
    other, have all literals but one false once the clause itself is taken to be false, up to one that has none left. This is
    the part of LRAT that needs no RAT (Cruz-Filipe and others, "Efficient certified RAT verification", 2017). Whoever
    wrote the proof need not be believed ([refutes_right]). *)
Require Import Bool List ZArith FMapPositive.
Import ListNotations.
Require Import Statements.
Import Formulas.

(** What is known of variables. *)
Definition values := PositiveMap.t bool.
(** With the literal made true, or false. *)
Definition assign (made : bool) (l : literal) (m : values) : values :=
  match l with
  | Zpos v => PositiveMap.add v made m
  | Zneg v => PositiveMap.add v (negb made) m
  | Z0 => m
  end.
Definition known_false (m : values) (l : literal) : bool :=
  match l with
  | Zpos v => match PositiveMap.find v m with Some b => negb b | None => false end
  | Zneg v => match PositiveMap.find v m with Some b => b | None => false end
  | Z0 => true
  end.

(** The clauses by number. *)
Definition clauses := PositiveMap.t clause.
(** Does following the hints end with a clause that is false altogether? *)
Fixpoint conflict (db : clauses) (m : values) (hints : list positive) : bool :=
  match hints with
  | [] => false
  | h :: r =>
      match PositiveMap.find h db with
      | None => false
      | Some c =>
          match filter (fun l => negb (known_false m l)) c with
          | [] => true
          | l :: copies => forallb (Z.eqb l) copies && conflict db (assign true l m) r
          end
      end
  end.
Definition denied (c : clause) : values := fold_right (assign false) (PositiveMap.empty bool) c.

Fixpoint follow (db : clauses) (proof : list step) : bool :=
  match proof with
  | [] => false
  | Learn n c hints :: r =>
      conflict db (denied c) hints && match c with [] => true | _ => follow (PositiveMap.add n c db) r end
  | Forget numbers :: r => follow (fold_right (@PositiveMap.remove clause) db numbers) r
  end.
Fixpoint numbered (n : positive) (F : formula) (db : clauses) : clauses :=
  match F with [] => db | c :: r => numbered (Pos.succ n) r (PositiveMap.add n c db) end.
Definition refutes (F : formula) (proof : list step) : bool := follow (numbered 1 F (PositiveMap.empty clause)) proof.

(** ** It is right *)
Definition meets (A : positive -> bool) (c : clause) : Prop := exists l, In l c /\ holds A l.
Definition agrees (A : positive -> bool) (m : values) : Prop := forall v b, PositiveMap.find v m = Some b -> A v = b.
Definition all_met (A : positive -> bool) (db : clauses) : Prop := forall n c, PositiveMap.find n db = Some c -> meets A c.

Lemma find_add {T} n k (x : T) m : PositiveMap.find n (PositiveMap.add k x m) = if Pos.eq_dec n k then Some x else PositiveMap.find n m.
Proof. destruct (Pos.eq_dec n k) as [->|N]; [apply PositiveMap.gss|now apply PositiveMap.gso]. Qed.

Lemma agrees_add A v b m : A v = b -> agrees A m -> agrees A (PositiveMap.add v b m).
Proof. intros E G w d. rewrite find_add. destruct (Pos.eq_dec w v) as [->|]; [intros [= <-]; exact E|apply G]. Qed.
Lemma assigned_true A l m : holds A l -> agrees A m -> agrees A (assign true l m).
Proof. destruct l; intros H; [exact (fun G => G)|now apply agrees_add|now apply agrees_add]. Qed.
Lemma assigned_false A l m : ~ holds A l -> agrees A m -> agrees A (assign false l m).
Proof.
  destruct l as [|v|v]; cbn [holds assign negb]; intros H; [exact (fun G => G)|apply agrees_add|apply agrees_add];
    now destruct (A v).
Qed.
Lemma denied_agrees A c : ~ meets A c -> agrees A (denied c).
Proof.
  induction c as [|l c IH]; intros N.
  - intros v b. cbn. rewrite PositiveMap.gempty. discriminate.
  - apply assigned_false.
    + intros H. apply N. exists l. split; [now left|exact H].
    + apply IH. intros (k & I & H). apply N. exists k. split; [now right|exact H].
Qed.
Lemma known_false_right A m l : agrees A m -> known_false m l = true -> ~ holds A l.
Proof.
  intros G. destruct l as [|v|v]; cbn [known_false holds]; [easy| |]; specialize (G v);
    destruct (PositiveMap.find v m) as [b|]; try discriminate; rewrite (G b eq_refl); now destruct b.
Qed.

Lemma conflict_right A db hints : all_met A db -> forall m, conflict db m hints = true -> ~ agrees A m.
Proof.
  intros D. induction hints as [|h r IH]; intros m; cbn [conflict]; [discriminate|].
  destruct (PositiveMap.find h db) as [c|] eqn:F; [|discriminate]. intros C G.
  destruct (D h c F) as (l & I & H).
  assert (J : In l (filter (fun l => negb (known_false m l)) c)).
  { apply filter_In. split; [exact I|]. destruct (known_false m l) eqn:K; [|reflexivity].
    now apply (known_false_right A m l G) in K. }
  destruct (filter _ c) as [|k copies]; [destruct J|]. apply andb_prop in C as [Same C]. rewrite forallb_forall in Same.
  assert (k = l) as -> by (destruct J as [E|J]; [exact E|now apply Z.eqb_eq, Same]).
  now apply (IH (assign true l m) C), assigned_true.
Qed.

Lemma follow_right A proof : forall db, follow db proof = true -> ~ all_met A db.
Proof.
  induction proof as [|[n c hints|numbers] r IH]; intros db; cbn [follow]; [discriminate| |].
  - intros E D. apply andb_prop in E as [C E].
    assert (M : ~ ~ meets A c) by (intros N; exact (conflict_right A db hints D _ C (denied_agrees A c N))).
    destruct c as [|l c]; [apply M; now intros (l & [] & _)|].
    apply M. intros L. apply (IH _ E). intros k d. rewrite find_add. destruct (Pos.eq_dec k n); [intros [= <-]; exact L|apply D].
  - intros E D. apply (IH _ E). clear -D. induction numbers as [|n l IH]; [exact D|]. cbn [fold_right]. intros k c.
    destruct (Pos.eq_dec k n) as [->|N]; [rewrite PositiveMap.grs; discriminate|]. rewrite PositiveMap.gro by congruence. apply IH.
Qed.
Lemma numbered_met A F : (forall c, In c F -> meets A c) -> forall n db, all_met A db -> all_met A (numbered n F db).
Proof.
  induction F as [|c F IH]; intros M n db D; [exact D|]. apply IH; [intros d I; apply M; now right|].
  intros k d. rewrite find_add. destruct (Pos.eq_dec k n); [intros [= <-]; apply M; now left|apply D].
Qed.
Theorem refutes_right : Refutes_right refutes.
Proof.
  intros F proof E A M. apply (follow_right A proof _ E). apply numbered_met; [exact M|].
  intros n c. rewrite PositiveMap.gempty. discriminate.
Qed.
