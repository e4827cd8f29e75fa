(** * Linked ports are neighbours

    In a fan, closed or open, the strand from a solid port ends at the next solid port at the latest. So what is known of all
    ports is what a key says about neighbouring ones. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Strips Locality Drawing Checker Rows Symmetry Frontier Route.

(** Three edges at one vertex are too many. *)
Lemma three_edges G v e1 e2 e3 : In e1 G -> In e2 G -> In e3 G -> e1 <> e2 -> e1 <> e3 -> e2 <> e3 ->
  (forall e, e = e1 \/ e = e2 \/ e = e3 -> 1 <= meets e v) -> 3 <= degree G v.
Proof.
  intros I1 I2 I3 N12 N13 N23 M.
  assert (Sp : forall (e : edge) (L : graph), In e L -> exists L', Permutation L (e :: L')).
  { intros e L I. apply in_split in I as (A & B & ->). exists (A ++ B). symmetry. apply Permutation_middle. }
  destruct (Sp _ _ I1) as (G1 & P1). assert (J2 : In e2 G1).
  { apply (Permutation_in _ P1) in I2 as [E|I2]; [contradiction|exact I2]. }
  destruct (Sp _ _ J2) as (G2 & P2). assert (J3 : In e3 G2).
  { apply (Permutation_in _ P1) in I3 as [E|I3]; [contradiction|]. apply (Permutation_in _ P2) in I3 as [E|I3]; [contradiction|exact I3]. }
  destruct (Sp _ _ J3) as (G3 & P3). rewrite (degree_perm _ _ v P1), degree_cons, (degree_perm _ _ v P2), degree_cons, (degree_perm _ _ v P3), degree_cons.
  pose proof (M e1 ltac:(auto)). pose proof (M e2 ltac:(auto)). pose proof (M e3 ltac:(auto)). lia.
Qed.

