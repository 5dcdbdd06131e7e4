package org.palpate.benchmarks.fracture;

import java.io.IOException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.reduction.GuidedHands;
import org.palpate.testing.Scans;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;

/** Guided hands place the fragments of the lower jaw of the scan CThead. */
class JawGuidanceTest {
  /** Faces of 8 parts are smaller, and determine rotations less well. */
  @ParameterizedTest
  @CsvSource({"4, 1.5", "8, 2"})
  void aGuideLeadsAWrongHandToThePlaceInAJawAndLeavesARightOneThere(int parts, double mostDegrees)
      throws IOException {
    WholeBone jaw = WholeBone.jaw(Scans.file("CThead").getParent());
    GuidedHands.check(
        "jaw in " + parts + " parts",
        seed -> FragmentCutter.cut(jaw.bits(), jaw.grid(), new FractureSpec(parts, seed, 0)),
        0.5,
        mostDegrees);
  }
}
