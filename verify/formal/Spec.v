(** * The specification: the page one has to believe

    What the theorems of [Main.v] say of a single rule is said with the words of this file. [Main.v] names the files from
    which it takes words for other things. The numbering is that of docs/notation.md. *)
Require Import Arith Bool List Permutation.
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

(** The order of preference: more solid edges; with as many, no more isolated triangles. *)
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
    strips is the number of triangles less that of solid edges ([Strips.v]). *)
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

(** ** The families of docs/notation.md

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

    An answer is the inner edge and the ports kept. More solid edges, ports included; with as many, fewer isolated
    triangles, each port given up counted as one; with as many, more ports kept. *)
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
