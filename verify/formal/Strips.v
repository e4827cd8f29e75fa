(** * Valid means: made of strips

    [Statements.v] calls a graph valid when no degree exceeds two and every edge is a bridge. This file proves that a graph
    is valid exactly when its vertices can be listed strip by strip, each vertex once, so that the solid edges are the
    pairs of neighbours in the lists; and that the number of strips is then the number of vertices minus the number of edges. *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements Graph.

(** ** The number of strips *)
Lemma path_edges_length l : l <> [] -> length (path_edges l) + 1 = length l.
Proof.
  induction l as [|u [|v l] IH]; intros N; [congruence|reflexivity|].
  change (path_edges (u :: v :: l)) with ((u, v) :: path_edges (v :: l)). simpl length in *. rewrite <- IH by discriminate. lia.
Qed.

Theorem number_of_strips vs G strips : stripped vs G strips -> length strips + length G = length vs.
Proof.
  intros (N & P & Q). apply Permutation_length in P, Q. rewrite !map_length in Q. rewrite <- P, <- Q. clear P Q.
  induction strips as [|l strips IH]; [reflexivity|]. simpl in *. rewrite !app_length.
  pose proof (path_edges_length l). rewrite <- IH by tauto. assert (l <> []) by (intros ->; tauto). specialize (H H0). lia.
Qed.

(** ** Directions do not matter *)
Lemma undirected_cases e : undirected e = e \/ undirected e = (snd e, fst e).
Proof. destruct e as [a b]. unfold undirected. simpl. destruct (le_ge_dec a b); [left|right]; f_equal; lia. Qed.

Lemma degree_undirected G v : degree (map undirected G) v = degree G v.
Proof.
  induction G as [|e G IH]; [reflexivity|]. simpl map. rewrite !degree_cons, IH. f_equal.
  destruct (undirected_cases e) as [->| ->]; unfold meets; simpl; lia.
Qed.

Lemma adjacent_undirected G u v : adjacent (map undirected G) u v <-> adjacent G u v.
Proof.
  induction G as [|[a b] G IH]; [reflexivity|]. unfold adjacent in *. simpl.
  destruct (undirected_cases (a, b)) as [->| ->]; simpl; intuition congruence.
Qed.

Lemma linked_same G H u v : (forall x y, adjacent G x y -> adjacent H x y) -> linked G u v -> linked H u v.
Proof. intros A L. induction L as [|v w _ IH B]; [apply here|]. exact (onward _ _ _ _ IH (A _ _ B)). Qed.

Lemma linked_undirected G u v : linked (map undirected G) u v <-> linked G u v.
Proof. split; apply linked_same; intros x y; apply adjacent_undirected. Qed.

Lemma valid_undirected G : valid (map undirected G) <-> valid G.
Proof.
  induction G as [|[a b] G IH]; [reflexivity|]. simpl map.
  destruct (undirected_cases (a, b)) as [->| ->]; simpl; rewrite !valid_cons, IH, !degree_undirected, linked_undirected.
  - reflexivity.
  - assert (S : linked G b a <-> linked G a b) by (split; apply linked_sym). rewrite S. tauto.
Qed.

(** ** Strips are valid *)
Lemma path_edges_in l e : In e (path_edges l) -> In (fst e) l /\ In (snd e) l.
Proof.
  induction l as [|u [|v l] IH]; simpl; try tauto. intros [<-|I]; [simpl; auto|]. destruct (IH I). simpl in *. tauto.
Qed.

Lemma strips_in strips e : In e (concat (map path_edges strips)) -> In (fst e) (concat strips) /\ In (snd e) (concat strips).
Proof.
  rewrite in_concat. intros (es & I & J). apply in_map_iff in I as (l & <- & I). apply path_edges_in in J.
  rewrite !in_concat. split; exists l; tauto.
Qed.

Lemma adjacent_degree G u v : adjacent G u v -> degree G u <> 0.
Proof.
  induction G as [|e G IH]; [intros [[]|[]]|]. rewrite degree_cons. unfold meets.
  intros [[->|I]|[->|I]]; simpl; rewrite ?Nat.eqb_refl; try lia; assert (degree G u <> 0) by (apply IH; unfold adjacent; auto); lia.
Qed.

Lemma linked_lonely G u v : degree G u = 0 -> linked G v u -> u = v.
Proof.
  intros D L. destruct L as [|x w _ A]; [reflexivity|]. apply adjacent_sym, adjacent_degree in A. contradiction.
Qed.

Lemma valid_path (l : list nat) (G : graph) : NoDup l -> (forall (e : edge) v, In e G -> In v l -> fst e <> v /\ snd e <> v) -> valid G ->
  valid (path_edges l ++ G).
Proof.
  induction l as [|u [|v l] IH]; intros N O V; [exact V|exact V|].
  change (path_edges (u :: v :: l)) with ((u, v) :: path_edges (v :: l)). rewrite <- app_comm_cons.
  pose proof N as M. inversion_clear N as [|? ? Nu Nvl].
  assert (V' : valid (path_edges (v :: l) ++ G)) by (apply IH; auto; intros e x I J; apply O; [exact I|now right]).
  assert (Du : degree (path_edges (v :: l) ++ G) u = 0).
  { apply degree_zero. intros e I. apply in_app_or in I as [I|I].
    - apply path_edges_in in I. split; intros E; apply Nu; rewrite <- E; tauto.
    - apply O; [exact I|now left]. }
  apply (valid_cons u v (path_edges (v :: l) ++ G)). split; [exact V'|]. split; [rewrite Du; auto|]. split.
  - rewrite degree_app, (degree_zero G v) by (intros e I; apply O; [exact I|right; now left]).
    destruct l as [|w l]; [unfold degree; simpl; lia|]. change (path_edges (v :: w :: l)) with ((v, w) :: path_edges (w :: l)).
    inversion_clear Nvl as [|? ? Nv _]. rewrite degree_cons, degree_zero.
    + unfold meets. simpl. destruct (Nat.eqb_spec v v), (Nat.eqb_spec w v); simpl; try lia. subst. exfalso. apply Nv. now left.
    + intros e I. apply path_edges_in in I. split; intros E; apply Nv; rewrite <- E; tauto.
  - intros L. apply Nu. left. symmetry. apply (linked_lonely _ _ _ Du). now apply linked_sym.
Qed.

Lemma nodup_app {A} (l m : list A) : NoDup (l ++ m) -> NoDup l /\ NoDup m /\ forall x, In x l -> ~ In x m.
Proof.
  induction l as [|a l IH]; simpl; intros N; [repeat split; auto; constructor|].
  inversion_clear N as [|? ? Na N']. destruct (IH N') as (L & M & D). repeat split; auto.
  - constructor; [|exact L]. intros I. apply Na, in_or_app. now left.
  - intros x [<-|I]; [intros J; apply Na, in_or_app; now right|now apply D].
Qed.

Lemma valid_strips strips : NoDup (concat strips) -> valid (concat (map path_edges strips)).
Proof.
  induction strips as [|l strips IH]; simpl; intros N; [apply valid_nil|].
  apply nodup_app in N as (Nl & Ns & D). apply valid_path; auto.
  intros e v I J. apply strips_in in I. split; intros <-; eapply D; try exact J; tauto.
Qed.

Theorem stripped_valid vs G strips : NoDup vs -> stripped vs G strips -> valid G.
Proof.
  intros N (_ & P & Q). apply valid_undirected. eapply valid_perm; [exact Q|]. apply valid_undirected, valid_strips.
  eapply Permutation_NoDup; [symmetry; exact P|exact N].
Qed.

(** ** A valid graph is made of strips

    Edge by edge: a new edge joins two strips at their ends. *)
Lemma path_edges_app l u v m : path_edges (l ++ [u] ++ v :: m) = path_edges (l ++ [u]) ++ (u, v) :: path_edges (v :: m).
Proof.
  induction l as [|x [|y l] IH]; [reflexivity|reflexivity|]. simpl in *. now rewrite IH.
Qed.

Lemma path_edges_rev l : Permutation (map undirected (path_edges (rev l))) (map undirected (path_edges l)).
Proof.
  induction l as [|u [|v l] IH]; [apply Permutation_refl|apply Permutation_refl|].
  change (path_edges (u :: v :: l)) with ((u, v) :: path_edges (v :: l)). simpl rev in *.
  rewrite <- app_assoc. change ([v] ++ [u]) with ([v] ++ u :: []). rewrite path_edges_app, map_app, IH.
  simpl map. rewrite Permutation_app_comm. simpl. apply Permutation_refl'.
  f_equal. unfold undirected. simpl. f_equal; lia.
Qed.

Lemma concat_perm {A} (ls ms : list (list A)) : Permutation ls ms -> Permutation (concat ls) (concat ms).
Proof.
  intros P. induction P; simpl; [apply perm_nil|now apply Permutation_app_head| |now transitivity (concat l')].
  rewrite !app_assoc. apply Permutation_app_tail, Permutation_app_comm.
Qed.

Lemma stripped_perm vs G strips strips' : Permutation strips strips' -> stripped vs G strips -> stripped vs G strips'.
Proof.
  intros P (N & V & E). split; [|split].
  - intros I. apply N. eapply Permutation_in; [symmetry; exact P|exact I].
  - rewrite <- V. symmetry. now apply concat_perm.
  - rewrite <- E. symmetry. apply Permutation_map, concat_perm, Permutation_map, P.
Qed.

Lemma stripped_turn vs G l strips : stripped vs G (l :: strips) -> stripped vs G (rev l :: strips).
Proof.
  intros (N & V & E). simpl in *. split; [|split].
  - intros [R|I]; [|tauto]. apply N. left. rewrite <- (rev_involutive l), R. reflexivity.
  - rewrite <- V. apply Permutation_app_tail. symmetry. apply Permutation_rev.
  - rewrite <- E. simpl map at 2. simpl concat. rewrite !map_app. apply Permutation_app_tail, path_edges_rev.
Qed.

Lemma linked_strip l G u v : incl (path_edges l) G -> In u l -> In v l -> linked G u v.
Proof.
  assert (H : forall x m, incl (path_edges (x :: m)) G -> forall w, In w (x :: m) -> linked G x w).
  { intros x m. revert x. induction m as [|y m IH]; intros x I w [<-|J]; try apply here; [destruct J|].
    apply linked_trans with y; [apply linked_edge; left; apply I; now left|].
    apply IH; [|exact J]. intros e K. apply I. now right. }
  intros I Hu Hv. destruct l as [|x l]; [destruct Hu|].
  apply linked_trans with x; [apply linked_sym|]; now apply (H x l).
Qed.

(** A vertex of degree at most one is an end of its strip. *)
Lemma inner_degree l u m : l <> [] -> m <> [] -> 2 <= degree (path_edges (l ++ u :: m)) u.
Proof.
  intros Hl Hm. destruct (exists_last Hl) as (l' & x & ->). destruct m as [|y m]; [congruence|].
  rewrite <- app_assoc. change ([x] ++ u :: y :: m) with ([x] ++ u :: (y :: m)). rewrite path_edges_app, degree_app.
  change (path_edges (u :: y :: m)) with ((u, y) :: path_edges (y :: m)). rewrite !degree_cons. unfold meets. simpl.
  rewrite Nat.eqb_refl. lia.
Qed.

Lemma degree_stripped vs G l strips v : stripped vs G (l :: strips) -> degree (path_edges l) v <= degree G v.
Proof.
  intros (_ & _ & E). rewrite <- (degree_undirected G), <- (degree_perm _ _ v E), degree_undirected. simpl.
  rewrite degree_app. lia.
Qed.

(** The first strip can be turned so that it ends in [a]. *)
Lemma turn_to_end vs G l strips a : stripped vs G (l :: strips) -> In a l -> degree G a <= 1 ->
  exists l', stripped vs G ((l' ++ [a]) :: strips).
Proof.
  intros S I D. apply in_split in I as (l1 & l2 & ->). pose proof (degree_stripped _ _ _ _ a S) as B.
  destruct l2 as [|y l2]; [now exists l1|]. destruct l1 as [|x l1].
  - exists (rev (y :: l2)). exact (stripped_turn _ _ _ _ S).
  - pose proof (inner_degree (x :: l1) a (y :: l2)). assert (2 <= 1); [|lia].
    eapply Nat.le_trans; [apply H; discriminate|]. lia.
Qed.

Lemma bring_front (strips : list (list nat)) a : In a (concat strips) -> exists l others, In a l /\ Permutation strips (l :: others).
Proof.
  intros I. apply in_concat in I as (l & J & I). apply in_split in J as (s1 & s2 & ->).
  exists l, (s1 ++ s2). split; [exact I|]. symmetry. apply Permutation_middle.
Qed.

Lemma join_strips vs G a b strips : stripped vs G strips -> In a vs -> In b vs ->
  degree G a <= 1 -> degree G b <= 1 -> ~ linked G a b -> exists strips', stripped vs ((a, b) :: G) strips'.
Proof.
  intros S Ia Ib Da Db N. pose proof S as (_ & V & _).
  assert (I : In a (concat strips)) by (eapply Permutation_in; [symmetry; exact V|exact Ia]).
  apply bring_front in I as (l & others & Il & P). apply (stripped_perm _ _ _ _ P) in S.
  pose proof S as (_ & V' & E').
  assert (I : In b (concat (l :: others))) by (eapply Permutation_in; [symmetry; exact V'|exact Ib]).
  simpl in I. apply in_app_or in I as [I|I].
  { exfalso. apply N. apply linked_undirected.
    apply linked_mono with (map undirected (path_edges l)).
    - intros e J. eapply Permutation_in; [exact E'|]. simpl. rewrite map_app. apply in_or_app. now left.
    - apply linked_undirected. apply (linked_strip l); auto. apply incl_refl. }
  apply bring_front in I as (m & rest & Im & Q). apply (stripped_perm _ _ _ (l :: m :: rest)) in S; [|now apply perm_skip].
  apply turn_to_end with (a := a) in S as (l' & S); [|exact Il|exact Da].
  apply (stripped_perm _ _ _ (m :: (l' ++ [a]) :: rest)) in S; [|apply perm_swap].
  apply turn_to_end with (a := b) in S as (m' & S); [|exact Im|exact Db].
  apply stripped_turn in S. rewrite rev_app_distr in S. simpl in S. destruct S as (F & W & E).
  exists ((l' ++ [a] ++ b :: rev m') :: rest). split; [|split].
  - intros [J|J]; [destruct l'; discriminate|]. apply F. simpl. tauto.
  - rewrite <- W. change (Permutation ((l' ++ [a] ++ b :: rev m') ++ concat rest) ((b :: rev m') ++ (l' ++ [a]) ++ concat rest)).
    rewrite (app_assoc l' [a]), (app_assoc (b :: rev m')). apply Permutation_app_tail, Permutation_app_comm.
  - transitivity (map undirected ((a, b) :: concat (map path_edges ((b :: rev m') :: (l' ++ [a]) :: rest)))).
    + apply Permutation_map.
      change (Permutation (path_edges (l' ++ [a] ++ b :: rev m') ++ concat (map path_edges rest))
        ((a, b) :: path_edges (b :: rev m') ++ path_edges (l' ++ [a]) ++ concat (map path_edges rest))).
      rewrite path_edges_app. generalize (path_edges (l' ++ [a])) (path_edges (b :: rev m')).
      intros pl pm. rewrite <- Permutation_middle. simpl. apply perm_skip. rewrite (app_assoc pm).
      apply Permutation_app_tail, Permutation_app_comm.
    + simpl map. apply perm_skip. exact E.
Qed.

Lemma single_strips vs : NoDup vs -> stripped vs [] (map (fun v => [v]) vs).
Proof.
  intros _. split; [|split].
  - intros I. apply in_map_iff in I as (v & E & _). discriminate.
  - induction vs as [|v vs IH]; simpl; auto.
  - induction vs as [|v vs IH]; simpl; auto.
Qed.

Theorem valid_stripped vs G : NoDup vs -> (forall e, In e G -> In (fst e) vs /\ In (snd e) vs) ->
  valid G -> exists strips, stripped vs G strips.
Proof.
  intros N. induction G as [|[a b] G IH]; intros I V; [eexists; now apply single_strips|].
  apply valid_cons in V as (V & Da & Db & L). destruct IH as (strips & S); auto.
  { intros e J. apply I. now right. }
  destruct (I (a, b) (or_introl eq_refl)). now apply join_strips with strips.
Qed.

(** The two together. *)
Theorem valid_is_stripped vs G : NoDup vs -> (forall e, In e G -> In (fst e) vs /\ In (snd e) vs) ->
  (valid G <-> exists strips, stripped vs G strips /\ length strips + length G = length vs).
Proof.
  intros N I. split.
  - intros V. destruct (valid_stripped vs G N I V) as (strips & S). exists strips. split; [exact S|].
    exact (number_of_strips vs G strips S).
  - intros (strips & S & _). exact (stripped_valid vs G strips N S).
Qed.
