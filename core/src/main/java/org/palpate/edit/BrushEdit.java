package org.palpate.edit;

import java.util.Optional;
import org.palpate.geometry.Vec3;

/**
 * Makes every voxel solid or empty whose centre lies within a ball, or within a distance of a
 * straight path. A large brush takes several frames.
 */
public final class BrushEdit extends BoxEdit {
  private final Vec3 from = new Vec3();
  private final Vec3 to = new Vec3();
  private final Optional<BrushPath> path;
  private final double radiusMm;
  private final boolean solid;
  private final BrushLimits limits;

  /** The vector from the beginning to the end of the piece, mm along the axes of the grid. */
  private final Vec3 wayMm = new Vec3();

  private double squaredWayMm;

  /**
   * Makes an edit of a ball.
   *
   * @param segment index of the segment in the scene
   * @param centreGrid grid coordinates, finite
   * @param radiusMm metric radius, at least 0
   * @param solid whether the voxels become solid; otherwise they become empty
   * @throws IllegalArgumentException if the centre is not finite or the radius is negative
   */
  public BrushEdit(int segment, Vec3 centreGrid, double radiusMm, boolean solid) {
    this(segment, Optional.empty(), radiusMm, solid, BrushLimits.NONE);
    from.set(centreGrid);
    to.set(centreGrid);
    if (!to.isFinite()) {
      throw new IllegalArgumentException("centre must be finite: centreGrid=" + centreGrid);
    }
  }

  /**
   * {@return an edit of the next piece of a stroke} The piece ends where the device is when the
   * edit is applied if voxels are added, and where the tool touches if they are removed. So what is
   * added cannot push the brush along. Nothing happens if the tool has no place yet.
   *
   * @param segment index of the segment in the scene
   * @param path the path of the stroke
   * @param radiusMm metric radius, at least 0
   * @param solid whether the voxels become solid; otherwise they become empty
   * @param limits the voxels that it leaves as they are
   */
  public static BrushEdit atTool(
      int segment, BrushPath path, double radiusMm, boolean solid, BrushLimits limits) {
    return new BrushEdit(segment, Optional.of(path), radiusMm, solid, limits);
  }

  private BrushEdit(
      int segment, Optional<BrushPath> path, double radiusMm, boolean solid, BrushLimits limits) {
    super(segment);
    this.path = path;
    this.radiusMm = radiusMm;
    this.solid = solid;
    this.limits = limits;
    if (!(radiusMm >= 0)) {
      throw new IllegalArgumentException("radius must be at least 0: radiusMm=" + radiusMm);
    }
  }

  @Override
  void findBox(VoxelWriter out) {
    if (path.isPresent()) {
      boolean isPlaced =
          solid ? out.tool().devicePosition(segment(), to) : out.tool().touchedPoint(segment(), to);
      if (!isPlaced) {
        return;
      }
      path.get().goTo(to, metric(), radiusMm, from);
    }
    wayMm.set(
        (to.x - from.x) * metric().spacingX(),
        (to.y - from.y) * metric().spacingY(),
        (to.z - from.z) * metric().spacingZ());
    squaredWayMm = wayMm.dot(wayMm);
    include(from.x, from.y, from.z, radiusMm);
    include(to.x, to.y, to.z, radiusMm);
  }

  @Override
  boolean visit(VoxelWriter out, int i, int j, int k) {
    double t = fraction(i + 0.5, j + 0.5, k + 0.5);
    double x = from.x + t * (to.x - from.x);
    double y = from.y + t * (to.y - from.y);
    double z = from.z + t * (to.z - from.z);
    double square = metric().squaredDistance(x, y, z, i + 0.5, j + 0.5, k + 0.5);
    return square <= radiusMm * radiusMm && limits.write(out, segment(), i, j, k, solid);
  }

  /** Returns the fraction of the piece, 0 to 1, at its point nearest to a point of the grid. */
  private double fraction(double x, double y, double z) {
    double along =
        (x - from.x) * metric().spacingX() * wayMm.x
            + (y - from.y) * metric().spacingY() * wayMm.y
            + (z - from.z) * metric().spacingZ() * wayMm.z;
    return squaredWayMm > 0 ? Math.max(0, Math.min(1, along / squaredWayMm)) : 0;
  }
}
