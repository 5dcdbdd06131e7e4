package org.palpate.host;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Function;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReplayDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.device.Workspace;
import org.palpate.device.WorkspaceDevice;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.DeviceException;

/**
 * Names a device as users write it, {@code NAME} or {@code NAME:ID}, and opens it.
 *
 * <p>Any thread. Opening a real device blocks for up to some seconds.
 *
 * @param name the back end, for example {@code simulated} or {@code hid}
 * @param id the seed, file, serial number, name or host; empty if none is given
 */
public record DeviceName(String name, String id) {
  private static final String SIMULATED = "simulated";
  private static final String MOUSE = "mouse";
  private static final String REPLAY = "replay";
  private static final long DEFAULT_SEED = 1;

  /**
   * {@return a text split at its first colon} Every text is accepted; see {@link #isKnown}.
   *
   * @param text the text of a user
   */
  public static DeviceName parse(String text) {
    int colon = text.indexOf(':');
    return colon < 0
        ? new DeviceName(text, "")
        : new DeviceName(text.substring(0, colon), text.substring(colon + 1));
  }

  /**
   * {@return the name of a replay of a recorded trajectory}
   *
   * @param trajectory the recorded file
   */
  public static DeviceName ofReplay(Path trajectory) {
    return new DeviceName(REPLAY, trajectory.toString());
  }

  /** {@return whether there is a back end of this name} */
  public boolean isKnown() {
    return isSimulated() || isMouse() || isReplay() || DeviceCatalog.isNative(name);
  }

  /** {@return whether the device is a simulated hand} */
  public boolean isSimulated() {
    return name.equals(SIMULATED);
  }

  /** {@return whether the device is the mouse in the 3-D window} */
  public boolean isMouse() {
    return name.equals(MOUSE);
  }

  /** {@return whether the device replays a recorded trajectory} */
  public boolean isReplay() {
    return name.equals(REPLAY);
  }

  /** {@return whether a hand holds the device and feels its force} */
  public boolean isReal() {
    return !isSimulated() && !isMouse() && !isReplay();
  }

  /**
   * {@return the seed of a simulated hand}
   *
   * @throws NumberFormatException if the id is not a whole number
   */
  public long seed() {
    return id.isEmpty() ? DEFAULT_SEED : Long.parseLong(id);
  }

  /**
   * Opens the device. Its positions are in world mm.
   *
   * @param target the region that must be in reach
   * @param periodNanos time between two samples of a simulated hand or the mouse
   * @param fit maps the workspace of a real device to the world
   * @return the open device; the caller closes it
   * @throws DeviceException if a real device cannot be opened; the message gives the remedy
   * @throws IOException if the recorded trajectory cannot be read
   */
  public HapticDevice open(
      HandTarget target, long periodNanos, Function<DeviceSpecification, Workspace> fit)
      throws IOException, DeviceException {
    return switch (name) {
      case SIMULATED -> new SimulatedDevice(seed(), target, periodNanos);
      case MOUSE -> new MouseDevice(target, periodNanos);
      case REPLAY -> openReplay();
      default -> openReal(fit);
    };
  }

  /**
   * Opens the device for a rigid tool: as {@link #open} does, but a simulated hand turns too.
   *
   * @param target the region that must be in reach
   * @param periodNanos time between two samples of a simulated hand or the mouse
   * @param fit maps the workspace of a real device to the world
   * @return the open device; the caller closes it
   * @throws DeviceException if a real device cannot be opened; the message gives the remedy
   * @throws IOException if the recorded trajectory cannot be read
   */
  public HapticDevice openForTool(
      HandTarget target, long periodNanos, Function<DeviceSpecification, Workspace> fit)
      throws IOException, DeviceException {
    return isSimulated()
        ? SimulatedDevice.withOrientation(seed(), target, periodNanos)
        : open(target, periodNanos, fit);
  }

  private HapticDevice openReplay() throws IOException {
    return new ReplayDevice(toString(), TrajectoryFile.read(Path.of(id), false));
  }

  private HapticDevice openReal(Function<DeviceSpecification, Workspace> fit)
      throws DeviceException {
    HapticDevice device = DeviceCatalog.open(name, id);
    Workspace workspace = fit.apply(device.specification());
    return new WorkspaceDevice(device, workspace, WorkspaceDevice.Controls.standard());
  }

  /**
   * {@return the stiffness to use in a scene if the user gives none, N per mm of scan}
   *
   * @param opened the device that {@link #open} returned
   * @param scene the scene, whose size decides for a device that no hand holds
   */
  public double defaultStiffnessNewtonPerMm(HapticDevice opened, ContactScene scene) {
    return isReal()
        ? opened.specification().defaultStiffnessNewtonPerMm()
        : scene.defaultStiffnessNewtonPerMm();
  }

  /** Returns the text that {@link #parse} reads. */
  @Override
  public String toString() {
    return id.isEmpty() ? name : name + ":" + id;
  }
}
