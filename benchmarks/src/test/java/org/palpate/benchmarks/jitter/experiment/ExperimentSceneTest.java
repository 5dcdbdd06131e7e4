package org.palpate.benchmarks.jitter.experiment;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.process.PalpateException;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine;

/** The scene passes from the command to the process of an experiment as text. */
class ExperimentSceneTest {
  @TempDir private Path folder;

  /** The options as a command has them. */
  @CommandLine.Command
  private static final class Options {
    @CommandLine.Mixin private VolumeOptions volume;
  }

  private static String textOf(String... arguments) {
    Options options = new Options();
    new CommandLine(options).parseArgs(arguments);
    return ExperimentScene.textOf(options.volume);
  }

  /** Writes a raw volume of 3 x 2 x 2 bytes with the values 0 to 11. */
  private Path raw() throws IOException {
    byte[] bytes = new byte[12];
    for (int n = 0; n < 12; n++) {
      bytes[n] = (byte) n;
    }
    return Files.write(folder.resolve("a volume.raw"), bytes);
  }

  @Test
  void aPhantomIsItsOwnText() throws VolumeFormatException {
    String text = textOf("--phantom", "sphere:32");
    assertEquals("phantom sphere:32", text);
    ExperimentScene.check(text);
    SegmentedVolume volume = ExperimentScene.read(text);
    assertEquals(32, volume.grid().sizeX());
    assertEquals("sphere", volume.segments().get(0).name());
  }

  @Test
  void aFileKeepsItsLayoutAndItsSegments() throws IOException {
    Path file = raw();
    String text =
        textOf(
            "--volume",
            file.toString(),
            "--raw",
            "3x2x2:u8:1,1,2",
            "--segment",
            "bone=>=7",
            "--segment",
            "rest=1..6");
    assertEquals(
        "volume "
            + file.toAbsolutePath()
            + "\nraw 3x2x2:u8:1,1,2\nsegment bone=>=7\nsegment rest=1..6",
        text);
    ExperimentScene.check(text);
    SegmentedVolume volume = ExperimentScene.read(text);
    assertEquals(2, volume.grid().spacingMm().z);
    assertEquals("bone", volume.segments().get(0).name());
    BitCube bone = volume.segments().get(0).bits();
    BitCube rest = volume.segments().get(1).bits();
    for (int n = 0; n < 12; n++) {
      assertEquals(n >= 7, bone.get(n % 3, n / 3 % 2, n / 6), "value " + n);
      assertEquals(n >= 1 && n <= 6, rest.get(n % 3, n / 3 % 2, n / 6), "value " + n);
    }
  }

  @Test
  void aFileWithoutSegmentsIsRefused() throws IOException {
    String file = raw().toString();
    PalpateException refused = assertThrows(PalpateException.class, () -> textOf("--volume", file));
    assertTrue(refused.getMessage().contains("choose with --segment"), refused.getMessage());
    assertEquals(PalpateException.WRONG_USE, refused.exitCode());
  }

  @Test
  void mistakesShowBeforeAnExperimentRuns() throws IOException {
    PalpateException phantom =
        assertThrows(PalpateException.class, () -> ExperimentScene.check("phantom cube:32"));
    assertEquals(PalpateException.WRONG_USE, phantom.exitCode());
    assertRefused("no such file", "volume " + folder.resolve("missing.nrrd"));
    assertRefused(
        "the file has 12 bytes but --raw describes 18",
        "volume " + raw() + "\nraw 3x2x3:u8:1,1,2\nsegment a=>=1");
    assertRefused(
        "the values of the segment are not understood: --segment a=about 7",
        "volume " + raw() + "\nraw 3x2x2:u8:1,1,2\nsegment a=about 7");
    IllegalArgumentException unknown =
        assertThrows(IllegalArgumentException.class, () -> ExperimentScene.check("mesh a.stl"));
    assertEquals("not a scene: mesh a.stl", unknown.getMessage());
  }

  private static void assertRefused(String reason, String scene) {
    String message =
        assertThrows(VolumeFormatException.class, () -> ExperimentScene.check(scene)).getMessage();
    assertTrue(message.startsWith(reason + ": "), message);
  }
}
