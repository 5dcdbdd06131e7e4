package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.force.FeelSettings;
import org.palpate.force.FrictionForm;
import org.palpate.force.MassSettings;
import org.palpate.geometry.Vec3;
import org.palpate.host.BorderChoice;
import org.palpate.host.CollisionChoice;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.MaterialOverride;
import org.palpate.host.SolverKind;
import picocli.CommandLine;
import picocli.CommandLine.ParseResult;

class ContactOptionsTest {
  @TempDir private Path folder;

  private static ContactOptions options(String... arguments) {
    return Given.options(new ContactOptions(), arguments);
  }

  @Test
  void withoutOptionsTheSettingsAreTheStandardOnes() {
    assertEquals(ContactSettings.standard(), options().settings());
    assertFalse(options().protects());
    assertFalse(options().cuts());
    assertFalse(options().hasMaterials());
  }

  @Test
  void everyNumberReachesItsSetting() {
    ContactSettings settings =
        options(
                "--stiffness=0.75",
                "--friction=0.4",
                "--max-step=2.5",
                "--max-force=3.5",
                "--carve=12",
                "--protect=nerve:1.5",
                "--protect=vein:2:3",
                "--friction-form=cone")
            .settings();
    assertEquals(OptionalDouble.of(0.75), settings.stiffnessNewtonPerMm());
    assertEquals(0.4, settings.friction());
    assertEquals(OptionalDouble.of(2.5), settings.maxStepMm());
    assertEquals(OptionalDouble.of(3.5), settings.maxForceNewton());
    assertEquals(OptionalDouble.of(12), settings.carveMm3PerNewtonSecond());
    assertEquals(FrictionForm.CONE, settings.frictionForm());
    assertEquals(Map.of("nerve", 1.5, "vein", 2.0), settings.protectedMm());
  }

  @ParameterizedTest
  @CsvSource({"equation4, EQUATION_4", "shorter, SHORTER", "cone, CONE"})
  void eachFrictionModelHasAName(String name, FrictionForm form) {
    assertEquals(form, options("--friction-form", name).settings().frictionForm());
  }

  @ParameterizedTest
  @CsvSource({
    "--stiffness, the stiffness, 1e-6, 1e6, 0.000001, 'N/mm', 0.5",
    "--friction, the friction coefficient, 0, 100, 0, '', 0.2",
    "--max-step, the longest path, 1e-6, 1e6, 0.000001, 'mm', 1",
    "--max-force, the largest force, 1e-6, 1e6, 0.000001, 'N', 1",
    "--carve, the rate, 1e-6, 1e6, 0.000001, 'mm^3 per N s', 1"
  })
  void aNumberIsRefusedJustBeyondItsRange(
      String option,
      String quantity,
      double low,
      double high,
      String from,
      String unit,
      String eg) {
    options(option + "=" + low).settings();
    options(option + "=" + high).settings();
    String to = high == 100 ? "100" : "1,000,000";
    String text = Double.toString(Math.nextUp(high));
    Given.refuses(
        (quantity + " must be a number from " + from + " to " + to + " " + unit).strip()
            + (": " + option + " " + text + ": try " + option + " " + eg),
        () -> options(option + "=" + text).settings());
    String refused = Double.toString(Math.nextDown(low));
    assertTrue(refusal(option + "=" + refused).contains(option), refused);
    assertTrue(refusal(option + "=NaN").contains(option + " NaN"));
  }

  private static String refusal(String argument) {
    try {
      return "accepted: " + options(argument).settings();
    } catch (org.palpate.app.process.PalpateException e) {
      return e.getMessage();
    }
  }

