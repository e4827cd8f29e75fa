
type __ = Obj.t

(** val implb : bool -> bool -> bool **)

let implb b1 b2 =
  if b1 then b2 else true

(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true

type nat =
| O
| S of nat

(** val option_map : ('a1 -> 'a2) -> 'a1 option -> 'a2 option **)

let option_map f = function
| Some a -> Some (f a)
| None -> None

(** val fst : ('a1 * 'a2) -> 'a1 **)

let fst = function
| (x, _) -> x

(** val snd : ('a1 * 'a2) -> 'a2 **)

let snd = function
| (_, y) -> y

(** val length : 'a1 list -> nat **)

let rec length = function
| [] -> O
| _ :: l' -> S (length l')

(** val app : 'a1 list -> 'a1 list -> 'a1 list **)

let rec app l m =
  match l with
  | [] -> m
  | a :: l1 -> a :: (app l1 m)

type comparison =
| Eq
| Lt
| Gt

(** val id : __ -> __ **)

let id x =
  x

(** val pred : nat -> nat **)

let pred n = match n with
| O -> n
| S u -> u

module Coq__1 = struct
 (** val add : nat -> nat -> nat **)
 let rec add n m =
   match n with
   | O -> m
   | S p -> S (add p m)
end
include Coq__1

(** val sub : nat -> nat -> nat **)

let rec sub n m =
  match n with
  | O -> n
  | S k -> (match m with
            | O -> n
            | S l -> sub k l)

(** val eqb : bool -> bool -> bool **)

let eqb b1 b2 =
  if b1 then b2 else if b2 then false else true

module Nat =
 struct
  (** val eqb : nat -> nat -> bool **)

  let rec eqb n m =
    match n with
    | O -> (match m with
            | O -> true
            | S _ -> false)
    | S n' -> (match m with
               | O -> false
               | S m' -> eqb n' m')

  (** val leb : nat -> nat -> bool **)

  let rec leb n m =
    match n with
    | O -> true
    | S n' -> (match m with
               | O -> false
               | S m' -> leb n' m')

  (** val ltb : nat -> nat -> bool **)

  let ltb n m =
    leb (S n) m
 end

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

  (** val add : positive -> positive -> positive **)

  let rec add x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> XO (add_carry p q)
       | XO q -> XI (add p q)
       | XH -> XO (succ p))
    | XO p ->
      (match y with
       | XI q -> XI (add p q)
       | XO q -> XO (add p q)
       | XH -> XI p)
    | XH -> (match y with
             | XI q -> XO (succ q)
             | XO q -> XI q
             | XH -> XO XH)

  (** val add_carry : positive -> positive -> positive **)

  and add_carry x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> XI (add_carry p q)
       | XO q -> XO (add_carry p q)
       | XH -> XI (succ p))
    | XO p ->
      (match y with
       | XI q -> XO (add_carry p q)
       | XO q -> XI (add p q)
       | XH -> XO (succ p))
    | XH ->
      (match y with
       | XI q -> XI (succ q)
       | XO q -> XO (succ q)
       | XH -> XI XH)

  (** val pred_double : positive -> positive **)

  let rec pred_double = function
  | XI p -> XI (XO p)
  | XO p -> XI (pred_double p)
  | XH -> XH

  (** val compare_cont : comparison -> positive -> positive -> comparison **)

  let rec compare_cont r x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> compare_cont r p q
       | XO q -> compare_cont Gt p q
       | XH -> Gt)
    | XO p ->
      (match y with
       | XI q -> compare_cont Lt p q
       | XO q -> compare_cont r p q
       | XH -> Gt)
    | XH -> (match y with
             | XH -> r
             | _ -> Lt)

  (** val compare : positive -> positive -> comparison **)

  let compare =
    compare_cont Eq

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

  (** val ltb : positive -> positive -> bool **)

  let ltb x y =
    match compare x y with
    | Lt -> true
    | _ -> false

  (** val iter_op : ('a1 -> 'a1 -> 'a1) -> positive -> 'a1 -> 'a1 **)

  let rec iter_op op p a =
    match p with
    | XI p0 -> op a (iter_op op p0 (op a a))
    | XO p0 -> iter_op op p0 (op a a)
    | XH -> a

  (** val to_nat : positive -> nat **)

  let to_nat x =
    iter_op Coq__1.add x (S O)

  (** val of_succ_nat : nat -> positive **)

  let rec of_succ_nat = function
  | O -> XH
  | S x -> succ (of_succ_nat x)
 end

(** val nth : nat -> 'a1 list -> 'a1 -> 'a1 **)

let rec nth n l default =
  match n with
  | O -> (match l with
          | [] -> default
          | x :: _ -> x)
  | S m -> (match l with
            | [] -> default
            | _ :: t -> nth m t default)

(** val nth_error : 'a1 list -> nat -> 'a1 option **)

let rec nth_error l = function
| O -> (match l with
        | [] -> None
        | x :: _ -> Some x)
| S n0 -> (match l with
           | [] -> None
           | _ :: l0 -> nth_error l0 n0)

(** val rev_append : 'a1 list -> 'a1 list -> 'a1 list **)

let rec rev_append l l' =
  match l with
  | [] -> l'
  | a :: l0 -> rev_append l0 (a :: l')

(** val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list **)

let rec map f = function
| [] -> []
| a :: t -> (f a) :: (map f t)

(** val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list **)

let rec flat_map f = function
| [] -> []
| x :: t -> app (f x) (flat_map f t)

(** val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1 **)

let rec fold_left f l a0 =
  match l with
  | [] -> a0
  | b :: t -> fold_left f t (f a0 b)

(** val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1 **)

let rec fold_right f a0 = function
| [] -> a0
| b :: t -> f b (fold_right f a0 t)

(** val existsb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec existsb f = function
| [] -> false
| a :: l0 -> (||) (f a) (existsb f l0)

(** val forallb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec forallb f = function
| [] -> true
| a :: l0 -> (&&) (f a) (forallb f l0)

(** val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list **)

let rec filter f = function
| [] -> []
| x :: l0 -> if f x then x :: (filter f l0) else filter f l0

(** val find : ('a1 -> bool) -> 'a1 list -> 'a1 option **)

let rec find f = function
| [] -> None
| x :: tl -> if f x then Some x else find f tl

(** val combine : 'a1 list -> 'a2 list -> ('a1 * 'a2) list **)

let rec combine l l' =
  match l with
  | [] -> []
  | x :: tl ->
    (match l' with
     | [] -> []
     | y :: tl' -> (x, y) :: (combine tl tl'))

(** val firstn : nat -> 'a1 list -> 'a1 list **)

let rec firstn n l =
  match n with
  | O -> []
  | S n0 -> (match l with
             | [] -> []
             | a :: l0 -> a :: (firstn n0 l0))

(** val skipn : nat -> 'a1 list -> 'a1 list **)

let rec skipn n l =
  match n with
  | O -> l
  | S n0 -> (match l with
             | [] -> []
             | _ :: l0 -> skipn n0 l0)

(** val seq : nat -> nat -> nat list **)

let rec seq start = function
| O -> []
| S len0 -> start :: (seq (S start) len0)

(** val list_sum : nat list -> nat **)

let list_sum l =
  fold_right add O l

module Z =
 struct
  (** val double : z -> z **)

  let double = function
  | Z0 -> Z0
  | Zpos p -> Zpos (XO p)
  | Zneg p -> Zneg (XO p)

  (** val succ_double : z -> z **)

  let succ_double = function
  | Z0 -> Zpos XH
  | Zpos p -> Zpos (XI p)
  | Zneg p -> Zneg (Pos.pred_double p)

  (** val pred_double : z -> z **)

  let pred_double = function
  | Z0 -> Zneg XH
  | Zpos p -> Zpos (Pos.pred_double p)
  | Zneg p -> Zneg (XI p)

  (** val pos_sub : positive -> positive -> z **)

  let rec pos_sub x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> double (pos_sub p q)
       | XO q -> succ_double (pos_sub p q)
       | XH -> Zpos (XO p))
    | XO p ->
      (match y with
       | XI q -> pred_double (pos_sub p q)
       | XO q -> double (pos_sub p q)
       | XH -> Zpos (Pos.pred_double p))
    | XH ->
      (match y with
       | XI q -> Zneg (XO q)
       | XO q -> Zneg (Pos.pred_double q)
       | XH -> Z0)

  (** val add : z -> z -> z **)

  let add x y =
    match x with
    | Z0 -> y
    | Zpos x' ->
      (match y with
       | Z0 -> x
       | Zpos y' -> Zpos (Pos.add x' y')
       | Zneg y' -> pos_sub x' y')
    | Zneg x' ->
      (match y with
       | Z0 -> x
       | Zpos y' -> pos_sub y' x'
       | Zneg y' -> Zneg (Pos.add x' y'))

  (** val opp : z -> z **)

  let opp = function
  | Z0 -> Z0
  | Zpos x0 -> Zneg x0
  | Zneg x0 -> Zpos x0

  (** val succ : z -> z **)

  let succ x =
    add x (Zpos XH)

  (** val sub : z -> z -> z **)

  let sub m n =
    add m (opp n)
 end

type edge = nat * nat

type graph = edge list

(** val meets : edge -> nat -> nat **)

let meets e v =
  add (if Nat.eqb (fst e) v then S O else O)
    (if Nat.eqb (snd e) v then S O else O)

(** val degree : graph -> nat -> nat **)

let degree g v =
  list_sum (map (fun e -> meets e v) g)

(** val path_edges : nat list -> edge list **)

let rec path_edges = function
| [] -> []
| u :: l' -> (match l' with
              | [] -> []
              | v :: _ -> (u, v) :: (path_edges l'))

type side = { triangles : nat; inner : edge list; owner : nat list }

type patch = { before : side; after : side }

(** val ports : patch -> nat **)

let ports p =
  length p.before.owner

type coloring = bool list

(** val solid : edge list -> coloring -> graph **)

let rec solid es c =
  match es with
  | [] -> []
  | e :: es' ->
    (match c with
     | [] -> []
     | b :: c' -> if b then e :: (solid es' c') else solid es' c')

(** val port_edges : side -> edge list **)

let port_edges d =
  combine (seq O (length d.owner))
    (map (fun t -> add (length d.owner) t) d.owner)

(** val inner_edges : side -> edge list **)

let inner_edges d =
  map (fun e -> ((add (length d.owner) (fst e)),
    (add (length d.owner) (snd e)))) d.inner

(** val drawing : side -> coloring -> coloring -> graph **)

let drawing d ports0 inner0 =
  app (solid (port_edges d) ports0) (solid (inner_edges d) inner0)

(** val solids : coloring -> nat **)

let solids x =
  length (filter (Obj.magic id) x)

(** val isolated : side -> coloring -> coloring -> nat **)

let isolated d s x =
  length
    (filter (fun t ->
      Nat.eqb (degree (drawing d s x) (add (length d.owner) t)) O)
      (seq O d.triangles))

(** val ring_edges : nat list -> edge list **)

let ring_edges l =
  path_edges (app l (firstn (S O) l))

(** val closed_fan : nat -> side **)

let closed_fan k =
  { triangles = k; inner = (ring_edges (seq O k)); owner = (seq O k) }

(** val open_fan : nat -> side **)

let open_fan k =
  { triangles = k; inner = (path_edges (seq O k)); owner = (seq O k) }

(** val ring_with_chord : nat -> nat -> side **)

let ring_with_chord k a =
  { triangles = (add k (S (S O))); inner =
    (app
      (ring_edges (k :: (app (seq O a) ((add k (S O)) :: (seq a (sub k a))))))
      ((k, (add k (S O))) :: [])); owner = (seq O k) }

(** val path_with_chord : nat -> nat -> nat -> side **)

let path_with_chord k i j =
  { triangles = (add k (S (S O))); inner =
    (app
      (path_edges
        (app (seq O i)
          (k :: (app (seq i (sub j i)) ((add k (S O)) :: (seq j (sub k j)))))))
      ((k, (add k (S O))) :: [])); owner = (seq O k) }

(** val path_with_one : nat -> nat -> side **)

let path_with_one k i =
  { triangles = (add k (S O)); inner =
    (path_edges (app (seq O i) (k :: (seq i (sub k i))))); owner = (seq O k) }

(** val split : nat -> nat -> patch **)

let split k a =
  { before = (closed_fan k); after = (ring_with_chord k a) }

(** val collapse : nat -> nat -> patch **)

let collapse k a =
  { before = (ring_with_chord k a); after = (closed_fan k) }

(** val open_split : nat -> nat -> nat -> patch **)

let open_split k i j =
  { before = (open_fan k); after = (path_with_chord k i j) }

(** val open_collapse : nat -> nat -> nat -> patch **)

let open_collapse k i j =
  { before = (path_with_chord k i j); after = (open_fan k) }

(** val boundary_split : nat -> nat -> patch **)

let boundary_split k i =
  { before = (open_fan k); after = (path_with_one k i) }

(** val boundary_collapse : nat -> nat -> patch **)

let boundary_collapse k i =
  { before = (path_with_one k i); after = (open_fan k) }

(** val flip : patch **)

let flip =
  { before = { triangles = (S (S O)); inner = ((O, (S O)) :: []); owner =
    (O :: (O :: ((S O) :: ((S O) :: [])))) }; after = { triangles = (S (S
    O)); inner = ((O, (S O)) :: []); owner = ((S O) :: (O :: (O :: ((S
    O) :: [])))) } }

(** val lone_or_given_up : coloring -> coloring -> coloring -> nat **)

let lone_or_given_up s s' x =
  add (isolated flip.after s' x) (sub (solids s) (solids s'))

type position =
| Split_at of nat * nat
| Collapse_at of nat * nat
| Open_split_at of nat * nat * nat
| Open_collapse_at of nat * nat * nat
| Boundary_split_at of nat * nat
| Boundary_collapse_at of nat * nat

(** val possible : position -> bool **)

let possible = function
| Split_at (k, a) ->
  (&&) ((&&) (Nat.leb (S (S (S O))) k) (Nat.leb (S O) a)) (Nat.ltb a k)
| Collapse_at (k, a) ->
  (&&) ((&&) (Nat.leb (S (S (S O))) k) (Nat.leb (S O) a)) (Nat.ltb a k)
| Open_split_at (k, i, j) ->
  (&&) ((&&) (Nat.leb (S O) k) (Nat.ltb i j)) (Nat.leb j k)
| Open_collapse_at (k, i, j) ->
  (&&) ((&&) (Nat.leb (S O) k) (Nat.ltb i j)) (Nat.leb j k)
| Boundary_split_at (k, i) -> (&&) (Nat.leb (S O) k) (Nat.leb i k)
| Boundary_collapse_at (k, i) -> (&&) (Nat.leb (S O) k) (Nat.leb i k)

(** val patch_at : position -> patch **)

let patch_at = function
| Split_at (k, a) -> split k a
| Collapse_at (k, a) -> collapse k a
| Open_split_at (k, i, j) -> open_split k i j
| Open_collapse_at (k, i, j) -> open_collapse k i j
| Boundary_split_at (k, i) -> boundary_split k i
| Boundary_collapse_at (k, i) -> boundary_collapse k i

module Runs =
 struct
  type verdict = { solid_before : nat; alone_before : nat; solid_best : 
                   nat; alone_best : nat; chosen : bool }

  (** val solid_before : verdict -> nat **)

  let solid_before v =
    v.solid_before

  (** val alone_before : verdict -> nat **)

  let alone_before v =
    v.alone_before

  (** val solid_best : verdict -> nat **)

  let solid_best v =
    v.solid_best

  (** val alone_best : verdict -> nat **)

  let alone_best v =
    v.alone_best

  (** val chosen : verdict -> bool **)

  let chosen v =
    v.chosen

  type 'v corners = ('v * 'v) * 'v

  type 'v mesh_edge = 'v * 'v

  (** val rim : 'a1 corners -> 'a1 mesh_edge list **)

  let rim = function
  | (p, c) -> let (a, b) = p in (a, b) :: ((b, c) :: ((c, a) :: []))

  (** val turned : 'a1 mesh_edge -> 'a1 mesh_edge **)

  let turned e =
    ((snd e), (fst e))

  (** val same_edge :
      ('a1 -> 'a1 -> bool) -> 'a1 mesh_edge -> 'a1 mesh_edge -> bool **)

  let same_edge same0 e f =
    (&&) (same0 (fst e) (fst f)) (same0 (snd e) (snd f))

  (** val among :
      ('a1 -> 'a1 -> bool) -> 'a1 mesh_edge -> 'a1 mesh_edge list -> bool **)

  let among same0 e l =
    existsb (same_edge same0 e) l

  (** val either_way :
      ('a1 -> 'a1 -> bool) -> 'a1 mesh_edge -> 'a1 mesh_edge list -> bool **)

  let either_way same0 e l =
    (||) (among same0 e l) (among same0 (turned e) l)

  (** val distinct : ('a1 -> 'a1 -> bool) -> 'a1 corners list -> bool **)

  let rec distinct same0 = function
  | [] -> true
  | t :: r ->
    (&&)
      (match rim t with
       | [] -> false
       | e :: _ -> negb (existsb (fun u -> among same0 e (rim u)) r))
      (distinct same0 r)

  (** val between :
      ('a1 -> 'a1 -> bool) -> 'a1 corners -> 'a1 corners -> 'a1 mesh_edge
      option **)

  let between same0 t u =
    find (fun e -> among same0 (turned e) (rim u)) (rim t)

  (** val crossed :
      ('a1 -> 'a1 -> bool) -> 'a1 corners list -> edge list -> 'a1 mesh_edge
      list option **)

  let rec crossed same0 ts = function
  | [] -> Some []
  | e :: r ->
    let (i, j) = e in
    (match nth_error ts i with
     | Some t ->
       (match nth_error ts j with
        | Some u ->
          (match between same0 t u with
           | Some e0 ->
             (match crossed same0 ts r with
              | Some l -> Some (e0 :: l)
              | None -> None)
           | None -> None)
        | None -> None)
     | None -> None)

  (** val lies :
      ('a1 -> 'a1 -> bool) -> side -> 'a1 corners list -> 'a1 mesh_edge list
      -> 'a1 mesh_edge list -> ('a1 mesh_edge -> bool) -> bool **)

  let lies same0 d ts ps es neighbour =
    (&&)
      ((&&)
        ((&&)
          ((&&) (Nat.eqb (length ts) d.triangles)
            (Nat.eqb (length ps) (length d.owner))) (distinct same0 ts))
        (forallb (fun x ->
          match nth_error ts (fst x) with
          | Some t -> among same0 (snd x) (rim t)
          | None -> false) (combine d.owner ps)))
      (forallb (fun e ->
        (||) ((||) (among same0 e ps) (either_way same0 e es))
          (negb (neighbour e))) (flat_map rim ts))
 end

module Steps =
 struct
  type ('t, 's) sets = { none : 's; add : ('t -> 's -> 's);
                         drop : ('t -> 's -> 's); has : ('t -> 's -> bool) }

  (** val none : ('a1, 'a2) sets -> 'a2 **)

  let none s =
    s.none

  (** val add : ('a1, 'a2) sets -> 'a1 -> 'a2 -> 'a2 **)

  let add s =
    s.add

  (** val drop : ('a1, 'a2) sets -> 'a1 -> 'a2 -> 'a2 **)

  let drop s =
    s.drop

  (** val has : ('a1, 'a2) sets -> 'a1 -> 'a2 -> bool **)

  let has s =
    s.has

  type 't step =
  | Three of 't
  | Round of 't
  | Changes of z * z
 end

type state = (nat * nat) list

(** val label_in : state -> nat -> nat **)

let label_in st v =
  snd (nth v st ((S (S O)), O))

(** val blank : nat -> state **)

let blank size1 =
  map (fun v -> (O, v)) (seq O size1)

(** val bump : nat -> state -> state **)

let rec bump v = function
| [] -> []
| n :: r ->
  let (d, l) = n in
  (match v with
   | O -> ((S d), l) :: r
   | S v' -> n :: (bump v' r))

(** val relabel : nat -> nat -> state -> state **)

let relabel old new0 st =
  map (fun n -> if Nat.eqb (snd n) old then ((fst n), new0) else n) st

(** val step0 : edge -> state -> state option **)

let step0 e st =
  let (da, la) = nth (fst e) st ((S (S O)), O) in
  let (db, lb) = nth (snd e) st ((S (S O)), O) in
  if (&&) ((&&) (Nat.ltb da (S (S O))) (Nat.ltb db (S (S O))))
       (negb (Nat.eqb la lb))
  then Some
         (let st' = bump (fst e) (bump (snd e) st) in
          if Nat.ltb la lb then relabel lb la st' else relabel la lb st')
  else None

(** val draw : edge list -> coloring -> state -> state option **)

let rec draw es c st =
  match es with
  | [] -> Some st
  | e :: es' ->
    (match c with
     | [] -> Some st
     | b :: c' ->
       if b
       then (match step0 e st with
             | Some st' -> draw es' c' st'
             | None -> None)
       else draw es' c' st)

(** val alone : nat -> state -> nat **)

let alone k st =
  length (filter (fun n -> Nat.eqb (fst n) O) (skipn k st))

type score = nat * nat

(** val good : score -> score -> bool **)

let good v w =
  (||) (Nat.ltb (fst w) (fst v))
    ((&&) (Nat.eqb (fst v) (fst w)) (Nat.leb (snd v) (snd w)))

(** val size : side -> nat **)

let size d =
  add (length d.owner) d.triangles

(** val drawn : side -> coloring -> coloring -> state option **)

let drawn d s x =
  match draw (port_edges d) s (blank (size d)) with
  | Some st -> draw (inner_edges d) x st
  | None -> None

type binary_state = (nat * positive) list

(** val unary : (nat * positive) -> nat * nat **)

let unary n =
  ((fst n), (pred (Pos.to_nat (snd n))))

(** val books : binary_state -> state **)

let books st =
  map unary st

(** val blank_labels : nat -> binary_state **)

let blank_labels size1 =
  map (fun v -> (O, (Pos.of_succ_nat v))) (seq O size1)

(** val count_edge : nat -> binary_state -> binary_state **)

let rec count_edge v = function
| [] -> []
| n :: r ->
  let (d, l) = n in
  (match v with
   | O -> ((S d), l) :: r
   | S v' -> n :: (count_edge v' r))

(** val replace : positive -> positive -> binary_state -> binary_state **)

let replace old new0 st =
  map (fun n -> if Pos.eqb (snd n) old then ((fst n), new0) else n) st

(** val add_edge : edge -> binary_state -> binary_state option **)

let add_edge e st =
  let (da, la) = nth (fst e) st ((S (S O)), XH) in
  let (db, lb) = nth (snd e) st ((S (S O)), XH) in
  if (&&) ((&&) (Nat.ltb da (S (S O))) (Nat.ltb db (S (S O))))
       (negb (Pos.eqb la lb))
  then Some
         (let st' = count_edge (fst e) (count_edge (snd e) st) in
          if Pos.ltb la lb then replace lb la st' else replace la lb st')
  else None

(** val add_edges :
    edge list -> coloring -> binary_state -> binary_state option **)

let rec add_edges es c st =
  match es with
  | [] -> Some st
  | e :: es' ->
    (match c with
     | [] -> Some st
     | b :: c' ->
       if b
       then (match add_edge e st with
             | Some st' -> add_edges es' c' st'
             | None -> None)
       else add_edges es' c' st)

(** val drawn_with_labels : side -> coloring -> coloring -> state option **)

let drawn_with_labels d s x =
  match add_edges (port_edges d) s (blank_labels (size d)) with
  | Some st -> option_map books (add_edges (inner_edges d) x st)
  | None -> None

type place = { deg : nat; port : nat option }

type frontier = { anchor : place; tip : place; same : bool }

type step1 =
| Put of nat option
| Next of nat option
| Mark of nat option
| Chord

(** val fresh : nat option -> place **)

let fresh p = match p with
| Some _ -> { deg = (S O); port = p }
| None -> { deg = O; port = None }

(** val agree : nat option -> nat option -> bool **)

let agree l m =
  match l with
  | Some a -> (match m with
               | Some b -> Nat.eqb a b
               | None -> true)
  | None -> true

(** val either : nat option -> nat option -> nat option **)

let either l m =
  match l with
  | Some _ -> l
  | None -> m

(** val open_end : place -> bool **)

let open_end x =
  Nat.ltb x.deg (S (S O))

(** val tidy_place : place -> place **)

let tidy_place x =
  if open_end x then x else { deg = x.deg; port = None }

(** val tidy : frontier -> frontier **)

let tidy f =
  { anchor = (tidy_place f.anchor); tip = (tidy_place f.tip); same =
    ((&&) ((&&) f.same (open_end f.anchor)) (open_end f.tip)) }

(** val more : place -> nat option -> place **)

let more x l =
  { deg = (S x.deg); port = l }

(** val take : step1 -> bool -> frontier -> frontier option **)

let take s b f =
  match s with
  | Put p ->
    if b
    then None
    else Some { anchor = f.anchor; tip = (fresh p); same = false }
  | Next p ->
    let l = either f.tip.port p in
    if b
    then if (&&) (open_end f.tip) (agree f.tip.port p)
         then Some
                (tidy { anchor =
                  (if f.same
                   then { deg = f.anchor.deg; port = l }
                   else f.anchor); tip = (more (fresh p) l); same = f.same })
         else None
    else Some { anchor = f.anchor; tip = (fresh p); same = false }
  | Mark p ->
    let l = either f.tip.port p in
    if b
    then if (&&) (open_end f.tip) (agree f.tip.port p)
         then Some
                (tidy { anchor = (more f.tip l); tip = (more (fresh p) l);
                  same = true })
         else None
    else Some { anchor = f.tip; tip = (fresh p); same = false }
  | Chord ->
    let l = either f.anchor.port f.tip.port in
    if b
    then if (&&)
              ((&&) ((&&) (open_end f.anchor) (open_end f.tip)) (negb f.same))
              (agree f.anchor.port f.tip.port)
         then Some
                (tidy { anchor = (more f.anchor l); tip = (more f.tip l);
                  same = true })
         else None
    else Some f

(** val lone : nat -> nat **)

let lone n =
  if Nat.eqb n O then S O else O

(** val left_alone : step1 -> bool -> frontier -> nat **)

let left_alone s b f =
  match s with
  | Put _ -> lone f.tip.deg
  | Next _ -> if b then O else lone f.tip.deg
  | Mark _ -> lone f.anchor.deg
  | Chord -> O

(** val at_end : frontier -> nat **)

let at_end f =
  add (lone f.anchor.deg) (lone f.tip.deg)

(** val blank_frontier : frontier **)

let blank_frontier =
  { anchor = { deg = O; port = None }; tip = { deg = O; port = None }; same =
    false }

(** val play :
    step1 list -> coloring -> frontier -> nat -> nat ->
    (frontier * (nat * nat)) option **)

let rec play ss c f n i =
  match ss with
  | [] -> (match c with
           | [] -> Some (f, (n, i))
           | _ :: _ -> None)
  | s :: ss' ->
    (match c with
     | [] -> None
     | b :: c' ->
       (match take s b f with
        | Some g ->
          play ss' c' g (if b then S n else n) (add i (left_alone s b f))
        | None -> None))

(** val same_label : nat option -> nat option -> bool **)

let same_label a b =
  match a with
  | Some x -> (match b with
               | Some y -> Nat.eqb x y
               | None -> false)
  | None -> (match b with
             | Some _ -> false
             | None -> true)

(** val same_place : place -> place -> bool **)

let same_place x y =
  (&&) (Nat.eqb x.deg y.deg) (same_label x.port y.port)

(** val same_frontier : frontier -> frontier -> bool **)

let same_frontier f g =
  (&&) ((&&) (same_place f.anchor g.anchor) (same_place f.tip g.tip))
    (eqb f.same g.same)

type 'h entry = (frontier * score) * 'h

(** val insert :
    frontier -> score -> 'a1 -> 'a1 entry list -> 'a1 entry list **)

let rec insert f v h = function
| [] -> ((f, v), h) :: []
| e :: r ->
  let (p, k) = e in
  let (g, w) = p in
  if same_frontier f g
  then (if good w v then ((g, w), k) else ((g, v), h)) :: r
  else ((g, w), k) :: (insert f v h r)

(** val add_choice :
    (bool -> 'a1 -> 'a1) -> step1 -> bool -> 'a1 entry list -> 'a1 entry ->
    'a1 entry list **)

let add_choice note s b d = function
| (p, h) ->
  let (f, s0) = p in
  let (n, i) = s0 in
  (match take s b f with
   | Some g ->
     insert g ((if b then S n else n), (add i (left_alone s b f))) (note b h)
       d
   | None -> d)

(** val add_both :
    (bool -> 'a1 -> 'a1) -> step1 -> 'a1 entry list -> 'a1 entry -> 'a1 entry
    list **)

let add_both note s d e =
  add_choice note s true (add_choice note s false d e) e

(** val extend :
    (bool -> 'a1 -> 'a1) -> step1 -> 'a1 entry list -> 'a1 entry list **)

let extend note s d =
  fold_left (add_both note s) d []

(** val extends :
    (bool -> 'a1 -> 'a1) -> step1 list -> 'a1 entry list -> 'a1 entry list **)

let extends note ss d =
  fold_left (fun d0 s -> extend note s d0) ss d

type coloring_entry = coloring entry

(** val remember : bool -> coloring -> coloring **)

let remember b h =
  b :: h

(** val blank_entries : coloring_entry list **)

let blank_entries =
  ((blank_frontier, (O, O)), []) :: []

(** val finished : 'a1 entry -> score **)

let finished = function
| (p, _) -> let (f, s) = p in let (n, i) = s in (n, (add i (at_end f)))

(** val best_entry : 'a1 entry list -> 'a1 entry option **)

let best_entry d =
  fold_right (fun e o ->
    match o with
    | Some d0 -> if good (finished d0) (finished e) then Some d0 else Some e
    | None -> Some e) None d

type kind =
| Put0
| Next0
| Mark0
| Chord0

type shape = (kind * nat) list

(** val arranged : nat -> nat -> 'a1 list -> 'a1 list **)

let arranged m r l =
  app (firstn m l) (app (skipn (add m r) l) (firstn r (skipn m l)))

(** val port_of : nat -> coloring -> (nat -> nat) -> nat -> nat option **)

let port_of k s lab t =
  if (&&) (Nat.ltb t k) (nth t s false) then Some (lab t) else None

(** val step_of : nat -> coloring -> (nat -> nat) -> (kind * nat) -> step1 **)

let step_of k s lab x =
  match fst x with
  | Put0 -> Put (port_of k s lab (snd x))
  | Next0 -> Next (port_of k s lab (snd x))
  | Mark0 -> Mark (port_of k s lab (snd x))
  | Chord0 -> Chord

(** val choices : nat -> nat -> coloring -> coloring **)

let choices m r x =
  false :: (arranged m r x)

(** val route : nat list -> nat list -> nat list -> bool -> bool -> shape **)

let route l1 l2 l3 chorded closed =
  app
    (match l1 with
     | [] -> []
     | x :: l -> (Put0, x) :: (map (fun x0 -> (Next0, x0)) l))
    (app
      (match l2 with
       | [] -> []
       | y :: l -> (Mark0, y) :: (map (fun x -> (Next0, x)) l))
      (app (if chorded then (Chord0, O) :: [] else [])
        (app (map (fun x -> (Next0, x)) l3)
          (if closed then (Chord0, O) :: [] else []))))

(** val closed_route : nat -> shape **)

let closed_route k =
  route (O :: []) (seq (S O) (sub k (S O))) [] false true

(** val ring_route : nat -> nat -> shape **)

let ring_route k a =
  route (k :: []) (app (seq O a) ((add k (S O)) :: [])) (seq a (sub k a))
    true true

(** val open_route : nat -> shape **)

let open_route k =
  route (seq O k) [] [] false false

(** val chord_route : nat -> nat -> nat -> shape **)

let chord_route k i j =
  route (app (seq O i) (k :: []))
    (app (seq i (sub j i)) ((add k (S O)) :: [])) (seq j (sub k j)) true false

(** val one_route : nat -> nat -> shape **)

let one_route k i =
  route (app (seq O i) (k :: (seq i (sub k i)))) [] [] false false

type course = { way : shape; met_first : nat; met_last : nat; left_over : nat }

(** val course_at : position -> course **)

let course_at = function
| Split_at (k, a) ->
  { way = (ring_route k a); met_first = (add a (S O)); met_last =
    (add (sub k a) (S O)); left_over = (S O) }
| Collapse_at (k, _) ->
  { way = (closed_route k); met_first = (sub k (S O)); met_last = (S O);
    left_over = O }
| Open_split_at (k, i, j) ->
  { way = (chord_route k i j); met_first = (add j (S O)); met_last =
    (sub k j); left_over = (S O) }
| Open_collapse_at (k, _, _) ->
  { way = (open_route k); met_first = (sub k (S O)); met_last = O;
    left_over = O }
| Boundary_split_at (k, i) ->
  { way = (one_route k i); met_first = k; met_last = O; left_over = O }
| Boundary_collapse_at (k, _) ->
  { way = (open_route k); met_first = (sub k (S O)); met_last = O;
    left_over = O }

(** val weigh :
    position -> coloring -> coloring -> coloring -> Runs.verdict option **)

let weigh o s c x =
  let p = patch_at o in
  let r = course_at o in
  (match drawn_with_labels p.before s c with
   | Some st ->
     let ss = map (step_of (ports p) s (label_in st)) r.way in
     (match best_entry (extends remember ss blank_entries) with
      | Some e ->
        let found =
          match play ss (choices r.met_first r.met_last x) blank_frontier O O with
          | Some p0 ->
            let (f, p1) = p0 in
            let (n, i) = p1 in good (n, (add i (at_end f))) (finished e)
          | None -> false
        in
        Some { Runs.solid_before = (solids c); Runs.alone_before =
        (alone (ports p) st); Runs.solid_best = (fst (finished e));
        Runs.alone_best = (sub (snd (finished e)) (S (S O))); Runs.chosen =
        ((&&) (Nat.eqb (length x) (length p.after.inner)) found) }
      | None -> None)
   | None -> None)

type way_on = coloring * coloring

(** val all_colorings : nat -> coloring list **)

let rec all_colorings = function
| O -> [] :: []
| S m ->
  app (map (fun x -> false :: x) (all_colorings m))
    (map (fun x -> true :: x) (all_colorings m))

(** val keeps : coloring -> coloring -> bool **)

let keeps s s' =
  (&&) (Nat.eqb (length s') (length s))
    (forallb (fun i -> implb (nth i s' false) (nth i s false))
      (seq O (length s')))

(** val flip_allowed : state -> coloring -> way_on -> bool **)

let flip_allowed st s w =
  (&&) ((&&) (keeps s (fst w)) (Nat.eqb (length (snd w)) (S O)))
    (match drawn flip.after (fst w) (snd w) with
     | Some st' ->
       forallb (fun i ->
         forallb (fun j ->
           implb (Nat.eqb (label_in st' i) (label_in st' j))
             (Nat.eqb (label_in st i) (label_in st j)))
           (seq O (S (S (S (S O)))))) (seq O (S (S (S (S O)))))
     | None -> false)

(** val flip_alone : coloring -> way_on -> nat **)

let flip_alone s w =
  lone_or_given_up s (fst w) (snd w)

(** val flip_edges : way_on -> nat **)

let flip_edges w =
  add (solids (fst w)) (solids (snd w))

(** val flip_good : coloring -> way_on -> way_on -> bool **)

let flip_good s v w =
  (||) (Nat.ltb (flip_edges w) (flip_edges v))
    ((&&) (Nat.eqb (flip_edges w) (flip_edges v))
      ((||) (Nat.ltb (flip_alone s v) (flip_alone s w))
        ((&&) (Nat.eqb (flip_alone s v) (flip_alone s w))
          (Nat.leb (solids (fst w)) (solids (fst v))))))

(** val ways_on : state -> coloring -> way_on list **)

let ways_on st s =
  filter (flip_allowed st s)
    (flat_map (fun s' -> (s', (false :: [])) :: ((s', (true :: [])) :: []))
      (all_colorings (S (S (S (S O))))))

(** val first_of : coloring -> way_on list -> way_on option **)

let first_of s l =
  fold_right (fun w o ->
    match o with
    | Some v -> if flip_good s v w then Some v else Some w
    | None -> Some w) None l

(** val weigh_flip : coloring -> coloring -> way_on -> Runs.verdict option **)

let weigh_flip s c w =
  match drawn flip.before s c with
  | Some st ->
    (match first_of s (ways_on st s) with
     | Some v ->
       Some { Runs.solid_before = (add (solids s) (solids c));
         Runs.alone_before = (isolated flip.before s c); Runs.solid_best =
         (flip_edges v); Runs.alone_best = (flip_alone s v); Runs.chosen =
         ((&&) (flip_allowed st s w) (flip_good s w v)) }
     | None -> None)
  | None -> None

(** val judge :
    ('a1 -> 'a1 -> bool) -> position -> 'a1 Runs.corners list -> 'a1
    Runs.corners list -> 'a1 Runs.mesh_edge list -> ('a1 Runs.mesh_edge ->
    bool) -> ('a1 Runs.mesh_edge -> bool) -> ('a1 Runs.mesh_edge -> bool) ->
    ('a1 Runs.mesh_edge -> bool) -> 'a1 Runs.mesh_edge list -> Runs.verdict
    option **)

let judge same0 o olds news ps was is beside beside' altered =
  let p = patch_at o in
  (match Runs.crossed same0 olds p.before.inner with
   | Some es ->
     (match Runs.crossed same0 news p.after.inner with
      | Some fs ->
        if (&&)
             ((&&) (possible o) (Runs.lies same0 p.before olds ps es beside))
             (Runs.lies same0 p.after news ps fs beside')
        then (match weigh o (map was ps) (map was es) (map is fs) with
              | Some v ->
                let kept = forallb (fun e -> eqb (is e) (was e)) ps in
                let inside =
                  forallb (fun e ->
                    (||) (Runs.either_way same0 e es)
                      (Runs.either_way same0 e fs)) altered
                in
                Some { Runs.solid_before = v.Runs.solid_before;
                Runs.alone_before = v.Runs.alone_before; Runs.solid_best =
                v.Runs.solid_best; Runs.alone_best = v.Runs.alone_best;
                Runs.chosen = ((&&) ((&&) v.Runs.chosen kept) inside) }
              | None -> None)
        else None
      | None -> None)
   | None -> None)

(** val judge_flip :
    ('a1 -> 'a1 -> bool) -> 'a1 Runs.corners list -> 'a1 Runs.corners list ->
    'a1 Runs.mesh_edge list -> ('a1 Runs.mesh_edge -> bool) -> ('a1
    Runs.mesh_edge -> bool) -> ('a1 Runs.mesh_edge -> bool) -> ('a1
    Runs.mesh_edge -> bool) -> 'a1 Runs.mesh_edge list -> Runs.verdict option **)

let judge_flip same0 olds news ps was is beside beside' altered =
  match Runs.crossed same0 olds flip.before.inner with
  | Some es ->
    (match Runs.crossed same0 news flip.after.inner with
     | Some fs ->
       if (&&) (Runs.lies same0 flip.before olds ps es beside)
            (Runs.lies same0 flip.after news ps fs beside')
       then (match weigh_flip (map was ps) (map was es) ((map is ps),
                     (map is fs)) with
             | Some v ->
               let inside =
                 forallb (fun e ->
                   (||)
                     ((||) (Runs.either_way same0 e ps)
                       (Runs.either_way same0 e es))
                     (Runs.either_way same0 e fs)) altered
               in
               Some { Runs.solid_before = v.Runs.solid_before;
               Runs.alone_before = v.Runs.alone_before; Runs.solid_best =
               v.Runs.solid_best; Runs.alone_best = v.Runs.alone_best;
               Runs.chosen = ((&&) v.Runs.chosen inside) }
             | None -> None)
       else None
     | None -> None)
  | None -> None

(** val add_all : ('a1, 'a2) Steps.sets -> 'a2 -> 'a1 list -> 'a2 **)

let add_all k s ts =
  fold_left (fun s0 t -> k.Steps.add t s0) ts s

(** val count : ('a1 -> bool) -> 'a1 list -> z **)

let count f ts =
  fold_left (fun n t -> if f t then Z.succ n else n) ts Z0

(** val size0 : 'a1 list -> z **)

let size0 l =
  fold_left (fun n _ -> Z.succ n) l Z0

(** val without : ('a1 -> 'a1 -> bool) -> 'a1 -> 'a1 list -> 'a1 list **)

let rec without same0 t = function
| [] -> []
| u :: r -> if same0 t u then r else u :: (without same0 t r)

(** val walk :
    ('a1, 'a2) Steps.sets -> ('a1 -> 'a1 -> bool) -> ('a1 -> 'a1 list) -> nat
    -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a2 -> 'a2 option **)

let rec walk k same0 beside fuel t from one back other pending =
  match fuel with
  | O -> None
  | S fuel0 ->
    (match without same0 from (beside one) with
     | [] -> Some pending
     | u :: _ ->
       if same0 t u
       then None
       else walk k same0 beside fuel0 t back other one u
              (k.Steps.drop u pending))

(** val fault :
    ('a1, 'a2) Steps.sets -> ('a1 -> 'a1 -> bool) -> nat -> ('a1 -> 'a1 list)
    -> 'a1 list -> 'a2 -> 'a1 Steps.step option **)

let rec fault k same0 fuel beside ts pending =
  match ts with
  | [] -> None
  | t :: r ->
    (match beside t with
     | [] -> fault k same0 fuel beside r pending
     | a :: l ->
       (match l with
        | [] -> fault k same0 fuel beside r pending
        | b :: l0 ->
          (match l0 with
           | [] ->
             if k.Steps.has t pending
             then (match walk k same0 beside fuel t t a t b
                           (k.Steps.drop a (k.Steps.drop b pending)) with
                   | Some pending0 -> fault k same0 fuel beside r pending0
                   | None -> Some (Steps.Round t))
             else fault k same0 fuel beside r pending
           | _ :: _ -> Some (Steps.Three t))))

(** val see :
    ('a1, 'a2) Steps.sets -> ('a1 list * 'a2) -> 'a1 -> 'a1 list * 'a2 **)

let see k found t =
  if k.Steps.has t (snd found)
  then found
  else ((t :: (fst found)), (k.Steps.add t (snd found)))

(** val stays :
    ('a1, 'a2) Steps.sets -> 'a1 list -> 'a1 list -> ('a1 * 'a1) list ->
    ('a1 * 'a1) list -> 'a1 list **)

let stays k gone come lost made =
  let sees = fun found e -> see k (see k found (fst e)) (snd e) in
  fst
    (fold_left sees made
      (fold_left sees lost ([],
        (add_all k (add_all k k.Steps.none gone) come))))

(** val judge_step :
    ('a1, 'a2) Steps.sets -> ('a1 -> 'a1 -> bool) -> nat -> ('a1 -> bool) ->
    ('a1 -> 'a1 list) -> 'a1 list -> 'a1 list -> ('a1 * 'a1) list ->
    ('a1 * 'a1) list -> 'a1 Steps.step **)

let judge_step k same0 fuel lone0 beside gone come lost made =
  let still = stays k gone come lost made in
  let news = rev_append come still in
  (match fault k same0 fuel beside news (add_all k k.Steps.none news) with
   | Some wrong -> wrong
   | None ->
     Steps.Changes
       ((Z.sub (Z.sub (size0 come) (size0 gone))
          (Z.sub (size0 made) (size0 lost))),
       (Z.sub
         (count (fun t -> match beside t with
                          | [] -> true
                          | _ :: _ -> false) news)
         (Z.add (count lone0 gone) (count lone0 still)))))
