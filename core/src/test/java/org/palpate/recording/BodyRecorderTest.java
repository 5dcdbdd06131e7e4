package org.palpate.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyEvent;
import org.palpate.body.BodyListener;
import org.palpate.geometry.Pose;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class BodyRecorderTest {
  private final BodyRecorder recorder = new BodyRecorder();

  /** An event as it was offered, or as it arrived. */
  private record Event(long sample, int body, BodyEvent event, Pose pose, Pose inHand) {
    private boolean isSame(Event other) {
      return sample == other.sample
          && body == other.body
          && event == other.event
          && pose.sameBits(other.pose)
          && inHand.sameBits(other.inHand);
    }
  }

  private List<Event> drain() {
    List<Event> got = new ArrayList<>();
    recorder.drainTo(
        (sample, body, event, pose, inHand) ->
            got.add(new Event(sample, body, event, new Pose().set(pose), new Pose().set(inHand))));
    return got;
  }

  @Test
  void aListenerAddsEachEventWithTheSampleOfItsMoment() {
    long[] sample = {7};
    BodyListener listener = recorder.listener(() -> sample[0]);
    Pose pose = Pose.at(1, 2, 3);
    Pose inHand = Pose.at(4, 5, 6);
    listener.accept(2, BodyEvent.TAKEN, pose, inHand);
    sample[0] = 8;
    listener.accept(3, BodyEvent.MOVED, inHand, pose);
    List<Event> got = drain();
    assertEquals(2, got.size());
    assertTrue(new Event(7, 2, BodyEvent.TAKEN, pose, inHand).isSame(got.get(0)));
    assertTrue(new Event(8, 3, BodyEvent.MOVED, inHand, pose).isSame(got.get(1)));
  }

  @Test
  void everyEventArrivesBitForBit() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    List<BodyEvent> kinds = List.of(BodyEvent.values());
    List<Event> sent = new ArrayList<>();
    List<Event> got = new ArrayList<>();
    for (int n = 0; n < 2 * BodyRecorder.CAPACITY; n++) {
      BodyEvent event = kinds.get(random.nextInt(kinds.size()));
      Pose pose = RandomGeometry.pose(random, 50);
      Event next = new Event(n, random.nextInt(9), event, pose, RandomGeometry.pose(random, 50));
      recorder.offer(next.sample(), next.body(), event, pose, next.inHand());
      sent.add(next);
      if (random.nextInt(1000) == 0 || n % BodyRecorder.CAPACITY == 0) {
        got.addAll(drain());
      }
    }
    got.addAll(drain());
    assertEquals(sent.size(), got.size());
    for (int n = 0; n < sent.size(); n++) {
      assertTrue(sent.get(n).isSame(got.get(n)), "seed " + Seeds.seed() + " event " + n);
    }
    assertEquals(0, recorder.overflows());
  }

  @Test
  void aFullBufferDropsTheNewestEventsAndCountsThem() {
    for (int n = 0; n < BodyRecorder.CAPACITY + 5; n++) {
      recorder.offer(n, 0, BodyEvent.MOVED, new Pose(), new Pose());
    }
    List<Event> got = drain();
    assertEquals(BodyRecorder.CAPACITY, got.size());
    assertEquals(BodyRecorder.CAPACITY - 1, got.get(got.size() - 1).sample());
    assertEquals(5, recorder.overflows());
  }
}