  @Test
  void anUnknownNameIsRefusedWithTheNamesThatThereAre() {
    Given.refuses(
        "there is no such solver: --solver fast: choose smooth, guarded, paper, dot or none",
        () -> options("--solver=fast").settings());
    Given.refuses(
        "there is no such friction model: --friction-form wet: choose equation4, shorter or cone",
        () -> options("--friction-form=wet").settings());
    Given.refuses(
        "there is no such collision method: --collision near: write sampled:STEP (a step from 0.001"
            + " to 1,000 voxels), gridplanes or exact",
        () -> options("--solver=none", "--collision=near").settings());
    Given.refuses(
        "there is no such method for border voxels: --border twice: choose on-the-fly or"
            + " precalculated",
        () -> options("--solver=dot", "--border=twice").settings());
    Given.refuses(
        "there is no such source of a surface: --smooth-from mesh: choose grey or bits",
        () -> options("--smooth-from=mesh").followsGrey(Given.source("--phantom=sphere:16")));
  }

  @ParameterizedTest
  @EnumSource(SolverKind.class)
  void eachSolverHasANameAndItsOwnCollisionMethod(SolverKind kind) {
    ContactSettings settings = options("--solver=" + kind).settings();
    assertEquals(kind, settings.solver());
    assertEquals(kind.defaultCollision(), settings.collision());
  }

  @ParameterizedTest
  @ValueSource(strings = {"none", "dot", "paper"})
  void someSolversLetTheUserChooseTheCollisionMethod(String solver) {
    ContactOptions chosen = options("--solver=" + solver, "--collision=sampled:0.25");
    assertEquals(CollisionChoice.sampled(0.25), chosen.collision());
    assertEquals(
        CollisionChoice.GRIDPLANES,
        options("--solver=" + solver, "--collision=gridplanes").settings().collision());
  }

  @ParameterizedTest
  @ValueSource(strings = {"smooth", "guarded"})
  void theOthersTakeNothingButExactCollision(String solver) {
    assertEquals(
        CollisionChoice.EXACT, options("--solver=" + solver, "--collision=exact").collision());
    Given.refuses(
        "the solver "
            + solver
            + " always uses exact collision: --collision gridplanes: leave it out, or choose"
            + " --solver none, dot or paper",
        () -> options("--solver=" + solver, "--collision=gridplanes").collision());
  }

  @Test
  void borderVoxelsAreForTheSolversThatLookForThem() {
    assertEquals(
        BorderChoice.PRECALCULATED,
        options("--solver=paper", "--border=precalculated").settings().border());
    assertEquals(
        BorderChoice.ON_THE_FLY,
        options("--solver=dot", "--border=on-the-fly").settings().border());
    Given.refuses(
        "the solver none uses no border voxels: --border on-the-fly: leave it out, or choose"
            + " --solver dot or paper",
        () -> options("--solver=none", "--border=on-the-fly").settings());
  }

  @Test
  void eachMaterialKeepsWhatWasGivenForIt() {
    Map<String, MaterialOverride> materials =
        options("--material", "bone=stiffness:0.8,cut:0.5", "--material", "skin=damping:0.002")
            .settings()
            .materials();
    assertEquals(2, materials.size());
    assertEquals(Map.of("stiffness", 0.8, "cut", 0.5), materials.get("bone").values());
    assertEquals(Map.of("damping", 0.002), materials.get("skin").values());
  }

  @ParameterizedTest
  @ValueSource(strings = {"hard", "stiffness:", "stiffness:1,", "weight:1", "damping:-1"})
  void aMaterialThatCannotBeReadIsShownWithAnExample(String text) {
    Given.refuses(
        "the material cannot be read: --material bone="
            + text
            + ": write for example bone=stiffness:0.8,friction:0.3,damping:0, with a stiffness of 0"
            + " or from 0.000001 to 1,000,000 N/mm, friction from 0 to 100, sliding at most"
            + " friction, damping from 0 to 1,000,000 N s/mm, cut, puncture, cutting and shaft from"
            + " 0 to 1,000,000, the last two only with puncture",
        () -> options("--material=bone=" + text).settings());
  }

