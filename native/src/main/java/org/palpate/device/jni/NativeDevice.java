package org.palpate.device.jni;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/**
 * A device behind the C++ layer: one native call to read and one to write, through one direct
 * buffer, without allocation.
 *
 * <p>Positions and forces are in the device's frame: millimetres and newtons, x to the right, y up,
 * z towards the person; {@link org.palpate.device.WorkspaceDevice} maps them to the world. The C++
 * layer limits what is written to what the device bears, lets force in only when the hand has held
 * the device still, and zeroes it when samples stay away; each device has a watchdog of its own for
 * when this process stops.
 *
 * <p>Read and written by one thread; closed by any.
 */
public final class NativeDevice implements HapticDevice {
  private static final int CLOSE_WAIT_MILLIS = 500;
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
            (long) numbers[3]);
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
    state.qx = frame.getDouble(FrameLayout.ORIENTATION);
    state.qy = frame.getDouble(FrameLayout.ORIENTATION + 8);
    state.qz = frame.getDouble(FrameLayout.ORIENTATION + 16);
    state.qw = frame.getDouble(FrameLayout.ORIENTATION + 24);
    state.buttons = frame.getInt(FrameLayout.BUTTONS);
  }

  @Override
  public boolean write(Vec3 forceNewton) {
    frame.putDouble(FrameLayout.FORCE_NEWTON, forceNewton.x);
    frame.putDouble(FrameLayout.FORCE_NEWTON + 8, forceNewton.y);
    frame.putDouble(FrameLayout.FORCE_NEWTON + 16, forceNewton.z);
    return NativeCalls.write(handle);
  }

  /**
   * Sets the torque that goes with every force from the next write on; 0 until this is called.
   * Devices without torque ignore it. Haptic thread.
   *
   * @param torqueNewtonMetre on the hand, device frame
   */
  public void torque(Vec3 torqueNewtonMetre) {
    frame.putDouble(FrameLayout.TORQUE_NEWTON_METRE, torqueNewtonMetre.x);
    frame.putDouble(FrameLayout.TORQUE_NEWTON_METRE + 8, torqueNewtonMetre.y);
    frame.putDouble(FrameLayout.TORQUE_NEWTON_METRE + 16, torqueNewtonMetre.z);
  }

  /** Whether no force comes yet because the hand has not held the device still. Any thread. */
  public boolean isWaitingForHand() {
    return (frame.getInt(FrameLayout.FLAGS) & FrameLayout.WAITING_FOR_HAND) != 0;
  }

  /** Whether the device wants to be calibrated before it pushes. Any thread. */
  public boolean needsCalibration() {
    return (frame.getInt(FrameLayout.FLAGS) & FrameLayout.NEEDS_CALIBRATION) != 0;
  }

  /** Heat of the motors: 0 cold, 1 as hot as the maker allows; 0 where unknown. Any thread. */
  public double motorHeat() {
    return frame.getDouble(FrameLayout.MOTOR_HEAT);
  }

  /** What befell the samples so far; a moment's view. Any thread. */
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
   * One line: why the device is gone, or how its last force was left; empty while all is well and
   * after an orderly close. Any thread.
   */
  @Override
  public String ending() {
    return NativeCalls.ending(handle);
  }

  /** Who zeroes the force when this program no longer can. */
  public String watchdog() {
    return watchdog;
  }

  /**
   * Sends zero force, then lets the device go. Waits up to half a second for the haptic thread's
   * call to return; where it hangs, {@link #ending} says so and the device's own watchdog stands
   * in.
   */
  @Override
  public void close() {
    NativeCalls.close(handle, CLOSE_WAIT_MILLIS);
  }
}
