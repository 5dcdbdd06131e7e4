package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.phantom.Phantom;

/**
 * Damages files of a folder, and segmentation objects over their whole length. Each is read or
 * refused in one line. {@code -Dpalpate.seed} repeats a run.
 */
class DamagedSeriesTest {
  private static final int SERIES = 400;
  private static final int OBJECTS = 2000;

  @TempDir Path folder;
  private Random random;
  private long seed;

  @BeforeEach
  void chooseSeed() {
    seed = Long.getLong("palpate.seed", System.nanoTime());
    System.out.println("DamagedSeriesTest seed " + seed);
    random = new Random(seed);
  }

  @Test
  void aFolderWithDamagedFilesIsReadOrRefused() throws IOException {
    List<byte[]> whole = new ArrayList<>();
    for (int n = 0; n < 6; n++) {
      Path file = folder.resolve("image");
      new DicomTestFile(n % 3, 100 * n)
          .text(DicomTag.TRIGGER_TIME, "DS", Integer.toString(50 * (n / 3)))
          .text(DicomTag.SOP_INSTANCE, "UI", "1.2." + n)
          .write(file);
      whole.add(Files.readAllBytes(file));
      Files.delete(file);
    }
    for (int n = 0; n < SERIES; n++) {
      Path series = Files.createDirectory(folder.resolve("series" + n));
      for (int image = 0; image < whole.size(); image++) {
        Files.write(series.resolve("image" + image), whole.get(image));
      }
      for (int times = 1 + random.nextInt(2); times > 0; times--) {
        int image = random.nextInt(whole.size());
        // an added file stands at the place of another
        String name = "image" + (random.nextBoolean() ? image : whole.size());
        Files.write(series.resolve(name), damaged(whole.get(image)));
      }
      requireReadOrRefused(series, "series " + n);
    }
  }

  @Test
  void aDamagedSegmentationIsReadOrRefused() throws IOException {
    Path file = folder.resolve("whole.dcm");
    try (var out = Files.newOutputStream(file)) {
      DicomSegmentationWriter.write(
          new SegmentsAsLabels(Phantom.parse("head:16").segments(), CoordinateSystem.RAS), out);
    }
    byte[] whole = Files.readAllBytes(file);
    for (int n = 0; n < OBJECTS; n++) {
      Path damaged = Files.write(folder.resolve("damaged.dcm"), damaged(whole));
      requireReadOrRefused(damaged, "object " + n);
    }
  }

  private byte[] damaged(byte[] whole) {
    if (random.nextInt(8) == 0) {
      return Arrays.copyOf(whole, random.nextInt(whole.length));
    }
    byte[] damaged = whole.clone();
    for (int times = 1 + random.nextInt(4); times > 0; times--) {
      damaged[random.nextInt(whole.length)] = (byte) random.nextInt(256);
    }
    return damaged;
  }

  private void requireReadOrRefused(Path place, String what) throws IOException {
    for (ReadOptions options :
        List.of(ReadOptions.defaults(), ReadOptions.defaults().withTimeStep(1))) {
      try {
        VolumeFiles.open(place, options).readLayers((k, slice) -> {});
      } catch (VolumeFormatException refused) {
        assertEquals(1, refused.getMessage().lines().count(), refused.getMessage());
      } catch (RuntimeException | Error e) {
        fail(what + " with seed " + seed + " kept as " + kept(place), e);
      }
    }
  }

  private Path kept(Path place) throws IOException {
    Path target = Path.of("target", "fuzz-" + seed);
    Files.createDirectories(target);
    try (Stream<Path> files = Files.walk(place)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Files.write(target.resolve(file.getFileName()), Files.readAllBytes(file));
      }
    }
    return target;
  }
}
