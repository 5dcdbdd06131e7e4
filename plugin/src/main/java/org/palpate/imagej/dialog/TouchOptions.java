package org.palpate.imagej.dialog;

import ij.Macro;
import ij.Prefs;
import ij.gui.GenericDialog;
import ij.measure.Calibration;
import ij.process.ImageProcessor;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.force.ForceSettings;
import org.palpate.host.ContactSettings;
import org.palpate.host.MaterialOverride;
import org.palpate.host.SolverKind;
import org.palpate.imagej.stack.SegmentColour;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackSegments;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.io.volume.LabelTable;

/**
 * The user's choices in the dialog of "Touch Volume...". Macros give them by the first words of the
 * labels; ImageJ's preferences keep them.
 *
 * @param name name of the segment if there is one; labels are named after their values
 * @param colour colour of the one segment; labels have the colours of the image or of the table
 *     beside its file
 * @param labels whether each value of the image is a segment; otherwise the values from lower to
 *     upper are one segment
 * @param lower the smallest value of the segment, calibrated as ImageJ shows it
 * @param upper the largest value of the segment
 * @param followsThreshold whether these are the thresholds that the image shows
 * @param solver moves the interaction point
 * @param stiffnessNewtonPerMm force per distance, N/mm; 0 means the device's default
 * @param friction friction coefficient
 * @param materials materials of single segments
 * @param device the device as {@link org.palpate.host.DeviceName} parses it
 * @param workspace maps the workspace of a real device to the stack
 * @param seconds length of the session, s; 0 means until Escape or the image closes
 * @param view whether the 3-D window is wanted
 */
