package org.palpate.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.DeviceVoxels;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Compares the verdicts of an OpenCL device with those of the CPU. Needs OpenCL. */
class OpenClVerdictTest {
  /** {@code -Dpalpate.openclLegs=N} sets the number of hostile legs. */
  private static final long LEGS = Long.getLong("palpate.openclLegs", 500_000);

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final VerdictCount count = new VerdictCount();

  @Test
  void everyVerdictOnHostileLegsIsThatOfTheCpu() {
    try (OpenClDevice device = OpenClOnCpu.open(JoclDriver.source())) {
      count.addHostile(device, random, LEGS);
    }
    System.out.println(count + ", seed " + Seeds.seed());
    assertEquals(LEGS, count.legs);
    assertEquals(0, count.falseFree, count.toString());
    assertEquals(0, count.falseHit, count.toString());
    assertEquals(0, count.falseCubes, count.toString());
    assertTrue(count.free > LEGS / 10 && count.hit > LEGS / 25, count.toString());
    assertTrue(count.doubt < LEGS / 2, count.toString());
  }

  @Test
  void findsVoxelsThatAreNotClosed() {
    String open = OpenClOnCpu.sourceWith("(int) cell - (cell == coordinate)", "(int) cell");
    try (OpenClDevice device = OpenClOnCpu.open(open)) {
      count.addHostile(device, random, LEGS);
    }
    assertTrue(count.falseFree > 0 && count.falseCubes > 0, count.toString());
  }

  @Test
  void findsAMissingErrorBound() {
    String bold = OpenClOnCpu.sourceWith("RELATIVE_ERROR 0x1p-51", "RELATIVE_ERROR 0.0");
    try (OpenClDevice device = OpenClOnCpu.open(bold)) {
      count.addHostile(device, random, LEGS);
    }
    System.out.println("without the error bound: " + count);
    assertTrue(count.falseFree > 0, count.toString());
  }

  @Test
  void refusesADeviceWhoseArithmeticIsWrong() {
    String bold = OpenClOnCpu.sourceWith("RELATIVE_ERROR 0x1p-51", "RELATIVE_ERROR 0.0");
    JoclDevices.Found found = OpenClOnCpu.device();
    OpenClException refusal =
        assertThrows(
            OpenClException.class,
            () ->
                OpenClDevice.open(
                    () -> new JoclDriver(found, bold),
                    OpenClOnCpu.PATIENT_NANOS,
                    new LaunchCost(OpenClOnCpu.PATIENT_NANOS)));
    assertTrue(refusal.getMessage().contains("not exact"), refusal.getMessage());
  }

  @Test
  void judgesVoxelsAsTheyAreAfterEdits() {
    BitCube bits = VerdictCount.noise(random, 0.1);
    GrazingLegs points = new GrazingLegs(random, bits.sizeX(), 2_000);
    LegBatch exact = CollisionDevice.CPU.keep(bits).newBatch(points);
    try (OpenClDevice device = OpenClOnCpu.open(JoclDriver.source())) {
      DeviceVoxels kept = device.keep(bits);
      OpenClLegs batch = (OpenClLegs) kept.newBatch(points);
      for (int edit = 0; edit < 60; edit++) {
        kept.voxelsChanged(edit(bits));
        count.add(batch, exact, points, points.group(edit % GrazingLegs.GROUPS));
      }
    }
    assertEquals(0, count.falseFree + count.falseHit + count.falseCubes, count.toString());
    assertTrue(count.hit > 5_000, count.toString());
  }

  /** Changes voxels within a box, or all of them, and returns the box. */
  private IntBox edit(BitCube bits) {
    IntBox box = new IntBox();
    box.include(random.nextInt(bits.sizeX()), random.nextInt(bits.sizeY()), 3);
    box.include(random.nextInt(bits.sizeX()), random.nextInt(bits.sizeY()), 9);
    double share = random.nextDouble();
    for (int k = box.lowZ; k <= box.highZ; k++) {
      for (int j = box.lowY; j <= box.highY; j++) {
        for (int i = box.lowX; i <= box.highX; i++) {
          if (random.nextDouble() < share) {
            bits.set(i, j, k);
          } else {
            bits.clear(i, j, k);
          }
        }
      }
    }
    return box.grow(random.nextInt(3));
  }

  @Test
  void sendsAllBricksIfManyHaveChanged() {
    BitCube bits = new BitCube(112, 112, 112);
    GrazingLegs points = new GrazingLegs(random, 112, 2_000);
    LegBatch exact = CollisionDevice.CPU.keep(bits).newBatch(points);
    try (OpenClDevice device = OpenClOnCpu.open(JoclDriver.source())) {
      DeviceVoxels kept = device.keep(bits);
      OpenClLegs batch = (OpenClLegs) kept.newBatch(points);
      count.add(batch, exact, points, points.group(0));
      assertEquals(0, count.hit);
      IntBox all = new IntBox();
      for (int z = 0; z < bits.bricksZ(); z++) {
        for (int y = 0; y < bits.bricksY(); y++) {
          for (int x = 0; x < bits.bricksX(); x++) {
            bits.setBrick(x, y, z, sparseWord());
          }
        }
      }
      all.include(-5, -5, -5);
      all.include(200, 200, 200);
      assertTrue(bits.bricksX() * bits.bricksY() * bits.bricksZ() > OpenClVoxels.MOST_CHANGES);
      kept.voxelsChanged(all);
      count.add(batch, exact, points, points.group(1));
    }
    assertEquals(0, count.falseFree + count.falseHit + count.falseCubes, count.toString());
    assertTrue(count.hit > 10, count.toString());
  }

