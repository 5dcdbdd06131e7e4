package org.palpate.benchmarks.stress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.collision.CollisionScene;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.BitCube;

/** Checks what attacks feed to solvers, and what they keep of a failure. */
class HostileInputTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_128);
  private static final BitCube CUBE = new BitCube(6, 7, 8);

  private static List<Vec3> hand(long seed, int frames) {
    HostileHand hand = new HostileHand(new SplittableRandom(seed), CUBE);
    Vec3 device = new Vec3(1, 2, 3);
    List<Vec3> all = new ArrayList<>();
    for (int frame = 0; frame < frames; frame++) {
      all.add(new Vec3().set(hand.next(new Vec3(0.25, 0.5, 7.75), device)));
    }
    return all;
  }

  @Test
  void theHandIsFiniteAndTheSeedAloneDecidesWhereItGoes() {
    List<Vec3> hand = hand(SEED, 5_000);
    List<Vec3> same = hand(SEED, 5_000);
    List<Vec3> other = hand(SEED + 1, 5_000);
    int differing = 0;
    for (int n = 0; n < hand.size(); n++) {
      assertTrue(hand.get(n).isFinite(), "frame=" + n);
      assertTrue(hand.get(n).sameBits(same.get(n)), "frame=" + n);
      differing += hand.get(n).sameBits(other.get(n)) ? 0 : 1;
    }
    assertTrue(differing > 4_000, "differing=" + differing);
  }

  @Test
  void theHandRestsJumpsFarAwayAndAimsAtPlanesAndAtThePoint() {
    List<Vec3> hand = hand(SEED, 20_000);
    int planes = 0;
    int far = 0;
    int beside = 0;
    int atPoint = 0;
    int longestRest = 0;
    int rest = 0;
    for (int n = 1; n < hand.size(); n++) {
      double x = hand.get(n).x;
      planes += x == Math.rint(x) ? 1 : 0;
      far += Math.abs(x) > 1e9 ? 1 : 0;
      boolean isBeside = x != Math.rint(x) && Math.abs(x - Math.rint(x)) <= 2 * Math.ulp(x);
      beside += isBeside ? 1 : 0;
      atPoint += x == 0.25 ? 1 : 0;
      rest = hand.get(n).sameBits(hand.get(n - 1)) ? rest + 1 : 0;
      longestRest = Math.max(longestRest, rest);
    }
    assertTrue(planes > 2_000 && beside > 500, planes + " " + beside);
    assertTrue(far > 5 && far < 1_000 && atPoint > 500, far + " " + atPoint);
    assertTrue(longestRest >= 15 && longestRest < 60, "longestRest=" + longestRest);
  }

  @Test
  void theDeviceRepeatsSamplesTurnsBackItsClockAndReportsWhatIsNoPosition() {
    SplittableRandom random = new SplittableRandom(SEED);
    FaultyDevice device =
        new FaultyDevice(random, new HostileHand(random, CUBE), new Vec3(1, 1, 1));
    DeviceState state = new DeviceState();
    int repeated = 0;
    int stopped = 0;
    int back = 0;
    int notFinite = 0;
    for (int n = 0; n < 10_000; n++) {
      long before = state.timeNanos;
      if (device.read(state) == ReadStatus.REPEATED) {
        repeated++;
        assertEquals(before, state.timeNanos);
      } else {
        stopped += state.timeNanos == before ? 1 : 0;
        back += state.timeNanos < before ? 1 : 0;
        notFinite += state.positionMm.isFinite() ? 0 : 1;
      }
    }
    for (int count : new int[] {repeated, stopped, back, notFinite}) {
      assertTrue(count > 150 && count < 400, "one read in 40 each, not " + count);
    }
  }

  @Test
  void noMoreThanThreeWritesFailInARowAndTheForceIsKnownAllTheSame() {
    SplittableRandom random = new SplittableRandom(SEED);
    FaultyDevice device =
        new FaultyDevice(random, new HostileHand(random, CUBE), new Vec3(1, 1, 1));
    int failed = 0;
    int inARow = 0;
    for (int n = 0; n < 50_000; n++) {
      Vec3 force = new Vec3(n, 0, 0);
      boolean reached = device.write(force, new Vec3());
      inARow = reached ? 0 : inARow + 1;
      failed += reached ? 0 : 1;
      assertTrue(inARow <= 3);
      assertTrue(force.sameBits(device.lastForce()));
    }
    assertTrue(failed > 700 && failed < 1_300, "failed=" + failed);
  }

  @Test
  void everyKindOfSceneAppearsAndHasASolid() {
    SplittableRandom random = new SplittableRandom(SEED);
    TreeSet<String> kinds = new TreeSet<>();
    for (int n = 0; n < 200; n++) {
      HostileScene scene = HostileScene.next(random);
      kinds.add(scene.kind());
      assertTrue(scene.bits().solidCount() > 0, scene.kind());
      assertTrue(scene.maxStepMm() > 0 && scene.spacingMm().x > 0, scene.kind());
    }
    assertEquals(11, kinds.size(), kinds.toString());
  }

  @Test
  void aSceneIsTheSameForTheSameSeed() {
    HostileScene one = HostileScene.next(new SplittableRandom(SEED));
    HostileScene two = HostileScene.next(new SplittableRandom(SEED));
    assertEquals(one.kind(), two.kind());
    assertEquals(one.maxStepMm(), two.maxStepMm());
    assertTrue(one.spacingMm().sameBits(two.spacingMm()));
    for (int z = 0; z < one.bits().bricksZ(); z++) {
      for (int y = 0; y < one.bits().bricksY(); y++) {
        for (int x = 0; x < one.bits().bricksX(); x++) {
          assertEquals(one.bits().brick(x, y, z), two.bits().brick(x, y, z));
        }
      }
    }
  }

  /** Goes straight to the device, through solids. */
  private static final class Careless implements ProxySolver {
    @Override
    public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
      Vec3 p = point.position;
      point.legs.clear();
      if (!p.sameBits(device)) {
        point.legs.add(p.x, p.y, p.z, device.x, device.y, device.z, 0, false);
        p.set(device);
      }
    }
  }

  @Test
  void aFailureShrinksToTheOneFrameAndTheOneVoxelThatItNeeds() {
    BitCube bits = new BitCube(6, 6, 6);
    for (int n = 0; n < 36; n++) {
      bits.set(2, n % 6, n / 6);
    }
    HostileScene scene = new HostileScene("wall", bits, new Vec3(1, 1, 1), 1e9);
    List<Vec3> devices = new ArrayList<>();
    for (int n = 0; n < 20; n++) {
      devices.add(new Vec3(0.5 + 0.01 * n, 3.5, 3.5));
    }
    devices.add(new Vec3(5, 3.5, 3.5));
    devices.add(new Vec3(5.5, 3.5, 3.5));
    FailedCase failed = new FailedCase(scene, new Vec3(0.25, 3.5, 3.5), devices, 42);
    FailedCase least = new Shrinker((metric, maxStepMm) -> new Careless()).shrink(failed);
    assertEquals(1, least.devices().size());
    assertTrue(least.devices().get(0).x > 2);
    assertEquals(1, least.scene().bits().solidCount());
    assertTrue(least.scene().bits().get(2, 3, 3));
    assertEquals(36, bits.solidCount(), "the case that failed stays as it was");
    assertEquals("wall of 1 solid voxels, 1 frames, case seed 42", least.summary());
  }

  @Test
  void aFailureIsWrittenWithItsStartAndEveryDevice(@TempDir Path folder) throws IOException {
    BitCube bits = new BitCube(3, 2, 1);
    bits.set(2, 1, 0);
    HostileScene scene = new HostileScene("dot", bits, new Vec3(1, 1, 20), 1e-6);
    List<Vec3> devices = List.of(new Vec3(1, 2, 3), new Vec3(-0.0, 1e99, 0.1));
    new FailedCase(scene, new Vec3(0.5, 0.5, 0.5), devices, 1)
        .write(folder.resolve("new"), "smooth");
    assertEquals(
        "t_ms,x,y,z\n0,0.5,0.5,0.5\n1,1.0,2.0,3.0\n2,-0.0,1.0E99,0.1\n",
        Files.readString(folder.resolve("new/device.csv")));
    byte[] nrrd = Files.readAllBytes(folder.resolve("new/scene.nrrd"));
    assertEquals("000001", digits(nrrd));
    String command = Files.readString(folder.resolve("new/replay.txt"));
    assertTrue(command.contains("--solver smooth --max-step 1.0E-6 "), command);
  }

  private static String digits(byte[] nrrd) {
    StringBuilder voxels = new StringBuilder();
    for (int n = nrrd.length - 6; n < nrrd.length; n++) {
      voxels.append(nrrd[n]);
    }
    return voxels.toString();
  }

  @Test
  void totalsAreTheSameAfterWritingAndReading(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("totals.properties");
    assertEquals(0, StressTotals.read(file).legs());
    StressTotals totals = new StressTotals();
    totals.cases = 1;
    totals.frames = 20;
    totals.legs = 300;
    totals.exactDecisions = 4_000_000_000L;
    totals.write(file);
    StressTotals read = StressTotals.read(file);
    assertEquals(1, read.cases());
    assertEquals(20, read.frames());
    assertEquals(300, read.legs());
    assertEquals(4_000_000_000L, read.exactDecisions());
  }

  @Test
  void totalsWithoutANumberAreRefusedByTheirKey(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("totals.properties");
    Files.writeString(file, "cases=1\nframes=2\nlegs=many\nexact_decisions=0\n");
    IOException refused = assertThrows(IOException.class, () -> StressTotals.read(file));
    assertEquals("no number under legs in " + file, refused.getMessage());
  }

  @Test
  void aCountingCubeHasTheSameVoxelsAndCountsEveryWordOnce() {
    SplittableRandom random = new SplittableRandom(SEED);
    BitCube bits = new BitCube(9, 6, 13);
    for (int n = 0; n < 200; n++) {
      bits.set(random.nextInt(9), random.nextInt(6), random.nextInt(13));
    }
    CountingCube counting = new CountingCube(bits);
    assertEquals(bits.solidCount(), counting.solidCount());
    long before = counting.words();
    assertEquals(bits.brick(1, 1, 2), counting.brick(1, 1, 2));
    assertEquals(before + 1, counting.words());
    assertEquals(bits.window(3, 2, 5), counting.window(3, 2, 5));
    assertEquals(before + 9, counting.words());
    assertEquals(bits.window(-1, -1, -1), counting.window(-1, -1, -1));
    assertEquals(before + 17, counting.words());
    assertEquals(bits.block(0, 0, 0), counting.block(0, 0, 0));
    assertEquals(before + 18, counting.words());
  }

  @Test
  void thePenetrationIsTheDistanceToTheNearestEmptyVoxel() {
    SplittableRandom random = new SplittableRandom(SEED);
    BitCube bits = new BitCube(7, 7, 7);
    for (int n = 0; n < 343; n++) {
      bits.set(n % 7, n / 7 % 7, n / 49);
    }
    assertEquals(3.5, PenetrationDepth.voxels(bits, new Vec3(3.5, 3.5, 3.5)));
    bits.clear(5, 5, 3);
    assertEquals(Math.sqrt(4.5), PenetrationDepth.voxels(bits, new Vec3(3.5, 3.5, 3.5)), 1e-15);
    assertEquals(0, PenetrationDepth.voxels(bits, new Vec3(5.5, 5.5, 3.5)));
    for (int n = 0; n < 200; n++) {
      Vec3 at = new Vec3(random.nextDouble(7), random.nextDouble(7), random.nextDouble(7));
      double outside = Math.min(rim(at.x), Math.min(rim(at.y), rim(at.z)));
      GridMetric unit = new GridMetric(1, 1, 1);
      double toHole =
          unit.distance(at.x, at.y, at.z, clamp(at.x, 5), clamp(at.y, 5), clamp(at.z, 3));
      assertEquals(Math.min(outside, toHole), PenetrationDepth.voxels(bits, at), 1e-15);
    }
  }

  private static double rim(double at) {
    return Math.min(at, 7 - at);
  }

  private static double clamp(double at, int cell) {
    return Math.max(cell, Math.min(cell + 1.0, at));
  }
}
