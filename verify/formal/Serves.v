(** * Finitely many classes, whatever the size

    A fan is drawn along its routes before and after the operation at the same time. What matters of the part drawn so far
    is the frontier before and, for each frontier after, the best score; and of these only the differences, and which
    labels are equal. So there are finitely many classes, and what holds for the end of each holds for fans of every
    size. *)
Require Import Arith Bool List Permutation ZArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Checker Frontier Fold Route.

(** ** A frontier that serves as well as another

    Whatever can be drawn on from [f] can be drawn on from [g]; at most [slack g f] more triangles stay alone. *)
Definition below_place (g f : place) : bool :=
  (deg g <=? deg f) && (negb (open_end f) || match port g with None => true | Some _ => same_label (port g) (port f) end).
Definition simulates (g f : frontier) : bool :=
  below_place (anchor g) (anchor f) && below_place (tip g) (tip f) &&
  (negb (open_end (anchor f) && open_end (tip f)) ||
   (if same g then same f
    else negb (same f) || match port (anchor g) with None => true | Some _ => same_label (port (anchor g)) (port (tip f)) end)).
Definition slack_place (g f : place) : nat := if (deg g =? 0) && negb (deg f =? 0) then 1 else 0.
Definition slack (g f : frontier) : nat := slack_place (anchor g) (anchor f) + slack_place (tip g) (tip f).

Definition under (g f : place) : Prop := deg g <= deg f /\ (deg f < 2 -> port g = None \/ port g = port f).
Definition serves (g f : frontier) : Prop :=
  under (anchor g) (anchor f) /\ under (tip g) (tip f) /\
  (deg (anchor f) < 2 -> deg (tip f) < 2 ->
    (same g = true -> same f = true) /\
    (same g = false -> same f = true -> port (anchor g) = None \/ port (anchor g) = port (tip f))).

Lemma none_or_same a b : match a with None => true | Some _ => same_label a b end = true <-> a = None \/ a = b.
Proof. destruct a as [l|]; [rewrite same_label_eq|]; intuition discriminate. Qed.
Lemma below_place_ok g f : below_place g f = true <-> under g f.
Proof.
  unfold below_place, under, open_end. rewrite andb_true_iff, Nat.leb_le, orb_true_iff, negb_true_iff, Nat.ltb_ge, none_or_same.
  split; intros [L H]; (split; [exact L|]).
  - intros B. destruct H; [lia|assumption]. - destruct (le_lt_dec 2 (deg f)); auto.
Qed.
Lemma simulates_ok g f : simulates g f = true <-> serves g f.
Proof.
  unfold simulates, serves. rewrite !andb_true_iff, !below_place_ok, orb_true_iff, negb_true_iff, andb_false_iff. unfold open_end.
  rewrite !Nat.ltb_ge. split.
  - intros [[A T] S]. split; [exact A|]. split; [exact T|]. intros Oa Ot. destruct S as [S|S]; [lia|]. destruct (same g).
    + split; [auto|discriminate]. + split; [discriminate|]. intros _ E. rewrite E in S. cbn in S. now apply none_or_same.
  - intros (A & T & S). split; [now split|]. destruct (le_lt_dec 2 (deg (anchor f))); auto. destruct (le_lt_dec 2 (deg (tip f))); auto.
    right. destruct S as [S1 S2]; auto. destruct (same g); auto. destruct (same f); auto. cbn. apply none_or_same. auto.
Qed.

Lemma under_refl x : under x x.
Proof. split; auto. Qed.
Lemma serves_refl f : serves f f.
Proof. split; [apply under_refl|]. split; [apply under_refl|]. intros _ _. split; [auto|congruence]. Qed.
Lemma under_trans e g f : under e g -> under g f -> under e f.
Proof.
  intros [A B] [C D]. split; [lia|]. intros O. destruct B as [B|B]; [lia|now left|]. destruct D as [D|D]; [exact O| |]; rewrite B; auto.
