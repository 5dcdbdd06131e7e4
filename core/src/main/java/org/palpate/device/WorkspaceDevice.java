package org.palpate.device;

import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Maps a device's own frame to the world by a {@link Workspace}, a clutch and two speeds.
 *
 * <p>While the clutch is held, position and orientation rest and there is no force. The hand can
 * then return to a pose with more room. After the release the force returns over {@link
 * #RETURN_NANOS}. The speed button switches between full and fine motion about the present
 * position; rotation is never scaled. New axes change neither position nor orientation.
 *
 * <p>Buttons pass through. A position that is not finite passes too and changes nothing of the
 * mapping; so does an orientation that is not {@linkplain Quaternion#isNearUnit near} a unit
 * quaternion.
 *
 * <p>The haptic thread reads and writes the device and owns its state. Allocates nothing.
 */
public final class WorkspaceDevice extends DeviceDecorator {
  /** Time in which the force returns after the clutch was released. */
  public static final long RETURN_NANOS = 150_000_000L;

  private final Controls controls;
  private final DeviceSpecification specification;
  private final DeviceState raw = new DeviceState();

  /** Displacement of the device from its origin, world mm, at the present speed. */
  private final Vec3 displacementMm = new Vec3();

  /** World position of the device's origin, mm. */
  private final Vec3 originMm;

  /**
   * A turn about the probe's own axes that is applied before the mapped orientation. With it,
   * neither the clutch nor other axes turn the probe. Later turns are about the axes of the hand.
   */
  private final Quaternion offset = new Quaternion();

  private final Quaternion mapped = new Quaternion();
  private final Vec3 lastPositionMm = new Vec3();
  private final Quaternion lastOrientation = new Quaternion();
  private final Vec3 deviceNewton = new Vec3();
  private final Vec3 deviceNewtonMm = new Vec3();
  private double speed = 1;
  private int lastButtons;
  private boolean hasPosition;
  private boolean hasOrientation;

  /** The axes in use; haptic thread. */
  private Axes axes;

  private volatile Axes requestedAxes;
  private volatile boolean clutchRequested;
  private boolean clutched;
  private boolean wasClutched;

  /** Whether the offset has to be computed anew with the next orientation. */
  private boolean offsetDue;

  private boolean returning;
  private long releasedNanos;
  private double forceFactor = 1;

  /**
   * The assignment of the buttons.
   *
   * @param clutchButton bit of the button that holds the clutch; 0 for none
   * @param speedButton bit of the button that changes the speed; 0 for none
   * @param fineSpeed fine motion as a fraction of full motion, in (0, 1]
   */
  public record Controls(int clutchButton, int speedButton, double fineSpeed) {

    /**
     * Checks the speed.
     *
     * @throws IllegalArgumentException if the speed is not above 0 and at most 1
     */
    public Controls {
      if (!(fineSpeed > 0 && fineSpeed <= 1)) {
        throw new IllegalArgumentException("fineSpeed must be in (0, 1]: fineSpeed=" + fineSpeed);
      }
    }

    /** {@return the usual assignment: second button clutch, third button a quarter of the speed} */
    public static Controls standard() {
      return new Controls(2, 4, 0.25);
    }
  }

  /** A workspace and its rotation as a quaternion. Immutable. */
  private static final class Axes {
    final Workspace workspace;
    final Quaternion rotation;

    Axes(Workspace workspace) {
      this.workspace = workspace;
      rotation = quaternion(workspace.deviceToWorld());
    }
  }

  /**
   * Maps a device, and closes it when it is closed itself.
   *
   * @param device the device to map, with positions in its own frame
   * @param workspace from the device's frame to the world
   * @param controls which buttons hold the clutch and change the speed
   */
  public WorkspaceDevice(HapticDevice device, Workspace workspace, Controls controls) {
    super(device);
    axes = new Axes(workspace);
    requestedAxes = axes;
    this.controls = controls;
    originMm = new Vec3().set(workspace.deviceToWorld().origin());
    DeviceSpecification own = device.specification();
    specification =
        new DeviceSpecification(
            own.name(),
            own.serial(),
            own.maxForceNewton(),
            workspace.stiffnessNewtonPerMm(own, 1),
            own.workspaceRadiusMm() * workspace.largestScale(),
            own.reportIntervalNanos(),
            own.hasOrientation(),
            own.maxTorqueNewtonMm() * workspace.largestScale());
  }

  /**
   * Returns the device as the world sees it: stiffness per world mm, radius in world mm, and the
   * torque in the world that becomes the device's maximum.
   */
  @Override
  public DeviceSpecification specification() {
    return specification;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = device.read(raw);
    if (status == ReadStatus.FRESH) {
      state.set(raw);
      boolean turned = takeAxes();
      mapPosition(state, turned);
      updateForceFactor(state.timeNanos);
      mapOrientation(state, turned);
    }
    return status;
  }

  /**
   * Takes the axes that were requested last, once they map a position to finite numbers. Returns
   * whether the axes changed.
   */
  private boolean takeAxes() {
    Axes requested = requestedAxes;
    boolean changed =
        requested != axes
            && requested.workspace.toWorldStep(raw.positionMm, displacementMm).isFinite();
    axes = changed ? requested : axes;
    return changed;
  }

  private void mapPosition(DeviceState state, boolean turned) {
    axes.workspace.toWorldStep(raw.positionMm, displacementMm).mul(speed, displacementMm);
    if (turned && hasPosition) {
      lastPositionMm.sub(displacementMm, originMm);
    }
    if (displacementMm.isFinite()) {
      updateSpeed(state.buttons);
      updateClutch(state.buttons, state.timeNanos);
      lastButtons = state.buttons;
    }
    displacementMm.add(originMm, state.positionMm);
    if (!state.positionMm.isFinite()) {
      return;
    }
    if (clutched) {
      state.positionMm.set(lastPositionMm);
    } else {
      lastPositionMm.set(state.positionMm);
      hasPosition = true;
    }
  }

  /** Changes the speed if its button goes down, and keeps the position where it is. */
  private void updateSpeed(int buttons) {
    boolean goesDown = (buttons & ~lastButtons & controls.speedButton()) != 0;
    if (goesDown) {
      double next = speed == 1 ? controls.fineSpeed() : 1;
      double ratio = next / speed;
      originMm.set(
          originMm.x + displacementMm.x * (1 - ratio),
          originMm.y + displacementMm.y * (1 - ratio),
          originMm.z + displacementMm.z * (1 - ratio));
      displacementMm.mul(ratio, displacementMm);
      speed = next;
    }
  }

  /** Holds or releases the clutch. The release moves the origin so that the position stays. */
  private void updateClutch(int buttons, long nanos) {
    boolean requested = clutchRequested || (buttons & controls.clutchButton()) != 0;
    boolean held = requested && hasPosition;
    if (clutched && !held) {
      lastPositionMm.sub(displacementMm, originMm);
      releasedNanos = nanos;
      returning = true;
    }
    clutched = held;
  }

  private void updateForceFactor(long nanos) {
    if (clutched) {
      forceFactor = 0;
    } else if (returning) {
      forceFactor = Math.min(1, Math.max(0, (nanos - releasedNanos) / (double) RETURN_NANOS));
      returning = forceFactor < 1;
    }
  }

  /** Turns the device's orientation into the world's; keeps the last one while clutched. */
  private void mapOrientation(DeviceState state, boolean turned) {
    axes.rotation.multiply(raw.orientation, mapped);
    offsetDue |= turned || (wasClutched && !clutched);
    if (offsetDue && mapped.isNearUnit()) {
      offsetDue = false;
      if (hasOrientation) {
        mapped.conjugate(offset).multiply(lastOrientation, offset);
        offset.normalize(); // else the norms' errors would add up
      }
    }
    wasClutched = clutched;
    if (clutched) {
      state.orientation.set(lastOrientation);
    } else {
      mapped.multiply(offset, state.orientation);
      keepOrientation(state.orientation);
    }
  }

  private void keepOrientation(Quaternion orientation) {
    if (orientation.isNearUnit()) {
      lastOrientation.set(orientation);
      hasOrientation = true;
    }
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    axes.workspace.toDeviceForce(forceNewton, deviceNewton).mul(forceFactor, deviceNewton);
    axes.workspace.toDeviceTorque(torqueNewtonMm, deviceNewtonMm).mul(forceFactor, deviceNewtonMm);
    return device.write(deviceNewton, deviceNewtonMm);
  }

  /**
   * Gives the device other axes in the world, from the next sample on. The point keeps its position
   * and the tool its orientation; only later motion and forces follow the new axes. Any thread.
   *
   * @param deviceToWorld the axes; a rotation without mirroring, whose origin is not used
   */
  public void turnAxes(RigidTransform deviceToWorld) {
    requestedAxes = new Axes(new Workspace(deviceToWorld, requestedAxes.workspace.scale()));
  }

  /**
   * Holds the clutch as its button does, or releases it, from the next sample on. Any thread.
   *
   * @param requested whether the clutch is to be held
   */
  public void holdClutch(boolean requested) {
    clutchRequested = requested;
  }

  /**
   * Holds the clutch if {@link #holdClutch} does not hold it yet, else releases it. Any thread, one
   * at a time.
   */
  public void toggleClutch() {
    clutchRequested = !clutchRequested;
  }

  /** {@return whether {@link #holdClutch} holds the clutch} Any thread. */
  public boolean isClutchRequested() {
    return clutchRequested;
  }

  /** Whether the clutch is held. Haptic thread. */
  boolean isClutched() {
    return clutched;
  }

  /** Returns the quaternion of a rotation. */
  private static Quaternion quaternion(RigidTransform t) {
    double xx = t.axisX().x;
    double yy = t.axisY().y;
    double zz = t.axisZ().z;
    double x = Math.sqrt(Math.max(0, 1 + xx - yy - zz)) / 2;
    double y = Math.sqrt(Math.max(0, 1 - xx + yy - zz)) / 2;
    double z = Math.sqrt(Math.max(0, 1 - xx - yy + zz)) / 2;
    double w = Math.sqrt(Math.max(0, 1 + xx + yy + zz)) / 2;
    return withSigns(t, x, y, z, w);
  }

  /** Returns the components with their signs, of which the largest component is positive. */
  private static Quaternion withSigns(RigidTransform t, double x, double y, double z, double w) {
    double yz = t.axisZ().y + t.axisY().z;
    double zx = t.axisX().z + t.axisZ().x;
    double xy = t.axisY().x + t.axisX().y;
    double ofX = t.axisY().z - t.axisZ().y;
    double ofY = t.axisZ().x - t.axisX().z;
    double ofZ = t.axisX().y - t.axisY().x;
    double largest = Math.max(Math.max(x, y), Math.max(z, w));
    if (w == largest) {
      return new Quaternion(w, Math.copySign(x, ofX), Math.copySign(y, ofY), Math.copySign(z, ofZ));
    }
    if (x == largest) {
      return new Quaternion(Math.copySign(w, ofX), x, Math.copySign(y, xy), Math.copySign(z, zx));
    }
    if (y == largest) {
      return new Quaternion(Math.copySign(w, ofY), Math.copySign(x, xy), y, Math.copySign(z, yz));
    }
    return new Quaternion(Math.copySign(w, ofZ), Math.copySign(x, zx), Math.copySign(y, yz), z);
  }
}
