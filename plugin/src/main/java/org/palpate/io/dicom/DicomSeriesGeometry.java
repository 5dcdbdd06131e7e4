package org.palpate.io.dicom;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.palpate.geometry.Vec3;
import org.palpate.io.dicom.DicomFrame.ImagePlane;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.Grids;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.VoxelGrid;

/**
 * Sorts frames by position and derives their grid. The positions give spacing and direction of the
 * slices; the slice thickness is not used.
 */
final class DicomSeriesGeometry {
  private final List<DicomFrame> frames;
  private final String name;
  private final boolean resample;
  private final List<String> notes;
  private double[] alongNormalMm = new double[0];
  private double stepMm;
  private boolean uneven;

  private DicomSeriesGeometry(
      List<DicomFrame> frames, String name, boolean resample, List<String> notes) {
    this.frames = new ArrayList<>(frames);
    this.name = name;
    this.resample = resample;
    this.notes = notes;
  }

  /**
   * A sorted series and its grid.
   *
   * @param known whether the positions in the patient are known
   */
  record SortedSeries(
      List<DicomFrame> frames, VoxelGrid grid, List<SliceInterpolation> slices, boolean known) {}

  /**
   * The frames that make a slice: one, and a part of the next.
   *
   * @param frame index of the frame
   * @param nextWeight weight of the next frame, from 0 to less than 1
   */
  record SliceInterpolation(int frame, double nextWeight) {}

  /**
   * Sorts frames and derives their grid.
   *
   * @param name the file or folder, for messages
   * @param resample whether unevenly spaced slices may be interpolated
   * @param notes receives the assumptions that the user should know
   */
  static SortedSeries arrange(
      List<DicomFrame> frames, String name, boolean resample, List<String> notes)
      throws VolumeFormatException {
    return new DicomSeriesGeometry(frames, name, resample, notes).arrange();
  }

  private SortedSeries arrange() throws VolumeFormatException {
    if (frames.stream().anyMatch(frame -> frame.plane().isEmpty())) {
      return withoutPositions();
    }
    requireParallel();
    Vec3 normal = plane(0).normal();
    frames.sort(Comparator.comparingDouble(frame -> frame.plane().get().position().dot(normal)));
    alongNormalMm =
        frames.stream().mapToDouble(frame -> frame.plane().get().position().dot(normal)).toArray();
    Vec3 step = step(normal);
    requireDistinctPositions();
    requireNoGantryTilt(step, normal);
    requireEvenSpacing();
    int depth = frames.size();
    if (uneven) {
      depth = (int) Math.rint((alongNormalMm[depth - 1] - alongNormalMm[0]) / stepMm) + 1;
      step.mul(stepMm / step.length(), step);
    }
    int[] sizes = {frames.get(0).dicom().columns(), frames.get(0).dicom().rows(), depth};
    VoxelGrid grid = Grids.of(sizes, plane(0).steps(step), plane(0).position(), Path.of(name));
    return new SortedSeries(frames, grid, weights(depth), true);
  }

  private ImagePlane plane(int n) {
    return frames.get(n).plane().orElseThrow();
  }

  /**
   * Stacks frames without positions of their own in file order; all must come from one file, which
   * must state their distance.
   */
  private SortedSeries withoutPositions() throws VolumeFormatException {
    DicomFile dicom = frames.get(0).dicom();
    if (frames.stream().anyMatch(frame -> !frame.dicom().file().equals(dicom.file()))) {
      throw refusal(
          "some of the images have no position",
          "name one file, or a folder with one series that has positions");
    }
    double[] slices =
        frames
            .get(0)
            .attributes()
            .decimals(DicomTag.PIXEL_MEASURES_SEQUENCE, DicomTag.SLICE_SPACING, 1, true);
    if (slices == null && frames.size() > 1) {
      throw refusal(
          "the "
              + frames.size()
              + " frames have neither positions nor SpacingBetweenSlices, as in a film",
          "give a series whose images have positions");
    }
    double[] position = dicom.attributes().decimals(DicomTag.POSITION, 3);
    double[] axes = dicom.attributes().decimals(DicomTag.ORIENTATION, 6);
    boolean known = frames.size() > 1 && position != null && axes != null;
    ImagePlane first = known ? frames.get(0).attributes().plane(position, axes) : unplaced();
    double step = slices == null ? first.columnSpacingMm() : slices[0];
    notes.add(
        slices == null
            ? "the image has no position, and the slice spacing is taken to be the pixel spacing"
            : "the frames have no positions of their own: they are stacked in file order, "
                + NumberText.thousandths(step)
                + " mm apart (SpacingBetweenSlices)");
    Vec3[] steps = first.steps(first.normal().mul(step, new Vec3()));
    int[] sizes = {dicom.columns(), dicom.rows(), frames.size()};
    VoxelGrid grid = Grids.of(sizes, steps, first.position(), dicom.file());
    return new SortedSeries(frames, grid, weights(frames.size()), known);
  }

  /** Returns a plane at the origin along the axes of the world. */
  private ImagePlane unplaced() throws VolumeFormatException {
    double[] none = {0, 0, 0};
    double[] axes = {1, 0, 0, 0, 1, 0};
    FrameAttributes attributes = frames.get(0).attributes();
    if (attributes.decimals(DicomTag.PIXEL_MEASURES_SEQUENCE, DicomTag.PIXEL_SPACING, 2, true)
        != null) {
      return attributes.plane(none, axes);
    }
    notes.add("the pixel size is unknown: 1 mm assumed");
    return new ImagePlane(
        new Vec3(), new Vec3(axes[0], axes[1], axes[2]), new Vec3(axes[3], axes[4], axes[5]), 1, 1);
  }

