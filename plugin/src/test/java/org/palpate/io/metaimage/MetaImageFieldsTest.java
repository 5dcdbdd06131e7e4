package org.palpate.io.metaimage;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.io.ReadVolumes.values;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.GreyVolumes;
import org.palpate.io.ReadVolumes;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelType;

class MetaImageFieldsTest {
  private static final byte[] DATA = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

  @TempDir private Path folder;

  /** Writes a header of 3 x 2 x 2 bytes with other or more fields, and its data. */
  private Path write(byte[] data, String... fields) throws IOException {
    Map<String, String> all = new LinkedHashMap<>();
    all.put("ObjectType", "Image");
    all.put("NDims", "3");
    all.put("DimSize", "3 2 2");
    all.put("ElementType", "MET_UCHAR");
    String dataFile = "LOCAL";
    for (String field : fields) {
      int equals = field.indexOf('=');
      String key = field.substring(0, equals);
      String value = field.substring(equals + 1);
      if (key.equals("ElementDataFile")) {
        dataFile = value;
      } else if (value.isEmpty()) {
        all.remove(key);
      } else {
        all.put(key, value);
      }
    }
    StringBuilder text = new StringBuilder();
    all.forEach((key, value) -> text.append(key).append(" = ").append(value).append('\n'));
    text.append("ElementDataFile = ").append(dataFile).append('\n');
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write(text.toString().getBytes(StandardCharsets.ISO_8859_1));
    bytes.write(data);
    return Files.write(folder.resolve("v.mha"), bytes.toByteArray());
  }

  private static VolumeReader open(Path file) throws VolumeFormatException {
    return MetaImageReader.open(file, ReadOptions.defaults());
  }

  private String refusal(byte[] data, String... fields) throws IOException {
    Path file = write(data, fields);
    return ReadVolumes.refusal(file, () -> open(file));
  }

  @Test
  void aPlainHeaderIsReadWithItsDefaults() throws IOException {
    VolumeReader reader = open(write(DATA));
    assertEquals("1 2 3 4 5 6 7 8 9 10 11 12", values(reader));
    assertEquals("MetaImage, raw", reader.header().format());
    assertEquals(CoordinateSystem.LPS, reader.header().coordinateSystem());
    assertEquals("(1.0, 1.0, 1.0)", reader.header().grid().spacingMm().toString());
    assertEquals(List.of(folder.resolve("v.mha")), reader.files());
    assertEquals(List.of(), reader.header().notes());
  }

  @ParameterizedTest
  @CsvSource({
    "MET_CHAR, INT8",
    "MET_ASCII_CHAR, INT8",
    "MET_UCHAR, UINT8",
    "MET_SHORT, INT16",
    "MET_USHORT, UINT16",
    "MET_INT, INT32",
    "MET_LONG, INT32",
    "MET_UINT, UINT32",
    "MET_ULONG, UINT32",
    "MET_LONG_LONG, INT64",
    "MET_ULONG_LONG, UINT64",
    "MET_FLOAT, FLOAT32",
    "MET_DOUBLE, FLOAT64"
  })
  void everyTypeIsKnownByItsName(String name, VoxelType type) throws IOException {
    byte[] data = new byte[12 * type.bytes()];
    VolumeReader reader = open(write(data, "ElementType=" + name));
    assertEquals(type, reader.header().type());
    assertEquals("0 0 0 0 0 0 0 0 0 0 0 0", values(reader));
  }

  @ParameterizedTest
  @CsvSource({
    "BinaryDataByteOrderMSB=True, 258",
    "BinaryDataByteOrderMSB=False, 513",
    "ElementByteOrderMSB=1, 258",
    "ElementByteOrderMSB=yes, 258",
    "Comment=none, 513"
  })
  void theByteOrderIsThatOfItsField(String field, int first) throws IOException {
    byte[] data = Arrays.copyOf(DATA, 24);
    VolumeReader reader = open(write(data, "ElementType=MET_USHORT", field));
    assertEquals(first, GreyVolumes.read(reader).value(0, 0, 0));
  }

