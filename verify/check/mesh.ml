(* The checker's mesh: triangles by vertex numbers, and the mesh edges that are crossed by a solid dual edge. It knows only
   what a trace says, and refuses what is impossible.

   The dual edge across the mesh edge u-v is also called u-v here. *)

exception Refused of string

let refuse format = Printf.ksprintf (fun text -> raise (Refused text)) format

type triangle = int * int * int (* counter-clockwise *)

(* Two vertices in one word, from the first to the second. *)
let bits = 31
let largest_vertex = (1 lsl bits) - 1
let directed u v = (u lsl bits) lor v
let undirected u v = if u < v then directed u v else directed v u

(* Maps mesh edges to numbers: a key lies in the first free slot at or after its own, without gaps in between. *)
module Edges = struct
  type t = { mutable keys : int array; mutable values : int array; mutable length : int }

  let free = -1
  let create size = { keys = Array.make size free; values = Array.make size 0; length = 0 }
  let length edges = edges.length
  let next keys i = (i + 1) land (Array.length keys - 1)

  (* Sizes are powers of two. *)
  let own_place keys key =
    let mixed = key * 0x1E3779B97F4A7C15 in
    (mixed lxor (mixed lsr 29)) land (Array.length keys - 1)

  (* The slot of the key, or the slot where it belongs. *)
  let place keys (key : int) =
    let rec from i =
      let there = keys.(i) in
      if there = key || there = free then i else from (next keys i)
    in
    from (own_place keys key)

  let mem edges key = edges.keys.(place edges.keys key) = key

  let find_opt edges key =
    let i = place edges.keys key in
    if edges.keys.(i) = key then Some edges.values.(i) else None

  let find edges key =
    let i = place edges.keys key in
    if edges.keys.(i) = key then edges.values.(i) else raise Not_found

  let iter f edges = Array.iteri (fun i key -> if key <> free then f key edges.values.(i)) edges.keys

  let rec replace edges key value =
    let i = place edges.keys key in
    if edges.keys.(i) = key then edges.values.(i) <- value
    else if 2 * (edges.length + 1) > Array.length edges.keys then (
      let larger = create (2 * Array.length edges.keys) in
      iter (replace larger) edges;
      edges.keys <- larger.keys;
      edges.values <- larger.values;
      replace edges key value)
    else (
      edges.keys.(i) <- key;
      edges.values.(i) <- value;
      edges.length <- edges.length + 1)

  (* The keys after it, up to the next gap, are inserted again. *)
  let remove edges key =
    let i = place edges.keys key in
    if edges.keys.(i) = key then (
      let rec put_again i =
        let key = edges.keys.(i) in
        if key <> free then (
          edges.keys.(i) <- free;
          let to_ = place edges.keys key in
          edges.keys.(to_) <- key;
          edges.values.(to_) <- edges.values.(i);
          put_again (next edges.keys i))
      in
      edges.keys.(i) <- free;
      edges.length <- edges.length - 1;
      put_again (next edges.keys i))
end

type t = {
  third : Edges.t; (* of the triangle to the left of a directed mesh edge *)
  solid : Edges.t; (* undirected; a set *)
  mutable triangles : int;
  mutable isolated : int;
}

let empty () = { third = Edges.create 1024; solid = Edges.create 1024; triangles = 0; isolated = 0 }

(* For valid colourings: a strip has one triangle more than solid edges. *)
let strips mesh = mesh.triangles - Edges.length mesh.solid
let has_left mesh u v = Edges.mem mesh.third (directed u v)
let is_solid mesh u v = Edges.mem mesh.solid (undirected u v)
let left_of mesh u v : triangle option = Option.map (fun w -> (u, v, w)) (Edges.find_opt mesh.third (directed u v))

let degree mesh ((a, b, c) : triangle) =
  Bool.to_int (is_solid mesh a b) + Bool.to_int (is_solid mesh b c) + Bool.to_int (is_solid mesh c a)

let has_triangle mesh ((a, b, c) : triangle) =
  let is u v w = match Edges.find_opt mesh.third (directed u v) with Some x -> x = w | None -> false in
  is a b c && is b c a && is c a b

