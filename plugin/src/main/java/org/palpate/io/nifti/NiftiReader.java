package org.palpate.io.nifti;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.Grids;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.Luminance;
import org.palpate.io.format.LuminanceSampleStream;
import org.palpate.io.format.NonSpatialAxis;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.format.SampleStream;
import org.palpate.io.format.Scaling;
import org.palpate.io.format.StreamVolumeReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

/**
 * Reads NIfTI-1 and NIfTI-2, in one file or as a pair, plain or gzip, and pairs of Analyze 7.5.
 * World coordinates are RAS; those of Analyze 7.5 are unknown.
 *
 * <p>Source: nifti1.h and nifti2.h, nifti.nimh.nih.gov; dbh.h of Analyze 7.5.
 */
public final class NiftiReader {
  private static final String[] ENDINGS = {".nii", ".nii.gz", ".hdr", ".hdr.gz", ".img", ".img.gz"};

  private static final int RGB24 = 128;
  private static final int RGBA32 = 2304;

  private NiftiReader() {}

  /** Returns whether a file with these first bytes or this name is a NIfTI file, plain or gzip. */
  public static boolean accepts(byte[] start, Path file) throws VolumeFormatException {
    return InputFiles.hasEnding(file, ENDINGS)
        || NiftiHeader.isNifti(BinaryData.isGzip(start) ? NiftiHeader.firstBytes(file) : start);
  }

  /**
   * Opens a file, or the pair to which it belongs.
   *
   * @throws VolumeFormatException if the file is damaged, cannot be decoded, or needs another
   *     option
   */
  public static VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException {
    Path headerFile = pairedFile(file, ".img", ".hdr");
    NiftiHeader header = NiftiHeader.read(headerFile);
    Path dataFile = header.isPair() ? pairedFile(headerFile, ".hdr", ".img") : headerFile;
    VoxelType type = type(header);
    Scaling scaling = scaling(header);
    List<String> notes = new ArrayList<>();
    int[] sizes = sizes(header);
    NonSpatialAxis extra = extra(header, options, notes);
    NiftiAffine place = NiftiAffine.of(header, notes);
    VoxelGrid grid =
        Grids.of(sizes, place.stepsMm().toArray(new Vec3[0]), place.firstCentreMm(), headerFile);
    boolean gzip = BinaryData.isGzip(InputFiles.firstBytes(dataFile, 2));
    int components = components(header);
    BinaryData data =
        new BinaryData(
            List.of(dataFile),
            new BinaryData.Start(offset(header), false, gzip),
            type,
            header.order(),
            components > 1 ? Scaling.NONE : scaling,
            byteCount(header, grid, extra, type.bytes() * components));
    data.requireFileLengths();
    if (components > 1) {
      notes.add(Luminance.NOTE);
    }
    noteAnalyze(header, notes);
    SampleStream.Opener opener =
        components > 1 ? () -> new LuminanceSampleStream(data.open(), components) : data;
    VolumeHeader described =
        new VolumeHeader(
            header.formatName() + colourName(header) + (gzip ? ", gzip" : ""),
            grid,
            type,
            components > 1 ? ValueRange.of(type) : scaling.range(type),
            place.isKnown() ? CoordinateSystem.RAS : CoordinateSystem.UNKNOWN,
            header.isLabels() ? Optional.of(LabelTable.EMPTY) : Optional.empty(),
            notes);
    List<Path> files = header.isPair() ? List.of(headerFile, dataFile) : List.of(headerFile);
    return new StreamVolumeReader(described, files, opener, extra, options.progress());
  }

  private static void noteAnalyze(NiftiHeader header, List<String> notes) {
    if (header.isAnalyze()) {
      notes.add("Analyze 7.5 states no unit of length: taken as mm");
    }
  }

  /**
   * Returns the file beside it with the other ending, plain or gzip; the file itself if it does not
   * have the first ending.
   */
  private static Path pairedFile(Path file, String from, String to) throws VolumeFormatException {
    String name = file.getFileName().toString();
    String lower = name.toLowerCase(Locale.ROOT);
    String zip = lower.endsWith(".gz") ? ".gz" : "";
    if (!lower.endsWith(from + zip)) {
      return file;
    }
    String stem = name.substring(0, name.length() - from.length() - zip.length());
    for (String ending : List.of(to, to + ".gz", to.toUpperCase(Locale.ROOT))) {
      Path other = file.resolveSibling(stem + ending);
      if (Files.exists(other)) {
        return InputFiles.resolveBeside(file, stem + ending);
      }
    }
    throw new VolumeFormatException(
        "the second file of the pair, " + stem + to + ", is missing",
        file,
        "put both files into one folder");
  }

