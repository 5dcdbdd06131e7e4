package org.palpate.imagej.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.Macro;
import ij.Prefs;
import ij.process.ImageProcessor;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.host.ContactSettings;
import org.palpate.host.MaterialOverride;
import org.palpate.host.SolverKind;
import org.palpate.imagej.stack.SegmentColour;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.Stacks;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.scene.window.TestDisplay;

/** The dialog as macros fill it in: it reads every field and shows nothing. */
class TouchOptionsWindowTest {
  private static final List<String> KEPT =
      List.of(
          "name",
          "colour",
          "labels",
          "lower",
          "upper",
          "solver",
          "stiffness",
          "friction",
          "materials",
          "device",
          "workspace",
          "scale",
          "seconds",
          "view");

  private final ImagePlus image = Stacks.of(8, 4, 4, 4, (i, j, k) -> 20 * i);

  @BeforeEach
  @AfterEach
  void forgetPreferences() {
    TestDisplay.require();
    KEPT.forEach(key -> Prefs.set("palpate." + key, null));
  }

  /** Fills the dialog in as a macro does, in a thread of the name that ImageJ gives its macros. */
  private TouchOptions ask(String macro, boolean live) throws Exception {
    AtomicReference<TouchOptions> chosen = new AtomicReference<>();
    AtomicReference<Exception> refused = new AtomicReference<>();
    Thread thread =
        new Thread(
            () -> {
              Macro.setOptions(macro);
              try {
                chosen.set(TouchOptions.ask("Touch Volume", StackVolume.shownIn(image), live));
              } catch (TouchRefusedException | RuntimeException e) {
                refused.set(e);
              }
            },
            "Run$_palpate");
    Macro.setOptions(thread, macro);
    thread.setDaemon(true);
    thread.start();
    thread.join(60_000);
    assertFalse(thread.isAlive(), "the dialog waits for a person: " + macro);
    if (refused.get() != null) {
      throw refused.get();
    }
    return chosen.get();
  }

  @Test
  void everyFieldIsRead() throws Exception {
    TouchOptions options =
        ask(
            "segment=jaw colour=sky lower=20 upper=40 solver=guarded stiffness=0.75 friction=0.4"
                + " materials=[jaw=damping:0.001] device=replay:t.csv workspace=[by scale]"
                + " scale=2.5 time=7 view",
            true);
    assertEquals("jaw", options.name());
    assertEquals(SegmentColour.SKY, options.colour());
    assertFalse(options.labels());
    assertEquals(20, options.lower());
    assertEquals(40, options.upper());
    assertFalse(options.followsThreshold());
    assertEquals(SolverKind.GUARDED, options.solver());
    assertEquals(0.75, options.stiffnessNewtonPerMm());
    assertEquals(0.4, options.friction());
    MaterialOverride damping = MaterialOverride.parse("damping:0.001").orElseThrow();
    assertEquals(Map.of("jaw", damping), options.materials().choices());
    assertEquals("replay:t.csv", options.device());
    assertEquals(new StackWorkspace(StackWorkspace.Kind.SCALE, 2.5), options.workspace());
    assertEquals(7, options.seconds());
    assertTrue(options.view());
    ContactSettings settings = options.contactSettings();
    assertEquals(OptionalDouble.of(0.75), settings.stiffnessNewtonPerMm());
    assertEquals(0.4, settings.friction());
    assertEquals(SolverKind.GUARDED, settings.solver());
    assertEquals(Map.of("jaw", damping), settings.materials());
  }

  @Test
  void aReplayHasNoDevice() throws Exception {
    TouchOptions options = ask("segment=jaw lower=20 upper=40 device=mouse time=9 view", false);
    assertEquals("simulated", options.device());
    assertEquals(0, options.seconds());
    assertFalse(options.view());
    assertEquals(OptionalDouble.empty(), options.contactSettings().stiffnessNewtonPerMm());
  }

  @Test
  void theLastChoicesAreRememberedExceptMaterials() throws Exception {
    ask("segment=jaw colour=red lower=20 upper=40 solver=dot materials=[a=friction:1]", true);
    TouchOptions next = ask("again", true);
    assertEquals("jaw", next.name());
    assertEquals(SegmentColour.RED, next.colour());
    assertEquals(SolverKind.DOT, next.solver());
    assertEquals(20, next.lower());
    assertEquals(Map.of(), next.materials().choices());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "lower=40 upper=20|The lower threshold 40.0 is above the upper threshold 20.0.",
        "stiffness=1e7|The stiffness must be from 1e-6 to 1e6 N/mm, or 0.",
        "stiffness=-1|Stiffness, friction and time must be 0 or more.",
        "friction=-1|Stiffness, friction and time must be 0 or more.",
        "time=-1|Stiffness, friction and time must be 0 or more.",
        "scale=0|The scale must be a positive number of mm of scan per mm of hand.",
        "solver=fast|There is no solver \"fast\": choose one of dot, paper, guarded, smooth, none.",
        "colour=pink|There is no colour \"pink\": choose one of bone, sky, orange, green, purple,"
            + " yellow, blue, red.",
        "workspace=[by hand]|There is no workspace \"by hand\": choose one of fit, fit each axis,"
            + " by scale."
      })
  void aWrongFieldIsRefusedInAFullSentence(String macro, String sentence) {
    try {
      ask(macro + " segment=a lower=1 upper=9", true);
      throw new AssertionError("accepted " + macro);
    } catch (Exception e) {
      assertEquals(sentence, e.getMessage());
    }
  }

  @Test
  void theShownThresholdIsFollowedUnlessTheFieldsDiffer() throws Exception {
    image.getProcessor().setThreshold(30, 50, ImageProcessor.NO_LUT_UPDATE);
    assertTrue(ask("segment=a", true).followsThreshold());
    assertEquals(30, ask("segment=a", true).lower());
    assertFalse(ask("segment=a lower=31", true).followsThreshold());
    assertFalse(ask("segment=a labels", true).followsThreshold());
  }

  @Test
  void aThresholdIsOneSegmentOfRawValues() throws Exception {
    image
        .getCalibration()
        .setFunction(ij.measure.Calibration.STRAIGHT_LINE, new double[] {100, -2}, "HU");
    TouchOptions options = ask("segment=a colour=blue lower=40 upper=80", true);
    SegmentRange range = options.ranges(StackVolume.shownIn(image)).get(0);
    assertEquals(new SegmentRange("a", 10, 30, SegmentColour.BLUE.rgb()), range);
  }

  @Test
  void eachLabelIsASegmentOfItsOwn() throws Exception {
    List<SegmentRange> ranges =
        ask("labels lower=9 upper=1", true).ranges(StackVolume.shownIn(image));
    assertEquals(
        List.of("label 20", "label 40", "label 60"),
        ranges.stream().map(SegmentRange::name).toList());
    assertEquals(40, ranges.get(1).lower());
    assertEquals(40, ranges.get(1).upper());
  }
}