  private void requireParallel() throws VolumeFormatException {
    ImagePlane first = plane(0);
    for (DicomFrame frame : frames) {
      if (!frame.plane().orElseThrow().isParallelTo(first)) {
        throw refusal(
            "the slices differ in direction or pixel spacing", "export one series of one kind");
      }
    }
  }

  /**
   * Returns the mean step from a slice to the next; for a single slice, a step along its normal.
   */
  private Vec3 step(Vec3 normal) {
    int count = frames.size();
    if (count > 1) {
      Vec3 all = plane(count - 1).position().sub(plane(0).position(), new Vec3());
      return all.mul(1.0 / (count - 1), all);
    }
    return normal.mul(singleSliceMm(), new Vec3());
  }

  /** Returns the extent of a single slice along its normal, mm, and notes where it stands. */
  private double singleSliceMm() {
    int[] tags = {DicomTag.SLICE_SPACING, DicomTag.SLICE_THICKNESS};
    for (int tag : tags) {
      double[] stated = frames.get(0).dicom().attributes().decimals(tag, 1);
      if (stated != null && stated[0] > 0 && Double.isFinite(stated[0])) {
        notes.add(
            tag == DicomTag.SLICE_SPACING
                ? "a single slice: the slice spacing is that of the header"
                : "a single slice: the slice spacing is its thickness");
        return stated[0];
      }
    }
    notes.add("a single slice: the slice spacing is taken to be the pixel spacing");
    return plane(0).columnSpacingMm();
  }

  private void requireDistinctPositions() throws VolumeFormatException {
    for (int k = 1; k < frames.size(); k++) {
      if (alongNormalMm[k] - alongNormalMm[k - 1] < ImagePlane.SAME_POSITION_MM) {
        throw refusal(
            "two slices have the same position, at "
                + NumberText.thousandths(alongNormalMm[k])
                + " mm",
            "export each time step or echo as a series of its own");
      }
    }
  }

  private void requireNoGantryTilt(Vec3 step, Vec3 normal) throws VolumeFormatException {
    double alongNormal = step.dot(normal);
    double inPlane = step.sub(normal.mul(alongNormal, new Vec3()), new Vec3()).length();
    if (frames.size() > 1 && inPlane > ImagePlane.SAME_DIRECTION * alongNormal) {
      double degrees = StrictMath.toDegrees(StrictMath.atan2(inPlane, alongNormal));
      throw refusal(
          String.format(
              Locale.ROOT,
              "the slices are tilted by %.2f degrees against their normal (gantry tilt)",
              degrees),
          "correct the tilt first, for example with 3D Slicer");
    }
  }

  private void requireEvenSpacing() throws VolumeFormatException {
    int gaps = frames.size() - 1;
    if (gaps < 1) {
      return;
    }
    double[] sorted = new double[gaps];
    for (int k = 0; k < gaps; k++) {
      sorted[k] = alongNormalMm[k + 1] - alongNormalMm[k];
    }
    Arrays.sort(sorted);
    stepMm = sorted[gaps / 2];
    for (int k = 0; k < gaps && !uneven; k++) {
      double gap = alongNormalMm[k + 1] - alongNormalMm[k];
      if (Math.abs(gap - stepMm) > ImagePlane.UNEVEN * stepMm + ImagePlane.POSITION_ROUNDING_MM) {
        uneven = true;
        reportUneven(gap, k);
      }
    }
  }

  private void reportUneven(double gap, int k) throws VolumeFormatException {
    String where =
        "between "
            + NumberText.thousandths(alongNormalMm[k])
            + " and "
            + NumberText.thousandths(alongNormalMm[k + 1])
            + " mm the gap is "
            + NumberText.thousandths(gap)
            + " mm instead of "
            + NumberText.thousandths(stepMm)
            + " mm";
    long missing = Math.round(gap / stepMm) - 1;
    boolean whole =
        missing > 0 && Math.abs(gap - (missing + 1) * stepMm) <= 2 * ImagePlane.UNEVEN * stepMm;
    String what =
        whole ? missing + " slice(s) missing: " + where : "the slice spacing is uneven: " + where;
    if (!resample) {
      throw refusal(what, "export the whole series, or allow interpolated slices with --resample");
    }
    notes.add(
        "resampled to slices " + NumberText.thousandths(stepMm) + " mm apart because " + what);
  }

  private List<SliceInterpolation> weights(int depth) {
    List<SliceInterpolation> weights = new ArrayList<>();
    int frame = 0;
    for (int k = 0; k < depth; k++) {
      if (!uneven) {
        weights.add(new SliceInterpolation(k, 0));
        continue;
      }
      double at = Math.min(alongNormalMm[0] + k * stepMm, alongNormalMm[frames.size() - 1]);
      while (frame + 2 < frames.size() && alongNormalMm[frame + 1] <= at) {
        frame++;
      }
      double gap = alongNormalMm[frame + 1] - alongNormalMm[frame];
      double weight = (at - alongNormalMm[frame]) / gap;
      weights.add(
          weight >= 1
              ? new SliceInterpolation(frame + 1, 0)
              : new SliceInterpolation(frame, weight));
    }
    return weights;
  }

  private VolumeFormatException refusal(String what, String remedy) {
    return new VolumeFormatException(what, name, remedy);
  }
}
