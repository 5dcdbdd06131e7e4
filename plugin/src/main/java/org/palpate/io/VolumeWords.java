package org.palpate.io;

import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeHeader.World;

/** Says in a radiographer's words how a volume lies in the patient. */
public final class VolumeWords {
  private static final double ALONG_AN_AXIS = 0.999; // within 2.6 degrees

  private VolumeWords() {}

  /**
   * Which way rows, columns and slices run, and where the first voxel is; only the last where the
   * file does not name its axes.
   */
  public static List<String> place(VolumeHeader header) {
    Vec3 first = header.grid().gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3());
    String centre =
        "first voxel's centre at "
            + short4(first.x)
            + ", "
            + short4(first.y)
            + ", "
            + short4(first.z)
            + " mm";
    if (header.world() == World.UNKNOWN) {
      return List.of(centre);
    }
    RigidTransform axes = header.grid().gridMmToWorld();
    String ways =
        "x runs to the patient's "
            + towards(axes.axisX(), header.world())
            + ", y to the "
            + towards(axes.axisY(), header.world())
            + ", slices to the "
            + towards(axes.axisZ(), header.world());
    return List.of(ways, centre);
  }

  /** Four decimals at most: enough for a person. */
  private static String short4(double value) {
    return Numbers.text(Math.rint(value * 1e4) / 1e4 + 0.0);
  }

  private static String towards(Vec3 axis, World world) {
    int along = 0;
    for (int n = 1; n < 3; n++) {
      along = Math.abs(axis.get(n)) > Math.abs(axis.get(along)) ? n : along;
    }
    boolean positive = axis.get(along) > 0;
    String name =
        switch (along) {
          case 0 -> positive == (world != World.RAS) ? "left" : "right";
          case 1 -> positive == (world == World.LPS) ? "back" : "front";
          default -> positive ? "head" : "feet";
        };
    return Math.abs(axis.get(along)) >= ALONG_AN_AXIS ? name : name + " (obliquely)";
  }
}
