package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.elastic.ElasticBody;
import org.palpate.host.SolverKind;

class ElasticOptionsTest {
  private static final String SOFT = "--elastic=block=young:20e3";

  private static ElasticOptions options(String... arguments) {
    return Given.options(new ElasticOptions(), arguments);
  }

  private static Optional<Supplier<ElasticBody>> bodies(String... arguments) throws IOException {
    return options(arguments)
        .bodies(Given.segments(Given.source("--phantom=block:16")), SolverKind.SMOOTH);
  }

  private static void check(String tool, String volume, String... arguments) throws IOException {
    options(arguments)
        .check(Given.options(new VolumeOptions(), volume), Given.options(new ToolOptions(), tool));
  }

  @Test
  void withoutTheOptionNothingIsElastic() throws IOException {
    assertFalse(options().isWanted());
    assertTrue(bodies().isEmpty());
    check("--mass=1", "--phantom=fracture:64:2");
  }

  @Test
  void eachBodyIsANewOneAtRest() throws IOException {
    assertTrue(options(SOFT).isWanted());
    Supplier<ElasticBody> bodies = bodies(SOFT, "--fixed=base", "--lattice=2").orElseThrow();
    ElasticBody first = bodies.get();
    ElasticBody second = bodies.get();
    assertNotSame(first, second);
    assertEquals(first.hexahedra(), second.hexahedra());
  }

  @Test
  void theEdgeOfACellDividesTheSegment() throws IOException {
    int coarse = bodies(SOFT, "--lattice=4").orElseThrow().get().hexahedra();
    int fine = bodies(SOFT, "--lattice=2").orElseThrow().get().hexahedra();
    assertTrue(fine > coarse, fine + " cells, and " + coarse);
    int usual = bodies(SOFT).orElseThrow().get().hexahedra();
    int finest = bodies(SOFT, "--lattice=1").orElseThrow().get().hexahedra();
    assertEquals(finest, usual, "3,000 cells of a voxel or more");
  }

  @Test
  void aSharpContactHasAWindowOfShorterElements() throws IOException {
    int whole = bodies(SOFT, "--lattice=4").orElseThrow().get().hexahedra();
    int wide = bodies(SOFT, "--lattice=4", "--contact-radius=8").orElseThrow().get().hexahedra();
    int sharp = bodies(SOFT, "--lattice=4", "--contact-radius=4").orElseThrow().get().hexahedra();
    assertEquals(whole, wide);
    assertEquals(whole + 12 * 12 * 12, sharp);
    Given.refuses(
        "a contact of 1.5 mm needs cells of at most twice its radius: block: change --elastic,"
            + " --lattice or --contact-radius",
        () -> bodies(SOFT, "--lattice=4", "--contact-radius=1.5"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "20e3",
        "young:",
        "young:9.9",
        "young:1.1e12",
        "young:NaN",
        "young:1e4,0.4",
        "young:1e4,poisson:0.5",
        "young:1e4,poisson:-0.1",
        "young:1e4,poisson:0.4,poisson:0.4",
        "poisson:0.4"
      })
  void aMaterialThatCannotBeReadIsShownWithAnExample(String text) {
    Given.refuses(
        "the elastic material cannot be read: --elastic block="
            + text
            + ": write for example block=young:20e3,poisson:0.4, with a modulus of 10 to 1e12 Pa"
            + " and a ratio of 0 to 0.49",
        () -> bodies("--elastic=block=" + text));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"young:10", "young:1e12", "young:1e4,poisson:0", "young:1e4,poisson:0.49"})
  void theEndsOfEachRangeAreAllowed(String text) throws IOException {
    assertTrue(bodies("--elastic=block=" + text, "--lattice=4").isPresent());
  }

  @Test
  void segmentsMustBeThereAndNotTwoThings() {
    Given.refuses(
        "there is no such segment: --elastic skin: choose block or base",
        () -> bodies("--elastic=skin=young:1e4"));
    Given.refuses(
        "there is no such segment: --fixed skin: choose block or base",
        () -> bodies(SOFT, "--fixed=skin"));
    Given.refuses(
        "a segment is elastic and fixed: --fixed block: leave one of them out",
        () -> bodies(SOFT, "--fixed=block"));
  }

  @Test
  void fixedAndLatticeNeedSomethingElastic() {
    Given.refuses(
        "no segment is elastic: --fixed: add --elastic NAME=young:PA, or leave it out",
        () -> bodies("--fixed=base"));
    Given.refuses(
        "no segment is elastic: --lattice: add --elastic NAME=young:PA, or leave it out",
        () -> bodies("--lattice=2"));
    Given.refuses(
        "no segment is elastic: --contact-radius: add --elastic NAME=young:PA, or leave it out",
        () -> bodies("--contact-radius=2"));
  }

  @ParameterizedTest
  @EnumSource(
      value = SolverKind.class,
      names = {"DOT", "PAPER", "NONE"})
  void aSolverWithoutTheGuaranteeIsRefused(SolverKind solver) {
    Given.refuses(
        "elastic segments need a solver that keeps the guarantee: --solver "
            + solver
            + ": choose smooth or guarded",
        () -> options(SOFT).bodies(Given.segments(Given.source("--phantom=block:16")), solver));
  }

  @Test
  void whatDoesNotGoTogetherIsRefused() throws IOException {
    String tool = "--tool=point";
    String volume = "--phantom=block:16";
    check(tool, volume, SOFT);
    Given.refuses(
        "a point with mass touches rigid segments alone: --elastic with --mass: leave one of them"
            + " out",
        () -> check("--mass=0.1", volume, SOFT));
    Given.refuses(
        "elastic segments are those of one volume: --elastic: give a volume, not a scene",
        () -> check(tool, "--phantom=fracture:64:2", SOFT));
    Given.refuses(
        "the edge of a cell must be a number from 0.000001 to 1,000,000 mm: --lattice 0: try"
            + " --lattice 1",
        () -> check(tool, volume, "--lattice=0"));
    Given.refuses(
        "the radius of a contact must be a number from 0.000001 to 1,000,000 mm: --contact-radius"
            + " 0: try --contact-radius 1",
        () -> check(tool, volume, "--contact-radius=0"));
  }

  @Test
  void allElasticSegmentsHaveOneRatio() throws IOException {
    String[] one = {SOFT + ",poisson:0.3", "--elastic=base=young:1e6,poisson:0.3", "--lattice=4"};
    assertTrue(bodies(one).isPresent());
    Given.refuses(
        "elastic segments need one Poisson's ratio, but there are 0.3 and 0.4: block, base: change"
            + " --elastic or --lattice",
        () -> bodies(SOFT + ",poisson:0.3", "--elastic=base=young:1e6", "--lattice=4"));
  }
}
