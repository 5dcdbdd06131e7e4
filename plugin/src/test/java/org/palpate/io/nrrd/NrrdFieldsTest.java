package org.palpate.io.nrrd;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.io.ReadVolumes.values;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.GZIPOutputStream;
import org.apache.commons.compress.compressors.bzip2.BZip2CompressorOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.GreyVolumes;
import org.palpate.io.ReadVolumes;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

class NrrdFieldsTest {
  private static final byte[] DATA = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  private static final String VALUES = "1 2 3 4 5 6 7 8 9 10 11 12";

  @TempDir private Path folder;

  /** Writes a header of 3 x 2 x 2 bytes with other or more lines, and its data. */
  private Path write(byte[] data, String... lines) throws IOException {
    Map<String, String> all = new LinkedHashMap<>();
    all.put("type", "uint8");
    all.put("dimension", "3");
    all.put("sizes", "3 2 2");
    all.put("encoding", "raw");
    StringBuilder pairs = new StringBuilder();
    for (String line : lines) {
      int colon = line.indexOf(':');
      if (line.startsWith(":=", colon)) {
        pairs.append(line).append('\n');
      } else if (colon == line.length() - 1) {
        all.remove(line.substring(0, colon));
      } else {
        all.put(line.substring(0, colon), line.substring(colon + 1).strip());
      }
    }
    StringBuilder text = new StringBuilder("NRRD0004\n# a remark\n");
    all.forEach((name, value) -> text.append(name).append(": ").append(value).append('\n'));
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write((text.append(pairs) + "\n").getBytes(StandardCharsets.UTF_8));
    bytes.write(data);
    return Files.write(folder.resolve("v.nrrd"), bytes.toByteArray());
  }

  private static VolumeReader open(Path file) throws VolumeFormatException {
    return NrrdReader.open(file, ReadOptions.defaults());
  }

  private String refusal(byte[] data, String... lines) throws IOException {
    Path file = write(data, lines);
    return ReadVolumes.refusal(file, () -> open(file));
  }

  private static Vec3 centre(VolumeReader reader, double i, double j, double k) {
    return reader.header().grid().gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
  }

