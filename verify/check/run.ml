(* Replays a trace: makes each step on the checker's mesh, which Judge.judge_step judges, and asks Judge about the patch, as
   claimed. *)

open Mesh
open Trace
open Step

type account = {
  mutable splits : int;
  mutable collapses : int;
  mutable flips : int;
  mutable others : int;
  judged : (string, int * int) Hashtbl.t; (* by family: how many, and the largest valence *)
}

let judged_of account family = Option.value (Hashtbl.find_opt account.judged family) ~default:(0, 0)

let operations account = account.splits + account.collapses + account.flips + account.others

(* ---- optimality *)

let expect_there found ((a, b, c) as t) =
  if not (found t) then refuse "triangle %d %d %d of the patch is not in the mesh" a b c

let expect_in_patch found what family ((a, b, c) as t) =
  if not (found t) then refuse "triangle %d %d %d %s, but is not of the patch of this %s" a b c what family

let set_of list =
  let set = Hashtbl.create (List.length list) in
  List.iter (fun one -> Hashtbl.replace set one ()) list;
  set

(* Judge's verdict on the patch, after an operation. The mesh before it is reconstructed from the changes. [ask] is a
   function of Judge that still needs the mesh. *)
let judged account mesh operation ~family ~valence ~olds ~news ~ports ask =
  let triangles list = set_of (List.rev_map canonical list) in
  let edges list = set_of (List.rev_map (fun (u, v) -> undirected u v) list) in
  let around list = set_of (List.concat_map (fun t -> List.map (fun (u, v) -> directed u v) (sides t)) list) in
  let among list =
    let set = triangles list in
    fun t -> Hashtbl.mem set (canonical t)
  in
  let is_gone = among operation.gone and is_come = among operation.come in
  let there_before t = is_gone t || (has_triangle mesh (canonical t) && not (is_come t)) in
  let dashed = edges operation.dashed and solid = edges operation.solid in
  let was (u, v) =
    let e = undirected u v in
    Hashtbl.mem dashed e || (is_solid mesh u v && not (Hashtbl.mem solid e))
  in
  let is (u, v) = is_solid mesh u v in
  let around_gone = around operation.gone and around_come = around operation.come in
  let left_before (u, v) =
    let e = directed v u in
    Hashtbl.mem around_gone e || (has_left mesh v u && not (Hashtbl.mem around_come e))
  in
  let left_now (u, v) = has_left mesh v u in
  (* Otherwise a worse rule could be hidden by changes elsewhere. *)
  List.iter (expect_in_patch (among olds) "is removed" family) operation.gone;
  List.iter (expect_in_patch (among news) "is added" family) operation.come;
  List.iter (expect_there there_before) olds;
  List.iter (expect_there (has_triangle mesh)) news;
  let corners = List.map (fun (a, b, c) -> ((a, b), c)) in
  match ask (corners olds) (corners news) ports was is left_before left_now (operation.dashed @ operation.solid) with
  | None -> refuse "the operation is not the %s of %d and %d" family operation.from operation.into
  | Some verdict ->
      let count, largest = judged_of account family in
      Hashtbl.replace account.judged family (count + 1, max valence largest);
      (verdict, List.length news - List.length olds)

let judged_fan account mesh operation kind (larger : Patch.larger) =
  let smaller = Patch.smaller operation.from larger in
  let olds, news = match kind with `Split -> (smaller, larger.triangles) | `Collapse -> (larger.triangles, smaller) in
  let position = Patch.position kind larger in
  judged account mesh operation ~family:(Patch.family position) ~valence:larger.valence ~olds ~news
    ~ports:(Patch.ports larger) (Judge.judge Int.equal position)

(* The stated changes are true; this checks that they are optimal. *)
let expect_good claim operation ((verdict : Judge.Runs.verdict), more_triangles) =
  let strips = more_triangles - (Patch.int verdict.solid_best - Patch.int verdict.solid_before) in
  let isolated = Patch.int verdict.alone_best - Patch.int verdict.alone_before in
  let worse = operation.strips > strips || (operation.strips = strips && operation.isolated > isolated) in
  if worse then
    refuse "changes strips by %+d and isolated triangles by %+d; a sound recolouring of the patch by %+d and %+d"
      operation.strips operation.isolated strips isolated;
  if claim = Best && not verdict.chosen then
    refuse "is not one of the best sound recolourings of the patch and nothing else"

let apply_judged account claim mesh operation =
  match (claim, operation.kind) with
  | Valid, _ | _, Other -> apply mesh operation
  | _, Split ->
      apply mesh operation;
      let larger = Patch.around mesh operation.from operation.into in
      expect_good claim operation (judged_fan account mesh operation `Split larger)
  | _, Collapse ->
      let larger = Patch.around mesh operation.from operation.into in
      apply mesh operation;
      expect_good claim operation (judged_fan account mesh operation `Collapse larger)
  | _, Flip ->
      let olds, news, ports = Patch.flip mesh operation.from operation.into in
      apply mesh operation;
      expect_good claim operation
        (judged account mesh operation ~family:"flip" ~valence:4 ~olds ~news ~ports (Judge.judge_flip Int.equal))

let count account = function
  | Split -> account.splits <- account.splits + 1
  | Collapse -> account.collapses <- account.collapses + 1
  | Flip -> account.flips <- account.flips + 1
  | Other -> account.others <- account.others + 1

type result = { claim : claim; account : account; mesh : Mesh.t; largest : int (* triangles at any moment *) }

(* Raises Refused; the reader has the line number. *)
let check reader =
  let claim = head reader in
  let mesh = empty () in
  let account = { splits = 0; collapses = 0; flips = 0; others = 0; judged = Hashtbl.create 8 } in
  let largest = ref 0 in
  let expect_end n =
    if n <> operations account then refuse "the end states %d operations, but there are %d" n (operations account);
    if next reader <> None then refuse "text after the end"
  in
  let read () =
    match next reader with Some text -> line_of text | None -> refuse "the trace ends without its last line"
  in
  (* Triangles, then solid edges, then operations. *)
  let rec triangles_first () =
    match read () with
    | Triangle t ->
        add_triangle mesh t;
        triangles_first ()
    | line -> edges_next line
  and edges_next = function
    | Solid (u, v) ->
        make_solid mesh (u, v);
        edges_next (read ())
    | line ->
        begin_with mesh;
        largest := mesh.triangles;
        operations_then line
  and operations_then = function
    | Operation operation ->
        apply_judged account claim mesh operation;
        count account operation.kind;
        largest := max !largest mesh.triangles;
        operations_then (read ())
    | End n ->
        expect_end n;
        let isolated = expect_whole mesh in
        if isolated <> mesh.isolated then
          refuse "there are %d isolated triangles, but %d were counted" isolated mesh.isolated
    | Triangle _ | Solid _ -> refuse "the mesh comes before the operations, triangles before edges"
  in
  triangles_first ();
  { claim; account; mesh; largest = !largest }
