package org.palpate.collision;

import java.util.List;
import org.palpate.geometry.IntBox;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.volume.BitCube;

/**
 * The solids that a tool collides with: the union of bit cubes over one grid, one cube an object. A
 * {@code ProxySolver} sees the scene through this class alone.
 *
 * <p>Frame: grid coordinates. Voxel (i,j,k) is the closed cell from (i,j,k) to (i+1,j+1,k+1), and
 * everything outside the grid is empty.
 *
 * <p>Thread: the haptic thread alone calls this class, and it alone changes the cubes, between
 * frames. Any other thread queues its edits, see {@code org.palpate.edit.EditQueue}. After a change
 * of the solids, call {@code ProxySolver.reset}; {@code org.palpate.frame.PointFrame} does both.
 *
 * <p>Cost: a query looks at every cube of a scene of up to 8. A larger scene has a broad phase, so
 * that a query looks only at the cubes whose bounds are near. Queries allocate nothing and throw no
 * exception for any coordinates.
 */
public final class CollisionScene {
  /** In a smaller scene a look at each cube is as fast as the broad phase. */
  private static final int MIN_CUBES_FOR_BROAD_PHASE = 9;

  private static final int NO_OBJECT = -1;

  private final BitCube[] cubes;
  private final RayHit candidateHit = new RayHit();

  /** Null if every query looks at every cube. */
  private BroadPhase broadPhase;

  /** The cubes that a query looks at: all, or those that the broad phase found. */
  private BitCube[] candidates;

  /**
   * Creates a scene of {@code cubes}, which stay the caller's.
   *
   * <p>In a scene of up to 8 cubes any cube may change between frames. In a larger scene only those
   * may change that {@link #cube} or {@link #replace} returned; after any other change call {@link
   * #boundsChanged}.
   *
   * @param cubes one cube an object, all of the same sizes; their order numbers the objects
   */
  public CollisionScene(List<BitCube> cubes) {
    this(cubes, cubes.size() >= MIN_CUBES_FOR_BROAD_PHASE);
  }

  private CollisionScene(List<BitCube> cubes, boolean hasBroadPhase) {
    this.cubes = cubes.toArray(new BitCube[0]);
    use(hasBroadPhase ? new BroadPhase(this.cubes) : null);
  }

  /** Returns a scene with a broad phase, whatever the number of cubes. Its answers are the same. */
  static CollisionScene withBroadPhase(List<BitCube> cubes) {
    return new CollisionScene(cubes, true);
  }

  /** Returns a scene whose queries look at every cube. Its answers are the same. */
  static CollisionScene withoutBroadPhase(List<BitCube> cubes) {
    return new CollisionScene(cubes, false);
  }

  private void use(BroadPhase newBroadPhase) {
    broadPhase = newBroadPhase;
    candidates = newBroadPhase == null ? cubes : newBroadPhase.candidates();
  }

  /**
   * Takes over the present bounds of all cubes. Needed only if a cube of a scene of more than 8
   * grew without {@link #cube} or {@link #replace}. Allocates.
   */
  public void boundsChanged() {
    if (broadPhase != null) {
      use(broadPhase.rebuilt());
    }
  }

  /** Returns how often the broad phase searched its tree; 0 without a broad phase. */
  long searches() {
    return broadPhase == null ? 0 : broadPhase.searches();
  }

  /**
   * Adds the number of cubes that queries left out to other counters.
   *
   * @param dest receives the count
   */
  public void addSkips(SkipCounters dest) {
    dest.add(SkipKind.FAR_OBJECTS, broadPhase == null ? 0 : broadPhase.skippedCubes());
  }

  /**
   * {@return whether a voxel is solid in any cube}
   *
   * @param i the voxel's number along x; one outside the grid is empty
   * @param j its number along y
   * @param k its number along z
   */
  public boolean isSolid(int i, int j, int k) {
    int count = findCandidates(i, j, k, i, j, k);
    for (int n = 0; n < count; n++) {
      if (candidates[n].get(i, j, k)) {
        return true;
      }
    }
    return false;
  }

