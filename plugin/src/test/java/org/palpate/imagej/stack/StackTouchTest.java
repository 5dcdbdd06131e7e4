package org.palpate.imagej.stack;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileSaver;
import ij.io.Opener;
import ij.process.ByteProcessor;
import ij.process.ColorProcessor;
import ij.process.FloatProcessor;
import ij.process.ImageProcessor;
import ij.process.LUT;
import ij.process.ShortProcessor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReplayDevice;
import org.palpate.device.Trajectory;
import org.palpate.edit.EditQueue;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SolverKind;
import org.palpate.io.volume.LabelTable;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

class StackTouchTest {
  private static final SegmentRange BRIGHT =
      SegmentRange.threshold("bright", 100, 255, SegmentColour.BONE);

  @Test
  void aSegmentContainsTheVoxelsBetweenItsThresholds() throws TouchRefusedException {
    ImagePlus image = stack();
    paint(image, 3, 4, 5, 100);
    paint(image, 0, 0, 0, 255);
    paint(image, 9, 7, 5, 99);
    BitCube bits = segments(image).get(0).bits();
    assertEquals(2, bits.solidCount());
    assertTrue(bits.get(3, 4, 5));
    assertTrue(bits.get(0, 0, 0));
    assertFalse(BRIGHT.contains(99));
  }

  @Test
  void labelsAreTheValuesExceptBackground() throws TouchRefusedException {
    ImagePlus image = stack();
    paint(image, 1, 1, 1, 7);
    paint(image, 2, 1, 1, 3);
    assertEquals(Set.of(3, 7), StackSegments.labels(StackVolume.shownIn(image)));
  }

  @Test
  void refusesAnImageWithoutLabels() {
    assertThrows(
        TouchRefusedException.class, () -> StackSegments.labels(StackVolume.shownIn(stack())));
  }

  @Test
  void refusesAColourImageAndASingleSlice() {
    ImagePlus colour = new ImagePlus("c", new ColorProcessor(4, 4));
    ImagePlus single = new ImagePlus("s", new ByteProcessor(4, 4));
    assertTrue(refusal(colour).contains("colour"));
    assertTrue(refusal(single).contains("single image"));
  }

  private static String refusal(ImagePlus image) {
    return assertThrows(TouchRefusedException.class, () -> StackVolume.shownIn(image)).getMessage();
  }

  @Test
  void convertsEveryUnitToMillimetres() throws TouchRefusedException {
    ImagePlus image = stack();
    image.getCalibration().setUnit("micron");
    image.getCalibration().pixelWidth = 500;
    image.getCalibration().pixelHeight = 250;
    image.getCalibration().pixelDepth = 2000;
    image.getCalibration().xOrigin = 2;
    StackGeometry geometry = StackGeometry.of(image);
    assertEquals("(0.5, 0.25, 2.0)", geometry.grid().spacingMm().toString());
    Vec3 at = geometry.gridToCalibrated(new Vec3(3, 2, 1), new Vec3());
    assertEquals("(500.0, 500.0, 2000.0)", at.toString());
  }

  @Test
  void appliesPaintedVoxelsOneByOneAndInBulk() throws TouchRefusedException {
    ImagePlus image = stack();
    StackVolume volume = StackVolume.shownIn(image);
    List<Segment> segments = segments(image);
    ContactScene scene = scene(StackGeometry.of(image), segments);
    EditQueue edits = scene.edits();
    BitCube bits = segments.get(0).bits();
    PointFrame frame = frame(scene);
    List<String> seen = new ArrayList<>();
    try (StackSynchronizer synchronizer = synchronizer(volume, scene, false, seen)) {
      assertEquals(0, synchronizer.applyChanges());
      paint(image, 3, 4, 5, 200);
      image.updateAndDraw();
      synchronizer.imageUpdated(image);
      assertEquals(1, synchronizer.applyChanges());
      frame.run(1_000_000);
      assertTrue(bits.get(3, 4, 5));
      for (int k = 0; k < volume.slices(); k++) {
        ImageProcessor slice = volume.slice(k);
        slice.setValue(255);
        slice.fill();
      }
      synchronizer.markUpdated();
      assertEquals(1, synchronizer.solidCount(0));
      assertEquals(10 * 8 * 6 - 1, synchronizer.applyChanges());
      assertEquals(10 * 8 * 6, synchronizer.solidCount(0));
      assertEquals(0, synchronizer.applyChanges());
      for (int n = 2; !edits.isIdle(); n++) {
        frame.run(n * 1_000_000L);
      }
      assertTrue(frame.statistics().freed() > 0, "the point was inside the new solid");
    }
    assertEquals(List.of("0: x 3-3, y 4-4, z 5-5", "0: x 0-9, y 0-7, z 0-5"), seen);
  }

  @Test
  void followsTheShownThreshold() throws TouchRefusedException {
    ImagePlus image = stack();
    paint(image, 3, 4, 5, 50);
    paint(image, 4, 4, 5, 150);
    List<Segment> segments = segments(image);
    ContactScene scene = scene(StackGeometry.of(image), segments);
    StackVolume volume = StackVolume.shownIn(image);
    try (StackSynchronizer synchronizer = synchronizer(volume, scene, true, new ArrayList<>())) {
      assertEquals(1, synchronizer.mirrors().get(0).solidCount());
      image.getProcessor().setThreshold(40, 255, ImageProcessor.NO_LUT_UPDATE);
      synchronizer.imageUpdated(image);
      assertEquals(1, synchronizer.applyChanges());
      assertEquals(2, synchronizer.mirrors().get(0).solidCount());
    }
  }

