(* restrip-check: checks a trace of a run (docs/how-to/check-a-run.md). *)

let usage =
  {|Checks a trace written by `restrip replay --trace` or a custom program
(restrip/output/trace.hpp). It maintains a separate mesh of triangles and colours and requires,
after each operation, valid colours and true numbers of strips and isolated triangles, decided
by functions extracted from Coq.
docs/reference/file-formats.md has the format, docs/how-to/check-a-run.md what is proved.

usage: restrip-check [--json FILE] TRACE

  --json FILE  Writes the report as JSON; with - to standard output instead of the text
  --help       Prints this help
  --version    Prints the version

Exit status: 0 accepted, 1 refused or unreadable, 2 wrong use or lost output.
Example: restrip replay --built-in --triangles 2000 --policy local --repeats 0 --trace run.trace
         restrip-check run.trace
|}

(* Ends the program; at_exit would hide that the output could not be written. *)
let finish code =
  match flush stdout with
  | () -> exit code
  | exception Sys_error text ->
      prerr_endline ("restrip-check: standard output could not be written: " ^ text);
      exit 2

let wrong_use text =
  prerr_endline ("restrip-check: " ^ text);
  prerr_endline "Run with --help for more information.";
  exit 2

type options = { trace : string option; json : string option }

let rec options found = function
  | [] -> found
  | ("--help" | "-h") :: _ ->
      print_string usage;
      finish 0
  | "--version" :: _ ->
      print_endline Version.number;
      finish 0
  | "--json" :: file :: rest ->
      if file <> "-" && not (Filename.check_suffix file ".json") then wrong_use (file ^ ": the name must end in .json");
      options { found with json = Some file } rest
  | [ "--json" ] -> wrong_use "--json needs a file"
  | word :: _ when String.length word > 1 && word.[0] = '-' -> wrong_use ("unknown option " ^ word)
  | file :: _ when found.trace <> None -> wrong_use ("unexpected " ^ file)
  | file :: rest -> options { found with trace = Some file } rest

let json_string text =
  let quoted = Buffer.create (String.length text + 2) in
  Buffer.add_char quoted '"';
  String.iter
    (function
      | '"' -> Buffer.add_string quoted "\\\""
      | '\\' -> Buffer.add_string quoted "\\\\"
      | c when c < ' ' -> Buffer.add_string quoted (Printf.sprintf "\\u%04x" (Char.code c))
      | c -> Buffer.add_char quoted c)
    text;
  Buffer.add_char quoted '"';
  Buffer.contents quoted

let json members =
  let line (name, value) = Printf.sprintf "  %s: %s" (json_string name) value in
  "{\n" ^ String.concat ",\n" (List.map line members) ^ "\n}\n"

(* Writes the whole file or nothing. *)
let write_file file text =
  let draft = file ^ ".draft" in
  let channel = open_out_bin draft in
  output_string channel text;
  close_out channel;
  Sys.rename draft file

let counted n one = if n = 1 then "1 " ^ one else Printf.sprintf "%d %ss" n one


(* [text] goes to standard output unless the JSON does. *)
let report options ~text ~members =
  match options.json with
  | Some "-" -> print_string (json members)
  | Some file ->
      write_file file (json members);
      print_string text
  | None -> print_string text

(* Optimality, for all operations except `others`. *)
let optimality (result : Run.result) =
  let count = Run.operations result.account - result.account.others in
  let judged = counted count "operation" ^ " judged" in
  match result.claim with
  | Valid -> "optimality was neither claimed nor checked"
  | (No_worse | Best) when count = 0 -> "optimality was claimed, but no operation is of a kind that is judged"
  | No_worse -> judged ^ ": none does worse than the best sound recolouring of its patch"
  | Best -> judged ^ ": each is a best sound recolouring of its patch"

let accepted options trace (result : Run.result) =
  let account = result.account in
  let operations = Run.operations account in
  let judged = List.map (fun name -> (name, Run.judged_of account name)) Patch.families in
  let judged = List.filter (fun (_, (n, _)) -> n > 0) judged in
  let line_of name n k =
    Printf.sprintf "  judged: %s: %d%s\n" name n (if name = "flip" then "" else Printf.sprintf ", k <= %d" k)
  in
  let text =
    String.concat ""
      [
        Printf.sprintf "%s: %s of up to %s\n" trace (counted operations "operation") (counted result.largest "triangle");
        Printf.sprintf "  %s, %s, %s, %d others\n" (counted account.splits "split") (counted account.collapses "collapse")
          (counted account.flips "flip") account.others;
        Printf.sprintf "  at the end %s in %s, %d of them isolated\n" (counted result.mesh.triangles "triangle")
          (counted (Mesh.strips result.mesh) "strip") result.mesh.isolated;
        String.concat "" (List.map (fun (name, (n, k)) -> line_of name n k) judged);
        Printf.sprintf
          "accepted: the trace was read to its end; after each of %s the colouring is valid and the stated changes are \
           true; %s\n"
          (counted operations "operation") (optimality result);
      ]
  in
  let number (name, (n, _)) = Printf.sprintf "%s: %d" (json_string name) n in
  report options ~text
    ~members:
      [
        ("trace", json_string trace);
        ("accepted", "true");
        ("claim", json_string (Trace.word_of_claim result.claim));
        ("operations", string_of_int operations);
        ("splits", string_of_int account.splits);
        ("collapses", string_of_int account.collapses);
        ("flips", string_of_int account.flips);
        ("others", string_of_int account.others);
        ("judged", "{" ^ String.concat ", " (List.map number judged) ^ "}");
        ("triangles", string_of_int result.mesh.triangles);
        ("strips", string_of_int (Mesh.strips result.mesh));
        ("isolated", string_of_int result.mesh.isolated);
      ]

let refused options trace line fault =
  report options ~text:""
    ~members:
      [
        ("trace", json_string trace);
        ("accepted", "false");
        ("line", string_of_int line);
        ("fault", json_string fault);
      ];
  Printf.eprintf "%s: line %d: %s\n" trace line fault;
  finish 1

let () =
  Gc.set { (Gc.get ()) with minor_heap_size = 1 lsl 20; space_overhead = 200 };
  let options = options { trace = None; json = None } (List.tl (Array.to_list Sys.argv)) in
  match options.trace with
  | None -> wrong_use "name a trace"
  | Some trace -> (
      let fail text =
        Printf.eprintf "restrip-check: %s\n" text;
        exit 1
      in
      match open_in_bin trace with
      | exception Sys_error text -> fail text
      | channel -> (
          let reader = Trace.reader channel in
          try
            match Run.check reader with
            | result ->
                accepted options trace result;
                finish 0
            | exception Mesh.Refused fault -> refused options trace reader.line fault
          with Sys_error text -> fail text))
