package org.palpate.io.nrrd;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.io.format.Luminance;
import org.palpate.io.format.LuminanceSampleStream;
import org.palpate.io.format.NonSpatialAxis;
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
    return switch (axes.extraKind()) {
      case STEPS -> {
        VolumeHeader described = described(header, axes, data, ValueRange.of(type));
        yield new StreamVolumeReader(
            described, files(header, data), data, axes.extra(), options.progress());
      }
      case COLOUR -> luminance(header, axes, data, options);
      case LAYERS -> layers(header, axes, data, options);
    };
  }

  private static VolumeHeader described(
      NrrdHeader header, NrrdAxes axes, NrrdData data, ValueRange values) {
    SlicerSegments segments = SlicerSegments.of(header);
    return new VolumeHeader(
        "NRRD, " + data.encoding().description(),
        axes.grid(),
        data.type(),
        values,
        axes.coordinateSystem(),
        axes.extraKind() == NrrdAxes.ExtraKind.LAYERS
            ? Optional.of(segments.numbered())
            : segments.table(axes.extra().chosen()),
        axes.notes());
  }

  private static VolumeReader luminance(
      NrrdHeader header, NrrdAxes axes, NrrdData data, ReadOptions options)
      throws VolumeFormatException {
    VoxelType type = data.type();
    if (type != VoxelType.UINT8 && type != VoxelType.UINT16) {
      throw header.refusal("the voxels are colours of " + type.description());
    }
    axes.notes().add(Luminance.NOTE);
    return new StreamVolumeReader(
        described(header, axes, data, ValueRange.of(type)),
        files(header, data),
        () -> new LuminanceSampleStream(data.open(), axes.extra().count()),
        NonSpatialAxis.NONE,
        options.progress());
  }

  private static VolumeReader layers(
      NrrdHeader header, NrrdAxes axes, NrrdData data, ReadOptions options)
      throws VolumeFormatException {
    SlicerSegments segments = SlicerSegments.of(header);
    int last = segments.segments().size();
    if (!data.type().fitsInt()) {
      throw header.refusal("the labels are of " + data.type().description());
    }
    axes.notes()
        .add(
            axes.extra().count()
                + " layers of segments that may overlap: each segment has a value of its own, from"
                + " 1 to "
                + last
                + "; a label without a segment is left out; --time reads one layer alone");
    return new LayeredLabelReader(
        described(header, axes, data, new ValueRange(0, last, true)),
        files(header, data),
        data,
        axes.extra(),
        segments,
        options.progress());
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
