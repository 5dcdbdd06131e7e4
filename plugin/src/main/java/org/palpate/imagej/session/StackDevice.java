package org.palpate.imagej.session;

import java.io.IOException;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.jni.DeviceException;
import org.palpate.host.ContactScene;
import org.palpate.host.DeviceName;
import org.palpate.imagej.dialog.FilePaths;
import org.palpate.imagej.dialog.StackWorkspace;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * An opened device of the dialog: {@code simulated}, {@code mouse} in the 3-D window, {@code
 * replay:FILE.csv}, or a back end with its id, for example {@code hid:SERIAL}.
 *
 * @param device the device with positions in world mm
 * @param defaultNewtonPerMm stiffness if the user gives none, N per mm of scan
 */
record StackDevice(HapticDevice device, double defaultNewtonPerMm) {
  /**
   * Opens a device.
   *
   * @param choice the text of the dialog
   * @param scene the solids, which must be in reach
   * @param workspace maps the workspace of a real device to the stack
   * @param periodNanos time between two samples of a simulated hand or the mouse
   * @throws TouchRefusedException if there is no such device, or it cannot be opened
   */
  static StackDevice open(
      String choice, ContactScene scene, StackWorkspace workspace, long periodNanos)
      throws TouchRefusedException {
    HandTarget target = scene.handTarget();
    DeviceName name = checked(DeviceName.parse(choice));
    try {
      HapticDevice device =
          name.open(target, periodNanos, specification -> workspace.of(specification, target));
      return new StackDevice(device, name.defaultStiffnessNewtonPerMm(device, scene));
    } catch (IOException e) {
      throw new TouchRefusedException("The trajectory cannot be read: " + e.getMessage());
    } catch (DeviceException e) {
      throw new TouchRefusedException(e.getMessage());
    }
  }

  private static DeviceName checked(DeviceName name) throws TouchRefusedException {
    if (!name.isKnown()) {
      throw new TouchRefusedException(
          "There is no device \""
              + name.name()
              + "\": write simulated, mouse, replay:FILE.csv, or see Plugins > Palpate >"
              + " Devices...");
    }
    if (name.isReplay()) {
      return DeviceName.ofReplay(FilePaths.of("recorded trajectory", name.id()));
    }
    // In ImageJ the simulated hand has one seed, so an id after the colon has no effect.
    return name.isSimulated() ? DeviceName.parse(name.name()) : name;
  }
}
