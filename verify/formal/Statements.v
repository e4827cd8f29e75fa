(** * What is proved: the definitions and statements that must be trusted

    Every definition that the main theorems use, and the theorems themselves, as statements: [Rules_right T] and the like are
    the claims about a table [T]. [Main.v] proves each of them, for the shipped tables if it is about tables; apart from
    these, it proves only comparisons of numbers. This file needs only Coq's library. The numbering follows
    docs/reference/notation.md.

    The parts are: graphs, patches, best recolourings, tables, the families, flips, positions and the rules; then,
    independently, the look-up in the automaton, sequences of operations, whole meshes, a lower bound, and runs. *)
Require Import Arith Bool List NArith ZArith FMapPositive Permutation.
Import ListNotations.

(** ** Graphs

    A graph is the list of its edges; its vertices are numbers. Here the edges are always the *solid* ones. *)
Definition edge := (nat * nat)%type.
Definition graph := list edge.

Definition meets (e : edge) (v : nat) : nat := (if fst e =? v then 1 else 0) + (if snd e =? v then 1 else 0).
Definition degree (G : graph) (v : nat) : nat := list_sum (map (fun e => meets e v) G).
Definition adjacent (G : graph) (v w : nat) : Prop := In (v, w) G \/ In (w, v) G.

(** [linked G u v]: a walk along solid edges leads from u to v. *)
Inductive linked (G : graph) (u : nat) : nat -> Prop :=
| here : linked G u u
| onward v w : linked G u v -> adjacent G v w -> linked G u w.

(** No cycle: every edge is a bridge. Whichever edge [e] is taken away, the rest no longer links its ends. *)
Definition acyclic (G : graph) : Prop :=
  forall e rest, Permutation G (e :: rest) -> ~ linked rest (fst e) (snd e).

(** A colouring is valid when its solid edges form paths: no degree above two, no cycle. *)
Definition valid (G : graph) : Prop := (forall v, degree G v <= 2) /\ acyclic G.

(** The same in other words, as [Strips.v] proves: the vertices [vs] can be listed strip by strip, each once, so that
    the edges of [G] are the pairs of neighbours in the lists. *)
Fixpoint path_edges (l : list nat) : list edge :=
  match l with u :: (v :: _) as l' => (u, v) :: path_edges l' | _ => [] end.
Definition undirected (e : edge) : edge := (Nat.min (fst e) (snd e), Nat.max (fst e) (snd e)).
Definition stripped (vs : list nat) (G : graph) (strips : list (list nat)) : Prop :=
  ~ In [] strips /\
  Permutation (concat strips) vs /\
  Permutation (map undirected (concat (map path_edges strips))) (map undirected G).

(** ** Patches

    One side of an operation: how many triangles, which inner dual edges in which order, and to which triangle each
    port belongs. A patch has two sides; both have the same ports. *)
Record side := Side { triangles : nat; inner : list edge; owner : list nat }.
Record patch := Patch { before : side; after : side }.
Definition ports (p : patch) : nat := length (owner (before p)).
Definition sensible (p : patch) (d : side) : Prop :=
  length (owner d) = ports p /\ (forall t, In t (owner d) -> t < triangles d) /\
  (forall e, In e (inner d) -> fst e < triangles d /\ snd e < triangles d).

(** A colouring of edges is a list of booleans, one for each edge in order, [true] = solid. *)
Definition coloring := list bool.
Fixpoint solid (es : list edge) (c : coloring) : graph :=
  match es, c with
  | e :: es', true :: c' => e :: solid es' c'
  | _ :: es', false :: c' => solid es' c'
  | _, _ => []
  end.

(** The vertices: port i is cut at a point, and the point is vertex i; triangle t is vertex [k + t] where k is the
    number of ports. What lies outside the patch begins at the points. *)
Definition port_edges (d : side) : list edge :=
  combine (seq 0 (length (owner d))) (map (fun t => length (owner d) + t) (owner d)).
Definition inner_edges (d : side) : list edge :=
  map (fun e => (length (owner d) + fst e, length (owner d) + snd e)) (inner d).
Definition drawing (d : side) (ports inner : coloring) : graph :=
  solid (port_edges d) ports ++ solid (inner_edges d) inner.

