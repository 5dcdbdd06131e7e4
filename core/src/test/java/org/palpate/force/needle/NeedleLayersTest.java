package org.palpate.force.needle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class NeedleLayersTest {
  private static final int GAP = -1;

  private final NeedleTissue[] tissues = {tissue(0.3), tissue(0.05), tissue(0.7)};
  private final NeedleLayers layers = new NeedleLayers();

  private static NeedleTissue tissue(double shaftNewtonPerMm) {
    return new NeedleTissue(new BitCube(1, 1, 1), 1, 1, shaftNewtonPerMm);
  }

  @Test
  void aShaftRubsInEachLayerOverItsLengthThere() {
    layers.add(0, 2);
    layers.add(GAP, 5);
    layers.add(2, 6);
    assertEquals(3 * 0.3 + 4 * 0.7, layers.frictionNewton(tissues, -10, 10), 1e-12);
    assertEquals(0, layers.frictionNewton(tissues, -10, 2), "it has just reached the first one");
    assertEquals(1 * 0.3, layers.frictionNewton(tissues, -10, 3), 1e-12);
    assertEquals(2 * 0.7, layers.frictionNewton(tissues, 8, 10), 1e-12, "the shaft begins at 8");
    assertEquals(0, layers.frictionNewton(tissues, 5.2, 5.9), "it lies in the gap");
  }

  @Test
  void theFrictionGrowsWithTheLayerAtTheTip() {
    assertEquals(0, layers.newtonPerMm(tissues, 3), "no layer yet");
    layers.add(0, 2);
    layers.add(GAP, 5);
    layers.add(2, 6);
    assertEquals(0.7, layers.newtonPerMm(tissues, 6), "from the depth on at which it begins");
    assertEquals(0.7, layers.newtonPerMm(tissues, 99));
    assertEquals(0, layers.newtonPerMm(tissues, 5.5), "in the gap");
    assertEquals(0.3, layers.newtonPerMm(tissues, 4.9));
    assertEquals(0.3, layers.newtonPerMm(tissues, 1), "before the first one it is that of it");
  }

  /** The growth is the difference of the friction over a small way, wherever the tip is. */
  @Test
  void theGrowthIsTheSlopeOfTheFriction() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    for (int round = 0; round < 50; round++) {
      layers.clear();
      double depth = 0;
      for (int n = 0; n < 12; n++) {
        layers.add(random.nextInt(-1, 3), depth);
        depth += random.nextDouble(0.2, 2);
      }
      for (int n = 0; n < 100; n++) {
        double tip = random.nextDouble(0.01, depth + 3);
        double slope =
            (layers.frictionNewton(tissues, -50, tip + 1e-7)
                    - layers.frictionNewton(tissues, -50, tip - 1e-7))
                / 2e-7;
        double growth = layers.newtonPerMm(tissues, tip);
        assertTrue(Math.abs(slope - growth) < 1e-4 || isAtABorder(tip), slope + " " + growth);
      }
    }
  }

  private boolean isAtABorder(double tip) {
    return layers.newtonPerMm(tissues, tip - 1e-6) != layers.newtonPerMm(tissues, tip + 1e-6);
  }

  @Test
  void aClearedTrackHasNoFrictionAndTooManyLayersEndInTheLast() {
    for (int n = 0; n < NeedleLayers.MOST + 5; n++) {
      layers.add(n < NeedleLayers.MOST - 1 ? 1 : n == NeedleLayers.MOST - 1 ? 0 : 2, n);
    }
    assertEquals(0.3, layers.newtonPerMm(tissues, 1_000));
    assertEquals(0.05, layers.newtonPerMm(tissues, 7.5));
    layers.clear();
    assertEquals(0, layers.newtonPerMm(tissues, 7.5));
    assertEquals(0, layers.frictionNewton(tissues, 0, 100));
    assertEquals("[] from []", layers.toString());
    layers.add(2, 1.5);
    assertEquals("[2] from [1.5]", layers.toString());
  }
}
