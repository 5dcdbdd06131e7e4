package org.palpate.device.jni;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/**
 * A device behind the C++ layer. A frame reads it with one native call and writes it with another,
 * through one direct buffer and without allocation.
 *
 * <p>Poses, forces and torques are in the device's frame: x to the right, y up, z towards the
 * person; {@link org.palpate.device.WorkspaceDevice} maps them to the world.
 *
 * <p>The C++ layer limits every force and torque to the device's limits. It sends no force until
 * the hand has held the device still, and sends zero force if samples stay away. {@link #watchdog}
 * names what zeroes the force if this process stops; WoodenHaptics has nothing that does.
 *
 * <p>One thread reads and writes; any thread may close.
 */
public final class NativeDevice implements HapticDevice {
  private static final int CLOSE_WAIT_MILLIS = 500;
  private static final double MM_PER_METRE = 1000;
  private static final double METRE_PER_MM = 1 / MM_PER_METRE;
  private static final ReadStatus[] STATUSES = ReadStatus.values();

  private final long handle;
  private final ByteBuffer frame;
  private final DeviceSpecification specification;
  private final String watchdog;

  NativeDevice(long handle) {
    this.handle = handle;
    this.frame = NativeCalls.frame(handle).order(ByteOrder.nativeOrder());
    double[] numbers = new double[6];
    KeyedLines texts = KeyedLines.parse(NativeCalls.specification(handle, numbers));
    this.watchdog = texts.first("watchdog");
    this.specification =
        new DeviceSpecification(
            texts.first("name"),
            texts.first("serial"),
            numbers[0],
            numbers[1],
            numbers[2],
            (long) numbers[3],
            texts.first("orientation").equals("yes"),
            MM_PER_METRE * numbers[5]);
  }

  @Override
  public DeviceSpecification specification() {
    return specification;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    int status = NativeCalls.read(handle);
    if (status == 0) {
      copyTo(state);
    }
    return STATUSES[status];
  }

  private void copyTo(DeviceState state) {
    state.timeNanos = frame.getLong(FrameLayout.TIME_NANOS);
    state.positionMm.x = frame.getDouble(FrameLayout.POSITION_MM);
    state.positionMm.y = frame.getDouble(FrameLayout.POSITION_MM + 8);
    state.positionMm.z = frame.getDouble(FrameLayout.POSITION_MM + 16);
    state.orientation.x = frame.getDouble(FrameLayout.ORIENTATION);
    state.orientation.y = frame.getDouble(FrameLayout.ORIENTATION + 8);
    state.orientation.z = frame.getDouble(FrameLayout.ORIENTATION + 16);
    state.orientation.w = frame.getDouble(FrameLayout.ORIENTATION + 24);
    state.buttons = frame.getInt(FrameLayout.BUTTONS);
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    put(FrameLayout.FORCE_NEWTON, forceNewton, 1);
    put(FrameLayout.TORQUE_NEWTON_METRE, torqueNewtonMm, METRE_PER_MM);
    return NativeCalls.write(handle);
  }

  private void put(int at, Vec3 v, double factor) {
    frame.putDouble(at, factor * v.x);
    frame.putDouble(at + 8, factor * v.y);
    frame.putDouble(at + 16, factor * v.z);
  }

  /** Whether the force is zero because the hand has not yet held the device still. Any thread. */
  public boolean isWaitingForHand() {
    return (frame.getInt(FrameLayout.FLAGS) & FrameLayout.WAITING_FOR_HAND) != 0;
  }

  /** Whether the device must be calibrated before it exerts a force. Any thread. */
  public boolean needsCalibration() {
    return (frame.getInt(FrameLayout.FLAGS) & FrameLayout.NEEDS_CALIBRATION) != 0;
  }

  /** Returns the heat of the motors: 0 cold, 1 the vendor's limit; 0 if unknown. Any thread. */
  public double motorHeat() {
    return frame.getDouble(FrameLayout.MOTOR_HEAT);
  }

  /** Returns the counters of the samples so far. Any thread. */
  public DeviceCounters counters() {
    return new DeviceCounters(
        counter(0),
        counter(1),
        counter(2),
        counter(3),
        counter(4),
        counter(5),
        counter(6),
        counter(7));
  }

  private long counter(int index) {
    return frame.getLong(FrameLayout.COUNTERS + 8 * index);
  }

  /**
   * Returns one line with the reason why the device is gone, or with the state of its last force;
   * empty while it works and after an orderly close. Any thread.
   */
  @Override
  public String ending() {
    return NativeCalls.ending(handle);
  }

  /** Returns the name of what zeroes the force if this program no longer can. */
  public String watchdog() {
    return watchdog;
  }

  /**
   * Sends zero force, then releases the device. Waits up to half a second for the haptic thread's
   * call to return. If that call hangs, {@link #ending} reports it and the device's own watchdog
   * zeroes the force.
   */
  @Override
  public void close() {
    NativeCalls.close(handle, CLOSE_WAIT_MILLIS);
  }
}
