package org.palpate.benchmarks.rigid;

import org.HdrHistogram.Histogram;
import org.palpate.collision.CollisionDevice;
import org.palpate.geometry.Pose;

/**
 * The times of whole frames of a tool that slides, once with the CPU alone and once with a device
 * that may judge legs. Times are wall time, because a frame waits for its device.
 *
 * @param condition scene, tool and clearance
 * @param points the number of sample points
 * @param cpuP50 the median with the CPU alone, us
 * @param cpuP999 the 99.9th percentile with the CPU alone, us
 * @param deviceP50 the median with the device, us
 * @param deviceP999 the 99.9th percentile with the device, us
 * @param launches launches in a frame, mean; 0 if the device was measured not to pay
 */
public record DeviceFrameTimes(
    String condition,
    int points,
    double cpuP50,
    double cpuP999,
    double deviceP50,
    double deviceP999,
    double launches) {
  private static final double NANOS_PER_MICRO = 1e3;
  private static final int SIGNIFICANT_DIGITS = 3;

  /** Frames that one of the two runs before the other takes its turn. */
  private static final int TURN_FRAMES = 100;

  /** Returns the number of conditions. */
  public static int conditions() {
    return TimedCondition.all().size();
  }

  /**
   * Slides a tool with both in turn, after a warm-up of as many frames.
   *
   * @param number the number of the condition, from 0
   * @param device judges legs; it is used by nothing else meanwhile
   * @param frames how many frames are timed
   * @throws IllegalStateException if the device failed, so that the CPU took over
   */
  public static DeviceFrameTimes of(int number, CollisionDevice device, int frames) {
    TimedCondition condition = TimedCondition.all().get(number);
    Slide onCpu = new Slide(condition.pressed(CollisionDevice.CPU));
    Slide onDevice = new Slide(condition.pressed(device));
    takeTurns(onCpu, onDevice, frames);
    onCpu.nanos.reset();
    onDevice.nanos.reset();
    long before = device.batches();
    takeTurns(onCpu, onDevice, frames);
    device
        .failure()
        .ifPresent(
            why -> {
              throw new IllegalStateException(device.name() + " failed: " + why);
            });
    return new DeviceFrameTimes(
        condition.label(),
        onCpu.pressed.run().tool.count(),
        onCpu.micros(50),
        onCpu.micros(99.9),
        onDevice.micros(50),
        onDevice.micros(99.9),
        (double) (device.batches() - before) / frames);
  }

  private static void takeTurns(Slide first, Slide second, int frames) {
    for (int begin = 0; begin < frames; begin += TURN_FRAMES) {
      int turn = Math.min(TURN_FRAMES, frames - begin);
      first.run(turn);
      second.run(turn);
    }
  }

  /** A slide that goes on where it stopped. */
  private static final class Slide {
    private final TimedCondition.Pressed pressed;
    private final Histogram nanos = new Histogram(SIGNIFICANT_DIGITS);
    private final Pose pose = new Pose();
    private int frame;

    Slide(TimedCondition.Pressed pressed) {
      this.pressed = pressed;
    }

    void run(int frames) {
      for (int n = 0; n < frames; n++) {
        pressed.device().device(frame++, pose);
        long begin = System.nanoTime();
        pressed.run().follow(pose);
        nanos.recordValue(System.nanoTime() - begin);
      }
    }

    double micros(double percent) {
      return nanos.getValueAtPercentile(percent) / NANOS_PER_MICRO;
    }
  }
}
