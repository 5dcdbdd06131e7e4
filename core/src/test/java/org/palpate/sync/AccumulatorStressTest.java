package org.palpate.sync;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/** Runs a writer and a reader at full speed on two threads. */
class AccumulatorStressTest {
  private static final int FRAMES = 1_000_000;

  private final Accumulator accumulator = new Accumulator();
  private final TouchProperties touch = new TouchProperties(accumulator);
  private final TransformProperty pose = accumulator.transform("pose");
  private final NumberProperty rare = accumulator.number("rare");
  private final AtomicBoolean ended = new AtomicBoolean();
  private final AtomicReference<String> torn = new AtomicReference<>();
  private final Vec3 scratch = new Vec3();
  private double lastFrame;
  private double lastRare;
  private long taken;

  @Test
  void positionAndForceOfTheSameFrameArriveTogetherAndInOrder() throws InterruptedException {
    Thread reader = new Thread(this::readUntilEnded, "reader");
    reader.start();
    for (int frame = 1; frame <= FRAMES; frame++) {
      write(frame);
    }
    ended.set(true);
    reader.join();
    assertNull(torn.get());
    assertEquals(FRAMES, lastFrame, "the last frame arrives");
    assertEquals(FRAMES / 1000.0, lastRare, "a rare change is not lost between frequent ones");
    assertTrue(taken > 1, "the threads overlapped: taken=" + taken);
  }

  private void write(int frame) {
    if (frame % 1000 == 0) {
      rare.set(Math.floor(frame / 1000.0));
    }
    Vec3 at = new Vec3(frame, frame + 0.25, frame + 0.5);
    pose.set(at, at, at, at);
    touch.publish(at, at, new Vec3(-frame, -2.0 * frame, -3.0 * frame), frame % 2 == 0, frame);
  }

  private void readUntilEnded() {
    boolean last;
    do {
      last = ended.get();
      if (accumulator.take()) {
        taken++;
        check();
      }
    } while (!last);
  }

  private void check() {
    double frame = touch.touch().frame();
    double rareNow = rare.read();
    boolean whole =
        frame > lastFrame
            && isAt(touch.touch().device(scratch), frame)
            && isAt(touch.touch().interactionPoint(scratch), frame)
            && touch.touch().force(scratch).dot(new Vec3(1, 1, 1)) == -6 * frame
            && touch.touch().contact() == (frame % 2 == 0)
            && rareNow == Math.floor(frame / 1000)
            && poseIsOf(frame);
    if (!whole) {
      torn.compareAndSet(null, "frame=" + frame + " after " + lastFrame + " rare=" + rareNow);
    }
    lastFrame = frame;
    lastRare = rareNow;
    accumulator.properties().forEach(Property::markApplied);
  }

  private static boolean isAt(Vec3 position, double frame) {
    return position.x == frame && position.y == frame + 0.25 && position.z == frame + 0.5;
  }

  private boolean poseIsOf(double frame) {
    RigidTransform seen = pose.read();
    return isAt(seen.axisX(), frame)
        && isAt(seen.axisY(), frame)
        && isAt(seen.axisZ(), frame)
        && isAt(seen.origin(), frame);
  }
}
