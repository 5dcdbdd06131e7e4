package org.palpate.opencl;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.PointSet;
import org.palpate.volume.BitCube;

/**
 * A driver without OpenCL: memory of its own, copies that end at the first poll after the next, and
 * both kernels in Java. So failures can be tested on every machine.
 */
final class SimulatedDriver implements ClDriver {
  /** Answers that the kernel never writes: no verdict, and more or fewer cubes than there are. */
  private static final int[] NONSENSE = {0xff, 0x7f, 0x83, 6 << 2 | 3};

  private final List<ClMemory> hosts = new ArrayList<>();
  private final List<ByteBuffer> memories = new ArrayList<>();
  private final List<List<Object>> kernels = new ArrayList<>();
  private ClMemory reading;
  private int readBytes;
  private int polls;
  boolean isReleased;

  /** Whether every leg is called free from now on. */
  boolean lies;

  /** Whether the largest cubes are called empty from now on. */
  boolean liesAboutCubes;

  /** Whether every byte of an answer is one that the kernel never writes, from now on. */
  boolean talksNonsense;

  @Override
  public String name() {
    return "simulated";
  }

  @Override
  public boolean sharesProcessors() {
    return true;
  }

  @Override
  public ClMemory allocate(long bytes) {
    ByteBuffer host = ByteBuffer.allocateDirect((int) bytes).order(ByteOrder.nativeOrder());
    memories.add(ByteBuffer.allocate((int) bytes).order(ByteOrder.nativeOrder()));
    hosts.add(new ClMemory(host, hosts.size()));
    return hosts.get(hosts.size() - 1);
  }

  @Override
  public long kernel(String kernelName, Object... arguments) {
    List<Object> bound = new ArrayList<>(List.of(kernelName));
    bound.addAll(List.of(arguments));
    kernels.add(bound);
    return kernels.size() - 1L;
  }

  private ByteBuffer memory(Object of) {
    return memories.get((int) ((ClMemory) of).id());
  }

  @Override
  public void write(ClMemory memory, int bytes) {
    memory(memory).put(0, memory.host(), 0, bytes);
  }

  @Override
  public void launch(long kernel, int items) {
    List<Object> bound = kernels.get((int) kernel);
    if (bound.get(0).equals("judge")) {
      judge(bound);
    } else {
      change(memory(bound.get(1)), memory(bound.get(2)));
    }
  }

  private static void change(ByteBuffer bricks, ByteBuffer changes) {
    for (int n = 0; n < changes.getLong(0); n++) {
      bricks.putLong(8 * (int) changes.getLong(16 * n + 8), changes.getLong(16 * n + 16));
    }
  }

  private void judge(List<Object> bound) {
    int x = (Integer) bound.get(2);
    int y = (Integer) bound.get(3);
    int z = (Integer) bound.get(4);
    ByteBuffer bricks = memory(bound.get(1));
    BitCube bits = new BitCube(4 * x, 4 * y, 4 * z);
    for (int n = 0; n < x * y * z; n++) {
      bits.setBrick(n % x, n / x % y, n / (x * y), bricks.getLong(8 * n));
    }
    Points points = new Points(memory(bound.get(5)), (Integer) bound.get(6));
    LegBatch exact = CollisionDevice.CPU.keep(bits).newBatch(points);
    MotionGroup group = group(memory(bound.get(7)));
    exact.judge(group);
    for (int n = 0; n < points.count() * group.count(); n++) {
      boolean free =
          lies || exact.verdict(n / points.count(), n % points.count()) == LegVerdict.FREE;
      int answer = (free ? 0 : 1) | (liesAboutCubes ? 5 << 2 : 0);
      memory(bound.get(8)).put(n, (byte) (talksNonsense ? NONSENSE[n % NONSENSE.length] : answer));
    }
  }

  private static MotionGroup group(ByteBuffer rows) {
    MotionGroup group = new MotionGroup();
    group.begin(map(rows, 8));
    for (int motion = 0; motion < rows.getDouble(0); motion++) {
      group.add(map(rows, 8 + 96 * (1 + motion)));
    }
    return group;
  }

  private static AffineMap map(ByteBuffer rows, int at) {
    AffineMap map = new AffineMap();
    map.mXX = rows.getDouble(at);
    map.mXY = rows.getDouble(at + 8);
    map.mXZ = rows.getDouble(at + 16);
    map.offsetX = rows.getDouble(at + 24);
    map.mYX = rows.getDouble(at + 32);
    map.mYY = rows.getDouble(at + 40);
    map.mYZ = rows.getDouble(at + 48);
    map.offsetY = rows.getDouble(at + 56);
    map.mZX = rows.getDouble(at + 64);
    map.mZY = rows.getDouble(at + 72);
    map.mZZ = rows.getDouble(at + 80);
    map.offsetZ = rows.getDouble(at + 88);
    return map;
  }

  private record Points(ByteBuffer coordinates, int count) implements PointSet {
    @Override
    public double x(int point) {
      return coordinates.getDouble(8 * point);
    }

    @Override
    public double y(int point) {
      return coordinates.getDouble(8 * (count + point));
    }

    @Override
    public double z(int point) {
      return coordinates.getDouble(8 * (2 * count + point));
    }
  }

  @Override
  public void startRead(ClMemory memory, int bytes) {
    reading = memory;
    readBytes = bytes;
    polls = 0;
  }

  @Override
  public boolean isRead() {
    if (++polls < 2) {
      return false;
    }
    reading.host().put(0, memory(reading), 0, readBytes);
    return true;
  }

  @Override
  public void release() {
    isReleased = true;
  }
}
