(** * Every read of the look-up lies inside its array

    [bounds_ok] tests this for every index that a kind of arc, or a pair of kinds, can form. It follows that memory after the
    arrays has no influence on any answer. *)
Require Import Arith Bool List NArith FMapPositive Lia.
Import ListNotations.
Require Import Statements Frontier Fold Arcs Header Kinds.

Lemma read_longer t t' n : longer t t' -> inside_array t n = true -> read t' n = read t n.
Proof.
  unfold inside_array, read. intros L. destruct (PositiveMap.find (N.succ_pos n) t) as [x|] eqn:F; [|discriminate].
  now rewrite (L _ _ F).
Qed.

Section Bounds.
  Variable H : header.

  (** A letter more, forwards and back. *)
  Definition step_inside (x : N) (l : letter) : bool :=
    (inside_array (next_class H) (4 * x + number l) && inside_array (before_case H) (4 * x + number l))%N.
  (** The case of a closed fan has four bits, by which [before] is shifted. *)
  Definition closing_inside (x : N) : bool := inside_array (closed_case H) x && (read (closed_case H) x <? 16)%N.
  Definition place_of (x y : N) : N := (seconds H * read (first_row H) x + read (second_column H) y)%N.
  Definition meeting_inside (x y : N) : bool :=
    inside_array (first_row H) x && inside_array (second_column H) y &&
    inside_array (meet_index H) (place_of x y) && inside_array (meetings H) (read (meet_index H) (place_of x y)).
  Definition rimless (K : kind) : bool := negb (rim (about K)).
  Definition bounds_ok (Ks : list kind) : bool :=
    forallb (step_inside 0) (letters_after empty_kind) &&
    forallb (fun K => forallb (step_inside (cl K)) (letters_after K)) Ks &&
    forallb (fun K => closing_inside (cl K) && forallb (fun K' => meeting_inside (cl K) (cl K')) Ks) (filter rimless Ks).

  Variable R : kinds.
  Hypothesis all : closed H R = true.
  Hypothesis ok : bounds_ok (listed R) = true.
  Lemma ok_parts : (forall l, In l (letters_after empty_kind) -> step_inside 0 l = true) /\
    (forall K, In K (listed R) -> forall l, In l (letters_after K) -> step_inside (cl K) l = true) /\
    (forall K, In K (listed R) -> rimless K = true -> closing_inside (cl K) = true /\
      forall K', In K' (listed R) -> meeting_inside (cl K) (cl K') = true).
  Proof.
    unfold bounds_ok in ok. apply andb_prop in ok as [O C]. apply andb_prop in O as [A B]. rewrite forallb_forall in A, B, C.
    split; [exact A|]. split.
    - intros K I. specialize (B K I). now rewrite forallb_forall in B.
    - intros K I E. specialize (C K ltac:(apply filter_In; now split)). apply andb_prop in C as [C D]. split; [exact C|].
      now rewrite forallb_forall in D.
  Qed.

  Lemma steps_inside l u : edges (l :: u) <= 1 -> step_inside (arc_class H u) l = true.
  Proof.
    intros E. destruct ok_parts as (A & B & _). destruct u as [|l' u].
    - apply A. destruct l; simpl; auto.
    - destruct (every_kind H R all (l' :: u)) as (K & m & I & (C & Ab & _)); [discriminate|destruct l; cbn [edges] in E |- *; lia|].
      rewrite <- C. apply B; [exact I|]. unfold letters_after. rewrite Ab, rim_edges.
      destruct l; destruct (Nat.eqb_spec (edges (l' :: u)) 0); cbn [negb]; simpl; auto.
      cbn [edges] in E. destruct l'; cbn [edges] in *; lia.
  Qed.
  Lemma closings_inside w : w <> [] -> edges w = 0 -> closing_inside (arc_class H w) = true.
  Proof.
    intros N E. destruct (every_kind H R all w N ltac:(lia)) as (K & m & I & (C & Ab & _)). destruct ok_parts as (_ & _ & D).
    rewrite <- C. apply D; [exact I|]. unfold rimless. now rewrite Ab, rim_edges, E.
  Qed.
  Lemma meetings_inside w1 w2 : w1 <> [] -> w2 <> [] -> edges w1 = 0 -> edges w2 <= 1 ->
    meeting_inside (arc_class H w1) (arc_class H w2) = true.
  Proof.
    intros N1 N2 E1 E2. destruct (every_kind H R all w1 N1 ltac:(lia)) as (K1 & m1 & I1 & (C1 & A1 & _)).
    destruct (every_kind H R all w2 N2 E2) as (K2 & m2 & I2 & (C2 & _)). destruct ok_parts as (_ & _ & D).
    rewrite <- C1, <- C2. apply D; [exact I1| |exact I2]. unfold rimless. now rewrite A1, rim_edges, E1.
  Qed.

  (** ** Independence of the memory after the arrays *)
  Variable H' : header.
  Hypothesis same : same_inside H H'.

  Lemma arc_same w : edges w <= 1 -> arc_class H' w = arc_class H w /\ forall e, trace H' w e = trace H w e.
  Proof.
    destruct same as (Sn & Sb & _). induction w as [|l u IH]; intros E; [split; reflexivity|].
    destruct IH as [IHc IHt]; [destruct l; cbn [edges] in E; lia|].
    pose proof (steps_inside l u E) as S. apply andb_prop in S as [In_next In_before]. cbn [arc_class trace]. rewrite IHc. split.
    - unfold go. now apply read_longer.
    - intros e. assert (Q : came H' (arc_class H u) l e = came H (arc_class H u) l e) by (unfold came; now rewrite (read_longer _ _ _ Sb In_before)).
      now rewrite Q, IHt.
  Qed.
  Lemma links_same w e : edges w <= 1 -> links H' w e = links H w e.
  Proof. intros E. unfold links. now rewrite (proj2 (arc_same w E)). Qed.
  Lemma meet_arcs_same w1 w2 : w1 <> [] -> w2 <> [] -> edges w1 = 0 -> edges w2 <= 1 -> meet_arcs H' w1 w2 = meet_arcs H w1 w2.
  Proof.
    intros N1 N2 E1 E2. pose proof (meetings_inside w1 w2 N1 N2 E1 E2) as M. unfold meeting_inside in M.
    apply andb_prop in M as [M M4]. apply andb_prop in M as [M M3]. apply andb_prop in M as [M1 M2].
    destruct same as (_ & _ & _ & S1 & S2 & S3 & S4 & Ss).
    assert (Q : meeting H' (arc_class H' w1) (arc_class H' w2) = meeting H (arc_class H w1) (arc_class H w2)).
    { rewrite (proj1 (arc_same w1 ltac:(lia))), (proj1 (arc_same w2 E2)). unfold meeting. rewrite Ss.
      rewrite (read_longer _ _ _ S1 M1), (read_longer _ _ _ S2 M2). fold (place_of (arc_class H w1) (arc_class H w2)).
      now rewrite (read_longer _ _ _ S3 M3), (read_longer _ _ _ S4 M4). }
    unfold meet_arcs. rewrite Q. destruct (meeting H (arc_class H w1) (arc_class H w2)) as [[e1 e2] ch].
    now rewrite !links_same by lia.
  Qed.

  Lemma no_edges s J i n : edges (letters s J i n) = 0.
  Proof.
    unfold letters. rewrite <- map_rev. induction (rev (seq i n)) as [|x l IH]; [reflexivity|]. cbn [map].
    unfold letter_at at 1. destruct (nth x s false); [destruct (nth x J false)|]; exact IH.
  Qed.
  Lemma letters_there s J i n : 0 < n -> letters s J i n <> [].
  Proof. intros P Q. apply (f_equal (@length _)) in Q. unfold letters in Q. rewrite rev_length, map_length, seq_length in Q. simpl in Q. lia. Qed.
  Lemma edges_app u v : edges (u ++ v) = edges u + edges v.
  Proof. induction u as [|[] u IH]; cbn [app edges]; lia. Qed.

  Theorem answers_inside :
    (forall k a s J, 1 <= a < k -> split_answer H' k a s J = split_answer H k a s J) /\
    (forall k s J, 1 <= k -> collapse_answer H' k s J = collapse_answer H k s J) /\
    (forall k i j s J, i < j <= k -> open_split_answer H' k i j s J = open_split_answer H k i j s J) /\
    (forall k i s J, boundary_split_answer H' k i s J = boundary_split_answer H k i s J) /\
    (forall k s J, fan_collapse_answer H' k s J = fan_collapse_answer H k s J).
  Proof.
    split; [|split; [|split; [|split]]].
    - intros k a s J A. unfold split_answer, split_walk.
      now rewrite meet_arcs_same by (apply letters_there || rewrite ?no_edges; lia).
    - intros k s J A. unfold collapse_answer, collapse_walk. set (w := letters s (of_closed s J) 0 k).
      assert (E : edges w = 0) by apply no_edges. assert (N : w <> []) by (apply letters_there; lia).
      pose proof (closings_inside w N E) as C. apply andb_prop in C as [C _]. destruct same as (_ & _ & Sc & _).
      rewrite (proj1 (arc_same w ltac:(lia))), (read_longer _ _ _ Sc C). now rewrite links_same by lia.
    - intros k i j s J A. unfold open_split_answer, open_split_walk. rewrite meet_arcs_same; [reflexivity| | | |].
      + apply letters_there; lia.
      + intros Q. apply (f_equal (@length _)) in Q. rewrite app_length in Q. simpl in Q. lia.
      + apply no_edges.
      + rewrite edges_app, no_edges. cbn [edges]. rewrite no_edges. lia.
    - intros k i s J. unfold boundary_split_answer, boundary_split_walk. rewrite links_same; [reflexivity|].
      rewrite edges_app, no_edges. cbn [edges]. rewrite no_edges. lia.
    - intros k s J. unfold fan_collapse_answer, fan_collapse_walk. rewrite links_same; [reflexivity|]. rewrite no_edges. lia.
  Qed.
End Bounds.
