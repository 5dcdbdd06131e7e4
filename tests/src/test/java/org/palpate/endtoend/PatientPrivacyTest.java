package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.testing.Scans;

/** Checks that what names a patient in a DICOM header reaches no output of a command. */
class PatientPrivacyTest {
  private static final String[] FORMATS = {"a.nrrd", "a.nii", "a.dcm"};

  @TempDir private Path folder;

  /** The last column is a pattern of name, number, dates and identifiers in the header. */
  @ParameterizedTest
  @CsvSource({
    "formats/dicom/CT_small.dcm, a=>=500, CompressedSamples|1CT1|20040119|19970430|3.6.1.4.1.5962",
    "formats/dicom/MR_small_jpeg_ls_lossless.dcm, a=>=500, "
        + "CompressedSamples|4MR1|20040826|3.6.1.4.1.5962",
    "cases/dicom/seg_binary.dcm, a=nonzero, TEST.NONE|20200101|2.826.0.1.3680043",
    "cases/dicom/time_series, a=nonzero, TEST.NONE|20200101|2.826.0.1.3680043",
    "cases/dicom/with_strangers, a=>=-800, TEST.NONE|20200101|2.826.0.1.3680043",
    "cases/dicom/subfolders, a=nonzero, TEST.NONE|20200101|2.826.0.1.3680043",
  })
  void noCommandPassesItOn(String name, String segment, String secrets) throws IOException {
    Pattern secret = Pattern.compile(secrets);
    assertTrue(secret.matcher(content(Scans.file(name))).find(), "the file has no secret");
    List<Object> volume = new ArrayList<>(List.of("--volume", Scans.file(name)));
    if (name.endsWith("time_series")) {
      require(secret, run(2, List.of("info", "--debug"), volume));
      volume.addAll(List.of("--time", "1"));
    }
    volume.addAll(List.of("--segment", segment));
    int exitCode = name.endsWith("subfolders") ? 2 : 0;
    for (String format : FORMATS) {
      Path export = folder.resolve(format);
      Path report = folder.resolve("r.json");
      require(
          secret,
          run(
              exitCode,
              List.of("info", "--debug"),
              volume,
              "--export",
              export,
              "--report",
              report));
    }
    Path record = folder.resolve("t.csv");
    List<Object> touch =
        List.of("touch", "--headless", "--seconds", "0.3", "--assess", folder.resolve("training"));
    require(
        secret,
        run(exitCode, touch, volume, "--record", record, "--report", folder.resolve("touch.json")));
    require(secret, content(folder));
  }

  @Test
  void theNamesOfSegmentsAreKept() throws IOException {
    Path file = Scans.file("cases/dicom/seg_binary.dcm");
    Path export = folder.resolve("a.dcm");
    run(0, List.of("info"), List.of("--volume", file), "--export", export);
    assertTrue(content(export).contains("lung"));
  }

  private static String run(int exitCode, List<?> command, List<?> volume, Object... more) {
    List<Object> all = new ArrayList<>(command);
    all.addAll(volume);
    all.addAll(List.of(more));
    CommandRun run = CommandRun.of(all.toArray());
    assertEquals(exitCode, run.exitCode(), run.err());
    return run.out() + run.err();
  }

  private static void require(Pattern secret, String text) {
    assertFalse(secret.matcher(text).find(), () -> secret + " in " + text);
  }

  /** Returns the bytes of a file, or of all files in a folder, as text; gzip is unpacked. */
  private static String content(Path place) throws IOException {
    StringBuilder text = new StringBuilder();
    try (Stream<Path> files = Files.walk(place)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        byte[] bytes = Files.readAllBytes(file);
        text.append(new String(bytes, StandardCharsets.ISO_8859_1)).append(unpacked(bytes));
      }
    }
    return text.toString();
  }

  private static String unpacked(byte[] bytes) throws IOException {
    for (int at = 0; at + 2 < bytes.length; at++) {
      if (bytes[at] == 0x1f && bytes[at + 1] == (byte) 0x8b && bytes[at + 2] == 8) {
        byte[] whole =
            new GZIPInputStream(new ByteArrayInputStream(bytes, at, bytes.length - at))
                .readAllBytes();
        return new String(whole, StandardCharsets.ISO_8859_1);
      }
    }
    return "";
  }
}
