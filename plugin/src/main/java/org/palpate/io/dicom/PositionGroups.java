package org.palpate.io.dicom;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.io.dicom.DicomFrame.ImagePlane;
import org.palpate.io.file.NumberText;

/**
 * Parallel frames, grouped by their position along the normal.
 *
 * @param groups by position, each of at least one frame
 * @param normal the normal of the first frame
 */
record PositionGroups(List<List<DicomFrame>> groups, Vec3 normal) {
  /** Groups frames whose positions are known. */
  static PositionGroups of(List<DicomFrame> frames) {
    Vec3 normal = frames.get(0).plane().orElseThrow().normal();
    List<DicomFrame> sorted = new ArrayList<>(frames);
    sorted.sort(Comparator.comparingDouble(frame -> alongMm(frame, normal)));
    List<List<DicomFrame>> groups = new ArrayList<>();
    double lastMm = Double.NEGATIVE_INFINITY;
    for (DicomFrame frame : sorted) {
      double mm = alongMm(frame, normal);
      if (mm - lastMm >= ImagePlane.SAME_POSITION_MM) {
        groups.add(new ArrayList<>());
        lastMm = mm;
      }
      groups.get(groups.size() - 1).add(frame);
    }
    return new PositionGroups(groups, normal);
  }

  private static double alongMm(DicomFrame frame, Vec3 normal) {
    return frame.plane().orElseThrow().position().dot(normal);
  }

  /** Returns all frames, sorted by position. */
  List<DicomFrame> frames() {
    return groups.stream().flatMap(List::stream).toList();
  }

  /** Returns the number of frames at the position that has most. */
  int largest() {
    return groups.stream().mapToInt(List::size).max().orElse(0);
  }

  /** Returns the number of frames at the position that has fewest. */
  int smallest() {
    return groups.stream().mapToInt(List::size).min().orElse(0);
  }

  /** Returns the position of a group in words. */
  String position(List<DicomFrame> group) {
    double mm = alongMm(group.get(0), normal);
    boolean axial = Math.abs(normal.z) > 1 - 1e-9;
    double shown = axial ? group.get(0).plane().orElseThrow().position().z : mm;
    return (axial ? "z = " : "")
        + NumberText.thousandths(shown)
        + (axial ? " mm" : " mm along the normal");
  }
}
