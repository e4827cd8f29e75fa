// The tests of the verifier notice every deliberate fault of mutants.txt.
#include "../support/mutant_tests.hpp"

int main(int argc, char** argv) {
  restrip::testing_support::MutantTests tests;
  // The quick ones first.
  tests.stages = {
      "Description.*:Families.*:Forged*:Orbits.*:OperationJudge.*Corpus:OperationJudge.Good*:OperationJudge.Symm*:"
      "Unlisted.*",
      "IndexCost.*",
      "Corpus.*Hold:TableDump.*:OperationJudge.*",
      "*AutomatonRejects.NothingInAGoodCertificate/0:OperationHeader.*",
      "Corpus.Damaged*",
  };
  // Each automaton test takes a second or more, so faults that they notice name them.
  tests.left_out = "*AutomatonRejects*:AutomatonFans.*";
  tests.seconds = 120;
  return restrip::testing_support::MutantRun(tests).run(argc, argv);
}
