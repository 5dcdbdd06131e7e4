package org.palpate.scene;

import java.util.List;
import java.util.Map;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.surface.SurfaceBrick;

/**
 * A segment as it is drawn. Its surface comes brick by brick from any thread; all else is changed
 * through {@link SceneModel}, whose lock guards it.
 */
public final class SceneObject {
  /** Levels of detail: 0 is every voxel, each further one half of the resolution. */
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

  SceneObject(String name, int rgb, RigidTransform pose, Vec3 lowMm, Vec3 highMm) {
    this.name = name;
    this.rgb = rgb;
    this.pose = pose;
    this.lowMm = lowMm;
    this.highMm = highMm;
    levels = List.of(new LevelBricks(), new LevelBricks(), new LevelBricks());
  }

  public String name() {
    return name;
  }

  /** A corner of the box about its solid voxels, grid mm: bit 0 of the number is x, 1 y, 2 z. */
  public Vec3 corner(int number) {
    return new Vec3(
        (number & 1) == 0 ? lowMm.x : highMm.x,
        (number & 2) == 0 ? lowMm.y : highMm.y,
        (number & 4) == 0 ? lowMm.z : highMm.z);
  }

  /** Whether the box of this holds that of another, or is it. */
  boolean surrounds(SceneObject other) {
    return lowMm.x <= other.lowMm.x
        && lowMm.y <= other.lowMm.y
        && lowMm.z <= other.lowMm.z
        && highMm.x >= other.highMm.x
        && highMm.y >= other.highMm.y
        && highMm.z >= other.highMm.z;
  }

  /** The bricks of a level by their numbers; may change while read. */
  public Map<Integer, SurfaceBrick> bricks(int level) {
    return levels.get(level).shown();
  }

  /** Takes a brick's mesh, see {@link LevelBricks#put}. */
  void put(int level, int brick, long begun, SurfaceBrick mesh) {
    levels.get(level).put(brick, begun, mesh);
  }

  synchronized void setComplete(int level) {
    complete[level] = true;
  }

  /** The finest level that is whole; -1 while there is none. */
  public synchronized int finestComplete() {
    for (int level = 0; level < LEVELS; level++) {
      if (complete[level]) {
        return level;
      }
    }
    return -1;
  }

  /** Whether a level is whole. */
  public synchronized boolean isComplete(int level) {
    return complete[level];
  }

  /** Triangles of a level so far. */
  public long triangleCount(int level) {
    return bricks(level).values().stream().mapToLong(SurfaceBrick::triangleCount).sum();
  }
}