  @Test
  void aMaterialOrAMarginOfASegmentThatIsNotThereIsRefused() {
    Given.refuses(
        "there is no such segment: --material bone: choose sphere",
        () -> scene(options("--material=bone=stiffness:1"), "--phantom=sphere:16"));
    Given.refuses(
        "there is no such segment: --protect nerve: choose sphere",
        () -> scene(options("--protect=nerve:2"), "--phantom=sphere:16"));
    Given.refuses(
        "the margin is wider than 64 mm, 64 voxels: --protect sphere:64.5: choose a smaller one",
        () -> scene(options("--protect=sphere:64.5:0"), "--phantom=sphere:16"));
    Given.refuses(
        "margins are for bodies of one grid that are fixed where they rest: --protect: leave it"
            + " out, or make all bodies of the scene fixed, without poses, from one volume",
        () -> scene(options("--protect=fragment1"), "--phantom=fracture:64:2"));
  }

  @ParameterizedTest
  @CsvSource({"'1,1,12.5', 12.5", "'40,2,3', 20", "'0.75,9,9', 12"})
  void voxelsThatAreTooLongForSmoothAreNoted(String spacing, String ratio) throws IOException {
    VolumeSource source = raw(spacing);
    assertEquals(
        "palpate: voxels are "
            + ratio
            + " times as long as wide: "
            + folder.resolve("long.raw")
            + ": beyond 10 times the force of smooth may be off by tens of degrees; choose a series"
            + " with thinner slices"
            + System.lineSeparator(),
        notes(options(), source));
    assertEquals("", notes(options("--solver=guarded"), source));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1,1,1", "1,10,1", "0.5,0.5,5"})
  void voxelsUpToTenTimesAsLongAsWideAreNotNoted(String spacing) throws IOException {
    assertEquals("", notes(options(), raw(spacing)));
  }

  @Test
  void greyValuesAreKeptIfTheSolverFollowsThemOrTheCallerAsks() throws IOException {
    String[] grey = {"--phantom=sphere:16:grey", "--segment=s=>=500"};
    for (boolean keeps : new boolean[] {false, true}) {
      VolumeSource source = Given.source(grey);
      options("--smooth-from=bits").segments(source, new PrintWriter(new StringWriter()), keeps);
      assertEquals(keeps, source.hasGreyValues());
    }
    VolumeSource followed = Given.source(grey);
    options().segments(followed, new PrintWriter(new StringWriter()), false);
    assertTrue(followed.hasGreyValues());
  }

  private VolumeSource raw(String spacing) throws IOException {
    Path file = Files.write(folder.resolve("long.raw"), new byte[] {0, 1, 0, 1, 0, 1, 0, 1});
    return Given.source("--volume=" + file, "--raw=2x2x2:u8:" + spacing);
  }

  private static String notes(ContactOptions options, VolumeSource source) throws IOException {
    StringWriter notes = new StringWriter();
    options.segments(source, new PrintWriter(notes), false);
    return notes.toString();
  }

  private static ContactScene scene(ContactOptions options, String... volume) throws IOException {
    return scene(options, FeelSettings.NONE, volume);
  }

  private static ContactScene scene(ContactOptions options, FeelSettings feel, String... volume)
      throws IOException {
    VolumeSource source = Given.source(volume);
    return options.scene(source, Given.segments(source), feel);
  }

  @Test
  void aMarginCoversTheVoxelsAroundItsSegmentAndPushesBesideWhatIsFelt() throws IOException {
    Optional<MassSettings> mass = Optional.of(new MassSettings(0.1, new Vec3()));
    FeelSettings feel = new FeelSettings(List.of(site -> null), mass, Optional.empty());
    ContactOptions options = options("--protect=sphere:2:1");
    ContactScene guarded = scene(options, feel, "--phantom=sphere:16");
    assertEquals(2, guarded.settings().feel().effects().size(), "the push comes behind the others");
    assertEquals(mass, guarded.settings().feel().mass());
    assertTrue(options.protects());
    long margin = guarded.protectedVoxels().orElseThrow().solidCount();
    long solid = guarded.volume().segments().get(0).bits().solidCount();
    assertTrue(margin > solid, margin + " voxels within the margin of " + solid);
    ContactScene silent = scene(options("--protect=sphere:2:0"), feel, "--phantom=sphere:16");
    assertEquals(1, silent.settings().feel().effects().size(), "no push within 0 mm");
    assertEquals(margin, silent.protectedVoxels().orElseThrow().solidCount());
  }

  @Test
  void theSolverFollowsGreyValuesOfOneThresholdUnlessToldOtherwise() throws IOException {
    String[] one = {"--phantom=sphere:16:grey", "--segment=s=>=500"};
    String[] band = {"--phantom=sphere:16:grey", "--segment=s=500..700"};
    String[] two = {"--phantom=sphere:16:grey", "--segment=s=>=500", "--segment=t=>=900"};
    assertTrue(options().followsGrey(Given.source(one)));
    assertTrue(scene(options(), one).grey().isPresent());
    assertTrue(scene(options("--smooth-from=bits"), one).grey().isEmpty());
    assertFalse(options("--smooth-from=bits").followsGrey(Given.source(one)));
    assertTrue(scene(options("--solver=guarded"), one).grey().isEmpty());
    assertFalse(options("--solver=guarded").followsGrey(Given.source(one)));
    assertTrue(scene(options(), band).grey().isEmpty());
    assertTrue(scene(options(), two).grey().isEmpty());
    Given.refuses(
        "a surface of grey values needs exactly one segment, made by a threshold: --smooth-from"
            + " grey: choose one with --segment NAME=>=VALUE, or leave --smooth-from out",
        () -> scene(options("--smooth-from=grey"), two));
  }

  @Test
  void aSceneFileGivesWhatNoOptionGives() throws IOException {
    Path file = folder.resolve("s.json");
    Files.writeString(
        file,
        """
        { "bodies": [ { "name": "bone", "volume": "b.nrrd", "segment": ">=1",
                        "material": "stiffness:0.3" },
                      { "name": "skin", "volume": "b.nrrd", "segment": ">=2",
                        "material": "friction:0.1" } ],
          "protect": ["bone:2"], "carve": 7 }
        """);
    ContactSettings plain = taken(file).settings();
    assertEquals(Map.of("stiffness", 0.3), plain.materials().get("bone").values());
    assertEquals(Map.of("friction", 0.1), plain.materials().get("skin").values());
    assertEquals(OptionalDouble.of(7), plain.carveMm3PerNewtonSecond());
    assertEquals(Map.of("bone", 2.0), plain.protectedMm());
    ContactSettings given =
        taken(file, "--material=bone=stiffness:2", "--carve=9", "--protect=skin:1").settings();
    assertEquals(Map.of("stiffness", 2.0), given.materials().get("bone").values());
    assertEquals(Map.of("friction", 0.1), given.materials().get("skin").values());
    assertEquals(OptionalDouble.of(9), given.carveMm3PerNewtonSecond());
    assertEquals(Map.of("skin", 1.0), given.protectedMm());
  }

  /** Returns options after a scene file has completed them. */
  private static ContactOptions taken(Path scene, String... arguments) throws IOException {
    ContactOptions options = new ContactOptions();
    ParseResult given = new CommandLine(options).parseArgs(arguments);
    options.takeFrom(Given.options(new VolumeOptions(), "--scene", scene.toString()), given);
    return options;
  }

  @Test
  void withoutASceneNothingIsTaken() throws IOException {
    ContactOptions options = new ContactOptions();
    ParseResult given = new CommandLine(options).parseArgs();
    options.takeFrom(Given.options(new VolumeOptions(), "--phantom=sphere:16"), given);
    assertEquals(ContactSettings.standard(), options.settings());
  }
}