  @Test
  void dataMayBeText() throws IOException {
    byte[] text = "1 2 3\n4 5 6\n7 8 9 10 11 12".getBytes(StandardCharsets.US_ASCII);
    VolumeReader reader = open(write(text, "BinaryData=False"));
    assertEquals("MetaImage, text", reader.header().format());
    assertEquals("1 2 3 4 5 6 7 8 9 10 11 12", values(reader));
    assertTrue(
        refusal("1 2 3".getBytes(StandardCharsets.US_ASCII), "BinaryData=False", "DimSize=99 9 9")
            .startsWith("the header promises 8019 values but the file has "));
  }

  @Test
  void dataMayBeCompressed() throws IOException {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (OutputStream out = new DeflaterOutputStream(packed)) {
      out.write(DATA);
    }
    VolumeReader reader = open(write(packed.toByteArray(), "CompressedData=True"));
    assertEquals("MetaImage, compressed", reader.header().format());
    assertEquals("1 2 3 4 5 6 7 8 9 10 11 12", values(reader));
  }

  @Test
  void dataMayLieInOtherFiles() throws IOException {
    Files.write(folder.resolve("d.raw"), new byte[] {9, 9, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    String expected = "1 2 3 4 5 6 7 8 9 10 11 12";
    VolumeReader skipped = open(write(new byte[0], "ElementDataFile=d.raw", "HeaderSize=2"));
    assertEquals(expected, values(skipped));
    assertEquals(2, skipped.files().size());
    VolumeReader atEnd = open(write(new byte[0], "ElementDataFile=d.raw", "HeaderSize=-1"));
    assertEquals(expected, values(atEnd));
    Files.write(folder.resolve("s1.raw"), Arrays.copyOf(DATA, 6));
    Files.write(folder.resolve("s2.raw"), Arrays.copyOfRange(DATA, 6, 12));
    assertEquals(expected, values(open(write(new byte[0], "ElementDataFile=s%d.raw 1 2 1"))));
    byte[] list = "s1.raw\ns2.raw\n\nd.raw".getBytes(StandardCharsets.US_ASCII);
    VolumeReader listed = open(write(list, "ElementDataFile=LIST"));
    assertEquals(expected, values(listed));
    assertEquals(3, listed.files().size());
  }

  @ParameterizedTest
  @CsvSource({
    "Offset, TransformMatrix, ElementSpacing",
    "Position, Rotation, ElementSize",
    "Origin, Orientation, ElementSpacing"
  })
  void thePositionHasSeveralNames(String offset, String matrix, String spacing) throws IOException {
    VolumeReader reader =
        open(
            write(
                DATA, offset + "=10 20 30", matrix + "=0 1 0 -1 0 0 0 0 1", spacing + "=0.5 2 3"));
    Vec3 at = reader.header().grid().gridToWorld(new Vec3(1.5, 1.5, 1.5), new Vec3());
    assertEquals("(8.0, 20.5, 33.0)", at.toString());
    assertEquals("(0.5, 2.0, 3.0)", reader.header().grid().spacingMm().toString());
  }

  @Test
  void aNegativeSpacingRunsBackwardAndIsNoted() throws IOException {
    VolumeReader reader = open(write(DATA, "ElementSpacing=1 -2 1"));
    assertEquals(-2, reader.header().grid().gridToWorld(new Vec3(0.5, 1.5, 0.5), new Vec3()).y);
    assertEquals(
        List.of("the spacing along y is stated as -2: that axis runs backward"),
        reader.header().notes());
  }

  @Test
  void aSingleSliceIsAsDeepAsItsPixelsAreWide() throws IOException {
    VolumeReader reader =
        open(write(Arrays.copyOf(DATA, 6), "NDims=2", "DimSize=3 2", "ElementSpacing=0.5 0.7"));
    assertEquals("(0.5, 0.7, 0.5)", reader.header().grid().spacingMm().toString());
    assertEquals(
        List.of("a single slice: the slice spacing is taken to be the pixel spacing"),
        reader.header().notes());
  }

  @Test
  void channelsAndTimesAreChosen() throws IOException {
    Path channels = write(DATA, "DimSize=3 2 1", "ElementNumberOfChannels=2");
    assertEquals(
        "the file has 2 channels (numbers in a voxel): "
            + channels
            + ": choose one with --time 0 to --time 1",
        assertThrows(VolumeFormatException.class, () -> open(channels)).getMessage());
    VolumeReader second = MetaImageReader.open(channels, ReadOptions.defaults().withTimeStep(1));
    assertEquals(4, GreyVolumes.read(second).value(1, 0, 0), "2 4 6 8 10 12");
    Path times = write(DATA, "NDims=4", "DimSize=3 1 2 2");
    VolumeReader last = MetaImageReader.open(times, ReadOptions.defaults().withTimeStep(1));
    assertEquals(7, GreyVolumes.read(last).value(0, 0, 0));
    assertEquals(
        "the file has both several time steps and several channels",
        refusal(DATA, "NDims=4", "DimSize=3 1 1 2", "ElementNumberOfChannels=2"));
  }

  @Test
  void anIntensityFunctionIsNotedAndNotUsed() throws IOException {
    VolumeReader reader = open(write(DATA, "ElementToIntensityFunctionSlope=2"));
    assertEquals(1, GreyVolumes.read(reader).value(0, 0, 0));
    assertEquals(
        List.of(
            "the values are the stored ones, as in ITK: the header's intensity function, 2 times"
                + " the value plus 0, is not applied"),
        reader.header().notes());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "NDims=5|the NDims is '5', not 2, 3 or 4",
        "NDims=|the header has no 'NDims'",
        "DimSize=|the header has no 'DimSize'",
        "DimSize=3 2|the DimSize has 2 numbers, not 3",
        "DimSize=3 2 0|the DimSize is '3 2 0'",
        "DimSize=3 2 1.5|the DimSize is '3 2 1.5'",
        "DimSize=3 2 x|'x' in the field DimSize is no finite number",
        "ElementType=|the header has no 'ElementType'",
        "ElementType=MET_OTHER|the type 'MET_OTHER' is no type of number",
        "ElementNumberOfChannels=0|the ElementNumberOfChannels is no positive number",
        "ElementSpacing=1 1|the ElementSpacing has 2 numbers, not 3",
        "TransformMatrix=1 0 0 0 1 0|the TransformMatrix has 6 numbers, not 9",
        "Offset=0 0 nan|'nan' in the field Offset is no finite number",
        "ElementDataFile=LIST|the list of data files is empty",
        "ElementDataFile=none.raw|the data file 'none.raw' is missing",
        "DimSize=3 2 3|the header promises 18 bytes of data but the file has 12",
        "ObjectType=Tube|the ObjectType \"Tube\" is no image"
      })
  void aFieldThatCannotBeIsRefused(String field, String what) throws IOException {
    byte[] data = field.equals("ElementDataFile=LIST") ? new byte[0] : DATA;
    assertEquals(what, refusal(data, field));
  }

  @ParameterizedTest
  @CsvSource({"-2", "1.5", "x"})
  void aHeaderSizeIsAWholeNumber(String size) throws IOException {
    Files.write(folder.resolve("d.raw"), DATA);
    assertEquals(
        "the HeaderSize is '" + size + "'",
        refusal(new byte[0], "ElementDataFile=d.raw", "HeaderSize=" + size));
  }

  @Test
  void aLineThatIsNoFieldIsShown() throws IOException {
    Path file = folder.resolve("v.mha");
    Files.writeString(file, "ObjectType = Image\n" + "x".repeat(70) + "\n");
    assertEquals(
        "the line '"
            + "x".repeat(60)
            + "...' of the header is no field: "
            + file
            + ": export the file again",
        assertThrows(VolumeFormatException.class, () -> open(file)).getMessage());
  }

  @Test
  void aFileIsKnownByItsNameOrItsFirstField() {
    byte[] start = "Comment = x\n".getBytes(StandardCharsets.US_ASCII);
    assertTrue(MetaImageReader.accepts(start, Path.of("v.bin")));
    assertTrue(MetaImageReader.accepts(new byte[0], Path.of("v.MHD")));
    assertFalse(
        MetaImageReader.accepts("NRRD0004".getBytes(StandardCharsets.US_ASCII), Path.of("v")));
    assertFalse(MetaImageReader.accepts(new byte[8], Path.of("v.raw")));
  }
}
