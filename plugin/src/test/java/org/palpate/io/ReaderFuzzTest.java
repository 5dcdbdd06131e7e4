package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.io.dicom.DicomSliceWriter;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.phantom.Phantom;

/**
 * Checks that any damaged file is read or refused in one line, without another exception, a hang,
 * or memory out of proportion. Samples are damaged at random, {@value #FILES} files a format, or
 * with {@code -Dpalpate.fuzz.seconds=60} as many as that time lets; {@code -Dpalpate.seed} repeats
 * a run case by case, and a file that fails is kept in {@code target}.
 */
@Timeout(value = 30, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ReaderFuzzTest {
  private static final int FILES = 5_000;
  private static final Integer SECONDS = Integer.getInteger("palpate.fuzz.seconds");
  private static final long LARGEST_SAMPLE = 25_000;

  /** Decompression multiplies by a thousand, and a byte can become a double. */
  private static final long BYTES_PER_BYTE = 10_000;

  private static final long BYTES_ANYWAY = 64_000_000;

  @TempDir Path folder;
  private long seed;

  @BeforeEach
  void chooseSeed() {
    String asked = System.getProperty("palpate.seed", "");
    seed = asked.matches("-?[0-9]+") ? Long.parseLong(asked) : System.nanoTime();
    System.out.println("ReaderFuzzTest seed " + seed);
  }

  @Test
  void nrrdIsReadOrRefused() throws Exception {
    fuzz("nrrd", samples("formats/nrrd", written("a.nrrd")));
  }

  @Test
  void niftiIsReadOrRefused() throws Exception {
    fuzz("nifti", samples("formats/nifti", written("a.nii"), written("b.nii.gz")));
  }

  @Test
  void metaImageIsReadOrRefused() throws Exception {
    Path plain = folder.resolve("a.mha");
    Files.writeString(
        plain,
        """
        NDims = 3
        DimSize = 3 3 3
        ElementType = MET_UCHAR
        ElementSpacing = 1 1 2
        TransformMatrix = 1 0 0 0 1 0 0 0 1
        ElementDataFile = LOCAL
        abcdefghijklmnopqrstuvwxyz.
        """);
    fuzz("mha", samples("formats/mha", plain));
  }

  @Test
  void tiffIsReadOrRefused() throws Exception {
    List<Path> samples = new ArrayList<>();
    for (String name : List.of("lzw", "packbits", "deflate", "tiled", "big")) {
      Path file = folder.resolve(name + ".tif");
      try (InputStream in = ReaderFuzzTest.class.getResourceAsStream(name + ".tif")) {
        Files.copy(in, file);
      }
      samples.add(file);
    }
    fuzz("tif", samples);
  }

  @Test
  void dicomIsReadOrRefused() throws Exception {
    Path jpeg = folder.resolve("ljpeg.dcm");
    try (InputStream in = ReaderFuzzTest.class.getResourceAsStream("ljpeg.dcm")) {
      Files.copy(in, jpeg);
    }
    Path slice = folder.resolve("slice.dcm");
    DicomSliceWriter.slice(slice, "1.2", "0\\0\\0", "1\\0\\0\\0\\1\\0", 7);
    fuzz("dcm", samples("formats/dicom", jpeg, slice));
  }

  private Path written(String name) throws VolumeFormatException {
    Path file = folder.resolve(name);
    VolumeWriter.write(new PhantomReader(Phantom.parse("torus:16:grey")), file);
    return file;
  }

  /** Returns the given files and the small ones of a folder of real data, if that exists. */
  private static List<Path> samples(String name, Path... given) throws IOException {
    List<Path> samples = new ArrayList<>(List.of(given));
    Path data = Path.of(System.getProperty("palpate.data", "../shared/data")).resolve(name);
    if (Files.isDirectory(data)) {
      try (Stream<Path> files = Files.list(data).sorted()) {
        for (Path file : files.toList()) {
          if (Files.size(file) <= LARGEST_SAMPLE) {
            samples.add(file);
          }
        }
      }
    }
    return samples;
  }

  private void fuzz(String format, List<Path> samples) throws IOException {
    assumeTrue(!samples.isEmpty(), "skipped: no samples of " + format);
    Random random = new Random(seed);
    long start = System.nanoTime();
    int refused = 0;
    int cases = 0;
    long longest = 0;
    List<byte[]> contents = new ArrayList<>();
    for (Path sample : samples) {
      contents.add(Files.readAllBytes(sample));
    }
    for (long now = start; goesOn(cases, now - start); cases++) {
      int which = random.nextInt(samples.size());
      byte[] spoiled = FileMutator.spoil(contents.get(which), random);
      String name = samples.get(which).getFileName().toString();
      Path file = Files.write(folder.resolve("spoiled-" + name), spoiled);
      refused += isRead(file, spoiled, format + " case " + cases) ? 0 : 1;
      longest = Math.max(longest, System.nanoTime() - now);
      now = System.nanoTime();
    }
    System.out.printf(
        Locale.ROOT,
        "%s: %,d spoiled files, %,d refused, the others read; the longest took %d ms%n",
        format,
        cases,
        refused,
        TimeUnit.NANOSECONDS.toMillis(longest));
  }

  private static boolean goesOn(int cases, long nanos) {
    return SECONDS == null ? cases < FILES : nanos < TimeUnit.SECONDS.toNanos(SECONDS);
  }

  /** Returns whether the file was read; otherwise it was refused. */
  private boolean isRead(Path file, byte[] bytes, String what) throws IOException {
    boolean read = false;
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long thread = Thread.currentThread().getId();
    long before = threads.getThreadAllocatedBytes(thread);
    try {
      VolumeFiles.open(file, ReadOptions.defaults().withTimeStep(0)).read((k, slice) -> {});
      read = true;
    } catch (VolumeFormatException refused) {
      assertTrue(refused.getMessage().lines().count() == 1, refused.getMessage());
    } catch (RuntimeException | Error e) {
      keep(bytes, file, what, e);
    }
    long allocated = threads.getThreadAllocatedBytes(thread) - before;
    if (allocated > BYTES_ANYWAY + BYTES_PER_BYTE * bytes.length) {
      keep(bytes, file, what + " allocated " + allocated, null);
    }
    return read;
  }

  private void keep(byte[] bytes, Path file, String what, Throwable cause) throws IOException {
    Path kept = Path.of("target", "fuzz-" + seed + "-" + file.getFileName());
    Files.createDirectories(kept.getParent());
    Files.write(kept, bytes);
    fail(what + " with seed " + seed + ", kept as " + kept, cause);
  }
}
