(* Reads a trace line by line (docs/reference/file-formats.md). Refuses every line that deviates from the format. *)

open Mesh

type claim = Valid | No_worse | Best
type kind = Split | Collapse | Flip | Other

type operation = {
  kind : kind;
  from : int;
  into : int;
  strips : int;
  isolated : int;
  gone : triangle list;
  come : triangle list;
  dashed : (int * int) list;
  solid : (int * int) list;
}

type line = Triangle of triangle | Solid of int * int | Operation of operation | End of int

let word_of_claim = function Valid -> "valid" | No_worse -> "no-worse" | Best -> "best"

let claim_of_word = function
  | "valid" -> Valid
  | "no-worse" -> No_worse
  | "best" -> Best
  | word -> refuse "unknown claim %S" word

(* Words are separated by one space. *)
let words line = String.split_on_char ' ' line

let number word =
  let digits = String.length word in
  let all_digits = String.for_all (fun c -> c >= '0' && c <= '9') word in
  if digits = 0 || digits > 10 || (digits > 1 && word.[0] = '0') || not all_digits then refuse "%S is not a number" word;
  int_of_string word

let vertex word =
  let v = number word in
  if v > largest_vertex then refuse "vertex %d is beyond %d" v largest_vertex;
  v

let change word =
  if word <> "" && word.[0] = '-' then (
    let n = number (String.sub word 1 (String.length word - 1)) in
    if n = 0 then refuse "%S is not a number" word;
    -n)
  else number word

let is_sign = function "-" | "+" | "d" | "s" -> true | _ -> false

(* Words up to the next sign in groups, last first. *)
let rec triangles found = function
  | a :: rest when is_sign a -> (List.rev found, a :: rest)
  | a :: b :: c :: rest -> triangles ((vertex a, vertex b, vertex c) :: found) rest
  | [] -> (List.rev found, [])
  | _ -> refuse "a triangle has three corners"

let rec pairs found = function
  | a :: rest when is_sign a -> (List.rev found, a :: rest)
  | a :: b :: rest -> pairs ((vertex a, vertex b) :: found) rest
  | [] -> (List.rev found, [])
  | _ -> refuse "an edge has two vertices"

let list_of sign read = function
  | word :: rest when word = sign ->
      let found, rest = read [] rest in
      if found = [] then refuse "nothing follows %S" sign;
      (found, rest)
  | rest -> ([], rest)

let operation kind = function
  | from :: into :: strips :: isolated :: rest ->
      let gone, rest = list_of "-" triangles rest in
      let come, rest = list_of "+" triangles rest in
      let dashed, rest = list_of "d" pairs rest in
      let solid, rest = list_of "s" pairs rest in
      (match rest with [] -> () | word :: _ -> refuse "unexpected %S" word);
      Operation
        {
          kind;
          from = vertex from;
          into = vertex into;
          strips = change strips;
          isolated = change isolated;
          gone;
          come;
          dashed;
          solid;
        }
  | _ -> refuse "an operation has two vertices and two changes"

let line_of text =
  match words text with
  | [ "t"; a; b; c ] -> Triangle (vertex a, vertex b, vertex c)
  | [ "s"; u; v ] -> Solid (vertex u, vertex v)
  | "split" :: rest -> operation Split rest
  | "collapse" :: rest -> operation Collapse rest
  | "flip" :: rest -> operation Flip rest
  | "other" :: rest -> operation Other rest
  | [ "end"; n ] -> End (number n)
  | word :: _ -> refuse "%S is not the beginning of a line of a trace" word
  | [] -> refuse "an empty line"

type reader = { channel : in_channel; mutable line : int (* number of the last line read *) }

let reader channel = { channel; line = 0 }

let next reader =
  match input_line reader.channel with
  | text ->
      reader.line <- reader.line + 1;
      Some text
  | exception End_of_file -> None

let head reader =
  (match next reader with
  | Some "restrip-trace 1" -> ()
  | Some text when String.length text >= 13 && String.sub text 0 13 = "restrip-trace" ->
      refuse "%S is of another version; this program reads version 1" text
  | _ -> refuse "the first line of a trace is \"restrip-trace 1\"");
  match Option.map words (next reader) with
  | Some [ "claim"; word ] -> claim_of_word word
  | _ -> refuse "the second line says what is claimed, such as \"claim best\""