public record TouchOptions(
    String name,
    SegmentColour colour,
    boolean labels,
    double lower,
    double upper,
    boolean followsThreshold,
    SolverKind solver,
    double stiffnessNewtonPerMm,
    double friction,
    StackMaterials materials,
    String device,
    StackWorkspace workspace,
    double seconds,
    boolean view) {
  private static final String PREFIX = "palpate.";
  private static final String SIMULATED = "simulated";
  private static final int THRESHOLD_COLUMNS = 10;

  /**
   * Asks the user, or takes the values that a macro gives.
   *
   * @param live whether a device is used; a replay needs no device options
   * @return the choices; null if the user cancelled
   */
  public static TouchOptions ask(String title, StackVolume volume, boolean live)
      throws TouchRefusedException {
    ImageProcessor shown = volume.image().getProcessor();
    boolean threshold = shown.getMinThreshold() != ImageProcessor.NO_THRESHOLD;
    Calibration values = volume.image().getCalibration();
    StackProposal proposal = StackProposal.of(volume, Macro.getOptions() != null);
    double lower = threshold ? values.getCValue(shown.getMinThreshold()) : proposal.lower();
    double upper = threshold ? values.getCValue(shown.getMaxThreshold()) : proposal.upper();
    GenericDialog dialog = new GenericDialog(title);
    if (!threshold && !proposal.reason().isEmpty()) {
      dialog.addMessage(proposal.reason());
    }
    addSegment(dialog, lower, upper);
    addContact(dialog);
    if (live) {
      addDevice(dialog, PREFIX, SIMULATED);
    }
    HelpText.addTo(dialog);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return null;
    }
    TouchOptions chosen = read(dialog, threshold ? lower : Double.NaN, upper, live);
    chosen.check();
    chosen.keep(live);
    return chosen;
  }

  private static void addSegment(GenericDialog dialog, double lower, double upper) {
    dialog.addStringField("Segment name", Prefs.get(PREFIX + "name", "segment"), 16);
    dialog.addChoice(
        "Colour",
        SegmentColour.words(),
        Prefs.get(PREFIX + "colour", SegmentColour.BONE.toString()));
    dialog.addCheckbox("Labels: a segment a value", Prefs.get(PREFIX + "labels", false));
    dialog.addNumericField("Lower threshold", lower, 2, THRESHOLD_COLUMNS, "");
    dialog.addNumericField("Upper threshold", upper, 2, THRESHOLD_COLUMNS, "");
  }

  private static void addContact(GenericDialog dialog) {
    dialog.addChoice(
        "Solver", solvers(), Prefs.get(PREFIX + "solver", SolverKind.DEFAULT.toString()));
    dialog.addNumericField(
        "Stiffness (0: device default)", Prefs.get(PREFIX + "stiffness", 0), 3, 8, "N/mm");
    dialog.addNumericField(
        "Friction", Prefs.get(PREFIX + "friction", ForceSettings.DEFAULT_FRICTION), 2);
    // In a macro without materials there are none, whatever a dialog chose before.
    String materials = Macro.getOptions() == null ? Prefs.get(PREFIX + "materials", "") : "";
    dialog.addStringField("Materials (bone=friction:0.3; skin=young:20e3; ...)", materials, 24);
  }

  /**
   * Adds the fields of the device and of the session.
   *
   * @param prefix of the preferences that keep them
   * @param usual the device before one was chosen
   */
  static void addDevice(GenericDialog dialog, String prefix, String usual) {
    dialog.addStringField("Device", Prefs.get(prefix + "device", usual), 24);
    dialog.addChoice(
        "Workspace of a real device",
        StackWorkspace.Kind.words(),
        Prefs.get(prefix + "workspace", StackWorkspace.Kind.FIT.toString()));
    dialog.addNumericField(
        "Scale (where by scale)",
        Prefs.get(prefix + "scale", 1),
        3,
        8,
        "mm of scan per mm of hand");
    dialog.addNumericField("Time (0: until Escape)", Prefs.get(prefix + "seconds", 0), 1, 8, "s");
    dialog.addCheckbox("View in 3-D", Prefs.get(prefix + "view", true));
  }

  /** Keeps the fields that {@link #addDevice} added. */
  static void keepDevice(
      String prefix, String device, StackWorkspace workspace, double seconds, boolean view) {
    Prefs.set(prefix + "device", device);
    Prefs.set(prefix + "workspace", workspace.kind().toString());
    Prefs.set(prefix + "scale", workspace.scale());
    Prefs.set(prefix + "seconds", seconds);
    Prefs.set(prefix + "view", view);
  }

  /**
   * Reads every field in its order, so that the recorder writes each.
   *
   * @param shownLower the lower threshold that the image shows; NaN if it shows none
   */
  private static TouchOptions read(
      GenericDialog dialog, double shownLower, double shownUpper, boolean live)
      throws TouchRefusedException {
    String name = dialog.getNextString().strip();
    String colour = dialog.getNextChoice();
    boolean labels = dialog.getNextBoolean();
    double lower = dialog.getNextNumber();
    double upper = dialog.getNextNumber();
    String solver = dialog.getNextChoice();
    double stiffness = dialog.getNextNumber();
    double friction = dialog.getNextNumber();
    String materials = dialog.getNextString();
    String device = live ? dialog.getNextString().strip() : SIMULATED;
    String workspace = live ? dialog.getNextChoice() : StackWorkspace.Kind.FIT.toString();
    double scale = live ? dialog.getNextNumber() : 1;
    double seconds = live ? dialog.getNextNumber() : 0;
    boolean view = live && dialog.getNextBoolean();
    if (dialog.invalidNumber()) {
      throw new TouchRefusedException(
          "A field does not contain a number: " + dialog.getErrorMessage());
    }
    boolean asShown = isShown(lower, shownLower) && isShown(upper, shownUpper);
    return new TouchOptions(
        name.isEmpty() ? "segment" : name,
        known("colour", colour, SegmentColour.parse(colour), SegmentColour.words()),
        labels,
        lower,
        upper,
        asShown && !labels,
        known("solver", solver, SolverKind.parse(solver), solvers()),
        stiffness,
        friction,
        StackMaterials.parse(materials),
        device,
        workspace(workspace, scale),
        seconds,
        view);
  }

  /** Returns the workspace that the fields choose. */
  static StackWorkspace workspace(String words, double scale) throws TouchRefusedException {
    if (!(scale > 0) || Double.isInfinite(scale)) {
      throw new TouchRefusedException(
          "The scale must be a positive number of mm of scan per mm of hand.");
    }
    StackWorkspace.Kind kind =
        known("workspace", words, StackWorkspace.Kind.parse(words), StackWorkspace.Kind.words());
    return new StackWorkspace(kind, scale);
  }

  /** Returns a parsed word, which a macro may have misspelt. */
  private static <T> T known(String what, String word, Optional<T> found, String[] all)
      throws TouchRefusedException {
    return found.orElseThrow(
        () ->
            new TouchRefusedException(
                "There is no "
                    + what
                    + " \""
                    + word
                    + "\": choose one of "
                    + String.join(", ", all)
                    + "."));
  }

  /** Whether a field still has the value that it showed with two digits. */
  private static boolean isShown(double value, double shown) {
    return Math.abs(value - shown) <= 0.005;
  }

  private static String[] solvers() {
    return List.of(SolverKind.values()).stream().map(SolverKind::toString).toArray(String[]::new);
  }

  private void check() throws TouchRefusedException {
    if (!materials.elastic().isEmpty() && !solver.keepsGuarantee()) {
      throw new TouchRefusedException(
          "Elastic segments (young:...) need the solver smooth or guarded.");
    }
    if (!labels && !(lower <= upper)) {
      throw new TouchRefusedException(
          "The lower threshold " + lower + " is above the upper threshold " + upper + ".");
    }
    if (stiffnessNewtonPerMm > 0 && !MaterialOverride.isFeasibleStiffness(stiffnessNewtonPerMm)) {
      throw new TouchRefusedException("The stiffness must be from 1e-6 to 1e6 N/mm, or 0.");
    }
    if (!(stiffnessNewtonPerMm >= 0) || !(friction >= 0) || !(seconds >= 0)) {
      throw new TouchRefusedException("Stiffness, friction and time must be 0 or more.");
    }
  }

  private void keep(boolean live) {
    Prefs.set(PREFIX + "name", name);
    Prefs.set(PREFIX + "colour", colour.toString());
    Prefs.set(PREFIX + "labels", labels);
    Prefs.set(PREFIX + "lower", lower);
    Prefs.set(PREFIX + "upper", upper);
    Prefs.set(PREFIX + "solver", solver.toString());
    Prefs.set(PREFIX + "stiffness", stiffnessNewtonPerMm);
    Prefs.set(PREFIX + "friction", friction);
    Prefs.set(PREFIX + "materials", materials.text());
    if (live) {
      keepDevice(PREFIX, device, workspace, seconds, view);
    }
  }

  /** Returns the contact settings. */
  public ContactSettings contactSettings() {
    OptionalDouble stiffness =
        stiffnessNewtonPerMm > 0 ? OptionalDouble.of(stiffnessNewtonPerMm) : OptionalDouble.empty();
    return ContactSettings.builder(solver)
        .stiffness(stiffness)
        .friction(friction)
        .materials(materials.choices())
        .build();
  }

  /**
   * Returns a segment for each value of a label stack.
   *
   * @throws TouchRefusedException if the image has no valid labels
   */
  static List<SegmentRange> labelRanges(StackVolume volume) throws TouchRefusedException {
    LabelTable table = volume.labelTable();
    return StackSegments.labels(volume).stream()
        .map(value -> SegmentRange.label(value, volume.image(), table))
        .toList();
  }

  /**
   * Returns the range of raw values of each segment of a stack.
   *
   * @throws TouchRefusedException if the image has no valid labels
   */
  public List<SegmentRange> ranges(StackVolume volume) throws TouchRefusedException {
    if (labels) {
      return labelRanges(volume);
    }
    Calibration values = volume.image().getCalibration();
    double a = values.getRawValue(lower);
    double b = values.getRawValue(upper);
    return List.of(SegmentRange.threshold(name, Math.min(a, b), Math.max(a, b), colour));
  }
}