(* The same triangle, its smallest corner first. *)
let canonical ((a, b, c) : triangle) : triangle =
  if a < b && a < c then (a, b, c) else if b < c && b < a then (b, c, a) else (c, a, b)

let same_triangle ((a, b, c) : triangle) ((x, y, z) : triangle) = a = x && b = y && c = z

let compare_triangles ((a, b, c) : triangle) ((x, y, z) : triangle) =
  if a <> x then Int.compare a x else if b <> y then Int.compare b y else Int.compare c z

(* ---- one change at a time *)

let add_triangle mesh ((a, b, c) : triangle) =
  if a = b || b = c || c = a then refuse "triangle %d %d %d has a corner twice" a b c;
  List.iter
    (fun (u, v) ->
      if has_left mesh u v then refuse "triangle %d %d %d lies at edge %d %d, which already has one on that side" a b c u v)
    [ (a, b); (b, c); (c, a) ];
  Edges.replace mesh.third (directed a b) c;
  Edges.replace mesh.third (directed b c) a;
  Edges.replace mesh.third (directed c a) b;
  mesh.triangles <- mesh.triangles + 1

let remove_triangle mesh ((a, b, c) as t : triangle) =
  if not (has_triangle mesh t) then refuse "triangle %d %d %d is removed, but the mesh has no such triangle" a b c;
  Edges.remove mesh.third (directed a b);
  Edges.remove mesh.third (directed b c);
  Edges.remove mesh.third (directed c a);
  mesh.triangles <- mesh.triangles - 1

let expect_both_sides mesh u v =
  if not (has_left mesh u v && has_left mesh v u) then
    refuse "edge %d %d is solid, but it has no triangle on one side" u v

let make_solid mesh (u, v) =
  if is_solid mesh u v then refuse "edge %d %d becomes solid, but it is solid already" u v;
  expect_both_sides mesh u v;
  Edges.replace mesh.solid (undirected u v) 0

let make_dashed mesh (u, v) =
  if not (is_solid mesh u v) then refuse "edge %d %d becomes dashed, but it is not solid" u v;
  Edges.remove mesh.solid (undirected u v)

(* ---- validity: no degree above two, no cycle *)

let expect_degree mesh ((a, b, c) as t : triangle) =
  let degree = degree mesh t in
  if degree > 2 then refuse "triangle %d %d %d has three solid edges" a b c;
  degree

(* Follows a strip over u-v into the triangle u v w and returns the next triangle in the same form. *)
let onward mesh ((u, v, w) : triangle) =
  let across x y = Some (y, x, Edges.find mesh.third (directed y x)) in
  match (is_solid mesh v w, is_solid mesh w u) with
  | true, false -> across v w
  | false, true -> across w u
  | false, false -> None
  | true, true -> refuse "triangle %d %d %d has three solid edges" u v w

(* ---- the whole mesh *)

let iter_triangles mesh f =
  Edges.iter
    (fun key w ->
      let u = key lsr bits and v = key land largest_vertex in
      if u < v && u < w then f (u, v, w))
    mesh.third

(* Recounts everything, by walking along all strips from their ends. *)
let expect_whole mesh =
  Edges.iter (fun key _ -> expect_both_sides mesh (key lsr bits) (key land largest_vertex)) mesh.solid;
  let triangles = ref 0 and isolated = ref 0 and ends = ref 0 and passed = ref 0 in
  let walk (a, b, c) =
    incr ends;
    let rec follow = function
      | None -> ()
      | Some entered ->
          incr passed;
          follow (onward mesh entered)
    in
    incr passed;
    (* As if entered over a dashed edge. *)
    follow (onward mesh (if is_solid mesh a b then (b, c, a) else (a, b, c)))
  in
  iter_triangles mesh (fun t ->
      incr triangles;
      match expect_degree mesh t with 0 -> incr isolated | 1 -> walk t | _ -> ());
  (* Every path has been walked from both of its ends. *)
  if (2 * !isolated) + !passed <> 2 * !triangles then refuse "some solid edges form a cycle";
  if !triangles <> mesh.triangles then refuse "there are %d triangles, but %d were counted" !triangles mesh.triangles;
  if 2 * strips mesh <> (2 * !isolated) + !ends then
    refuse "there are %d strips, but %d were counted" (!isolated + (!ends / 2)) (strips mesh);
  !isolated
