package org.palpate.io.dicom;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.dicom.DicomFrame.ImagePlane;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.Grids;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.VoxelGrid;

/**
 * The grid of a segmentation object, whose empty frames may be left out, and the slice of each
 * frame.
 *
 * @param grid from the first to the last slice that a frame shows
 * @param sliceOfFrame the slice of each frame
 */
record SegmentationGrid(VoxelGrid grid, List<Integer> sliceOfFrame) {
  private static final int MAX_SLICES = 1 << 16;

  /**
   * Returns the grid of a segmentation.
   *
   * @throws VolumeFormatException if the positions of its frames form no grid
   */
  static SegmentationGrid of(DicomFile dicom, List<String> notes) throws VolumeFormatException {
    List<ImagePlane> planes = new ArrayList<>();
    List<FrameAttributes> frames = FrameAttributes.of(dicom, dicom.frameCount());
    for (FrameAttributes frame : frames) {
      Optional<ImagePlane> plane = frame.plane(frames.size() == 1);
      planes.add(
          plane.orElseThrow(
              () ->
                  dicom.refusal(
                      "a frame of the segmentation has no position, as on a microscope slide",
                      "give a segmentation of a volume")));
    }
    return new Arrangement(dicom, frames.get(0), planes).grid(notes);
  }

  /** Arranges parallel planes. */
  private record Arrangement(DicomFile dicom, FrameAttributes frame, List<ImagePlane> planes) {

    SegmentationGrid grid(List<String> notes) throws VolumeFormatException {
      requireParallel();
      Vec3 normal = planes.get(0).normal();
      double[] all = planes.stream().mapToDouble(plane -> plane.position().dot(normal)).toArray();
      double[] sorted = Arrays.stream(all).sorted().toArray();
      double firstMm = sorted[0];
      double depthMm = sorted[sorted.length - 1] - firstMm;
      double stepMm = step(sorted, notes);
      double steps = Math.rint(depthMm / stepMm);
      if (!(steps < MAX_SLICES)) {
        throw dicom.refusal(
            "the frames lie "
                + NumberText.thousandths(depthMm)
                + " mm apart, in steps of "
                + NumberText.thousandths(stepMm)
                + " mm",
            "save the segmentation again");
      }
      // the mean step, because positions are rounded
      double meanMm = steps > 0 ? depthMm / steps : stepMm;
      List<Integer> slices =
          Arrays.stream(all)
              .mapToObj(position -> (int) Math.rint((position - firstMm) / meanMm))
              .toList();
      requireNoShift(normal);
      int first = slices.indexOf(0);
      ImagePlane plane = planes.get(first);
      Vec3[] edges = plane.steps(normal.mul(meanMm, new Vec3()));
      int[] sizes = {dicom.columns(), dicom.rows(), (int) steps + 1};
      VoxelGrid grid = Grids.of(sizes, edges, plane.position(), dicom.file());
      return new SegmentationGrid(grid, slices);
    }

    private void requireParallel() throws VolumeFormatException {
      ImagePlane first = planes.get(0);
      for (ImagePlane plane : planes) {
        if (!plane.isParallelTo(first)) {
          throw dicom.refusal(
              "the frames of the segmentation differ in direction or pixel spacing",
              "save it on one grid, for example with 3D Slicer");
        }
      }
    }

    /** Refuses frames that lie beside each other rather than along their normal. */
    private void requireNoShift(Vec3 normal) throws VolumeFormatException {
      Vec3 first = planes.get(0).position();
      for (ImagePlane plane : planes) {
        Vec3 apart = plane.position().sub(first, new Vec3());
        double along = apart.dot(normal);
        double beside = apart.sub(normal.mul(along, new Vec3()), new Vec3()).length();
        if (beside
            > ImagePlane.SAME_DIRECTION * Math.abs(along) + ImagePlane.POSITION_ROUNDING_MM) {
          throw dicom.refusal(
              "the frames of the segmentation are shifted by "
                  + NumberText.thousandths(beside)
                  + " mm against their normal",
              "save it on one grid, for example with 3D Slicer");
        }
      }
    }

    /** Returns the distance of slices: that of the header, or else the least of the positions. */
    private double step(double[] sortedMm, List<String> notes) throws VolumeFormatException {
      double leastMm = Double.POSITIVE_INFINITY;
      for (int n = 1; n < sortedMm.length; n++) {
        double gap = sortedMm[n] - sortedMm[n - 1];
        leastMm = gap >= ImagePlane.SAME_POSITION_MM ? Math.min(leastMm, gap) : leastMm;
      }
      double stated = measure(DicomTag.SLICE_SPACING);
      if (stated > 0 && areMultiples(sortedMm, stated)) {
        return stated;
      }
      if (Double.isInfinite(leastMm)) {
        double thickness = measure(DicomTag.SLICE_THICKNESS);
        notes.add("a single slice: its thickness is taken to be the slice spacing");
        return thickness > 0 ? thickness : planes.get(0).columnSpacingMm();
      }
      if (!areMultiples(sortedMm, leastMm)) {
        throw dicom.refusal(
            "the slices of the segmentation are spaced unevenly",
            "save it on one grid, for example with 3D Slicer");
      }
      return leastMm;
    }

    private double measure(int tag) {
      double[] found = frame.decimals(DicomTag.PIXEL_MEASURES_SEQUENCE, tag, 1, true);
      return found == null || !Double.isFinite(found[0]) ? 0 : found[0];
    }

    private static boolean areMultiples(double[] sortedMm, double step) {
      for (double at : sortedMm) {
        double steps = (at - sortedMm[0]) / step;
        double beside = Math.abs(steps - Math.rint(steps)) * step;
        if (!(beside <= ImagePlane.UNEVEN * step + ImagePlane.POSITION_ROUNDING_MM)) {
          return false;
        }
      }
      return true;
    }
  }
}
