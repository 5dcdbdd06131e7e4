package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.fracture.VoxelOverlap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.fracture.PosedBits;

/**
 * Another thread asks blocks to go through each other, to let them be taken, and to undo where they
 * were put, as frames run.
 */
class RequestedPosesTest extends HeldBlocks {
  private static final long FRAMES = Long.getLong("palpate.threadFrames", 3_000);
  private static final double W_MAX_MM = 4; // that of the blocks' frames

  private final Body floor = body("floor", 40, 40, 5, 5, Mobility.FIXED, new Vec3());
  private final Body block = cube("block", 8, new Vec3(16, 16, 8));
  private final Body small = cube("small", 4, new Vec3(30, 16, 8));
  private final BodyScene bodies = new BodyScene(List.of(floor, block, small));
  private final SplittableRandom ofHand = new SplittableRandom(1);
  private final EditQueue edits = EditQueue.ofBodies(bodies.grids());
  private final ToolFrame frame = newFrame(new ScriptedDevice(this::sample), bodies, edits, 10_000);

  @Override
  ToolFrame frame() {
    return frame;
  }

  @Override
  ReadStatus sample(int read, DeviceState state) {
    hand.set(
        Math.max(0, Math.min(40, hand.x + ofHand.nextDouble(-1, 1))),
        Math.max(0, Math.min(40, hand.y + ofHand.nextDouble(-1, 1))),
        Math.max(0, Math.min(25, hand.z + ofHand.nextDouble(-1, 1))));
    return super.sample(read, state);
  }

  @Test
  void noBlockEntersAnotherWhateverAnotherThreadAsksFor() throws InterruptedException {
    AtomicBoolean stopped = new AtomicBoolean();
    CountDownLatch asked = new CountDownLatch(10);
    Thread asking =
        new Thread(
            () -> {
              SplittableRandom random = new SplittableRandom(2);
              while (!stopped.get()) {
                ask(random);
                asked.countDown();
                Thread.onSpinWait();
              }
            });
    run(1);
    asking.start();
    asked.await();
    long motions = 0;
    try {
      for (long n = 0; n < FRAMES; n++) {
        run(1);
        motions += frame.motion().bodies().count();
        assertTrue(frame.motion().pathMm() <= W_MAX_MM + 1e-9);
        if (n % 20 == 0) {
          assertEquals(0, overlaps(floor, block) + overlaps(floor, small) + overlaps(block, small));
        }
      }
    } finally {
      stopped.set(true);
      asking.join();
    }
    assertTrue(motions > 0, "blocks moved: " + motions);
  }

  private void ask(SplittableRandom random) {
    int body = random.nextInt(1, 3);
    Pose goal = new Pose();
    goal.translation.set(
        random.nextDouble(0, 35), random.nextDouble(0, 35), random.nextDouble(-5, 20));
    if (random.nextBoolean()) {
      goal.rotation.set(0, 1, 0, 0); // half a turn
      goal.translation.add(new Vec3(0, 8, 8), goal.translation);
    }
    frame.requestPose(body, goal);
    if (random.nextInt(50) == 0) {
      frame.requestTake();
    } else if (random.nextInt(50) == 0) {
      frame.requestLetGo();
    } else if (random.nextInt(50) == 0) {
      edits.offer(random.nextBoolean() ? HistoryEdit.undo() : HistoryEdit.redo());
    }
  }

  private static long overlaps(Body one, Body other) {
    return new VoxelOverlap(posed(one), posed(other)).count();
  }

  private static PosedBits posed(Body body) {
    return new PosedBits(body.bits(), body.grid(), body.pose());
  }
}
