package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;

class SmoothingKernelTest {
  private static final Vec3 CUBES = new Vec3(1, 1, 1);

  @Test
  void tapsOfBitsAreTwoBoxesOfSixAndFiveVoxels() {
    SmoothingKernel kernel = SmoothingKernel.forBits(ThinGrid.WHOLE, CUBES);
    for (int axis = 0; axis < 3; axis++) {
      assertArrayEquals(new int[] {1, 2, 3, 4, 5, 5, 4, 3, 2, 1}, taps(kernel, axis));
      assertEquals(0, kernel.firstTap(axis));
    }
    assertEquals(1 / Math.pow(30, 3), kernel.scale(), 1e-20);
  }

  @Test
  void tapsOfGreyValuesAreTwoBoxesOfFourAndThreeVoxels() {
    SmoothingKernel kernel = SmoothingKernel.forGrey(ThinGrid.WHOLE, CUBES);
    for (int axis = 0; axis < 3; axis++) {
      assertArrayEquals(new int[] {0, 0, 1, 2, 3, 3, 2, 1, 0, 0}, taps(kernel, axis));
      assertEquals(2, kernel.firstTap(axis));
    }
    assertEquals(1 / Math.pow(12, 3), kernel.scale(), 1e-20);
  }

  /**
   * On either side of the ratio at which two pairs of boxes are equally far from the wanted width.
   */
  @ParameterizedTest
  @CsvSource({
    "1.09, 6, 5",
    "1.10, 5, 4",
    "1.355, 5, 4",
    "1.365, 4, 3",
    "1.78, 4, 3",
    "1.79, 3, 2",
    "2.54, 3, 2",
    "2.55, 2, 1",
    "9, 2, 1"
  })
  void longerVoxelsGetNarrowerBoxes(double ratio, int wide, int narrow) {
    SmoothingKernel kernel = SmoothingKernel.forBits(ThinGrid.WHOLE, new Vec3(1, ratio, 1));
    assertEquals(wide, kernel.wideBox(1));
    assertEquals(narrow, kernel.narrowBox(1));
    assertEquals(6, kernel.wideBox(0));
    assertEquals(5, kernel.narrowBox(2));
    assertEquals(wide * narrow, IntStream.of(taps(kernel, 1)).sum());
    assertEquals(1.0 / (30 * wide * narrow * 30), kernel.scale(), 1e-18);
  }

  /** A box of n voxels has the variance (n^2 - 1) / 12 of its taps, and a spline 3 / 12. */
  @ParameterizedTest
  @CsvSource({"1, 0", "1.3, 1", "2.5, 2"})
  void theDeviationIsThatOfTheTapsAndTheSpline(double ratio, int axis) {
    Vec3 edges = new Vec3(1, 1, 1);
    edges.set(axis, ratio);
    SmoothingKernel kernel = SmoothingKernel.forBits(ThinGrid.WHOLE, edges);
    double weight = 0;
    double moment = 0;
    for (int t = 0; t < SmoothingKernel.TAPS; t++) {
      weight += kernel.tap(axis, t);
      moment += kernel.tap(axis, t) * (t - 4.5) * (t - 4.5);
    }
    double variance = moment / weight + 3.0 / 12;
    assertEquals(ratio * Math.sqrt(variance), kernel.sigmaEdges(axis), 1e-12);
  }

  private static int[] taps(SmoothingKernel kernel, int axis) {
    return IntStream.range(0, SmoothingKernel.TAPS).map(t -> kernel.tap(axis, t)).toArray();
  }
}
