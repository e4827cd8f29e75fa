(** * Checking a step

    What [restrip-check] decides of every operation of a run, under any cost (docs/how-to/check-a-run.md): [judge_step], extracted
    like [judge] of Check.v. The reader says which triangles and solid edges an operation takes away and adds. A triangle is
    touched if it is new or if one of its solid edges is. Each touched triangle must have at most two solid edges, and its strip
    must have an end. Then the whole mesh is valid if it was before ([judge_step_right]): a cycle through a touched triangle
    has no end, and any other cycle was there before.

    Cost: linear in the triangles touched and walked over, apart from the sets. A walk goes both ways in turn, at most twice
    as far as the nearer end; touched triangles met on the way need no walk. Everything that can be long is tail recursive. *)
Require Import Arith Bool List ZArith Permutation Lia.
Import ListNotations.
Require Import Statements Graph Strips.
Import Meshes Steps.

Section Step.
  Context {T S : Type} (k : sets T S) (same : T -> T -> bool) (fuel : nat).

  (** ** The decision *)
  Definition add_all (s : S) (ts : list T) : S := fold_left (fun s t => add k t s) ts s.
  Definition count (f : T -> bool) (ts : list T) : Z := fold_left (fun n t => if f t then Z.succ n else n) ts 0%Z.
  Definition size {A} (l : list A) : Z := fold_left (fun n _ => Z.succ n) l 0%Z.

  Fixpoint without (t : T) (l : list T) : list T :=
    match l with [] => [] | u :: r => if same t u then r else u :: without t r end.

  Section Walk.
    Variable beside : T -> list T.

    (** Two walkers, at [one] and [other], that came from [from] and [back]; [t] is where they started. *)
    Fixpoint walk (fuel : nat) (t from one back other : T) (pending : S) : option S :=
      match fuel with
      | 0 => None
      | Datatypes.S fuel =>
          match without from (beside one) with
          | [] => Some pending
          | u :: _ => if same t u then None else walk fuel t back other one u (drop k u pending)
          end
      end.

    (** The first fault among the triangles [ts]; those that are not [pending] are known to lie on strips with ends. *)
    Fixpoint fault (ts : list T) (pending : S) : option (step T) :=
      match ts with
      | [] => None
      | t :: r =>
          match beside t with
          | [] | [_] => fault r pending
          | [a; b] =>
              if has k t pending then
                match walk fuel t t a t b (drop k a (drop k b pending)) with
                | None => Some (Round t)
                | Some pending => fault r pending
                end
              else fault r pending
          | _ => Some (Three t)
          end
      end.
  End Walk.

  (** Ends of [lost] and [made] that are neither gone nor new, each once; with the set of all triangles seen. *)
  Definition see (found : list T * S) (t : T) : list T * S := if has k t (snd found) then found else (t :: fst found, add k t (snd found)).
  Definition stays (gone come : list T) (lost made : list (T * T)) : list T :=
    let sees found (e : T * T) := see (see found (fst e)) (snd e) in
    fst (fold_left sees made (fold_left sees lost ([], add_all (add_all (none k) gone) come))).

  Definition judge_step (lone : T -> bool) (beside : T -> list T) (gone come : list T) (lost made : list (T * T)) : step T :=
    let still := stays gone come lost made in
    let news := rev_append come still in
    match fault beside news (add_all (none k) news) with
    | Some wrong => wrong
    | None =>
        Changes ((size come - size gone) - (size made - size lost))
          (count (fun t => match beside t with [] => true | _ => false end) news - (count lone gone + count lone still))
    end.
End Step.

