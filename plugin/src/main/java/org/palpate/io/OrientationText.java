package org.palpate.io;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeHeader;

/** Describes in anatomical terms how a volume is oriented and positioned. */
public final class OrientationText {
  private static final double ROUNDING_MM = 1e-9; // smaller numbers are a rounded 0
  private static final double ALONG_AN_AXIS = 0.999; // within 2.6 degrees

  private OrientationText() {}

  /**
   * Returns the plane of the slices, the directions of rows and columns, and the centre of the
   * first voxel. Only the last if the file does not name its axes.
   */
  public static List<String> describe(VolumeHeader header) {
    Vec3 first = header.grid().gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3());
    String centre =
        "first voxel's centre at "
            + number(first.x)
            + ", "
            + number(first.y)
            + ", "
            + number(first.z)
            + " mm";
    if (header.coordinateSystem() == CoordinateSystem.UNKNOWN) {
      return List.of(centre);
    }
    RigidTransform axes = header.grid().gridMmToWorld();
    String slices =
        plane(axes.axisZ())
            + " slices, "
            + number(header.grid().spacingMm().z)
            + " mm apart, running to the patient's "
            + anatomicalDirection(axes.axisZ(), header.coordinateSystem());
    String pixels =
        "in a slice x runs to the patient's "
            + anatomicalDirection(axes.axisX(), header.coordinateSystem())
            + ", y to the "
            + anatomicalDirection(axes.axisY(), header.coordinateSystem());
    return List.of(slices, pixels, centre);
  }

  /** Returns a length with four decimals, or with five digits below 1 mm. */
  public static String number(double mm) {
    if (!(Math.abs(mm) < 1) || Math.abs(mm) < ROUNDING_MM) {
      return NumberText.display(Math.rint(mm * 1e4) / 1e4 + 0.0);
    }
    return new BigDecimal(mm).round(new MathContext(5)).stripTrailingZeros().toPlainString();
  }

  /** Returns the anatomical plane perpendicular to an axis, or the nearest one. */
  private static String plane(Vec3 axis) {
    String name = List.of("sagittal", "coronal", "axial").get(longest(axis));
    return Math.abs(axis.get(longest(axis))) >= ALONG_AN_AXIS ? name : "oblique, nearly " + name;
  }

  private static int longest(Vec3 axis) {
    int along = 0;
    for (int n = 1; n < 3; n++) {
      along = Math.abs(axis.get(n)) > Math.abs(axis.get(along)) ? n : along;
    }
    return along;
  }

  private static String anatomicalDirection(Vec3 axis, CoordinateSystem system) {
    int along = longest(axis);
    boolean positive = axis.get(along) > 0;
    String name =
        switch (along) {
          case 0 -> positive == (system != CoordinateSystem.RAS) ? "left" : "right";
          case 1 -> positive == (system == CoordinateSystem.LPS) ? "back" : "front";
          default -> positive ? "head" : "feet";
        };
    return Math.abs(axis.get(along)) >= ALONG_AN_AXIS ? name : name + " (obliquely)";
  }
}
