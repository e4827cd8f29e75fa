// The tests of the runtime notice every deliberate fault of mutants.txt. This program is compiled against a copy of the
// headers that has the faults.
#include "../support/mutant_tests.hpp"

int main(int argc, char** argv) {
  restrip::testing_support::MutantTests tests;
  // First tests that take a few milliseconds and need little of the library; then searches, because a fault below a
  // search may let it run for ever; last tests that take a tenth of a second or more.
  tests.stages = {
      "Operations.AnyValence:Join.*:Absorb.That*:"
      "Refine.Inverses*:Refine.Refuses*:Operations.Going*:Operations.Invalid*:"
      "Operations.SmallMeshes*:StripMesh.*:Checks.Bound*:Apply.Takes*:Apply.Refuses*:Apply.In*:KeptApply.KeepsPairs*:"
      "Checked.*:Checks.Handles*:Checks.AgreeOnEveryListOver*:Checks.AgreeOnRandom*:StripBuffer.AnUpdate*:Strips.*:"
      "ChunkLists.*:StripTrees.*:MarkedWords.*:*StripLocatorOf.AgreesAfterRewrites*",
      "*StripLocatorOf.AgreesW*:Checks.AgreeBetween*:Absorb.Leaves*:Operations."
      "LargeFans*:"
      "Baked.OutOfOrder*:Baked.RoundTrips*",
      "StripBuffer.WritesLittle*:StripBuffer.Nothing*:StripifyF*:Tunnel.Each*:Tunnel.Looks*:Keeper.Changes*:"
      "InvalidColorings.*:Moves.*:Descent.*:EndMoves.*:EndSearch.*:Keeper.IsRight*:"
      "Window.IsTheLeast*",
  };
  return restrip::testing_support::MutantRun(tests).run(argc, argv);
}
