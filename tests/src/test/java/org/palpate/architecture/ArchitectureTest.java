package org.palpate.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** The house of the design: each package uses those below it and no other. */
class ArchitectureTest {
  private static final String BASE = "org.palpate.";

  /** Each package with those that it may use; what these may use, it may too. */
  private static final Map<String, List<String>> MAY_USE =
      Map.ofEntries(
          Map.entry("geometry", List.of()),
          Map.entry("volume", List.of("geometry")),
          Map.entry("raycast", List.of("volume")),
          Map.entry("proxy", List.of("raycast")),
          Map.entry("force", List.of("proxy")),
          Map.entry("device", List.of("geometry")),
          Map.entry("sync", List.of("geometry")),
          Map.entry("interaction", List.of("device", "proxy", "force", "sync")),
          Map.entry("device.jni", List.of("device")),
          Map.entry("realtime", List.of("interaction")),
          Map.entry("scene", List.of("sync", "volume", "geometry")),
          Map.entry("io", List.of("volume")),
          Map.entry("host", List.of("interaction", "scene", "device", "volume")),
          Map.entry("imagej", List.of("host", "io", "device.jni", "realtime")),
          Map.entry("app", List.of("host", "io", "device.jni", "realtime")),
          Map.entry("scijava", List.of("app")),
          Map.entry("benchmarks", List.of("app", "imagej")));

  private static final JavaClasses CLASSES =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .withImportOption(location -> !location.contains("-tests.jar"))
          .importPackages("org.palpate");

  @TestFactory
  Stream<DynamicTest> usesOnlyWhatStandsBelowIt() {
    return MAY_USE.keySet().stream()
        .sorted()
        .map(name -> DynamicTest.dynamicTest(name, () -> usesOnlyWhatStandsBelow(name)));
  }

  private static void usesOnlyWhatStandsBelow(String name) {
    Set<String> allowed = new TreeSet<>();
    addWithAllBelow(name, allowed);
    classes()
        .that(describe("reside in " + name, (JavaClass c) -> house(c).equals(name)))
        .should()
        .onlyDependOnClassesThat(
            describe(
                "are outside Palpate or in one of " + allowed,
                (JavaClass c) -> house(c).isEmpty() || allowed.contains(house(c))))
        .check(CLASSES);
  }

  private static void addWithAllBelow(String name, Set<String> dest) {
    dest.add(name);
    MAY_USE.get(name).forEach(below -> addWithAllBelow(below, dest));
  }

  /** The longest name of {@link #MAY_USE} that holds the class; empty outside Palpate. */
  private static String house(JavaClass c) {
    String packageName = c.getPackageName() + ".";
    return MAY_USE.keySet().stream()
        .filter(name -> packageName.startsWith(BASE + name + "."))
        .reduce("", (a, b) -> a.length() > b.length() ? a : b);
  }

  @Test
  void everyPackageHasItsPlaceInTheHouse() {
    List<String> strays = new ArrayList<>();
    for (JavaClass c : CLASSES) {
      if (house(c).isEmpty() && !c.getPackageName().startsWith("org.palpate.benchmarks")) {
        strays.add(c.getName());
      }
    }
    assertEquals(List.of(), strays);
  }

  @Test
  void packagesHaveNoCycles() {
    slices().matching("org.palpate.(**)").should().beFreeOfCycles().check(CLASSES);
  }

  @Test
  void coreKnowsTheJdkAndHdrHistogramAlone() {
    classes()
        .that()
        .resideInAnyPackage(
            BASE + "geometry..",
            BASE + "volume..",
            BASE + "raycast..",
            BASE + "proxy..",
            BASE + "force..",
            BASE + "device",
            BASE + "sync..",
            BASE + "interaction..")
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage("java..", "org.HdrHistogram..", "org.palpate..")
        .check(CLASSES);
  }

  @Test
  void joglStandsOnlyInScene() {
    onlyIn("..scene..").accept("com.jogamp..", "jogamp..");
  }

  @Test
  void jnaStandsOnlyInRealtime() {
    onlyIn("..realtime..").accept("com.sun.jna..");
  }

  @Test
  void imageJStandsOnlyInImagejAndIo() {
    onlyIn("..imagej..", "..io..").accept("ij..");
  }

  @Test
  void scijavaStandsOnlyInItsFace() {
    onlyIn("org.palpate.scijava..").accept("org.scijava..");
  }

  private interface Rule {
    void accept(String... foreignPackages);
  }

  private static Rule onlyIn(String... homes) {
    return foreign ->
        noClasses()
            .that(resideInAnyPackage("org.palpate..").and(resideInAnyPackage(homes).negate()))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(foreign)
            .check(CLASSES);
  }

  @Test
  void nativeMethodsStandOnlyInDeviceJni() {
    methods()
        .that()
        .areDeclaredInClassesThat(
            describe(
                "are ours and bind nothing by JNA",
                (JavaClass c) -> !house(c).equals("realtime") && !house(c).equals("device.jni")))
        .should()
        .notHaveModifier(JavaModifier.NATIVE)
        .check(CLASSES);
  }

  @Test
  void threadsStandOnlyWhereTheyAreOwned() {
    noClasses()
        .that(
            resideInAnyPackage("org.palpate..")
                .and(
                    resideInAnyPackage(
                            "..interaction..", "..scene..", "..host..", "..app..", "..benchmarks..")
                        .negate()))
        .should()
        .callConstructorWhere(
            describe(
                "makes a thread",
                call ->
                    call.getTargetOwner().isAssignableTo(Thread.class)
                        || call.getTargetOwner().isAssignableTo(ForkJoinPool.class)
                        || call.getTargetOwner().isAssignableTo(java.util.Timer.class)))
        .orShould()
        .dependOnClassesThat()
        .areAssignableTo(ExecutorService.class)
        .check(CLASSES);
  }

  @Test
  void frameCodeTakesNoLockAndNoStreamAndLogsNothing() {
    noClasses()
        .that()
        .resideInAnyPackage(
            BASE + "geometry..",
            BASE + "raycast..",
            BASE + "proxy..",
            BASE + "force..",
            BASE + "sync..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(
            "java.util.concurrent.locks..", "java.util.logging..", "java.util.stream..")
        .because("they stand on the path of a frame")
        .check(CLASSES);
  }
}