Qed.
Lemma serves_trans e g f : serves e g -> serves g f -> serves e f.
Proof.
  intros (A & T & S) (A' & T' & S'). split; [now apply under_trans with (anchor g)|]. split; [now apply under_trans with (tip g)|].
  intros Oa Ot. destruct (S' Oa Ot) as [S1' S2']. destruct A' as [A1' A2'], T' as [T1' T2'].
  destruct S as [S1 S2]; [lia|lia|]. specialize (A2' Oa). specialize (T2' Ot). split; [auto|]. intros E F.
  destruct A as [_ A2]. specialize (A2 ltac:(lia)). destruct (same g) eqn:G.
  - destruct (S2 E eq_refl) as [Q|Q]; [now left|]. destruct T2' as [R|R]; rewrite Q; auto.
  - destruct (S2' eq_refl F) as [Q|Q]; destruct A2 as [R|R]; rewrite R; auto.
Qed.
Lemma slack_refl f : slack f f = 0.
Proof. unfold slack, slack_place. destruct (deg (anchor f) =? 0), (deg (tip f) =? 0); reflexivity. Qed.
Lemma slack_trans e g f : slack e f <= slack e g + slack g f.
Proof.
  unfold slack, slack_place.
  destruct (deg (anchor e) =? 0), (deg (anchor g) =? 0), (deg (anchor f) =? 0), (deg (tip e) =? 0), (deg (tip g) =? 0), (deg (tip f) =? 0); simpl; lia.
Qed.

Lemma agree_under a b p : a = None \/ a = b -> agree b p = true -> agree a p = true.
Proof. intros [->| ->]; auto. Qed.
Lemma either_under a b p : a = None \/ a = b -> agree b p = true -> either a p = None \/ either a p = either b p.
Proof.
  intros [->| ->] H; [|now right]. simpl. destruct p as [m|]; [|now left]. right. destruct b as [l|]; [|reflexivity].
  simpl in *. apply Nat.eqb_eq in H. now subst.
Qed.
Lemma tidy_under g f : under g f -> under (tidy_place g) (tidy_place f).
Proof.
  intros [A B]. unfold under, tidy_place, open_end. destruct (Nat.ltb_spec (deg g) 2), (Nat.ltb_spec (deg f) 2); cbn [deg port]; try lia; split; auto; lia.
Qed.

Lemma tidy_serves g f : serves g f -> serves (tidy g) (tidy f).
Proof.
  intros (A & T & S). unfold tidy. split; [now apply tidy_under|]. split; [now apply tidy_under|]. cbn [anchor tip same].
  rewrite !tidy_deg. intros Oa Ot. destruct (S Oa Ot) as [S1 S2]. destruct A as [A _], T as [T _]. unfold tidy_place, open_end.
  rewrite !(proj2 (Nat.ltb_lt _ _)) by lia. rewrite !andb_true_r. cbn [anchor tip]. auto.
Qed.
Lemma tidy_slack g f : slack (tidy g) (tidy f) = slack g f.
Proof. unfold slack, slack_place, tidy. cbn [anchor tip]. now rewrite !tidy_deg. Qed.

Ltac slacks := unfold slack, slack_place, lone, more, fresh in *; cbn [anchor tip deg] in *;
  repeat match goal with |- context [?d =? 0] => destruct (Nat.eqb_spec d 0) end; cbn [andb negb] in *; try lia.

Lemma take_serves s b g f f' : serves g f -> take s b f = Some f' ->
  exists g', take s b g = Some g' /\ serves g' f' /\ left_alone s b g + slack g' f' <= left_alone s b f + slack g f.
Proof.
  intros V T. pose proof V as (A & P & S). destruct s as [p|p|p|]; destruct b; cbn [take left_alone] in *; try discriminate.
  - injection T as <-. eexists. split; [reflexivity|]. split.
    + split; [exact A|]. split; [apply under_refl|]. cbn. intros _ _. split; [auto|discriminate].
    + slacks.
  - destruct (open_end (tip f) && agree (port (tip f)) p) eqn:E; [|discriminate]. injection T as <-.
    apply andb_prop in E as [O C]. apply open_room in O. destruct P as [P1 P2]. specialize (P2 O).
    rewrite (agree_under _ _ _ P2 C). unfold open_end at 1. rewrite (proj2 (Nat.ltb_lt _ _)) by lia. cbn [andb].
    eexists. split; [reflexivity|]. rewrite tidy_slack. pose proof (either_under _ _ _ P2 C) as L. split.
    + apply tidy_serves. split; [|split]; cbn [anchor tip same].
      * destruct A as [A1 A2]. split; [destruct (same g), (same f); exact A1|]. intros Oa.
        assert (Oa' : deg (anchor f) < 2) by (destruct (same f); exact Oa). destruct (S Oa' O) as [S1 S2]. specialize (A2 Oa').
        destruct (same g), (same f); cbn [port]; auto; try (specialize (S1 eq_refl); discriminate).
        destruct (S2 eq_refl eq_refl) as [Q|Q]; [now left|]. destruct (port (anchor g)) as [l|]; [|now left]. right. now rewrite <- Q.
      * split; [reflexivity|]. intros _. exact L.
      * intros Oa _. assert (Oa' : deg (anchor f) < 2) by (destruct (same f); exact Oa). destruct (S Oa' O) as [S1 S2]. split; [exact S1|].
        intros Eg Ef. rewrite Eg. destruct (S2 Eg Ef) as [Q|Q]; [now left|]. unfold more. cbn [port].
        destruct (port (anchor g)) as [l|]; [|now left]. right. now rewrite <- Q.
    + destruct (same g), (same f); slacks.
  - injection T as <-. eexists. split; [reflexivity|]. split.
    + split; [exact A|]. split; [apply under_refl|]. cbn. intros _ _. split; [auto|discriminate].
    + slacks.
  - destruct (open_end (tip f) && agree (port (tip f)) p) eqn:E; [|discriminate]. injection T as <-.
    apply andb_prop in E as [O C]. apply open_room in O. destruct P as [P1 P2]. specialize (P2 O).
    rewrite (agree_under _ _ _ P2 C). unfold open_end at 1. rewrite (proj2 (Nat.ltb_lt _ _)) by lia. cbn [andb].
    eexists. split; [reflexivity|]. rewrite tidy_slack. pose proof (either_under _ _ _ P2 C) as L. split.
    + apply tidy_serves. split; [|split]; cbn [anchor tip same].
      * split; [simpl; lia|]. intros _. exact L. * split; [reflexivity|]. intros _. exact L.
      * intros _ _. split; [auto|discriminate].
    + slacks.
  - injection T as <-. eexists. split; [reflexivity|]. split.
    + split; [exact P|]. split; [apply under_refl|]. cbn. intros _ _. split; [auto|discriminate].
    + slacks.
  - destruct (open_end (anchor f) && open_end (tip f) && negb (same f) && agree (port (anchor f)) (port (tip f))) eqn:E; [|discriminate].
    injection T as <-. rewrite !andb_true_iff in E. destruct E as [[[Oa Ot] Ns] C]. apply open_room in Oa, Ot. apply negb_true_iff in Ns.
    destruct A as [A1 A2], P as [P1 P2]. specialize (A2 Oa). specialize (P2 Ot). destruct (S Oa Ot) as [S1 _].
    assert (G : same g = false) by (destruct (same g); [rewrite S1 in Ns by reflexivity; discriminate|reflexivity]).
    assert (C' : agree (port (anchor g)) (port (tip g)) = true).
    { destruct A2 as [->| ->]; [reflexivity|]. destruct P2 as [->| ->]; [now destruct (port (anchor f))|exact C]. }
    rewrite C', G. unfold open_end at 1 2. rewrite !(proj2 (Nat.ltb_lt _ _)) by lia. cbn [andb negb].
    eexists. split; [reflexivity|]. rewrite tidy_slack.
    assert (L : either (port (anchor g)) (port (tip g)) = None \/ either (port (anchor g)) (port (tip g)) = either (port (anchor f)) (port (tip f))).
    { destruct A2 as [->| ->]; destruct P2 as [->| ->]; simpl; auto.
      - destruct (port (tip f)) as [l|]; [|now left]. destruct (port (anchor f)) as [m|]; [|now right]. simpl in *. apply Nat.eqb_eq in C. subst. now right.
      - destruct (port (anchor f)) as [m|]; [now right|now left]. }
    split.
    + apply tidy_serves. split; [|split]; cbn [anchor tip same].
      * split; [simpl; lia|]. intros _. exact L. * split; [simpl; lia|]. intros _. exact L. * intros _ _. split; [auto|discriminate].
    + slacks.
  - injection T as <-. exists g. split; [reflexivity|]. split; [exact V|lia].
Qed.

Lemma at_end_serves g f : at_end g <= at_end f + slack g f.
Proof. unfold at_end. slacks. Qed.
