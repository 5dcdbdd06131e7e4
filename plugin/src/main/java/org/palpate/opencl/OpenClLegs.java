package org.palpate.opencl;

import java.nio.ByteBuffer;
import java.util.concurrent.locks.LockSupport;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.PointSet;
import org.palpate.volume.BitCube;

/**
 * Judges the legs of points on an OpenCL device. Points and voxels stay there; a motion sends two
 * maps and fetches a byte for each point. In each motion the CPU casts some of the legs again, in
 * turn, and gives up a device whose verdict is wrong.
 */
final class OpenClLegs implements LegBatch {
  /** The size of a map: three rows of a matrix, each with its component of the offset. */
  private static final int MAP_BYTES = 12 * 8;

  /** The time for which the host polls without a pause, ns. */
  private static final long SPIN_NANOS = 50_000;

  /** The pause between two polls afterwards, ns. A device that is the CPU needs the core. */
  private static final long PAUSE_NANOS = 10_000;

  /** The number of legs of a motion that the CPU casts again. */
  private static final int AUDITED_LEGS = 16;

  private final OpenClDevice device;
  private final ClDriver driver;
  private final OpenClVoxels voxels;
  private final LegBatch exact;
  private final int count;
  private final ClMemory maps;
  private final ClMemory verdicts;
  private final long kernel;
  private long crossover;
  private int nextAudited;

  OpenClLegs(OpenClDevice device, ClDriver driver, OpenClVoxels voxels, PointSet points) {
    this.device = device;
    this.driver = driver;
    this.voxels = voxels;
    exact = CollisionDevice.CPU.keep(voxels.bits()).newBatch(points);
    count = points.count();
    ClMemory coordinates = driver.allocate(24L * count);
    maps = driver.allocate(2 * MAP_BYTES);
    verdicts = driver.allocate(count);
    kernel =
        driver.kernel(
            "judge",
            voxels.bricks(),
            voxels.bits().bricksX(),
            voxels.bits().bricksY(),
            voxels.bits().bricksZ(),
            coordinates,
            count,
            maps,
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

  void setCrossover(long legs) {
    crossover = legs;
  }

  @Override
  public long crossover() {
    return crossover;
  }

  @Override
  public boolean judge(AffineMap from, AffineMap to) {
    if (!device.begin()) {
      return false;
    }
    try {
      judge(from, to, device.deadlineNanos());
      audit(from, to);
      device.countBatch();
      return true;
    } catch (RuntimeException | LinkageError | OutOfMemoryError e) {
      device.giveUp(e);
      return false;
    } finally {
      device.end();
    }
  }

  private void audit(AffineMap from, AffineMap to) {
    exact.judge(from, to);
    for (int n = 0; n < AUDITED_LEGS; n++) {
      nextAudited = nextAudited + 1 < count ? nextAudited + 1 : 0;
      LegVerdict verdict = verdict(nextAudited);
      if (verdict != LegVerdict.DOUBT && verdict != exact.verdict(nextAudited)) {
        throw new IllegalStateException("its verdict on a leg is wrong");
      }
    }
  }

  /** Judges within a time, ns; throws if the device fails or takes longer. */
  void judge(AffineMap from, AffineMap to, long withinNanos) {
    long start = System.nanoTime();
    launch(from, to);
    fetch(count, start + withinNanos);
  }

  /** Begins to send changed voxels and maps, and to judge. */
  void launch(AffineMap from, AffineMap to) {
    voxels.send();
    put(from, maps.host(), 0);
    put(to, maps.host(), MAP_BYTES);
    driver.write(maps, 2 * MAP_BYTES);
    driver.launch(kernel, count);
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
      if (now - start < SPIN_NANOS) {
        Thread.onSpinWait();
      } else {
        LockSupport.parkNanos(PAUSE_NANOS);
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
  public LegVerdict verdict(int point) {
    return switch (verdicts.host().get(point)) {
      case 0 -> LegVerdict.FREE;
      case 1 -> LegVerdict.HIT;
      default -> LegVerdict.DOUBT;
    };
  }
}
