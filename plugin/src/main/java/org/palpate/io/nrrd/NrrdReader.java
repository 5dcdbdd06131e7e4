package org.palpate.io.nrrd;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.palpate.io.format.StreamVolumeReader;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelType;

/**
 * Reads NRRD, attached or detached.
 *
 * <p>Source: Definition of NRRD File Format, teem.sourceforge.net/nrrd/format.html.
 */
public final class NrrdReader {
  private NrrdReader() {}

  /** Returns whether a file with these first bytes is a NRRD file. */
  public static boolean accepts(byte[] start, Path file) {
    return NrrdHeader.isNrrd(start);
  }

  /**
   * Opens a file.
   *
   * @throws VolumeFormatException if the file is damaged, cannot be decoded, or needs another
   *     option
   */
  public static VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException {
    NrrdHeader header = NrrdHeader.read(file);
    VoxelType type = type(header);
    NrrdAxes axes = NrrdAxes.of(header, options);
    NrrdData data = NrrdData.of(header, type, axes.sampleCount());
    VolumeHeader described =
        new VolumeHeader(
            "NRRD, " + data.encoding().description(),
            axes.grid(),
            type,
            ValueRange.of(type),
            axes.coordinateSystem(),
            SlicerLabels.of(header),
            axes.notes());
    return new StreamVolumeReader(
        described, files(header, data), data, axes.extra(), options.progress());
  }

  private static List<Path> files(NrrdHeader header, NrrdData data) {
    if (data.isAttached()) {
      return List.of(header.file());
    }
    return java.util.stream.Stream.concat(
            java.util.stream.Stream.of(header.file()), data.files().stream())
        .toList();
  }

  private static VoxelType type(NrrdHeader header) throws VolumeFormatException {
    String name = header.required("type").toLowerCase(Locale.ROOT);
    return switch (name.replaceAll("\\s+", " ")) {
      case "signed char", "int8", "int8_t" -> VoxelType.INT8;
      case "uchar", "unsigned char", "uint8", "uint8_t" -> VoxelType.UINT8;
      case "short", "short int", "signed short", "signed short int", "int16", "int16_t" ->
          VoxelType.INT16;
      case "ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t" ->
          VoxelType.UINT16;
      case "int", "signed int", "int32", "int32_t" -> VoxelType.INT32;
      case "uint", "unsigned int", "uint32", "uint32_t" -> VoxelType.UINT32;
      case "longlong",
          "long long",
          "long long int",
          "signed long long",
          "signed long long int",
          "int64",
          "int64_t" ->
          VoxelType.INT64;
      case "ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t" ->
          VoxelType.UINT64;
      case "float" -> VoxelType.FLOAT32;
      case "double" -> VoxelType.FLOAT64;
      default ->
          throw header.refusal("the type '" + header.required("type") + "' is no type of number");
    };
  }
}
