package org.palpate.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HandTarget;
import org.palpate.device.SimulatedDevice;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.testing.Floor;
import org.palpate.testing.LegJudge;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class EditQueueTest {
  private static final int EDGE = Floor.EDGE;

  /** The grid of a body that is smaller than the floor, with other voxels. */
  private static final VoxelGrid SMALL =
      new VoxelGrid(4, 5, 3, new Vec3(2, 2, 3), RigidTransform.identity());

  private final Floor floor = Floor.make();
  private final VoxelWriter writer = new VoxelWriter(floor.scene, EditListener.NONE);

  @Test
  void anEditThatDoesNotFitIsRefusedInTheThreadThatQueuesIt() {
    assertRefused(new VoxelEdit(0, 0, 32, 0, true), "voxel lies outside the grid: voxel=0,32,0");
    assertRefused(new VoxelEdit(1, 0, 0, 0, true), "no such segment: segment=1 segments=1");
    assertRefused(
        new SwapEdit(0, new BitCube(32, 32, 31)),
        "cube must have the grid's sizes: cube=32x32x31 grid=32x32x32");
    assertThrows(
        IllegalArgumentException.class,
        () -> new BrushEdit(0, new Vec3(Double.NaN, 0, 0), 1, true));
  }

  @Test
  void anEditOfABodyMustFitTheGridOfThatBody() {
    EditQueue bodies = EditQueue.ofBodies(List.of(Floor.GRID, SMALL));
    String outside = "voxel lies outside the grid: voxel=4,0,0";
    assertRefused(bodies, new VoxelEdit(1, 4, 0, 0, true), outside);
    assertRefused(bodies, listOf(new VoxelChange(0, 1, 4, 0, 0, true)), outside);
    assertRefused(
        bodies,
        listOf(new VoxelChange(0, 2, 0, 0, 0, true)),
        "no such segment: segment=2 segments=2");
    assertTrue(bodies.offer(new VoxelEdit(0, 4, 0, 0, true)));
    assertTrue(bodies.offer(new VoxelEdit(1, 3, 4, 2, true)));
  }

  /** Returns the changes behind one that fits. */
  private static Edit listOf(VoxelChange change) {
    return new VoxelListEdit(List.of(new VoxelChange(0, 0, 4, 0, 0, true), change));
  }

  @Test
  void aBrushIsClippedToTheGridOfItsBodyAndMeasuredInItsMillimetres() {
    BitCube small = new BitCube(SMALL.sizeX(), SMALL.sizeY(), SMALL.sizeZ());
    CollisionScene scene = new CollisionScene(List.of(floor.bits, small));
    EditQueue bodies = EditQueue.ofBodies(List.of(Floor.GRID, SMALL));
    Vec3 centre = new Vec3(3, 4, 1);
    BrushEdit brush = new BrushEdit(1, centre, 5, true);
    assertTrue(bodies.offer(brush));
    bodies.applyTo(new VoxelWriter(scene, EditListener.NONE), 10_000);
    assertTrue(brush.isDone());
    for (int n = 0; n < 60; n++) {
      int i = n % 4;
      int j = n / 4 % 5;
      int k = n / 20;
      double x = 2 * (i + 0.5 - centre.x);
      double y = 2 * (j + 0.5 - centre.y);
      double z = 3 * (k + 0.5 - centre.z);
      assertEquals(x * x + y * y + z * z <= 25, small.get(i, j, k), i + "," + j + "," + k);
    }
  }

  @Test
  void aFullQueueRefusesAnEditAndAcceptsItLater() {
    EditQueue queue = new EditQueue(Floor.GRID, 1, 2);
    assertTrue(queue.offer(new VoxelEdit(0, 1, 1, 20, true)));
    assertTrue(queue.offer(new VoxelEdit(0, 1, 1, 21, true)));
    assertFalse(queue.offer(new VoxelEdit(0, 1, 1, 22, true)));
    queue.applyTo(writer, 1);
    assertTrue(queue.offer(new VoxelEdit(0, 1, 1, 22, true)));
    queue.applyTo(writer, 10);
    assertEquals(3, queue.completed());
    assertTrue(floor.bits.get(1, 1, 22));
  }

  @Test
  void aFrameAppliesABoundedNumberOfEdits() {
    EditQueue queue = new EditQueue(Floor.GRID, 1);
    for (int n = 0; n < 3 * EditQueue.MOST_EDITS_A_FRAME / 2; n++) {
      assertTrue(queue.offer(new VoxelEdit(0, n % EDGE, n / EDGE, 20, true)));
    }
    queue.applyTo(writer, 10_000);
    assertEquals(EditQueue.MOST_EDITS_A_FRAME, queue.completed());
    queue.applyTo(writer, 10_000);
    assertTrue(queue.isIdle());
  }

  @Test
  void aBrushOutsideTheGridChangesNothingAndCompletes() {
    for (double at : new double[] {-50, 90, 1e12, -1e300}) {
      BrushEdit brush = new BrushEdit(0, new Vec3(at, 16, 16), 5, true);
      floor.edits.offer(brush);
      floor.edits.applyTo(writer, 1);
      assertTrue(brush.isDone(), "at=" + at);
    }
    assertEquals(Floor.TOP * EDGE * EDGE, floor.bits.solidCount());
  }

  /** The naive reference is a bit set that takes each edit at once, in the same order. */
  @Test
  void editsInPartsAgreeWithEditsAtOnce() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    BitSet reference = new BitSet();
    for (int n = 0; n < Floor.TOP * EDGE * EDGE; n++) {
      reference.set(n);
    }
    for (int run = 0; run < 300; run++) {
      Vec3 centre = new Vec3(coordinate(random), coordinate(random), coordinate(random));
      double radius = unit(random) * 6;
      boolean solid = (random.nextLong() & 1) == 0;
      floor.edits.offer(new BrushEdit(0, centre, radius, solid));
      brushAtOnce(reference, centre, radius, solid);
      while (!floor.edits.isIdle()) {
        floor.edits.applyTo(writer, 1 + (int) ((random.nextLong() >>> 1) % 200));
      }
      assertEquals(reference.cardinality(), floor.bits.solidCount(), "seed=" + Seeds.seed());
    }
    reference.stream()
        .forEach(n -> assertTrue(floor.bits.get(n % EDGE, n / EDGE % EDGE, n / EDGE / EDGE)));
  }

  @Test
  void editsOfSeveralThreadsAllArrive() throws InterruptedException {
    EditQueue queue = new EditQueue(Floor.GRID, 1, 16);
    BitCube empty = new BitCube(EDGE, EDGE, EDGE);
    List<Thread> editors = new ArrayList<>();
    for (int t = 0; t < 3; t++) {
      int k = 10 + t;
      editors.add(new Thread(() -> setLayer(queue, k)));
    }
    queue.offer(new SwapEdit(0, empty));
    editors.forEach(Thread::start);
    while (queue.completed() < 1 + 3 * EDGE * EDGE) {
      queue.applyTo(writer, 100);
    }
    for (Thread editor : editors) {
      editor.join();
    }
    assertEquals(3 * EDGE * EDGE, empty.solidCount());
  }

  /** One thread edits, another moves the hand, and the exact judge checks every leg. */
  @Test
  void theGuaranteeHoldsWhileAnotherThreadEdits() throws InterruptedException {
    SimulatedDevice device =
        new SimulatedDevice(
            Seeds.seed(),
            HandTarget.ofBox(new Vec3(2, 2, 2), new Vec3(30, 30, 12), 1),
            ManualClock.MS);
    PointFrame frame = floor.frame(device);
    AtomicBoolean ended = new AtomicBoolean();
    AtomicReference<Vec3> near = new AtomicReference<>(new Vec3(16, 16, 8));
    Thread editor = new Thread(() -> editUntil(ended, near));
    editor.start();
    int freed = judgeFrames(frame, near, 30_000);
    ended.set(true);
    editor.join();
    assertEquals(freed, frame.statistics().freed());
    assertTrue(freed > 10, "solids reached the point: freed=" + freed);
    assertTrue(floor.edits.completed() > 1000, "edits=" + floor.edits.completed());
  }

  private int judgeFrames(PointFrame frame, AtomicReference<Vec3> near, int frames) {
    int freed = 0;
    Vec3 last = new Vec3();
    for (int n = 0; n < frames; n++) {
      last.set(frame.point().position);
      assertEquals(FrameOutcome.RUNNING, frame.run(n * ManualClock.MS));
      boolean newChain = frame.wasFreed() || n == 0;
      freed += frame.wasFreed() ? 1 : 0;
      if (newChain) {
        last.set(startOf(frame));
      }
      LegJudge judge = new LegJudge(floor.scene.cube(0), last);
      String fault = judge.faultOf(frame.point());
      assertEquals(null, fault, "seed=" + Seeds.seed() + " frame=" + n);
      Vec3 p = frame.point().position;
      assertFalse(floor.scene.touches(p.x, p.y, p.z));
      near.set(new Vec3().set(p));
    }
    return freed;
  }

  private static Vec3 startOf(PointFrame frame) {
    return frame.point().legs.count() == 0
        ? frame.point().position
        : new Vec3(
            frame.point().legs.start(0, 0),
            frame.point().legs.start(0, 1),
            frame.point().legs.start(0, 2));
  }

  private void editUntil(AtomicBoolean ended, AtomicReference<Vec3> near) {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    while (!ended.get()) {
      floor.edits.offer(randomEdit(random, near.get()));
      Thread.onSpinWait();
    }
  }

  private static Edit randomEdit(SplittableRandom random, Vec3 near) {
    int what = (int) ((random.nextLong() >>> 1) % 100);
    if (what == 0) {
      return new SwapEdit(0, Floor.bits());
    }
    boolean solid = (random.nextLong() & 1) == 0;
    if (what < 50) {
      return new VoxelEdit(
          0, beside(near.x, random), beside(near.y, random), beside(near.z, random), solid);
    }
    Vec3 centre = new Vec3(coordinate(random), coordinate(random), coordinate(random));
    return new BrushEdit(0, what < 75 ? near : centre, unit(random) * 3, solid && what % 4 == 0);
  }

  private static int beside(double at, SplittableRandom random) {
    int cell = (int) Math.floor(at) + (int) (random.nextLong() % 2);
    return Math.max(0, Math.min(EDGE - 1, cell));
  }

  private void assertRefused(Edit edit, String message) {
    assertRefused(floor.edits, edit, message);
  }

  private static void assertRefused(EditQueue queue, Edit edit, String message) {
    assertEquals(
        message,
        assertThrows(IllegalArgumentException.class, () -> queue.offer(edit)).getMessage());
  }

  private static void setLayer(EditQueue queue, int k) {
    for (int n = 0; n < EDGE * EDGE; n++) {
      Edit edit = new VoxelEdit(0, n % EDGE, n / EDGE, k, true);
      while (!queue.offer(edit)) {
        Thread.onSpinWait();
      }
    }
  }

  private static void brushAtOnce(BitSet reference, Vec3 centre, double radius, boolean solid) {
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / EDGE / EDGE;
      double square =
          Floor.METRIC.squaredDistance(centre.x, centre.y, centre.z, i + 0.5, j + 0.5, k + 0.5);
      if (square <= radius * radius) {
        reference.set(n, solid);
      }
    }
  }

  private static double unit(SplittableRandom random) {
    return (random.nextLong() >>> 11) * 0x1p-53;
  }

  private static double coordinate(SplittableRandom random) {
    return unit(random) * (EDGE + 8) - 4;
  }
}
