package org.palpate.imagej.stack;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ImageProcessor;
import ij.process.ShortProcessor;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReplayDevice;
import org.palpate.device.Trajectory;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SolverKind;
import org.palpate.io.volume.LabelTable;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** The grey values of a stack and their changes reach the smooth solver. */
class StackGreyValuesTest {
  private static final int EDGE = 32;
  private static final int TOP = 16;
  private static final SegmentRange BONE =
      SegmentRange.threshold("bone", 1000, 65535, SegmentColour.BONE);

  private final ImagePlus image = plane();
  private final Vec3 point = new Vec3();

  @Test
  void aThresholdGivesTheIsosurfaceOfTheCommandLine() throws TouchRefusedException {
    GreyIsosurface found = surface(BONE).orElseThrow();
    VoxelGrid grid = StackGeometry.of(image).grid();
    ScalarVolume read = ScalarVolume.of(grid, ScalarVolume.Storage.UINT16);
    for (int k = 0; k < EDGE; k++) {
      ImageProcessor slice = image.getStack().getProcessor(k + 1);
      for (int n = 0; n < EDGE * EDGE; n++) {
        read.set(n % EDGE, n / EDGE, k, slice.get(n));
      }
    }
    GreyIsosurface expected = GreyIsosurface.ofThreshold(read, 1000);
    assertEquals(expected.threshold(), found.threshold());
    assertEquals(expected.contrast(), found.contrast());
    assertEquals(600, found.volume().value(3, 4, TOP));
  }

  @Test
  void bandsMasksAndLabelsHaveNoIsosurface() throws TouchRefusedException {
    assertEquals(
        Optional.empty(), surface(SegmentRange.threshold("band", 500, 1500, SegmentColour.BONE)));
    assertEquals(
        Optional.empty(), surface(SegmentRange.threshold("all", 0, 65535, SegmentColour.BONE)));
    assertEquals(Optional.empty(), surface(BONE, SegmentRange.label(7, image, LabelTable.EMPTY)));
    fill(TOP, 0);
    assertEquals(Optional.empty(), surface(BONE), "a mask has two values");
  }

  @Test
  void paintingBelowTheThresholdMovesTheTouchedSurface() throws TouchRefusedException {
    Rise riseAfter =
        riseAfter(
            false,
            synchronizer -> {
              ImageProcessor slice = image.getStack().getProcessor(TOP + 1);
              slice.setRoi(8, 8, 16, 16);
              slice.setValue(950); // still empty, but nearly solid
              slice.fill();
              synchronizer.markUpdated();
            });
    assertEquals(0, riseAfter.voxels());
    assertEquals(950, riseAfter.surface().volume().value(16, 15, TOP));
    assertTrue(riseAfter.after() > riseAfter.before() + 0.1, riseAfter::toString);
  }

  @Test
  void theSurfaceFollowsTheShownThreshold() throws TouchRefusedException {
    Rise riseAfter =
        riseAfter(
            true,
            synchronizer -> {
              image.getProcessor().setThreshold(500, 65535, ImageProcessor.NO_LUT_UPDATE);
              synchronizer.imageUpdated(image);
            });
    assertEquals(EDGE * EDGE, riseAfter.voxels());
    assertEquals(500, riseAfter.surface().threshold());
    assertTrue(riseAfter.after() > riseAfter.before() + 0.1, riseAfter::toString);
  }

  /** The height of the pressed point before and after a change, and what changed. */
  private record Rise(double before, double after, int voxels, GreyIsosurface surface) {}

  private Rise riseAfter(boolean followsThreshold, Consumer<StackSynchronizer> change)
      throws TouchRefusedException {
    StackVolume volume = StackVolume.shownIn(image);
    PixelSnapshot pixels = new PixelSnapshot(volume);
    ContactScene scene = scene(pixels);
    PointFrame frame = pressed(scene);
    int n = run(frame, 1);
    double before = point.z;
    int voxels;
    try (StackSynchronizer synchronizer = synchronizer(volume, pixels, scene, followsThreshold)) {
      change.accept(synchronizer);
      voxels = synchronizer.applyChanges();
      run(frame, n);
    }
    return new Rise(before, point.z, voxels, scene.grey().orElseThrow());
  }

  private Optional<GreyIsosurface> surface(SegmentRange... ranges) throws TouchRefusedException {
    StackVolume volume = StackVolume.shownIn(image);
    VoxelGrid grid = StackGeometry.of(image).grid();
    return StackGreyValues.surface(new PixelSnapshot(volume), EDGE, grid, List.of(ranges));
  }

  private ContactScene scene(PixelSnapshot pixels) throws TouchRefusedException {
    VoxelGrid grid = StackGeometry.of(image).grid();
    StackVolume volume = StackVolume.shownIn(image);
    return new ContactScene(
        new SegmentedVolume(
            grid, StackSegments.of(volume, pixels::slice, List.of(BONE), slice -> {})),
        ContactSettings.standard(SolverKind.SMOOTH),
        StackGreyValues.surface(pixels, EDGE, grid, List.of(BONE)));
  }

  private static StackSynchronizer synchronizer(
      StackVolume volume, PixelSnapshot pixels, ContactScene scene, boolean followsThreshold) {
    return new StackSynchronizer(
        volume,
        pixels,
        List.of(BONE),
        followsThreshold,
        scene,
        new StackSynchronizer.Listener() {
          @Override
          public void updated() {}

          @Override
          public void seen(int i, int j, int k, float value) {}

          @Override
          public void changed(IntBox voxels, int segment) {}
        });
  }

  /** Returns a frame whose device descends onto the plane and stays two voxels below it. */
  private PointFrame pressed(ContactScene scene) {
    Trajectory down = new Trajectory();
    for (int n = 0; n < 20_000; n++) {
      down.add(n, 16.3, 15.8, Math.max(TOP - 2, TOP + 4 - n * 0.02));
    }
    HapticDevice device = new ReplayDevice("down", down);
    return scene.newFrame(
        GridDevice.fromWorld(device, scene.grid()),
        scene.liveFrame(device.specification(), 0.5),
        (deviceGrid, pointGrid, force, contact, counts) -> point.set(pointGrid));
  }

  /** Runs a thousand frames from a number on; returns the next number. */
  private static int run(PointFrame frame, int from) {
    for (int n = from; n < from + 1000; n++) {
      frame.run(n * 1_000_000L);
    }
    return from + 1000;
  }

  private void fill(int k, int value) {
    ImageProcessor slice = image.getStack().getProcessor(k + 1);
    slice.setValue(value);
    slice.fill();
  }

  /** Returns bone up to a plane, half a voxel of it in the next slice, and nothing above. */
  private static ImagePlus plane() {
    ImageStack slices = new ImageStack(EDGE, EDGE);
    for (int k = 0; k < EDGE; k++) {
      ShortProcessor slice = new ShortProcessor(EDGE, EDGE);
      slice.setValue(k < TOP ? 2000 : k == TOP ? 600 : 0);
      slice.fill();
      slices.addSlice(slice);
    }
    return new ImagePlus("plane", slices);
  }
}
