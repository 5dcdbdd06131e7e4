package org.palpate.io.dicom;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.palpate.io.dicom.DicomSegmentation.Kind;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.format.ReadOptionChecks;
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
 * Reads a DICOM segmentation object as labels: the value of a voxel is the number of its segment.
 * Where segments overlap, the one of the higher number covers the others in a plain reading.
 */
final class DicomSegmentationReader implements VolumeReader {
  /** The least fraction of the maximum at which a voxel belongs to its segment. */
  private static final double LEAST_FRACTION = 0.5;

  private final DicomSegmentation segmentation;
  private final List<List<Integer>> framesOfSlice;
  private final VolumeHeader header;
  private final String place;
  private final ReadProgress progress;

  private DicomSegmentationReader(
      DicomSegmentation segmentation,
      List<List<Integer>> framesOfSlice,
      VolumeHeader header,
      String place,
      ReadProgress progress) {
    this.segmentation = segmentation;
    this.framesOfSlice = framesOfSlice;
    this.header = header;
    this.place = place;
    this.progress = progress;
  }

  /**
   * Opens a segmentation object.
   *
   * @param notes notes for the user so far; those of the segmentation are added
   * @throws VolumeFormatException if there are several files, or the object is incomplete
   */
  static VolumeReader open(
      List<DicomFile> files, String place, List<String> notes, ReadOptions options)
      throws VolumeFormatException {
    if (files.size() > 1) {
      throw new VolumeFormatException(
          "the series has " + files.size() + " segmentation objects", place, "name one of them");
    }
    DicomSegmentation segmentation = DicomSegmentation.of(files.get(0));
    ReadOptionChecks.chosenStep(1, options, Path.of(place), notes);
    SegmentationGrid grid = SegmentationGrid.of(segmentation.dicom(), notes);
    addNotes(segmentation, notes);
    long most = segmentation.table().labels().keySet().stream().reduce(1L, Math::max);
    most = segmentation.kind() == Kind.LABEL_MAP ? (1L << files.get(0).bitsAllocated()) - 1 : most;
    VolumeHeader header =
        new VolumeHeader(
            "DICOM segmentation, "
                + segmentation.kind().text()
                + ", "
                + segmentation.dicom().syntax().name(),
            grid.grid(),
            most <= VoxelType.UINT8.high() ? VoxelType.UINT8 : VoxelType.UINT16,
            new ValueRange(0, most, true),
            CoordinateSystem.LPS,
            Optional.of(segmentation.table()),
            notes);
    return new DicomSegmentationReader(
        segmentation, framesOfSlice(segmentation, grid), header, place, options.progress());
  }

  private static void addNotes(DicomSegmentation segmentation, List<String> notes) {
    if (segmentation.kind() == Kind.FRACTIONAL) {
      notes.add(
          "the segments are fractional: a voxel belongs to one from "
              + LEAST_FRACTION
              + " of the maximum on");
    }
    if (segmentation.kind() != Kind.LABEL_MAP && segmentation.table().labels().size() > 1) {
      notes.add(
          "each segment is read whole; where segments overlap, slices and exported labels show the"
              + " last");
    }
    if (!segmentation.namesWithoutFrame().isEmpty()) {
      notes.add("segments without a voxel: " + String.join(", ", segmentation.namesWithoutFrame()));
    }
  }

  /** Returns the frames of each slice, by the number of their segment. */
  private static List<List<Integer>> framesOfSlice(
      DicomSegmentation segmentation, SegmentationGrid grid) {
    List<List<Integer>> slices = new ArrayList<>();
    for (int k = 0; k < grid.grid().sizeZ(); k++) {
      slices.add(new ArrayList<>());
    }
    for (int n = 0; n < grid.sliceOfFrame().size(); n++) {
      slices.get(grid.sliceOfFrame().get(n)).add(n);
    }
    for (List<Integer> slice : slices) {
      slice.sort(Comparator.comparing(segmentation.segmentOfFrame()::get));
    }
    return slices;
  }

  @Override
  public VolumeHeader header() {
    return header;
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    read(sink, false);
  }

