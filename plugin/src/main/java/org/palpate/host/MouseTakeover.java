package org.palpate.host;

import java.util.Optional;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.TurnableDevice;
import org.palpate.geometry.Vec3;

/**
 * A simulated hand that the mouse takes over as soon as the user presses with it. Threads are those
 * of {@link MouseDevice}.
 */
public final class MouseTakeover extends DeviceDecorator implements TurnableDevice {
  private final MouseDevice mouse;
  private final long intervalNanos;
  private long reads;

  /**
   * Wraps a simulated hand.
   *
   * @param hand delivers the samples until the mouse presses; its clock is ignored
   * @param region the region to touch, world mm
   * @param intervalNanos time between two samples, positive
   */
  public MouseTakeover(HapticDevice hand, HandTarget region, long intervalNanos) {
    super(hand);
    mouse = new MouseDevice(region, intervalNanos);
    this.intervalNanos = intervalNanos;
  }

  /** {@return whether the mouse has taken over} Any thread. */
  public boolean isTakenOver() {
    return mouse.hasJumped();
  }

  /** Returns the mouse. */
  MouseDevice mouse() {
    return mouse;
  }

  /** Returns the mouse as a device, if a device is one or may become one. */
  static Optional<MouseDevice> mouseOf(HapticDevice device) {
    return device instanceof MouseDevice mouse
        ? Optional.of(mouse)
        : device instanceof MouseTakeover takeover ? Optional.of(takeover.mouse) : Optional.empty();
  }

  /** Turns the mouse once it has pressed; until then the hand turns by itself. */
  @Override
  public void turn(Vec3 rotationVector) {
    if (mouse.hasJumped()) {
      mouse.turn(rotationVector);
    }
  }

  @Override
  public boolean isTurnable() {
    return mouse.hasJumped();
  }

  /** Reads the hand, or the mouse once it has pressed. */
  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = mouse.hasJumped() ? mouse.read(state) : device.read(state);
    state.timeNanos = reads++ * intervalNanos;
    return status;
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    return mouse.hasJumped()
        ? mouse.write(forceNewton, torqueNewtonMm)
        : device.write(forceNewton, torqueNewtonMm);
  }

  @Override
  public void close() {
    mouse.close();
    device.close();
  }
}
