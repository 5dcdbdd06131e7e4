package org.palpate.opencl;

import java.nio.ByteBuffer;
import java.util.concurrent.locks.LockSupport;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.PointSet;
import org.palpate.opencl.OpenClDevice.Choice;
import org.palpate.volume.BitCube;

/**
 * Judges the legs of points on an OpenCL device. Points and voxels stay there; a launch sends the
 * maps of some motions and fetches a byte for each point and motion. In each motion the CPU casts
 * some of the legs again, in turn, and gives up a device whose answer is wrong.
 */
final class OpenClLegs implements LegBatch {
  /** The size of a map: three rows of a matrix, each with its component of the offset. */
  private static final int MAP_BYTES = 12 * 8;

  /**
   * The time for which the host polls without a pause a device that shares its processors, ns. A
   * card is polled without a pause to the end, because a pause of the operating system takes as
   * long as a whole answer.
   */
  private static final long SPIN_NANOS = 50_000;

  /** The pause between two polls afterwards, ns. */
  private static final long PAUSE_NANOS = 10_000;

  /** The bits of an answer that hold the verdict; the others hold the number of empty cubes. */
  private static final int VERDICT_BITS = 2;

  /** Half the edge of an empty cube, by the number of cubes that are empty, voxels. */
  private static final double[] HALVES = {0, 0.25, 0.5, 1, 2, 4};

  /** The number of legs of a motion that the CPU casts again. */
  private static final int AUDITED_LEGS = 16;

  private final OpenClDevice device;
  private final ClDriver driver;
  private final OpenClVoxels voxels;
  private final LegBatch exact;
  private final int count;
  private final ClMemory motions;
  private final ClMemory verdicts;
  private final long kernel;
  private Choice choice = new Choice(0, MotionGroup.CAPACITY);
  private int nextAudited;

  OpenClLegs(OpenClDevice device, ClDriver driver, OpenClVoxels voxels, PointSet points) {
    this.device = device;
    this.driver = driver;
    this.voxels = voxels;
    exact = CollisionDevice.CPU.keep(voxels.bits()).newBatch(points);
    count = points.count();
    ClMemory coordinates = driver.allocate(24L * count);
    motions = driver.allocate(Double.BYTES + (1 + MotionGroup.CAPACITY) * MAP_BYTES);
    verdicts = driver.allocate((long) MotionGroup.CAPACITY * count);
    kernel =
        driver.kernel(
            "judge",
            voxels.bricks(),
            voxels.bits().bricksX(),
            voxels.bits().bricksY(),
            voxels.bits().bricksZ(),
            coordinates,
            count,
            motions,
            verdicts);
    for (int n = 0; n < count; n++) {
      coordinates.host().putDouble(8 * n, points.x(n));
      coordinates.host().putDouble(8 * (count + n), points.y(n));
      coordinates.host().putDouble(8 * (2 * count + n), points.z(n));
    }
    driver.write(coordinates, 24 * count);
  }

  BitCube voxels() {
    return voxels.bits();
  }

  void setChoice(Choice newChoice) {
    choice = newChoice;
  }

  @Override
  public long crossover() {
    return choice.crossover();
  }

  @Override
  public int motionsAtOnce() {
    return choice.motionsAtOnce();
  }

  @Override
  public boolean judge(MotionGroup group) {
    if (!device.begin()) {
      return false;
    }
    try {
      judge(group, device.deadlineNanos());
      audit(group);
      device.countBatch();
      return true;
    } catch (RuntimeException | LinkageError | OutOfMemoryError e) {
      device.giveUp(e);
      return false;
    } finally {
      device.end();
    }
  }

  private void audit(MotionGroup group) {
    exact.judge(group);
    for (int motion = 0; motion < group.count(); motion++) {
      for (int n = 0; n < AUDITED_LEGS; n++) {
        nextAudited = nextAudited + 1 < count ? nextAudited + 1 : 0;
        if (!isRight(motion, nextAudited, exact)) {
          throw new IllegalStateException("it was wrong about a leg");
        }
      }
    }
  }

  /** Whether an answer is that of the CPU, or leaves a leg to it. */
  boolean isRight(int motion, int point, LegBatch truth) {
    LegVerdict verdict = verdict(motion, point);
    return (verdict == LegVerdict.DOUBT || verdict == truth.verdict(motion, point))
        && emptyAround(point) <= truth.emptyAround(point);
  }

  /** Judges within a time, ns; throws if the device fails or takes longer. */
  void judge(MotionGroup group, long withinNanos) {
    long start = System.nanoTime();
    launch(group);
    fetch(group.count() * count, start + withinNanos);
  }

  /** Begins to send changed voxels and maps, and to judge. */
  void launch(MotionGroup group) {
    voxels.send();
    motions.host().putDouble(0, group.count());
    put(group.from(), motions.host(), Double.BYTES);
    for (int motion = 0; motion < group.count(); motion++) {
      put(group.to(motion), motions.host(), Double.BYTES + (1 + motion) * MAP_BYTES);
    }
    driver.write(motions, Double.BYTES + (1 + group.count()) * MAP_BYTES);
    driver.launch(kernel, group.count() * count);
  }

  /**
   * Fetches the first verdicts; throws if they have not arrived at a time of the system's clock.
   */
  void fetch(int verdictCount, long untilNanos) {
    long start = System.nanoTime();
    driver.startRead(verdicts, verdictCount);
    while (!driver.isRead()) {
      long now = System.nanoTime();
      if (now - untilNanos > 0) {
        throw new IllegalStateException("it did not answer in time");
      }
      if (driver.sharesProcessors() && now - start >= SPIN_NANOS) {
        LockSupport.parkNanos(PAUSE_NANOS);
      } else {
        Thread.onSpinWait();
      }
    }
  }

  /** Writes a map as the kernels read it. */
  static void put(AffineMap map, ByteBuffer rows, int at) {
    putRow(rows, at, map.mXX, map.mXY, map.mXZ, map.offsetX);
    putRow(rows, at + 32, map.mYX, map.mYY, map.mYZ, map.offsetY);
    putRow(rows, at + 64, map.mZX, map.mZY, map.mZZ, map.offsetZ);
  }

  private static void putRow(ByteBuffer rows, int at, double x, double y, double z, double offset) {
    rows.putDouble(at, x);
    rows.putDouble(at + 8, y);
    rows.putDouble(at + 16, z);
    rows.putDouble(at + 24, offset);
  }

  @Override
  public LegVerdict verdict(int motion, int point) {
    int answer = verdicts.host().get(motion * count + point);
    return switch (answer & (1 << VERDICT_BITS) - 1) {
      case 0 -> LegVerdict.FREE;
      case 1 -> LegVerdict.HIT;
      default -> LegVerdict.DOUBT;
    };
  }

  @Override
  public double emptyAround(int point) {
    int cubes = verdicts.host().get(point) >> VERDICT_BITS;
    // A number that the kernel never writes promises nothing.
    return cubes >= 0 && cubes < HALVES.length ? HALVES[cubes] : 0;
  }
}
