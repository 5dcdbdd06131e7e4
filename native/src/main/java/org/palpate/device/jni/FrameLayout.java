package org.palpate.device.jni;

/**
 * Offsets in the 256 bytes that Java and C++ share, one block for each device, in native byte
 * order. {@code device/frame.h} has the same layout.
 *
 * <pre>
 *   0        8              32              64      68    72      80      88 .. 127
 *   | time i64 | position 3 f64 | quaternion 4 f64 | buttons | flags | gripper | heat | unused |
 *   128            152            176       184      192 .. 255
 *   | force 3 f64 | torque 3 f64 | gripper | unused | counters 8 i64 |
 * </pre>
 */
final class FrameLayout {
  static final int TIME_NANOS = 0;
  static final int POSITION_MM = 8;
  static final int ORIENTATION = 32;
  static final int BUTTONS = 64;
  static final int FLAGS = 68;
  static final int GRIPPER_MM = 72;
  static final int MOTOR_HEAT = 80;
  static final int FORCE_NEWTON = 128;
  static final int TORQUE_NEWTON_METRE = 152;
  static final int GRIPPER_NEWTON = 176;
  static final int COUNTERS = 192;
  static final int BYTES = 256;

  /** Bit of {@link #FLAGS}, as are the following. */
  static final int FORCE_READY = 1;

  static final int WAITING_FOR_HAND = 1 << 1;
  static final int NEEDS_CALIBRATION = 1 << 2;
  static final int MOTORS_HOT = 1 << 3;
  static final int WATCHDOG_TRIPPED = 1 << 4;

  private FrameLayout() {}
}
