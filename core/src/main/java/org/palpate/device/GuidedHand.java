package org.palpate.device;

import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * A device of six degrees of freedom in a simulated hand that goes from stop to stop, straight and
 * with minimal jerk, and then stays at the last one. A tremor is added to its motion.
 *
 * <p>At a stop with an aim it also looks at what it moves, and shifts and turns the device until
 * that thing is at its goal, as a person does by eye.
 *
 * <p>Each read is the next sample. The motion depends on the stops, on what is seen and on the
 * number of reads, never on a clock or on forces. A session can therefore be repeated. Haptic
 * thread; {@link #close} is for any thread.
 */
public final class GuidedHand implements HapticDevice {
  /** The mean speed between two stops. */
  public static final double MM_PER_SECOND = 60;

  /** The mean angular speed between two stops. */
  public static final double RAD_PER_SECOND = 1;

  /** The fraction of the visible error that the hand corrects in a millisecond. */
  private static final double CORRECTION_PER_MS = 0.005;

  private static final double NANOS_PER_MS = 1e6;

  /** The time in which the tremor dies away at a steady stop. */
  private static final double CALMING_SECONDS = 0.3;

  private final DeviceSpecification specification;
  private final List<HandStop> stops;
  private final Tremor tremor;
  private final long intervalNanos;
  private final double correction;
  private final Pose pose = new Pose();
  private final Pose.Scratch scratch = new Pose.Scratch();
  private final Quaternion quaternion = new Quaternion();
  private final Vec3 shake = new Vec3();
  private final Vec3 twist = new Vec3();

  /** The pose of the present stop, with the corrections so far. */
  private final Pose corrected = new Pose();

  private final Pose error = new Pose();

  /** The stop at which the hand is or which it left last, and the time of its arrival there. */
  private int stop;

  private double arrivalSeconds;
  private long reads;
  private volatile boolean closed;

  /**
   * Creates a device whose hand is at the first stop.
   *
   * @param stops at least one
   * @param radiusMm radius of the ball that the hand reaches
   * @param intervalNanos time between samples, positive
   */
  public GuidedHand(List<HandStop> stops, Tremor tremor, double radiusMm, long intervalNanos) {
    if (stops.isEmpty() || intervalNanos <= 0) {
      throw new IllegalArgumentException(
          "a hand needs a stop and a positive interval: stops="
              + stops.size()
              + ", intervalNanos="
              + intervalNanos);
    }
    this.stops = List.copyOf(stops);
    corrected.set(stops.get(0).pose());
    this.tremor = tremor;
    this.intervalNanos = intervalNanos;
    correction = Math.min(1, CORRECTION_PER_MS * (intervalNanos / NANOS_PER_MS));
    specification =
        new DeviceSpecification(
            "simulated",
            "",
            SimulatedDevice.MAX_FORCE_NEWTON,
            SimulatedDevice.MAX_STIFFNESS_NEWTON_PER_MM,
            radiusMm,
            0,
            true,
            SimulatedDevice.MAX_TORQUE_NEWTON_MM);
  }

  @Override
  public DeviceSpecification specification() {
    return specification;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    if (closed) {
      return ReadStatus.DISCONNECTED;
    }
    long nanos = reads++ * intervalNanos;
    double seconds = nanos * 1e-9;
    while (stop + 1 < stops.size() && seconds >= arrivalAtNext()) {
      arrivalSeconds = arrivalAtNext();
      corrected.set(stops.get(++stop).pose());
    }
    Optional<HandStop.Aim> aim = stops.get(stop).aim();
    if (aim.isPresent()) { // a method reference would be a new object in each sample
      correct(aim.get());
    }
    setPose(seconds);
    tremor.at(seconds, shakiness(seconds), shake, twist);
    pose.displace(shake, twist, 1, quaternion, pose);
    state.positionMm.set(pose.translation);
    state.orientation.set(pose.rotation);
    state.buttons = stops.get(stop).buttons();
    state.timeNanos = nanos;
    return ReadStatus.FRESH;
  }

  private double departure() {
    return arrivalSeconds + stops.get(stop).restSeconds();
  }

  private double arrivalAtNext() {
    return departure() + travelSeconds(stops.get(stop).pose(), stops.get(stop + 1).pose());
  }

  /** Moves the device by a fraction of the motion that brings the visible thing to its goal. */
  private void correct(HandStop.Aim aim) {
    Pose seen = aim.seen().get();
    aim.goal().rotation.multiply(seen.rotation.conjugate(quaternion), error.rotation);
    error.rotation.rotate(seen.translation, shake);
    aim.goal().translation.sub(shake, error.translation);
    error.transform(corrected.translation, shake).sub(corrected.translation, shake);
    error.rotation.rotationVector(twist);
    corrected.displace(shake, twist, correction, quaternion, corrected);
  }

  private double travelSeconds(Pose from, Pose to) {
    from.differenceTo(to, shake, twist, quaternion);
    return Math.max(shake.length() / MM_PER_SECOND, twist.length() / RAD_PER_SECOND);
  }

  private void setPose(double seconds) {
    pose.set(corrected);
    double since = seconds - departure();
    if (stop + 1 < stops.size() && since > 0) {
      double t = since / (arrivalAtNext() - departure());
      double eased = t * t * t * (10 + t * (6 * t - 15));
      pose.interpolate(stops.get(stop + 1).pose(), eased, scratch, pose);
    }
  }

  /** Returns the fraction of the tremor: it dies away at a steady stop and comes back after it. */
  private double shakiness(double seconds) {
    if (!stops.get(stop).isSteady()) {
      return 1;
    }
    double calm = (seconds - arrivalSeconds) / CALMING_SECONDS;
    double after = stop + 1 < stops.size() ? (seconds - departure()) / CALMING_SECONDS : 0;
    return Math.max(Math.max(0, 1 - calm), Math.min(1, after));
  }

  /** Returns the time after which the hand stays at its last stop. */
  public double durationSeconds() {
    double seconds = 0;
    for (int n = 0; n + 1 < stops.size(); n++) {
      seconds +=
          stops.get(n).restSeconds() + travelSeconds(stops.get(n).pose(), stops.get(n + 1).pose());
    }
    return seconds;
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    return !closed;
  }

  @Override
  public void close() {
    closed = true;
  }
}
