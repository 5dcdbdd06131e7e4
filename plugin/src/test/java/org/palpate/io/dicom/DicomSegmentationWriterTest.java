package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.testing.Scans;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Writes segmentation objects, and reads them back. */
class DicomSegmentationWriterTest {
  private static final int SIZE_X = 5;
  private static final int SIZE_Y = 3;
  private static final int SIZE_Z = 7;

  @TempDir Path folder;

  @ParameterizedTest
  @EnumSource(CoordinateSystem.class)
  void segmentsComeBackVoxelForVoxelAtTheirPlace(CoordinateSystem system) throws Exception {
    long seed = Long.getLong("palpate.seed", System.nanoTime());
    System.out.println("DicomSegmentationWriterTest seed " + seed);
    SegmentedVolume volume = random(new Random(seed));
    VolumeReader read = roundTrip(new SegmentsAsLabels(volume, system));
    assertEquals(CoordinateSystem.LPS, read.header().coordinateSystem());
    for (int n = 0; n < volume.segments().size(); n++) {
      Segment segment = volume.segments().get(n);
      SegmentSpec byName = SegmentSpec.parse("a=name:" + segment.name());
      BitCube found = SegmentBuilder.read(read, List.of(byName)).segments().get(0).bits();
      assertEquals(worldOf(volume.grid(), segment.bits(), system), worldOf(read, found));
      Label label = read.header().labels().orElseThrow().labels().get(n + 1L);
      requireNear(segment.rgb(), label.rgb());
    }
  }

  /** Returns two segments that overlap and a third in few slices, on an oblique grid. */
  private static SegmentedVolume random(Random random) {
    double turn = 0.3;
    Vec3 x = new Vec3(Math.cos(turn), Math.sin(turn), 0);
    Vec3 y = new Vec3(Math.sin(turn), -Math.cos(turn), 0); // a left-handed grid with z
    RigidTransform place =
        new RigidTransform(x, y, new Vec3(0, 0, 1), new Vec3(-12.25, 1e-3 / 3, 71));
    VoxelGrid grid =
        VoxelGrid.ofFirstCentre(SIZE_X, SIZE_Y, SIZE_Z, new Vec3(0.7, 1.3, 2.5), place);
    List<Segment> segments = new ArrayList<>();
    for (String name : List.of("bone", "Müskel", "left lung: upper")) {
      BitCube bits = new BitCube(SIZE_X, SIZE_Y, SIZE_Z);
      bits.set(1, 1, 0);
      bits.set(2, 1, SIZE_Z - 1);
      for (int n = 0; n < 20; n++) {
        bits.set(random.nextInt(SIZE_X), random.nextInt(SIZE_Y), 3 * random.nextInt(3));
      }
      segments.add(new Segment(name, bits, random.nextInt(1 << 24)));
    }
    return new SegmentedVolume(grid, segments);
  }

  /** Returns the LPS positions of the voxels of a segment, rounded to a micrometre. */
  private static List<String> worldOf(VoxelGrid grid, BitCube bits, CoordinateSystem system) {
    double signX = system == CoordinateSystem.RAS ? -1 : 1;
    double signY = system == CoordinateSystem.RAS || system == CoordinateSystem.LAS ? -1 : 1;
    List<String> places = new ArrayList<>();
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          if (bits.get(i, j, k)) {
            Vec3 world = grid.gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
            places.add(
                micrometres(signX * world.x)
                    + " "
                    + micrometres(signY * world.y)
                    + " "
                    + micrometres(world.z));
          }
        }
      }
    }
    places.sort(null);
    return places;
  }

  private static long micrometres(double mm) {
    return Math.round(mm * 1e3);
  }

  private static List<String> worldOf(VolumeReader read, BitCube bits) {
    return worldOf(read.header().grid(), bits, CoordinateSystem.LPS);
  }

  private static void requireNear(int rgb, int other) {
    for (int shift = 0; shift < 24; shift += 8) {
      assertEquals(rgb >> shift & 0xff, other >> shift & 0xff, 1);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"seg_binary.dcm", "seg_fractional.dcm", "seg_labelmap.dcm"})
  void aSegmentationThatWasReadIsWrittenWithTheSameVoxels(String name) throws Exception {
    VolumeReader given =
        VolumeFiles.open(Scans.file("cases/dicom/" + name), ReadOptions.defaults());
    assertEquals(voxels(given), voxels(roundTrip(given)));
  }

  private static Map<String, Long> voxels(VolumeReader reader) throws Exception {
    Map<String, Long> voxels = new TreeMap<>();
    for (Map.Entry<Long, Label> label :
        reader.header().labels().orElseThrow().labels().entrySet()) {
      List<SegmentSpec> spec = List.of(SegmentSpec.labels("a", label.getKey()));
      BitCube bits = SegmentBuilder.read(reader, spec).segments().get(0).bits();
      voxels.put(label.getValue().name() + ' ' + bits.bounds(), bits.solidCount());
    }
    return voxels;
  }

  @Test
  void nothingOfThePatientIsCopied() throws Exception {
    VolumeReader given =
        VolumeFiles.open(Scans.file("cases/dicom/seg_binary.dcm"), ReadOptions.defaults());
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    DicomSegmentationWriter.write(given, out);
    String text = out.toString(StandardCharsets.ISO_8859_1);
    // name, study date and the root of every identifier of the given file
    for (String secret : List.of("TEST^NONE", "20200101", "1.2.826.0.1.3680043.10")) {
      assertFalse(text.contains(secret), secret);
    }
  }

  @Test
  void aVolumeWithoutLabelsIsRefused() throws Exception {
    Path image = new DicomTestFile(0, 1).write(folder.resolve("a.dcm"));
    VolumeReader given = VolumeFiles.open(image, ReadOptions.defaults());
    VolumeFormatException refused =
        assertThrows(
            VolumeFormatException.class,
            () -> DicomSegmentationWriter.write(given, OutputStream.nullOutputStream()));
    assertTrue(refused.getMessage().contains("--segment"), refused.getMessage());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1, -0.5, 1.0 / 3, -1e-3 / 3, 123456789.12345679, 1e-12, -1e12, 1e300})
  void decimalStringsFitAndAreNear(double number) {
    String text = DecimalString.of(number);
    assertTrue(text.length() <= 16, text);
    assertEquals(number, Double.parseDouble(text), Math.abs(number) * 1e-8);
  }

  private VolumeReader roundTrip(VolumeReader volume) throws IOException {
    Path file = folder.resolve("written.dcm");
    try (OutputStream out = Files.newOutputStream(file)) {
      DicomSegmentationWriter.write(volume, out);
    }
    return VolumeFiles.open(file, ReadOptions.defaults());
  }
}
