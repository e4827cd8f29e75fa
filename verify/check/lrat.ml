(* restrip-lrat: checks a proof that a formula has no model. What it decides is [Refuter.refutes], extracted from Coq; here is
   the reader. A file that is not exactly of its format is refused. *)

open Refuter
open Refuter.Formulas

let usage =
  {|Checks that a formula has no model: FORMULA is a DIMACS file, PROOF a proof of it in LRAT, the
text form, without RAT. `restrip-sat --out FOLDER` writes both. docs/trust.md says what is proved
of this program.

usage: restrip-lrat FORMULA PROOF

Exit status: 0 the formula has no model, 1 the proof does not show it or a file is refused, 2 wrong use.
Example: restrip-sat --tables-dir tables --family flip --out proofs
         restrip-lrat proofs/flip.cnf proofs/flip.lrat
|}

exception Refused of string

let refuse format = Printf.ksprintf (fun text -> raise (Refused text)) format

type reader = { channel : in_channel; file : string; mutable line : int }

let rec positive n = if n = 1 then XH else if n land 1 = 1 then XI (positive (n lsr 1)) else XO (positive (n lsr 1))

(* A number that is not 0, as [n] or [-n]. *)
let number word =
  let digits = if word <> "" && word.[0] = '-' then String.sub word 1 (String.length word - 1) else word in
  let length = String.length digits in
  if length = 0 || length > 10 || digits.[0] = '0' || not (String.for_all (fun c -> c >= '0' && c <= '9') digits) then
    refuse "%S is not a number other than 0" word;
  int_of_string word

let literal variables word =
  let n = number word in
  if abs n > variables then refuse "there is no variable %d; the formula has %d" (abs n) variables;
  if n > 0 then Zpos (positive n) else Zneg (positive (-n))

let clause_number word =
  let n = number word in
  if n < 0 then refuse "%d: RAT is not accepted" n;
  positive n

(* The words before the next 0, each read by [read], and those behind it. *)
let rec up_to_zero read found = function
  | "0" :: rest -> (List.rev found, rest)
  | word :: rest -> up_to_zero read (read word :: found) rest
  | [] -> refuse "the closing 0 is missing"

let only_up_to_zero read words =
  match up_to_zero read [] words with found, [] -> found | _, _ -> refuse "the line goes on behind its closing 0"

(* Lines as their words, which one space separates; the last one must end like the others. *)
let rec lines reader found =
  match input_line reader.channel with
  | exception End_of_file ->
      let length = in_channel_length reader.channel in
      if length > 0 then (
        seek_in reader.channel (length - 1);
        if input_char reader.channel <> '\n' then refuse "the file ends in the middle of a line");
      List.rev found
  | line ->
      reader.line <- reader.line + 1;
      lines reader ((reader.line, String.split_on_char ' ' line) :: found)

let each reader read = List.map (fun (line, words) -> reader.line <- line; read words)

let formula reader =
  match List.filter (fun (_, words) -> List.hd words <> "c") (lines reader []) with
  | (line, [ "p"; "cnf"; variables; announced ]) :: clauses ->
      reader.line <- line;
      let size word = if word = "0" then 0 else number word in
      let variables = size variables and announced = size announced in
      if List.length clauses <> announced then refuse "%d clauses announced, %d found" announced (List.length clauses);
      (variables, each reader (only_up_to_zero (literal variables)) clauses)
  | _ -> refuse "\"p cnf VARIABLES CLAUSES\" is missing"

let proof variables reader =
  let step = function
    | _ :: "d" :: numbers -> Forget (only_up_to_zero clause_number numbers)
    | number :: words ->
        let clause, hints = up_to_zero (literal variables) [] words in
        Learn (clause_number number, clause, only_up_to_zero clause_number hints)
    | [] -> refuse "a blank line"
  in
  each reader step (lines reader [])

let read file parse =
  match open_in_bin file with
  | exception Sys_error text -> Printf.eprintf "restrip-lrat: %s\n" text; exit 1
  | channel -> (
      let reader = { channel; file; line = 0 } in
      try parse reader with
      | Refused fault -> Printf.eprintf "%s: line %d: %s\n" file reader.line fault; exit 1
      | Sys_error text -> Printf.eprintf "restrip-lrat: %s: %s\n" file text; exit 1)

let () =
  match List.tl (Array.to_list Sys.argv) with
  | [ ("--help" | "-h") ] -> print_string usage
  | [ formula_file; proof_file ] ->
      let variables, clauses = read formula_file formula in
      if refutes clauses (read proof_file (proof variables)) then print_string "s VERIFIED UNSAT\n"
      else (
        print_string "s NOT VERIFIED\n";
        exit 1)
  | _ ->
      prerr_endline "restrip-lrat: a formula and a proof are wanted\nRun with --help for more information.";
      exit 2
