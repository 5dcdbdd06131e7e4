package org.palpate.imagej.session;

import java.io.IOException;
import java.nio.file.Path;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReplayDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.device.Trajectory;
import org.palpate.device.WorkspaceDevice;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.DeviceException;
import org.palpate.force.ForceSettings;
import org.palpate.host.MouseDevice;
import org.palpate.imagej.dialog.FilePaths;
import org.palpate.imagej.dialog.StackWorkspace;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.io.table.TrajectoryCsvReader;

/**
 * A device as the dialog names it: {@code simulated}, {@code mouse} in the 3-D window, {@code
 * replay:FILE.csv}, or a back end with what tells its devices apart, as in {@code hid:SERIAL}.
 *
 * @param device positions in world mm
 * @param defaultNewtonPerMm stiffness where the user gave none
 */
public record StackDevice(HapticDevice device, double defaultNewtonPerMm) {
  private static final long SEED = 1;

  /** Half of what a real device renders stably. */
  private static final double STIFFNESS_FRACTION = 0.5;

  /**
   * Opens a device.
   *
   * @param target what is to be in reach
   * @param workspace how the reach of a real one is laid over it
   * @throws TouchRefusedException where there is no such device, or its recording cannot be read
   */
  static StackDevice open(
      String choice, HandTarget target, StackWorkspace workspace, long periodNanos)
      throws TouchRefusedException {
    int colon = choice.indexOf(':');
    String name = colon < 0 ? choice : choice.substring(0, colon);
    String id = colon < 0 ? "" : choice.substring(colon + 1);
    if (name.equals("simulated")) {
      HapticDevice hand = new SimulatedDevice(SEED, target, periodNanos);
      return new StackDevice(hand, ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM);
    }
    if (name.equals("mouse")) {
      HapticDevice hand = new MouseDevice(target, periodNanos);
      return new StackDevice(hand, ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM);
    }
    if (name.equals("replay")) {
      return new StackDevice(replay(id), ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM);
    }
    return openReal(name, id, target, workspace);
  }

  private static HapticDevice replay(String file) throws TouchRefusedException {
    Path path = FilePaths.of("recorded trajectory", file);
    Trajectory trajectory = new Trajectory();
    try {
      TrajectoryCsvReader.read(path, false, trajectory::add);
    } catch (IOException e) {
      throw new TouchRefusedException("The trajectory cannot be read: " + e.getMessage());
    }
    return new ReplayDevice("replay", trajectory);
  }

  private static StackDevice openReal(
      String name, String id, HandTarget target, StackWorkspace workspace)
      throws TouchRefusedException {
    if (!DeviceCatalog.isNative(name)) {
      throw new TouchRefusedException(
          "There is no device \""
              + name
              + "\": write simulated, mouse, replay:FILE.csv, or see Plugins > Palpate > Devices...");
    }
    try {
      HapticDevice opened = DeviceCatalog.open(name, id);
      HapticDevice mapped =
          new WorkspaceDevice(
              opened,
              workspace.of(opened.specification(), target),
              WorkspaceDevice.Controls.standard());
      return new StackDevice(
          mapped, STIFFNESS_FRACTION * mapped.specification().maxStiffnessNewtonPerMm());
    } catch (DeviceException e) {
      throw new TouchRefusedException(e.getMessage());
    }
  }
}
