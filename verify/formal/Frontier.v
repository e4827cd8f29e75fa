(** * Drawing a fan triangle by triangle

    [Drawing.v] keeps a book about every vertex. In a fan, all but two vertices can be forgotten on the way: the triangle
    at the *tip* of what is drawn so far, to which the next one is joined, and an *anchor* further back, to which the last
    triangle (or A, by the chord) is joined at the end. Of these two it matters how many solid edges they have, which port
    their strands lead to, and whether they are on the same strand. A port is known by its label: two ports may be
    linked when their labels are equal. That is all there is to know about an arc of any length. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph Drawing.

(** ** The books

    A place without room (degree two) has nothing more to say; its port is forgotten, too. *)
Record place := Place { deg : nat; port : option nat }.
Record frontier := Frontier { anchor : place; tip : place; same : bool }.

(** What can be drawn next. [Put]: a triangle that is joined to nothing drawn so far; it is the new tip. [Next]: a
    triangle with a dual edge to the tip; it is the new tip. [Mark]: the same, and the old tip is the new anchor. [Chord]: an
    edge between tip and anchor. The argument is the label of the new triangle's port, if that is solid. *)
Inductive step := Put (p : option nat) | Next (p : option nat) | Mark (p : option nat) | Chord.

Definition fresh (p : option nat) : place := match p with Some _ => Place 1 p | None => Place 0 None end.
Definition agree (l m : option nat) : bool := match l, m with Some a, Some b => a =? b | _, _ => true end.
Definition either (l m : option nat) : option nat := match l with Some _ => l | None => m end.
Definition open_end (x : place) : bool := deg x <? 2.
Definition tidy_place (x : place) : place := if open_end x then x else Place (deg x) None.
Definition tidy (f : frontier) : frontier :=
  Frontier (tidy_place (anchor f)) (tidy_place (tip f)) (same f && open_end (anchor f) && open_end (tip f)).
Definition more (x : place) (l : option nat) : place := Place (S (deg x)) l.

(** The step's edge is solid ([true]) or dashed. [None]: that is not legal. *)
Definition take (s : step) (b : bool) (f : frontier) : option frontier :=
  match s with
  | Put p => if b then None else Some (Frontier (anchor f) (fresh p) false)
  | Next p =>
      let l := either (port (tip f)) p in
      if b then
        if open_end (tip f) && agree (port (tip f)) p
        then Some (tidy (Frontier (if same f then Place (deg (anchor f)) l else anchor f) (more (fresh p) l) (same f)))
        else None
      else Some (Frontier (anchor f) (fresh p) false)
  | Mark p =>
      let l := either (port (tip f)) p in
      if b then
        if open_end (tip f) && agree (port (tip f)) p
        then Some (tidy (Frontier (more (tip f) l) (more (fresh p) l) true))
        else None
      else Some (Frontier (tip f) (fresh p) false)
  | Chord =>
      let l := either (port (anchor f)) (port (tip f)) in
      if b then
        if open_end (anchor f) && open_end (tip f) && negb (same f) && agree (port (anchor f)) (port (tip f))
        then Some (tidy (Frontier (more (anchor f) l) (more (tip f) l) true))
        else None
      else Some f
  end.

(** How many of the triangles that are forgotten in this step are isolated, and how many of the last two. *)
Definition lone (n : nat) : nat := if n =? 0 then 1 else 0.
Definition left_alone (s : step) (b : bool) (f : frontier) : nat :=
  match s with
  | Put _ => lone (deg (tip f))
  | Next _ => if b then 0 else lone (deg (tip f))
  | Mark _ => lone (deg (anchor f))
  | Chord => 0
  end.
Definition at_end (f : frontier) : nat := lone (deg (anchor f)) + lone (deg (tip f)).

(** At the beginning, tip and anchor are two vertices that are not triangles; nothing will ever be joined to them. *)
Definition blank_frontier : frontier := Frontier (Place 0 None) (Place 0 None) false.

(** [c] gives a colour to the edge of each step; the result is the frontier, the number of solid edges and the number of
    forgotten vertices without any. *)
Fixpoint play (ss : list step) (c : coloring) (f : frontier) (n i : nat) : option (frontier * (nat * nat)) :=
  match ss, c with
  | [], [] => Some (f, (n, i))
  | s :: ss', b :: c' =>
      match take s b f with
      | Some g => play ss' c' g (if b then S n else n) (i + left_alone s b f)
      | None => None
      end
  | _, _ => None
  end.

Lemma open_room x : open_end x = true -> deg x < 2.
Proof. apply Nat.ltb_lt. Qed.

Lemma fresh_room p : deg (fresh p) < 2. Proof. destruct p; simpl; lia. Qed.
Lemma fresh_port p : port (fresh p) = p. Proof. now destruct p. Qed.

(** ** What the books mean *)
Section Meaning.
  Variables (k : nat) (lab : nat -> nat).

  (** Valid, and only ports with the same label are linked. *)
  Definition allowed (G : graph) : Prop := valid G /\ forall i j, i < k -> j < k -> linked G i j -> lab i = lab j.

  Definition leads_to (G : graph) (v : nat) (p : option nat) : Prop :=
    match p with
    | None => forall i, i < k -> ~ linked G v i
    | Some l => exists i, i < k /\ linked G v i /\ lab i = l
    end.
  Definition seen (G : graph) (v : nat) (x : place) : Prop := degree G v = deg x /\ (deg x < 2 -> leads_to G v (port x)).

  Lemma allowed_tail e G : allowed (e :: G) -> allowed G.
  Proof.
    intros [V L]. split; [exact (valid_tail _ _ V)|]. intros i j Hi Hj H. apply L; auto.
    apply linked_mono with G; [intros f; now right|exact H].
  Qed.
  Lemma allowed_suffix H G : allowed (H ++ G) -> allowed G.
  Proof. induction H as [|e H IH]; [auto|]. intros A. exact (IH (allowed_tail _ _ A)). Qed.
  Lemma allowed_perm G H : Permutation G H -> allowed G -> allowed H.
  Proof.
    intros P [V L]. split; [exact (valid_perm _ _ P V)|]. intros i j Hi Hj I. apply L; auto.
    exact (linked_perm _ _ _ _ (Permutation_sym P) I).
  Qed.

  Lemma lonely_linked G u v : degree G u = 0 -> linked G v u -> u = v.
  Proof.
    intros D L. destruct L as [|v' w L A]; [reflexivity|]. exfalso. clear L. induction G as [|[a b] G IH]; [destruct A as [[]|[]]|].
    rewrite degree_cons in D. unfold meets in D. cbn [fst snd] in D.
    destruct (Nat.eqb_spec a w), (Nat.eqb_spec b w); try lia.
    apply IH; [lia|]. destruct A as [[A|A]|[A|A]]; try (injection A as ? ?; congruence); [now left|now right].
  Qed.

  (** Everything linked to [v] that is a port has the label that [v] leads to. *)
  Lemma leads_label G v p i : allowed G -> leads_to G v p -> i < k -> linked G v i -> p = Some (lab i).
  Proof.
    intros [_ A] L Hi I. destruct p as [l|]; [|now destruct (L i Hi)]. destruct L as (j & Hj & J & <-). f_equal.
    apply A; auto. apply linked_trans with v; [now apply linked_sym|exact I].
  Qed.

  Lemma leads_linked G v w p : linked G v w -> leads_to G v p -> leads_to G w p.
  Proof.
    intros L. destruct p as [l|]; simpl.
    - intros (i & Hi & I & E). exists i. repeat split; auto. apply linked_trans with v; [now apply linked_sym|exact I].
    - intros N i Hi I. apply (N i Hi). now apply linked_trans with w.
  Qed.

  Lemma join_others G a b v : ~ linked G v a -> ~ linked G v b -> forall w, linked ((a, b) :: G) v w <-> linked G v w.
  Proof. intros Na Nb w. rewrite linked_cons. tauto. Qed.
  Lemma join_degree G a b v : v <> a -> v <> b -> degree ((a, b) :: G) v = degree G v.
  Proof.
    intros Ha Hb. rewrite degree_cons. unfold meets. cbn [fst snd].
    destruct (Nat.eqb_spec a v), (Nat.eqb_spec b v); congruence || lia.
  Qed.

  Section Join.
    Variables (G : graph) (a b : nat) (x y : place).
    Hypotheses (A : allowed G) (Sa : seen G a x) (Sb : seen G b y).

    (** An edge between [a] and [b], of which we know whether they are linked. *)
    Lemma join_refused sm : (deg x < 2 -> deg y < 2 -> (sm = true <-> linked G a b)) ->
      open_end x && open_end y && negb sm && agree (port x) (port y) = false -> ~ allowed ((a, b) :: G).
    Proof.
      intros L F [V K]. destruct Sa as [Da La], Sb as [Db Lb]. unfold open_end in F.
      apply valid_cons in V as (_ & Va & Vb & N). rewrite Da in Va. rewrite Db in Vb.
      destruct (Nat.ltb_spec (deg x) 2); [|lia]. destruct (Nat.ltb_spec (deg y) 2); [|lia]. cbn [andb] in F.
      specialize (La ltac:(assumption)). specialize (Lb ltac:(assumption)). specialize (L ltac:(assumption) ltac:(assumption)).
      destruct sm; [now apply N, L|]. cbn [andb negb] in F.
      destruct (port x) as [l|], (port y) as [m|]; try discriminate F. cbn [agree] in F. apply Nat.eqb_neq in F. apply F.
      destruct La as (i & Hi & I & <-), Lb as (j & Hj & J & <-). apply K; auto. apply linked_cons. right. left.
      split; [now apply linked_sym|exact J].
    Qed.

    Hypotheses (Ox : deg x < 2) (Oy : deg y < 2) (N : ~ linked G a b) (C : agree (port x) (port y) = true).
    Let l := either (port x) (port y).
    Let G' := (a, b) :: G.

    Lemma labels_agree i j : i < k -> j < k -> linked G a i -> linked G b j -> lab i = lab j.
    Proof.
      intros Hi Hj I J. pose proof (leads_label G a (port x) i A (proj2 Sa Ox) Hi I) as P.
      pose proof (leads_label G b (port y) j A (proj2 Sb Oy) Hj J) as Q. rewrite P, Q in C. now apply Nat.eqb_eq.
    Qed.

    Lemma join_allowed : allowed G'.
    Proof.
      split.
      - apply valid_cons. rewrite (proj1 Sa), (proj1 Sb). repeat split; auto; try apply A; lia.
      - intros i j Hi Hj L. apply linked_cons in L as [L|[[L M]|[L M]]]; [now apply A| |].
        + apply labels_agree; auto. now apply linked_sym.
        + symmetry. apply labels_agree; auto. now apply linked_sym.
    Qed.

    (** What the joined strand leads to, seen from any vertex of it. *)
    Lemma join_leads v : linked G v a \/ linked G v b -> leads_to G' v l.
    Proof.
      intros V. assert (W : forall p q, linked G p q -> linked G' p q) by (intros p q; apply linked_mono; intros e; now right).
      assert (E : linked G' a b) by (apply linked_edge; left; now left).
      assert (Va : linked G' v a).
      { destruct V as [V|V]; [now apply W|]. apply linked_trans with b; [now apply W|now apply linked_sym]. }
      assert (Vb : linked G' v b) by (now apply linked_trans with a).
      pose proof (proj2 Sa Ox) as La. pose proof (proj2 Sb Oy) as Lb. unfold l. destruct (port x) as [n|]; cbn [either].
      - destruct La as (i & Hi & I & Li). exists i. repeat split; auto. apply linked_trans with a; auto.
      - destruct (port y) as [n|].
        + destruct Lb as (i & Hi & I & Li). exists i. repeat split; auto. apply linked_trans with b; auto.
        + intros i Hi I. apply linked_cons in I.
          assert (Ca : ~ linked G a i) by (now apply La). assert (Cb : ~ linked G b i) by (now apply Lb).
          destruct I as [I|[[_ I]|[_ I]]]; try contradiction.
          destruct V as [V|V]; [apply Ca|apply Cb]; apply linked_trans with v; auto; now apply linked_sym.
    Qed.

    Lemma join_seen_left : a <> b -> seen G' a (more x l).
    Proof.
      intros H. split.
      - unfold G'. rewrite degree_cons, (proj1 Sa). unfold meets. cbn [fst snd more deg]. rewrite Nat.eqb_refl.
        destruct (Nat.eqb_spec b a); [congruence|lia].
      - intros _. apply join_leads. left. apply here.
    Qed.
    Lemma join_seen_right : a <> b -> seen G' b (more y l).
    Proof.
      intros H. split.
      - unfold G'. rewrite degree_cons, (proj1 Sb). unfold meets. cbn [fst snd more deg]. rewrite Nat.eqb_refl.
        destruct (Nat.eqb_spec a b); [congruence|lia].
      - intros _. apply join_leads. right. apply here.
    Qed.
  End Join.

  (** A new vertex [n] with its port point [i], when that is solid. *)
  Definition port_edge (p : option nat) (i n : nat) : graph := match p with Some _ => [(i, n)] | None => [] end.

  Section Introduce.
    Variables (G : graph) (p : option nat) (i n : nat).
    Hypotheses (A : allowed G) (Hn : k <= n) (Dn : degree G n = 0)
      (Hp : match p with Some l => i < k /\ l = lab i /\ degree G i = 0 | None => True end).
    Let G' := port_edge p i n ++ G.

    Lemma new_linked v w : k <= v -> k <= w -> v <> n -> (linked G' v w <-> linked G v w).
    Proof.
      intros Hv Hw Nv. unfold G', port_edge. destruct p as [l|]; [|reflexivity]. destruct Hp as (Hi & _ & Di). simpl.
      rewrite linked_cons. split; [|tauto]. intros [L|[[L _]|[L _]]]; [exact L| |];
        exfalso; apply lonely_linked in L; auto; lia.
    Qed.
    Lemma new_ports v j : k <= v -> v <> n -> j < k -> (linked G' v j <-> linked G v j).
    Proof.
      intros Hv Nv Hj. unfold G', port_edge. destruct p as [l|]; [|reflexivity]. destruct Hp as (Hi & _ & Di). simpl.
      rewrite linked_cons. split; [|tauto]. intros [L|[[L _]|[L _]]]; [exact L| |];
        exfalso; apply lonely_linked in L; auto; lia.
    Qed.
    Lemma new_apart v : k <= v -> v <> n -> ~ linked G' v n.
    Proof. intros Hv Nv L. apply new_linked in L; auto. apply lonely_linked in L; auto. Qed.

    Lemma new_allowed : allowed G'.
    Proof.
      unfold G', port_edge. destruct p as [l|]; [|exact A]. destruct Hp as (Hi & _ & Di). simpl. split.
      - apply valid_cons. rewrite Dn, Di. repeat split; try apply A; auto. intros L. apply lonely_linked in L; auto. lia.
      - intros j m Hj Hm L. apply linked_cons in L as [L|[[L M]|[L M]]]; [now apply A| |].
        + apply linked_sym, lonely_linked in M; auto. lia.
        + apply lonely_linked in L; auto. lia.
    Qed.
    Lemma new_degree v : v <> n -> k <= v -> degree G' v = degree G v.
    Proof.
      intros Nv Hv. unfold G', port_edge. destruct p as [l|]; [|reflexivity]. destruct Hp as (Hi & _ & _). simpl.
      rewrite degree_cons. unfold meets. cbn [fst snd]. destruct (Nat.eqb_spec i v), (Nat.eqb_spec n v); lia.
    Qed.
    Lemma new_seen v x : v <> n -> k <= v -> seen G v x -> seen G' v x.
    Proof.
      intros Nv Hv [D L]. split; [now rewrite new_degree|]. intros O. specialize (L O). destruct (port x) as [l|].
      - destruct L as (j & Hj & J & E). exists j. repeat split; auto. now apply new_ports.
      - intros j Hj J. apply new_ports in J; auto. exact (L j Hj J).
    Qed.
    Lemma new_fresh : seen G' n (fresh p).
    Proof.
      unfold G', port_edge. destruct p as [l|]; simpl.
      - destruct Hp as (Hi & -> & Di). split.
        + rewrite degree_cons, Dn. unfold meets. simpl. rewrite Nat.eqb_refl. destruct (Nat.eqb_spec i n); [lia|reflexivity].
        + intros _. exists i. repeat split; auto. apply linked_edge. right. now left.
      - split; [exact Dn|]. intros _ j Hj L. apply linked_sym, lonely_linked in L; auto. lia.
    Qed.
  End Introduce.

  Lemma seen_tidy G v x : seen G v x -> seen G v (tidy_place x).
  Proof.
    intros [D L]. unfold tidy_place, open_end. destruct (Nat.ltb_spec (deg x) 2); split; auto. simpl. lia.
  Qed.
  Lemma tidy_deg x : deg (tidy_place x) = deg x.
  Proof. unfold tidy_place. now destruct (open_end x). Qed.

  (** ** Drawing

      What has been drawn: the graph, where anchor and tip are, and the vertices that are forgotten. *)
  Record picture := Drawn { graph_of : graph; at_anchor : nat; at_tip : nat; gone : list nat }.
  (** A step, with the vertex it introduces and the point of that vertex's port. *)
  Record move := Move { what : step; vertex : nat; point : nat }.

  Definition label_of (s : step) : option nat := match s with Put p | Next p | Mark p => p | Chord => None end.
  Definition edge_of (m : move) (d : picture) : edge :=
    match what m with Chord => (at_anchor d, at_tip d) | _ => (at_tip d, vertex m) end.
  Definition draw_move (m : move) (b : bool) (d : picture) : picture :=
    let G := (if b then [edge_of m d] else []) ++ match what m with Chord => [] | s => port_edge (label_of s) (point m) (vertex m) end
               ++ graph_of d in
    match what m with
    | Put _ | Next _ => Drawn G (at_anchor d) (vertex m) (at_tip d :: gone d)
    | Mark _ => Drawn G (at_tip d) (vertex m) (at_anchor d :: gone d)
    | Chord => Drawn G (at_anchor d) (at_tip d) (gone d)
    end.

  Definition alone_in (G : graph) (vs : list nat) : nat := length (filter (fun v => degree G v =? 0) vs).

  (** The books [f] and [i] are right about [d]; the vertices not in [used] have not been touched. *)
  Definition right (used : list nat) (d : picture) (f : frontier) (i : nat) : Prop :=
    allowed (graph_of d) /\ at_anchor d <> at_tip d /\ k <= at_anchor d /\ k <= at_tip d /\
    seen (graph_of d) (at_anchor d) (anchor f) /\ seen (graph_of d) (at_tip d) (tip f) /\
    (deg (anchor f) < 2 -> deg (tip f) < 2 -> (same f = true <-> linked (graph_of d) (at_anchor d) (at_tip d))) /\
    i = alone_in (graph_of d) (gone d) /\
    (forall v, degree (graph_of d) v <> 0 -> In v used) /\
    In (at_anchor d) used /\ In (at_tip d) used /\ incl (gone d) used /\ (forall v, In v (gone d) -> k <= v) /\
    ~ In (at_anchor d) (gone d) /\ ~ In (at_tip d) (gone d).

  (** A move is new when its vertex and its port point have not been used. *)
  Definition new_move (used : list nat) (m : move) : Prop :=
    match what m with
    | Chord => True
    | s => k <= vertex m /\ ~ In (vertex m) used /\
           match label_of s with Some l => point m < k /\ l = lab (point m) /\ ~ In (point m) used | None => True end
    end.
  Definition use (m : move) (used : list nat) : list nat :=
    match what m with Chord => used | _ => vertex m :: point m :: used end.
  Definition feasible (s : step) (b : bool) : Prop := match s with Put _ => b = false | _ => True end.

  Lemma alone_same G G' vs : (forall v, In v vs -> degree G' v = degree G v) -> alone_in G' vs = alone_in G vs.
  Proof.
    intros E. unfold alone_in. f_equal. apply filter_ext_in. intros v I. now rewrite E.
  Qed.
  Lemma alone_cons G v vs : alone_in G (v :: vs) = alone_in G vs + lone (degree G v).
  Proof. unfold alone_in, lone. simpl. destruct (degree G v =? 0); simpl; lia. Qed.

  Section Move.
    Variables (used : list nat) (d : picture) (f : frontier) (i : nat) (p : option nat) (n q : nat).
    Hypotheses (R : right used d f i) (Hn : k <= n) (Nn : ~ In n used)
      (Hp : match p with Some l => q < k /\ l = lab q /\ ~ In q used | None => True end).
    Let G := graph_of d.
    Let G1 := port_edge p q n ++ G.
    Let a := at_anchor d.
    Let t := at_tip d.

    Lemma unused v : ~ In v used -> degree G v = 0.
    Proof.
      intros N. destruct R as (_ & _ & _ & _ & _ & _ & _ & _ & U & _). destruct (Nat.eq_dec (degree G v) 0) as [E|E]; [exact E|].
      now contradiction N; apply U.
    Qed.
    Let Dn : degree G n = 0 := unused n Nn.
    Let Hp' : match p with Some l => q < k /\ l = lab q /\ degree G q = 0 | None => True end.
    Proof. destruct p; [|exact I]. destruct Hp as (Hq & E & Nq). auto using unused. Qed.
    Let A : allowed G. Proof. apply R. Qed.
    Lemma tip_not_new : t <> n. Proof. intros E. apply Nn. rewrite <- E. now destruct R as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & U & _). Qed.
    Lemma anchor_not_new : a <> n. Proof. intros E. apply Nn. rewrite <- E. now destruct R as (_ & _ & _ & _ & _ & _ & _ & _ & _ & U & _). Qed.
    Let Ha : k <= a. Proof. now destruct R as (_ & _ & H & _). Qed.
    Let Ht : k <= t. Proof. now destruct R as (_ & _ & _ & H & _). Qed.
    Lemma port_allowed : allowed G1. Proof. now apply new_allowed. Qed.
    Lemma port_tip : seen G1 t (tip f). Proof. apply new_seen; auto using tip_not_new. apply R. Qed.
    Lemma port_anchor : seen G1 a (anchor f). Proof. apply new_seen; auto using anchor_not_new. apply R. Qed.
    Lemma port_new : seen G1 n (fresh p). Proof. now apply new_fresh. Qed.
    Lemma tip_apart : ~ linked G1 t n. Proof. apply new_apart; auto using tip_not_new. Qed.
    Lemma anchor_apart : ~ linked G1 a n. Proof. apply new_apart; auto using anchor_not_new. Qed.
    Lemma port_same : deg (anchor f) < 2 -> deg (tip f) < 2 -> (same f = true <-> linked G1 a t).
    Proof. intros O1 O2. unfold G1. rewrite new_linked by auto using anchor_not_new. now apply R. Qed.
    Lemma port_degree v : k <= v -> v <> n -> degree G1 v = degree G v.
    Proof. intros Hv N. now apply new_degree. Qed.
    Lemma port_used v : degree G1 v <> 0 -> In v (n :: q :: used).
    Proof.
      intros D. destruct (Nat.eq_dec n v) as [->|]; [now left|]. destruct (Nat.eq_dec q v) as [->|]; [right; now left|].
      right. right. destruct R as (_ & _ & _ & _ & _ & _ & _ & _ & U & _). apply U. intros E. apply D. unfold G1, port_edge.
      destruct p; [|exact E]. simpl. rewrite degree_cons. fold G in E. rewrite E. unfold meets. cbn [fst snd].
      destruct (Nat.eqb_spec q v), (Nat.eqb_spec n v); try congruence. reflexivity.
    Qed.

    (** Without an edge: [a'] is the anchor from now on, [o] is forgotten. *)
    Lemma right_dashed a' o x : (a' = a /\ o = t /\ x = anchor f) \/ (a' = t /\ o = a /\ x = tip f) ->
      right (n :: q :: used) (Drawn G1 a' n (o :: gone d)) (Frontier x (fresh p) false)
        (i + lone (degree G1 o)).
    Proof.
      intros C. pose proof R as (_ & Nat_ & _ & _ & _ & _ & _ & Ei & _ & Ua & Ut & Ug & Kg & Ga & Gt).
      fold G a t in Nat_, Ei, Ua, Ut, Ga, Gt. unfold right. cbn [graph_of at_anchor at_tip gone anchor tip same].
      assert (Q : a' <> n /\ k <= a' /\ seen G1 a' x /\ ~ linked G1 a' n /\ In a' used /\ In o used /\ k <= o /\ a' <> o /\ ~ In a' (gone d)).
      { destruct C as [(-> & -> & ->)|(-> & -> & ->)].
        - repeat split; auto using anchor_not_new, anchor_apart; apply port_anchor.
        - repeat split; auto using tip_not_new, tip_apart; apply port_tip. }
      destruct Q as (Q1 & Q2 & Q3 & Q4 & Q5 & Q6 & Q7 & Q8 & Q9).
      split; [exact port_allowed|]. split; [exact Q1|]. split; [exact Q2|]. split; [exact Hn|]. split; [exact Q3|].
      split; [exact port_new|]. split; [intros _ _; split; [discriminate|contradiction]|].
      split.
      { rewrite alone_cons. f_equal. rewrite Ei. symmetry. apply alone_same. intros v I. apply port_degree; [now apply Kg|].
        intros ->. apply Nn. now apply Ug. }
      split; [exact port_used|]. split; [right; now right|]. split; [now left|].
      split; [intros v [<-|I]; right; right; auto|]. split; [intros v [<-|I]; auto|].
      split; [intros [E|I]; [now apply Q8|contradiction]|].
      intros [E|I]; [apply Nn; now rewrite <- E|]. apply Nn. now apply Ug.
    Qed.

    (** With an edge between the tip and the new triangle. *)
    Section Solid.
      Hypotheses (O : deg (tip f) < 2) (C : agree (port (tip f)) p = true).
      Let l := either (port (tip f)) p.
      Let G2 := (t, n) :: G1.
      Lemma solid_allowed : allowed G2.
      Proof.
        apply (join_allowed G1 t n (tip f) (fresh p)); auto using port_allowed, port_tip, port_new, fresh_room, tip_apart.
        now rewrite fresh_port.
      Qed.
      Lemma solid_tip : seen G2 t (more (tip f) l).
      Proof.
        unfold l. rewrite <- (fresh_port p) at 1.
        apply (join_seen_left G1 t n (tip f) (fresh p)); auto using port_tip, port_new, fresh_room, tip_not_new; now rewrite fresh_port.
      Qed.
      Lemma solid_new : seen G2 n (more (fresh p) l).
      Proof.
        unfold l. rewrite <- (fresh_port p) at 2.
        apply (join_seen_right G1 t n (tip f) (fresh p)); auto using port_tip, port_new, fresh_room, tip_not_new; now rewrite fresh_port.
      Qed.
      Lemma solid_anchor : seen G2 a (if same f then Place (deg (anchor f)) l else anchor f).
      Proof.
        assert (D : degree G2 a = deg (anchor f)).
        { unfold G2. rewrite join_degree; [apply port_anchor|apply R|apply anchor_not_new]. }
        destruct (same f) eqn:E; split; auto.
        - intros Oa. cbn [deg] in Oa. cbn [port]. unfold l. rewrite <- (fresh_port p) at 1.
          apply (join_leads G1 t n (tip f) (fresh p)); auto using port_tip, port_new, fresh_room; [now rewrite fresh_port|].
          left. now apply port_same.
        - intros Oa. pose proof (proj2 port_anchor Oa) as L.
          assert (N : ~ linked G1 a t) by (intros I; apply port_same in I; congruence || auto).
          destruct (port (anchor f)) as [m|]; simpl in *.
          + destruct L as (j & Hj & I & Ej). exists j. repeat split; auto. now apply join_others; auto using anchor_apart.
          + intros j Hj I. apply join_others in I; auto using anchor_apart. exact (L j Hj I).
      Qed.
      Lemma solid_same : deg (anchor f) < 2 -> (same f = true <-> linked G2 a n).
      Proof.
        intros Oa. rewrite (port_same Oa O). unfold G2. rewrite linked_cons. split.
        - intros I. right. left. split; [exact I|apply here].
        - intros [I|[[I _]|[I _]]]; [now apply anchor_apart in I|exact I|now apply anchor_apart in I].
      Qed.
      Lemma solid_used v : degree G2 v <> 0 -> In v (n :: q :: used).
      Proof.
        intros D. destruct (Nat.eq_dec v t) as [->|N1]; [right; right; now destruct R as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & U & _)|]. destruct (Nat.eq_dec v n) as [->|N2]; [now left|].
        unfold G2 in D. rewrite join_degree in D by auto. now apply port_used.
      Qed.
      Lemma solid_gone : alone_in G2 (gone d) = i.
      Proof.
        pose proof R as (_ & _ & _ & _ & _ & _ & _ & Ei & _ & _ & _ & Ug & Kg & _ & Gt). rewrite Ei. apply alone_same. intros v I.
        assert (v <> n) by (intros ->; apply Nn; now apply Ug). assert (v <> t) by (intros ->; contradiction).
        unfold G2. rewrite join_degree by auto. apply port_degree; auto.
      Qed.

      Lemma right_solid_next :
        right (n :: q :: used) (Drawn G2 a n (t :: gone d))
          (tidy (Frontier (if same f then Place (deg (anchor f)) l else anchor f) (more (fresh p) l) (same f))) i.
      Proof.
        pose proof R as (_ & Nat_ & _ & _ & _ & _ & _ & Ei & _ & Ua & Ut & Ug & Kg & Ga & Gt).
        fold a t in Nat_, Ua, Ut, Ga, Gt. unfold right. cbn [graph_of at_anchor at_tip gone anchor tip same tidy].
        split; [exact solid_allowed|]. split; [exact anchor_not_new|]. split; [exact Ha|]. split; [exact Hn|].
        split; [apply seen_tidy, solid_anchor|]. split; [apply seen_tidy, solid_new|].
        rewrite !tidy_deg. split.
        { intros O1 O2. assert (O1' : deg (anchor f) < 2) by (destruct (same f); exact O1).
          rewrite <- (solid_same O1'). unfold open_end. destruct (Nat.ltb_spec (deg (more (fresh p) l)) 2); [|lia].
          destruct (Nat.ltb_spec (deg (if same f then Place (deg (anchor f)) l else anchor f)) 2); [|lia].
          now rewrite !andb_true_r. }
        split.
        { rewrite alone_cons, solid_gone, (proj1 solid_tip). unfold lone. simpl. lia. }
        split; [exact solid_used|]. split; [right; now right|]. split; [now left|].
        split; [intros v [<-|I]; right; right; auto|]. split; [intros v [<-|I]; auto|].
        split; [intros [E|I]; [now symmetry in E|contradiction]|].
        intros [E|I]; [now apply tip_not_new|]. apply Nn. now apply Ug.
      Qed.

      Lemma right_solid_mark :
        right (n :: q :: used) (Drawn G2 t n (a :: gone d)) (tidy (Frontier (more (tip f) l) (more (fresh p) l) true))
          (i + lone (deg (anchor f))).
      Proof.
        pose proof R as (_ & Nat_ & _ & _ & _ & _ & _ & Ei & _ & Ua & Ut & Ug & Kg & Ga & Gt).
        fold a t in Nat_, Ua, Ut, Ga, Gt. unfold right. cbn [graph_of at_anchor at_tip gone anchor tip same tidy].
        split; [exact solid_allowed|]. split; [exact tip_not_new|]. split; [exact Ht|]. split; [exact Hn|].
        split; [apply seen_tidy, solid_tip|]. split; [apply seen_tidy, solid_new|].
        rewrite !tidy_deg. split.
        { intros O1 O2. unfold open_end. destruct (Nat.ltb_spec (deg (more (fresh p) l)) 2); [|lia].
          destruct (Nat.ltb_spec (deg (more (tip f) l)) 2); [|lia].
          split; [intros _; apply linked_edge; left; now left|reflexivity]. }
        split.
        { rewrite alone_cons, solid_gone. f_equal. f_equal. unfold G2. rewrite join_degree by auto using anchor_not_new.
          symmetry. apply port_anchor. }
        split; [exact solid_used|]. split; [right; now right|]. split; [now left|].
        split; [intros v [<-|I]; right; right; auto|]. split; [intros v [<-|I]; auto|].
        split; [intros [E|I]; [now apply Nat_|contradiction]|].
        intros [E|I]; [now apply anchor_not_new|]. apply Nn. now apply Ug.
      Qed.
    End Solid.
  End Move.

  Lemma right_chord used d f i : right used d f i ->
    deg (anchor f) < 2 -> deg (tip f) < 2 -> same f = false -> agree (port (anchor f)) (port (tip f)) = true ->
    let l := either (port (anchor f)) (port (tip f)) in
    right used (Drawn ((at_anchor d, at_tip d) :: graph_of d) (at_anchor d) (at_tip d) (gone d))
      (tidy (Frontier (more (anchor f) l) (more (tip f) l) true)) i.
  Proof.
    intros R Oa Ot S C l. pose proof R as (A & N & Ha & Ht & Sa & St & Q & Ei & U & Ua & Ut & Ug & Kg & Ga & Gt).
    assert (L : ~ linked (graph_of d) (at_anchor d) (at_tip d)) by (intros L; apply Q in L; congruence || auto).
    unfold right. cbn [graph_of at_anchor at_tip gone anchor tip same tidy].
    split; [now apply (join_allowed _ _ _ (anchor f) (tip f))|]. split; [exact N|]. split; [exact Ha|]. split; [exact Ht|].
    split; [now apply seen_tidy, (join_seen_left _ _ _ (anchor f) (tip f))|].
    split; [now apply seen_tidy, (join_seen_right _ _ _ (anchor f) (tip f))|]. rewrite !tidy_deg. split.
    { intros O1 O2. unfold open_end. destruct (Nat.ltb_spec (deg (more (anchor f) l)) 2); [|lia].
      destruct (Nat.ltb_spec (deg (more (tip f) l)) 2); [|lia].
      split; [intros _; apply linked_edge; left; now left|reflexivity]. }
    split.
    { rewrite Ei. symmetry. apply alone_same. intros v I. apply join_degree; intros ->; contradiction. }
    split; [|auto 10].
    intros v D. destruct (Nat.eq_dec v (at_anchor d)) as [->|N1]; [exact Ua|]. destruct (Nat.eq_dec v (at_tip d)) as [->|N2]; [exact Ut|].
    rewrite join_degree in D by auto. now apply U.
  Qed.

  (** One step: the books stay right, and a step that is refused is not legal. *)
  Lemma move_right used d f i m b : right used d f i -> new_move used m -> feasible (what m) b ->
    match take (what m) b f with
    | Some g => right (use m used) (draw_move m b d) g (i + left_alone (what m) b f)
    | None => ~ allowed (graph_of (draw_move m b d))
    end.
  Proof.
    intros R W Po. destruct m as [[p|p|p|] n q]; unfold new_move, use, draw_move, edge_of in *; cbn [what vertex point label_of feasible] in *.
    - subst b. destruct W as (Hn & Nn & Hp). cbn [take left_alone app].
      rewrite <- (proj1 (port_tip used d f i p n q R Hn Nn Hp)). apply right_dashed with f; auto.
    - destruct W as (Hn & Nn & Hp). unfold take, left_alone. destruct b.
      + destruct (open_end (tip f) && agree (port (tip f)) p) eqn:E; cbn [graph_of app].
        * apply andb_prop in E as [O C]. apply open_room in O. rewrite Nat.add_0_r. now apply right_solid_next.
        * eapply (join_refused _ (at_tip d) n (tip f) (fresh p)) with (sm := false).
          -- now apply (port_tip used d f i p n q). -- now apply (port_new used d f i p n q).
          -- intros _ _. split; [discriminate|]. intros L. now apply (tip_apart used d f i p n q) in L.
          -- rewrite fresh_port. unfold open_end at 2. rewrite (proj2 (Nat.ltb_lt _ _) (fresh_room p)).
             now rewrite !andb_true_r.
      + cbn [app]. rewrite <- (proj1 (port_tip used d f i p n q R Hn Nn Hp)). apply right_dashed with f; auto.
    - destruct W as (Hn & Nn & Hp). unfold take, left_alone. destruct b.
      + destruct (open_end (tip f) && agree (port (tip f)) p) eqn:E; cbn [graph_of app].
        * apply andb_prop in E as [O C]. apply open_room in O. now apply right_solid_mark.
        * eapply (join_refused _ (at_tip d) n (tip f) (fresh p)) with (sm := false).
          -- now apply (port_tip used d f i p n q). -- now apply (port_new used d f i p n q).
          -- intros _ _. split; [discriminate|]. intros L. now apply (tip_apart used d f i p n q) in L.
          -- rewrite fresh_port. unfold open_end at 2. rewrite (proj2 (Nat.ltb_lt _ _) (fresh_room p)).
             now rewrite !andb_true_r.
      + cbn [app]. rewrite <- (proj1 (port_anchor used d f i p n q R Hn Nn Hp)). apply right_dashed with f; auto.
    - unfold take, left_alone. rewrite Nat.add_0_r. destruct b; [|now destruct d].
      destruct (open_end (anchor f) && open_end (tip f) && negb (same f) && agree (port (anchor f)) (port (tip f))) eqn:E;
        cbn [graph_of app].
      + rewrite !andb_true_iff in E. destruct E as [[[Oa Ot] S] C]. apply open_room in Oa, Ot. apply negb_true_iff in S.
        now apply right_chord.
      + eapply (join_refused _ _ _ (anchor f) (tip f)) with (sm := same f); [apply R..|exact E].
  Qed.

  (** Any number of steps. *)
  Fixpoint draw_moves (ms : list move) (c : coloring) (d : picture) : picture :=
    match ms, c with m :: ms', b :: c' => draw_moves ms' c' (draw_move m b d) | _, _ => d end.
  Fixpoint new_moves (used : list nat) (ms : list move) : Prop :=
    match ms with [] => True | m :: ms' => new_move used m /\ new_moves (use m used) ms' end.
  Definition uses (used : list nat) (ms : list move) : list nat := fold_left (fun u m => use m u) ms used.
  Fixpoint feasibles (ms : list move) (c : coloring) : Prop :=
    match ms, c with
    | [], [] => True
    | m :: ms', b :: c' => feasible (what m) b /\ feasibles ms' c'
    | _, _ => False
    end.

  Lemma drawn_more ms : forall c d, exists H, graph_of (draw_moves ms c d) = H ++ graph_of d.
  Proof.
    induction ms as [|m ms IH]; intros [|b c] d; try (now exists []). simpl. destruct (IH c (draw_move m b d)) as (H & ->).
    unfold draw_move. destruct (what m); cbn [graph_of]; eexists; rewrite !app_assoc; reflexivity.
  Qed.

  Theorem play_right ms : forall used d f n i c, right used d f i -> new_moves used ms -> feasibles ms c ->
    match play (map what ms) c f n i with
    | Some (g, (n', i')) => right (uses used ms) (draw_moves ms c d) g i' /\ n' = n + solids c
    | None => ~ allowed (graph_of (draw_moves ms c d))
    end.
  Proof.
    induction ms as [|m ms IH]; intros used d f n i [|b c] R W Po; cbn [feasibles] in Po; try contradiction.
    - simpl. split; [exact R|]. unfold solids. simpl. lia.
    - destruct W as [W Ws], Po as [Po Pos]. cbn [map play draw_moves]. pose proof (move_right used d f i m b R W Po) as M.
      destruct (take (what m) b f) as [g|].
      + specialize (IH (use m used) (draw_move m b d) g (if b then S n else n) (i + left_alone (what m) b f) c M Ws Pos).
        destruct (play (map what ms) c g _ _) as [[h [n' i']]|]; [|exact IH]. destruct IH as [IH ->].
        split; [exact IH|]. unfold solids. destruct b; simpl; lia.
      + intros A. apply M. destruct (drawn_more ms c (draw_move m b d)) as (H & E). rewrite E in A.
        exact (allowed_suffix H _ A).
  Qed.
End Meaning.
