package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class LayerRampTest {
  private static final double[] WIDTHS = {LayerRamp.MIN_WIDTH, 0.1, 0.5, 0.99, 1, 1.01, 3, 10, 64};

  @Test
  void theMiddleLeavesTheFractionOfTheVoxelSolid() {
    for (double width : WIDTHS) {
      for (int n = 0; n <= 255; n++) {
        double middle = LayerRamp.middle(n / 255.0, width);
        assertEquals(n / 255.0, LayerRamp.solid(0, 1, middle, width), 1e-9, width + " " + n);
      }
    }
  }

  @Test
  void aStepFillsTheVoxelFromItsSolidSide() {
    double middle = LayerRamp.middle(0.4, LayerRamp.MIN_WIDTH);
    assertEquals(0.2, LayerRamp.solid(0, 0.2, middle, LayerRamp.MIN_WIDTH), 1e-9);
    assertEquals(0, LayerRamp.solid(0.6, 0.8, middle, LayerRamp.MIN_WIDTH), 1e-9);
  }

  @Test
  void theWidestRampFillsTheVoxelEvenly() {
    double middle = LayerRamp.middle(0.4, LayerRamp.MAX_WIDTH);
    assertEquals(0.08, LayerRamp.solid(0.2, 0.4, middle, LayerRamp.MAX_WIDTH), 2e-3);
    assertEquals(0.08, LayerRamp.solid(0.8, 1, middle, LayerRamp.MAX_WIDTH), 2e-3);
  }

  @Test
  void aRampOfAPlaneLeavesInEachLayerWhatThePlaneLeaves() {
    // The plane z = 0.3 + 0.8 (x - 1/2) over a pixel; layers are summed over many x.
    for (double from = 0; from < 1; from += 0.1) {
      double solid = 0;
      for (int n = 0; n < 10_000; n++) {
        double surface = 0.3 + 0.8 * ((n + 0.5) / 10_000 - 0.5);
        solid += Math.max(0, Math.min(0.1, surface - from)) / 10_000;
      }
      assertEquals(solid, LayerRamp.solid(from, from + 0.1, 0.3, 0.8), 1e-6, "from " + from);
    }
  }

  @Test
  void moreSolidNeverLiesLower() {
    for (double width : WIDTHS) {
      for (int n = 0; n < 255; n++) {
        assertTrue(
            LayerRamp.middle(n / 255.0, width) <= LayerRamp.middle((n + 1) / 255.0, width) + 1e-12);
      }
    }
  }
}