  @Override
  public void readLayers(SliceSink sink) throws VolumeFormatException {
    read(sink, true);
  }

  private void read(SliceSink sink, boolean layers) throws VolumeFormatException {
    VoxelSlice slice = MemoryCheck.slice(header.grid(), true, place);
    MemoryCheck.require(8.0 * slice.count(), "decoding one frame", place);
    try (DicomPixelDecoder pixels = new DicomPixelDecoder()) {
      for (int k = 0; k < framesOfSlice.size(); k++) {
        Arrays.fill(slice.integers(), 0);
        for (int frame : framesOfSlice.get(k)) {
          if (segmentation.kind() == Kind.LABEL_MAP) {
            paintLabels(pixels, frame, slice.integers());
          } else {
            paintSegment(pixels, frame, k, slice, layers ? sink : null);
          }
        }
        sink.accept(k, slice);
        progress.slicesRead(k + 1, framesOfSlice.size());
      }
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException | ArithmeticException e) {
      throw segmentation.dicom().damagedPixels(e);
    }
  }

  private void paintLabels(DicomPixelDecoder pixels, int frame, int[] dest) throws IOException {
    DicomFile dicom = segmentation.dicom();
    int background = dicom.attributes().number(DicomTag.PADDING, 0);
    int[] stored = pixels.storedValues(dicom, frame, dest.length);
    for (int n = 0; n < dest.length; n++) {
      dest[n] = stored[n] == background ? 0 : stored[n];
    }
  }

  /**
   * Paints the segment of a frame into a slice.
   *
   * @param sink receives what the slice holds already if the segment overlaps it, and the slice is
   *     then empty; null if the segment covers it
   */
  private void paintSegment(
      DicomPixelDecoder pixels, int frame, int k, VoxelSlice slice, SliceSink sink)
      throws IOException {
    int segment = segmentation.segmentOfFrame().get(frame);
    int[] dest = slice.integers();
    BitSet inside = inside(pixels, frame, dest.length);
    if (sink != null && overlaps(inside, segment, dest)) {
      sink.accept(k, slice);
      Arrays.fill(dest, 0);
    }
    for (int n = inside.nextSetBit(0); n >= 0; n = inside.nextSetBit(n + 1)) {
      dest[n] = segment;
    }
  }

  private static boolean overlaps(BitSet inside, int segment, int[] painted) {
    for (int n = inside.nextSetBit(0); n >= 0; n = inside.nextSetBit(n + 1)) {
      if (painted[n] != 0 && painted[n] != segment) {
        return true;
      }
    }
    return false;
  }

  /** Returns the pixels of a frame that belong to its segment. */
  private BitSet inside(DicomPixelDecoder pixels, int frame, int count) throws IOException {
    DicomFile dicom = segmentation.dicom();
    if (dicom.bitsAllocated() == 1) {
      return packedBits(pixels, frame, count);
    }
    boolean fractional = segmentation.kind() == Kind.FRACTIONAL;
    int most = dicom.attributes().number(DicomTag.MOST_FRACTION, 255);
    double least = fractional ? Math.max(1, LEAST_FRACTION * most) : 1;
    int[] stored = pixels.storedValues(dicom, frame, count);
    BitSet inside = new BitSet(count);
    for (int n = 0; n < count; n++) {
      if (stored[n] >= least) {
        inside.set(n);
      }
    }
    return inside;
  }

  /** Returns a frame of one bit a pixel. Frames follow each other without filling up bytes. */
  private BitSet packedBits(DicomPixelDecoder pixels, int frame, int count) throws IOException {
    long first = (long) frame * count;
    long from = first >> 3;
    int bytes = Math.toIntExact(((first + count + 7) >> 3) - from);
    int shift = (int) (first & 7);
    BitSet bits = BitSet.valueOf(pixels.nativeBytes(segmentation.dicom(), from, bytes));
    return bits.get(shift, shift + count);
  }

  @Override
  public String sourceName() {
    return place;
  }

  @Override
  public List<Path> files() {
    return List.of(segmentation.dicom().file());
  }
}
