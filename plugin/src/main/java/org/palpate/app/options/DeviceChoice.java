package org.palpate.app.options;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Function;
import org.palpate.app.process.PalpateException;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.Workspace;
import org.palpate.device.jni.DeviceException;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.DeviceName;
import org.palpate.io.scene.SceneDevice;
import org.palpate.io.volume.CoordinateSystem;

/**
 * The device that {@code --device NAME[:ID]} asks for. Immutable.
 *
 * @param device the checked name
 * @param fitEachAxis whether the workspace of a real device is stretched over the box of the
 *     segments along each axis separately
 * @param axesOfView whether the axes of a real device are those of the view
 * @param mapping scale and position of the workspace of a real device, as a scene gives them
 */
public record DeviceChoice(
    DeviceName device, boolean fitEachAxis, boolean axesOfView, Optional<SceneDevice> mapping) {
  private static final String FORMS =
      "write simulated[:SEED], replay:T.csv, hid[:SERIAL], openhaptics[:NAME],"
          + " forcedimension[:SERIAL], virtuose:HOST or mouse";
  private static final Set<String> NEED_ID = Set.of("replay", "virtuose");

  /**
   * Parses and checks the argument of {@code --device}.
   *
   * @throws PalpateException exit code 2, if there is no such device, or its id is missing or wrong
   */
  public static DeviceChoice parse(String argument) {
    DeviceName device = DeviceName.parse(argument);
    if (!device.isKnown()) {
      throw wrong("there is no such device", device);
    }
    if (device.id().isEmpty() && NEED_ID.contains(device.name())) {
      throw wrong("this device needs an id after a colon", device);
    }
    if (device.isSimulated()) {
      checkSeed(device);
    }
    return new DeviceChoice(device, false, false, Optional.empty());
  }

  private static void checkSeed(DeviceName device) {
    try {
      device.seed();
    } catch (NumberFormatException e) {
      throw wrong("the seed is not a whole number", device);
    }
  }

  private static PalpateException wrong(String what, DeviceName device) {
    return PalpateException.wrongUse(what, "--device " + device, FORMS);
  }

  /**
   * Returns a copy with another fit of the workspace of a real device.
   *
   * @param fit whether each axis is fitted separately
   * @param view whether the axes are those of the view
   * @throws PalpateException exit code 2, if one of them is wanted and the device is not a real one
   */
  public DeviceChoice withFit(boolean fit, boolean view) {
    if ((fit || view) && !device.isReal()) {
      throw PalpateException.wrongUse(
          "only the workspace of a real device can be fitted",
          (fit ? "--fit-each-axis" : "--axes view") + " --device " + device,
          "leave it out, or choose hid, openhaptics, forcedimension or virtuose");
    }
    return new DeviceChoice(device, fit, view, mapping);
  }

  /** Returns a copy with the mapping of a scene, which only a real device uses. */
  DeviceChoice mappedAs(Optional<SceneDevice> ofScene) {
    return new DeviceChoice(device, fitEachAxis, axesOfView, ofScene);
  }

  /** Returns the files that the device reads, which no output may replace. */
  public List<Path> files() {
    return device.isReplay() ? List.of(Path.of(device.id())) : List.of();
  }

  /** Whether the end of the device is the regular end of the session, as with a replay. */
  public boolean ends() {
    return device.isReplay();
  }

  /**
   * Opens the device. Its positions are in world mm.
   *
   * @param target the region that must be in reach
   * @param world orientation of the world's axes
   * @param periodNanos time between two samples of a simulated hand or the mouse
   * @param forTool whether a rigid tool is held, so that a simulated hand turns
   * @throws PalpateException exit code 1, if a real device cannot be opened
   * @throws IOException if the recorded trajectory cannot be read
   */
  public HapticDevice open(
      HandTarget target, CoordinateSystem world, long periodNanos, boolean forTool)
      throws IOException {
    Function<DeviceSpecification, Workspace> fit = reach -> workspace(reach, target, world);
    try {
      return forTool
          ? device.openForTool(target, periodNanos, fit)
          : device.open(target, periodNanos, fit);
    } catch (DeviceException e) {
      throw PalpateException.failed(e.getMessage(), e);
    }
  }

  /**
   * Returns the workspace of a real device: fitted to the target, except for what a scene gives.
   */
  Workspace workspace(DeviceSpecification reach, HandTarget target, CoordinateSystem world) {
    Workspace fitted =
        fitEachAxis
            ? Workspace.fitEachAxis(reach, axes(world), target.lowMm(), target.highMm())
            : Workspace.fit(reach, axes(world), target.lowMm(), target.highMm());
    RigidTransform t = fitted.deviceToWorld();
    Vec3 middle = mapping.flatMap(SceneDevice::offsetMm).orElse(t.origin());
    OptionalDouble scale = mapping.map(SceneDevice::scale).orElse(OptionalDouble.empty());
    return new Workspace(
        new RigidTransform(t.axisX(), t.axisY(), t.axisZ(), new Vec3().set(middle)),
        scale.isPresent() && !fitEachAxis
            ? new Vec3(scale.getAsDouble(), scale.getAsDouble(), scale.getAsDouble())
            : fitted.scale());
  }

  /**
   * Returns the device's axes in the world: the user faces the patient, so the hand's right is the
   * patient's left, up is towards the head, and towards the user is anterior.
   */
  private static RigidTransform axes(CoordinateSystem world) {
    boolean ras = world == CoordinateSystem.RAS;
    Vec3 right = new Vec3(ras ? -1 : 1, 0, 0);
    Vec3 up = new Vec3(0, 0, 1);
    Vec3 towardsUser = new Vec3(0, ras ? 1 : -1, 0);
    return new RigidTransform(right, up, towardsUser, new Vec3());
  }

  /** Returns the stiffness to use in a scene if the user gives none, N per mm of scan. */
  public double defaultStiffness(HapticDevice opened, ContactScene scene) {
    return device.defaultStiffnessNewtonPerMm(opened, scene);
  }

  /** Returns the argument of {@code --device}. */
  @Override
  public String toString() {
    return device.toString();
  }
}
