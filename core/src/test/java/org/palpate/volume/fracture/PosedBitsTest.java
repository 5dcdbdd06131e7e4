package org.palpate.volume.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.FracturePhantom;

class PosedBitsTest {
  private static final int TURNED_POSES = 40;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void agreesWithAskingEveryBodyAboutEveryVoxelCentre() {
    VoxelGrid target = VoxelGrid.ofUnitVoxels(16, 14, 18);
    for (int round = 0; round < 20; round++) {
      List<PosedBits> bodies = new ArrayList<>();
      for (int n = 0; n < 3; n++) {
        bodies.add(body(n));
      }
      List<BitCube> found = PosedBits.resample(bodies, target);
      for (int v = 0; v < 16 * 14 * 18; v++) {
        int i = v % 16;
        int j = v / 16 % 14;
        int k = v / 16 / 14;
        int owner = nearestBody(bodies, target, i, j, k);
        for (int n = 0; n < 3; n++) {
          assertEquals(n == owner, found.get(n).get(i, j, k));
        }
      }
    }
  }

  /** Returns a body on a grid of its own. */
  private PosedBits body(int n) {
    Vec3 spacing = new Vec3(1 + 0.3 * n, 0.8, 1.7 - 0.2 * n);
    RigidTransform axes =
        n < 2
            ? RigidTransform.identity()
            : new RigidTransform(
                new Vec3(0.8, 0.6, 0),
                new Vec3(0.6, -0.8, 0),
                new Vec3(0, 0, 1),
                new Vec3(1, 2, 3));
    return new PosedBits(scattered(12, 9, 7), new VoxelGrid(12, 9, 7, spacing, axes), pose());
  }

  @Test
  void aGridAroundBodiesHoldsTheCentresOfAllVoxels() {
    RigidTransform axes =
        new RigidTransform(
            new Vec3(0, 1, 0), new Vec3(-0.6, 0, 0.8), new Vec3(0.8, 0, 0.6), new Vec3(4, -3, 2));
    VoxelGrid like = new VoxelGrid(10, 11, 12, new Vec3(1.5, 0.5, 1), axes);
    for (int round = 0; round < 20; round++) {
      List<PosedBits> bodies = List.of(body(0), body(1), body(2));
      VoxelGrid around = PosedBits.gridAround(bodies, like);
      long outside = 0;
      for (PosedBits body : bodies) {
        assertEquals(0, body.voxelsOutside(around));
        outside += body.voxelsOutside(like);
        assertEquals(outside(body, like), body.voxelsOutside(like));
      }
      if (outside == 0) {
        assertSame(like, around);
      }
      Vec3 corner = around.worldToGrid(like.gridToWorld(new Vec3(), new Vec3()), new Vec3());
      for (int axis = 0; axis < 3; axis++) {
        assertEquals(Math.rint(corner.get(axis)), corner.get(axis), 1e-9, "voxels lie on voxels");
        assertTrue(corner.get(axis) > -1e-9);
      }
      assertSame(around, PosedBits.gridAround(bodies, around));
    }
  }

  /** Counts the voxels of a body whose centres lie outside a grid, one by one. */
  private static long outside(PosedBits body, VoxelGrid grid) {
    long outside = 0;
    for (int v = 0; v < 12 * 9 * 7; v++) {
      int k = v / 108;
      Vec3 p = new Vec3(v % 12 + 0.5, v / 12 % 9 + 0.5, k + 0.5);
      if (body.bits().get((int) p.x, (int) p.y, (int) p.z)) {
        body.pose().transform(body.grid().gridToWorld(p, p), p);
        grid.worldToGrid(p, p);
        outside +=
            grid.contains((int) Math.floor(p.x), (int) Math.floor(p.y), (int) Math.floor(p.z))
                ? 0
                : 1;
      }
    }
    return outside;
  }

  @Test
  void aGridAroundBodiesThatLieFarApartHasLargerVoxels() {
    PosedBits near = body(0);
    Pose far = new Pose();
    far.translation.set(1e5, -2e5, 3e5);
    PosedBits other = new PosedBits(near.bits(), near.grid(), far);
    VoxelGrid around = PosedBits.gridAround(List.of(near, other), near.grid());
    assertTrue(around.voxelCount() <= 1 << 26);
    assertEquals(0, near.voxelsOutside(around) + other.voxelsOutside(around));
  }

