package org.palpate.volume.fracture;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Displaces and rotates the fragments of a bone so that none overlaps or nearly touches another.
 * The largest stays where it is. One thread an instance.
 *
 * <p>Two voxels whose centres lie farther apart than the diagonal of a voxel do not meet, however
 * they are turned. A pose is taken only if all centres of rim voxels lie farther than that, and a
 * margin, from all voxel centres of every other fragment. Rims suffice: of two solids that overlap,
 * one has a rim voxel in the other.
 */
public final class FragmentScatter {
  /** The distance and angle of a displacement; distances relate to the diagonal of the bone. */
  private static final double NEAREST = 0.07;

  private static final double FARTHEST = 0.18;
  private static final double SMALLEST_RAD = Math.PI / 18;
  private static final double LARGEST_RAD = 4 * SMALLEST_RAD;

  /** The least gap between two fragments, longest voxel edges. */
  private static final double LEAST_GAP_EDGES = 2;

  /** After this many failures a fragment is moved farther away at each try. */
  private static final int CROWDED = 200;

  private static final int MOST_TRIES = 2000;
  private static final double FARTHER_A_TRY = 0.001;

  private final Fragments fragments;
  private final VoxelGrid grid;
  private final Uniform random;
  private final List<int[]> rims = new ArrayList<>();
  private final List<Vec3> middles = new ArrayList<>();
  private final List<Pose> poses = new ArrayList<>();
  private final double diagonalMm;
  private final double leastCentresMm;

  private FragmentScatter(Fragments fragments, long seed) {
    this.fragments = fragments;
    grid = fragments.grid();
    random = new Uniform(seed);
    IntBox all = new IntBox();
    for (BitCube bits : fragments.bits()) {
      all.include(bits.bounds());
      rims.add(rim(bits));
      middles.add(middle(bits.bounds()));
    }
    Vec3 spacing = grid.spacingMm();
    diagonalMm = grid.diagonalMm(all);
    leastCentresMm =
        spacing.length() + LEAST_GAP_EDGES * Math.max(spacing.x, Math.max(spacing.y, spacing.z));
  }

  /**
   * {@return a starting pose for each fragment, from its place in the bone to its displaced one}
   *
   * @param fragments the fragments where they rest, the largest first
   * @param seed the seed of the random displacements
   * @param isInside whether displaced fragments must stay inside the grid
   * @throws IllegalArgumentException if no free place is found
   */
  public static List<Pose> scatter(Fragments fragments, long seed, boolean isInside) {
    FragmentScatter scatter = new FragmentScatter(fragments, seed);
    scatter.poses.add(new Pose());
    for (int n = 1; n < fragments.bits().size(); n++) {
      scatter.place(n, isInside);
    }
    return List.copyOf(scatter.poses);
  }

  /** Returns the middle of a box of voxels, world mm. */
  private Vec3 middle(IntBox box) {
    Vec3 p =
        new Vec3(
            (box.lowX + box.highX + 1) / 2.0,
            (box.lowY + box.highY + 1) / 2.0,
            (box.lowZ + box.highZ + 1) / 2.0);
    return grid.gridToWorld(p, p);
  }

  private static int[] rim(BitCube bits) {
    IntStream.Builder found = IntStream.builder();
    bits.forEachRimVoxel((i, j, k) -> found.add(i).add(j).add(k));
    return found.build().toArray();
  }

  private void place(int n, boolean isInside) {
    Vec3 bone = new Vec3();
    middles.forEach(middle -> bone.add(middle, bone));
    bone.mul(1.0 / middles.size(), bone);
    Vec3 outward = middles.get(n).sub(bone, new Vec3());
    outward.mul(1 / Math.max(1e-9, outward.length()), outward);
    for (int tries = 0; tries < MOST_TRIES; tries++) {
      double extra = isInside ? 0 : Math.max(0, tries - CROWDED) * FARTHER_A_TRY;
      Pose pose = candidate(middles.get(n), outward, extra);
      if ((!isInside || staysInside(n, pose)) && isFree(n, pose)) {
        poses.add(pose);
        return;
      }
    }
    throw new IllegalArgumentException(
        "no free place for fragment "
            + (n + 1)
            + " of "
            + middles.size()
            + ": choose fewer fragments or another seed");
  }

