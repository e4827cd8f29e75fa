(* Finds the patch of an operation in the checker's mesh by walking around its vertices. This code need not be trusted:
   Judge refuses triangles that do not lie as the given patch. *)

open Mesh

let rec nat n : Judge.nat = if n <= 0 then O else S (nat (n - 1))
let rec int : Judge.nat -> int = function O -> 0 | S n -> 1 + int n

(* The side with the new triangles, the larger one: t_0 ... t_{k-1}, then A, and D if it exists. Each t_i is (centre, x, y)
   with the port x-y. *)
type larger = { triangles : triangle list; valence : int; at : at }
and at = Ring of int | Path of int * int | End of int

let cannot s t = refuse "edge %d %d does not lie in the mesh as a split makes it or a collapse takes it" s t

(* The triangles of a vertex, counter-clockwise from the mesh edge c-x, to the boundary or around. *)
let fan_from mesh c x =
  let rec on found at =
    match left_of mesh c at with
    | Some (_, _, next) when next <> x -> on ((c, at, next) :: found) next
    | Some (_, _, next) -> List.rev ((c, at, next) :: found)
    | None -> List.rev found
  in
  on [] x

(* The spoke from which all triangles of c are reached: the first one on the boundary, otherwise x. *)
let first_spoke mesh c x =
  let rec back at =
    match left_of mesh at c with Some (_, _, w) when w <> x -> back w | Some _ -> (x, true) | None -> (at, false)
  in
  back x

let rec without_last = function [] | [ _ ] -> [] | x :: rest -> x :: without_last rest
let inner triangles = match triangles with [] -> [] | _ :: rest -> without_last rest

(* The patch around the mesh edge s-t after a split or before a collapse. *)
let around mesh s t =
  let one_sided u v =
    let w = match left_of mesh u v with Some (_, _, w) -> w | None -> cannot s t in
    let first, _ = first_spoke mesh v w in
    let before = without_last (fan_from mesh v first) and after = List.tl (fan_from mesh u v) in
    let i = List.length before in
    { triangles = before @ after @ [ (u, v, w) ]; valence = i + List.length after; at = End i }
  in
  match (left_of mesh s t, left_of mesh t s) with
  | None, None -> cannot s t
  | Some _, None -> one_sided s t
  | None, Some _ -> one_sided t s
  | Some a, Some d -> (
      let first_s, s_closed = first_spoke mesh s t and first_t, t_closed = first_spoke mesh t s in
      let opened closed first o =
        (* Around the vertex o on the boundary; [closed] is the other one. *)
        let rec part before = function
          | ((_, _, y) as a) :: (((_, z, _) as d) :: rest) when y = closed && z = closed -> (List.rev before, a, d, rest)
          | x :: rest -> part (x :: before) rest
          | [] -> cannot s t
        in
        let before, a, d, after = part [] (fan_from mesh o first) in
        let middle = inner (fan_from mesh closed o) in
        let i = List.length before and m = List.length middle in
        { triangles = before @ middle @ after @ [ a; d ]; valence = i + m + List.length after; at = Path (i, i + m) }
      in
      match (s_closed, t_closed) with
      | true, true ->
          let of_s = inner (fan_from mesh s t) and of_t = inner (fan_from mesh t s) in
          let i = List.length of_s in
          { triangles = of_s @ of_t @ [ a; d ]; valence = i + List.length of_t; at = Ring i }
      | true, false -> opened s first_t t
      | false, true -> opened t first_s s
      | false, false -> cannot s t)

(* The triangles of a flip before and after, and its ports. *)
let flip mesh u v =
  match (left_of mesh u v, left_of mesh v u) with
  | Some (_, _, l), Some (_, _, r) ->
      ([ (u, v, l); (v, u, r) ], [ (l, u, r); (r, v, l) ], [ (v, l); (l, u); (u, r); (r, v) ])
  | _ -> refuse "edge %d %d has no triangle on one side" u v

let rec take n = function x :: rest when n > 0 -> x :: take (n - 1) rest | _ -> []

(* The other side: the vertex is s again, and the new triangles are absent. *)
let smaller s larger = List.map (fun (_, x, y) -> (s, x, y)) (take larger.valence larger.triangles)
let ports larger = List.map (fun (_, x, y) -> (x, y)) (take larger.valence larger.triangles)

(* The terms of docs/reference/notation.md. *)
let families = [ "split"; "collapse"; "open split"; "open collapse"; "boundary split"; "boundary collapse"; "flip" ]

let family : Judge.position -> string = function
  | Split_at _ -> "split"
  | Collapse_at _ -> "collapse"
  | Open_split_at _ -> "open split"
  | Open_collapse_at _ -> "open collapse"
  | Boundary_split_at _ -> "boundary split"
  | Boundary_collapse_at _ -> "boundary collapse"

let position kind larger : Judge.position =
  let k = nat larger.valence in
  match (kind, larger.at) with
  | `Split, Ring a -> Split_at (k, nat a)
  | `Collapse, Ring a -> Collapse_at (k, nat a)
  | `Split, Path (i, j) -> Open_split_at (k, nat i, nat j)
  | `Collapse, Path (i, j) -> Open_collapse_at (k, nat i, nat j)
  | `Split, End i -> Boundary_split_at (k, nat i)
  | `Collapse, End i -> Boundary_collapse_at (k, nat i)
