package org.palpate.imagej.annotation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ByteProcessor;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.PixelSnapshot;
import org.palpate.imagej.stack.SegmentColour;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackSegments;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

class BrushStrokeTest {
  private static final SegmentRange BRIGHT =
      SegmentRange.threshold("bright", 100, 255, SegmentColour.BONE);

  private final ImagePlus image = stack();

  @Test
  void undoesAndRedoesEveryVoxel() throws TouchRefusedException {
    StackVolume volume = StackVolume.shownIn(image);
    Vec3 spacing = new Vec3(1, 1, 2);
    BrushStroke stroke =
        BrushStroke.ofBall(volume, new Vec3(4.5, 4.5, 2.5), spacing, 1.5, 100, BRIGHT);
    assertEquals(9, stroke.size()); // a disc of nine voxels; the next slices are 2 mm away
    assertEquals(0, brightVoxels(volume));
    stroke.redo((i, j, k, value) -> assertEquals(100, value));
    assertEquals(9, brightVoxels(volume));
    stroke.undo((i, j, k, value) -> assertEquals(0, value));
    assertEquals(0, brightVoxels(volume));
  }

  private static long brightVoxels(StackVolume volume) throws TouchRefusedException {
    PixelSnapshot pixels = new PixelSnapshot(volume);
    return StackSegments.of(volume, pixels::slice, List.of(BRIGHT), k -> {})
        .get(0)
        .bits()
        .solidCount();
  }

  private static ImagePlus stack() {
    ImageStack slices = new ImageStack(10, 8);
    for (int k = 0; k < 6; k++) {
      slices.addSlice(new ByteProcessor(10, 8));
    }
    return new ImagePlus("stack", slices);
  }
}
