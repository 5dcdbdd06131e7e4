package org.palpate.benchmarks.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.phantom.FracturePhantom;

/**
 * A hand with tremor that knows the truth puts the fragments of a bone back, touch by touch. In six
 * parts, bones would catch the point tool if the hand did not choose how it leaves a fragment.
 */
class ReductionTest {
  @ParameterizedTest
  @CsvSource({"96, 3:1:1", "96, 6:2:1", "160, 4:11:1"})
  void everyFragmentIsTakenLedHomeAndPutDownThere(int edge, String spec) {
    FractureSpec fracture = FractureSpec.parse(spec);
    WholeBone bone = new WholeBone("arch", new FracturePhantom(edge, fracture).bone());
    Reduction reduction =
        Reduction.of(BrokenBone.of(bone, fracture), Contact.KERF, fracture.seed());
    assertEquals(fracture.parts() - 1, reduction.parts().size());
    for (PutBack part : reduction.parts()) {
      assertEquals(PutBack.Outcome.IN_PLACE, part.outcome(), reduction.toString());
      assertTrue(part.wasTaken() && part.hasWay(), part.toString());
    }
  }
}
