package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.function.Executable;
import org.palpate.app.process.PalpateException;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine;

/** Parses options as a command does, and asserts how they are refused. */
final class Given {
  private Given() {}

  /** Returns options after parsing arguments into them. */
  static <T> T options(T options, String... arguments) {
    new CommandLine(options).setCaseInsensitiveEnumValuesAllowed(true).parseArgs(arguments);
    return options;
  }

  /** Opens the volume that arguments name. */
  static VolumeSource source(String... arguments) throws VolumeFormatException {
    return VolumeSource.open(options(new VolumeOptions(), arguments));
  }

  /** Reads the segments of a volume, and asserts that there is nothing to note. */
  static SegmentedVolume segments(VolumeSource source) throws VolumeFormatException {
    StringWriter notes = new StringWriter();
    SegmentedVolume found = source.segments(new PrintWriter(notes), false);
    assertEquals("", notes.toString());
    return found;
  }

  /** Asserts that a call is refused as wrong use, with this line. */
  static void refuses(String line, Executable call) {
    PalpateException refusal = assertThrows(PalpateException.class, call);
    assertEquals(line, refusal.getMessage());
    assertEquals(PalpateException.WRONG_USE, refusal.exitCode());
  }

  /** Writes a volume of unit voxels as text. */
  static Path nrrd(Path file, String type, String sizes, String values) throws IOException {
    return Files.writeString(
        file,
        String.format(
            "NRRD0004\ntype: %s\ndimension: 3\nsizes: %s\nencoding: ascii\n\n%s\n",
            type, sizes, values));
  }
}