  /**
   * {@return the index of the object that has a solid voxel: the first of several, or -1 if there
   * is none}
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  public int objectAt(int i, int j, int k) {
    int count = findCandidates(i, j, k, i, j, k);
    for (int n = 0; n < count; n++) {
      if (candidates[n].get(i, j, k)) {
        return broadPhase == null ? n : broadPhase.index(n);
      }
    }
    return NO_OBJECT;
  }

  /**
   * {@return whether a point touches a closed solid voxel: lies in it or on its face, edge or
   * corner} Exact. False if a coordinate is NaN, infinite, or larger than any voxel number.
   *
   * @param x the point along x, grid coordinates
   * @param y its y component
   * @param z its z component
   */
  public boolean touches(double x, double y, double z) {
    if (!(hasCell(x) && hasCell(y) && hasCell(z))) {
      return false;
    }
    int lowX = lowestTouchedCell(x);
    int lowY = lowestTouchedCell(y);
    int lowZ = lowestTouchedCell(z);
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

  /** Whether the cells around a coordinate have int numbers. */
  private static boolean hasCell(double coordinate) {
    return Math.abs(coordinate) < Integer.MAX_VALUE - 1;
  }

  private static int lowestTouchedCell(double coordinate) {
    return (int) Math.ceil(coordinate) - 1;
  }

  /**
   * {@return the solid voxels of a brick as the bits of a word, see {@link BitCube#brick}}
   *
   * @param brickX brick coordinates: voxel coordinates shifted right by {@link BitCube#BRICK_SHIFT}
   * @param brickY the same along y
   * @param brickZ the same along z
   */
  public long brick(int brickX, int brickY, int brickZ) {
    if (cubes.length == 1) {
      return cubes[0].brick(brickX, brickY, brickZ);
    }
    int count = findCandidatesOfWindow(brickX << 2, brickY << 2, brickZ << 2);
    long word = 0;
    for (int n = 0; n < count; n++) {
      word |= candidates[n].brick(brickX, brickY, brickZ);
    }
    return word;
  }

  /**
   * {@return the solid voxels of a window of 4x4x4 voxels as the bits of a word, see {@link
   * BitCube#window}}
   *
   * @param i the number of the lowest voxel along x
   * @param j its number along y
   * @param k its number along z
   */
  public long window(int i, int j, int k) {
    int count = findCandidatesOfWindow(i, j, k);
    long word = 0;
    for (int n = 0; n < count; n++) {
      word |= candidates[n].window(i, j, k);
    }
    return word;
  }

  /**
   * Finds the first solid voxel on a ray over all cubes. Of equal hits the first object's counts.
   *
   * @param caster the rule by which the ray meets a voxel; its scratch memory is used
   * @param ray two finite points in grid coordinates
   * @param hit receives the hit if the answer is true; undefined after a miss
   * @return whether the ray meets a solid voxel, see {@link RayCaster#cast}
   */
  public boolean cast(RayCaster caster, Ray ray, RayHit hit) {
    if (cubes.length == 1) {
      return caster.cast(cubes[0], ray, hit);
    }
    int count = findCandidatesOf(ray);
    boolean found = false;
    for (int n = 0; n < count; n++) {
      if (caster.cast(candidates[n], ray, candidateHit) && !(found && hit.t <= candidateHit.t)) {
        hit.set(candidateHit);
        found = true;
      }
    }
    return found;
  }

  private int findCandidatesOf(Ray ray) {
    if (broadPhase == null) {
      return cubes.length;
    }
    return broadPhase.find(
        cellBelow(ray.fromX, ray.toX),
        cellBelow(ray.fromY, ray.toY),
        cellBelow(ray.fromZ, ray.toZ),
        cellAbove(ray.fromX, ray.toX),
        cellAbove(ray.fromY, ray.toY),
        cellAbove(ray.fromZ, ray.toZ));
  }

  /** Returns a cell below all that the ray touches; beyond the numbers of cells the lowest one. */
  private static int cellBelow(double from, double to) {
    return (int) (Math.floor(Math.min(from, to)) - 1);
  }

  private static int cellAbove(double from, double to) {
    return (int) (Math.floor(Math.max(from, to)) + 1);
  }

  /** Finds the candidates of the 4x4x4 voxels from (i,j,k) on, whose numbers may overflow. */
  private int findCandidatesOfWindow(int i, int j, int k) {
    return findCandidates(i, j, k, Math.max(i, i + 3), Math.max(j, j + 3), Math.max(k, k + 3));
  }

  /** Finds the candidates of a box of voxels and returns their number. */
  private int findCandidates(int lowX, int lowY, int lowZ, int highX, int highY, int highZ) {
    return broadPhase == null
        ? cubes.length
        : broadPhase.find(lowX, lowY, lowZ, highX, highY, highZ);
  }

  /**
   * Writes a box that holds every solid voxel of all cubes.
   *
   * @param dest receives the box; empty if there is none
   */
  public void bounds(IntBox dest) {
    dest.clear();
    for (BitCube cube : cubes) {
      dest.include(cube.bounds());
    }
  }

  /**
   * {@return the cube of an object for editing} From now on every query looks at it, because its
   * bounds may grow.
   *
   * @param index the object, in the order in which the cubes were given
   */
  public BitCube cube(int index) {
    keepCandidate(index);
    return cubes[index];
  }

  /**
   * Replaces the cube of an object by one of the same sizes.
   *
   * @param index the index of the object in the scene
   * @param fresh the new cube; the scene owns it from now on
   * @return the replaced cube, which is the caller's from now on
   */
  public BitCube replace(int index, BitCube fresh) {
    BitCube replaced = cubes[index];
    cubes[index] = fresh;
    keepCandidate(index);
    return replaced;
  }

  private void keepCandidate(int index) {
    if (broadPhase != null) {
      broadPhase.keep(index);
    }
  }
}
