(** * Automata that must be refused

    One number of the header is changed at a time, or an array ends before an index that is asked; there [Header.read] finds the
    0 that stood there. That a header which serves something wrong is refused is proved; here it is
    seen. *)
Require Import Arith Bool List NArith FMapPositive.
Import ListNotations.
Require Import Header Kinds Meetings AutomatonNumbers Automaton.

Definition changed (t : array) (n : N) (f : N -> N) : array := PositiveMap.add (N.succ_pos n) (f (read t n)) t.
Definition other_bit (n x : N) : N := N.lxor x (N.shiftl 1 n).
(** The next class of an arc, the case before a letter, the case of a closed fan, and the chord of a meeting. *)
Definition wrong_automata : list header :=
  match automaton with
  | Header next before closed first second meet meetings width =>
      [Header (changed next 5 (other_bit 0)) before closed first second meet meetings width;
       Header next (changed before 4 (other_bit 2)) closed first second meet meetings width;
       Header next before (changed closed 5 (other_bit 0)) first second meet meetings width;
       Header next before closed first second meet (changed meetings 3 (other_bit 8)) width;
       Header next before closed first second (PositiveMap.remove (N.succ_pos 0) meet) meetings width]
  end.
Theorem zero_was_there : read (meet_index automaton) 0 = 0%N.
Proof. vm_cast_no_check (eq_refl 0%N). Qed.
Theorem wrong_automata_refused : forallb (fun H => negb (header_ok H)) wrong_automata = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