(** ** A strip with an end is no cycle

    The end's edge is taken away, and so on along the strip. *)
Lemma incident_degree G e v : In e G -> fst e = v \/ snd e = v -> degree G v <> 0.
Proof.
  destruct e as [a b]. intros I [<-|<-]; [apply (adjacent_degree G a b); now left|apply (adjacent_degree G b a); now right].
Qed.

Lemma end_edge G : forall x, degree G x = 1 ->
  exists y e H, Permutation G (e :: H) /\ (e = (x, y) \/ e = (y, x)) /\ y <> x /\ degree H x = 0.
Proof.
  induction G as [|[a b] G IH]; intros x D; [discriminate|]. rewrite degree_cons in D. unfold meets in D. simpl in D.
  destruct (Nat.eqb_spec a x) as [->|Na], (Nat.eqb_spec b x) as [->|Nb]; try lia.
  - exists b, (x, b), G. split; [reflexivity|split; [now left|split; [exact Nb|lia]]].
  - exists a, (a, x), G. split; [reflexivity|split; [now right|split; [exact Na|lia]]].
  - destruct (IH x D) as (y & e & H & P & E & N & Z). exists y, e, ((a, b) :: H). split; [|split; [exact E|split; [exact N|]]].
    + rewrite P. apply perm_swap.
    + rewrite degree_cons. unfold meets. simpl. destruct (Nat.eqb_spec a x), (Nat.eqb_spec b x); congruence || lia.
Qed.

Lemma linked_either x y e G u v : e = (x, y) \/ e = (y, x) -> linked (e :: G) u v -> linked ((x, y) :: G) u v.
Proof. intros [->| ->]; [auto|]. rewrite !linked_cons. tauto. Qed.

Lemma no_cycle_at_end n : forall G x e rest, length G = n -> (forall v, degree G v <= 2) -> degree G x <= 1 ->
  Permutation G (e :: rest) -> linked G x (fst e) -> ~ linked rest (fst e) (snd e).
Proof.
  induction n as [|n IH]; intros G x e rest Len Two End P L C.
  { destruct G; [|discriminate]. apply Permutation_nil in P. discriminate. }
  assert (I : In e G) by (apply (Permutation_in _ (Permutation_sym P)); now left).
  assert (Z : degree G x = 0 \/ degree G x = 1) by lia. destruct Z as [Z|Z].
  { apply (incident_degree G e x I); [|exact Z]. left. symmetry. apply (linked_lonely G); [exact Z|]. now apply linked_sym. }
  destruct (end_edge G x Z) as (y & f & H & Q & F & N & D).
  assert (R : Permutation (e :: rest) (f :: H)) by now rewrite <- P.
  apply cons_cases in R as [[-> R]|(K & R1 & R2)].
  - apply (linked_perm _ _ _ _ R) in C. apply N. symmetry. apply (linked_lonely H); [exact D|].
    destruct F as [->| ->]; simpl in C; [now apply linked_sym|exact C].
  - assert (DK : degree H x = meets e x + degree K x) by now rewrite (degree_perm _ _ x R2), degree_cons.
    assert (Na : x <> fst e) by (intros E; unfold meets in DK; rewrite E, Nat.eqb_refl in DK; rewrite <- E in DK; lia).
    assert (Nb : x <> snd e) by (intros E; unfold meets in DK; rewrite E, Nat.eqb_refl in DK; rewrite <- E in DK; lia).
    assert (K0 : degree K x = 0) by lia.
    apply (linked_perm _ _ _ _ R1), (linked_either _ _ _ _ _ _ F), linked_cons in C.
    assert (C' : linked K (fst e) (snd e)).
    { destruct C as [C|[[C _]|[_ C]]]; [exact C| |]; exfalso.
      - apply Na. exact (linked_lonely K _ _ K0 C).
      - apply Nb. apply (linked_lonely K _ _ K0). now apply linked_sym. }
    apply (IH H y e K); auto.
    + apply Permutation_length in Q. simpl in Q. lia.
    + intros v. specialize (Two v). rewrite (degree_perm _ _ v Q), degree_cons in Two. lia.
    + specialize (Two y). rewrite (degree_perm _ _ y Q), degree_cons in Two. unfold meets in Two.
      destruct F as [->| ->]; simpl in Two; rewrite Nat.eqb_refl in Two; lia.
    + apply (linked_perm _ _ _ _ Q), (linked_either _ _ _ _ _ _ F), linked_cons in L.
      destruct L as [L|[[_ L]|[_ L]]]; [| exact L|]; exfalso; apply Na, (linked_lonely H); auto; now apply linked_sym.
Qed.

(** Where no vertex is linked with an end of [made], nothing but what was there before is reached. *)
Lemma linked_away made kept u v : (forall e w, In e made -> fst e = w \/ snd e = w -> ~ linked (made ++ kept) u w) ->
  linked (made ++ kept) u v -> linked kept u v.
Proof.
  intros Away L. induction L as [|v w L IH A]; [apply here|]. apply onward with v; [exact IH|].
  destruct A as [A|A]; apply in_app_or in A as [A|A]; [exfalso|now left|exfalso|now right].
  - exact (Away _ v A (or_introl eq_refl) L).
  - exact (Away _ v A (or_intror eq_refl) L).
Qed.

(** The theorem of locality: no fault arises away from what is made. *)
Definition has_end (G : graph) (v : nat) : Prop := exists x, linked G v x /\ degree G x <= 1.
Theorem ends_suffice lost made kept : valid (lost ++ kept) -> (forall v, degree (made ++ kept) v <= 2) ->
  (forall e, In e made -> has_end (made ++ kept) (fst e) \/ has_end (made ++ kept) (snd e)) -> valid (made ++ kept).
Proof.
  intros V Two Ends. split; [exact Two|]. intros e rest P L.
  assert (E : forall x, degree (made ++ kept) x <= 1 -> ~ linked (made ++ kept) x (fst e)).
  { intros x D M. exact (no_cycle_at_end _ _ x e rest eq_refl Two D P M L). }
  assert (Sub : forall a b, linked rest a b -> linked (made ++ kept) a b).
  { intros a b. apply linked_mono. intros f I. apply (Permutation_in _ (Permutation_sym P)). now right. }
  assert (Away : forall f w, In f made -> fst f = w \/ snd f = w -> ~ linked (made ++ kept) (fst e) w).
  { intros f w I F M. assert (A : linked (made ++ kept) (fst f) (snd f)).
    { apply linked_edge. left. apply in_or_app. left. now destruct f. }
    destruct (Ends f I) as [(x & X & D)|(x & X & D)]; apply (E x D), linked_sym; (eapply linked_trans; [exact M|]);
      destruct F as [<-|<-]; try exact X; (eapply linked_trans; [|exact X]); first [exact A|apply linked_sym, A]. }
  assert (Ik : In e kept).
  { assert (I : In e (made ++ kept)) by (apply (Permutation_in _ (Permutation_sym P)); now left).
    apply in_app_or in I as [I|I]; [|exact I]. exfalso. apply (Away e (fst e) I); [now left|apply here]. }
  apply in_split in Ik as (k1 & k2 & Ek).
  assert (R : Permutation rest (made ++ k1 ++ k2)).
  { apply Permutation_cons_inv with e. rewrite <- P, Ek, !app_assoc. symmetry. apply Permutation_middle. }
  apply (linked_perm _ _ _ _ R) in L. apply linked_away in L.
  - apply valid_suffix in V. destruct V as [_ A]. apply (A e (k1 ++ k2)); [|exact L]. rewrite Ek. symmetry. apply Permutation_middle.
  - intros f w I F M. apply (Away f w I F). apply Sub. now apply (linked_perm _ _ _ _ (Permutation_sym R)).
Qed.

(** ** The decision is right *)
Lemma size_length {A} (l : list A) : size l = Z.of_nat (length l).
Proof.
  unfold size. enough (forall n, fold_left (fun n _ => Z.succ n) l n = (n + Z.of_nat (length l))%Z) as -> by lia.
  induction l as [|a l IH]; intros n; simpl fold_left; [simpl; lia|]. rewrite IH. simpl length. lia.
Qed.
Lemma count_filter {T} (f : T -> bool) l : count f l = Z.of_nat (length (filter f l)).
Proof.
  unfold count. enough (forall n, fold_left (fun n t => if f t then Z.succ n else n) l n = (n + Z.of_nat (length (filter f l)))%Z) as -> by lia.
  induction l as [|a l IH]; intros n; simpl fold_left; [simpl; lia|]. rewrite IH. simpl filter. destruct (f a); simpl length; lia.
Qed.
Definition isolated_in (G : graph) (vs : list nat) : Z := Z.of_nat (length (filter (fun v => degree G v =? 0) vs)).
Lemma isolated_app G vs ws : isolated_in G (vs ++ ws) = (isolated_in G vs + isolated_in G ws)%Z.
Proof. unfold isolated_in. rewrite filter_app, app_length. lia. Qed.
Lemma isolated_perm G vs ws : Permutation vs ws -> isolated_in G vs = isolated_in G ws.
Proof.
  intros P. unfold isolated_in. induction P; simpl; auto.
  - destruct (degree G x =? 0); simpl; lia.
  - destruct (degree G x =? 0), (degree G y =? 0); simpl; lia.
  - congruence.
Qed.
Lemma count_isolated {T} (name : T -> nat) G f l : (forall t, In t l -> f t = (degree G (name t) =? 0)) ->
  count f l = isolated_in G (map name l).
Proof.
  rewrite count_filter. unfold isolated_in. intros E. f_equal. induction l as [|t l IH]; [reflexivity|].
  simpl. rewrite (E t) by now left. destruct (_ =? 0); simpl; rewrite IH by (intros u I; apply E; now right); reflexivity.
Qed.
Lemma isolated_same G H vs : (forall v, In v vs -> degree G v = degree H v) -> isolated_in G vs = isolated_in H vs.
Proof.
  intros E. unfold isolated_in. f_equal. f_equal. apply filter_ext_in. intros v I. now rewrite E.
Qed.
Lemma rest_of {A} (l : list A) : forall m, NoDup l -> incl l m -> exists o, Permutation m (l ++ o).
Proof.
  induction l as [|a l IH]; intros m N I; [now exists m|]. inversion_clear N as [|? ? Na N'].
  destruct (in_split a m) as (m1 & m2 & ->); [apply I; now left|]. destruct (IH (m1 ++ m2) N') as (o & P).
  - intros x J. assert (K : In x (m1 ++ a :: m2)) by (apply I; now right). apply in_app_or in K as [K|[<-|K]]; [|tauto|]; apply in_or_app; auto.
  - exists o. rewrite <- Permutation_middle. simpl. now constructor.
Qed.

Section Right.
  Context {T S : Type} (k : sets T S) (L : lawful k).

  Lemma has_add_all ts : forall s t, has k t (add_all k s ts) = true <-> In t ts \/ has k t s = true.
  Proof.
    destruct L as (_ & Add & _). induction ts as [|u ts IH]; intros s t; simpl; [tauto|].
    unfold add_all in *. simpl. rewrite IH, Add. intuition congruence.
  Qed.

  Lemma see_right ts : forall l s, NoDup l -> (forall t, In t l -> has k t s = true) ->
    let l' := fst (fold_left (see k) ts (l, s)) in NoDup l' /\ forall t, In t l' <-> In t l \/ (In t ts /\ has k t s = false).
  Proof.
    destruct L as (_ & Add & _). induction ts as [|u ts IH]; intros l s N H; simpl; [tauto|].
    unfold see at 2 4. simpl. destruct (has k u s) eqn:Hu.
    - destruct (IH l s N H) as [N' E]. split; [exact N'|]. intros t. rewrite E. intuition congruence.
    - destruct (IH (u :: l) (add k u s)) as [N' E].
      + constructor; [|exact N]. intros I. apply H in I. congruence.
      + intros t [<-|I]; apply Add; auto.
      + split; [exact N'|]. intros t. rewrite E. simpl. specialize (Add t u s).
        destruct (has k t (add k u s)) eqn:A.
        * destruct (proj1 Add eq_refl) as [->|B]; [tauto|]. intuition congruence.
        * assert (t <> u) by (intros ->; assert (false = true) by (apply Add; auto); discriminate).
          destruct (has k t s) eqn:B; [assert (false = true) by (apply Add; auto); discriminate|]. intuition congruence.
  Qed.

  Definition ends_of (es : list (T * T)) : list T := flat_map (fun e => [fst e; snd e]) es.
  Lemma sees_flat es : forall found,
    fold_left (fun found (e : T * T) => see k (see k found (fst e)) (snd e)) es found = fold_left (see k) (ends_of es) found.
  Proof. induction es as [|e es IH]; intros found; [reflexivity|]. simpl. apply IH. Qed.
  Lemma stays_right gone come lost made : let still := stays k gone come lost made in
    NoDup still /\ forall t, In t still <-> In t (ends_of lost ++ ends_of made) /\ ~ In t gone /\ ~ In t come.
  Proof.
    unfold stays. rewrite !sees_flat, <- fold_left_app.
    destruct (see_right (ends_of lost ++ ends_of made) [] (add_all k (add_all k (none k) gone) come)) as [N E]; [constructor|intros t []|].
    split; [exact N|]. intros t. rewrite E. pose proof (has_add_all come (add_all k (none k) gone) t) as H.
    pose proof (has_add_all gone (none k) t) as H'. rewrite (proj1 L) in H'.
    destruct (has k t (add_all k (add_all k (none k) gone) come)); simpl; intuition congruence.
  Qed.

  Variable same : T -> T -> bool.
  Lemma without_in t u l : In u (without same t l) -> In u l.
  Proof. induction l as [|x l IH]; simpl; [auto|]. destruct (same t x); simpl; tauto. Qed.
  Lemma without_nil t l : without same t l = [] -> length l <= 1.
  Proof. destruct l as [|x l]; simpl; [auto|]. destruct (same t x); [intros ->; auto|discriminate]. Qed.

  Variables (name : T -> nat) (M : mesh) (beside : T -> list T).
  Hypotheses (Sane : sane M) (Beside : lists_neighbours name beside M).
  Let G := edges M.
  Let inside t := In (name t) (nodes M).

  Lemma onward_inside t u : inside t -> In u (beside t) -> inside u /\ linked G (name t) (name u).
  Proof.
    intros I J. destruct (Beside t I) as [_ A]. apply A in J. split; [|now apply linked_edge].
    apply (proj2 Sane). apply adjacent_degree with (name t). now apply adjacent_sym.
  Qed.
  Lemma has_end_linked u v : linked G u v -> has_end G v -> has_end G u.
  Proof. intros A (x & B & D). exists x. split; [eapply linked_trans; eassumption|exact D]. Qed.

  Lemma walk_right fuel : forall t from one back other pending p, walk k same beside fuel t from one back other pending = Some p ->
    inside one -> linked G (name t) (name one) -> inside other -> linked G (name t) (name other) ->
    has_end G (name t) /\ forall u, has k u pending = true -> has k u p = true \/ linked G (name t) (name u).
  Proof.
    induction fuel as [|fuel IH]; intros t from one back other pending p W I1 L1 I2 L2; [discriminate|]. simpl in W.
    destruct (without same from (beside one)) as [|u r] eqn:E.
    - injection W as <-. split; [|now left]. exists (name one). split; [exact L1|].
      apply without_nil in E. unfold G. destruct (Beside one I1) as [<- _]. exact E.
    - destruct (same t u); [discriminate|]. assert (J : In u (beside one)) by (apply (without_in from); rewrite E; now left).
      destruct (onward_inside one u I1 J) as [Iu Lu]. apply IH in W; auto; [|exact (linked_trans _ _ _ _ L1 Lu)].
      destruct W as [En D]. split; [exact En|]. intros v Hv.
      destruct (Nat.eq_dec (name v) (name u)) as [Q|Q]; [right; rewrite Q; exact (linked_trans _ _ _ _ L1 Lu)|].
      apply D. destruct L as (_ & _ & Drop). apply Drop. split; [congruence|exact Hv].
  Qed.

  Lemma fault_right fuel ts : forall pending, fault k same fuel beside ts pending = None -> (forall t, In t ts -> inside t) ->
    (forall t, In t ts -> has k t pending = true \/ has_end G (name t)) ->
    forall t, In t ts -> degree G (name t) <= 2 /\ has_end G (name t).
  Proof.
    induction ts as [|t ts IH]; intros pending F I P u J; [destruct J|]. simpl in F.
    assert (It : inside t) by (apply I; now left). destruct (Beside t It) as [D _].
    assert (Next : forall p, fault k same fuel beside ts p = None -> degree G (name t) <= 2 -> has_end G (name t) ->
      (forall v, In v ts -> has k v p = true \/ has_end G (name v)) -> degree G (name u) <= 2 /\ has_end G (name u)).
    { intros p E D2 En P'. destruct J as [<-|J]; [now split|]. apply (IH p E); auto. intros v K. apply I. now right. }
    assert (Small : length (beside t) <= 1 -> fault k same fuel beside ts pending = None -> degree G (name u) <= 2 /\ has_end G (name u)).
    { intros Le E. apply (Next pending E); [unfold G; lia|exists (name t); split; [apply here|unfold G; lia]|].
      intros v K. apply P. now right. }
    destruct (beside t) as [|a [|b [|c r]]] eqn:B; [apply Small; simpl; auto; fail|apply Small; simpl; auto; fail| |discriminate].
    assert (D2 : degree G (name t) <= 2) by (unfold G; simpl in D; lia).
    destruct (has k t pending) eqn:Ht.
    - destruct (walk k same beside fuel t t a t b (drop k a (drop k b pending))) as [p|] eqn:W; [|discriminate].
      destruct (onward_inside t a It) as [Ia La]; [rewrite B; now left|].
      destruct (onward_inside t b It) as [Ib Lb]; [rewrite B; right; now left|].
      apply walk_right in W; auto. destruct W as [En Dr]. apply (Next p F D2 En). intros v K.
      destruct (P v (or_intror K)) as [Hv|Hv]; [|now right].
      assert (Met : linked G (name t) (name v) -> has_end G (name v)).
      { intros A. apply has_end_linked with (name t); [now apply linked_sym|exact En]. }
      destruct (Nat.eq_dec (name v) (name a)) as [Q|Qa]; [right; apply Met; now rewrite Q|].
      destruct (Nat.eq_dec (name v) (name b)) as [Q|Qb]; [right; apply Met; now rewrite Q|].
      destruct (Dr v) as [A|A]; [|now left|right; now apply Met].
      destruct L as (_ & _ & Drop). apply Drop. split; [congruence|]. apply Drop. split; [congruence|exact Hv].
    - destruct (P t (or_introl eq_refl)) as [E|En]; [congruence|]. apply (Next pending F D2 En). intros v K. apply P. now right.
  Qed.
End Right.

Lemma named_degree {T} (name : T -> nat) es v : (forall t, In t (ends_of es) -> name t <> v) -> degree (named name es) v = 0.
Proof.
  intros N. apply degree_zero. intros e I. unfold named in I. apply in_map_iff in I as ([a b] & <- & I). simpl.
  split; apply N; unfold ends_of; apply in_flat_map; exists (a, b); simpl; auto.
Qed.
Lemma end_degree {T} (name : T -> nat) es kept G t : Permutation G (named name es ++ kept) -> In t (ends_of es) -> degree G (name t) <> 0.
Proof.
  intros P I. unfold ends_of in I. apply in_flat_map in I as ([a b] & I & J).
  assert (K : In (name a, name b) G).
  { apply (Permutation_in _ (Permutation_sym P)), in_or_app. left. unfold named. apply in_map_iff. now exists (a, b). }
  simpl in J. destruct J as [<-|[<-|[]]]; [apply adjacent_degree with (name b); now left|apply adjacent_degree with (name a); now right].
Qed.

Lemma has_end_perm G H v : Permutation G H -> has_end G v -> has_end H v.
Proof. intros P (x & A & D). exists x. split; [exact (linked_perm _ _ _ _ P A)|]. now rewrite <- (degree_perm _ _ x P). Qed.
Lemma injective_nodup {A B} (f : A -> B) l : (forall x y, f x = f y -> x = y) -> NoDup l -> NoDup (map f l).
Proof.
  intros Inj N. induction N as [|x l Nx N IH]; simpl; constructor; [|exact IH]. intros I. apply in_map_iff in I as (y & E & I).
  apply Inj in E. now subst.
Qed.

Theorem judge_step_right : Judge_step_right (@judge_step).
Proof.
  intros T S k same fuel lone beside gone come lost made strips alone E L name M M' Inj Sane Sane' Rep Lone Beside V.
  destruct Rep as (stay & kept & PF & PF' & PG & PG'). unfold judge_step in E.
  destruct (stays_right k L gone come lost made) as [Ns Is]. set (still := stays k gone come lost made) in *.
  set (news := rev_append come still) in *.
  assert (News : forall t, In t news <-> In t come \/ In t still).
  { intros t. unfold news. rewrite rev_append_rev, in_app_iff, <- in_rev. tauto. }
  destruct (fault k same fuel beside news (add_all k (none k) news)) as [w|] eqn:F.
  { destruct w; try discriminate. exfalso. revert F. generalize (add_all k (none k) news). clear. induction news as [|t r IH]; intros s F; [discriminate|].
    simpl in F. destruct (beside t) as [|a [|b [|c l]]]; try discriminate; try (now apply (IH s)).
    destruct (has k t s); [|now apply (IH s)]. destruct (walk _ _ _ _ _ _ _ _ _ _); [now apply (IH s0)|discriminate]. }
  injection E as E1 E2.
  assert (In_come : forall t, In (name t) (map name come) -> In t come).
  { intros t I. apply in_map_iff in I as (u & Q & I). apply Inj in Q. now subst. }
  assert (In_gone : forall t, In (name t) (map name gone) -> In t gone).
  { intros t I. apply in_map_iff in I as (u & Q & I). apply Inj in Q. now subst. }
  assert (NF : NoDup (map name gone ++ stay)) by exact (Permutation_NoDup PF (proj1 Sane)).
  assert (NF' : NoDup (map name come ++ stay)) by exact (Permutation_NoDup PF' (proj1 Sane')).
  apply nodup_app in NF as (_ & Nstay & Dg). apply nodup_app in NF' as (_ & _ & Dc).
  assert (Still : forall t, In t still -> In (name t) stay).
  { intros t I. apply Is in I as (I & Ng & Nc). apply in_app_or in I as [I|I].
    - assert (J : In (name t) (nodes M)) by (apply (proj2 Sane); exact (end_degree name lost kept _ t PG I)).
      apply (Permutation_in _ PF), in_app_or in J as [J|J]; [now apply In_gone in J|exact J].
    - assert (J : In (name t) (nodes M')) by (apply (proj2 Sane'); exact (end_degree name made kept _ t PG' I)).
      apply (Permutation_in _ PF'), in_app_or in J as [J|J]; [now apply In_come in J|exact J]. }
  assert (Touched : forall t, In t (ends_of lost ++ ends_of made) -> In (name t) stay -> In t still).
  { intros t I J. apply Is. split; [exact I|]. split; intros K; [apply (Dg (name t))|apply (Dc (name t))]; auto; now apply in_map. }
  assert (Same : forall v, In v stay -> ~ In v (map name still) -> degree (edges M) v = degree (edges M') v).
  { intros v I N. rewrite (degree_perm _ _ v PG), (degree_perm _ _ v PG'), !degree_app, !named_degree; [reflexivity| |];
      intros t J <-; apply N, in_map, Touched; auto; apply in_or_app; auto. }
  assert (Inside : forall t, In t news -> In (name t) (nodes M')).
  { intros t I. apply (Permutation_in _ (Permutation_sym PF')), in_or_app.
    apply News in I as [I|I]; [left; now apply in_map|right; now apply Still]. }
  assert (Good : forall t, In t news -> degree (edges M') (name t) <= 2 /\ has_end (edges M') (name t)).
  { apply (fault_right k L same name M' beside Sane' Beside fuel news _ F Inside). intros t I. left.
    apply (has_add_all k L). now left. }
  split; [|split].
  - apply (valid_perm _ _ (Permutation_sym PG')). apply ends_suffice with (named name lost); [exact (valid_perm _ _ PG V)| |].
    + intros v. rewrite <- (degree_perm _ _ v PG'). destruct (in_dec Nat.eq_dec v (nodes M')) as [I|I].
      * apply (Permutation_in _ PF'), in_app_or in I as [I|I].
        -- apply in_map_iff in I as (t & <- & I). apply Good, News. now left.
        -- destruct (in_dec Nat.eq_dec v (map name still)) as [J|J].
           ++ apply in_map_iff in J as (t & <- & J). apply Good, News. now right.
           ++ rewrite <- (Same v I J). apply V.
      * destruct (degree (edges M') v) eqn:Z; [lia|]. exfalso. apply I, (proj2 Sane'). congruence.
    + intros e I. left. apply (has_end_perm _ _ _ PG'). unfold named in I. apply in_map_iff in I as ([a b] & <- & I). simpl.
      assert (Ea : In a (ends_of made)) by (unfold ends_of; apply in_flat_map; exists (a, b); simpl; auto).
      apply Good, News. assert (J : In (name a) (nodes M')) by (apply (proj2 Sane'); exact (end_degree name made kept _ a PG' Ea)).
      apply (Permutation_in _ PF'), in_app_or in J as [J|J]; [left; now apply In_come|right].
      apply Touched; [apply in_or_app; now right|exact J].
  - rewrite !size_length in E1. unfold strips_of. apply Permutation_length in PF, PF', PG, PG'.
    unfold named in PG, PG'. rewrite !app_length, !map_length in PF, PF', PG, PG'. unfold graph, edge in *. lia.
  - change (isolated_in (edges M') (nodes M') = (isolated_in (edges M) (nodes M) + alone)%Z).
    rewrite (isolated_perm _ _ _ PF), (isolated_perm _ _ _ PF'), !isolated_app.
    destruct (rest_of (map name still) stay) as (o & Po).
    { now apply injective_nodup. }
    { intros v I. apply in_map_iff in I as (t & <- & I). now apply Still. }
    rewrite !(isolated_perm _ _ _ Po), !isolated_app.
    assert (No : forall v, In v o -> degree (edges M) v = degree (edges M') v).
    { intros v I. apply Same; [apply (Permutation_in _ (Permutation_sym Po)), in_or_app; now right|]. intros J.
      apply (Permutation_NoDup Po), nodup_app in Nstay as (_ & _ & D). exact (D v J I). }
    rewrite (isolated_same _ _ o No).
    rewrite (count_isolated name (edges M') _ news) in E2.
    2: { intros t I. destruct (Beside t (Inside t I)) as [D _]. rewrite <- D. now destruct (beside t). }
    rewrite (count_isolated name (edges M) lone gone) in E2.
    2: { intros t I. apply Lone, (Permutation_in _ (Permutation_sym PF)), in_or_app. left. now apply in_map. }
    rewrite (count_isolated name (edges M) lone still) in E2.
    2: { intros t I. apply Lone, (Permutation_in _ (Permutation_sym PF)), in_or_app. right. now apply Still. }
    unfold news in E2. rewrite rev_append_rev, map_app, isolated_app in E2.
    rewrite (isolated_perm (edges M') (map name (rev come)) (map name come)) in E2; [lia|].
    apply Permutation_map. symmetry. apply Permutation_rev.
Qed.