  @Test
  void aPlainHeaderIsReadWithItsDefaults() throws IOException {
    VolumeReader reader = open(write(DATA));
    assertEquals(VALUES, values(reader));
    assertEquals("NRRD, raw", reader.header().format());
    assertEquals(CoordinateSystem.UNKNOWN, reader.header().coordinateSystem());
    assertEquals(
        List.of(
            "no spacing along x: 1 mm assumed",
            "no spacing along y: 1 mm assumed",
            "no spacing along z: 1 mm assumed"),
        reader.header().notes());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "signed char|INT8",
        "int8_t|INT8",
        "unsigned char|UINT8",
        "UCHAR|UINT8",
        "short int|INT16",
        "signed  short|INT16",
        "ushort|UINT16",
        "unsigned short int|UINT16",
        "signed int|INT32",
        "int32|INT32",
        "uint|UINT32",
        "uint32_t|UINT32",
        "long long int|INT64",
        "signed long long|INT64",
        "ulonglong|UINT64",
        "unsigned long long int|UINT64",
        "float|FLOAT32",
        "double|FLOAT64"
      })
  void everyNameOfATypeIsKnown(String name, VoxelType type) throws IOException {
    byte[] data = new byte[12 * type.bytes()];
    assertEquals(type, open(write(data, "type:" + name, "endian:big")).header().type());
  }

  @ParameterizedTest
  @CsvSource({"big, 258", "little, 513", "LITTLE, 513"})
  void theByteOrderIsStated(String endian, int first) throws IOException {
    byte[] data = Arrays.copyOf(DATA, 24);
    VolumeReader reader = open(write(data, "type:ushort", "endian:" + endian));
    assertEquals(first, GreyVolumes.read(reader).value(0, 0, 0));
  }

  @Test
  void everyEncodingGivesTheSameValues() throws IOException {
    byte[] text = "1 2 3 4 5 6\n7 8 9 10 11 12".getBytes(StandardCharsets.US_ASCII);
    byte[] hex = "0102 0304 05060708 090A0b0c".getBytes(StandardCharsets.US_ASCII);
    ByteArrayOutputStream gzip = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(gzip)) {
      out.write(DATA);
    }
    ByteArrayOutputStream bzip2 = new ByteArrayOutputStream();
    try (OutputStream out = new BZip2CompressorOutputStream(bzip2)) {
      out.write(DATA);
    }
    for (String name : List.of("ascii", "txt", "text")) {
      assertEquals(VALUES, values(open(write(text, "encoding:" + name))), name);
    }
    assertEquals("NRRD, hexadecimal", open(write(hex, "encoding:hex")).header().format());
    assertEquals(VALUES, values(open(write(hex, "encoding:hex"))));
    assertEquals(VALUES, values(open(write(gzip.toByteArray(), "encoding:gz"))));
    assertEquals(VALUES, values(open(write(gzip.toByteArray(), "encoding:gzip"))));
    assertEquals(VALUES, values(open(write(bzip2.toByteArray(), "encoding:bzip2"))));
    VolumeReader packed = open(write(gzip.toByteArray(), "encoding:gzip", "byte skip:-1"));
    assertEquals(VALUES, values(packed));
  }

  @Test
  void linesAndBytesBeforeTheDataAreSkipped() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write("one\ntwo\n".getBytes(StandardCharsets.US_ASCII));
    bytes.write(new byte[] {9, 9, 9});
    bytes.write(DATA);
    byte[] all = bytes.toByteArray();
    assertEquals(VALUES, values(open(write(all, "line skip:2", "byte skip:3"))));
    assertEquals(VALUES, values(open(write(all, "byte skip:11"))));
    assertEquals(VALUES, values(open(write(all, "byteskip:-1"))));
    VolumeReader few = open(write(DATA, "line skip:3"));
    assertTrue(
        assertThrows(VolumeFormatException.class, () -> values(few))
            .getMessage()
            .startsWith("the file has fewer than the 3 lines to skip: "));
  }

  @Test
  void dataMayLieInOtherFiles() throws IOException {
    Files.write(folder.resolve("a1.raw"), Arrays.copyOf(DATA, 6));
    Files.write(folder.resolve("a2.raw"), Arrays.copyOfRange(DATA, 6, 12));
    VolumeReader pattern = open(write(new byte[0], "data file:a%d.raw 1 2 1"));
    assertEquals(VALUES, values(pattern));
    assertEquals(3, pattern.files().size());
    Path listed = folder.resolve("l.nhdr");
    Files.writeString(
        listed,
        """
        NRRD0004
        type: uint8
        dimension: 3
        sizes: 3 2 2
        encoding: raw
        datafile: LIST
        a1.raw
        a2.raw
        """);
    assertEquals(VALUES, values(open(listed)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "left-posterior-superior|LPS",
        "LPS|LPS",
        "right-anterior-superior|RAS",
        "ras|RAS",
        "LAS|LAS",
        "3D-right-handed|UNKNOWN",
        "scanner-xyz|UNKNOWN"
      })
  void theSpaceNamesTheWorld(String space, CoordinateSystem world) throws IOException {
    VolumeReader reader =
        open(
            write(
                DATA,
                "space:" + space,
                "space directions:(0,0.5,0) (-2,0,0) (0,0,3)",
                "space origin:(1,2,3)"));
    assertEquals(world, reader.header().coordinateSystem());
    assertEquals("(-1.0, 2.5, 6.0)", centre(reader, 1, 1, 1).toString());
    assertEquals(List.of(), reader.header().notes());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "spacings:0.5 2 3|cell|0.5 2.0 3.0|0.0 0.0 0.0",
        "spacings:0.5 2 3|node|0.5 2.0 3.0|0.0 0.0 0.0",
        "axis mins:10 20 30;axis maxs:13 24 36|cell|1.0 2.0 3.0|10.5 21.0 31.5",
        "axis mins:10 20 30;axis maxs:12 22 33|node|1.0 2.0 3.0|10.0 20.0 30.0",
        "axismins:10 20 30;spacings:1 2 3|cell|1.0 2.0 3.0|10.5 21.0 31.5"
      })
  void cellsAndNodesLieWhereTheirAxesSay(
      String lines, String centering, String spacing, String first) throws IOException {
    List<String> all = new ArrayList<>(List.of(lines.split(";", -1)));
    all.add("centerings:" + (centering + " ").repeat(3));
    VolumeReader reader = open(write(DATA, all.toArray(new String[0])));
    Vec3 edges = reader.header().grid().spacingMm();
    assertEquals(spacing, edges.x + " " + edges.y + " " + edges.z);
    Vec3 at = centre(reader, 0, 0, 0);
    assertEquals(first, at.x + " " + at.y + " " + at.z);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {"mm|1", "cm|10", "m|1000", "um|0.001", "microns|0.001", "nm|0.000001", "'???'|1"})
  void aUnitOfLengthIsConverted(String unit, double mm) throws IOException {
    String quoted = "\"" + unit + "\"";
    VolumeReader ofSpace =
        open(
            write(
                DATA,
                "space:lps",
                "space directions:(2,0,0) (0,2,0) (0,0,2)",
                "space origin:(1,1,1)",
                "space units:" + quoted + " " + quoted + " " + quoted));
    assertEquals(2 * mm, ofSpace.header().grid().spacingMm().x, 1e-12 * mm);
    assertEquals(mm, centre(ofSpace, 0, 0, 0).x, 1e-9 * mm);
    VolumeReader ofAxes =
        open(write(DATA, "spacings:2 2 2", "units:" + quoted + " " + quoted + " " + quoted));
    assertEquals(2 * mm, ofAxes.header().grid().spacingMm().z, 1e-12 * mm);
  }

  @Test
  void aNegativeSpacingRunsBackwardAndIsNoted() throws IOException {
    VolumeReader reader = open(write(DATA, "spacings:1 -2 1"));
    assertEquals(-2, centre(reader, 0, 1, 0).y);
    assertEquals(
        List.of("the spacing along y is stated as -2: that axis runs backward"),
        reader.header().notes());
  }

  @Test
  void aSingleSliceIsAsDeepAsItsPixelsAreWide() throws IOException {
    VolumeReader reader =
        open(write(Arrays.copyOf(DATA, 6), "dimension:2", "sizes:3 2", "spacings:0.5 0.7"));
    assertEquals("(0.5, 0.7, 0.5)", reader.header().grid().spacingMm().toString());
    assertEquals(
        "a single slice: the slice spacing is taken to be the pixel spacing",
        reader.header().notes().get(0));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "domain domain domain time|3 1 2 2|the file has 2 times",
        "domain domain domain list|3 1 2 2|the file has a list of 2 volumes",
        "stub domain domain domain|2 3 1 2|the file has 2 time steps or components"
      })
  void aStepIsChosenAmongSeveral(String kinds, String sizes, String what) throws IOException {
    Path file = write(DATA, "dimension:4", "sizes:" + sizes, "kinds:" + kinds);
    assertTrue(
        assertThrows(VolumeFormatException.class, () -> open(file)).getMessage().startsWith(what));
    VolumeReader second = NrrdReader.open(file, ReadOptions.defaults().withTimeStep(1));
    assertEquals(kinds.startsWith("stub") ? "2 4 6 8 10 12" : "7 8 9 10 11 12", values(second));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "vector|the voxels are vectors of 3 numbers (kind vector), not the values of a scan",
        "3-gradient|the voxels are vectors of 3 numbers (kind 3-gradient), not the values of a"
            + " scan",
        "3d-matrix|the voxels are vectors of 3 numbers (kind 3d-matrix), not the values of a scan",
        "hsv-color|the voxels are colours of 3 numbers (kind hsv-color), not the values of a scan"
      })
  void numbersThatAreNoValuesAreRefused(String kind, String what) throws IOException {
    assertEquals(
        what,
        refusal(DATA, "dimension:4", "sizes:3 2 2 1", "kinds:" + kind + " domain domain domain"));
  }

  @Test
  void coloursAreReadAsLuminance() throws IOException {
    byte[] data = {10, 20, 30, (byte) 255, (byte) 255, (byte) 255};
    VolumeReader reader =
        open(write(data, "dimension:4", "sizes:3 2 1 1", "kinds:RGB-color domain domain domain"));
    assertEquals("18 255", values(reader));
    assertEquals(
        "the voxels are colours of signed 8 bit",
        refusal(
            data,
            "type:int8",
            "dimension:4",
            "sizes:3 2 1 1",
            "kinds:RGB-color domain domain domain"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "dimension:|the header has no 'dimension'",
        "dimension:17|the dimension is '17'",
        "dimension:x|the dimension is 'x'",
        "dimension:2|the dimension is 2 but there are 3 sizes",
        "sizes:3 2 0|the size along axis 2 is '0'",
        "sizes:2147483647 2147483647 2147483647|the sizes make more than 2^60 voxels",
        "type:|the header has no 'type'",
        "type:block|the type 'block' is no type of number",
        "type:short|the header does not say the byte order ('endian')",
        "endian:middle|the endian 'middle' is neither little nor big",
        "encoding:|the header has no 'encoding'",
        "encoding:zip|the encoding 'zip' is unknown",
        "line skip:-1|the 'line skip' is '-1'",
        "byte skip:x|the 'byte skip' is 'x'",
        "space:moon|the space 'moon' is unknown or has not three axes",
        "space directions:(1,0,0) (0,1,0)|the dimension is 3 but there are 2 space directions",
        "space directions:(1,0) (0,1,0) (0,0,1)|the vector (1,0) has 2 numbers, not 3",
        "spacings:1 x 1|the spacing along axis 1 is no number",
        "units:\"inch\" \"mm\" \"mm\"|the unit of length 'inch' is unknown",
        "kinds:time time domain|the file has 1 spatial axes",
        "sizes:3 2 3|the header promises 18 bytes of data but the file has 12"
      })
  void aFieldThatCannotBeIsRefused(String line, String what) throws IOException {
    assertEquals(what, refusal(DATA, line));
  }

  @Test
  void namesOfSegmentsAndLayersComeFromThePairs() throws IOException {
    String[] one = {
      "Segment0_ID:=a",
      "Segment0_Name:=Left Jaw",
      "Segment0_LabelValue:=7",
      "Segment0_Color:=1 0.5 0",
      "Segment1_ID:=b",
      "Segment1_LabelValue:=2",
      "Segment1_Color:=red",
      "Segment2_ID:=c",
      "Segment2_LabelValue:=-4"
    };
    LabelTable table = open(write(DATA, one)).header().labels().orElseThrow();
    assertTrue(table.isComplete());
    assertEquals(
        Map.of(7L, new Label("Left Jaw", 0xFF8000), 2L, new Label("segment 2", 0xFFFFFF)),
        table.labels());
    assertEquals(Optional.empty(), open(write(DATA)).header().labels());
  }

  @ParameterizedTest
  @CsvSource({"'list domain domain domain', '2 3 2 1'", "'domain domain domain list', '3 2 1 2'"})
  void segmentsOfTwoLayersMayOverlap(String kinds, String sizes) throws IOException {
    boolean first = kinds.startsWith("list");
    byte[] data =
        first
            ? new byte[] {0, 0, 1, 0, 1, 1, 0, 1, 5, 0, 0, 0}
            : new byte[] {0, 1, 1, 0, 5, 0, 0, 0, 1, 1, 0, 0};
    VolumeReader reader =
        open(
            write(
                data,
                "dimension:4",
                "sizes:" + sizes,
                "kinds:" + kinds,
                "Segment0_ID:=a",
                "Segment0_LabelValue:=1",
                "Segment0_Layer:=0",
                "Segment1_ID:=b",
                "Segment1_LabelValue:=1",
                "Segment1_Layer:=1"));
    List<String> layers = new ArrayList<>();
    reader.readLayers((k, slice) -> layers.add(Arrays.toString(slice.integers())));
    assertEquals(
        List.of("[0, 1, 1, 0, 0, 0]", "[0, 0, 2, 2, 0, 0]"),
        layers,
        "label 5 belongs to no segment");
    assertEquals("0 1 2 2 0 0", values(reader), "the last layer counts");
    assertEquals(2, reader.header().labels().orElseThrow().labels().size());
  }

  @ParameterizedTest
  @EnumSource(CoordinateSystem.class)
  void aWrittenHeaderIsReadBack(CoordinateSystem world) throws IOException {
    RigidTransform pose =
        new RigidTransform(
            new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(1, 2, 3));
    VolumeHeader written =
        new VolumeHeader(
            "test",
            new VoxelGrid(3, 2, 2, new Vec3(0.5, 2, 3), pose),
            VoxelType.UINT8,
            ValueRange.of(VoxelType.UINT8),
            world,
            Optional.of(new LabelTable(Map.of(3L, new Label("two\nlines", 0x336699)))),
            List.of());
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write(NrrdHeaderWriter.of(written, VoxelType.UINT8));
    try (OutputStream out = new GZIPOutputStream(bytes)) {
      out.write(DATA);
    }
    VolumeReader read = open(Files.write(folder.resolve("w.nrrd"), bytes.toByteArray()));
    assertEquals(VALUES, values(read));
    assertEquals(world, read.header().coordinateSystem());
    assertEquals("(0.5, 2.0, 3.0)", read.header().grid().spacingMm().toString());
    Vec3 apart =
        centre(read, 1, 1, 1)
            .sub(written.grid().gridToWorld(new Vec3(1.5, 1.5, 1.5), new Vec3()), new Vec3());
    assertEquals(0, apart.length(), 1e-12);
    assertEquals(
        new Label("two lines", 0x336699), read.header().labels().orElseThrow().labels().get(3L));
  }
}
