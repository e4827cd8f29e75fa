(** * No buffer has fewer indices

    docs/theory.md, "No buffer has fewer indices". A buffer is a list of runs, a run a list of vertices, and three
    consecutive vertices of a run are a window. Windows of three different vertices are the triangles of the mesh. What the
    other windows and the ends of runs miss are arrows along mesh edges, a flow modulo 3; multipliers of sets of vertices that
    load no edge too much bound the arrows, and so the indices. (Restarts between components are not counted here.) *)
Require Import Arith Bool List Permutation Lia.
Import ListNotations.
Require Import Statements.
Import Buffers.

Lemma total_cons {T} (f : T -> nat) x l : total f (x :: l) = f x + total f l.
Proof. reflexivity. Qed.
Lemma total_app {T} (f : T -> nat) l m : total f (l ++ m) = total f l + total f m.
Proof. unfold total. now rewrite map_app, list_sum_app. Qed.
Lemma total_flat_map {T U} (f : U -> nat) (g : T -> list U) l : total f (flat_map g l) = total (fun x => total f (g x)) l.
Proof. induction l as [|x l IH]; [reflexivity|]. simpl flat_map. rewrite total_app, IH. reflexivity. Qed.
Lemma total_le {T} (f g : T -> nat) l : (forall x, In x l -> f x <= g x) -> total f l <= total g l.
Proof.
  induction l as [|x l IH]; intros H; [reflexivity|].
  pose proof (H x (or_introl eq_refl)) as Hx. pose proof (IH (fun y I => H y (or_intror I))) as Hl.
  unfold total in *. simpl. lia.
Qed.
Lemma total_permutation {T} (f : T -> nat) l m : Permutation l m -> total f l = total f m.
Proof. induction 1; unfold total in *; simpl in *; lia. Qed.
Lemma total_plus {T} (f g : T -> nat) l : total (fun x => f x + g x) l = total f l + total g l.
Proof. induction l as [|x l IH]; [reflexivity|]. unfold total in *. simpl. rewrite IH. lia. Qed.
Lemma total_times {T} (f : T -> nat) c l : total (fun x => c * f x) l = c * total f l.
Proof. induction l as [|x l IH]; unfold total in *; simpl; [lia|]. rewrite IH. lia. Qed.
Lemma total_ext {T} (f g : T -> nat) l : (forall x, f x = g x) -> total f l = total g l.
Proof. intros H. unfold total. now rewrite (map_ext f g H). Qed.
Lemma total_swap {T U} (f : T -> U -> nat) l m : total (fun x => total (f x) m) l = total (fun y => total (fun x => f x y) l) m.
Proof.
  induction l as [|x l IH].
  - induction m as [|y m IHm]; [reflexivity|]. unfold total in *. simpl in *. exact IHm.
  - change (total (f x) m + total (fun x => total (f x) m) l = total (fun y => f x y + total (fun x => f x y) l) m).
    now rewrite IH, total_plus.
Qed.

(** ** Arrows *)
Definition missed (v : nat) (a : arrow) : nat := 2 * hit v (fst a) + hit v (snd a).
Section Mesh.
Variable mesh : list window.

Definition along (x y : nat) : list arrow := if edge mesh x y then [(x, y)] else [].
Definition of_window (t : window) : list arrow :=
  let '(x, y, z) := t in
  if x =? y then along x z else if y =? z then along y x else if z =? x then along x y else [].
Definition at_begin (run : list nat) : list arrow := match run with x :: y :: _ => along x y | _ => [] end.
Fixpoint at_end (run : list nat) : list arrow :=
  match run with [x; y] => along y x | _ :: rest => at_end rest | [] => [] end.
Definition arrows (run : list nat) : list arrow := at_begin run ++ flat_map of_window (windows run) ++ at_end run.

Lemma edge_sym x y : edge mesh x y = edge mesh y x.
Proof.
  unfold edge. rewrite Nat.eqb_sym. f_equal. induction mesh as [|t l IH]; [reflexivity|]. simpl. now rewrite IH, (andb_comm (corner x t)).
Qed.
Lemma along_self x : along x x = [].
Proof. unfold along, edge. now rewrite Nat.eqb_refl. Qed.

Definition served (v : nat) (t : window) : nat := if different t then serves v t else 0.
Definition fits (t : window) : Prop :=
  let '(x, y, z) := t in different t = true -> edge mesh x y = true /\ edge mesh y z = true /\ edge mesh z x = true.

(** One window more: what it serves and misses, and what the arrow at the beginning was and is. *)
Lemma window_balance v x y z : fits (x, y, z) -> exists q,
  total (missed v) (along x y) + total (missed v) (of_window (x, y, z)) + served v (x, y, z) = total (missed v) (along y z) + 3 * q.
