package org.palpate.imagej.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ByteProcessor;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.palpate.imagej.dialog.PlaceOptions;
import org.palpate.imagej.dialog.StackWorkspace;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

class PlacingSessionTest {
  private static final int SIZE = 40;

  /** Returns a stack with a large block of label 3 and a small one of label 7 beside it. */
  private static ImagePlus labels() {
    ImageStack stack = new ImageStack(SIZE, SIZE);
    for (int k = 0; k < SIZE; k++) {
      ByteProcessor slice = new ByteProcessor(SIZE, SIZE);
      for (int j = 10; j < 30 && k >= 10 && k < 30; j++) {
        for (int i = 5; i < 23; i++) {
          slice.set(i, j, i < 15 ? 3 : i >= 17 ? 7 : 0);
        }
      }
      stack.addSlice(slice);
    }
    ImagePlus image = new ImagePlus("labels", stack);
    image.setDimensions(1, SIZE, 1);
    return image;
  }

  private static PlaceOptions options(int fixed) {
    return new PlaceOptions(
        fixed, 0.2, "simulated", new StackWorkspace(StackWorkspace.Kind.FIT, 1), 0, false);
  }

  @Test
  @Timeout(60)
  void aFragmentIsMovedUntilAnotherHoldsItBackAndTheResultIsALabelStack() throws Exception {
    ImagePlus image = labels();
    StackVolume stack = StackVolume.shownIn(image);
    try (PlacingSession session = new PlacingSession(stack, options(0))) {
      Thread runner = new Thread(() -> run(session));
      runner.start();
      session.awaitForce();
      assertThrows(TouchRefusedException.class, () -> session.move("label 3", "1,0,0,1,0,0,0"));
      assertThrows(TouchRefusedException.class, () -> session.move("label 7", "1,0,0,2,0,0,0"));
      assertThrows(TouchRefusedException.class, () -> session.move("label 7", "here"));
      session.move("label 7", "5,0,0,1,0,0,0");
      awaitPose(session, "5.0,0.0,0.0,1.0,0.0,0.0,0.0");
      session.move("label 7", "-9,0,0,1,0,0,0");
      LockSupport.parkNanos(1_000_000_000L);
      double x = Double.parseDouble(session.pose("label 7").split(",", -1)[0]);
      assertTrue(x > -3 && x < 0, "held back by the other fragment: " + x);
      session.move("label 7", "4,0,0,1,0,0,0");
      awaitPose(session, "4.0,0.0,0.0,1.0,0.0,0.0,0.0");
      session.requestStop();
      runner.join();
      ImagePlus result = session.result();
      assertEquals("placed-labels", result.getTitle());
      for (int k = 0; k < SIZE; k++) {
        for (int v = 0; v < SIZE * SIZE; v++) {
          int i = v % SIZE;
          int before = i < 4 ? 0 : value(image, i - 4, v / SIZE, k);
          int own = value(image, i, v / SIZE, k);
          int expected = own == 3 ? 3 : before == 7 ? 7 : 0;
          assertEquals(expected, value(result, i, v / SIZE, k), i + " " + v / SIZE + " " + k);
        }
      }
    }
  }

  private static int value(ImagePlus image, int i, int j, int k) {
    return (int) image.getStack().getVoxel(i, j, k);
  }

  private static void run(PlacingSession session) {
    try {
      session.run();
    } catch (TouchRefusedException e) {
      throw new IllegalStateException(e);
    }
  }

  private static void awaitPose(PlacingSession session, String pose) throws Exception {
    while (!session.pose("label 7").equals(pose)) {
      LockSupport.parkNanos(10_000_000L);
    }
  }

  @Test
  void refusesAnUnknownLabelAndASingleOne() {
    ImagePlus image = labels();
    String refusal =
        assertThrows(
                TouchRefusedException.class,
                () -> new PlacingSession(StackVolume.shownIn(image), options(5)))
            .getMessage();
    assertEquals("The stack has no label 5.", refusal);
    for (int k = 0; k < SIZE; k++) {
      image.getStack().getProcessor(k + 1).min(7);
    }
    assertThrows(
        TouchRefusedException.class,
        () -> new PlacingSession(StackVolume.shownIn(image), options(0)));
  }
}
