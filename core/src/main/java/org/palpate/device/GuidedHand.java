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
 * that thing is at its goal, as a person does by eye. It keeps this correction of its grip until it
 * lets go. An aim may have a number of tries. If the thing is not at its goal when the hand leaves
 * the stop, the hand goes back by some stops and comes again. After the last try it goes on to
 * another stop instead.
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
  private static final int NOT_BACK = Integer.MAX_VALUE;

  /** The longest correction at a stop with tries, in case the thing does not follow. */
  private static final double LONGEST_LEAD_MM = 0.5;

  private static final double LONGEST_LEAD_RAD = Math.toRadians(1);

  /** The errors up to which a thing has reached its goal at a stop with tries. */
  private static final double REACHED_MM = 0.3;

  private static final double REACHED_RAD = Math.toRadians(0.6);

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

  /** The corrected pose as it was when the hand arrived. */
  private final Pose arrived = new Pose();

  /** The pose at which the hand will arrive. */
  private final Pose next = new Pose();

  /** The motion from the planned pose of a stop to the corrected one, in the frame of the hand. */
  private final Pose correctionOfGrip = new Pose();

  private final Pose error = new Pose();

  /** The stop at which the hand is or which it left last, and the time of its arrival there. */
  private int stop;

  /** The stop to which it goes next; the number of stops if it stays. */
  private int heading;

  private boolean isLeaving;

  /** The number of tries that missed their goal on the present way. */
  private int misses;

  /** The stop to which the hand goes back after a try that missed; none if it does not go back. */
  private int backTo = NOT_BACK;

  /** The stop to which it goes from there. */
  private int afterBack;

  /** The present size of the tremor over its full size. */
  private double shakiness = 1;

  private double arrivalSeconds;
  private long reads;

  /** The reads before the first sample that was delivered. */
  private long skippedReads;

  private volatile boolean closed;

  /**
   * Creates a device whose hand is at the first stop.
   *
   * @param stops at least one
   * @param tremor the shake that is added to the motion
   * @param radiusMm radius of the ball that the hand reaches
   * @param intervalNanos time between samples, positive
   * @throws IllegalArgumentException if there is no stop or the interval is not positive
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
    pose.set(stops.get(0).pose());
    corrected.set(pose);
    arrived.set(corrected);
    this.tremor = tremor;
    this.intervalNanos = intervalNanos;
    correction = Math.min(1, CORRECTION_PER_MS * (intervalNanos / NANOS_PER_MS));
    specification = specification(radiusMm);
  }

  /**
   * {@return the specification of every guided hand that reaches as far}
   *
   * @param radiusMm radius of the ball that the hand reaches
   */
  public static DeviceSpecification specification(double radiusMm) {
    return new DeviceSpecification(
        "simulated",
        "",
        SimulatedDevice.MAX_FORCE_NEWTON,
        SimulatedDevice.MAX_STIFFNESS_NEWTON_PER_MM,
        radiusMm,
        0,
        true,
        SimulatedDevice.MAX_TORQUE_NEWTON_MM);
  }

  /**
   * Lets the hand begin on the way from a stop to the next, with the motion and the tremor that it
   * has there after the way from the first one. Call it before the first {@link #read}. A hand that
   * is closed does not move.
   *
   * @param index of a stop; the hand holds nothing on the way there
   * @param mm the distance from the next stop at which it begins; it begins at the stop itself if
   *     that is nearer
   */
  public void beginAfter(int index, double mm) {
    DeviceState unseen = new DeviceState();
    while (!closed && !hasArrived() && (stop < index || (stop == index && isFartherFromNext(mm)))) {
      read(unseen);
    }
    skippedReads = reads;
  }

  /** Whether the last sample is farther than a distance from the stop after the present one. */
  private boolean isFartherFromNext(double mm) {
    int next = stop + stops.get(stop).next();
    return next < stops.size()
        && stops.get(next).pose().translation.sub(pose.translation, shake).length() > mm;
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
    leave(seconds);
    while (isUnderway() && seconds >= arrivalAtNext()) {
      arrive();
      leave(seconds);
    }
    Optional<HandStop.Aim> aim = stops.get(stop).aim();
    if (aim.isPresent() && !isLeaving) { // a method reference would be a new object in each sample
      correct(aim.get());
    }
    setPose(seconds);
    calm(seconds);
    tremor.at(seconds, shakiness, shake, twist);
    pose.displace(shake, twist, 1, quaternion, pose);
    state.positionMm.set(pose.translation);
    state.orientation.set(pose.rotation);
    state.buttons = stops.get(stop).buttons();
    state.timeNanos = nanos - skippedReads * intervalNanos;
    return ReadStatus.FRESH;
  }

  private boolean isUnderway() {
    return isLeaving && heading < stops.size();
  }

  /** Chooses the next stop once the hand has rested at the present one. */
  private void leave(double seconds) {
    if (isLeaving || seconds < departure()) {
      return;
    }
    isLeaving = true;
    Optional<HandStop.Aim> aim = stops.get(stop).aim();
    if (backTo == NOT_BACK && aim.isPresent() && aim.get().tries() > 0 && !isReached(aim.get())) {
      goBack(aim.get());
    }
    if (stop > backTo) {
      heading = stop - 1;
    } else if (stop == backTo) {
      backTo = NOT_BACK;
      heading = afterBack;
    } else {
      heading = stop + stops.get(stop).next();
    }
  }

  private void goBack(HandStop.Aim aim) {
    boolean isLast = misses + 1 >= aim.tries();
    backTo = stop - (isLast ? aim.back() : 1 + misses % aim.back());
    afterBack = isLast ? stop + aim.otherwise() : backTo + stops.get(backTo).next();
    misses = isLast ? 0 : misses + 1;
    stops.get(stop).pose().inverseMultiply(arrived, correctionOfGrip);
  }

  private boolean isReached(HandStop.Aim aim) {
    errorOf(aim);
    return shake.length() <= REACHED_MM && twist.length() <= REACHED_RAD;
  }

  private void arrive() {
    arrivalSeconds = arrivalAtNext();
    poseOfNext(corrected);
    arrived.set(corrected);
    if (stops.get(stop).buttons() == 0) {
      correctionOfGrip.setIdentity();
      misses = 0;
    }
    stop = heading;
    isLeaving = false;
  }

  /** Writes the pose at which the hand will arrive. A hand that holds something keeps its grip. */
  private Pose poseOfNext(Pose dest) {
    Pose planned = stops.get(heading).pose();
    return stops.get(stop).buttons() == 0
        ? dest.set(planned)
        : planned.multiply(correctionOfGrip, dest);
  }

  private double departure() {
    return arrivalSeconds + stops.get(stop).restSeconds();
  }

  private double arrivalAtNext() {
    return departure() + travelSeconds(stops.get(stop).pose(), stops.get(heading).pose());
  }

  /** Moves the device by a fraction of the motion that brings the visible thing to its goal. */
  private void correct(HandStop.Aim aim) {
    errorOf(aim);
    corrected.displace(shake, twist, correction, quaternion, corrected);
    if (aim.tries() > 0) {
      limitLead();
    }
    stops.get(stop).pose().inverseMultiply(corrected, correctionOfGrip);
  }

  /** Keeps the hand near the pose of its arrival, or it would press ever harder. */
  private void limitLead() {
    arrived.differenceTo(corrected, shake, twist, quaternion);
    double far = Math.max(shake.length() / LONGEST_LEAD_MM, twist.length() / LONGEST_LEAD_RAD);
    if (far > 1) {
      arrived.displace(shake, twist, 1 / far, quaternion, corrected);
    }
  }

  /** Computes the motion that brings the visible thing to its goal, about the device. */
  private void errorOf(HandStop.Aim aim) {
    Pose seen = aim.seen().get();
    aim.goal().rotation.multiply(seen.rotation.conjugate(quaternion), error.rotation);
    error.rotation.rotate(seen.translation, shake);
    aim.goal().translation.sub(shake, error.translation);
    error.transform(corrected.translation, shake).sub(corrected.translation, shake);
    error.rotation.rotationVector(twist);
  }

  private double travelSeconds(Pose from, Pose to) {
    from.differenceTo(to, shake, twist, quaternion);
    return Math.max(shake.length() / MM_PER_SECOND, twist.length() / RAD_PER_SECOND);
  }

  private void setPose(double seconds) {
    pose.set(corrected);
    double since = seconds - departure();
    if (isUnderway() && since > 0) {
      double t = since / (arrivalAtNext() - departure());
      double eased = t * t * t * (10 + t * (6 * t - 15));
      pose.interpolate(poseOfNext(next), eased, scratch, pose);
    }
  }

  /** Lets the tremor die away at a steady stop, and come back after it. */
  private void calm(double seconds) {
    boolean isCalm = stops.get(stop).isSteady() && !(isUnderway() && seconds > departure());
    double change = intervalNanos * 1e-9 / CALMING_SECONDS;
    shakiness = isCalm ? Math.max(0, shakiness - change) : Math.min(1, shakiness + change);
  }

  /** {@return whether the hand has rested at its last stop, where it stays} */
  public boolean hasArrived() {
    return isLeaving && heading >= stops.size();
  }

  /** {@return the time after which the hand stays at its last stop if each try succeeds} */
  public double durationSeconds() {
    double seconds = 0;
    int n = 0;
    for (int to = stops.get(0).next(); to < stops.size(); to += stops.get(n).next()) {
      seconds += stops.get(n).restSeconds();
      seconds += travelSeconds(stops.get(n).pose(), stops.get(to).pose());
      n = to;
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