Proof.
  intros F. unfold fits in F. unfold of_window, served, serves, different in *.
  destruct (x =? y) eqn:Exy.
  { apply Nat.eqb_eq in Exy. subst y. rewrite along_self. exists 0. unfold total at 1. simpl. lia. }
  destruct (y =? z) eqn:Eyz.
  { apply Nat.eqb_eq in Eyz. subst z. rewrite along_self. unfold along. rewrite (edge_sym y x).
    destruct (edge mesh x y); [exists (hit v x + hit v y)|exists 0]; unfold total, missed; simpl; lia. }
  destruct (z =? x) eqn:Ezx.
  { apply Nat.eqb_eq in Ezx. subst z. unfold along. rewrite (edge_sym y x).
    destruct (edge mesh x y); [exists (hit v x)|exists 0]; unfold total, missed; simpl; lia. }
  destruct (F eq_refl) as (E & E' & _). unfold along. rewrite E, E'. exists (hit v x). unfold total, missed. simpl. lia.
Qed.

Lemma run_balance v run : 2 <= length run -> Forall fits (windows run) ->
  exists q, total (missed v) (arrows run) + total (served v) (windows run) = 3 * q.
Proof.
  destruct run as [|x [|y rest]]; [intros L; inversion L|intros L; inversion L; lia|]. intros _. revert x y.
  induction rest as [|z rest IH]; intros x y F.
  - unfold arrows, at_begin, at_end, windows, along. rewrite (edge_sym y x).
    destruct (edge mesh x y); [exists (hit v x + hit v y)|exists 0]; unfold total, missed; simpl; lia.
  - change (windows (x :: y :: z :: rest)) with ((x, y, z) :: windows (y :: z :: rest)) in F.
    pose proof (Forall_inv F) as Fx. destruct (IH y z (Forall_inv_tail F)) as [q Hq].
    destruct (window_balance v x y z Fx) as [p Hp]. exists (p + q). unfold arrows in *.
    change (at_begin (x :: y :: z :: rest)) with (along x y).
    change (at_begin (y :: z :: rest)) with (along y z) in Hq.
    change (at_end (x :: y :: z :: rest)) with (at_end (y :: z :: rest)).
    change (windows (x :: y :: z :: rest)) with ((x, y, z) :: windows (y :: z :: rest)).
    change (flat_map of_window ((x, y, z) :: windows (y :: z :: rest)))
      with (of_window (x, y, z) ++ flat_map of_window (windows (y :: z :: rest))).
    change (total (served v) ((x, y, z) :: windows (y :: z :: rest)))
      with (served v (x, y, z) + total (served v) (windows (y :: z :: rest))).
    rewrite !total_app in *. lia.
Qed.

Lemma at_end_short run : length (at_end run) <= 1.
Proof.
  induction run as [|x [|y rest] IH]; [simpl; lia|simpl; lia|]. destruct rest as [|z rest]; [|exact IH].
  simpl. unfold along. destruct (edge mesh y x); simpl; lia.
Qed.
Lemma along_short x y : length (along x y) <= 1.
Proof. unfold along. destruct (edge mesh x y); simpl; lia. Qed.
Lemma windows_length run : 2 <= length run -> length (windows run) + 2 = length run.
Proof.
  destruct run as [|x [|y rest]]; [intros L; inversion L|intros L; inversion L; lia|]. intros _. revert x y.
  induction rest as [|z rest IH]; intros x y; [reflexivity|]. specialize (IH y z).
  change (S (length (windows (y :: z :: rest))) + 2 = S (length (y :: z :: rest))). now rewrite <- IH.
Qed.
Lemma window_short t : (if different t then 1 else 0) + length (of_window t) <= 1.
Proof.
  destruct t as [[x y] z]. unfold different, of_window.
  destruct (x =? y); [simpl; apply along_short|]. destruct (y =? z); [simpl; apply along_short|].
  destruct (z =? x); [simpl; apply along_short|simpl; lia].
Qed.

(** A run has as many indices as triangles and arrows, at least. *)
Lemma run_length run : 2 <= length run -> length (filter different (windows run)) + length (arrows run) <= length run.
Proof.
  intros L. pose proof (windows_length run L) as W. unfold arrows. rewrite !app_length.
  assert (length (at_begin run) <= 1) by (destruct run as [|x [|y r]]; simpl; try lia; apply along_short).
  pose proof (at_end_short run).
  assert (forall l, length (filter different l) + length (flat_map of_window l) <= length l) as D.
  { induction l as [|t l IH]; [reflexivity|]. pose proof (window_short t) as Ht.
    change (flat_map of_window (t :: l)) with (of_window t ++ flat_map of_window l). rewrite app_length.
    simpl filter. destruct (different t); simpl in *; lia. }
  specialize (D (windows run)). lia.
Qed.

(** ** Cuts *)
Lemma hit_total x l : NoDup l -> total (fun v => hit v x) l = if existsb (Nat.eqb x) l then 1 else 0.
Proof.
  induction 1 as [|v l N _ IH]; [reflexivity|]. unfold total in *. simpl. rewrite IH. unfold hit.
  destruct (x =? v) eqn:E; simpl; [|reflexivity]. apply Nat.eqb_eq in E. subst v.
  destruct (existsb (Nat.eqb x) l) eqn:X; [|reflexivity]. exfalso. apply N. apply existsb_exists in X as (y & I & E).
  apply Nat.eqb_eq in E. now subst y.
Qed.

(** What arrows miss in a set is three for each arrow inside, and for those across the border decides their weight. *)
Lemma border c A : proper mesh c -> (exists q, total (fun v => total (missed v) A + total (serves v) mesh) (vertices c) = 3 * q) ->
  2 <= total (weight c) A.
Proof.
  intros (N & L & k & K) [q Q]. rewrite total_plus in Q.
  assert (exists out inn both, total (fun v => total (missed v) A) (vertices c) = 2 * out + inn + 3 * both /\
    total (weight c) A = lacking c * out + (3 - lacking c) * inn) as (out & inn & both & M & W).
  { rewrite (total_swap (fun v a => missed v a)). clear Q K. induction A as [|[x y] A (out & inn & both & M & W)].
    { exists 0, 0, 0. unfold total. simpl. split; lia. }
    assert (total (fun v => missed v (x, y)) (vertices c) = 2 * (if inside x c then 1 else 0) + (if inside y c then 1 else 0)) as E.
    { unfold missed. simpl fst. simpl snd. rewrite total_plus, total_times, !hit_total by exact N. reflexivity. }
    unfold total in *. simpl map. simpl list_sum. rewrite E, M, W. unfold weight. simpl fst. simpl snd.
    destruct (inside x c), (inside y c).
    - exists out, inn, (both + 1). lia.
    - exists (out + 1), inn, both. lia.
    - exists out, (inn + 1), both. lia.
    - exists out, inn, both. lia. }
  rewrite W. rewrite M in Q. destruct L as [L|L]; rewrite L in *.
  - destruct inn as [|inn]; [|lia]. destruct out as [|[|out]]; lia.
  - destruct out as [|out]; [|lia]. destruct inn as [|[|inn]]; lia.
Qed.

Lemma packing cuts unit A : Forall (fun c => 2 <= total (weight c) A) cuts -> (forall a, In a A -> load cuts a <= 2 * unit) ->
  total multiplier cuts <= unit * length A.
Proof.
  intros C L. assert (total (load cuts) A <= total (fun _ => 2 * unit) A) as H by (apply total_le; exact L).
  assert (total (fun _ : arrow => 2 * unit) A = 2 * unit * length A) as E.
  { clear. induction A as [|a A IH]; unfold total in *; simpl in *; [lia|]. rewrite IH. lia. }
  rewrite E in H. clear E L. unfold load in H. rewrite total_swap in H.
  assert (2 * total multiplier cuts <= total (fun c => total (fun a => multiplier c * weight c a) A) cuts) as G; [|lia].
  clear H. rewrite <- total_times. apply total_le. intros c I. rewrite total_times.
  rewrite Forall_forall in C. specialize (C c I). nia.
Qed.
End Mesh.

(** ** Any buffer that draws the mesh *)
Lemma permutation_serves v t u : same_corners t u -> serves v t = serves v u.
Proof.
  destruct t as [[x y] z], u as [[a b] c]. intros P. pose proof (total_permutation (hit v) _ _ P) as E.
  unfold total in E. simpl in *. lia.
Qed.
Lemma corner_serves v t : corner v t = (1 <=? serves v t).
Proof. destruct t as [[x y] z]. unfold corner, serves, hit. destruct (x =? v), (y =? v), (z =? v); reflexivity. Qed.

Lemma drawn_served mesh runs v : draws mesh runs -> total (served v) (flat_map windows runs) = total (serves v) mesh.
Proof.
  intros (order & P & F). rewrite <- (total_permutation _ _ _ P). clear P. unfold served.
  generalize dependent order. induction (flat_map windows runs) as [|t l IH]; intros order F; simpl in *.
  { inversion F. reflexivity. }
  unfold total in *. simpl. destruct (different t).
  - inversion F as [|? u ? m S G]; subst. simpl. rewrite (permutation_serves v _ _ S), (IH _ G). reflexivity.
  - now apply IH.
Qed.

Lemma drawn_fits mesh runs : draws mesh runs -> Forall (fits mesh) (flat_map windows runs).
Proof.
  intros (order & P & F). apply Forall_forall. intros [[x y] z] I D.
  assert (exists u, In u mesh /\ same_corners (x, y, z) u) as (u & U & S).
  { assert (In (x, y, z) (filter different (flat_map windows runs))) as J by (now apply filter_In).
    clear I. induction F as [|t u l m S F IH]; [easy|]. destruct J as [->|J].
    - exists u. split; [|exact S]. apply (Permutation_in _ P). now left.
    - clear IH. assert (forall m', incl m m' -> exists u, In u m' /\ same_corners (x, y, z) u) as G.
      { clear P. induction F as [|t' u' l' m' S' F' IH']; [easy|]. intros m'' K. destruct J as [->|J].
        - exists u'. split; [|exact S']. apply K. now left.
        - apply (IH' J). intros w W. apply K. now right. }
      destruct (G (u :: m) (fun w W => or_intror W)) as (w & W & S'). exists w. split; [|exact S']. now apply (Permutation_in _ P). }
  assert (forall a, corner a (x, y, z) = true -> corner a u = true) as C.
  { intros a H. now rewrite corner_serves, <- (permutation_serves a _ _ S), <- corner_serves. }
  unfold different in D. apply andb_prop in D as [D Dzx]. apply andb_prop in D as [Dxy Dyz]. unfold edge.
  repeat split; (apply andb_true_intro; split; [assumption|]); apply existsb_exists; exists u; (split; [exact U|]);
    apply andb_true_intro; split; apply C; unfold corner; rewrite Nat.eqb_refl, ?orb_true_r; reflexivity.
Qed.

Theorem no_buffer_has_fewer : No_buffer_has_fewer.
Proof.
  intros mesh runs cuts unit D R N C L. set (A := flat_map (arrows mesh) runs).
  assert (forall v, exists q, total (missed v) A + total (serves v) mesh = 3 * q) as B.
  { intros v. rewrite <- (drawn_served mesh runs v D). unfold A. pose proof (drawn_fits mesh runs D) as F.
    rewrite !total_flat_map, <- total_plus. clear D N C L A.
    induction runs as [|run runs IH]; [now exists 0|]. simpl in F. apply Forall_app in F as [F Fs].
    pose proof (Forall_inv R) as R1. cbv beta in R1.
    destruct (run_balance mesh v run ltac:(lia) F) as [p P]. destruct (IH (Forall_inv_tail R) Fs) as [q Q].
    exists (p + q). rewrite total_cons. cbv beta. lia. }
  assert (total multiplier cuts <= unit * length A) as K.
  { apply packing.
    - apply Forall_forall. intros c I. rewrite Forall_forall in C. apply (border mesh); [now apply C|].
      induction (vertices c) as [|v l [q Q]]; [now exists 0|]. destruct (B v) as [p P]. exists (p + q).
      rewrite total_cons. cbv beta. lia.
    - intros [x y] I. apply L. unfold A in I. clear -I. apply in_flat_map in I as (run & _ & I). unfold arrows in I.
      assert (forall a b, In (x, y) (along mesh a b) -> edge mesh x y = true) as G.
      { intros a b J. unfold along in J. destruct (edge mesh a b) eqn:E; [|easy]. destruct J as [J|[]]. now inversion J; subst. }
      apply in_app_or in I as [I|I]; [|apply in_app_or in I as [I|I]].
      + destruct run as [|a [|b r]]; simpl in I; try easy. now apply (G a b).
      + apply in_flat_map in I as ([[a b] c] & _ & I). unfold of_window in I.
        destruct (a =? b); [now apply (G a c)|]. destruct (b =? c); [now apply (G b a)|]. destruct (c =? a); [now apply (G a b)|easy].
      + induction run as [|a [|b r] IH]; [easy|easy|]. destruct r as [|c r]; [now apply (G b a)|]. now apply IH. }
  assert (length mesh + length A <= total (@length nat) runs) as T.
  { destruct D as (order & P & F). rewrite <- (Permutation_length P).
    assert (length (filter different (flat_map windows runs)) = length order) as <- by (clear -F; induction F; simpl; lia).
    unfold A. clear -R.
    induction runs as [|run runs IH]; [reflexivity|]. pose proof (Forall_inv R) as R1. cbv beta in R1. specialize (IH (Forall_inv_tail R)).
    pose proof (run_length mesh run ltac:(lia)) as G. simpl flat_map. rewrite filter_app, !app_length.
    rewrite total_cons. simpl flat_map in IH. lia. }
  unfold buffer_length. nia.
Qed.
