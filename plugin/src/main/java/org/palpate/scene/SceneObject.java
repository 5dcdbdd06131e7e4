package org.palpate.scene;

import java.util.List;
import java.util.Map;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.surface.SurfaceBrick;
import org.palpate.scene.surface.SurfaceBuilder;
import org.palpate.volume.BitCube;

/**
 * A segment as it is drawn. Any thread delivers surface bricks; {@link SceneModel} changes
 * everything else under its lock.
 */
public final class SceneObject {
  /** Number of levels of detail: level 0 has full resolution, each further level half of it. */
  public static final int LEVELS = 3;

  private final String name;
  private final Vec3 lowMm;
  private final Vec3 highMm;
  private final List<LevelBricks> levels;
  private final boolean[] complete = new boolean[LEVELS];
  int rgb;
  double opacity = 1;
  boolean visible = true;
  RigidTransform pose;

  /** Whether it is a ghost itself, which the mouse does not meet. */
  boolean isGhost;

  /** The pose at which a faint copy is drawn, or null. */
  RigidTransform ghost;

  /** Colours a part of the surface, or null. */
  SurfaceTint tint;

  SceneObject(String name, int rgb, RigidTransform pose, Vec3 lowMm, Vec3 highMm) {
    this.name = name;
    this.rgb = rgb;
    this.pose = pose;
    this.lowMm = lowMm;
    this.highMm = highMm;
    levels = List.of(new LevelBricks(), new LevelBricks(), new LevelBricks());
  }

  /** Returns the name. */
  public String name() {
    return name;
  }

  /**
   * Returns a corner of the box of its solid voxels, grid mm. Bit 0 of the number is x, bit 1 y,
   * bit 2 z.
   */
  public Vec3 corner(int number) {
    return new Vec3(
        (number & 1) == 0 ? lowMm.x : highMm.x,
        (number & 2) == 0 ? lowMm.y : highMm.y,
        (number & 4) == 0 ? lowMm.z : highMm.z);
  }

  /** Grows the box to the whole grid. */
  void includeGrid(Vec3 sizesMm) {
    lowMm.set(0, 0, 0);
    highMm.set(sizesMm);
  }

  /** Whether this box contains the box of another segment. */
  boolean encloses(SceneObject other) {
    return lowMm.x <= other.lowMm.x
        && lowMm.y <= other.lowMm.y
        && lowMm.z <= other.lowMm.z
        && highMm.x >= other.highMm.x
        && highMm.y >= other.highMm.y
        && highMm.z >= other.highMm.z;
  }

  /** Returns the bricks of a level by their numbers. The map may change while it is read. */
  public Map<Integer, SurfaceBrick> bricks(int level) {
    return levels.get(level).shown();
  }

  /** Returns the place where a level keeps the bricks of a cube, and of no other from now on. */
  SurfaceBuilder.Store store(int level, BitCube bits) {
    return levels.get(level).storeOf(bits);
  }

  /** Records that a level is complete. */
  synchronized void setComplete(int level) {
    complete[level] = true;
  }

  /** Returns the finest complete level; -1 if there is none. */
  public synchronized int finestComplete() {
    for (int level = 0; level < LEVELS; level++) {
      if (complete[level]) {
        return level;
      }
    }
    return -1;
  }

  /** Whether a level is complete. */
  public synchronized boolean isComplete(int level) {
    return complete[level];
  }

  /** Returns the number of triangles of a level so far. */
  public long triangleCount(int level) {
    return bricks(level).values().stream().mapToLong(SurfaceBrick::triangleCount).sum();
  }
}
