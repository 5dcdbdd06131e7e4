package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.GreyVolumes;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.ScalarVolume;

class ReshapeOptionsTest {
  @TempDir private Path folder;

  private static ReshapeOptions options(String... arguments) {
    return Given.options(new ReshapeOptions(), arguments);
  }

  /** Returns a volume of 4 x 3 x 2 voxels whose values are 1 to 24, x first. */
  private VolumeReader volume() throws IOException {
    String values = "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24";
    Path file = Given.nrrd(folder.resolve("v.nrrd"), "uint8", "4 3 2", values);
    return Given.source("--volume", file.toString(), "--segment=a=>=1").reader();
  }

  private static ScalarVolume values(VolumeReader reader) throws IOException {
    return GreyVolumes.read(reader);
  }

  @Test
  void withoutOptionsTheReaderStaysTheSame() throws IOException {
    VolumeReader reader = volume();
    assertFalse(options().isWanted());
    assertSame(reader, options().applyTo(reader, Optional.empty(), false));
    assertTrue(options("--crop=0..1,0..1,0..1").isWanted());
    assertTrue(options("--mirror=0,0,0,1,0,0").isWanted());
  }

  @Test
  void aBoxIsCutOutWithBothItsEnds() throws IOException {
    VolumeReader cropped =
        options("--crop=1..3,2..2,0..1").applyTo(volume(), Optional.empty(), true);
    ScalarVolume values = values(cropped);
    assertEquals(3, values.grid().sizeX());
    assertEquals(1, values.grid().sizeY());
    assertEquals(2, values.grid().sizeZ());
    assertEquals(10, values.value(0, 0, 0));
    assertEquals(24, values.value(2, 0, 1));
  }

  @Test
  void theBoxComesFirstThenTheVoxelsThenTheMirror() throws IOException {
    VolumeReader shaped =
        options("--crop=0..1,0..0,0..0", "--mirror=0.5,0,0,1,0,0")
            .applyTo(volume(), Optional.of("0.5,1,1"), true);
    ScalarVolume values = values(shaped);
    assertEquals(4, values.grid().sizeX(), "two voxels of 1 mm are four of 0.5 mm");
    assertEquals(
        "2.0 2.0 1.0 1.0",
        values.value(0, 0, 0)
            + " "
            + values.value(1, 0, 0)
            + " "
            + values.value(2, 0, 0)
            + " "
            + values.value(3, 0, 0));
  }

  @Test
  void labelsAreNotInterpolatedAndGreyValuesAre() throws IOException {
    VolumeReader labels =
        options("--crop=0..3,0..0,0..0").applyTo(volume(), Optional.of("2,1,1"), true);
    VolumeReader greys =
        options("--crop=0..3,0..0,0..0").applyTo(volume(), Optional.of("2,1,1"), false);
    assertEquals(2, values(labels).value(0, 0, 0), "of the voxel that holds the centre");
    assertEquals(2, values(greys).value(0, 0, 0), "the mean 1.5 is rounded to an integer");
    assertEquals(4, values(labels).value(1, 0, 0));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0..4,0..2,0..1",
        "2..1,0..2,0..1",
        "0..3,0..2",
        "a..3,0..2,0..1",
        "0-3,0-2,0-1",
        ""
      })
  void aBoxThatLeavesTheVolumeIsRefusedWithItsSize(String box) {
    VolumeFormatException refusal =
        assertThrows(
            VolumeFormatException.class,
            () -> options("--crop=" + box).applyTo(volume(), Optional.empty(), false));
    assertEquals(
        "the box is not understood or leaves the volume of 4 x 3 x 2 voxels: --crop "
            + box
            + ": write first..last along x, y and z, for example 10..99,0..63,5..40",
        refusal.getMessage());
  }

  @ParameterizedTest
  @ValueSource(strings = {"0,0,0,0,0,0", "1,2,3", "a,0,0,1,0,0", "0,0,0,1,0,inf"})
  void aPlaneWithoutANormalIsRefused(String plane) {
    VolumeFormatException refusal =
        assertThrows(
            VolumeFormatException.class,
            () -> options("--mirror=" + plane).applyTo(volume(), Optional.empty(), false));
    assertTrue(
        refusal.getMessage().startsWith("the plane is not understood: --mirror " + plane + ": "),
        refusal.getMessage());
  }
}
