package org.palpate.imagej.stack;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.VirtualStack;
import ij.measure.Calibration;
import ij.process.ByteProcessor;
import ij.process.ImageProcessor;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;

class StackVolumeTest {
  private static String refusal(ImagePlus image) {
    return assertThrows(TouchRefusedException.class, () -> StackVolume.shownIn(image)).getMessage();
  }

  @Test
  void theShownChannelAndTimeAreTouched() throws TouchRefusedException {
    ImagePlus image = Stacks.of(8, 2, 2, 12, (i, j, k) -> k);
    image.setDimensions(2, 3, 2);
    image.setPosition(2, 1, 2);
    StackVolume volume = StackVolume.shownIn(image);
    assertEquals(2, volume.channel());
    assertEquals(2, volume.frame());
    assertEquals(3, volume.slices());
    assertTrue(volume.hasMoreChannelsOrTimes());
    for (int k = 0; k < 3; k++) {
      int at = 6 + 2 * k + 1; // channels first, then slices, then times
      assertEquals(at, volume.slice(k).get(0, 0));
      assertEquals(at, StackVolume.value(volume.pixels(k), 0));
    }
    assertFalse(
        StackVolume.shownIn(Stacks.of(8, 2, 2, 3, (i, j, k) -> 0)).hasMoreChannelsOrTimes());
  }

  @Test
  void timesThatAreNoSlicesAreRefusedWithARemedy() {
    ImagePlus image = Stacks.of(8, 2, 2, 6, (i, j, k) -> 0);
    image.setDimensions(2, 1, 3);
    assertEquals(
        "This stack has 2 channels and 3 times but one slice: if its images are slices, change this"
            + " in Image > Properties...",
        refusal(image));
  }

  @Test
  void aVirtualStackIsRefused() {
    VirtualStack slices =
        new VirtualStack(2, 2, null, null) {
          @Override
          public int getSize() {
            return 3;
          }

          @Override
          public ImageProcessor getProcessor(int n) {
            return new ByteProcessor(2, 2);
          }
        };
    ImagePlus image = new ImagePlus("virtual", slices);
    image.setDimensions(1, 3, 1);
    assertEquals(
        "This is a virtual stack, whose slices are read from disk each time: copy it with Image >"
            + " Duplicate... first.",
        refusal(image));
  }

  @ParameterizedTest
  @CsvSource({"8, 200, 200", "16, 65535, 65535", "32, -0.75, -0.75"})
  void eachPixelTypeHasItsOwnValues(int bits, float written, float read)
      throws TouchRefusedException {
    ImagePlus image = Stacks.of(bits, 3, 2, 2, (i, j, k) -> i == 2 && j == 1 ? written : 0);
    Object pixels = StackVolume.shownIn(image).pixels(0);
    assertEquals(6, StackVolume.pixelCount(pixels));
    assertEquals(read, StackVolume.value(pixels, 5));
    assertEquals(0, StackVolume.value(pixels, 4));
  }

  @Test
  void labelsAreWholeNumbersFromZeroAndNotTooMany() throws TouchRefusedException {
    assertEquals(Set.of(1, 300), labels(Stacks.of(16, 4, 1, 2, (i, j, k) -> i == 3 ? 300 : k)));
    assertEquals(
        256, labels(Stacks.of(16, 16, 17, 2, (i, j, k) -> Math.min(256, 16 * j + i))).size());
    refusesLabels(
        Stacks.of(16, 16, 17, 2, (i, j, k) -> Math.min(257, 16 * j + i)),
        "There are more than 256 values: these are grey values, not labels. Use a threshold"
            + " instead.");
    refusesLabels(
        Stacks.of(32, 2, 2, 2, (i, j, k) -> 1.5 * i),
        "The value 1.5 is not a label: labels are whole numbers from 0. Use a threshold instead.");
    refusesLabels(
        Stacks.of(32, 2, 2, 2, (i, j, k) -> -i),
        "The value -1.0 is not a label: labels are whole numbers from 0. Use a threshold instead.");
    refusesLabels(
        Stacks.of(8, 2, 2, 2, (i, j, k) -> 0),
        "Every voxel is 0, the background: there is nothing to touch.");
  }

