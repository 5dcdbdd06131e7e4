package org.palpate.imagej.annotation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ByteProcessor;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.SegmentColour;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

class StrokeHistoryTest {
  private static final int WIDTH = 10;
  private static final int HEIGHT = 8;
  private static final int SLICES = 6;
  private static final SegmentRange BRIGHT =
      SegmentRange.threshold("bright", 100, 255, SegmentColour.BONE);

  private StackVolume volume;
  private final float[] before = new float[WIDTH * HEIGHT * SLICES];
  private StrokeHistory strokes;

  @BeforeEach
  void open() throws TouchRefusedException {
    ImageStack slices = new ImageStack(WIDTH, HEIGHT);
    for (int k = 0; k < SLICES; k++) {
      slices.addSlice(new ByteProcessor(WIDTH, HEIGHT));
    }
    volume = StackVolume.shownIn(new ImagePlus("stack", slices));
    strokes = new StrokeHistory(volume, new Vec3(1, 1, 1));
  }

  private int paint(double x) throws TouchRefusedException {
    return strokes.paint(new Vec3(x, 4.5, 3.5), 1.2, BRIGHT, true);
  }

  /** Reports what has changed since the last call, as a session does. */
  private void look() {
    for (int n = 0; n < before.length; n++) {
      int i = n % WIDTH;
      int j = n / WIDTH % HEIGHT;
      int k = n / (WIDTH * HEIGHT);
      float value = volume.slice(k).getf(i, j);
      if (value != before[n]) {
        before[n] = value;
        strokes.seen(i, j, k, value);
      }
    }
  }

  @Test
  void aStrokeIsLastUntilSomethingElseChangesTheStack() throws TouchRefusedException {
    assertFalse(strokes.isStrokeLast());
    assertEquals(7, paint(4.5));
    look();
    assertTrue(strokes.isStrokeLast());
    volume.slice(0).set(1, 1, 9);
    look();
    assertFalse(strokes.isStrokeLast());
    paint(4.5);
    look();
    assertTrue(strokes.isStrokeLast(), "a later stroke");
    strokes.undo();
    look();
    assertFalse(strokes.isStrokeLast(), "the other change is the last one again");
  }

  @Test
  void aChangeInsideAStrokeIsNotItsOwn() throws TouchRefusedException {
    paint(4.5);
    volume.slice(3).set(4, 4, 101); // before anybody has looked
    look();
    assertFalse(strokes.isStrokeLast());
  }

  @Test
  void strokesThatAreUndoneAndRedoneStayLast() throws TouchRefusedException {
    paint(3.5);
    paint(5.5);
    look();
    strokes.undo();
    look();
    assertTrue(strokes.isStrokeLast(), "the first one");
    strokes.undo();
    look();
    assertFalse(strokes.isStrokeLast(), "none is left");
    strokes.redo();
    look();
    assertTrue(strokes.isStrokeLast());
  }

  @Test
  void anUndoOfAStrokeBelowAnotherChangeLeavesNoneBelowItLast() throws TouchRefusedException {
    paint(3.5);
    paint(5.5);
    look();
    volume.slice(0).set(1, 1, 9);
    look();
    strokes.undo();
    look();
    assertFalse(strokes.isStrokeLast(), "the first stroke lies below the change");
  }
}
