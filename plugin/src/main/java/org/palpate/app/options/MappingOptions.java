package org.palpate.app.options;

import java.util.Optional;
import org.palpate.app.process.PalpateException;
import org.palpate.io.scene.SceneDevice;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import picocli.CommandLine.Option;

/** The options that map the workspace of a real device into the world, and those of a scene. */
public final class MappingOptions {
  /** The axes of a real device. */
  enum DeviceAxes {
    PATIENT,
    VIEW
  }

  @Option(
      names = "--fit-each-axis",
      description = {
        "Stretches the workspace of a real device over the segments along each axis separately;"
            + " shapes then lose their proportions."
      })
  private boolean fitEachAxis;

  @Option(
      names = "--axes",
      paramLabel = "patient|view",
      description = {
        "What the hand's right, up and towards are with a real device: patient (the person faces"
            + " the patient) or view (those of the picture, also after the view was turned).",
        "Default: patient, or what the scene says."
      })
  private DeviceAxes axes;

  private Optional<SceneDevice> ofScene = Optional.empty();

  /**
   * Takes the mapping of a scene file. Options that are given replace it.
   *
   * @throws VolumeFormatException if the scene cannot be read
   */
  public void takeFrom(VolumeOptions volume) throws VolumeFormatException {
    if (volume.scene().isPresent()) {
      ofScene = SceneReader.read(volume.scene().get()).device();
    }
  }

  /** Whether an option asks for the axes of the view, which needs a window. */
  public boolean asksForView() {
    return axes == DeviceAxes.VIEW;
  }

  /** Whether the axes of a real device are to be those of the view, if there is one. */
  public boolean followsView() {
    return axes == null
        ? ofScene.flatMap(SceneDevice::axes).filter(SceneDevice.VIEW::equals).isPresent()
        : asksForView();
  }

  /**
   * Returns a device with this mapping. The mapping of a scene is for real devices; others ignore
   * it.
   *
   * @param world orientation of the world's axes
   * @throws PalpateException exit code 2, if an option is given and the device is not a real one,
   *     or there is no view that a hand could follow
   */
  public DeviceChoice applyTo(DeviceChoice choice, CoordinateSystem world) {
    boolean ofView = asksForView() || (choice.device().isReal() && followsView());
    if (ofView && world == CoordinateSystem.LAS) {
      throw PalpateException.wrongUse(
          "the file's axes are left-handed, so the picture has none for a hand",
          "--axes view",
          "leave it out");
    }
    return choice.withFit(fitEachAxis, ofView).mappedAs(ofScene);
  }
}
