package org.palpate.volume.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.FracturePhantom;

class PosedBitsTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void agreesWithAskingEveryBodyAboutEveryVoxelCentre() {
    VoxelGrid grid = new VoxelGrid(12, 9, 7, new Vec3(1, 0.8, 1.7), RigidTransform.identity());
    VoxelGrid target = VoxelGrid.ofUnitVoxels(16, 14, 18);
    for (int round = 0; round < 20; round++) {
      List<PosedBits> bodies = new ArrayList<>();
      for (int n = 0; n < 3; n++) {
        bodies.add(new PosedBits(scattered(12, 9, 7), grid, pose()));
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
        PosedBits.resample(fragments.segments(), List.of(pose, pose, pose, pose))
            .segments()
            .stream()
            .mapToLong(segment -> segment.bits().solidCount())
            .sum();
    assertEquals(whole.solidCount(), sum);
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
