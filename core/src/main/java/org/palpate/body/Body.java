package org.palpate.body;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * A solid in a scene: voxels on a grid of their own, and a pose that maps the rest position of the
 * grid in the world to its present one.
 *
 * <p>Belongs to the haptic thread. Code that edits the voxels must call {@link #voxelsChanged}.
 */
public final class Body {
  /** The number of edits whose boxes are kept; older ones count as edits of the whole grid. */
  private static final int REMEMBERED_EDITS = 128;

  private final String name;
  private final BitCube bits;
  private final VoxelGrid grid;
  private final Mobility mobility;
  private final GridMetric metric;
  private final BrickClearance clearance;
  private final Pose pose = new Pose();
  private final AffineMap restToGrid = new AffineMap();
  private final AffineMap worldToGrid = new AffineMap();
  private final AffineMap otherToGrid = new AffineMap();
  private final AffineMap scratch = new AffineMap();
  private final Vec3 direction = new Vec3();
  private final IntBox[] changes = new IntBox[REMEMBERED_EDITS];
  private final IntBox everything = new IntBox();
  private long edits;
  private long motions;

  /**
   * Creates a body at its rest position.
   *
   * @param name the name, unique in its scene
   * @param bits the voxels, on the grid; kept
   * @param grid the grid at rest
   * @param mobility how the body can move
   */
  public Body(String name, BitCube bits, VoxelGrid grid, Mobility mobility) {
    this.name = name;
    this.bits = bits;
    this.grid = grid;
    this.mobility = mobility;
    metric = GridMetric.of(grid.spacingMm());
    clearance = new BrickClearance(bits);
    for (int n = 0; n < changes.length; n++) {
      changes[n] = new IntBox();
    }
    grid.worldToGrid(restToGrid);
    setPose(pose);
  }

  /** {@return the name, unique in its scene} */
  public String name() {
    return name;
  }

  /** {@return the voxels} */
  public BitCube bits() {
    return bits;
  }

  /** {@return the grid, at rest} */
  public VoxelGrid grid() {
    return grid;
  }

  /** {@return the metric of the grid} */
  public GridMetric metric() {
    return metric;
  }

  /** {@return how the body can move} */
  public Mobility mobility() {
    return mobility;
  }

  /** {@return lower bounds of the distance to the voxels, grid coordinates} */
  public BrickClearance clearance() {
    return clearance;
  }

  /** {@return the pose, from rest to present, world mm; not to be written} */
  public Pose pose() {
    return pose;
  }

  /**
   * Sets the pose. A tool that was placed among bodies refuses to go on after a body moved, until
   * it is placed again.
   *
   * @param newPose from rest to present, world mm; copied
   * @throws IllegalArgumentException if the pose is not finite or the norm of its quaternion is not
   *     1
   */
  public void setPose(Pose newPose) {
    if (!newPose.isFinite() || !newPose.rotation.isUnit()) {
      throw new IllegalArgumentException(
          "the pose of a body must be finite with a unit quaternion: pose=" + newPose);
    }
    pose.set(newPose);
    motions++;
    restToGrid.multiply(scratch.setInverse(pose), worldToGrid);
  }

  /** {@return the number of times that the pose was set, so that others notice a motion} */
  public long motions() {
    return motions;
  }

  /**
   * Writes the map from a tool's frame, mm, to the body's grid coordinates. The same two poses give
   * the same bits.
   *
   * @param tool from the tool's frame to the world, mm
   * @param dest receives the map
   * @return {@code dest}
   */
  public AffineMap toolToGrid(Pose tool, AffineMap dest) {
    return worldToGrid.multiply(scratch.set(tool), dest);
  }

  /**
   * Writes the map from a tool's frame, mm, to the grid coordinates that the body has at another
   * pose. At the present pose it gives the same bits as {@link #toolToGrid(Pose, AffineMap)}.
   *
   * @param bodyPose rest to present, world mm
   * @param tool from the tool's frame to the world, mm
   * @param dest receives the map
   * @return {@code dest}
   */
  public AffineMap toolToGrid(Pose bodyPose, Pose tool, AffineMap dest) {
    restToGrid.multiply(scratch.setInverse(bodyPose), otherToGrid);
    return otherToGrid.multiply(scratch.set(tool), dest);
  }

  /**
   * Writes the world direction of a direction along the axes of the grid.
   *
   * @param alongAxes the direction along the axes of the grid, mm
   * @param dest receives the direction in the world, as long; may be {@code alongAxes}
   * @return {@code dest}
   */
  public Vec3 gridDirectionToWorld(Vec3 alongAxes, Vec3 dest) {
    grid.gridMmToWorld().rotate(alongAxes, direction);
    return pose.rotation.rotate(direction, dest);
  }

  /** {@return the number of edits of the voxels, so that others notice an edit} */
  public long edits() {
    return edits;
  }

  /**
   * {@return the box of voxels that an edit may have changed; not to be written} For an edit long
   * ago it is the box of the whole grid.
   *
   * @param edit the number of the edit: from 0 to {@link #edits} - 1
   */
  public IntBox change(long edit) {
    if (edit < oldestEdit()) {
      everything.clear();
      everything.include(0, 0, 0);
      everything.include(bits.sizeX() - 1, bits.sizeY() - 1, bits.sizeZ() - 1);
      return everything;
    }
    return changes[(int) (edit % REMEMBERED_EDITS)];
  }

  /**
   * Grows a box so that it contains all voxels that edits may have changed.
   *
   * @param seen the number of edits before the first of them
   * @param dest the box of voxels to grow
   */
  public void includeChanges(long seen, IntBox dest) {
    for (long edit = Math.max(seen, oldestEdit() - 1); edit < edits; edit++) {
      dest.include(change(edit));
    }
  }

  /** {@return the number of the oldest edit whose box is remembered} */
  public long oldestEdit() {
    return Math.max(0, edits - REMEMBERED_EDITS);
  }

  /**
   * Records an edit: voxels in a box were added or removed.
   *
   * @param box holds every voxel that changed; copied
   */
  public void voxelsChanged(IntBox box) {
    changes[(int) (edits++ % REMEMBERED_EDITS)].set(box);
    clearance.solidsAdded(box);
  }
}
