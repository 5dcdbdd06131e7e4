package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.volume.VolumeFormatException;

class VolumeOptionsTest {
  private static VolumeOptions options(String... arguments) {
    return Given.options(new VolumeOptions(), arguments);
  }

  @Test
  void withoutOptionsTheVolumeIsAHead() throws VolumeFormatException {
    VolumeOptions none = options();
    assertEquals(Optional.empty(), none.volume());
    assertEquals("head:256", none.phantom());
    assertEquals(List.of(), none.segments());
    assertEquals(Optional.empty(), none.scene());
    assertEquals(Optional.empty(), none.raw());
    assertEquals(Optional.empty(), none.series());
    assertEquals(OptionalInt.empty(), none.time());
    assertFalse(none.resample());
    assertFalse(none.isPlaced());
    none.refuseSpacing();
  }

  @Test
  void everyOptionOfAFileArrives() {
    VolumeOptions options =
        options(
            "--volume=v.raw",
            "--raw=1x1x1:u8:1,1,1",
            "--time=3",
            "--series=1.2.3",
            "--segment=a=>=1",
            "--segment=b=label:2",
            "--resample");
    assertEquals(Optional.of(Path.of("v.raw")), options.volume());
    assertEquals(Optional.of("1x1x1:u8:1,1,1"), options.raw());
    assertEquals(OptionalInt.of(3), options.time());
    assertEquals(Optional.of("1.2.3"), options.series());
    assertEquals(List.of("a=>=1", "b=label:2"), options.segments());
    assertTrue(options.resample());
    assertEquals(Optional.empty(), options.spacing());
  }

  @Test
  void voxelsOfOtherEdgesAreForAnExport() {
    VolumeOptions options = options("--volume=v.nrrd", "--resample=0.5,0.5,1");
    assertEquals(Optional.of("0.5,0.5,1"), options.spacing());
    assertFalse(options.resample());
    Given.refuses(
        "only info --export writes other voxels: --resample 0.5,0.5,1: export the volume first, or"
            + " write --resample alone",
        options::refuseSpacing);
  }

  @ParameterizedTest
  @ValueSource(strings = {"--volume=v.nrrd", "--phantom=head:64", "--segment=a=>=1"})
  void aSceneNamesItsOwnVolumes(String other) {
    Given.refuses(
        "a scene names its own volumes and segments: --scene s.json: leave --volume, --phantom and"
            + " --segment out",
        () -> options("--scene=s.json", other).volume());
  }

  @Test
  void aFileAndAPhantomExcludeEachOther() {
    Given.refuses(
        "a file and a phantom were both given: --volume and --phantom: leave one of them out",
        () -> options("--volume=v.nrrd", "--phantom=head:64").volume());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--raw=1x1x1:u8:1,1,1|--raw without a file: --raw 1x1x1:u8:1,1,1: name the raw file with"
            + " --volume FILE",
        "--time=2|--time without a file: --time 2: name the file with --volume FILE, or leave"
            + " --time out",
        "--series=2|--series without a file: --series 2: name the file with --volume FILE, or leave"
            + " --series out",
        "--resample|--resample without a file: --resample: name the file with --volume FILE, or"
            + " leave --resample out"
      })
  void anOptionOfFilesNeedsAFile(String option, String line) {
    Given.refuses(line, () -> options("--phantom=head:64", option).volume());
  }

  @ParameterizedTest
  @CsvSource({
    "--phantom=fracture, true, true",
    "--phantom=fracture:64:2, true, true",
    "--phantom=fractured, false, false",
    "--volume=v.nrrd, false, false",
    "--phantom=sphere:16, false, false"
  })
  void bodiesOfABrokenBoneHavePoses(String option, boolean placed, boolean broken)
      throws VolumeFormatException {
    assertEquals(placed, options(option).isPlaced());
    assertEquals(broken, options(option).isBrokenPhantom());
  }
}