  /** Returns a random pose that displaces roughly outwards and rotates about the middle. */
  private Pose candidate(Vec3 middle, Vec3 outward, double extra) {
    Vec3 way = random.direction();
    way.add(outward, way);
    way.mul(1 / Math.max(0.1, way.length()), way);
    way.mul((random.next(NEAREST, FARTHEST) + extra) * diagonalMm, way);
    Vec3 rotation = random.direction();
    rotation.mul(random.next(SMALLEST_RAD, LARGEST_RAD), rotation);
    Pose pose = new Pose();
    pose.rotation.setRotationVector(rotation).normalize();
    Vec3 turned = pose.rotation.rotate(middle, new Vec3());
    pose.translation.set(middle.add(way, way).sub(turned, way));
    return pose;
  }

  private boolean staysInside(int n, Pose pose) {
    IntBox box = fragments.bits().get(n).bounds();
    Vec3 p = new Vec3();
    for (int corner = 0; corner < 8; corner++) {
      p.set(
          (corner & 1) == 0 ? box.lowX : box.highX + 1.0,
          (corner & 2) == 0 ? box.lowY : box.highY + 1.0,
          (corner & 4) == 0 ? box.lowZ : box.highZ + 1.0);
      grid.worldToGrid(pose.transform(grid.gridToWorld(p, p), p), p);
      if (!grid.contains((int) Math.floor(p.x), (int) Math.floor(p.y), (int) Math.floor(p.z))) {
        return false;
      }
    }
    return true;
  }

  private boolean isFree(int n, Pose pose) {
    for (int other = 0; other < poses.size(); other++) {
      if (isNear(n, pose, other, poses.get(other)) || isNear(other, poses.get(other), n, pose)) {
        return false;
      }
    }
    return true;
  }

  /** Whether a rim voxel of one fragment has its centre too near to a voxel of another. */
  private boolean isNear(int one, Pose onePose, int other, Pose otherPose) {
    BitCube bits = fragments.bits().get(other);
    AffineMap oneToOther = new PosedBits(bits, grid, otherPose).gridFrom(grid, onePose);
    int[] rim = rims.get(one);
    Vec3 p = new Vec3();
    for (int v = 0; v < rim.length; v += 3) {
      oneToOther.transform(p.set(rim[v] + 0.5, rim[v + 1] + 0.5, rim[v + 2] + 0.5), p);
      if (isNear(p, bits)) {
        return true;
      }
    }
    return false;
  }

  private boolean isNear(Vec3 p, BitCube bits) {
    Vec3 s = grid.spacingMm();
    IntBox box = bits.bounds();
    double reachX = leastCentresMm / s.x;
    double reachY = leastCentresMm / s.y;
    double reachZ = leastCentresMm / s.z;
    for (int k = first(p.z - reachZ, box.lowZ); k <= last(p.z + reachZ, box.highZ); k++) {
      for (int j = first(p.y - reachY, box.lowY); j <= last(p.y + reachY, box.highY); j++) {
        for (int i = first(p.x - reachX, box.lowX); i <= last(p.x + reachX, box.highX); i++) {
          if (bits.get(i, j, k)) {
            double x = (i + 0.5 - p.x) * s.x;
            double y = (j + 0.5 - p.y) * s.y;
            double z = (k + 0.5 - p.z) * s.z;
            if (x * x + y * y + z * z <= leastCentresMm * leastCentresMm) {
              return true;
            }
          }
        }
      }
    }
    return false;
  }

  private static int first(double coordinate, int low) {
    return (int) Math.max(low, Math.floor(coordinate) - 1);
  }

  private static int last(double coordinate, int high) {
    return (int) Math.min(high, Math.floor(coordinate) + 1);
  }
}
