package org.palpate.proxy;

import java.util.List;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;

/**
 * The solids that stand in the way: the union of some bit cubes over one grid. What a solver sees
 * of the scene.
 *
 * <p>Belongs to the haptic thread.
 */
public final class Obstacles {
  private final BitCube[] cubes;
  private final RayHit candidate = new RayHit();

  /** All of {@code cubes}, which stay the caller's and may change between frames. */
  public Obstacles(List<BitCube> cubes) {
    this.cubes = cubes.toArray(new BitCube[0]);
  }

  /** Whether voxel (i,j,k) is solid in any cube; outside all is empty. */
  public boolean isSolid(int i, int j, int k) {
    for (BitCube cube : cubes) {
      if (cube.get(i, j, k)) {
        return true;
      }
    }
    return false;
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
    for (BitCube cube : cubes) {
      word |= cube.brick(brickX, brickY, brickZ);
    }
    return word;
  }

  /** The solid voxels of the 4x4x4 from (i,j,k) on, as {@link BitCube#window}. */
  public long window(int i, int j, int k) {
    long word = 0;
    for (BitCube cube : cubes) {
      word |= cube.window(i, j, k);
    }
    return word;
  }

  /** Finds the first hit over all cubes; see {@link RayCaster#cast}. */
  public boolean cast(RayCaster caster, Ray ray, RayHit hit) {
    if (cubes.length == 1) {
      return caster.cast(cubes[0], ray, hit);
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

  /** The cube at {@code index}, in the order in which they were given. */
  public BitCube cube(int index) {
    return cubes[index];
  }

  /** Puts another cube of the same sizes in the place of one, and returns that. */
  public BitCube replace(int index, BitCube fresh) {
    BitCube replaced = cubes[index];
    cubes[index] = fresh;
    return replaced;
  }
}
