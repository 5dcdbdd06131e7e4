package org.palpate.imagej.annotation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import ij.ImagePlus;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.SegmentColour;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.Stacks;
import org.palpate.imagej.stack.TouchRefusedException;

class PaintedStrokesTest {
  private static final long SEED = Long.getLong("palpate.seed", 20261128);
  private static final int SIZE = 9;
  private static final Vec3 SPACING = new Vec3(0.5, 1, 2);
  private static final Vec3 MIDDLE = new Vec3(4.5, 4.5, 4.5);
  private static final SegmentRange BRIGHT =
      SegmentRange.threshold("bright", 100, 255, SegmentColour.BONE);

  private final ImagePlus image =
      Stacks.of(8, SIZE, SIZE, SIZE, (i, j, k) -> 90 + (i + j + k) % 20);
  private final StackVolume volume = volume(image);
  private final StrokeHistory history = new StrokeHistory(volume, SPACING);

  private static StackVolume volume(ImagePlus image) {
    try {
      return StackVolume.shownIn(image);
    } catch (TouchRefusedException e) {
      throw new IllegalStateException(e);
    }
  }

  private float[] values() {
    float[] values = new float[SIZE * SIZE * SIZE];
    for (int n = 0; n < values.length; n++) {
      values[n] = volume.slice(n / SIZE / SIZE).getf(n % SIZE, n / SIZE % SIZE);
    }
    return values;
  }

  private static void assertSame(float[] expected, float[] found, String what) {
    for (int n = 0; n < expected.length; n++) {
      assertEquals(expected[n], found[n], what + " n=" + n + " seed=" + SEED);
    }
  }

  @Test
  void aBallChangesTheVoxelsWhoseCentresItHoldsAndWhoseMembershipChanges()
      throws TouchRefusedException {
    SplittableRandom random = new SplittableRandom(SEED);
    for (int round = 0; round < 60; round++) {
      float[] before = values();
      Vec3 centre =
          new Vec3(random.nextDouble(-1, 10), random.nextDouble(-1, 10), random.nextDouble(-1, 10));
      double radius = random.nextDouble(0.2, 4);
      boolean add = random.nextBoolean();
      int changed = history.paint(centre, radius, BRIGHT, add);
      float[] expected = before.clone();
      int count = 0;
      for (int n = 0; n < expected.length; n++) {
        int k = n / (SIZE * SIZE);
        double x = (n % SIZE + 0.5 - centre.x) * SPACING.x;
        double y = (n / SIZE % SIZE + 0.5 - centre.y) * SPACING.y;
        double z = (k + 0.5 - centre.z) * SPACING.z;
        if (x * x + y * y + z * z <= radius * radius && BRIGHT.contains(before[n]) != add) {
          expected[n] = add ? 100 : 0;
          count++;
        }
      }
      assertSame(expected, values(), "round " + round);
      assertEquals(count, changed, "round " + round + " seed=" + SEED);
    }
  }

  @Test
  void strokesAreUndoneInReverseAndRedoneInOrder() throws TouchRefusedException {
    float[] start = values();
    int first = history.paint(MIDDLE, 2, BRIGHT, true);
    float[] afterFirst = values();
    int second = history.paint(MIDDLE, 3, BRIGHT, false);
    float[] afterSecond = values();
    assertEquals(second, history.undo());
    assertSame(afterFirst, values(), "undone once");
    assertEquals(first, history.undo());
    assertSame(start, values(), "undone twice");
    assertEquals("There is nothing to undo.", refusal(history::undo));
    assertEquals(first, history.redo());
    assertEquals(second, history.redo());
    assertSame(afterSecond, values(), "redone");
    assertEquals("There is nothing to redo.", refusal(history::redo));
  }

  @Test
  void aNewStrokeForgetsTheUndoneOnes() throws TouchRefusedException {
    history.paint(MIDDLE, 2, BRIGHT, true);
    history.undo();
    history.paint(MIDDLE, 1, BRIGHT, false);
    assertEquals("There is nothing to redo.", refusal(history::redo));
  }

  @Test
  void theOldestOfMoreThanAHundredStrokesStays() throws TouchRefusedException {
    for (int n = 0; n < 101; n++) {
      history.paint(MIDDLE, 2, BRIGHT, n % 2 == 0);
    }
    for (int n = 0; n < 100; n++) {
      history.undo();
    }
    assertEquals("There is nothing to undo.", refusal(history::undo));
  }

  @Test
  void voxelsAreRemovedWithAValueOutsideTheSegment() throws TouchRefusedException {
    history.paint(MIDDLE, 0.6, new SegmentRange("low", 0, 200, 0), false);
    assertEquals(201, volume.slice(4).getf(4, 4), "0 belongs to the segment");
    assertEquals(
        "The segment contains every value from 0 to 255: no value is left to remove voxels with.",
        refusal(() -> history.paint(MIDDLE, 1, new SegmentRange("all", 0, 255, 0), false)));
    assertEquals(0, history.paint(MIDDLE, 1, new SegmentRange("all", 0, 255, 0), true));
  }

  private static String refusal(org.junit.jupiter.api.function.Executable call) {
    return assertThrows(TouchRefusedException.class, call).getMessage();
  }

  @Test
  void theRadiusIsRemembered() {
    double before = StrokeHistory.lastRadiusMm();
    StrokeHistory.keepRadiusMm(3.25);
    assertEquals(3.25, StrokeHistory.lastRadiusMm());
    StrokeHistory.keepRadiusMm(before);
  }
}
