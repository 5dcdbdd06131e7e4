package org.palpate.collision;

import java.util.List;
import org.palpate.geometry.IntBox;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;

/**
 * The solids that stand in the way: the union of some bit cubes over one grid. What a solver sees
 * of the scene. Of many cubes only those are looked at whose bounds are near.
 *
 * <p>Belongs to the haptic thread.
 */
public final class CollisionScene {
  /** With fewer, looking at each is as fast as knowing which are near. */
  private static final int MANY = 8;

  private final BitCube[] cubes;
  private final RayHit candidate = new RayHit();

  /** Null where all cubes are looked at. */
  private BroadPhase nearCubes;

  /**
   * All of {@code cubes}, which stay the caller's and may change between frames: any of up to 8,
   * and of more those that {@link #cube} or {@link #replace} gave; else say {@link #boundsChanged}.
   */
  public CollisionScene(List<BitCube> cubes) {
    this(cubes, cubes.size() > MANY);
  }

  /**
   * All of {@code cubes}, with the choice of how they are searched; answers are the same.
   *
   * @param byTree whether to look only at those whose bounds are near
   */
  public CollisionScene(List<BitCube> cubes, boolean byTree) {
    this.cubes = cubes.toArray(new BitCube[0]);
    nearCubes = byTree ? new BroadPhase(this.cubes) : null;
  }

  /**
   * To be told where the bounds of a cube may have grown otherwise than through this. Allocates.
   */
  public void boundsChanged() {
    nearCubes = nearCubes == null ? null : nearCubes.anew();
  }

  /** How often it was searched which cubes are near; 0 where all are looked at. */
  public long searches() {
    return nearCubes == null ? 0 : nearCubes.searches();
  }

  /** How many cubes were left out, over all questions; 0 where all are looked at. */
  public long skippedCubes() {
    return nearCubes == null ? 0 : nearCubes.skipped();
  }

  /** Whether voxel (i,j,k) is solid in any cube; outside all is empty. */
  public boolean isSolid(int i, int j, int k) {
    if (nearCubes != null) {
      return isSolidInNear(i, j, k);
    }
    for (BitCube cube : cubes) {
      if (cube.get(i, j, k)) {
        return true;
      }
    }
    return false;
  }

  private boolean isSolidInNear(int i, int j, int k) {
    int count = nearCubes.find(i, j, k, i, j, k);
    for (int n = 0; n < count; n++) {
      if (nearCubes.cube(n).get(i, j, k)) {
        return true;
      }
    }
    return false;
  }

  /** The first object in which voxel (i,j,k) is solid, by its place; -1 where it is in none. */
  public int objectAt(int i, int j, int k) {
    if (nearCubes != null) {
      int count = nearCubes.find(i, j, k, i, j, k);
      for (int n = 0; n < count; n++) {
        if (nearCubes.cube(n).get(i, j, k)) {
          return nearCubes.place(n);
        }
      }
      return -1;
    }
    for (int n = 0; n < cubes.length; n++) {
      if (cubes[n].get(i, j, k)) {
        return n;
      }
    }
    return -1;
  }

