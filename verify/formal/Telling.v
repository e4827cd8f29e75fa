(** * Comparing the stated changes of answers with the actual ones

    An answer reports how the numbers of strips and of isolated triangles change. The reports of a table's answers form a trie
    over the same colourings. *)
Require Import Arith Bool List NArith ZArith Lia.
Import ListNotations.
Require Import Statements Table Checker Marks.

(** The changes when ports [s] and inner edges [c] become [s'] and [x]: in strips, which are triangles less solid edges
    ([Strips.v]), and in isolated triangles of the patch. *)
Definition changes (p : patch) (s c s' x : coloring) : Z * Z :=
  let strips d ports inner := (Z.of_nat (triangles d) - Z.of_nat (solids ports) - Z.of_nat (solids inner))%Z in
  (strips (after p) s' x - strips (before p) s c,
   Z.of_nat (isolated (after p) s' x) - Z.of_nat (isolated (before p) s c))%Z.
(** The answer of a flip lists its inner edge, then the ports that it keeps. *)
Definition changed (flips : bool) (p : patch) (s c x : coloring) : Z * Z :=
  if flips then changes p s c (tl x) (firstn 1 x) else changes p s c s x.

(** A printed number is 256 (strips + 128) + isolated + 128; the leaf has its sixteen bits, the lowest first. *)
Fixpoint number (bits : coloring) : N :=
  match bits with [] => 0%N | b :: r => if b then N.succ_double (number r) else N.double (number r) end.
Definition told (bits : coloring) : Z * Z :=
  (Z.of_N (number (skipn 8 bits)) - 128, Z.of_N (number (firstn 8 bits)) - 128)%Z.

(** A change is reported exactly for configurations with an answer, and it is the change that the answer makes. *)
Definition tells (flips : bool) (p : patch) (t u : trie) : Prop :=
  forall s c, length s = ports p -> length c = length (inner (before p)) ->
  option_map told (lookup u s c) = option_map (changed flips p s c) (lookup t s c).

(** ** Comparing

    Both tries are gone through at once; marks and solid edges before are kept on the way. *)
Definition right_at (p : patch) (ma m : marks) (n : nat) (x y : coloring) : bool :=
  let v := told y in
  (fst v =? Z.of_nat (triangles (after p)) - Z.of_nat (solids x) - (Z.of_nat (triangles (before p)) - Z.of_nat n))%Z &&
  (snd v =? Z.of_nat (unmarked (mark_inner (inner (after p)) x ma)) - Z.of_nat (unmarked m))%Z.
Fixpoint along_inner (p : patch) (ma : marks) (es : list edge) (m : marks) (n : nat) (t u : trie) : bool :=
  match t, u with
  | Nothing, Nothing => true
  | _, _ =>
      match es with
      | [] => match t, u with Answer x, Answer y => right_at p ma m n x y | _, _ => false end
      | e :: es' =>
          along_inner p ma es' m n (branch false t) (branch false u) &&
          along_inner p ma es' (mark_both e m) (S n) (branch true t) (branch true u)
      end
  end.
Fixpoint along_ports (p : patch) (ob oa : list nat) (mb ma : marks) (t u : trie) : bool :=
  match ob, oa with
  | b :: ob', a :: oa' =>
      along_ports p ob' oa' mb ma (branch false t) (branch false u) &&
      along_ports p ob' oa' (mark b mb) (mark a ma) (branch true t) (branch true u)
  | [], [] => along_inner p ma (inner (before p)) mb 0 t u
  | _, _ => false
  end.
Definition tellsb (p : patch) (t u : trie) : bool :=
  along_ports p (owner (before p)) (owner (after p)) (no_marks (before p)) (no_marks (after p)) t u.

Lemma find_nothing c : find Nothing c = None.
Proof. now apply silent_find. Qed.
Lemma find_cons t b c : find t (b :: c) = find (branch b t) c.
Proof. reflexivity. Qed.

(** What is compared at a leaf, in the words of [changes]. *)
Definition agrees_at (p : patch) (ma m : marks) (n : nat) (c x y : coloring) (es : list edge) : Prop :=
  told y = (Z.of_nat (triangles (after p)) - Z.of_nat (solids x) - (Z.of_nat (triangles (before p)) - Z.of_nat (n + solids c)),
            Z.of_nat (unmarked (mark_inner (inner (after p)) x ma)) - Z.of_nat (unmarked (mark_inner es c m)))%Z.
Definition agree_along (p : patch) (ma m : marks) (n : nat) (c : coloring) (es : list edge) (x y : option coloring) : Prop :=
  match x, y with Some x, Some y => agrees_at p ma m n c x y es | None, None => True | _, _ => False end.

Lemma along_inner_ok p ma es : forall m n t u, along_inner p ma es m n t u = true -> forall c, length c = length es ->
  agree_along p ma m n c es (find t c) (find u c).
Proof.
  induction es as [|e es IH]; intros m n t u A c L.
  - destruct c; [|discriminate]. destruct t as [|x|], u as [|y|]; try discriminate; [exact I|]. cbn [along_inner] in A.
    cbn [find agree_along]. unfold right_at in A. apply andb_prop in A as [F G]. apply Z.eqb_eq in F, G.
    unfold agrees_at. change (solids []) with 0. rewrite Nat.add_0_r. cbn [mark_inner]. rewrite <- F, <- G. now destruct (told y).
  - destruct c as [|b c]; [discriminate|]. injection L as L. rewrite !find_cons.
    assert (B : t = Nothing /\ u = Nothing \/
      along_inner p ma es m n (branch false t) (branch false u) &&
      along_inner p ma es (mark_both e m) (S n) (branch true t) (branch true u) = true).
    { destruct t, u; auto. }
    destruct B as [[-> ->]|B]; [cbn [branch]; rewrite find_nothing; exact I|]. apply andb_prop in B as [F G].
    destruct b; [pose proof (IH _ _ _ _ G c L) as Q|pose proof (IH _ _ _ _ F c L) as Q]; [|exact Q].
    unfold agree_along, agrees_at in *. cbn [mark_inner].
    destruct (find (branch true t) c), (find (branch true u) c); try exact Q.
    rewrite Q. change (solids (true :: c)) with (S (solids c)). now rewrite Nat.add_succ_r.
Qed.
Lemma along_ports_ok p ob : forall oa mb ma t u, along_ports p ob oa mb ma t u = true -> forall s c, length s = length ob ->
  length c = length (inner (before p)) ->
  agree_along p (mark_owners oa s ma) (mark_owners ob s mb) 0 c (inner (before p)) (find t (s ++ c)) (find u (s ++ c)).
Proof.
  induction ob as [|b ob IH]; intros [|a oa] mb ma t u A s c Ls Lc; try discriminate.
  - destruct s; [|discriminate]. now apply along_inner_ok.
  - destruct s as [|v s]; [discriminate|]. injection Ls as Ls. cbn [along_ports] in A. apply andb_prop in A as [F G].
    destruct v; cbn [app mark_owners]; rewrite !find_cons; now apply IH.
Qed.
Theorem tellsb_ok p t u : tellsb p t u = true -> tells false p t u.
Proof.
  intros A s c Ls Lc. pose proof (along_ports_ok _ _ _ _ _ _ _ A s c Ls Lc) as Q. unfold lookup, changed.
  unfold agree_along, agrees_at in Q. destruct (find t (s ++ c)) as [x|], (find u (s ++ c)) as [y|]; try contradiction; [|reflexivity].
  cbn [option_map]. f_equal. rewrite Q, !unmarked_isolated. unfold changes. f_equal. lia.
Qed.

(** Flips are few: every configuration is tried. *)
Definition same_told (v w : option (Z * Z)) : bool :=
  match v, w with Some v, Some w => (fst v =? fst w)%Z && (snd v =? snd w)%Z | None, None => true | _, _ => false end.
Definition tells_each (flips : bool) (p : patch) (t u : trie) : bool :=
  forallb (fun s => forallb (fun c =>
      same_told (option_map told (lookup u s c)) (option_map (changed flips p s c) (lookup t s c)))
    (all_colorings (length (inner (before p))))) (all_colorings (ports p)).
Lemma tells_each_ok flips p t u : tells_each flips p t u = true -> tells flips p t u.
Proof.
  intros A s c Ls Lc. unfold tells_each in A. rewrite forallb_forall in A. specialize (A s ltac:(now apply all_colorings_ok)).
  rewrite forallb_forall in A. specialize (A c ltac:(now apply all_colorings_ok)).
  destruct (option_map told (lookup u s c)) as [[a b]|], (option_map _ (lookup t s c)) as [[a' b']|]; try discriminate; [|reflexivity].
  apply andb_prop in A as [F G]. apply Z.eqb_eq in F, G. cbn [fst snd] in *. congruence.
Qed.