  private static int[] sizes(NiftiHeader header) throws VolumeFormatException {
    int[] sizes = {1, 1, 1};
    int dimension = (int) header.dim(0);
    if (dimension < 2 || dimension > 7) {
      throw header.refusal("the header has " + header.dim(0) + " axes, not 2 to 7");
    }
    for (int axis = 0; axis < Math.min(3, dimension); axis++) {
      long size = header.dim(axis + 1);
      if (size < 1 || size > Integer.MAX_VALUE) {
        throw header.refusal("the size along " + "xyz".charAt(axis) + " is " + size);
      }
      sizes[axis] = (int) size;
    }
    return sizes;
  }

  private static NonSpatialAxis extra(NiftiHeader header, ReadOptions options, List<String> notes)
      throws VolumeFormatException {
    double steps = 1;
    for (int axis = 4; axis <= header.dim(0); axis++) {
      if (header.dim(axis) < 0) {
        throw header.refusal("the size along axis " + axis + " is " + header.dim(axis));
      }
      steps *= Math.max(1, header.dim(axis));
    }
    if (steps > Integer.MAX_VALUE) {
      throw header.refusal("the header has " + NumberText.display(steps) + " time steps");
    }
    return new NonSpatialAxis(
        3, (int) steps, ReadOptionChecks.chosenStep((int) steps, options, header.file(), notes));
  }

  private static long byteCount(
      NiftiHeader header, VoxelGrid grid, NonSpatialAxis extra, int bytesPerVoxel)
      throws VolumeFormatException {
    double bytes = (double) grid.voxelCount() * extra.count() * bytesPerVoxel;
    if (bytes > 0x1p60) {
      throw header.refusal("the sizes make more than 2^60 bytes");
    }
    return grid.voxelCount() * extra.count() * bytesPerVoxel;
  }

  private static long offset(NiftiHeader header) throws VolumeFormatException {
    double offset = header.voxOffset();
    long least = header.isPair() ? 0 : header.length() + 4;
    if (!(offset >= least) || offset > 0x1p53 || offset != Math.rint(offset)) {
      throw header.refusal(
          "the data begin at byte "
              + NumberText.display(offset)
              + ", which is not after the header");
    }
    return (long) offset;
  }

  private static Scaling scaling(NiftiHeader header) throws VolumeFormatException {
    double slope = header.slope();
    if (slope == 0 || !Double.isFinite(slope)) {
      return Scaling.NONE;
    }
    if (!Double.isFinite(header.intercept())) {
      throw header.refusal("the intercept is " + header.intercept());
    }
    return new Scaling(slope, header.intercept());
  }

  private static VoxelType type(NiftiHeader header) throws VolumeFormatException {
    return switch (header.datatype()) {
      case 2 -> VoxelType.UINT8;
      case 4 -> VoxelType.INT16;
      case 8 -> VoxelType.INT32;
      case 16 -> VoxelType.FLOAT32;
      case 64 -> VoxelType.FLOAT64;
      case 256 -> VoxelType.INT8;
      case 512 -> VoxelType.UINT16;
      case 768 -> VoxelType.UINT32;
      case 1024 -> VoxelType.INT64;
      case 1280 -> VoxelType.UINT64;
      case RGB24, RGBA32 -> {
        if (header.isAnalyze()) {
          throw unusable(header, "colours (RGB24)");
        }
        yield VoxelType.UINT8;
      }
      case 1 -> throw unusable(header, "single bits");
      case 32, 1792, 2048 -> throw unusable(header, "complex numbers");
      case 1536 -> throw unusable(header, "floating point of 128 bits");
      default -> throw unusable(header, "of the unknown type " + header.datatype());
    };
  }

  private static String colourName(NiftiHeader header) {
    return header.datatype() == RGB24 ? ", RGB24" : header.datatype() == RGBA32 ? ", RGBA32" : "";
  }

  /** Returns the parts of a voxel: 1, or those of a colour. */
  private static int components(NiftiHeader header) {
    return header.datatype() == RGB24 ? 3 : header.datatype() == RGBA32 ? 4 : 1;
  }

  private static VolumeFormatException unusable(NiftiHeader header, String what) {
    return new VolumeFormatException(
        "the voxels are " + what + ", not single numbers",
        header.file(),
        "convert the file to integers or floats, as in: fslmaths IN OUT -odt float");
  }
}
