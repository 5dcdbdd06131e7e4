package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.dicom.DicomSliceWriter;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.testing.Scans;
import org.palpate.volume.phantom.Phantom;

/** Checks that a file whose header promises more than it has is to be copied again. */
class TruncatedFileTest {
  @TempDir Path folder;

  @Test
  void namesBothNumbersOfBytes() throws IOException {
    Path file = folder.resolve("a.nrrd");
    Files.writeString(
        file, "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 10 10 10\nencoding: raw\n\n");
    Files.write(file, new byte[700], StandardOpenOption.APPEND);
    assertEquals(
        "the header promises 1,000 bytes of data but the file has 700: "
            + file
            + ": copy the file again; if that does not help, export it again",
        refusal(file));
  }

  @Test
  void aNiftiIsToBeCopiedAgain() throws IOException {
    Path file = folder.resolve("a.nii");
    VolumeWriter.write(new PhantomReader(Phantom.parse("torus:16:grey")), file);
    requireCopyAgain(shortened(file, 100));
  }

  @Test
  void aDicomFileIsToBeCopiedAgainOrIsDamaged() throws IOException {
    Path file = folder.resolve("a.dcm");
    DicomSliceWriter.slice(file, "1.2", "0\\0\\0", "1\\0\\0\\0\\1\\0", 7);
    assertTrue(refusal(shortened(file, 10)).contains("copy"), refusal(file));
  }

  @ParameterizedTest
  @ValueSource(strings = {"lzw", "deflate", "packbits"})
  void aTiffIsToBeCopiedAgain(String compression) throws IOException {
    Path file = folder.resolve("a.tif");
    try (InputStream in = TruncatedFileTest.class.getResourceAsStream(compression + ".tif")) {
      Files.copy(in, file);
    }
    assertTrue(refusal(shortened(file, 200)).contains("copy"), refusal(file));
  }

  @Test
  void anImagejStackNamesBothNumbersOfSlices() {
    String message = refusal(Scans.file("cases/tiff/ij_images_lie.tif"));
    assertTrue(
        message.contains("promises 50 slices but the file has room for at most 7:"), message);
  }

  private void requireCopyAgain(Path file) {
    String message = refusal(file);
    assertTrue(message.startsWith("the header promises "), message);
    assertTrue(message.contains("copy the file again"), message);
  }

  private static Path shortened(Path file, int bytes) throws IOException {
    byte[] whole = Files.readAllBytes(file);
    return Files.write(file, Arrays.copyOf(whole, whole.length - bytes));
  }

  private static String refusal(Path file) {
    return assertThrows(
            VolumeFormatException.class,
            () -> VolumeFiles.open(file, ReadOptions.defaults()).read((k, slice) -> {}))
        .getMessage();
  }
}
