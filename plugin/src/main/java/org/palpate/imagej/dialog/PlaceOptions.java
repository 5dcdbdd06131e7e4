package org.palpate.imagej.dialog;

import ij.Prefs;
import ij.gui.GenericDialog;
import java.util.List;
import org.palpate.force.ForceSettings;
import org.palpate.host.ContactSettings;
import org.palpate.host.SolverKind;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * The user's choices in the dialog of "Place Fragments...". Macros give them by the first words of
 * the labels; ImageJ's preferences keep them.
 *
 * @param fixed the label that stands still; 0 for the largest
 * @param friction friction coefficient
 * @param device the device as {@link org.palpate.host.DeviceName} parses it
 * @param workspace maps the workspace of a real device to the stack
 * @param seconds length of the session, s; 0 means until Escape or the image closes
 * @param view whether the 3-D window is wanted
 * @param resume whether to begin where an earlier session left the fragments
 */
public record PlaceOptions(
    int fixed,
    double friction,
    String device,
    StackWorkspace workspace,
    double seconds,
    boolean view,
    boolean resume) {
  private static final String PREFIX = "palpate.place.";

  /**
   * Asks the user, or takes the values that a macro gives.
   *
   * @return the choices; null if the user cancelled
   */
  public static PlaceOptions ask() throws TouchRefusedException {
    GenericDialog dialog = new GenericDialog("Place Fragments");
    dialog.addNumericField("Fixed label (0: the largest)", Prefs.get(PREFIX + "fixed", 0), 0);
    dialog.addNumericField(
        "Friction", Prefs.get(PREFIX + "friction", ForceSettings.DEFAULT_FRICTION), 2);
    TouchOptions.addDevice(dialog, PREFIX, "mouse");
    dialog.addCheckbox("Resume what a crash left", false);
    HelpText.addTo(dialog);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return null;
    }
    PlaceOptions chosen = read(dialog);
    chosen.check();
    chosen.keep();
    return chosen;
  }

  private static PlaceOptions read(GenericDialog dialog) throws TouchRefusedException {
    double fixed = dialog.getNextNumber();
    double friction = dialog.getNextNumber();
    String device = dialog.getNextString().strip();
    String workspace = dialog.getNextChoice();
    double scale = dialog.getNextNumber();
    double seconds = dialog.getNextNumber();
    boolean view = dialog.getNextBoolean();
    boolean resume = dialog.getNextBoolean();
    if (dialog.invalidNumber() || fixed != (int) fixed) {
      throw new TouchRefusedException(
          "A field does not contain a number, or the label is not a whole one.");
    }
    return new PlaceOptions(
        (int) fixed,
        friction,
        device,
        TouchOptions.workspace(workspace, scale),
        seconds,
        view,
        resume);
  }

  private void check() throws TouchRefusedException {
    if (!(friction >= 0) || !(seconds >= 0) || fixed < 0) {
      throw new TouchRefusedException("Label, friction and time must be 0 or more.");
    }
  }

  private void keep() {
    Prefs.set(PREFIX + "fixed", fixed);
    Prefs.set(PREFIX + "friction", friction);
    TouchOptions.keepDevice(PREFIX, device, workspace, seconds, view);
  }

  /** Returns the contact settings. */
  public ContactSettings contactSettings() {
    return ContactSettings.builder(SolverKind.DEFAULT).friction(friction).build();
  }

  /**
   * Returns the value of each fragment of a label stack.
   *
   * @throws TouchRefusedException if the image has no valid labels, or only one
   */
  public List<SegmentRange> ranges(StackVolume volume) throws TouchRefusedException {
    List<SegmentRange> ranges = TouchOptions.labelRanges(volume);
    if (ranges.size() < 2) {
      throw new TouchRefusedException(
          "Fragments are placed beside each other, but the stack has one label: give each fragment"
              + " a value of its own.");
    }
    return ranges;
  }
}
