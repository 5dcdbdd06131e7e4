package org.palpate.device;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Gives a device without orientation one that a program turns, for example by keys. A requested
 * turn is a goal, which the orientation approaches at {@link #RADIANS_PER_SECOND} of the device's
 * clock. So the force does not jump, and a recording of the samples holds the turns.
 *
 * <p>Turns apply only as long as something is held. What is left of a turn then is dropped, and the
 * orientation stays. Before the first turn, samples pass bit for bit.
 *
 * <p>Any thread requests turns. The haptic thread reads the device; that allocates nothing and
 * takes no lock.
 */
public final class TurnedDevice extends DeviceDecorator implements TurnableDevice {
  /** The rate at which the orientation approaches its goal, rad/s. */
  public static final double RADIANS_PER_SECOND = Math.PI / 2;

  /** The goal is never farther ahead, rad, so that the shortest way to it is the requested one. */
  static final double LARGEST_LEAD = 2;

  /** The longest time between two samples during which the orientation turns. */
  private static final long LONGEST_STEP_NANOS = 20_000_000;

  private static final double NANOS_PER_SECOND = 1e9;

  private final BooleanSupplier isHeld;

  /** The turn that was requested since the last sample; null if none was. */
  private final AtomicReference<Quaternion> requested = new AtomicReference<>();

  private final DeviceState raw = new DeviceState();
  private final Quaternion goal = new Quaternion();
  private final Quaternion present = new Quaternion();
  private final Quaternion way = new Quaternion();
  private final Quaternion next = new Quaternion();
  private final Vec3 rotation = new Vec3();
  private boolean hasTurned;
  private long lastNanos;
  private boolean hasTime;

  /**
   * Turns a device, which it closes when it is closed itself.
   *
   * @param device a device without orientation
   * @param isHeld whether the hand holds what turns; haptic thread
   */
  public TurnedDevice(HapticDevice device, BooleanSupplier isHeld) {
    super(device);
    this.isHeld = isHeld;
  }

  /**
   * Makes a device turnable, unless it is already or has an orientation of its own.
   *
   * @param device any device
   * @param isHeld whether the hand holds what turns; haptic thread
   * @return the device itself, or one that turns it
   */
  public static HapticDevice of(HapticDevice device, BooleanSupplier isHeld) {
    boolean turns = device instanceof TurnableDevice || device.specification().hasOrientation();
    return turns ? device : new TurnedDevice(device, isHeld);
  }

  /**
   * Requests a turn. Nothing happens if nothing is held, or if the goal would lie too far ahead.
   */
  @Override
  public void turn(Vec3 rotationVector) {
    Quaternion turn = new Quaternion().setRotationVector(rotationVector);
    double angle = rotationVector.length();
    requested.updateAndGet(before -> added(before, turn, angle));
  }

  /** Returns a turn after an earlier one; that one alone if both together may lead too far. */
  private static Quaternion added(Quaternion before, Quaternion turn, double angle) {
    double earlier = before == null ? 0 : before.angle();
    if (!(earlier + angle < LARGEST_LEAD)) { // or NaN
      return before;
    }
    return before == null ? turn : turn.multiply(before, new Quaternion());
  }

  @Override
  public ReadStatus read(DeviceState state) {
    raw.relocated = false; // Most devices never set it.
    ReadStatus status = device.read(raw);
    if (status == ReadStatus.FRESH) {
      state.set(raw);
      takeRequest();
      approach(nanosSinceLast(raw.timeNanos) / NANOS_PER_SECOND);
      if (hasTurned) {
        present.multiply(raw.orientation, state.orientation);
      }
    }
    return status;
  }

  private long nanosSinceLast(long nanos) {
    long since = hasTime ? nanos - lastNanos : 0;
    hasTime = true;
    lastNanos = nanos;
    return Math.max(0, Math.min(LONGEST_STEP_NANOS, since));
  }

  private void takeRequest() {
    Quaternion turn = requested.getAndSet(null);
    if (!isHeld.getAsBoolean()) {
      goal.set(present);
    } else if (turn != null
        && turn.multiply(goal, next).normalize()
        && leadOf(next) < LARGEST_LEAD) {
      goal.set(next);
      hasTurned = true;
    }
  }

  /** Returns the angle from the present orientation to another, rad. */
  private double leadOf(Quaternion other) {
    return other.multiply(present.conjugate(way), way).angle();
  }

  private void approach(double seconds) {
    double angle = leadOf(goal); // Also leaves the way.
    double step = RADIANS_PER_SECOND * seconds;
    if (angle <= step) {
      present.set(goal);
    } else {
      way.rotationVector(rotation).mul(step / angle, rotation);
      way.setRotationVector(rotation).multiply(present, present);
      present.normalize();
    }
  }
}
