package org.palpate.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.testing.ScriptedDevice;
import org.palpate.testing.Seeds;

class SampleRecorderTest {
  private final DeviceState sample = new DeviceState();

  @Test
  void everySampleArrivesBitForBit() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    SampleRecorder recorder = new SampleRecorder(100);
    List<DeviceState> sent = new ArrayList<>();
    List<DeviceState> got = new ArrayList<>();
    for (int i = 0; i < 1000; i++) {
      fill(random);
      recorder.offer(sample);
      sent.add(new DeviceState().set(sample));
      if (random.nextLong() % 20 == 0 || i % 100 == 99) {
        recorder.drainTo((state, flags) -> got.add(new DeviceState().set(state)));
      }
    }
    assertEquals(sent.size(), got.size());
    for (int i = 0; i < sent.size(); i++) {
      assertSameSample(sent.get(i), got.get(i), "seed=" + Seeds.seed() + " sample=" + i);
    }
    assertEquals(0, recorder.overflows());
  }

  @Test
  void samplesThatAreNotFiniteOrGoBackInTimeAreFlagged() {
    SampleRecorder recorder = new SampleRecorder();
    double[] x = {0, Double.NaN, 1, Double.POSITIVE_INFINITY, 2};
    long[] time = {5, 6, 4, 3, 3};
    for (int i = 0; i < 5; i++) {
      sample.positionMm.set(x[i], 0, 0);
      sample.timeNanos = time[i];
      recorder.offer(sample);
    }
    List<Integer> flags = new ArrayList<>();
    recorder.drainTo((state, ofSample) -> flags.add(ofSample.code()));
    assertEquals(List.of(0, 1, 2, 3, 0), flags);
  }

  @Test
  void aFullBufferDropsTheNewestSamplesAndCountsThem() {
    SampleRecorder recorder = new SampleRecorder(4);
    for (int i = 0; i < 10; i++) {
      sample.timeNanos = i;
      recorder.offer(sample);
    }
    List<Long> times = new ArrayList<>();
    recorder.drainTo((state, flags) -> times.add(state.timeNanos));
    assertEquals(List.of(0L, 1L, 2L, 3L), times);
    assertEquals(6, recorder.overflows());
  }

  @Test
  void noSampleIsTornOrLostBetweenTwoThreads() throws InterruptedException {
    int samples = 500_000;
    SampleRecorder recorder = new SampleRecorder(1000);
    AtomicBoolean ended = new AtomicBoolean();
    long[] next = new long[1];
    String[] fault = new String[1];
    SampleRecorder.Sink sink =
        (state, flags) -> {
          long time = next[0]++;
          if (state.timeNanos != time || state.positionMm.z != time || state.buttons != time) {
            fault[0] = "sample " + time + " came as " + state.timeNanos;
          }
        };
    Thread reader =
        new Thread(
            () -> {
              while (!ended.get()) {
                recorder.drainTo(sink);
              }
            });
    reader.start();
    for (int i = 0; i < samples; i++) {
      sample.timeNanos = i;
      sample.positionMm.set(-i, i / 2.0, i);
      sample.buttons = i;
      long lost;
      do {
        lost = recorder.overflows();
        recorder.offer(sample);
      } while (recorder.overflows() != lost);
    }
    ended.set(true);
    reader.join();
    recorder.drainTo(sink);
    assertEquals(null, fault[0]);
    assertEquals(samples, next[0]);
  }

  @Test
  void aRecordedSessionIsWrittenAsATrajectory() {
    SampleRecorder recorder = new SampleRecorder();
    ScriptedDevice device =
        new ScriptedDevice(
            (read, state) ->
                read % 2 == 1
                    ? ReadStatus.REPEATED
                    : ScriptedDevice.fresh(state, 100 + read, read == 4 ? Double.NaN : 0.1, 2, -3));
    RecordingDevice recording = new RecordingDevice(device, recorder);
    StringBuilder file = new StringBuilder();
    RecordingThread thread =
        RecordingThread.start(recorder, new TrajectoryWriter(file, Double::toString));
    for (int i = 0; i < 6; i++) {
      recording.read(sample);
    }
    thread.close();
    thread.close();
    assertEquals(
        """
        t_ms,x,y,z,qw,qx,qy,qz,flags
        0.0,0.1,2.0,-3.0,1.0,0.0,0.0,0.0,0
        2.0,0.1,2.0,-3.0,1.0,0.0,0.0,0.0,0
        4.0,NaN,2.0,-3.0,1.0,0.0,0.0,0.0,1
        """,
        file.toString());
  }

  @Test
  void aRecordingDeviceDelegatesEverythingElse() {
    ScriptedDevice device = ScriptedDevice.at(1, 2, 3);
    RecordingDevice recording = new RecordingDevice(device, new SampleRecorder());
    assertEquals(device.specification(), recording.specification());
    device.reachable = false;
    assertEquals("the cable is out", recording.ending());
    assertFalse(recording.write(new Vec3(), new Vec3()));
    recording.close();
    assertEquals(1, device.closed);
  }

  @Test
  void aSinkThatThrowsIsReportedAtTheEnd() {
    SampleRecorder recorder = new SampleRecorder();
    IllegalStateException full = new IllegalStateException("disk full");
    recorder.offer(sample);
    RecordingThread thread =
        RecordingThread.start(
            recorder,
            (state, flags) -> {
              throw full;
            });
    assertSame(full, assertThrows(IllegalStateException.class, thread::close));
    assertNotNull(thread.failure());
  }

  private void fill(SplittableRandom random) {
    sample.timeNanos = random.nextLong();
    sample.positionMm.set(anyDouble(random), anyDouble(random), anyDouble(random));
    sample.orientation.x = anyDouble(random);
    sample.orientation.y = anyDouble(random);
    sample.orientation.z = anyDouble(random);
    sample.orientation.w = anyDouble(random);
    sample.buttons = (int) random.nextLong();
  }

  private static double anyDouble(SplittableRandom random) {
    return Double.longBitsToDouble(random.nextLong());
  }

  private static void assertSameSample(DeviceState sent, DeviceState got, String where) {
    boolean same =
        sent.positionMm.sameBits(got.positionMm)
            && sent.timeNanos == got.timeNanos
            && sent.buttons == got.buttons
            && Double.compare(sent.orientation.x, got.orientation.x) == 0
            && Double.compare(sent.orientation.y, got.orientation.y) == 0
            && Double.compare(sent.orientation.z, got.orientation.z) == 0
            && Double.compare(sent.orientation.w, got.orientation.w) == 0;
    assertTrue(same, where);
  }
}
