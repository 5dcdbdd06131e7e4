package org.palpate.device;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * A device whose own frame is mapped to the world: by a {@link Workspace}, a clutch and two speeds.
 *
 * <p>While the clutch is held the point stays where it is, without force, and the hand goes back to
 * where it has room; when it is let go the force comes back over {@link #RETURN_NANOS}. The speed
 * button changes between full and fine movement about the point where it is. Buttons and
 * orientation come through; so does what is not finite, without a change of the mapping.
 *
 * <p>Read and written by the haptic thread, which owns all of the state; allocates nothing.
 */
public final class WorkspaceDevice extends DeviceDecorator {
  /** How long the force takes to come back after the clutch. */
  public static final long RETURN_NANOS = 150_000_000L;

  private final Workspace workspace;
  private final Controls controls;
  private final DeviceSpecification specification;
  private final Vec3 offsetMm;
  private final Vec3 stepMm = new Vec3();
  private final Vec3 heldMm = new Vec3();
  private final Vec3 deviceNewton = new Vec3();
  private final double[] rotation;
  private final DeviceState raw = new DeviceState();
  private double speed = 1;
  private int lastButtons;
  private boolean clutched;
  private volatile boolean clutchWanted;
  private boolean returning;
  private boolean placed;
  private long releasedNanos;
  private double forceShare = 1;

  /**
   * Which buttons do what.
   *
   * @param clutchButton bit of the button that holds the point; 0 for none
   * @param speedButton bit of the button that changes the speed; 0 for none
   * @param fineSpeed share of the full movement, in (0, 1]
   */
  public record Controls(int clutchButton, int speedButton, double fineSpeed) {

    /** Checks the speed. */
    public Controls {
      if (!(fineSpeed > 0 && fineSpeed <= 1)) {
        throw new IllegalArgumentException("fineSpeed must be in (0, 1]: fineSpeed=" + fineSpeed);
      }
    }

    /** The second button is the clutch, the third changes to a quarter of the speed. */
    public static Controls standard() {
      return new Controls(2, 4, 0.25);
    }
  }

  /** Maps {@code device}, which is in its own frame, and closes it when it is closed. */
  public WorkspaceDevice(HapticDevice device, Workspace workspace, Controls controls) {
    super(device);
    this.workspace = workspace;
    this.controls = controls;
    this.offsetMm = new Vec3().set(workspace.deviceToWorld().origin());
    this.rotation = quaternion(workspace.deviceToWorld());
    DeviceSpecification own = device.specification();
    this.specification =
        new DeviceSpecification(
            own.name(),
            own.serial(),
            own.maxForceNewton(),
            workspace.stiffnessNewtonPerMm(own, 1),
            own.workspaceRadiusMm() * workspace.largestScale(),
            own.reportIntervalNanos());
  }

  /** Of the device as the world sees it: stiffness per world mm, reach in world mm. */
  @Override
  public DeviceSpecification specification() {
    return specification;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = device.read(raw);
    if (status == ReadStatus.FRESH) {
      state.set(raw);
      place(state);
      turn(state);
    }
    return status;
  }

  private void place(DeviceState state) {
    workspace.toWorldStep(raw.positionMm, stepMm).mul(speed, stepMm);
    if (stepMm.isFinite()) {
      changeSpeed(state.buttons);
      changeClutch(state.buttons, state.timeNanos);
      lastButtons = state.buttons;
    }
    stepMm.add(offsetMm, state.positionMm);
    if (clutched && state.positionMm.isFinite()) {
      state.positionMm.set(heldMm);
    } else if (state.positionMm.isFinite()) {
      heldMm.set(state.positionMm);
      placed = true;
    }
    comeBack(state.timeNanos);
  }

  /** Keeps the point where it is and lets later movement count for more or less. */
  private void changeSpeed(int buttons) {
    if (pressedNow(controls.speedButton(), buttons)) {
      double next = speed == 1 ? controls.fineSpeed() : 1;
      double ratio = next / speed;
      offsetMm.set(
          offsetMm.x + stepMm.x * (1 - ratio),
          offsetMm.y + stepMm.y * (1 - ratio),
          offsetMm.z + stepMm.z * (1 - ratio));
      stepMm.mul(ratio, stepMm);
      speed = next;
    }
  }

  private void changeClutch(int buttons, long nanos) {
    boolean wanted = clutchWanted || (buttons & controls.clutchButton()) != 0;
    boolean held = wanted && placed;
    if (clutched && !held) {
      heldMm.sub(stepMm, offsetMm);
      releasedNanos = nanos;
      returning = true;
    }
    clutched = held;
  }

  private boolean pressedNow(int button, int buttons) {
    return (buttons & ~lastButtons & button) != 0;
  }

  private void comeBack(long nanos) {
    if (clutched) {
      forceShare = 0;
    } else if (returning) {
      forceShare = Math.min(1, Math.max(0, (nanos - releasedNanos) / (double) RETURN_NANOS));
      returning = forceShare < 1;
    }
  }

  /** The device's turn, then the workspace's: the product of their quaternions. */
  private void turn(DeviceState state) {
    double x = rotation[0];
    double y = rotation[1];
    double z = rotation[2];
    double w = rotation[3];
    state.qx = w * raw.qx + x * raw.qw + y * raw.qz - z * raw.qy;
    state.qy = w * raw.qy - x * raw.qz + y * raw.qw + z * raw.qx;
    state.qz = w * raw.qz + x * raw.qy - y * raw.qx + z * raw.qw;
    state.qw = w * raw.qw - x * raw.qx - y * raw.qy - z * raw.qz;
  }

  @Override
  public boolean write(Vec3 forceNewton) {
    workspace.toDeviceForce(forceNewton, deviceNewton);
    return device.write(deviceNewton.mul(forceShare, deviceNewton));
  }

  /** Holds the clutch as its button does, or lets it go, from the next sample on. Any thread. */
  public void holdClutch(boolean wanted) {
    clutchWanted = wanted;
  }

  /** Whether {@link #holdClutch} holds the clutch. Any thread. */
  public boolean isClutchWanted() {
    return clutchWanted;
  }

  /** Whether the clutch is held. Haptic thread. */
  public boolean isClutched() {
    return clutched;
  }

  /** The unit quaternion (x, y, z, w) of a rotation; the largest component is never divided by. */
  private static double[] quaternion(RigidTransform t) {
    double xx = t.axisX().x;
    double yy = t.axisY().y;
    double zz = t.axisZ().z;
    double x = Math.sqrt(Math.max(0, 1 + xx - yy - zz)) / 2;
    double y = Math.sqrt(Math.max(0, 1 - xx + yy - zz)) / 2;
    double z = Math.sqrt(Math.max(0, 1 - xx - yy + zz)) / 2;
    double w = Math.sqrt(Math.max(0, 1 + xx + yy + zz)) / 2;
    return signed(t, x, y, z, w);
  }

  /** Gives the parts the signs that belong to the largest one being positive. */
  private static double[] signed(RigidTransform t, double x, double y, double z, double w) {
    double yz = t.axisZ().y + t.axisY().z;
    double zx = t.axisX().z + t.axisZ().x;
    double xy = t.axisY().x + t.axisX().y;
    double ofX = t.axisY().z - t.axisZ().y;
    double ofY = t.axisZ().x - t.axisX().z;
    double ofZ = t.axisX().y - t.axisY().x;
    double largest = Math.max(Math.max(x, y), Math.max(z, w));
    if (w == largest) {
      return new double[] {copy(x, ofX), copy(y, ofY), copy(z, ofZ), w};
    }
    if (x == largest) {
      return new double[] {x, copy(y, xy), copy(z, zx), copy(w, ofX)};
    }
    if (y == largest) {
      return new double[] {copy(x, xy), y, copy(z, yz), copy(w, ofY)};
    }
    return new double[] {copy(x, zx), copy(y, yz), z, copy(w, ofZ)};
  }

  private static double copy(double size, double sign) {
    return Math.copySign(size, sign);
  }
}
