package org.palpate.io.metaimage;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberParser;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.ConcatenatedInputStream;
import org.palpate.io.format.FilePattern;
import org.palpate.io.format.Grids;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.NonSpatialAxis;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.format.SampleStream;
import org.palpate.io.format.Scaling;
import org.palpate.io.format.StreamVolumeReader;
import org.palpate.io.format.TextSampleStream;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

/**
 * Reads MetaImage: {@code .mha}, or {@code .mhd} with its data in other files. World coordinates
 * are LPS, as in ITK.
 *
 * <p>Source: MetaIO documentation, itk.org/Wiki/MetaIO/Documentation.
 */
public final class MetaImageReader {
  private final MetaImageHeader header;
  private final ReadOptions options;
  private final List<String> notes = new ArrayList<>();
  private int[] sizes;
  private int channels;

  private MetaImageReader(MetaImageHeader header, ReadOptions options) {
    this.header = header;
    this.options = options;
  }

  /** Returns whether a file with these first bytes or this name is a MetaImage file. */
  public static boolean accepts(byte[] start, Path file) {
    return InputFiles.hasEnding(file, ".mha", ".mhd") || MetaImageHeader.isMetaImage(start);
  }

  /**
   * Opens a file.
   *
   * @throws VolumeFormatException if the file is damaged, cannot be decoded, or needs another
   *     option
   */
  public static VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException {
    return new MetaImageReader(MetaImageHeader.read(file), options).open();
  }

  private VolumeReader open() throws VolumeFormatException {
    VoxelType type = type();
    noteIntensityFunction();
    noteUnit();
    sizes = sizes();
    channels = NumberParser.positiveInt(header.first("1", "ElementNumberOfChannels"));
    if (channels < 1) {
      throw header.refusal("the ElementNumberOfChannels is no positive number");
    }
    NonSpatialAxis extra = extra();
    VoxelGrid grid = grid();
    List<Path> dataFiles = dataFiles();
    boolean text = !header.isTrue("BinaryData") && header.fields().containsKey("BinaryData");
    BinaryData data = data(dataFiles, type, text);
    SampleStream.Opener opener = text ? () -> new TextSampleStream(textStream(data), type) : data;
    VolumeHeader described =
        new VolumeHeader(
            "MetaImage, " + (text ? "text" : data.start().deflated() ? "compressed" : "raw"),
            grid,
            type,
            ValueRange.of(type),
            CoordinateSystem.LPS,
            Optional.empty(),
            notes);
    return new StreamVolumeReader(described, files(dataFiles), opener, extra, options.progress());
  }

  private InputStream textStream(BinaryData data) throws IOException {
    long offset = data.start().offset();
    return new ConcatenatedInputStream(
        data.files(), file -> InputFiles.open(file, offset), Long.MAX_VALUE);
  }

  /** Notes a rescaling that the header states; it is left out, as ITK does. */
  private void noteIntensityFunction() {
    String slope = header.first("1", "ElementToIntensityFunctionSlope");
    String offset = header.first("0", "ElementToIntensityFunctionOffset");
    if (NumberParser.number(slope) != 1 || NumberParser.number(offset) != 0) {
      notes.add(
          "the values are the stored ones, as in ITK: the header's intensity function, "
              + slope
              + " times the value plus "
              + offset
              + ", is not applied");
    }
  }

  /** Notes a unit of length that the header states; it is left out, as ITK does. */
  private void noteUnit() {
    String unit = header.first("mm", "DistanceUnits");
    if (!unit.equalsIgnoreCase("mm") && !unit.equals("?")) {
      notes.add(
          "lengths are taken as mm, as in ITK: the DistanceUnits '" + unit + "' are not used");
    }
  }

  private List<Path> files(List<Path> dataFiles) {
    List<Path> files = new ArrayList<>();
    files.add(header.file());
    if (!isLocal()) {
      files.addAll(dataFiles);
    }
    return files;
  }

  private boolean isLocal() {
    return header.first("", "ElementDataFile").equalsIgnoreCase("LOCAL");
  }

  private int[] sizes() throws VolumeFormatException {
    int dimension = NumberParser.positiveInt(header.required("NDims"));
    if (dimension < 2 || dimension > 4) {
      throw header.refusal("the NDims is '" + header.required("NDims") + "', not 2, 3 or 4");
    }
    double[] numbers = numbers(header.required("DimSize"), dimension, "DimSize");
    int[] result = new int[dimension];
    for (int axis = 0; axis < dimension; axis++) {
      result[axis] = (int) numbers[axis];
      if (result[axis] < 1 || result[axis] != numbers[axis]) {
        throw header.refusal("the DimSize is '" + header.required("DimSize") + "'");
      }
    }
    return result;
  }

  private NonSpatialAxis extra() throws VolumeFormatException {
    int steps = sizes.length > 3 ? sizes[3] : 1;
    if (steps > 1 && channels > 1) {
      throw header.refusal("the file has both several time steps and several channels");
    }
    int count = Math.max(steps, channels);
    String what = count + (channels > 1 ? " channels (numbers in a voxel)" : " times");
    int step = ReadOptionChecks.chosenStep(count, what, options, header.file(), notes);
    return count == 1 ? NonSpatialAxis.NONE : new NonSpatialAxis(channels > 1 ? 0 : 3, count, step);
  }

