(* One operation on the whole mesh, whatever its kind: makes the changes of the trace, and asks Judge.judge_step whether
   the colouring stays valid and by how much strips and isolated triangles change. Judge_step_right
   (verify/formal/Statements.v) says what must be true of the arguments; that is tested. *)

open Mesh
open Trace

module Triangles = Set.Make (struct
  type t = triangle

  let compare = compare_triangles
end)

let sets : (triangle, Triangles.t) Judge.Steps.sets =
  { none = Triangles.empty; add = Triangles.add; drop = Triangles.remove; has = Triangles.mem }

(* More steps than any walk takes: each walk ends or returns to its start. *)
let rec endless = Judge.S endless
let rec positive : Judge.positive -> int = function XH -> 1 | XO p -> 2 * positive p | XI p -> (2 * positive p) + 1
let integer : Judge.z -> int = function Z0 -> 0 | Zpos p -> positive p | Zneg p -> -positive p
let sides ((a, b, c) : triangle) = [ (a, b); (b, c); (c, a) ]

(* The triangle to the left of u-v, which exists. *)
let beyond mesh u v = canonical (u, v, Edges.find mesh.third (directed u v))

let beside mesh ((a, b, c) : triangle) =
  let across u v rest = if is_solid mesh u v then beyond mesh v u :: rest else rest in
  across a b (across b c (across c a []))

let dual_edge mesh key =
  let u = key lsr bits and v = key land largest_vertex in
  (beyond mesh u v, beyond mesh v u)

(* The solid dual edges of the triangles [turned] and across the edges [listed], each once. A removed triangle loses its dual
   edges even if the mesh edges stay solid. *)
let solid_edges mesh turned listed =
  let add keys (u, v) = if is_solid mesh u v then undirected u v :: keys else keys in
  let keys = List.fold_left (fun keys t -> List.fold_left add keys (sides t)) (List.fold_left add [] listed) turned in
  List.rev_map (dual_edge mesh) (List.sort_uniq Int.compare keys)

(* The isolated triangles among those that Judge asks about: removed triangles and the ends of new solid edges. *)
let isolated_before mesh gone solid =
  let add found t = if degree mesh t = 0 then Triangles.add t found else found in
  let add_side found u v = match left_of mesh u v with Some t -> add found (canonical t) | None -> found in
  List.fold_left (fun found (u, v) -> add_side (add_side found u v) v u) (List.fold_left add Triangles.empty gone) solid

(* Changes of strips and isolated triangles. *)
let judged mesh lone ~gone ~come ~lost ~made =
  match Judge.judge_step sets same_triangle endless lone (beside mesh) gone come lost made with
  | Three (a, b, c) -> refuse "triangle %d %d %d has three solid edges" a b c
  | Round (a, b, c) -> refuse "the solid edges through triangle %d %d %d form a cycle" a b c
  | Changes (strips, isolated) -> (integer strips, integer isolated)

(* The initial mesh is a step from the empty mesh. *)
let begin_with mesh =
  let come = ref [] and made = ref [] in
  iter_triangles mesh (fun t -> come := canonical t :: !come);
  Edges.iter (fun key _ -> made := dual_edge mesh key :: !made) mesh.solid;
  let strips_found, isolated = judged mesh (fun _ -> false) ~gone:[] ~come:!come ~lost:[] ~made:!made in
  if strips_found <> strips mesh then refuse "there are %d strips, but %d were counted" strips_found (strips mesh);
  mesh.isolated <- isolated

let expect_stated what stated found = if stated <> found then refuse "%s: stated %+d, found %+d" what stated found

let apply mesh operation =
  let expect_there ((a, b, c) as t) =
    if not (has_triangle mesh t) then refuse "triangle %d %d %d is removed, but does not exist" a b c
  in
  List.iter expect_there operation.gone;
  let gone = List.rev_map canonical operation.gone and come = List.rev_map canonical operation.come in
  let isolated = isolated_before mesh gone operation.solid in
  let lost = solid_edges mesh gone operation.dashed in
  List.iter (make_dashed mesh) operation.dashed;
  List.iter (remove_triangle mesh) operation.gone;
  List.iter (add_triangle mesh) operation.come;
  List.iter (make_solid mesh) operation.solid;
  List.iter
    (fun t -> List.iter (fun (u, v) -> if is_solid mesh u v then expect_both_sides mesh u v) (sides t))
    operation.gone;
  let made = solid_edges mesh come operation.solid in
  let strips, isolated = judged mesh (fun t -> Triangles.mem t isolated) ~gone ~come ~lost ~made in
  mesh.isolated <- mesh.isolated + isolated;
  expect_stated "strips" operation.strips strips;
  expect_stated "isolated triangles" operation.isolated isolated