  @Test
  void refusesAStackThatLosesASlice() throws TouchRefusedException {
    ImagePlus image = stack();
    List<Segment> segments = segments(image);
    ContactScene scene = scene(StackGeometry.of(image), segments);
    StackVolume volume = StackVolume.shownIn(image);
    try (StackSynchronizer synchronizer = synchronizer(volume, scene, false, new ArrayList<>())) {
      ImageStack slices = image.getStack();
      slices.deleteLastSlice();
      image.setStack(slices);
      synchronizer.imageUpdated(image);
      TouchRefusedException refusal =
          assertThrows(TouchRefusedException.class, () -> synchronizer.applyChanges());
      assertTrue(refusal.getMessage().contains("size or type of the stack changed"));
    }
  }

  @Test
  void labelsHaveTheColoursThatTheImageShows() throws TouchRefusedException {
    ImagePlus image = stack();
    paint(image, 1, 1, 1, 3);
    byte[] ramp = new byte[256];
    ramp[3] = 40;
    byte[] none = new byte[256];
    image.setLut(new LUT(ramp, none, none));
    assertEquals(Set.of(3), StackSegments.labels(StackVolume.shownIn(image)));
    assertEquals(40 << 16, SegmentRange.label(3, image, LabelTable.EMPTY).rgb());
  }

  private static StackSynchronizer synchronizer(
      StackVolume volume, ContactScene scene, boolean followsThreshold, List<String> seen)
      throws TouchRefusedException {
    return new StackSynchronizer(
        volume,
        new PixelSnapshot(volume),
        List.of(BRIGHT),
        followsThreshold,
        scene,
        new StackSynchronizer.Listener() {
          @Override
          public void updated() {}

          @Override
          public void seen(int i, int j, int k, float value) {}

          @Override
          public void changed(IntBox voxels, int segment) {
            seen.add(segment + ": " + voxels);
          }
        });
  }

  private static ContactScene scene(StackGeometry geometry, List<Segment> segments) {
    ContactSettings settings = ContactSettings.standard(SolverKind.GUARDED);
    return new ContactScene(new SegmentedVolume(geometry.grid(), segments), settings);
  }

  /** Returns a frame whose device rests in the middle of the stack. */
  private static PointFrame frame(ContactScene scene) {
    Trajectory rest = new Trajectory();
    for (int n = 0; n < 10_000; n++) {
      rest.add(n, 5.5, 4.5, 3.5);
    }
    HapticDevice device = new ReplayDevice("rest", rest);
    return scene.newFrame(
        GridDevice.fromWorld(device, scene.grid()),
        scene.liveFrame(device.specification(), 0.5),
        FramePublisher.NONE);
  }

  private static List<Segment> segments(ImagePlus image) throws TouchRefusedException {
    StackVolume volume = StackVolume.shownIn(image);
    return StackSegments.of(volume, volume::pixels, List.of(BRIGHT), k -> {});
  }

  private static void paint(ImagePlus image, int i, int j, int k, int value) {
    image.getStack().getProcessor(k + 1).set(i, j, value);
  }

  private static ImagePlus stack() {
    ImageStack slices = new ImageStack(10, 8);
    for (int k = 0; k < 6; k++) {
      slices.addSlice(new ByteProcessor(10, 8));
    }
    return new ImagePlus("stack", slices);
  }

  @Test
  void labelsHaveTheNamesAndColoursOfATableBesideTheFile(@TempDir Path folder) throws Exception {
    ImagePlus image = stack();
    paint(image, 1, 1, 1, 7);
    paint(image, 2, 1, 1, 9);
    new FileSaver(image).saveAsTiffStack(folder.resolve("head.tif").toString());
    Files.writeString(folder.resolve("head.ctbl"), "7 left_jaw 10 20 30 255\n");
    ImagePlus opened = new Opener().openImage(folder.resolve("head.tif").toString());
    LabelTable table = StackVolume.shownIn(opened).labelTable();
    assertEquals(
        new SegmentRange("left jaw", 7, 7, 0x0A141E), SegmentRange.label(7, opened, table));
    assertEquals("label 9", SegmentRange.label(9, opened, table).name());
    assertEquals(LabelTable.EMPTY, StackVolume.shownIn(image).labelTable());
  }

  @Test
  void readsFloatsAndSixteenBitsUnchanged() throws TouchRefusedException {
    ImageStack floats = new ImageStack(4, 4);
    ImageStack shorts = new ImageStack(4, 4);
    for (int k = 0; k < 3; k++) {
      floats.addSlice(new FloatProcessor(4, 4));
      shorts.addSlice(new ShortProcessor(4, 4));
    }
    floats.getProcessor(2).setf(1, 2, 0.75f);
    floats.getProcessor(3).setf(1, 2, -0.75f);
    shorts.getProcessor(3).set(3, 0, 65535);
    assertEquals("1 at z 1", found(new ImagePlus("floats", floats), 0.5, 1));
    assertEquals("1 at z 2", found(new ImagePlus("shorts", shorts), 40_000, 65_535));
  }

  private static String found(ImagePlus image, double lower, double upper)
      throws TouchRefusedException {
    StackVolume volume = StackVolume.shownIn(image);
    SegmentRange range = SegmentRange.threshold("found", lower, upper, SegmentColour.BONE);
    BitCube bits = StackSegments.of(volume, volume::pixels, List.of(range), k -> {}).get(0).bits();
    return bits.solidCount() + " at z " + bits.bounds().lowZ;
  }
}
