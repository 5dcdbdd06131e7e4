package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelCrc;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.testing.Scans;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

class VolumeWriterTest {
  private static final double WORLD_TOLERANCE_MM = 1e-9;
  private static final double SINGLE_PRECISION_VOXELS = 1e-3;

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"head.nrrd", "head.nii", "head.nii.gz"})
  void aPhantomReadsBackEqual(String name) throws Exception {
    for (String spec : List.of("head:48", "torus:32:grey")) {
      VolumeReader phantom = new PhantomReader(Phantom.parse(spec));
      assertEquals(VoxelCrc.of(phantom), VoxelCrc.of(writtenAndOpened(phantom, name)));
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "formats/nifti/functional.nii",
        "formats/nifti/anatomical.nii",
        "formats/nifti/reoriented_anat_moved.nii",
        "formats/dicom/CT_small.dcm",
        "formats/nrrd/BallBinary30x30x30_gz.nrrd",
        "LIDC/dicom_10slices"
      })
  void aScanReadsBackEqualAndInTheSamePosition(String name) throws Exception {
    VolumeReader scan = VolumeFiles.open(Scans.file(name), time(name));
    for (String target : List.of("scan.nrrd", "scan.nii.gz")) {
      VolumeReader read = writtenAndOpened(scan, target);
      assertEquals(VoxelCrc.of(scan), VoxelCrc.of(read), target);
      Vec3 expected = asRas(scan, new Vec3(3.5, 2.5, 0.5));
      Vec3 actual = asRas(read, new Vec3(3.5, 2.5, 0.5));
      double tolerance =
          target.endsWith("nrrd")
              ? WORLD_TOLERANCE_MM
              : SINGLE_PRECISION_VOXELS * scan.header().grid().spacingMm().x;
      assertEquals(expected.x, actual.x, tolerance, target);
      assertEquals(expected.y, actual.y, tolerance, target);
      assertEquals(expected.z, actual.z, tolerance, target);
    }
  }

  @Test
  void aNiftiOfTheFirstVersionIsWrittenIfItsPrecisionIsEnough() throws Exception {
    VolumeReader scan =
        VolumeFiles.open(Scans.file("formats/dicom/CT_small.dcm"), ReadOptions.defaults());
    assertEquals("NIfTI-1, gzip", VolumeWriter.write(scan, folder.resolve("a.nii.gz")));
    assertEquals(
        "NIfTI-1",
        VolumeFiles.open(folder.resolve("a.nii.gz"), ReadOptions.defaults())
            .header()
            .format()
            .replace(", gzip", ""));
  }

  @Test
  void aNiftiOfTheSecondVersionIsWrittenWithItsReasonIfSinglePrecisionMovesVoxels()
      throws Exception {
    String header =
        """
        NRRD0004
        type: uint8
        dimension: 3
        sizes: 2 2 2
        space: RAS
        space directions: (0.1,0,0) (0,0.1,0) (0,0,0.1)
        space origin: (12345678.9,0,0)
        encoding: raw

        """;
    Path far =
        Files.write(
            folder.resolve("far.nrrd"), (header + "12345678").getBytes(StandardCharsets.US_ASCII));
    VolumeReader reader = VolumeFiles.open(far, ReadOptions.defaults());
    String words = VolumeWriter.write(reader, folder.resolve("far.nii"));
    assertTrue(words.startsWith("NIfTI-2, because single precision moves voxels;"), words);
    Vec3 centre =
        VolumeFiles.open(folder.resolve("far.nii"), ReadOptions.defaults())
            .header()
            .grid()
            .gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3());
    assertEquals(12345678.9, centre.x, 1e-8);
  }

  @Test
  void aDicomSegmentationOfUnnamedAxesIsWrittenWithThatAssumption() throws Exception {
    assertEquals(
        "DICOM segmentation, binary; the axes are not named and are taken as LPS",
        writtenAsDicom(CoordinateSystem.UNKNOWN));
    assertEquals("DICOM segmentation, binary", writtenAsDicom(CoordinateSystem.RAS));
  }

  @Test
  void aNiftiOfUnnamedAxesIsWrittenWithThatAssumption() throws Exception {
    assertEquals(
        "NIfTI-1, gzip; the axes are not named and are taken as RAS",
        writtenAsNifti(CoordinateSystem.UNKNOWN));
    assertEquals("NIfTI-1, gzip", writtenAsNifti(CoordinateSystem.LPS));
  }

  private String writtenAsNifti(CoordinateSystem system) throws Exception {
    return VolumeWriter.write(
        new SegmentsAsLabels(Phantom.parse("head:16").segments(), system),
        folder.resolve("segments.nii.gz"));
  }

  private String writtenAsDicom(CoordinateSystem system) throws Exception {
    return VolumeWriter.write(
        new SegmentsAsLabels(Phantom.parse("head:16").segments(), system),
        folder.resolve("segments.dcm"));
  }

  private static ReadOptions time(String name) {
    return name.contains("functional")
        ? ReadOptions.defaults().withTimeStep(1)
        : ReadOptions.defaults();
  }

  private static Vec3 asRas(VolumeReader reader, Vec3 grid) {
    Vec3 world = reader.header().grid().gridToWorld(grid, new Vec3());
    return reader.header().coordinateSystem() == CoordinateSystem.LPS
        ? new Vec3(-world.x, -world.y, world.z)
        : world;
  }

  @Test
  void segmentsReadBackWithTheirNamesAndColours() throws Exception {
    SegmentedVolume volume = Phantom.parse("head:48").segments();
    VolumeReader read =
        writtenAndOpened(new SegmentsAsLabels(volume, CoordinateSystem.LPS), "a.nrrd");
    for (int n = 0; n < volume.segments().size(); n++) {
      Segment segment = volume.segments().get(n);
      LabelTable.Label label = read.header().labels().get().labels().get(n + 1L);
      assertEquals(new LabelTable.Label(segment.name(), segment.rgb()), label);
      assertEquals(
          segment.bits().solidCount(),
          SegmentBuilder.read(read, List.of(SegmentSpec.labels("s", n + 1)))
              .segments()
              .get(0)
              .bits()
              .solidCount());
    }
  }

  @Test
  void aFailureLeavesTheTargetAndNoOtherFileBehind() throws Exception {
    Path target = Files.writeString(folder.resolve("kept.nrrd"), "kept");
    VolumeReader broken = failing();
    assertThrows(VolumeFormatException.class, () -> VolumeWriter.write(broken, target));
    assertEquals("kept", Files.readString(target));
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(1, files.count());
    }
  }

  @Test
  void anInputIsNeverOverwritten() throws Exception {
    Path file = folder.resolve("in.nrrd");
    VolumeWriter.write(new PhantomReader(Phantom.parse("sphere:16")), file);
    VolumeReader reader = VolumeFiles.open(file, ReadOptions.defaults());
    VolumeFormatException refused =
        assertThrows(VolumeFormatException.class, () -> VolumeWriter.write(reader, file));
    assertTrue(refused.getMessage().contains("the volume that is read"));
  }

  @Test
  void anotherEndingIsRefused() {
    VolumeReader phantom = new PhantomReader(Phantom.parse("sphere:16"));
    assertThrows(
        VolumeFormatException.class, () -> VolumeWriter.write(phantom, folder.resolve("a.png")));
  }

  private VolumeReader writtenAndOpened(VolumeReader volume, String name) throws Exception {
    Path file = folder.resolve(name);
    VolumeWriter.write(volume, file);
    return VolumeFiles.open(file, ReadOptions.defaults());
  }

  /** Returns a volume that fails after its first slice. */
  private static VolumeReader failing() {
    PhantomReader whole = new PhantomReader(Phantom.parse("sphere:16"));
    return new VolumeReader() {
      @Override
      public VolumeHeader header() {
        return whole.header();
      }

      @Override
      public void read(SliceSink sink) throws VolumeFormatException {
        sink.accept(0, new VoxelSlice(16, 16, true));
        throw new VolumeFormatException("the volume fails", sourceName(), "nothing to do");
      }

      @Override
      public String sourceName() {
        return "test";
      }

      @Override
      public List<Path> files() {
        return List.of();
      }
    };
  }
}
