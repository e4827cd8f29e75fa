
type __ = Obj.t

val implb : bool -> bool -> bool

val negb : bool -> bool

type nat =
| O
| S of nat

val option_map : ('a1 -> 'a2) -> 'a1 option -> 'a2 option

val fst : ('a1 * 'a2) -> 'a1

val snd : ('a1 * 'a2) -> 'a2

val length : 'a1 list -> nat

val app : 'a1 list -> 'a1 list -> 'a1 list

type comparison =
| Eq
| Lt
| Gt

val id : __ -> __

val pred : nat -> nat

val add : nat -> nat -> nat

val sub : nat -> nat -> nat

val eqb : bool -> bool -> bool

module Nat :
 sig
  val eqb : nat -> nat -> bool

  val leb : nat -> nat -> bool

  val ltb : nat -> nat -> bool
 end

type positive =
| XI of positive
| XO of positive
| XH

type z =
| Z0
| Zpos of positive
| Zneg of positive

module Pos :
 sig
  val succ : positive -> positive

  val add : positive -> positive -> positive

  val add_carry : positive -> positive -> positive

  val pred_double : positive -> positive

  val compare_cont : comparison -> positive -> positive -> comparison

  val compare : positive -> positive -> comparison

  val eqb : positive -> positive -> bool

  val ltb : positive -> positive -> bool

  val iter_op : ('a1 -> 'a1 -> 'a1) -> positive -> 'a1 -> 'a1

  val to_nat : positive -> nat

  val of_succ_nat : nat -> positive
 end

val nth : nat -> 'a1 list -> 'a1 -> 'a1

val nth_error : 'a1 list -> nat -> 'a1 option

val rev_append : 'a1 list -> 'a1 list -> 'a1 list

val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list

val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1

val existsb : ('a1 -> bool) -> 'a1 list -> bool

val forallb : ('a1 -> bool) -> 'a1 list -> bool

val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list

val find : ('a1 -> bool) -> 'a1 list -> 'a1 option

val combine : 'a1 list -> 'a2 list -> ('a1 * 'a2) list

val firstn : nat -> 'a1 list -> 'a1 list

val skipn : nat -> 'a1 list -> 'a1 list

val seq : nat -> nat -> nat list

val list_sum : nat list -> nat

module Z :
 sig
  val double : z -> z

  val succ_double : z -> z

  val pred_double : z -> z

  val pos_sub : positive -> positive -> z

  val add : z -> z -> z

  val opp : z -> z

  val succ : z -> z

  val sub : z -> z -> z
 end

type edge = nat * nat

type graph = edge list

val meets : edge -> nat -> nat

val degree : graph -> nat -> nat

val path_edges : nat list -> edge list

type side = { triangles : nat; inner : edge list; owner : nat list }

type patch = { before : side; after : side }

val ports : patch -> nat

type coloring = bool list

val solid : edge list -> coloring -> graph

val port_edges : side -> edge list

val inner_edges : side -> edge list

val drawing : side -> coloring -> coloring -> graph

val solids : coloring -> nat

val isolated : side -> coloring -> coloring -> nat

val ring_edges : nat list -> edge list

val closed_fan : nat -> side

val open_fan : nat -> side

val ring_with_chord : nat -> nat -> side

val path_with_chord : nat -> nat -> nat -> side

val path_with_one : nat -> nat -> side

val split : nat -> nat -> patch

val collapse : nat -> nat -> patch

val open_split : nat -> nat -> nat -> patch

val open_collapse : nat -> nat -> nat -> patch

val boundary_split : nat -> nat -> patch

val boundary_collapse : nat -> nat -> patch

val flip : patch

val lone_or_given_up : coloring -> coloring -> coloring -> nat

type position =
| Split_at of nat * nat
| Collapse_at of nat * nat
| Open_split_at of nat * nat * nat
| Open_collapse_at of nat * nat * nat
| Boundary_split_at of nat * nat
| Boundary_collapse_at of nat * nat

val possible : position -> bool

val patch_at : position -> patch

module Runs :
 sig
  type verdict = { solid_before : nat; alone_before : nat; solid_best : 
                   nat; alone_best : nat; chosen : bool }

  val solid_before : verdict -> nat

  val alone_before : verdict -> nat

  val solid_best : verdict -> nat

  val alone_best : verdict -> nat

  val chosen : verdict -> bool

  type 'v corners = ('v * 'v) * 'v

  type 'v mesh_edge = 'v * 'v

  val rim : 'a1 corners -> 'a1 mesh_edge list

  val turned : 'a1 mesh_edge -> 'a1 mesh_edge

  val same_edge :
    ('a1 -> 'a1 -> bool) -> 'a1 mesh_edge -> 'a1 mesh_edge -> bool

  val among :
    ('a1 -> 'a1 -> bool) -> 'a1 mesh_edge -> 'a1 mesh_edge list -> bool

  val either_way :
    ('a1 -> 'a1 -> bool) -> 'a1 mesh_edge -> 'a1 mesh_edge list -> bool

  val distinct : ('a1 -> 'a1 -> bool) -> 'a1 corners list -> bool

  val between :
    ('a1 -> 'a1 -> bool) -> 'a1 corners -> 'a1 corners -> 'a1 mesh_edge option

  val crossed :
    ('a1 -> 'a1 -> bool) -> 'a1 corners list -> edge list -> 'a1 mesh_edge
    list option

  val lies :
    ('a1 -> 'a1 -> bool) -> side -> 'a1 corners list -> 'a1 mesh_edge list ->
    'a1 mesh_edge list -> ('a1 mesh_edge -> bool) -> bool
 end

module Steps :
 sig
  type ('t, 's) sets = { none : 's; add : ('t -> 's -> 's);
                         drop : ('t -> 's -> 's); has : ('t -> 's -> bool) }

  val none : ('a1, 'a2) sets -> 'a2

  val add : ('a1, 'a2) sets -> 'a1 -> 'a2 -> 'a2

  val drop : ('a1, 'a2) sets -> 'a1 -> 'a2 -> 'a2

  val has : ('a1, 'a2) sets -> 'a1 -> 'a2 -> bool

  type 't step =
  | Three of 't
  | Round of 't
  | Changes of z * z
 end

type state = (nat * nat) list

val label_in : state -> nat -> nat

val blank : nat -> state

val bump : nat -> state -> state

val relabel : nat -> nat -> state -> state

val step0 : edge -> state -> state option

val draw : edge list -> coloring -> state -> state option

val alone : nat -> state -> nat

type score = nat * nat

val good : score -> score -> bool

val size : side -> nat

val drawn : side -> coloring -> coloring -> state option

type binary_state = (nat * positive) list

val unary : (nat * positive) -> nat * nat

val books : binary_state -> state

val blank_labels : nat -> binary_state

val count_edge : nat -> binary_state -> binary_state

val replace : positive -> positive -> binary_state -> binary_state

val add_edge : edge -> binary_state -> binary_state option

val add_edges : edge list -> coloring -> binary_state -> binary_state option

val drawn_with_labels : side -> coloring -> coloring -> state option

type place = { deg : nat; port : nat option }

type frontier = { anchor : place; tip : place; same : bool }

type step1 =
| Put of nat option
| Next of nat option
| Mark of nat option
| Chord

val fresh : nat option -> place

val agree : nat option -> nat option -> bool

val either : nat option -> nat option -> nat option

val open_end : place -> bool

val tidy_place : place -> place

val tidy : frontier -> frontier

val more : place -> nat option -> place

val take : step1 -> bool -> frontier -> frontier option

val lone : nat -> nat

val left_alone : step1 -> bool -> frontier -> nat

val at_end : frontier -> nat

val blank_frontier : frontier

val play :
  step1 list -> coloring -> frontier -> nat -> nat ->
  (frontier * (nat * nat)) option

val same_label : nat option -> nat option -> bool

val same_place : place -> place -> bool

val same_frontier : frontier -> frontier -> bool

type 'h entry = (frontier * score) * 'h

val insert : frontier -> score -> 'a1 -> 'a1 entry list -> 'a1 entry list

val add_choice :
  (bool -> 'a1 -> 'a1) -> step1 -> bool -> 'a1 entry list -> 'a1 entry -> 'a1
  entry list

val add_both :
  (bool -> 'a1 -> 'a1) -> step1 -> 'a1 entry list -> 'a1 entry -> 'a1 entry
  list

val extend : (bool -> 'a1 -> 'a1) -> step1 -> 'a1 entry list -> 'a1 entry list

val extends :
  (bool -> 'a1 -> 'a1) -> step1 list -> 'a1 entry list -> 'a1 entry list

type coloring_entry = coloring entry

val remember : bool -> coloring -> coloring

val blank_entries : coloring_entry list

val finished : 'a1 entry -> score

val best_entry : 'a1 entry list -> 'a1 entry option

type kind =
| Put0
| Next0
| Mark0
| Chord0

type shape = (kind * nat) list

val arranged : nat -> nat -> 'a1 list -> 'a1 list

val port_of : nat -> coloring -> (nat -> nat) -> nat -> nat option

val step_of : nat -> coloring -> (nat -> nat) -> (kind * nat) -> step1

val choices : nat -> nat -> coloring -> coloring

val route : nat list -> nat list -> nat list -> bool -> bool -> shape

val closed_route : nat -> shape

val ring_route : nat -> nat -> shape

val open_route : nat -> shape

val chord_route : nat -> nat -> nat -> shape

val one_route : nat -> nat -> shape

type course = { way : shape; met_first : nat; met_last : nat; left_over : nat }

val course_at : position -> course

val weigh :
  position -> coloring -> coloring -> coloring -> Runs.verdict option

type way_on = coloring * coloring

val all_colorings : nat -> coloring list

val keeps : coloring -> coloring -> bool

val flip_allowed : state -> coloring -> way_on -> bool

val flip_alone : coloring -> way_on -> nat

val flip_edges : way_on -> nat

val flip_good : coloring -> way_on -> way_on -> bool

val ways_on : state -> coloring -> way_on list

val first_of : coloring -> way_on list -> way_on option

val weigh_flip : coloring -> coloring -> way_on -> Runs.verdict option

val judge :
  ('a1 -> 'a1 -> bool) -> position -> 'a1 Runs.corners list -> 'a1
  Runs.corners list -> 'a1 Runs.mesh_edge list -> ('a1 Runs.mesh_edge ->
  bool) -> ('a1 Runs.mesh_edge -> bool) -> ('a1 Runs.mesh_edge -> bool) ->
  ('a1 Runs.mesh_edge -> bool) -> 'a1 Runs.mesh_edge list -> Runs.verdict
  option

val judge_flip :
  ('a1 -> 'a1 -> bool) -> 'a1 Runs.corners list -> 'a1 Runs.corners list ->
  'a1 Runs.mesh_edge list -> ('a1 Runs.mesh_edge -> bool) -> ('a1
  Runs.mesh_edge -> bool) -> ('a1 Runs.mesh_edge -> bool) -> ('a1
  Runs.mesh_edge -> bool) -> 'a1 Runs.mesh_edge list -> Runs.verdict option

val add_all : ('a1, 'a2) Steps.sets -> 'a2 -> 'a1 list -> 'a2

val count : ('a1 -> bool) -> 'a1 list -> z

val size0 : 'a1 list -> z

val without : ('a1 -> 'a1 -> bool) -> 'a1 -> 'a1 list -> 'a1 list

val walk :
  ('a1, 'a2) Steps.sets -> ('a1 -> 'a1 -> bool) -> ('a1 -> 'a1 list) -> nat
  -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a2 -> 'a2 option

val fault :
  ('a1, 'a2) Steps.sets -> ('a1 -> 'a1 -> bool) -> nat -> ('a1 -> 'a1 list)
  -> 'a1 list -> 'a2 -> 'a1 Steps.step option

val see : ('a1, 'a2) Steps.sets -> ('a1 list * 'a2) -> 'a1 -> 'a1 list * 'a2

val stays :
  ('a1, 'a2) Steps.sets -> 'a1 list -> 'a1 list -> ('a1 * 'a1) list ->
  ('a1 * 'a1) list -> 'a1 list

val judge_step :
  ('a1, 'a2) Steps.sets -> ('a1 -> 'a1 -> bool) -> nat -> ('a1 -> bool) ->
  ('a1 -> 'a1 list) -> 'a1 list -> 'a1 list -> ('a1 * 'a1) list ->
  ('a1 * 'a1) list -> 'a1 Steps.step
