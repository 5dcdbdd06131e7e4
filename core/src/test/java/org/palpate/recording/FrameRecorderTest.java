package org.palpate.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.frame.FrameRecord;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class FrameRecorderTest {
  private static FrameRecord random(SplittableRandom random, long number) {
    FrameRecord made = new FrameRecord();
    made.timeNanos = number * 100_000 - 7;
    made.deviceMm.set(random.nextDouble(), -random.nextDouble(), 1 / random.nextDouble());
    made.tool.set(RandomGeometry.pose(random, 50));
    made.forceNewton.set(random.nextDouble(), 0, -0.0);
    made.pressingNewton = random.nextDouble();
    made.contact = random.nextBoolean();
    made.freed = random.nextBoolean();
    made.relocated = random.nextBoolean();
    made.heldBody = random.nextInt(-1, 5);
    for (int n = random.nextInt(FrameRecord.MOST_CONTACTS + 1); n > 0; n--) {
      made.addContact(random.nextInt(300), random.nextDouble());
    }
    return made;
  }

  /** Returns every bit of a frame as text. */
  private static String text(FrameRecord frame) {
    List<Object> all = new ArrayList<>();
    all.add(frame.timeNanos);
    addBits(all, frame.deviceMm);
    Pose pose = frame.tool;
    addBits(all, pose.translation);
    all.addAll(List.of(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z));
    addBits(all, frame.forceNewton);
    all.addAll(List.of(frame.pressingNewton, frame.contact, frame.freed, frame.relocated));
    all.add(frame.heldBody);
    for (int n = 0; n < frame.contacts(); n++) {
      all.addAll(List.of(frame.object(n), frame.share(n)));
    }
    return all.toString();
  }

  private static void addBits(List<Object> all, Vec3 vector) {
    all.addAll(List.of(vector.x, vector.y, vector.z));
  }

  @Test
  void everyFrameArrivesBitForBit() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    FrameRecorder recorder = new FrameRecorder(64);
    List<String> sent = new ArrayList<>();
    List<String> got = new ArrayList<>();
    for (int n = 0; n < 5000; n++) {
      FrameRecord next = random(random, n);
      recorder.accept(next);
      sent.add(text(next));
      if (random.nextInt(50) == 0 || n % 64 == 63) {
        recorder.drainTo(frame -> got.add(text(frame)));
      }
    }
    recorder.drainTo(frame -> got.add(text(frame)));
    assertEquals(sent, got, "seed " + Seeds.seed());
    assertEquals(0, recorder.overflows());
  }

  @Test
  void aFullBufferDropsTheNewestFramesAndCountsThem() {
    FrameRecorder recorder = new FrameRecorder();
    FrameRecord frame = new FrameRecord();
    for (int n = 0; n < FrameRecorder.CAPACITY + 5; n++) {
      frame.timeNanos = n;
      recorder.accept(frame);
    }
    List<Long> times = new ArrayList<>();
    recorder.drainTo(got -> times.add(got.timeNanos));
    assertEquals(FrameRecorder.CAPACITY, times.size());
    assertEquals(FrameRecorder.CAPACITY - 1L, times.get(times.size() - 1));
    assertEquals(5, recorder.overflows());
    assertTrue(frame.heldBody < 0);
  }
}
