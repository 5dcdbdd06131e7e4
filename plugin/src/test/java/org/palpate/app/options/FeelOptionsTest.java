package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.force.EffectPlan;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.force.MassSettings;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.table.CsvFormatException;

class FeelOptionsTest {
  private static final EffectSite SITE =
      new EffectSite(RigidTransform.identity(), 0.5, 0, 100, List.of(new Vec3()));
  private static final ContactOptions CONTACT = Given.options(new ContactOptions());

  @TempDir private Path folder;

  private static FeelOptions options(String... arguments) {
    return Given.options(new FeelOptions(), arguments);
  }

  private static List<EffectPlan> plans(String... arguments) throws IOException {
    VolumeSource source = Given.source("--phantom=sphere:16");
    return options(arguments).settings(source, Given.segments(source), Optional.empty()).effects();
  }

  /** Returns the pull of a guide on a hand at a position. */
  private static Vec3 pull(EffectPlan plan, double x, double y, double z) {
    HandState hand = new HandState();
    hand.device.translation.set(x, y, z);
    hand.tool.translation.set(x, y, z);
    HapticEffect guide = plan.make(SITE);
    guide.reset();
    Vec3 force = new Vec3();
    guide.add(hand, force, new Vec3());
    return force;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "axis:1,2,3|axis:X,Y,Z,DX,DY,DZ with 6",
        "axis:1,2,3,0,0,x|axis:X,Y,Z,DX,DY,DZ with 6",
        "axis:1,2,3,0,0,1,1|axis:X,Y,Z,DX,DY,DZ with 6",
        "plane:|plane:X,Y,Z,NX,NY,NZ with 6",
        "plane:1000001,0,0,0,0,1|plane:X,Y,Z,NX,NY,NZ with 6",
        "hinge:-1000001,0,0,0,0,1|hinge:X,Y,Z,DX,DY,DZ with 6",
        "hinge:1,2,3,0,0,NaN|hinge:X,Y,Z,DX,DY,DZ with 6",
        "align:0,1|align:DX,DY,DZ with 3",
        "sphere:1,2,3|sphere:X,Y,Z,R with 4",
        "sphere:1,2,3,inf|sphere:X,Y,Z,R with 4"
      })
  void aGuideThatCannotBeReadIsRefusedWithItsForm(String guide, String form) {
    Given.refuses(
        "the guide cannot be read: --guide "
            + guide
            + ": write "
            + form
            + " numbers from -1,000,000 to 1,000,000",
        () -> options("--guide=" + guide).check(true, CONTACT));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "axis:1,2,3,0,0,0|axis:X,Y,Z,DX,DY,DZ",
        "plane:1,2,3,0,0,0|plane:X,Y,Z,NX,NY,NZ",
        "hinge:1,2,3,0,0,0|hinge:X,Y,Z,DX,DY,DZ",
        "align:0,0,0|align:DX,DY,DZ"
      })
  void aDirectionHasALength(String guide, String form) {
    Given.refuses(
        "the direction is zero: --guide " + guide + ": write " + form + " with a direction",
        () -> options("--guide=" + guide).check(true, CONTACT));
  }

  @Test
  void eachOtherMistakeHasItsRemedy() {
    refuses(
        "sphere:1,2,3,0",
        "the radius must be positive: --guide sphere:1,2,3,0: write sphere:X,Y,Z,R");
    refuses(
        "rail:1,2,3",
        "there is no such guide: --guide rail:1,2,3: choose axis, plane, sphere, hinge, path, away,"
            + " align or fit");
    refuses("path:", "the path has no file: --guide path:: write path:FILE.csv");
    refuses("path: ", "the path has no file: --guide path: : write path:FILE.csv");
    refuses("path:a\0b", "the path is no file name: --guide path:a\0b: write path:FILE.csv");
    refuses(
        "align:0,0,1",
        "a point has no direction: --guide align:0,0,1: choose a rigid tool with --tool");
    options("--guide=align:0,0,1").check(true, CONTACT);
  }

  private static void refuses(String guide, String line) {
    Given.refuses(line, () -> options("--guide=" + guide).check(false, CONTACT));
  }

  @ParameterizedTest
  @ValueSource(strings = {"away:", "away:nerve", "away:,3", "away:nerve,0", "away:nerve,1000.5"})
  void aMarginLiesAboveZeroAndUpToAMetre(String guide) {
    refuses(
        guide,
        "the margin cannot be read: --guide "
            + guide
            + ": write away:NAME,MM with a margin above 0 and up to 1,000 mm, as in away:nerve,3");
  }

  @Test
  void theNumbersOfGuidesAreCheckedEvenWithoutAGuide() {
    for (String option : List.of("--guide-stiffness", "--guide-force", "--guide-range")) {
      options(option + "=0.000001").check(false, CONTACT);
      options(option + "=1000000").check(false, CONTACT);
      assertThrows(RuntimeException.class, () -> options(option + "=0").check(false, CONTACT));
    }
    Given.refuses(
        "the stiffness of guides must be a number from 0.000001 to 1,000,000 N/mm:"
            + " --guide-stiffness 0: try --guide-stiffness 0.2",
        () -> options("--guide-stiffness=0").check(false, CONTACT));
    Given.refuses(
        "the largest pull must be a number from 0.000001 to 1,000,000 N: --guide-force NaN: try"
            + " --guide-force 2",
        () -> options("--guide-force=NaN").check(false, CONTACT));
    Given.refuses(
        "the range of guides must be a number from 0.000001 to 1,000,000 mm: --guide-range -1: try"
            + " --guide-range 1",
        () -> options("--guide-range=-1").check(false, CONTACT));
  }

  @Test
  void aGuidePullsToWhereItsNumbersSay() throws IOException {
    List<EffectPlan> plans =
        plans(
            "--guide=axis:1,2,3,0,0,8",
            "--guide=plane:0,0,2,0,0,-1",
            "--guide=sphere:1,0,0,5",
            "--guide-stiffness=0.25",
            "--guide-force=50");
    assertEquals("(-0.75, 1.0, 0.0)", pull(plans.get(0), 4, -2, 77).toString());
    assertEquals("(0.0, 0.0, -1.0)", pull(plans.get(1), 40, -9, 6).toString());
    assertEquals("(-0.5, 0.0, 0.0)", pull(plans.get(2), 8, 0, 0).toString());
  }

  @Test
  void theStrengthIsThatOfTheOptionsOrOfHalfTheContact() throws IOException {
    String axis = "--guide=axis:0,0,0,0,0,1";
    assertEquals(-0.25, pull(plans(axis).get(0), 1, 0, 0).x);
    assertEquals(-2, pull(plans(axis).get(0), 99, 0, 0).x, "the default largest pull");
    assertEquals(-3, pull(plans(axis, "--guide-force=3").get(0), 99, 0, 0).x);
    assertEquals(-0.7, pull(plans(axis, "--guide-stiffness=0.7").get(0), 1, 0, 0).x);
    assertEquals(0, pull(plans(axis, "--guide-range=10").get(0), 10.5, 0, 0).length());
    assertTrue(pull(plans(axis, "--guide-range=10").get(0), 9.5, 0, 0).x < 0);
  }

  @Test
  void aPathLeadsAlongThePositionsOfItsFile() throws IOException {
    Path file = Files.writeString(folder.resolve("p.csv"), "z,note,y,x\n0,a,0,0\n0,b,0,9\n");
    List<EffectPlan> plans = plans("--guide=path:" + file, "--guide-stiffness=0.5");
    assertEquals("(0.0, -1.0, 0.0)", pull(plans.get(0), 4, 2, 0).toString());
    assertEquals(List.of(file), options("--guide=path:" + file, "--guide=align:0,0,1").files());
  }

  @Test
  void aPathNeedsTwoToAThousandPositions() throws IOException {
    Path one = Files.writeString(folder.resolve("one.csv"), "x,y,z\n1,2,3\n");
    Given.refuses(
        "a path has 2 to 1,000 positions and this one has 1: "
            + one
            + ": leave out rows, or add"
            + " some",
        () -> plans("--guide=path:" + one));
    Path many =
        Files.writeString(folder.resolve("many.csv"), "x,y,z\n" + "1,2,3\n4,5,6\n".repeat(501));
    Given.refuses(
        "a path has 2 to 1,000 positions and this one has 1,002: "
            + many
            + ": leave out rows, or"
            + " add some",
        () -> plans("--guide=path:" + many));
    Path missing = folder.resolve("none.csv");
    assertThrows(CsvFormatException.class, () -> plans("--guide=path:" + missing));
  }

  @Test
  void aSegmentPushesOutOfItsMarginAlone() throws IOException {
    EffectPlan away = plans("--guide=away:sphere,3", "--guide-stiffness=0.5").get(0);
    assertEquals(0, pull(away, 8, 8, 20).length());
    assertTrue(pull(away, 8, 8, 15).z > 0, "out of the margin");
    Given.refuses(
        "there is no such segment: --guide away:bone,3: choose sphere",
        () -> plans("--guide=away:bone,3"));
  }

  @Test
  void effectsComeBeforeGuidesAndMassIsKept() throws IOException {
    VolumeSource source = Given.source("--phantom=sphere:16");
    Optional<MassSettings> mass = Optional.of(new MassSettings(0.05, new Vec3()));
    var settings =
        options("--guide=axis:0,0,0,0,0,1", "--effect=stickslip:1")
            .settings(source, Given.segments(source), mass);
    assertEquals(2, settings.effects().size());
    assertEquals(0, pull(settings.effects().get(0), 5, 0, 0).length(), "nothing to stick to");
    assertTrue(pull(settings.effects().get(1), 5, 0, 0).x < 0, "the axis pulls");
    assertEquals(mass, settings.mass());
    assertTrue(settings.materials().isEmpty());
  }

  @Test
  void greyValuesAreNeededForATextureAndForMaterials() {
    assertFalse(options("--guide=axis:0,0,0,0,0,1").needsGrey());
    assertTrue(options("--effect=texture:0.1").needsGrey());
    assertTrue(options("--material-from-grey=ct").needsGrey());
    assertFalse(options("--effect=texture:0.1").hasGreyMaterials());
    assertTrue(options("--material-from-grey=ct").hasGreyMaterials());
  }
}
