
(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true



type positive =
| XI of positive
| XO of positive
| XH

type z =
| Z0
| Zpos of positive
| Zneg of positive

module Pos =
 struct
  (** val succ : positive -> positive **)

  let rec succ = function
  | XI p -> XO (succ p)
  | XO p -> XI p
  | XH -> XO XH

  (** val eqb : positive -> positive -> bool **)

  let rec eqb p q =
    match p with
    | XI p0 -> (match q with
                | XI q0 -> eqb p0 q0
                | _ -> false)
    | XO p0 -> (match q with
                | XO q0 -> eqb p0 q0
                | _ -> false)
    | XH -> (match q with
             | XH -> true
             | _ -> false)
 end

(** val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1 **)

let rec fold_right f a0 = function
| [] -> a0
| b :: t0 -> f b (fold_right f a0 t0)

(** val forallb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec forallb f = function
| [] -> true
| a :: l0 -> (&&) (f a) (forallb f l0)

(** val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list **)

let rec filter f = function
| [] -> []
| x :: l0 -> if f x then x :: (filter f l0) else filter f l0

module Z =
 struct
  (** val eqb : z -> z -> bool **)

  let eqb x y =
    match x with
    | Z0 -> (match y with
             | Z0 -> true
             | _ -> false)
    | Zpos p -> (match y with
                 | Zpos q -> Pos.eqb p q
                 | _ -> false)
    | Zneg p -> (match y with
                 | Zneg q -> Pos.eqb p q
                 | _ -> false)
 end

module PositiveMap =
 struct
  type key = positive

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  (** val empty : 'a1 t **)

  let empty =
    Leaf

  (** val find : key -> 'a1 t -> 'a1 option **)

  let rec find i = function
  | Leaf -> None
  | Node (l, o, r) ->
    (match i with
     | XI ii -> find ii r
     | XO ii -> find ii l
     | XH -> o)

  (** val add : key -> 'a1 -> 'a1 t -> 'a1 t **)

  let rec add i v = function
  | Leaf ->
    (match i with
     | XI ii -> Node (Leaf, None, (add ii v Leaf))
     | XO ii -> Node ((add ii v Leaf), None, Leaf)
     | XH -> Node (Leaf, (Some v), Leaf))
  | Node (l, o, r) ->
    (match i with
     | XI ii -> Node (l, o, (add ii v r))
     | XO ii -> Node ((add ii v l), o, r)
     | XH -> Node (l, (Some v), r))

  (** val remove : key -> 'a1 t -> 'a1 t **)

  let rec remove i m =
    match i with
    | XI ii ->
      (match m with
       | Leaf -> Leaf
       | Node (l, o, r) ->
         (match l with
          | Leaf ->
            (match o with
             | Some _ -> Node (l, o, (remove ii r))
             | None ->
               (match remove ii r with
                | Leaf -> Leaf
                | Node (t0, o0, t1) -> Node (Leaf, None, (Node (t0, o0, t1)))))
          | Node (_, _, _) -> Node (l, o, (remove ii r))))
    | XO ii ->
      (match m with
       | Leaf -> Leaf
       | Node (l, o, r) ->
         (match o with
          | Some _ -> Node ((remove ii l), o, r)
          | None ->
            (match r with
             | Leaf ->
               (match remove ii l with
                | Leaf -> Leaf
                | Node (t0, o0, t1) -> Node ((Node (t0, o0, t1)), None, Leaf))
             | Node (_, _, _) -> Node ((remove ii l), o, r))))
    | XH ->
      (match m with
       | Leaf -> Leaf
       | Node (l, _, r) ->
         (match l with
          | Leaf ->
            (match r with
             | Leaf -> Leaf
             | Node (_, _, _) -> Node (l, None, r))
          | Node (_, _, _) -> Node (l, None, r)))
 end

module Formulas =
 struct
  type literal = z

  type clause = literal list

  type formula = clause list

  type step =
  | Learn of positive * clause * positive list
  | Forget of positive list
 end

type values = bool PositiveMap.t

(** val assign : bool -> Formulas.literal -> values -> values **)

let assign made l m =
  match l with
  | Z0 -> m
  | Zpos v -> PositiveMap.add v made m
  | Zneg v -> PositiveMap.add v (negb made) m

(** val known_false : values -> Formulas.literal -> bool **)

let known_false m = function
| Z0 -> true
| Zpos v -> (match PositiveMap.find v m with
             | Some b -> negb b
             | None -> false)
| Zneg v -> (match PositiveMap.find v m with
             | Some b -> b
             | None -> false)

type clauses = Formulas.clause PositiveMap.t

(** val conflict : clauses -> values -> positive list -> bool **)

let rec conflict db m = function
| [] -> false
| h :: r ->
  (match PositiveMap.find h db with
   | Some c ->
     (match filter (fun l -> negb (known_false m l)) c with
      | [] -> true
      | l :: copies ->
        (&&) (forallb (Z.eqb l) copies) (conflict db (assign true l m) r))
   | None -> false)

(** val denied : Formulas.clause -> values **)

let denied c =
  fold_right (assign false) PositiveMap.empty c

(** val follow : clauses -> Formulas.step list -> bool **)

let rec follow db = function
| [] -> false
| s :: r ->
  (match s with
   | Formulas.Learn (n, c, hints) ->
     (&&) (conflict db (denied c) hints)
       (match c with
        | [] -> true
        | _ :: _ -> follow (PositiveMap.add n c db) r)
   | Formulas.Forget numbers ->
     follow (fold_right PositiveMap.remove db numbers) r)

(** val numbered : positive -> Formulas.formula -> clauses -> clauses **)

let rec numbered n f db =
  match f with
  | [] -> db
  | c :: r -> numbered (Pos.succ n) r (PositiveMap.add n c db)

(** val refutes : Formulas.formula -> Formulas.step list -> bool **)

let refutes f proof =
  follow (numbered XH f PositiveMap.empty) proof