  private static int nearestBody(List<PosedBits> bodies, VoxelGrid target, int i, int j, int k) {
    Vec3 world = target.gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
    int owner = -1;
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n < bodies.size(); n++) {
      PosedBits body = bodies.get(n);
      Vec3 rest = body.pose().inverseTransform(world, new Vec3());
      Vec3 at = body.grid().worldToGrid(rest, new Vec3());
      Vec3 voxel = new Vec3(Math.floor(at.x), Math.floor(at.y), Math.floor(at.z));
      if (body.bits().get((int) voxel.x, (int) voxel.y, (int) voxel.z)) {
        Vec3 centre = new Vec3(voxel.x + 0.5, voxel.y + 0.5, voxel.z + 0.5);
        double distance = body.grid().gridToWorld(centre, centre).sub(rest, centre).length();
        if (distance < least) {
          least = distance;
          owner = n;
        }
      }
    }
    return owner;
  }

  @Test
  void partsThatAreTurnedTogetherLeaveNoGapAlongTheCut() {
    FracturePhantom phantom = new FracturePhantom(96, new FractureSpec(4, 1, 0));
    Fragments fragments = phantom.fragments();
    Pose pose = new Pose();
    pose.rotation.setRotationVector(new Vec3(0.2, -0.15, 0.17));
    pose.translation.set(10.3, -20.4, 15.8);
    BitCube whole =
        PosedBits.resample(
                List.of(new PosedBits(phantom.bone(), phantom.grid(), pose)), phantom.grid())
            .get(0);
    long sum =
        PosedBits.resample(fragments.segments(), List.of(pose, pose, pose, pose), fragments.grid())
            .segments()
            .stream()
            .mapToLong(segment -> segment.bits().solidCount())
            .sum();
    assertEquals(whole.solidCount(), sum);
  }

  /**
   * A turned bone gains and loses voxels at random along its surface of S voxel faces. The standard
   * deviation is 0.26 sqrt(S) voxels: S / (8 pi^3) times the sum of 1 / k^4 over all points k of
   * the lattice but 0.
   */
  @Test
  void aTurnedBoneChangesItsVolumeByAsMuchAsItsSurfaceExplains() {
    FracturePhantom phantom = new FracturePhantom(96, new FractureSpec(4, 1, 0));
    BitCube bone = phantom.bone();
    double expected = 0.26 * Math.sqrt(faces(bone));
    double mean = 0;
    double meanSquare = 0;
    for (int n = 0; n < TURNED_POSES; n++) {
      PosedBits turned = new PosedBits(bone, phantom.grid(), RandomGeometry.pose(random, 3));
      VoxelGrid target = PosedBits.gridAround(List.of(turned), phantom.grid());
      BitCube found = PosedBits.resample(List.of(turned), target).get(0);
      double change = found.solidCount() - bone.solidCount();
      mean += change / TURNED_POSES;
      meanSquare += change * change / TURNED_POSES;
      assertEquals(0, change, 5 * expected);
    }
    double rms = Math.sqrt(meanSquare);
    String text = "rms change " + rms + ", mean " + mean + ", expected " + expected + " voxels";
    assertTrue(rms > 0.5 * expected && rms < 1.5 * expected, text);
    assertEquals(0, mean, 5 * expected / Math.sqrt(TURNED_POSES), text);
  }

  /** Counts the faces between solid voxels and empty ones. */
  private static int faces(BitCube bits) {
    int[] faces = new int[1];
    bits.forEachRimVoxel(
        (i, j, k) -> {
          for (int side = -1; side <= 1; side += 2) {
            faces[0] += bits.get(i + side, j, k) ? 0 : 1;
            faces[0] += bits.get(i, j + side, k) ? 0 : 1;
            faces[0] += bits.get(i, j, k + side) ? 0 : 1;
          }
        });
    return faces[0];
  }

  private Pose pose() {
    Pose pose = new Pose();
    pose.rotation.setRotationVector(
        new Vec3(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-2, 2)));
    pose.translation.set(random.nextDouble(12), random.nextDouble(12), random.nextDouble(14));
    return pose;
  }

  private BitCube scattered(int sizeX, int sizeY, int sizeZ) {
    BitCube bits = new BitCube(sizeX, sizeY, sizeZ);
    for (int v = 0; v < sizeX * sizeY * sizeZ; v++) {
      if (random.nextInt(3) > 0) {
        bits.set(v % sizeX, v / sizeX % sizeY, v / sizeX / sizeY);
      }
    }
    return bits;
  }
}
