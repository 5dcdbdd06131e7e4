package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileSaver;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.dicom.DicomSliceWriter;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.RawLayout;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelCrc;
import org.palpate.testing.Scans;

/** Checks that one scan gives the same voxels and spacing in every format. */
class SameScanInEveryFormatTest {
  private static final long BONE_VOXELS = 336_108;
  private static final int EDGE = 256;
  private static final int SLICES = 113;
  private static final int SLICE_BYTES = 2 * EDGE * EDGE;

  private static VolumeReader scan;

  /** The values of the scan, 16 bits each, little-endian. */
  private static byte[] samples;

  @TempDir Path folder;

  @BeforeAll
  static void readTheScan() throws Exception {
    scan = VolumeFiles.open(Scans.file("CThead/CThead_u16gz.nrrd"), ReadOptions.defaults());
    samples = new byte[SLICES * SLICE_BYTES];
    ByteBuffer bytes = ByteBuffer.wrap(samples).order(ByteOrder.LITTLE_ENDIAN);
    scan.read(
        (k, slice) -> {
          for (int n = 0; n < slice.count(); n++) {
            bytes.putShort((short) slice.integers()[n]);
          }
        });
  }

  @Test
  void asItIs() throws Exception {
    requireSame(scan);
  }

  @ParameterizedTest
  @ValueSource(strings = {"scan.nrrd", "scan.nii", "scan.nii.gz"})
  void asWrittenHere(String name) throws Exception {
    Path file = folder.resolve(name);
    VolumeWriter.write(scan, file);
    requireSame(open(file));
  }

  @Test
  void asAPairOfNifti() throws Exception {
    Path whole = folder.resolve("whole.nii");
    VolumeWriter.write(scan, whole);
    byte[] bytes = Files.readAllBytes(whole);
    ByteBuffer header = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int begin = (int) header.getFloat(108); // vox_offset
    header.putFloat(108, 0).put(345, (byte) 'i'); // magic "ni1"
    Files.write(folder.resolve("scan.img"), Arrays.copyOfRange(bytes, begin, bytes.length));
    requireSame(open(Files.write(folder.resolve("scan.hdr"), Arrays.copyOf(bytes, 348))));
  }

  @Test
  void asADetachedNrrd() throws Exception {
    Files.write(folder.resolve("scan.raw"), samples);
    String header =
        """
        NRRD0004
        type: unsigned short
        dimension: 3
        sizes: 256 256 113
        spacings: 1 1 2
        endian: little
        encoding: raw
        data file: scan.raw
        """;
    requireSame(open(Files.writeString(folder.resolve("scan.nhdr"), header)));
  }

  @ParameterizedTest
  @CsvSource({"scan.mha, false", "scan.mha, true", "scan.mhd, false", "scan.mhd, true"})
  void asAMetaImage(String name, boolean compressed) throws Exception {
    boolean local = name.endsWith(".mha");
    String header =
        """
        ObjectType = Image
        NDims = 3
        BinaryData = True
        BinaryDataByteOrderMSB = False
        CompressedData = %s
        ElementSpacing = 1 1 2
        DimSize = 256 256 113
        ElementType = MET_USHORT
        ElementDataFile = %s
        """
            .formatted(compressed ? "True" : "False", local ? "LOCAL" : "scan.data");
    Path file = Files.writeString(folder.resolve(name), header);
    Path data = local ? file : Files.createFile(folder.resolve("scan.data"));
    try (OutputStream out = Files.newOutputStream(data, java.nio.file.StandardOpenOption.APPEND);
        OutputStream coded = compressed ? new DeflaterOutputStream(out) : out) {
      coded.write(samples);
    }
    requireSame(open(file));
  }

  @Test
  void asATiffStackOfImagej() throws Exception {
    ImageStack stack = new ImageStack(EDGE, EDGE);
    ByteBuffer bytes = ByteBuffer.wrap(samples).order(ByteOrder.LITTLE_ENDIAN);
    for (int k = 0; k < SLICES; k++) {
      short[] pixels = new short[EDGE * EDGE];
      bytes
          .slice(k * SLICE_BYTES, SLICE_BYTES)
          .order(ByteOrder.LITTLE_ENDIAN)
          .asShortBuffer()
          .get(pixels);
      stack.addSlice("", pixels);
    }
    ImagePlus image = new ImagePlus("scan", stack);
    image.getCalibration().pixelDepth = 2;
    image.getCalibration().setUnit("mm");
    Path file = folder.resolve("scan.tif");
    assertTrue(new FileSaver(image).saveAsTiffStack(file.toString()));
    requireSame(open(file));
  }

  @Test
  void asADicomSeriesWhoseNamesAreInAnotherOrder() throws Exception {
    for (int k = 0; k < SLICES; k++) {
      byte[] pixels = Arrays.copyOfRange(samples, k * SLICE_BYTES, (k + 1) * SLICE_BYTES);
      Path file = folder.resolve("IM" + k * 37 % SLICES);
      DicomSliceWriter.slice(file, 2.0 * k, EDGE, EDGE, pixels);
    }
    requireSame(open(folder));
  }

  @ParameterizedTest
  @ValueSource(strings = {"u16le", "u16be"})
  void asARawFile(String type) throws Exception {
    byte[] bytes = samples.clone();
    if (type.equals("u16be")) {
      ByteBuffer.wrap(bytes)
          .asShortBuffer()
          .put(ByteBuffer.wrap(samples).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer());
    }
    Path file = Files.write(folder.resolve("scan.raw"), bytes);
    RawLayout layout = RawLayout.parse("256x256x113:" + type + ":1,1,2");
    requireSame(VolumeFiles.open(file, ReadOptions.defaults().withRaw(layout)));
  }

  private static VolumeReader open(Path file) throws VolumeFormatException {
    return VolumeFiles.open(file, ReadOptions.defaults());
  }

  private static void requireSame(VolumeReader read) throws IOException {
    assertEquals(1, read.header().grid().spacingMm().x);
    assertEquals(1, read.header().grid().spacingMm().y);
    assertEquals(2, read.header().grid().spacingMm().z);
    assertEquals(
        BONE_VOXELS,
        SegmentBuilder.read(read, List.of(SegmentSpec.atLeast("bone", 1500)))
            .segments()
            .get(0)
            .bits()
            .solidCount());
    assertEquals(VoxelCrc.of(scan), VoxelCrc.of(read));
  }
}
