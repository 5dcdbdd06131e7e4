package org.palpate.io.dicom;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.io.dicom.DicomSeriesGeometry.SliceInterpolation;
import org.palpate.io.dicom.DicomSeriesGeometry.SortedSeries;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.Luminance;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.ReadProgress;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;

/**
 * Reads a DICOM series, one frame a slice. A slice of a resampled series is interpolated between
 * two frames.
 */
public final class DicomReader implements VolumeReader {
  private final SortedSeries series;
  private final String place;
  private final VolumeHeader header;
  private final ReadProgress progress;

  private DicomReader(
      SortedSeries series, String place, VolumeHeader header, ReadProgress progress) {
    this.series = series;
    this.place = place;
    this.header = header;
    this.progress = progress;
  }

  /** Returns whether a file with these first bytes is a DICOM file. */
  public static boolean accepts(byte[] start, Path file) {
    return DicomRecognizer.isDicom(start);
  }

  /**
   * Opens a single file, which may have several frames.
   *
   * @throws VolumeFormatException if the file is no volume, is damaged, or needs another option
   */
  public static VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException {
    return of(List.of(DicomFile.read(file)), file.toString(), List.of(), options);
  }

  /**
   * Opens one series of a folder.
   *
   * @throws VolumeFormatException if the folder has no series, or several and none is chosen
   */
  public static VolumeReader openFolder(Path folder, ReadOptions options)
      throws VolumeFormatException {
    DicomSeriesFinder.Found found = DicomSeriesFinder.find(folder, options);
    return of(found.files(), folder.toString(), found.notes(), options);
  }

  /** Returns a reader of files that belong to one series. */
  private static VolumeReader of(
      List<DicomFile> files, String place, List<String> notesSoFar, ReadOptions options)
      throws VolumeFormatException {
    DicomFile first = files.get(0);
    List<String> notes = new ArrayList<>(notesSoFar);
    if (DicomSegmentation.isSegmentation(first)) {
      return DicomSegmentationReader.open(files, place, notes, options);
    }
    List<DicomFrame> frames = new ArrayList<>();
    for (DicomFile file : files) {
      DicomImageChecks.check(file);
      requireSamePixels(first, file);
      frames.addAll(DicomFrame.of(file));
    }
    frames = DicomDuplicates.drop(frames, notes);
    frames = DicomSteps.select(frames, place, options, notes);
    SortedSeries series = DicomSeriesGeometry.arrange(frames, place, options.resample(), notes);
    addPixelNotes(first, notes);
    VolumeHeader header =
        new VolumeHeader(
            "DICOM, " + first.syntax().name(),
            series.grid(),
            type(first),
            values(series.frames()),
            series.known() ? CoordinateSystem.LPS : CoordinateSystem.UNKNOWN,
            Optional.empty(),
            notes);
    return new DicomReader(series, place, header, options.progress());
  }

  private static void addPixelNotes(DicomFile first, List<String> notes) {
    if (DicomDose.isDose(first)) {
      notes.add(DicomDose.note(first));
    }
    if (DicomColours.isColour(first)) {
      notes.add(Luminance.NOTE);
    }
    if (first.attributes().text(DicomTag.PHOTOMETRIC).equals("MONOCHROME1")) {
      notes.add("low values are shown white (MONOCHROME1); values are read as they are stored");
    }
    if (first.attributes().text(DicomTag.LOSSY).equals("01")
        || first.syntax().coding() == TransferSyntax.Coding.JPEG) {
      notes.add("the pixels were compressed with loss");
    } else if (first.syntax().isNearLossless()) {
      notes.add("the pixels may have been compressed with loss");
    }
  }

  private static void requireSamePixels(DicomFile first, DicomFile file)
      throws VolumeFormatException {
    if (file.rows() != first.rows()
        || file.columns() != first.columns()
        || file.samples() != first.samples()
        || type(file) != type(first)) {
      throw file.refusal(
          "the image differs in size or type from the first of its series",
          "export the series again");
    }
  }

  private static VoxelType type(DicomFile dicom) {
    return switch (dicom.bitsAllocated()) {
      case 8 -> dicom.isSigned() ? VoxelType.INT8 : VoxelType.UINT8;
      case 16 -> dicom.isSigned() ? VoxelType.INT16 : VoxelType.UINT16;
      default -> dicom.isSigned() ? VoxelType.INT32 : VoxelType.UINT32;
    };
  }

  /** Returns the bounds on the values of all frames, each with its own slope and intercept. */
  private static ValueRange values(List<DicomFrame> frames) {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    boolean integer = true;
    for (DicomFrame frame : frames) {
      ValueRange range = frame.scaling().range(type(frame.dicom()));
      double bits = StrictMath.pow(2, frame.dicom().bitsStored());
      double least = frame.scaling().apply(frame.dicom().isSigned() ? -bits / 2 : 0);
      double most = frame.scaling().apply(frame.dicom().isSigned() ? bits / 2 - 1 : bits - 1);
      low = Math.min(low, Math.min(least, most));
      high = Math.max(high, Math.max(least, most));
      integer &= range.isInteger();
    }
    return new ValueRange(low, high, integer);
  }

  @Override
  public VolumeHeader header() {
    return header;
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    VoxelSlice slice = MemoryCheck.slice(header.grid(), header.values().isInteger(), place);
    MemoryCheck.require(8.0 * slice.count(), "decoding one frame", place);
    VoxelSlice next = null;
    try (DicomPixelDecoder pixels = new DicomPixelDecoder()) {
      for (int k = 0; k < series.slices().size(); k++) {
        SliceInterpolation weight = series.slices().get(k);
        decode(pixels, weight.frame(), slice);
        if (weight.nextWeight() > 0) {
          next = next == null ? MemoryCheck.slice(header.grid(), slice.isInteger(), place) : next;
          decode(pixels, weight.frame() + 1, next);
          interpolate(slice, next, weight.nextWeight());
        }
        sink.accept(k, slice);
        progress.slicesRead(k + 1, series.slices().size());
      }
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw InputFiles.unreadableFile(series.frames().get(0).dicom().file(), e);
    }
  }

  private void decode(DicomPixelDecoder pixels, int frame, VoxelSlice dest)
      throws VolumeFormatException {
    try {
      pixels.decode(series.frames().get(frame), dest);
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException | ArithmeticException e) {
      throw series.frames().get(frame).dicom().damagedPixels(e);
    }
  }

  /** Interpolates linearly between two slices, and rounds integers. */
  private static void interpolate(VoxelSlice slice, VoxelSlice next, double nextWeight) {
    for (int n = 0; n < slice.count(); n++) {
      double value = slice.value(n) * (1 - nextWeight) + next.value(n) * nextWeight;
      if (slice.isInteger()) {
        slice.integers()[n] = (int) Math.rint(value);
      } else {
        slice.doubles()[n] = value;
      }
    }
  }

  @Override
  public String sourceName() {
    return place;
  }

  @Override
  public List<Path> files() {
    return series.frames().stream().map(frame -> frame.dicom().file()).distinct().toList();
  }
}
