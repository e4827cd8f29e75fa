
val negb : bool -> bool



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

  val eqb : positive -> positive -> bool
 end

val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1

val forallb : ('a1 -> bool) -> 'a1 list -> bool

val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list

module Z :
 sig
  val eqb : z -> z -> bool
 end

module PositiveMap :
 sig
  type key = positive

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  val empty : 'a1 t

  val find : key -> 'a1 t -> 'a1 option

  val add : key -> 'a1 -> 'a1 t -> 'a1 t

  val remove : key -> 'a1 t -> 'a1 t
 end

module Formulas :
 sig
  type literal = z

  type clause = literal list

  type formula = clause list

  type step =
  | Learn of positive * clause * positive list
  | Forget of positive list
 end

type values = bool PositiveMap.t

val assign : bool -> Formulas.literal -> values -> values

val known_false : values -> Formulas.literal -> bool

type clauses = Formulas.clause PositiveMap.t

val conflict : clauses -> values -> positive list -> bool

val denied : Formulas.clause -> values

val follow : clauses -> Formulas.step list -> bool

val numbered : positive -> Formulas.formula -> clauses -> clauses

val refutes : Formulas.formula -> Formulas.step list -> bool