  private static Set<Integer> labels(ImagePlus image) throws TouchRefusedException {
    return StackSegments.labels(StackVolume.shownIn(image));
  }

  private static void refusesLabels(ImagePlus image, String line) {
    assertEquals(line, assertThrows(TouchRefusedException.class, () -> labels(image)).getMessage());
  }

  @Test
  void eachRangeIsASegmentAndTheyMayOverlap() throws TouchRefusedException {
    ImagePlus image = Stacks.of(8, 7, 5, 3, (i, j, k) -> 7 * j + i + 40 * k);
    StackVolume volume = StackVolume.shownIn(image);
    List<SegmentRange> ranges =
        List.of(
            SegmentRange.threshold("low", 0, 20, SegmentColour.SKY),
            SegmentRange.threshold("both", 10, 90, SegmentColour.RED),
            SegmentRange.threshold("none", 200, 255, SegmentColour.BLUE));
    List<Integer> done = new ArrayList<>();
    List<Segment> segments = StackSegments.of(volume, volume::pixels, ranges, done::add);
    assertEquals(List.of(0, 1, 2), done);
    for (int n = 0; n < 3; n++) {
      BitCube bits = segments.get(n).bits();
      assertEquals(ranges.get(n).name(), segments.get(n).name());
      assertEquals(ranges.get(n).rgb(), segments.get(n).rgb());
      for (int k = 0; k < 3; k++) {
        for (int j = 0; j < 5; j++) {
          for (int i = 0; i < 7; i++) {
            boolean solid = ranges.get(n).contains(volume.slice(k).getf(i, j));
            assertEquals(solid, bits.get(i, j, k), n + " at " + i + "," + j + "," + k);
          }
        }
      }
    }
  }

  @Test
  void aShownThresholdReplacesTheRange() {
    ImagePlus image = Stacks.of(8, 2, 2, 2, (i, j, k) -> 0);
    SegmentRange range = SegmentRange.threshold("a", 1, 2, SegmentColour.GREEN);
    assertSame(range, range.withThresholdOf(image));
    image.getProcessor().setThreshold(40, 99, ImageProcessor.NO_LUT_UPDATE);
    assertEquals(
        new SegmentRange("a", 40, 99, SegmentColour.GREEN.rgb()), range.withThresholdOf(image));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, Double.NaN, Double.POSITIVE_INFINITY})
  void aVoxelEdgeIsPositiveAndFinite(double edge) {
    ImagePlus image = Stacks.of(8, 2, 2, 2, (i, j, k) -> 0);
    image.getCalibration().pixelDepth = edge;
    assertEquals(
        "The voxel size is not positive: set it by Image > Properties... (Ctrl+Shift+P).",
        assertThrows(TouchRefusedException.class, () -> StackGeometry.of(image)).getMessage());
  }

  @Test
  void aNegativeEdgeCountsAsItsLengthAndAnUnknownUnitAsMillimetres() throws TouchRefusedException {
    ImagePlus image = Stacks.of(8, 4, 3, 2, (i, j, k) -> 0);
    Calibration calibration = image.getCalibration();
    calibration.pixelWidth = -0.5;
    calibration.setUnit("parsec");
    calibration.zOrigin = 1;
    calibration.pixelDepth = 3;
    StackGeometry geometry = StackGeometry.of(image);
    assertEquals("(0.5, 1.0, 3.0)", geometry.grid().spacingMm().toString());
    assertEquals(1, geometry.mmPerUnit());
    assertEquals(
        "(0.0, 0.0, -3.0)", geometry.grid().gridToWorld(new Vec3(), new Vec3()).toString());
  }

  @Test
  void coloursRepeatAndAreFoundByTheirWords() {
    SegmentColour[] colours = SegmentColour.values();
    for (int n = 0; n < colours.length; n++) {
      assertEquals(colours[n], SegmentColour.parse(colours[n].toString()).orElseThrow());
      assertEquals(colours[n], SegmentColour.byNumber(n));
      assertEquals(colours[n], SegmentColour.byNumber(n - 8));
    }
    assertEquals(List.of("bone", "sky"), List.of(SegmentColour.words()).subList(0, 2));
    assertTrue(SegmentColour.parse("Bone").isEmpty());
  }
}