  private long sparseWord() {
    long word = random.nextLong();
    word &= random.nextLong();
    return word & random.nextLong();
  }

  @Test
  void longLegsAndNumbersThatAreNoneAreLeftInDoubt() {
    BitCube bits = VerdictCount.noise(random, 0.1);
    GrazingLegs points = new GrazingLegs(random, bits.sizeX(), 100);
    LegBatch exact = CollisionDevice.CPU.keep(bits).newBatch(points);
    double[] offsets = {Double.NaN, Double.POSITIVE_INFINITY, 1e300, -1e9, 40};
    try (OpenClDevice device = OpenClOnCpu.open(JoclDriver.source())) {
      OpenClLegs batch = device.newBatch(bits, points);
      for (double offset : offsets) {
        AffineMap far = new AffineMap().set(points.group(0).from());
        far.offsetY += offset;
        MotionGroup away = group(points.group(0).from(), far);
        batch.judge(away, OpenClOnCpu.PATIENT_NANOS);
        for (int n = 0; n < points.count(); n++) {
          assertEquals(LegVerdict.DOUBT, batch.verdict(0, n), offset + "");
        }
        MotionGroup back = group(far, points.group(0).from());
        batch.judge(back, OpenClOnCpu.PATIENT_NANOS);
        exact.judge(back);
        for (int n = 0; n < points.count(); n++) {
          assertEquals(exact.emptyAround(n), batch.emptyAround(n), offset + "");
        }
      }
    }
  }

  private static MotionGroup group(AffineMap from, AffineMap to) {
    MotionGroup group = new MotionGroup();
    group.begin(from);
    group.add(to);
    return group;
  }

  @Test
  void judgingAllocatesNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    BitCube bits = VerdictCount.noise(random, 0.1);
    GrazingLegs points = new GrazingLegs(random, bits.sizeX(), 500);
    IntBox box = new IntBox();
    box.include(3, 3, 3);
    List<Long> allocated = new ArrayList<>();
    try (OpenClDevice device = OpenClOnCpu.open(JoclDriver.source())) {
      DeviceVoxels kept = device.keep(bits);
      LegBatch batch = kept.newBatch(points);
      for (int round = 0; round < 8 && !allocated.contains(0L); round++) {
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int n = 0; n < 2_000; n++) {
          if (n % 2 == 0) {
            bits.set(3, 3, 3);
          } else {
            bits.clear(3, 3, 3);
          }
          kept.voxelsChanged(box);
          assertTrue(batch.judge(points.group(n % GrazingLegs.GROUPS)));
        }
        allocated.add(threads.getCurrentThreadAllocatedBytes() - before);
      }
    }
    assertTrue(allocated.contains(0L), "bytes by rounds: " + allocated);
  }

  @Test
  void coordinatesHaveTheBitsOfJavaOnlyWithoutContraction() {
    String reported =
        """
        __kernel void coordinates(
            int count, __global const double* points, __global const double* map,
            __global double* images) {
          int n = get_global_id(0);
          if (n < count) {
            double3 p = image(map, points[n], points[count + n], points[2 * count + n]);
            images[3 * n] = p.x;
            images[3 * n + 1] = p.y;
            images[3 * n + 2] = p.z;
          }
        }
        """;
    assertEquals(0, differentBits(JoclDriver.source() + reported));
    String fused =
        OpenClOnCpu.sourceWith("FP_CONTRACT OFF", "FP_CONTRACT ON")
            .replace(
                "double sum = byX + byY;",
                "return fma(row[2], z, fma(row[1], y, row[0] * x)) + row[3];\n  double sum = 0;");
    assertTrue(differentBits(fused + reported) > 0, "a fused sum must show");
  }

  private long differentBits(String source) {
    int points = 100_000;
    ClDriver driver = new JoclDriver(OpenClOnCpu.device(), source);
    ClMemory coordinates = driver.allocate(24L * points);
    ClMemory rows = driver.allocate(96);
    ClMemory images = driver.allocate(24L * points);
    Pose pose = new Pose();
    pose.rotation.set(0.5, 0.1, -0.7, 0.3).normalize();
    pose.translation.set(12.3, -4.5, 6.7);
    AffineMap map = new AffineMap().set(pose);
    OpenClLegs.put(map, rows.host(), 0);
    for (int n = 0; n < 3 * points; n++) {
      coordinates.host().putDouble(8 * n, random.nextDouble(-50, 50));
    }
    driver.write(rows, 96);
    driver.write(coordinates, 24 * points);
    driver.launch(driver.kernel("coordinates", points, coordinates, rows, images), points);
    driver.startRead(images, 24 * points);
    while (!driver.isRead()) {
      Thread.onSpinWait();
    }
    long different = 0;
    for (int n = 0; n < points; n++) {
      double x = coordinates.host().getDouble(8 * n);
      double y = coordinates.host().getDouble(8 * (points + n));
      double z = coordinates.host().getDouble(8 * (2 * points + n));
      different += isSame(images, 3 * n, map.x(x, y, z)) ? 0 : 1;
      different += isSame(images, 3 * n + 1, map.y(x, y, z)) ? 0 : 1;
      different += isSame(images, 3 * n + 2, map.z(x, y, z)) ? 0 : 1;
    }
    driver.release();
    return different;
  }

  private static boolean isSame(ClMemory images, int index, double expected) {
    return images.host().getLong(8 * index) == Double.doubleToRawLongBits(expected);
  }
}
