package org.palpate.guarantee;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HandTarget;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.SwapEdit;
import org.palpate.edit.VoxelEdit;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.raycast.Ray;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * A thread edits two segments while frames run: voxels, balls and swaps of a whole segment. The
 * edits depend only on the seed, their times on the scheduler. Every leg is judged by the bits of
 * its frame; at the end the bits equal those of cubes that were edited at once.
 */
class ConcurrentEditsTest {
  private static final int EDGE = 32;
  private static final int FLOOR = 8;
  private static final int EDITS = 6_000;

  /** Frames before each edit is offered, so that edits come while the hand touches. */
  private static final int FRAMES_PER_EDIT = 4;

  /**
   * Edits by which the editor may be late before the next frame waits for it. Without this limit a
   * busy machine may run most frames first, and then all edits within a few frames.
   */
  private static final int MAX_LATE_EDITS = 16;

  private static final int MIN_FRAMES = EDITS * FRAMES_PER_EDIT;
  private static final long MS = 1_000_000;
  private static final double STIFFNESS = 0.5;
  private static final double FRICTION = 0.2;
  private static final double MAX_FORCE = 10;
  private static final long RAMP_NANOS = 100 * MS;
  private static final GridMetric METRIC = new GridMetric(1, 1, 1);
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);

  private final EditQueue queue = new EditQueue(GRID, 2);
  private final CollisionScene scene = new CollisionScene(List.of(floor(), ceiling()));
  private final List<BitCube> expected = new ArrayList<>(List.of(floor(), ceiling()));
  private final Ray ray = new Ray();
  private final Vec3 at = new Vec3();
  private final AtomicLong framesRun = new AtomicLong();
  private final AtomicLong editsOffered = new AtomicLong();
  private PointFrame frame;
  private long freed;
  private long legs;
  private long freedNanos = -RAMP_NANOS;

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void noLegTouchesTheBitsOfItsFrameAndNoEditIsTornOrLost(boolean smooth)
      throws InterruptedException {
    frame = frame(smooth ? new SmoothSolver(METRIC, 8) : new GuardedSolver(METRIC, 8));
    List<Edit> edits = edits(new SplittableRandom(Seeds.seed()));
    Thread editor = new Thread(() -> offer(edits), "editor");
    editor.start();
    for (long n = 0; n < MIN_FRAMES || queue.completed() < EDITS; n++) {
      awaitEditor(n);
      runFrame(n, !smooth);
      framesRun.lazySet(n);
    }
    editor.join();
    assertTrue(frame.release());
    assertEquals(freed, frame.statistics().freed());
    assertTrue(freed > 10, "edits put solids at the point: freed=" + freed);
    assertTrue(legs > 1000, "legs=" + legs);
    assertEquals(EDITS, queue.completed());
    for (int segment = 0; segment < 2; segment++) {
      assertNotTorn(expected.get(segment), scene.cube(segment));
    }
    System.out.println(
        (smooth ? "smooth" : "guarded")
            + " while another thread edits: "
            + EDITS
            + " edits, "
            + legs
            + " legs, set free "
            + freed
            + " times, 0 violations, seed "
            + Seeds.seed());
  }

  private void offer(List<Edit> edits) {
    for (int n = 0; n < edits.size(); n++) {
      while (framesRun.get() < (long) n * FRAMES_PER_EDIT || !queue.offer(edits.get(n))) {
        Thread.onSpinWait();
      }
      editsOffered.lazySet(n + 1);
    }
  }

  /**
   * Waits for an editor that is late, unless an edit is pending, because frames empty the queue.
   */
  private void awaitEditor(long frameNumber) {
    long due = Math.min(EDITS, frameNumber / FRAMES_PER_EDIT - MAX_LATE_EDITS);
    while (editsOffered.get() < due && queue.completed() >= editsOffered.get()) {
      Thread.onSpinWait();
    }
  }

  private PointFrame frame(ProxySolver solver) {
    return new PointFrame(
        GridDevice.inGridCoordinates(
            new SimulatedDevice(
                Seeds.seed(), HandTarget.ofBox(new Vec3(12, 12, 4), new Vec3(20, 20, 14), 1), MS)),
        solver,
        scene,
        METRIC,
        new FrameSettings(
            ForceSettings.of(STIFFNESS, FRICTION),
            MAX_FORCE,
            Double.POSITIVE_INFINITY,
            RAMP_NANOS,
            20 * MS,
            64),
        queue,
        FramePublisher.NONE);
  }

  private void runFrame(long number, boolean springAlone) {
    at.set(frame.point().position);
    assertEquals(FrameOutcome.RUNNING, frame.run(number * MS));
    String where = "frame " + number + " seed " + Seeds.seed();
    boolean newChain = number == 0 || frame.wasFreed();
    Vec3 p = frame.point().position;
    if (frame.wasFreed()) {
      freed++;
      freedNanos = number * MS;
      assertEquals(0, frame.forceNewton().length(), where);
    }
    judgeLegs(newChain, where);
    assertTrue(at.sameBits(p) || newChain, () -> "the chain of legs is broken, " + where);
    assertFalse(scene.touches(p.x, p.y, p.z), where);
    if (springAlone) {
      assertRamped(number, where);
    }
  }

  private void judgeLegs(boolean newChain, String where) {
    LegPath path = frame.point().legs;
    for (int leg = 0; leg < path.count(); leg++) {
      legs++;
      ray.from(path.start(leg, 0), path.start(leg, 1), path.start(leg, 2));
      ray.to(path.end(leg, 0), path.end(leg, 1), path.end(leg, 2));
      boolean chained = at.sameBits(new Vec3(ray.fromX, ray.fromY, ray.fromZ));
      assertTrue(chained || (newChain && leg == 0), () -> "a broken chain, " + where);
      assertFalse(ExactOracle.touchesAny(scene.cube(0), ray), where);
      assertFalse(ExactOracle.touchesAny(scene.cube(1), ray), where);
      at.set(ray.toX, ray.toY, ray.toZ);
    }
  }

  /** Asserts that the force after a release is at most the ramped spring and friction. */
  private void assertRamped(long number, String where) {
    double fraction = Math.min(1, (number * MS - freedNanos) / (double) RAMP_NANOS);
    Vec3 behind = frame.point().position.sub(frame.sample().positionMm, new Vec3());
    double whole = STIFFNESS * behind.length() * (1 + FRICTION);
    double force = frame.forceNewton().length();
    assertTrue(
        force <= Math.min(MAX_FORCE, fraction * whole) * (1 + 1e-9) + 1e-12,
        () -> "force " + force + " of " + whole + " share " + fraction + ", " + where);
  }

  private List<Edit> edits(SplittableRandom random) {
    List<Edit> edits = new ArrayList<>();
    for (int n = 0; n < EDITS; n++) {
      int segment = random.nextInt(2);
      int what = random.nextInt(100);
      if (what == 0) {
        edits.add(swap(segment, random));
      } else if (what < 60) {
        edits.add(brush(segment, random));
      } else {
        edits.add(voxel(segment, random));
      }
    }
    return edits;
  }

  private Edit voxel(int segment, SplittableRandom random) {
    int i = random.nextInt(EDGE);
    int j = random.nextInt(EDGE);
    int k = random.nextInt(EDGE);
    boolean solid = random.nextBoolean();
    put(expected.get(segment), i, j, k, solid);
    return new VoxelEdit(segment, i, j, k, solid);
  }

  private Edit brush(int segment, SplittableRandom random) {
    Vec3 centre =
        new Vec3(
            10 + 12 * random.nextDouble(),
            10 + 12 * random.nextDouble(),
            4 + 12 * random.nextDouble());
    double radius = 4 * random.nextDouble();
    boolean solid = random.nextInt(3) == 0;
    BitCube expectedBits = expected.get(segment);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / EDGE / EDGE;
      double square =
          METRIC.squaredDistance(centre.x, centre.y, centre.z, i + 0.5, j + 0.5, k + 0.5);
      if (square <= radius * radius) {
        put(expectedBits, i, j, k, solid);
      }
    }
    return new BrushEdit(segment, centre, radius, solid);
  }

  private Edit swap(int segment, SplittableRandom random) {
    BitCube fresh = segment == 0 ? floor() : ceiling();
    for (int n = 0; n < 300; n++) {
      fresh.set(random.nextInt(EDGE), random.nextInt(EDGE), random.nextInt(EDGE));
    }
    expected.set(segment, fresh.copy());
    return new SwapEdit(segment, fresh);
  }

  private static void put(BitCube bits, int i, int j, int k, boolean solid) {
    if (solid) {
      bits.set(i, j, k);
    } else {
      bits.clear(i, j, k);
    }
  }

  private static BitCube floor() {
    return layers(0, FLOOR);
  }

  private static BitCube ceiling() {
    return layers(EDGE - FLOOR, EDGE);
  }

  private static BitCube layers(int low, int high) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = low; k < high; k++) {
      for (int n = 0; n < EDGE * EDGE; n++) {
        bits.set(n % EDGE, n / EDGE, k);
      }
    }
    return bits;
  }

  /** Asserts that both cubes have the same words and that the level above marks those not 0. */
  private static void assertNotTorn(BitCube expectedBits, BitCube bits) {
    long solids = 0;
    for (int z = 0; z < bits.bricksZ(); z++) {
      for (int y = 0; y < bits.bricksY(); y++) {
        for (int x = 0; x < bits.bricksX(); x++) {
          String where = "brick " + x + "," + y + "," + z + " seed " + Seeds.seed();
          long word = bits.brick(x, y, z);
          solids += Long.bitCount(word);
          assertEquals(expectedBits.brick(x, y, z), word, where);
          boolean marked = (bits.block(x >> 2, y >> 2, z >> 2) >>> BitCube.bit(x, y, z) & 1) != 0;
          assertEquals(word != 0, marked, where);
        }
      }
    }
    assertEquals(solids, bits.solidCount());
  }
}
