package org.palpate.imagej;

import ij.Prefs;
import ij.gui.GenericDialog;
import ij.process.ImageProcessor;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.palpate.force.ForceSettings;
import org.palpate.host.ContactSettings;
import org.palpate.host.SolverKind;

/**
 * What the user chose in the dialog of "Touch Volume...", which a macro gives by the first words of
 * its labels; kept in ImageJ's preferences.
 *
 * @param labels whether the image is taken as labels, a segment a label; else the values from lower
 *     to upper are one segment
 * @param lower the least value of the segment
 * @param upper the largest
 * @param solver what moves the interaction point
 * @param stiffnessNewtonPerMm force over distance; the device's own default where 0
 * @param friction coefficient
 * @param device as {@link StackDevice} reads it
 * @param seconds how long; until Escape or the image closes where 0
 */
record TouchOptions(
    boolean labels,
    double lower,
    double upper,
    SolverKind solver,
    double stiffnessNewtonPerMm,
    double friction,
    String device,
    double seconds) {
  private static final String HELP = "https://github.com/palpate/palpate#imagej-and-fiji";
  private static final String PREFIX = "palpate.";

  /** Asks the user, or takes what a macro says; null where it was cancelled. */
  static TouchOptions ask(StackVolume volume) throws StackRefused {
    ImageProcessor shown = volume.image().getProcessor();
    boolean hasThreshold = shown.isThreshold();
    GenericDialog dialog = new GenericDialog("Touch Volume");
    dialog.addCheckbox("Labels: a segment a value", Prefs.get(PREFIX + "labels", false));
    dialog.addNumericField(
        "Lower threshold",
        hasThreshold ? shown.getMinThreshold() : Prefs.get(PREFIX + "lower", 1),
        2);
    dialog.addNumericField(
        "Upper threshold",
        hasThreshold ? shown.getMaxThreshold() : Prefs.get(PREFIX + "upper", 65535),
        2);
    dialog.addChoice(
        "Solver", solvers(), Prefs.get(PREFIX + "solver", SolverKind.GUARDED.toString()));
    dialog.addNumericField(
        "Stiffness (0: device default)", Prefs.get(PREFIX + "stiffness", 0), 3, 8, "N/mm");
    dialog.addNumericField(
        "Friction", Prefs.get(PREFIX + "friction", ForceSettings.DEFAULT_FRICTION), 2);
    dialog.addStringField("Device", Prefs.get(PREFIX + "device", "simulated"), 24);
    dialog.addNumericField("Time (0: until Escape)", Prefs.get(PREFIX + "seconds", 0), 1, 8, "s");
    dialog.addHelp(HELP);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return null;
    }
    TouchOptions chosen = read(dialog);
    chosen.check();
    chosen.keep();
    return chosen;
  }

  /** Reads every field in its order, so that the recorder writes each. */
  private static TouchOptions read(GenericDialog dialog) throws StackRefused {
    boolean labels = dialog.getNextBoolean();
    double lower = dialog.getNextNumber();
    double upper = dialog.getNextNumber();
    String solver = dialog.getNextChoice();
    double stiffness = dialog.getNextNumber();
    double friction = dialog.getNextNumber();
    String device = dialog.getNextString();
    double seconds = dialog.getNextNumber();
    if (dialog.invalidNumber()) {
      throw new StackRefused("A field does not hold a number: " + dialog.getErrorMessage());
    }
    SolverKind kind = SolverKind.valueOf(solver.toUpperCase(Locale.ROOT));
    return new TouchOptions(
        labels, lower, upper, kind, stiffness, friction, device.strip(), seconds);
  }

  private static String[] solvers() {
    return List.of(SolverKind.values()).stream().map(SolverKind::toString).toArray(String[]::new);
  }

  private void check() throws StackRefused {
    if (!labels && !(lower <= upper)) {
      throw new StackRefused(
          "The lower threshold " + lower + " lies above the upper one, " + upper + ".");
    }
    if (!(stiffnessNewtonPerMm >= 0) || !(friction >= 0) || !(seconds >= 0)) {
      throw new StackRefused("Stiffness, friction and time must be 0 or more.");
    }
  }

  private void keep() {
    Prefs.set(PREFIX + "labels", labels);
    Prefs.set(PREFIX + "lower", lower);
    Prefs.set(PREFIX + "upper", upper);
    Prefs.set(PREFIX + "solver", solver.toString());
    Prefs.set(PREFIX + "stiffness", stiffnessNewtonPerMm);
    Prefs.set(PREFIX + "friction", friction);
    Prefs.set(PREFIX + "device", device);
    Prefs.set(PREFIX + "seconds", seconds);
  }

  /** As the host wants them. */
  ContactSettings contactSettings() {
    OptionalDouble stiffness =
        stiffnessNewtonPerMm > 0 ? OptionalDouble.of(stiffnessNewtonPerMm) : OptionalDouble.empty();
    return new ContactSettings(
        solver,
        solver.defaultCollision(),
        stiffness,
        friction,
        OptionalDouble.empty(),
        OptionalDouble.empty());
  }

  /** What makes the segments of a stack. */
  List<VoxelRule> rules(StackVolume volume) throws StackRefused {
    return labels
        ? StackSegments.labels(volume).stream().map(VoxelRule::label).toList()
        : List.of(VoxelRule.threshold("segment", lower, upper));
  }
}