Section Fan.
  Variables (d : side) (k : nat) (round : bool) (s c : coloring).
  Hypotheses (owners : owner d = seq 0 k) (enough : k <= triangles d) (size : 3 <= k \/ round = false) (ports_given : length s = k)
    (edges_of_fan : forall e, In e (inner d) -> (snd e = S (fst e) /\ snd e < k) \/ (round = true /\ fst e = k - 1 /\ snd e = 0)).
  Let G := drawing d s c.
  Hypothesis ok : valid G.

  Lemma port_there t : t < k -> nth t s false = true -> In (t, k + t) G.
  Proof.
    intros H E. unfold G, drawing. apply in_or_app. left. rewrite <- (ports_drawn d k (length (inner d)) 0 0 owners enough ltac:(lia) s ports_given).
    unfold ports_of. apply in_flat_map. exists t. split; [apply in_seq; lia|]. rewrite E. destruct (Nat.ltb_spec t k); [now left|lia].
  Qed.
  Lemma edge_kinds e : In e G -> (fst e < k /\ snd e = k + fst e) \/ (exists q, fst e = k + q /\ snd e = k + S q /\ S q < k) \/
    (round = true /\ fst e = k + (k - 1) /\ snd e = k).
  Proof.
    unfold G, drawing. intros I. apply in_app_or in I as [I|I]; apply solid_incl in I.
    - left. unfold port_edges in I. rewrite owners, seq_length in I. destruct e as [a b]. cbn [fst snd].
      assert (W : forall l, In (a, b) (combine l (map (fun t => k + t) l)) -> In a l /\ b = k + a).
      { induction l as [|x l IH]; intros J; [destruct J|]. destruct J as [J|J]; [injection J as <- <-; split; [now left|reflexivity]|].
        destruct (IH J). split; [now right|assumption]. }
      apply W in I as [I ->]. apply in_seq in I. lia.
    - right. unfold inner_edges in I. rewrite owners, seq_length in I. apply in_map_iff in I as (f & <- & I). cbn [fst snd].
      apply edges_of_fan in I as [[E B]|(R & E1 & E2)]; [left|right].
      + exists (fst f). rewrite E in *. lia.
      + rewrite E1, E2. repeat split; auto; lia.
  Qed.

  Definition place_of (v : nat) : nat := if v <? k then v else v - k.
  Definition within_region (lo hi v : nat) : Prop :=
    let p := place_of v in
    lo < p < hi \/ (p = lo /\ In (k + lo, k + S lo) G) \/ (p = hi /\ hi < k /\ exists q, hi = S q /\ In (k + q, k + hi) G).

  Lemma full t e1 e2 : t < k -> nth t s false = true -> In e1 G -> In e2 G -> e1 <> e2 ->
    (fst e1 = k + t \/ snd e1 = k + t) -> (fst e2 = k + t \/ snd e2 = k + t) -> k <= fst e1 -> k <= fst e2 -> False.
  Proof.
    intros Ht E I1 I2 N M1 M2 K1 K2. assert (D : 3 <= degree G (k + t)).
    { apply three_edges with (t, k + t) e1 e2; auto using port_there; try (intros Q; rewrite <- Q in *; cbn [fst] in *; lia).
      intros e [->|[->| ->]]; unfold meets; cbn [fst snd]; [rewrite Nat.eqb_refl; destruct (t =? k + t); lia|..].
      - destruct (Nat.eqb_spec (fst e1) (k + t)), (Nat.eqb_spec (snd e1) (k + t)); lia.
      - destruct (Nat.eqb_spec (fst e2) (k + t)), (Nat.eqb_spec (snd e2) (k + t)); lia. }
    pose proof (proj1 ok (k + t)). lia.
  Qed.

  (** A strand between two solid ports stays there. *)
  Lemma region_kept lo hi x : lo < x < hi -> nth lo s false = true -> (hi < k /\ nth hi s false = true \/ hi = k /\ round = false) ->
    forall v, linked G x v -> within_region lo hi v.
  Proof.
    intros Hx El Eh. assert (Hk : hi <= k) by lia. intros v L. induction L as [|v w L IH A].
    - left. unfold place_of. destruct (Nat.ltb_spec x k); lia.
    - assert (W : exists e, In e G /\ ((fst e = v /\ snd e = w) \/ (fst e = w /\ snd e = v))).
      { destruct A as [A|A]; eexists; (split; [exact A|]); cbn; auto. }
      destruct W as (e & I & M). pose proof (edge_kinds e I) as Ek. destruct e as [a b]. cbn [fst snd] in *.
      assert (Pt : forall t, place_of (k + t) = t) by (intros t; unfold place_of; destruct (Nat.ltb_spec (k + t) k); lia).
      destruct Ek as [(Ha & ->)|[(q & -> & -> & Hq)|(R & -> & ->)]].
      + (* a port *)
        assert (Q : place_of v = place_of w).
        { destruct M as [(<- & <-)|(<- & <-)]; rewrite Pt; unfold place_of; destruct (Nat.ltb_spec a k); lia. }
        unfold within_region in *. now rewrite <- Q.
      + (* along the fan *)
        destruct M as [(<- & <-)|(<- & <-)]; unfold within_region in *; rewrite Pt in *.
        * destruct IH as [B|[(-> & B)|(B & Hh & q' & E & J)]].
          -- destruct (Nat.eq_dec (S q) hi) as [<-|N]; [|left; lia]. right. right. split; [reflexivity|]. split; [lia|]. now exists q.
          -- destruct (Nat.eq_dec (S lo) hi) as [<-|N]; [lia|left; lia].
          -- exfalso. subst q. destruct Eh as [[_ Eh]|[? _]]; [|lia]. apply (full hi (k + q', k + hi) (k + hi, k + S hi)); cbn [fst snd]; auto; try lia.
             intros Q. injection Q. lia.
        * destruct IH as [B|[(B & J)|(B & Hh & q' & E & J)]].
          -- destruct (Nat.eq_dec q lo) as [->|N]; [right; left; auto|left; lia].
          -- exfalso. apply (full lo (k + lo, k + S lo) (k + q, k + S q)); cbn [fst snd]; auto; try lia. intros Q. injection Q. lia.
          -- rewrite E in B. injection B as ->. destruct (Nat.eq_dec q' lo) as [->|N]; [lia|left; lia].
      + (* round the fan *)
        assert (K3 : 3 <= k) by (destruct size; congruence || lia).
        destruct M as [(<- & <-)|(<- & <-)]; unfold within_region in *; replace (place_of k) with 0 in * by (unfold place_of; destruct (Nat.ltb_spec k k); lia); rewrite ?Pt in *.
        * exfalso. destruct IH as [B|[(B & J)|(B & Hh & q' & E & J)]]; [destruct Eh as [[? _]|[_ ?]]; [lia|congruence]|lia|]. destruct Eh as [[_ Eh]|[? _]]; [|lia].
          apply (full hi (k + q', k + hi) (k + (k - 1), k)); cbn [fst snd]; auto; try lia. intros Q. injection Q. lia.
        * exfalso. destruct IH as [B|[(B & J)|(B & Hh & q' & E & J)]]; [lia| |lia].
          apply (full lo (k + lo, k + S lo) (k + (k - 1), k)); cbn [fst snd]; auto; try lia. intros Q. injection Q. lia.
  Qed.
  Lemma region_port lo hi v : v < k -> lo < hi -> within_region lo hi v -> lo <= v <= hi.
  Proof. intros H O. unfold within_region, place_of. destruct (Nat.ltb_spec v k); [|lia]. intros [W|[[W _]|[W _]]]; lia. Qed.

  Theorem neighbours i j : i < j < k -> linked G i j ->
    (forall m, i < m < j -> nth m s false = false) \/ (round = true /\ forall m, m < k -> m < i \/ j < m -> nth m s false = false).
  Proof.
    intros H L. destruct (existsb (fun m => nth m s false) (seq (S i) (j - S i))) eqn:B.
    - apply existsb_exists in B as (m & I & E). apply in_seq in I. right. destruct (Bool.bool_dec round true) as [R|R]; [|apply not_true_is_false in R].
      + split; [exact R|]. intros m' Hm' O. destruct (nth m' s false) eqn:E'; [exfalso|reflexivity]. destruct O as [O|O].
        * pose proof (region_kept m' m i ltac:(lia) E' ltac:(left; split; [lia|exact E]) j L) as W. apply region_port in W; lia.
        * pose proof (region_kept m m' j ltac:(lia) E ltac:(left; split; [lia|exact E']) i (linked_sym _ _ _ L)) as W. apply region_port in W; lia.
      + exfalso. pose proof (region_kept m k j ltac:(lia) E ltac:(right; split; [reflexivity|exact R]) i (linked_sym _ _ _ L)) as W. apply region_port in W; lia.
    - left. intros m Hm. destruct (nth m s false) eqn:E; [|reflexivity]. exfalso.
      assert (Q : existsb (fun m => nth m s false) (seq (S i) (j - S i)) = true) by (apply existsb_exists; exists m; split; [apply in_seq; lia|exact E]).
      congruence.
  Qed.
End Fan.
