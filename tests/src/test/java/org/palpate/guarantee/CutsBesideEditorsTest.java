package org.palpate.guarantee;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.stress.PlainCopy;
import org.palpate.carve.CarveSettings;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HandTarget;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.testing.LegJudge;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Two threads paint, undo and redo while a point cuts. Every leg is judged by the bits of its
 * frame. At the end the bits are those of a plain copy.
 */
class CutsBesideEditorsTest {
  private static final int EDGE = 24;
  private static final int FLOOR = 10;
  private static final int LEAST_FRAMES = 20_000;
  private static final int LEAST_EDITS = 500;
  private static final int FRAMES_PER_EDIT = 20;
  private static final long MS = 1_000_000;
  private static final long ENDED = Long.MAX_VALUE;
  private static final GridMetric METRIC = new GridMetric(1, 1, 1);

  private final BitCube bits = floor();
  private final EditQueue queue = new EditQueue(VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE), 1);
  private final SimulatedDevice hand =
      new SimulatedDevice(
          Seeds.seed(), HandTarget.ofBox(new Vec3(8, 8, 4), new Vec3(16, 16, 12), 1), MS);
  private final PointFrame frame =
      new PointFrame(
          GridDevice.inGridCoordinates(hand),
          new GuardedSolver(METRIC, 8),
          new CollisionScene(List.of(bits)),
          METRIC,
          FrameSettings.live(hand.specification(), ForceSettings.of(0.5, 0.2)),
          queue,
          FramePublisher.NONE);
  private final PlainCopy copy = new PlainCopy(bits, new BitCube(EDGE, EDGE, EDGE));
  private final AtomicLong framesRun = new AtomicLong();
  private LegJudge judge;
  private long legs;
  private long cuts;

  @Test
  void noLegTouchesASolidAndNoChangeIsLost() throws InterruptedException {
    frame.voxels().listen(copy);
    frame.carve(CarveSettings.ofRate(500));
    List<Thread> editors =
        List.of(new Thread(() -> edit(1), "editor 1"), new Thread(() -> edit(2), "editor 2"));
    editors.forEach(Thread::start);
    for (long n = 0; n < LEAST_FRAMES || queue.completed() < LEAST_EDITS; n++) {
      runFrame(n);
      framesRun.lazySet(n);
    }
    framesRun.set(ENDED);
    for (Thread editor : editors) {
      editor.join();
    }
    assertEquals(0, copy.differentBricks(bits));
    assertTrue(cuts > 100, "cuts " + cuts);
    assertTrue(legs > 1_000, "legs " + legs);
  }

  private void runFrame(long n) {
    long completed = queue.completed();
    boolean wasIdle = queue.isIdle();
    long changes = copy.changes();
    assertEquals(FrameOutcome.RUNNING, frame.run(n * MS));
    if (wasIdle && queue.completed() == completed && queue.isIdle()) {
      cuts += copy.changes() - changes; // no edit was applied
    }
    LegPath path = frame.point().legs;
    if (n == 0 || frame.wasFreed()) {
      boolean moved = path.count() > 0;
      judge =
          new LegJudge(
              bits,
              moved
                  ? new Vec3(path.start(0, 0), path.start(0, 1), path.start(0, 2))
                  : frame.point().position);
    }
    legs += path.count();
    assertNull(judge.faultOf(frame.point()), () -> "frame " + n + " seed " + Seeds.seed());
  }

  /** Offers an edit for every few frames, until the frames have ended. */
  private void edit(int editor) {
    SplittableRandom random = new SplittableRandom(Seeds.seed() + editor);
    long due = 0;
    for (long now = 0; now != ENDED; now = framesRun.get()) {
      if (now >= due && queue.offer(edit(random))) {
        due += FRAMES_PER_EDIT;
      }
      Thread.onSpinWait();
    }
  }

  private static Edit edit(SplittableRandom random) {
    int kind = random.nextInt(4);
    if (kind < 2) {
      return kind == 0 ? HistoryEdit.undo() : HistoryEdit.redo();
    }
    Vec3 centre =
        new Vec3(random.nextDouble(8, 16), random.nextDouble(8, 16), random.nextDouble(6, 14));
    return new BrushEdit(0, centre, random.nextDouble(2.5), random.nextBoolean());
  }

  private static BitCube floor() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * FLOOR; n++) {
      bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
    }
    return bits;
  }
}