(** ** Legal, best

    A recolouring is sound when it is valid and links no two ports that were not linked before: [s], [c] are the ports
    and the inner edges before, [s'], [x] those after. [Locality.v] proves that this is the same as "valid whatever
    lies outside". Fans keep every port: their rules are [legal]. *)
Definition sound (p : patch) (s c s' x : coloring) : Prop :=
  length x = length (inner (after p)) /\
  valid (drawing (after p) s' x) /\
  forall i j, i < ports p -> j < ports p ->
    linked (drawing (after p) s' x) i j -> linked (drawing (before p) s c) i j.
Definition legal (p : patch) (s c x : coloring) : Prop := sound p s c s x.

(** The rest of a mesh is any graph that meets the patch in nothing but the port points. *)
Definition rest_of_mesh (p : patch) (O : graph) : Prop :=
  let triangle v := ports p <= v < ports p + Nat.max (triangles (before p)) (triangles (after p)) in
  forall e, In e O -> ~ triangle (fst e) /\ ~ triangle (snd e).

Definition solids (x : coloring) : nat := length (filter id x).
Definition isolated (d : side) (s x : coloring) : nat :=
  length (filter (fun t => degree (drawing d s x) (length (owner d) + t) =? 0) (seq 0 (triangles d))).

(** The order of preference: more solid edges; if equal, no more isolated triangles. *)
Definition as_good (d : side) (s x y : coloring) : Prop :=
  solids y < solids x \/ (solids y = solids x /\ isolated d s x <= isolated d s y).
Definition best (p : patch) (s c x : coloring) : Prop :=
  legal p s c x /\ forall y, legal p s c y -> as_good (after p) s x y.

(** ** What a table must do

    [T s c] is the table's answer for the configuration with ports [s] and inner edges [c] before. *)
Definition table := coloring -> coloring -> option coloring.
Definition correct (p : patch) (T : table) : Prop :=
  forall s c, length s = ports p -> length c = length (inner (before p)) ->
    (valid (drawing (before p) s c) -> exists x, T s c = Some x /\ best p s c x) /\
    (~ valid (drawing (before p) s c) -> T s c = None).

(** The facts: no rule costs more than [strips] strips or adds more than [alone] isolated triangles. The number of
    strips is the number of triangles minus the number of solid edges ([Strips.v]). *)
Definition within (p : patch) (T : table) (strips alone : nat) : Prop :=
  forall s c x, length s = ports p -> length c = length (inner (before p)) -> T s c = Some x ->
    triangles (after p) + solids c <= triangles (before p) + solids x + strips /\
    isolated (after p) s x <= isolated (before p) s c + alone.

(** A valid mesh stays valid, whatever lies outside the patch. *)
Definition safe (p : patch) (T : table) : Prop :=
  forall s c x O, length s = ports p -> length c = length (inner (before p)) -> T s c = Some x -> rest_of_mesh p O ->
    valid (O ++ drawing (before p) s c) -> valid (O ++ drawing (after p) s x).

(** ** Keys

    The solid port before port i: the nearest in descending order, around the fan when it is closed. Mask [J] is the
    second half of a configuration's key when it says which solid ports are linked to the solid port before them. *)
Definition preceding (closed : bool) (s : coloring) (i : nat) : option nat :=
  List.find (fun j => nth j s false)
    (rev (seq 0 i) ++ if closed then rev (seq (S i) (length s - S i)) else []).
Definition joined (p : patch) (closed : bool) (s c J : coloring) : Prop :=
  length J = ports p /\
  forall i, i < ports p ->
    (nth i J false = true <->
     nth i s false = true /\ exists j, preceding closed s i = Some j /\ linked (drawing (before p) s c) i j).

(** A reduced table [R], which sees keys only, says the same as the full one. *)
Definition reduces_to (p : patch) (closed : bool) (T : table) (R : table) : Prop :=
  forall s c, length s = ports p -> length c = length (inner (before p)) -> valid (drawing (before p) s c) ->
    exists J, joined p closed s c J /\ T s c = R s J.

(** ** The families of docs/reference/notation.md

    Triangle t_i is number i, A is number k, D is number k + 1. *)
Definition ring_edges (l : list nat) : list edge := path_edges (l ++ firstn 1 l).

Definition closed_fan (k : nat) : side := Side k (ring_edges (seq 0 k)) (seq 0 k).
Definition open_fan (k : nat) : side := Side k (path_edges (seq 0 k)) (seq 0 k).
Definition ring_with_chord (k a : nat) : side :=
  Side (k + 2) (ring_edges (k :: seq 0 a ++ k + 1 :: seq a (k - a)) ++ [(k, k + 1)]) (seq 0 k).
Definition path_with_chord (k i j : nat) : side :=
  Side (k + 2) (path_edges (seq 0 i ++ k :: seq i (j - i) ++ k + 1 :: seq j (k - j)) ++ [(k, k + 1)]) (seq 0 k).
Definition path_with_one (k i : nat) : side :=
  Side (k + 1) (path_edges (seq 0 i ++ k :: seq i (k - i))) (seq 0 k).

Definition split (k a : nat) : patch := Patch (closed_fan k) (ring_with_chord k a).
Definition collapse (k a : nat) : patch := Patch (ring_with_chord k a) (closed_fan k).
Definition open_split (k i j : nat) : patch := Patch (open_fan k) (path_with_chord k i j).
Definition open_collapse (k i j : nat) : patch := Patch (path_with_chord k i j) (open_fan k).
Definition boundary_split (k i : nat) : patch := Patch (open_fan k) (path_with_one k i).
Definition boundary_collapse (k i : nat) : patch := Patch (path_with_one k i) (open_fan k).

(** ** Flips give ports up

    An answer is the inner edge and the ports kept. More solid edges, ports included; if equal, fewer isolated
    triangles, each port given up counted as one; if equal, more ports kept. *)
Definition flip : patch := Patch (Side 2 [(0, 1)] [0; 0; 1; 1]) (Side 2 [(0, 1)] [1; 0; 0; 1]).

Definition kept (s s' : coloring) : Prop := length s' = length s /\ forall i, nth i s' false = true -> nth i s false = true.
Definition flip_legal (s c s' x : coloring) : Prop := kept s s' /\ sound flip s c s' x.
Definition lone_or_given_up (s s' x : coloring) : nat := isolated (after flip) s' x + (solids s - solids s').
Definition flip_as_good (s s' x t' y : coloring) : Prop :=
  let edges_x := solids s' + solids x in let edges_y := solids t' + solids y in
  let lone_x := lone_or_given_up s s' x in let lone_y := lone_or_given_up s t' y in
  edges_y < edges_x \/
  (edges_y = edges_x /\ (lone_x < lone_y \/ (lone_x = lone_y /\ solids t' <= solids s'))).
Definition flip_best (s c s' x : coloring) : Prop :=
  flip_legal s c s' x /\ forall t' y, flip_legal s c t' y -> flip_as_good s s' x t' y.

(** The table's answer lists the inner edge first, then the four ports. *)
Definition flip_correct (T : table) : Prop :=
  forall s c, length s = 4 -> length c = 1 ->
    (valid (drawing (before flip) s c) -> exists x s', T s c = Some (x ++ s') /\ flip_best s c s' x) /\
    (~ valid (drawing (before flip) s c) -> T s c = None).

Definition flip_within (T : table) (strips alone : nat) : Prop :=
  forall s c x s', length s = 4 -> length c = 1 -> length x = 1 -> T s c = Some (x ++ s') ->
    solids s + solids c <= solids s' + solids x + strips /\
    lone_or_given_up s s' x <= isolated (before flip) s c + alone.
Definition flip_safe (T : table) : Prop :=
  forall s c x s' O, length s = 4 -> length c = 1 -> length x = 1 -> T s c = Some (x ++ s') -> rest_of_mesh flip O ->
    valid (O ++ drawing (before flip) s c) -> valid (O ++ drawing (after flip) s' x).

(** ** The locality lemma, and what a colouring is *)

(** Legal is the same as "valid, whatever lies outside the patch". *)
Definition Locality : Prop := forall p, sensible p (before p) -> sensible p (after p) -> forall s c x,
  length x = length (inner (after p)) -> valid (drawing (before p) s c) ->
  (legal p s c x <->
   forall O, rest_of_mesh p O -> valid (O ++ drawing (before p) s c) -> valid (O ++ drawing (after p) s x)).

(** Valid colourings are lists of strips, whose number is vertices minus edges. *)
Definition Valid_is_stripped : Prop := forall vs G, NoDup vs -> (forall e, In e G -> In (fst e) vs /\ In (snd e) vs) ->
  (valid G <-> exists strips, stripped vs G strips /\ length strips + length G = length vs).

(** ** The rules

    Positions of the six families of fans, [k] being the number of triangles of the fan. *)
Inductive position :=
| split_at (k a : nat) | collapse_at (k a : nat)
| open_split_at (k i j : nat) | open_collapse_at (k i j : nat)
| boundary_split_at (k i : nat) | boundary_collapse_at (k i : nat).

Definition possible (o : position) : bool :=
  match o with
  | split_at k a | collapse_at k a => (3 <=? k) && (1 <=? a) && (a <? k)
  | open_split_at k i j | open_collapse_at k i j => (1 <=? k) && (i <? j) && (j <=? k)
  | boundary_split_at k i | boundary_collapse_at k i => (1 <=? k) && (i <=? k)
  end.
Definition patch_at (o : position) : patch :=
  match o with
  | split_at k a => split k a | collapse_at k a => collapse k a
  | open_split_at k i j => open_split k i j | open_collapse_at k i j => open_collapse k i j
  | boundary_split_at k i => boundary_split k i | boundary_collapse_at k i => boundary_collapse k i
  end.
Definition valence_at (o : position) : nat :=
  match o with
  | split_at k _ | collapse_at k _ | open_split_at k _ _ | open_collapse_at k _ _
  | boundary_split_at k _ | boundary_collapse_at k _ => k
  end.
Definition closed_at (o : position) : bool := match o with split_at _ _ | collapse_at _ _ => true | _ => false end.

(** How many strips and isolated triangles a rule may add. *)
Definition strips_at (o : position) : nat :=
  match o with
  | split_at k a => if Nat.min a (k - a) =? 1 then 0 else 1
  | open_split_at k i j => if j =? S i then 0 else 1
  | boundary_split_at k i => if Nat.min i (k - i) =? 1 then 0 else 1
  | collapse_at _ _ | open_collapse_at _ _ _ => 1
  | boundary_collapse_at _ _ => 0
  end.
Definition isolated_at (o : position) : nat :=
  match o with
  | split_at _ _ | collapse_at _ _ | open_split_at _ _ _ => 0
  | boundary_split_at k _ => if Nat.even k then 1 else 0
  | open_collapse_at k _ _ | boundary_collapse_at k _ => if Nat.even k then 0 else 1
  end.

Definition right_at (o : position) (T : table) : Prop :=
  correct (patch_at o) T /\ safe (patch_at o) T /\ within (patch_at o) T (strips_at o) (isolated_at o).
(** Of the tables of fans of at most eight triangles, and of tables for every k. *)
Definition Rules_right (T : position -> table) : Prop := forall o, possible o = true -> valence_at o <= 8 -> right_at o (T o).
Definition Every_rule_right (T : position -> table) : Prop := forall o, possible o = true -> right_at o (T o).
(** A boundary split of at most eight triangles isolates one only when k and the gap are even. *)
Definition Even_gaps (T : position -> table) : Prop := forall k i, 1 <= k <= 8 -> i <= k ->
  within (boundary_split k i) (T (boundary_split_at k i)) (strips_at (boundary_split_at k i))
    (if Nat.even k && Nat.even i then 1 else 0).

(** Two correct tables differ in nothing but which of the best recolourings they give. *)
Definition Correct_tables_agree : Prop := forall p T U s c x, correct p T -> correct p U -> length s = ports p ->
  length c = length (inner (before p)) -> T s c = Some x ->
  exists y, U s c = Some y /\ solids x = solids y /\ isolated (after p) s x = isolated (after p) s y.
Definition Correct_tables_cost : Prop := forall p T U strips alone, correct p T -> correct p U ->
  within p T strips alone -> within p U strips alone.

(** Certificates have rows [R] for half of the positions of closed fans; the others are turned onto these. *)
Definition listed (o : position) : bool :=
  match o with
  | split_at k a | collapse_at k a => 2 * a <=? k
  | _ => false
  end.
Definition Rows_say_the_same (T R : position -> table) : Prop := forall o, possible o = true -> valence_at o <= 8 ->
  listed o = true -> reduces_to (patch_at o) (closed_at o) (T o) (R o).

(** A flip costs at most one strip, and isolates at most two triangles, a port given up counted as one. *)
Definition Flip_right (T : table) : Prop := flip_correct T /\ flip_safe T /\ flip_within T 1 2.

(** ** The automaton

    What runtime/include/restrip/rules/exact.hpp does with the numbers of automaton.hpp, said in Coq; it is all of that
    code that the theorems know. docs/explanation/automaton.md explains letters, classes and cases. *)
Inductive letter := Plain | Alone | Joined | Edge.

Module Lookup.
Local Open Scope N_scope.

(** The arrays of automaton.hpp, found by index. *)
Definition array := PositiveMap.t N.
Definition array_of (l : list N) : array :=
  fst (fold_left (fun '(t, p) n => (PositiveMap.add p n t, Pos.succ p)) l (PositiveMap.empty N, 1%positive)).
Definition read (t : array) (n : N) : N := match PositiveMap.find (N.succ_pos n) t with Some x => x | None => 0 end.
(** Beyond its end an array of C++ has no value, and here 0. The look-up does not go there ([Automaton_inside]). *)
Definition inside_array (t : array) (n : N) : bool := match PositiveMap.find (N.succ_pos n) t with Some _ => true | None => false end.
Record header := Header { next_class : array; before_case : array; closed_case : array; first_row : array; second_column : array;
  meet_index : array; meetings : array; seconds : N }.

Definition longer (t t' : array) : Prop := forall n x, PositiveMap.find n t = Some x -> PositiveMap.find n t' = Some x.
Definition same_inside (H H' : header) : Prop :=
  longer (next_class H) (next_class H') /\ longer (before_case H) (before_case H') /\ longer (closed_case H) (closed_case H') /\
  longer (first_row H) (first_row H') /\ longer (second_column H) (second_column H') /\ longer (meet_index H) (meet_index H') /\
  longer (meetings H) (meetings H') /\ seconds H' = seconds H.

Definition number (l : letter) : N := match l with Plain => 0 | Alone => 1 | Joined => 2 | Edge => 3 end.
Definition solid_link (e : N) : bool := negb (N.land e 3 =? 0).

Section Walk.
  Variable H : header.

  (** An arc is a list with its last letter first, [trace w e]: the colours of the links to the left of its
      letters, the last first, when [e] is the case of the whole arc. *)
  Definition go (x : N) (l : letter) : N := read (next_class H) (4 * x + number l).
  Definition came (x : N) (l : letter) (e : N) : N := N.land (N.shiftr (read (before_case H) (4 * x + number l)) (4 * e)) 15.
  Fixpoint arc_class (w : list letter) : N := match w with [] => 0 | l :: u => go (arc_class u) l end.
  Fixpoint trace (w : list letter) (e : N) : coloring :=
    match w with
    | [] => []
    | l :: u => let e' := came (arc_class u) l e in solid_link e' :: trace u e'
    end.

  (** The cases of two arcs that meet, and the chord. *)
  Definition meeting (x y : N) : N * N * bool :=
    let m := read (meetings H) (read (meet_index H) (seconds H * read (first_row H) x + read (second_column H) y)) in
    (N.land m 15, N.land (N.shiftr m 4) 15, negb (N.land (N.shiftr m 8) 1 =? 0)).

  (** The links of an arc, from left to right. *)
  Definition links (w : list letter) (e : N) : coloring := rev (solid_link e :: trace w e).
  Definition inside (l : coloring) : coloring := tl (removelast l).

  (** The letter of a triangle. *)
  Definition letter_at (s J : coloring) (i : nat) : letter :=
    if nth i s false then if nth i J false then Joined else Alone else Plain.
  (** Letters [i], ..., [i + n - 1], the last first. *)
  Definition letters (s J : coloring) (i n : nat) : list letter := rev (map (letter_at s J) (seq i n)).

  (** The answers, in the order of edges of the patches above. *)
  Definition meet_arcs (w1 w2 : list letter) : coloring * coloring * bool :=
    let '(e1, e2, ch) := meeting (arc_class w1) (arc_class w2) in (links w1 e1, links w2 e2, ch).
  Definition split_walk (k a : nat) (s J : coloring) : coloring :=
    let '(l1, l2, ch) := meet_arcs (letters s J 0 a) (letters s J a (k - a)) in
    l1 ++ l2 ++ [ch].
  Definition collapse_walk (k : nat) (s J : coloring) : coloring :=
    let w := letters s J 0 k in tl (links w (read (closed_case H) (arc_class w))).
  Definition open_split_walk (k i j : nat) (s J : coloring) : coloring :=
    let '(l1, l2, ch) := meet_arcs (letters s J i (j - i)) (letters s J 0 i ++ Edge :: letters s J j (k - j)) in
    skipn (k - j + 2) l2 ++ l1 ++ firstn (k - j) l2 ++ [ch].
  Definition boundary_split_walk (k i : nat) (s J : coloring) : coloring :=
    inside (links (letters s J i (k - i) ++ Plain :: letters s J 0 i) 0).
  Definition fan_collapse_walk (k : nat) (s J : coloring) : coloring :=
    inside (links (letters s J 0 k) 0).

  (** From keys: with exactly two solid ports in a closed fan either bit stands for the pair; in an open fan nothing lies before
      the first solid port. *)
  Definition of_closed (s J : coloring) : coloring :=
    let both := map (fun i => nth i s false && nth i J false)%bool (seq 0 (length s)) in
    if ((length (filter id s) =? 2)%nat && existsb id both)%bool then s else both.
  Definition of_open (s J : coloring) : coloring :=
    map (fun i => nth i s false && nth i J false && existsb (fun m => nth m s false) (seq 0 i))%bool (seq 0 (length s)).
  Definition split_answer (k a : nat) (s J : coloring) : coloring := split_walk k a s (of_closed s J).
  Definition collapse_answer (k : nat) (s J : coloring) : coloring := collapse_walk k s (of_closed s J).
  Definition open_split_answer (k i j : nat) (s J : coloring) : coloring := open_split_walk k i j s (of_open s J).
  Definition boundary_split_answer (k i : nat) (s J : coloring) : coloring := boundary_split_walk k i s (of_open s J).
  Definition fan_collapse_answer (k : nat) (s J : coloring) : coloring := fan_collapse_walk k s (of_open s J).
End Walk.

(** The answer at a position. *)
Definition answer (H : header) (o : position) : coloring -> coloring -> coloring :=
  match o with
  | split_at k a => split_answer H k a
  | collapse_at k _ => collapse_answer H k
  | open_split_at k i j => open_split_answer H k i j
  | boundary_split_at k i => boundary_split_answer H k i
  | open_collapse_at k _ _ | boundary_collapse_at k _ => fan_collapse_answer H k
  end.
End Lookup.

(** For every k: the answers, which are a function of the key, make up a correct table. *)
Definition serves_keys (p : patch) (closed : bool) (answer : coloring -> coloring -> coloring) : Prop :=
  exists T, correct p T /\ safe p T /\ reduces_to p closed T (fun s J => Some (answer s J)).
Definition Automaton_serves (H : Lookup.header) : Prop := forall o, possible o = true ->
  serves_keys (patch_at o) (closed_at o) (Lookup.answer H o).
(** Every read stays inside its array: the answers do not depend on the memory after the arrays. *)
Definition Automaton_inside (H : Lookup.header) : Prop := forall H', Lookup.same_inside H H' -> forall o, possible o = true ->
  forall s J, Lookup.answer H' o s J = Lookup.answer H o s J.

(** ** Sequences of operations

    A mesh is the list of its triangles and the graph of its solid dual edges. An operation sees a mesh as a patch and the
    rest. The port points, in the middle of the dual edges that leave the patch, are not part of a mesh; here they are
    skipped. Flips are left out: they may give ports up. *)
(** [G'] is [G] with its vertices renamed; order and directions do not count. *)
Definition moved (f : nat -> nat) (e : edge) : edge := (f (fst e), f (snd e)).
Definition renamed (f : nat -> nat) (G G' : graph) : Prop := Permutation (map undirected (map (moved f) G)) (map undirected G').

Module Meshes.
Record mesh := Mesh { nodes : list nat; edges : graph }.
(** Triangles are listed once, and solid edges join triangles of the mesh. *)
Definition sane (M : mesh) : Prop := NoDup (nodes M) /\ forall v, degree (edges M) v <> 0 -> In v (nodes M).
(** The number of strips of a valid mesh. *)
Definition strips_of (M : mesh) : Z := Z.of_nat (length (nodes M)) - Z.of_nat (length (edges M)).
Definition none_isolated (M : mesh) : Prop := forall v, In v (nodes M) -> degree (edges M) v <> 0.

(** Passing over points: two edges that end at a point become one; a point without edges is dropped. *)
Inductive without_points : list nat -> graph -> graph -> Prop :=
| no_points G : without_points [] G G
| dashed x xs G H : degree G x = 0 -> without_points xs G H -> without_points (x :: xs) G H
| through x xs u v R G H : Permutation (map undirected G) (map undirected ((u, x) :: (x, v) :: R)) ->
    u <> x -> v <> x -> degree R x = 0 -> without_points xs ((u, v) :: R) H -> without_points (x :: xs) G H.

(** With its triangles named by [f], the mesh [M] is side [d] of patch [p], coloured [s] and [x], in the middle of [O]; the other
    triangles are [others]. *)
Definition looks_like (p : patch) (d : side) (s x : coloring) (O : graph) (others : list nat) (f : nat -> nat) (M : mesh) : Prop :=
  exists G, without_points (seq 0 (ports p)) (O ++ drawing d s x) G /\ renamed f G (edges M) /\
    Permutation (nodes M) (map f (seq (ports p) (triangles d) ++ others)).

(** One operation: the patch is recoloured as the table says, everything else stays as it is. [told] is the change in the number of
    strips that the rule reports: triangles gained minus solid edges gained. *)
Definition operation (p : patch) (T : table) (M : mesh) (told : Z) (M' : mesh) : Prop :=
  exists s c x O others f,
    (forall u v, f u = f v -> u = v) /\
    length s = ports p /\ length c = length (inner (before p)) /\ T s c = Some x /\ length x = length (inner (after p)) /\
    rest_of_mesh p O /\
    (forall v, In v others -> ports p + Nat.max (triangles (before p)) (triangles (after p)) <= v) /\
    looks_like p (before p) s c O others f M /\ looks_like p (after p) s x O others f M' /\
    told = (Z.of_nat (triangles (after p)) - Z.of_nat (triangles (before p)) - (Z.of_nat (solids x) - Z.of_nat (solids c)))%Z.

(** Any number of operations, each with a patch and a table that satisfy [allowed]. *)
Inductive sequence (allowed : patch -> table -> Prop) (M : mesh) : Z -> mesh -> Prop :=
| nothing_done : sequence allowed M 0 M
| one_more p T M' M'' told told' : sequence allowed M told M' -> allowed p T -> operation p T M' told' M'' ->
    sequence allowed M (told + told') M''.

(** What is allowed: the rules of [T], k <= 8; or any correct table, for every k; at the positions that [which] selects. *)
Definition by_tables (T : position -> table) (which : position -> bool) (p : patch) (U : table) : Prop :=
  exists o, possible o = true /\ which o = true /\ valence_at o <= 8 /\ p = patch_at o /\ U = T o.
Definition by_correct_tables (which : position -> bool) (p : patch) (U : table) : Prop :=
  exists o, possible o = true /\ which o = true /\ p = patch_at o /\ correct p U.
Definition anywhere (o : position) : bool := true.
(** Among others around a vertex inside the mesh, and for splits of a boundary vertex whose new edge lies inside. *)
Definition isolates_none (o : position) : bool := isolated_at o =? 0.
End Meshes.
Import Meshes.

(** A valid mesh stays valid; the reported changes of the number of strips add up; a mesh without isolated triangles stays
    one if the rules at all positions isolate none, and then has at most one strip for two triangles. *)
Definition Sequences_right (allowed : (position -> bool) -> patch -> table -> Prop) : Prop :=
  (forall M told M', sequence (allowed anywhere) M told M' ->
     (valid (edges M) -> valid (edges M')) /\ (strips_of M' = strips_of M + told)%Z) /\
  (forall M told M', sequence (allowed isolates_none) M told M' -> none_isolated M ->
     none_isolated M' /\ (sane M -> (2 * strips_of M' <= Z.of_nat (length (nodes M')))%Z)).
(** [strips_of] is the number of strips, however they are listed. *)
Definition Strips_counted : Prop := forall M strips, stripped (nodes M) (edges M) strips -> strips_of M = Z.of_nat (length strips).
(** There are such operations: a split of a fan of three triangles in a valid mesh of two strips makes them one. *)
Definition Operation_met (T : position -> table) : Prop := exists M M', sane M /\ valid (edges M) /\ strips_of M = 2%Z /\
  operation (split 3 1) (T (split_at 3 1)) M (-1) M' /\ strips_of M' = 1%Z.

(** ** What holds for the whole mesh: docs/explanation/theory.md *)
Module Whole.
(** The dual graph of a mesh of finitely many triangles has an edge for each mesh edge that two triangles share, so two edges for two
    triangles that share two. A triangle has three sides; sides that no dual edge crosses lie on the boundary. The colours are
    the colours of the dual edges, in order. A strip is the list of its triangles; [Valid_is_stripped] says that such lists exist
    exactly for the valid colourings. *)
Record stripification := Stripification
  { faces : list nat; dual : graph; colors : coloring; strips : list (list nat) }.
Definition solid_edges (M : stripification) : graph := solid (dual M) (colors M).
Definition dashed_edges (M : stripification) : graph := solid (dual M) (map negb (colors M)).
Definition well_formed (M : stripification) : Prop :=
  NoDup (faces M) /\
  (forall e, In e (dual M) -> In (fst e) (faces M) /\ In (snd e) (faces M)) /\
  (forall t, degree (dual M) t <= 3) /\
  length (colors M) = length (dual M) /\
  stripped (faces M) (solid_edges M) (strips M).

(** Strip ends and isolated triangles: the triangles with at most one solid edge. *)
Definition at_end (M : stripification) (t : nat) : bool := degree (solid_edges M) t <=? 1.
(** The dashed edges that join two of them, and whether these are of one strip. *)
Definition meetings (M : stripification) : graph :=
  filter (fun e => at_end M (fst e) && at_end M (snd e)) (dashed_edges M).
Definition both_in (l : list nat) (e : edge) : bool := existsb (Nat.eqb (fst e)) l && existsb (Nat.eqb (snd e)) l.
Definition same_strip (M : stripification) (e : edge) : bool := existsb (fun l => both_in l e) (strips M).

(** What is counted: T, S, I, C and B of docs/explanation/theory.md; and the dashed edges between ends of two strips. *)
Definition triangle_count (M : stripification) : nat := length (faces M).
Definition strip_count (M : stripification) : nat := length (strips M).
Definition isolated_count (M : stripification) : nat := length (filter (fun t => degree (solid_edges M) t =? 0) (faces M)).
Definition own_meetings (M : stripification) : nat := length (filter (same_strip M) (meetings M)).
Definition boundary_sides (M : stripification) : nat := list_sum (map (fun t => 3 - degree (dual M) t) (filter (at_end M) (faces M))).
Definition other_meetings (M : stripification) : nat := length (filter (fun e => negb (same_strip M e)) (meetings M)).

(** The assumptions: no dashed edge joins ends of two different strips; and, for the second inequality, no two triangles share
    two edges, and none shares an edge with itself. *)
Definition ends_joined (M : stripification) : Prop := other_meetings M = 0.
Definition simple (M : stripification) : Prop :=
  NoDup (map undirected (dual M)) /\ forall e, In e (dual M) -> fst e <> snd e.

End Whole.
Import Whole.

Definition Whole_mesh : Prop := forall M, well_formed M -> ends_joined M ->
  6 * strip_count M <= triangle_count M + 2 * isolated_count M + 2 * own_meetings M + boundary_sides M.
Definition Whole_mesh_quarter : Prop := forall M, well_formed M -> ends_joined M -> simple M ->
  4 * strip_count M <= triangle_count M + boundary_sides M.
(** If ends of two strips lie side by side, each such pair counts as well. *)
Definition Whole_mesh_any : Prop := forall M, well_formed M ->
  6 * strip_count M <= triangle_count M + 2 * isolated_count M + 2 * (own_meetings M + other_meetings M) + boundary_sides M.
(** Every valid colouring of a dual graph is spoken of. *)
Definition Whole_mesh_covers : Prop := forall ts D c, NoDup ts -> (forall e, In e D -> In (fst e) ts /\ In (snd e) ts) ->
  (forall t, degree D t <= 3) -> length c = length D -> valid (solid D c) ->
  exists ls, well_formed (Stripification ts D c ls).

(** ** A lower bound for every rule that reads only its patch

    A fan of k = 4 is split at a = 2. Before the split its strip enters by port p_3, runs through t_3, t_2, t_1, t_0 and leaves
    by port p_0. Whatever keeps its ports and every mesh valid loses a strip there. *)
Module Blocks.
Definition the_ports : coloring := [true; false; false; true].
Definition the_loop : coloring := [true; true; true; false].

(** A block is a fan of four around an interior vertex and a triangle w on the outer edges of t_2 and t_3; the third
    edge of w is the outer edge of t_0 in the next block. So the mesh is a disc, and triangle t of block m has number 7 m + t:
    t_0 ... t_3 are 0 ... 3, A and D are 4 and 5, w is 6. *)
Definition in_block (m : nat) (e : edge) : edge := (7 * m + fst e, 7 * m + snd e).
(** The port p_0 of block m leads to the triangle w of the block before; p_3 and p_2 lead to w of the same block. *)
Definition port_0 (m : nat) : graph := match m with 0 => [] | S b => [(7 * b + 6, 7 * m + 0)] end.
Definition port_3 (m : nat) : graph := [(7 * m + 3, 7 * m + 6)].
Definition port_2 (m : nat) : graph := [(7 * m + 2, 7 * m + 6)].

(** All dual edges of n blocks, and the triangles. *)
Definition dual_edges (d : side) (n : nat) : graph :=
  flat_map (fun m => map (in_block m) (inner d) ++ port_0 m ++ port_3 m ++ port_2 m) (seq 0 n).
Definition all_triangles (d : side) (n : nat) : list nat :=
  flat_map (fun m => map (fun t => 7 * m + t) (seq 0 (triangles d) ++ [6])) (seq 0 n).
(** The solid ones: the n blocks from m on have the inner colours [xs]; p_0 and p_3 are solid, p_2 is not. *)
Fixpoint solid_from (d : side) (m : nat) (xs : list coloring) : graph :=
  match xs with
  | [] => []
  | x :: r => (map (in_block m) (solid (inner d) x) ++ port_0 m ++ port_3 m) ++ solid_from d (S m) r
  end.
Definition solid_edges (d : side) (xs : list coloring) : graph := solid_from d 0 xs.

Definition before_splits : side := before (split 4 2).
Definition after_splits : side := after (split 4 2).

End Blocks.

Definition Every_rule_pays : Prop := forall (T : table) x, safe (split 4 2) T -> length x = 7 ->
  T Blocks.the_ports Blocks.the_loop = Some x ->
  triangles (after (split 4 2)) + solids Blocks.the_loop >= triangles (before (split 4 2)) + solids x + 1.
(** The n blocks are one strip before; after a split of each by such a rule there are at least n + 1; but the mesh after could be
    one strip. *)
Definition One_strip_before : Prop := forall n, 0 < n -> exists strip,
  stripped (Blocks.all_triangles Blocks.before_splits n) (Blocks.solid_edges Blocks.before_splits (repeat Blocks.the_loop n)) [strip].
Definition No_rule_competes : Prop := forall n (T : table) x strips, 0 < n -> safe (split 4 2) T -> length x = 7 ->
  T Blocks.the_ports Blocks.the_loop = Some x ->
  stripped (Blocks.all_triangles Blocks.after_splits n) (Blocks.solid_edges Blocks.after_splits (repeat x n)) strips ->
  n + 1 <= length strips.
Definition One_strip_would_do : Prop := forall n, 0 < n -> exists G,
  incl (map undirected G) (map undirected (Blocks.dual_edges Blocks.after_splits n)) /\
  exists strip, stripped (Blocks.all_triangles Blocks.after_splits n) G [strip].

(** ** Runs: what [restrip-check] decides of one operation (docs/how-to/check-a-run.md)

    It is given the raw triangles of the patch before and after, by their vertices, the mesh edges where the ports are, and what
    the mesh says of colours and neighbours. *)
Module Runs.
Record verdict := Verdict {
  solid_before : nat; alone_before : nat;  (** solid inner edges and isolated triangles of the patch before *)
  solid_best : nat; alone_best : nat;      (** those after a best recolouring *)
  chosen : bool                            (** the recolouring at hand is a best one *)
}.

Section Raw.
  Context {V : Type} (same : V -> V -> bool).
  Definition corners : Type := V * V * V.
  Definition mesh_edge : Type := V * V.
  Definition rim (t : corners) : list mesh_edge := let '(a, b, c) := t in [(a, b); (b, c); (c, a)].
  Definition turned (e : mesh_edge) : mesh_edge := (snd e, fst e).
  Definition same_edge (e f : mesh_edge) : bool := same (fst e) (fst f) && same (snd e) (snd f).
  Definition among (e : mesh_edge) (l : list mesh_edge) : bool := existsb (same_edge e) l.
  Definition either_way (e : mesh_edge) (l : list mesh_edge) : bool := among e l || among (turned e) l.
  (** No triangle is listed twice, from whichever corner on. *)
  Fixpoint distinct (ts : list corners) : bool :=
    match ts with
    | [] => true
    | t :: r => match rim t with e :: _ => negb (existsb (fun u => among e (rim u)) r) | [] => false end && distinct r
    end.

  (** The mesh edge between two triangles, and those between the triangles that dual edges join. *)
  Definition between (t u : corners) : option mesh_edge := List.find (fun e => among (turned e) (rim u)) (rim t).
  Fixpoint crossed (ts : list corners) (es : list edge) : option (list mesh_edge) :=
    match es with
    | [] => Some []
    | (i, j) :: r =>
        match nth_error ts i, nth_error ts j with
        | Some t, Some u =>
            match between t u, crossed ts r with Some e, Some l => Some (e :: l) | _, _ => None end
        | _, _ => None
        end
    end.

  (** The triangles [ts] lie as the side [d]: its inner edges cross the mesh edges [es], its ports [ps], and every other
      edge of the triangles has no [neighbour], a triangle on its other side. *)
  Definition lies (d : side) (ts : list corners) (ps es : list mesh_edge) (neighbour : mesh_edge -> bool) : bool :=
    (length ts =? triangles d) && (length ps =? length (owner d)) && distinct ts &&
    forallb (fun x => match nth_error ts (fst x) with Some t => among (snd x) (rim t) | None => false end)
      (combine (owner d) ps) &&
    forallb (fun e => among e ps || either_way e es || negb (neighbour e)) (flat_map rim ts).
End Raw.

End Runs.

(** If [judge] answers, the triangles lie as the patch before and after, and its numbers are correct for the patch. If it says
    that the given recolouring is a best one, then it is, and nothing else was recoloured. [olds] and [news] are the triangles before
    and after, [was] and [is] the colours of the mesh, [beside] and [beside'] its neighbours, and [altered] are the mesh edges
    whose colour has changed. *)
Import Runs.
Definition Judge_right (judge : forall V : Type, (V -> V -> bool) -> position -> list corners -> list corners -> list mesh_edge ->
    (mesh_edge -> bool) -> (mesh_edge -> bool) -> (mesh_edge -> bool) -> (mesh_edge -> bool) -> list mesh_edge -> option verdict) :
    Prop :=
  forall V same o olds news ps was is beside beside' altered v,
  judge V same o olds news ps was is beside beside' altered = Some v ->
  let p := patch_at o in
  exists es fs,
    crossed same olds (inner (before p)) = Some es /\ crossed same news (inner (after p)) = Some fs /\
    possible o = true /\ lies same (before p) olds ps es beside = true /\ lies same (after p) news ps fs beside' = true /\
    let s := map was ps in let c := map was es in
    valid (drawing (before p) s c) /\
    solid_before v = solids c /\ alone_before v = isolated (before p) s c /\
    (exists y, best p s c y /\ solids y = solid_best v /\ isolated (after p) s y = alone_best v) /\
    (chosen v = true ->
      best p s c (map is fs) /\ map is ps = s /\
      forall e, In e altered -> either_way same e es = true \/ either_way same e fs = true).
(** The same of a flip, whose ports may change; a verdict counts the ports among the edges, and each port given up among the
    isolated triangles. *)
Definition Judge_flip_right (judge : forall V : Type, (V -> V -> bool) -> list corners -> list corners -> list mesh_edge ->
    (mesh_edge -> bool) -> (mesh_edge -> bool) -> (mesh_edge -> bool) -> (mesh_edge -> bool) -> list mesh_edge -> option verdict) :
    Prop :=
  forall V same olds news ps was is beside beside' altered v,
  judge V same olds news ps was is beside beside' altered = Some v ->
  exists es fs,
    crossed same olds (inner (before flip)) = Some es /\ crossed same news (inner (after flip)) = Some fs /\
    lies same (before flip) olds ps es beside = true /\ lies same (after flip) news ps fs beside' = true /\
    let s := map was ps in let c := map was es in
    valid (drawing (before flip) s c) /\
    solid_before v = solids s + solids c /\ alone_before v = isolated (before flip) s c /\
    (exists t y, flip_best s c t y /\ solids t + solids y = solid_best v /\ lone_or_given_up s t y = alone_best v) /\
    (chosen v = true ->
      flip_best s c (map is ps) (map is fs) /\
      forall e, In e altered -> either_way same e ps = true \/ either_way same e es = true \/ either_way same e fs = true).
(** A best recolouring is safe in every mesh. *)
Definition Chosen_is_safe : Prop := forall o s c x O, possible o = true -> best (patch_at o) s c x ->
  rest_of_mesh (patch_at o) O ->
  valid (O ++ drawing (before (patch_at o)) s c) -> valid (O ++ drawing (after (patch_at o)) s x).

(** ** Steps: what [restrip-check] decides of every operation, whatever it is

    The mesh changes as the reader of the trace says. Only the touched triangles and the strips through them are looked at, and
    yet the answer is about the whole mesh. *)
Module Steps.
(** Sets of triangles, as the program around has them. *)
Record sets (T S : Type) := Sets { none : S; add : T -> S -> S; drop : T -> S -> S; has : T -> S -> bool }.
Arguments none {T S}. Arguments add {T S}. Arguments drop {T S}. Arguments has {T S}.
Definition lawful {T S} (k : sets T S) : Prop :=
  (forall t, has k t (none k) = false) /\
  (forall t u s, has k t (add k u s) = true <-> t = u \/ has k t s = true) /\
  (forall t u s, has k t (drop k u s) = true <-> t <> u /\ has k t s = true).

(** A triangle with three solid edges, a triangle on a cycle, or the changes of the numbers of strips and isolated triangles. *)
Inductive step (T : Type) := Three (t : T) | Round (t : T) | Changes (strips alone : Z).
Arguments Three {T}. Arguments Round {T}. Arguments Changes {T}.

Section Named.
  Context {T : Type} (name : T -> nat).
  Definition named (es : list (T * T)) : graph := map (fun e => (name (fst e), name (snd e))) es.
  (** The triangles [gone] are replaced by [come], and the solid edges [lost] by [made]. *)
  Definition replaced (gone come : list T) (lost made : list (T * T)) (M M' : mesh) : Prop :=
    exists stay kept,
      Permutation (nodes M) (map name gone ++ stay) /\ Permutation (nodes M') (map name come ++ stay) /\
      Permutation (edges M) (named lost ++ kept) /\ Permutation (edges M') (named made ++ kept).
  (** The triangles across the solid edges of a triangle. *)
  Definition lists_neighbours (beside : T -> list T) (M : mesh) : Prop := forall t, In (name t) (nodes M) ->
    length (beside t) = degree (edges M) (name t) /\ forall u, In u (beside t) -> adjacent (edges M) (name t) (name u).
  Definition tells_isolated (lone : T -> bool) (M : mesh) : Prop := forall t, In (name t) (nodes M) ->
    lone t = (degree (edges M) (name t) =? 0).
End Named.
Definition isolated_of (M : mesh) : Z := Z.of_nat (length (filter (fun v => degree (edges M) v =? 0) (nodes M))).
End Steps.
Import Steps.

(** If [judge] answers with changes, then a valid mesh is valid after the step, and the changes are those of the whole mesh.
    [lone] is about the mesh before, [beside] about the mesh after. *)
Definition Judge_step_right (judge : forall T S : Type, sets T S -> (T -> T -> bool) -> nat -> (T -> bool) -> (T -> list T) ->
    list T -> list T -> list (T * T) -> list (T * T) -> step T) : Prop :=
  forall T S k same fuel lone beside gone come lost made strips alone,
  judge T S k same fuel lone beside gone come lost made = Changes strips alone -> lawful k ->
  forall name M M', (forall t u : T, name t = name u -> t = u) -> sane M -> sane M' ->
  replaced name gone come lost made M M' -> tells_isolated name lone M -> lists_neighbours name beside M' ->
  valid (edges M) ->
  valid (edges M') /\ strips_of M' = (strips_of M + strips)%Z /\ isolated_of M' = (isolated_of M + alone)%Z.