  private VoxelGrid grid() throws VolumeFormatException {
    int n = sizes.length;
    double[] spacing = optional(n, 1, "ElementSpacing", "ElementSize");
    double[] origin = optional(n, 0, "Offset", "Position", "Origin");
    String matrixText = header.first("", "TransformMatrix", "Rotation", "Orientation");
    double[] matrix = matrixText.isEmpty() ? null : numbers(matrixText, n * n, "TransformMatrix");
    Vec3[] steps = Grids.steps(new Vec3(1, 1, spacing[0]));
    for (int axis = 0; axis < Math.min(3, n); axis++) {
      Vec3 direction = new Vec3();
      for (int c = 0; c < Math.min(3, n); c++) {
        direction.set(c, matrix == null ? (c == axis ? 1 : 0) : matrix[axis * n + c]);
      }
      steps[axis] = direction.mul(spacing[axis], direction);
      if (spacing[axis] < 0) {
        notes.add(Grids.negativeSpacing(axis, spacing[axis], Grids.RUNS_BACKWARD));
      }
    }
    if (n == 2) {
      notes.add("a single slice: the slice spacing is taken to be the pixel spacing");
    }
    int[] three = {sizes[0], sizes[1], n > 2 ? sizes[2] : 1};
    return Grids.of(
        three, steps, new Vec3(origin[0], origin[1], n > 2 ? origin[2] : 0), header.file());
  }

  private double[] optional(int count, double fallback, String... keys)
      throws VolumeFormatException {
    String text = header.first("", keys);
    if (text.isEmpty()) {
      double[] numbers = new double[count];
      Arrays.fill(numbers, fallback);
      return numbers;
    }
    return numbers(text, count, keys[0]);
  }

  private double[] numbers(String text, int count, String key) throws VolumeFormatException {
    String[] words = text.strip().split("\\s+", -1);
    if (words.length != count) {
      throw header.refusal("the " + key + " has " + words.length + " numbers, not " + count);
    }
    double[] numbers = new double[count];
    for (int n = 0; n < count; n++) {
      numbers[n] = NumberParser.number(words[n]);
      if (!Double.isFinite(numbers[n])) {
        throw header.refusal("'" + words[n] + "' in the field " + key + " is no finite number");
      }
    }
    return numbers;
  }

  private List<Path> dataFiles() throws VolumeFormatException {
    String value = header.required("ElementDataFile");
    if (isLocal()) {
      return List.of(header.file());
    }
    List<String> names =
        value.startsWith("LIST") ? header.dataList() : FilePattern.names(header.file(), value);
    if (names.isEmpty()) {
      throw header.refusal("the list of data files is empty");
    }
    List<Path> files = new ArrayList<>();
    for (String name : names) {
      files.add(InputFiles.resolveBeside(header.file(), name));
    }
    return files;
  }

  private BinaryData data(List<Path> files, VoxelType type, boolean text)
      throws VolumeFormatException {
    double bytes = (double) type.bytes() * channels;
    long exact = (long) type.bytes() * channels;
    for (int size : sizes) {
      bytes *= size;
      exact *= size;
    }
    if (bytes > 0x1p60) {
      throw header.refusal("the sizes make more than 2^60 bytes");
    }
    boolean msb = header.isTrue("BinaryDataByteOrderMSB", "ElementByteOrderMSB");
    BinaryData.Start start =
        new BinaryData.Start(offset(), header.isTrue("CompressedData") && !text, false);
    ByteOrder order = msb ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    BinaryData data = new BinaryData(files, start, type, order, Scaling.NONE, exact);
    if (text) {
      requireText(files, exact / type.bytes());
    } else {
      data.requireFileLengths();
    }
    return data;
  }

  /** Refuses text that is too short: each value takes a digit and, except the last, a separator. */
  private void requireText(List<Path> files, long samples) throws VolumeFormatException {
    long length = 0;
    for (Path file : files) {
      length += InputFiles.length(file);
    }
    if (samples > length / 2 + 1) {
      throw new VolumeFormatException(
          "the header promises "
              + samples
              + " values but the file has "
              + length
              + " bytes of text",
          header.file(),
          "copy the file again; if that does not help, export it again");
    }
  }

  private long offset() throws VolumeFormatException {
    if (isLocal()) {
      return header.dataOffset();
    }
    String text = header.first("0", "HeaderSize");
    double skip = NumberParser.number(text);
    if (!(skip >= -1) || skip != Math.rint(skip) || skip > 0x1p53) {
      throw header.refusal("the HeaderSize is '" + text + "'");
    }
    return (long) skip;
  }

  private VoxelType type() throws VolumeFormatException {
    String name = header.required("ElementType");
    return switch (name) {
      case "MET_CHAR", "MET_ASCII_CHAR" -> VoxelType.INT8;
      case "MET_UCHAR" -> VoxelType.UINT8;
      case "MET_SHORT" -> VoxelType.INT16;
      case "MET_USHORT" -> VoxelType.UINT16;
      case "MET_INT", "MET_LONG" -> VoxelType.INT32; // the format's long has 4 bytes
      case "MET_UINT", "MET_ULONG" -> VoxelType.UINT32;
      case "MET_LONG_LONG" -> VoxelType.INT64;
      case "MET_ULONG_LONG" -> VoxelType.UINT64;
      case "MET_FLOAT" -> VoxelType.FLOAT32;
      case "MET_DOUBLE" -> VoxelType.FLOAT64;
      default -> throw header.refusal("the type '" + name + "' is no type of number");
    };
  }
}