  /**
   * Whether the point touches a closed solid voxel: one that it lies in, on a face, an edge or a
   * corner of. Exact.
   */
  public boolean touches(double x, double y, double z) {
    if (!(isNear(x) && isNear(y) && isNear(z))) {
      return false;
    }
    int lowX = lowestCell(x);
    int lowY = lowestCell(y);
    int lowZ = lowestCell(z);
    for (int k = lowZ; k <= z; k++) {
      for (int j = lowY; j <= y; j++) {
        for (int i = lowX; i <= x; i++) {
          if (isSolid(i, j, k)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Whether the cells around a coordinate have numbers at all. */
  private static boolean isNear(double coordinate) {
    return Math.abs(coordinate) < Integer.MAX_VALUE - 1;
  }

  private static int lowestCell(double coordinate) {
    return (int) Math.ceil(coordinate) - 1;
  }

  /** The solid voxels of a brick, by brick coordinates, as {@link BitCube#brick}. */
  public long brick(int brickX, int brickY, int brickZ) {
    long word = 0;
    if (nearCubes != null) {
      int count = findNear(brickX << 2, brickY << 2, brickZ << 2);
      for (int n = 0; n < count; n++) {
        word |= nearCubes.cube(n).brick(brickX, brickY, brickZ);
      }
      return word;
    }
    for (BitCube cube : cubes) {
      word |= cube.brick(brickX, brickY, brickZ);
    }
    return word;
  }

  /** The solid voxels of the 4x4x4 from (i,j,k) on, as {@link BitCube#window}. */
  public long window(int i, int j, int k) {
    long word = 0;
    if (nearCubes != null) {
      int count = findNear(i, j, k);
      for (int n = 0; n < count; n++) {
        word |= nearCubes.cube(n).window(i, j, k);
      }
      return word;
    }
    for (BitCube cube : cubes) {
      word |= cube.window(i, j, k);
    }
    return word;
  }

  /** A box that holds every solid voxel of all cubes. */
  void bounds(IntBox dest) {
    dest.clear();
    for (BitCube cube : cubes) {
      IntBox box = cube.bounds();
      if (!box.isEmpty()) {
        dest.include(box.lowX, box.lowY, box.lowZ);
        dest.include(box.highX, box.highY, box.highZ);
      }
    }
  }

  /** The cubes near 4x4x4 voxels, of which some may have numbers beyond all numbers. */
  private int findNear(int i, int j, int k) {
    return nearCubes.find(i, j, k, Math.max(i, i + 3), Math.max(j, j + 3), Math.max(k, k + 3));
  }

  /** Finds the first hit over all cubes; see {@link RayCaster#cast}. */
  public boolean cast(RayCaster caster, Ray ray, RayHit hit) {
    if (cubes.length == 1) {
      return caster.cast(cubes[0], ray, hit);
    }
    if (nearCubes != null) {
      return castAtNear(caster, ray, hit);
    }
    boolean found = false;
    for (BitCube cube : cubes) {
      if (caster.cast(cube, ray, candidate) && !(found && hit.t <= candidate.t)) {
        hit.set(candidate);
        found = true;
      }
    }
    return found;
  }

  private boolean castAtNear(RayCaster caster, Ray ray, RayHit hit) {
    int count =
        nearCubes.find(
            below(ray.fromX, ray.toX),
            below(ray.fromY, ray.toY),
            below(ray.fromZ, ray.toZ),
            above(ray.fromX, ray.toX),
            above(ray.fromY, ray.toY),
            above(ray.fromZ, ray.toZ));
    boolean found = false;
    for (int n = 0; n < count; n++) {
      if (caster.cast(nearCubes.cube(n), ray, candidate) && !(found && hit.t <= candidate.t)) {
        hit.set(candidate);
        found = true;
      }
    }
    return found;
  }

  /** A cell below all that the way touches; the lowest number where that has none. */
  private static int below(double from, double to) {
    return (int) (Math.floor(Math.min(from, to)) - 1);
  }

  private static int above(double from, double to) {
    return (int) (Math.floor(Math.max(from, to)) + 1);
  }

  /**
   * The cube at {@code index}, in the order in which they were given. It may be edited: from now on
   * it is always looked at.
   */
  public BitCube cube(int index) {
    loosen(index);
    return cubes[index];
  }

  /** Puts another cube of the same sizes in the place of one, and returns that. */
  public BitCube replace(int index, BitCube fresh) {
    BitCube replaced = cubes[index];
    cubes[index] = fresh;
    loosen(index);
    return replaced;
  }

  private void loosen(int index) {
    if (nearCubes != null) {
      nearCubes.loosen(index);
    }
  }
}
