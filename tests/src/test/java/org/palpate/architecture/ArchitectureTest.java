package org.palpate.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** Holds the package map: each package uses the packages below it and no other. */
class ArchitectureTest {
  private static final String BASE = "org.palpate.";

  private static final int MAX_CLASSES_PER_PACKAGE = 30;

  /** Each package with the packages that it may use; it may also use what these may use. */
  private static final Map<String, List<String>> MAY_USE =
      Map.ofEntries(
          Map.entry("app", List.of("app.command")),
          Map.entry(
              "app.command",
              List.of("app.output", "device.protocol", "igtl", "realtime", "reduction")),
          Map.entry(
              "app.options",
              List.of(
                  "app.process",
                  "force.effect",
                  "fracture.fit",
                  "host",
                  "io.resample",
                  "io.scene",
                  "opencl",
                  "tool")),
          Map.entry("app.output", List.of("app.options", "assess", "host.placing")),
          Map.entry("app.process", List.of("display", "io.file", "io.volume")),
          Map.entry("assess", List.of("frame")),
          Map.entry(
              "benchmarks",
              List.of(
                  "benchmarks.baseline",
                  "benchmarks.input",
                  "benchmarks.shell",
                  "device.jni",
                  "loop",
                  "proxy.reference",
                  "proxy.smooth",
                  "realtime",
                  "recording",
                  "sync")),
          Map.entry(
              "benchmarks.accuracy",
              List.of(
                  "benchmarks.baseline",
                  "benchmarks.report",
                  "loop",
                  "proxy.reference",
                  "proxy.smooth",
                  "volume.phantom")),
          Map.entry("benchmarks.baseline", List.of("proxy")),
          Map.entry("benchmarks.carve", List.of("benchmarks.rigid")),
          Map.entry(
              "benchmarks.command",
              List.of(
                  "app",
                  "benchmarks.accuracy",
                  "benchmarks.carve",
                  "benchmarks.elastic",
                  "benchmarks.fracture",
                  "benchmarks.gpu",
                  "benchmarks.hold",
                  "benchmarks.nearest",
                  "benchmarks.rigid",
                  "benchmarks.speed",
                  "benchmarks.stability",
                  "benchmarks.surface",
                  "benchmarks.sync")),
          Map.entry("benchmarks.elastic", List.of("benchmarks.rigid", "frame", "volume.phantom")),
          Map.entry("benchmarks.gpu", List.of("benchmarks.report", "benchmarks.rigid", "opencl")),
          Map.entry("benchmarks.fracture", List.of("benchmarks.rigid", "reduction")),
          Map.entry(
              "benchmarks.hold",
              List.of(
                  "benchmarks",
                  "benchmarks.jitter.experiment",
                  "benchmarks.rigid",
                  "host.placing")),
          Map.entry("benchmarks.input", List.of("device", "io", "raycast")),
          Map.entry(
              "benchmarks.jitter",
              List.of("app", "benchmarks.jitter.experiment", "benchmarks.report")),
          Map.entry(
              "benchmarks.jitter.experiment",
              List.of("app.options", "benchmarks.jitter.trace", "realtime")),
          Map.entry("benchmarks.jitter.trace", List.of("io.file")),
          Map.entry("benchmarks.moving", List.of("benchmarks.stress", "fracture")),
          Map.entry(
              "benchmarks.nearest",
              List.of(
                  "benchmarks.baseline",
                  "benchmarks.report",
                  "proxy.reference",
                  "proxy.smooth",
                  "volume.phantom")),
          Map.entry("benchmarks.report", List.of("io.table")),
          Map.entry(
              "benchmarks.rigid",
              List.of("benchmarks.accuracy", "benchmarks.moving", "benchmarks.shell")),
          Map.entry("benchmarks.shell", List.of("proxy")),
          Map.entry(
              "benchmarks.speed",
              List.of("benchmarks", "benchmarks.report", "io.table", "scene.window")),
          Map.entry(
              "benchmarks.stability",
              List.of(
                  "benchmarks.report",
                  "force.effect",
                  "force.needle",
                  "fracture.fit",
                  "loop",
                  "proxy.reference",
                  "proxy.smooth",
                  "volume.phantom")),
          Map.entry("benchmarks.stress", List.of("benchmarks.input", "benchmarks.report", "host")),
          Map.entry(
              "benchmarks.surface",
              List.of("benchmarks.input", "benchmarks.report", "loop", "scene.surface")),
          Map.entry("benchmarks.sync", List.of("benchmarks.report", "host", "volume.phantom")),
          Map.entry("body", List.of("collision")),
          Map.entry("carve", List.of("edit", "rigid")),
          Map.entry("collision", List.of("raycast")),
          Map.entry("device", List.of("geometry")),
          Map.entry("device.jni", List.of("device")),
          Map.entry("device.protocol", List.of()),
          Map.entry("display", List.of()),
          Map.entry("edit", List.of("proxy.smooth.field")),
          Map.entry("elastic", List.of("elastic.lattice", "proxy", "sync")),
          Map.entry("elastic.lattice", List.of("volume")),
          Map.entry("force", List.of("proxy", "rigid")),
          Map.entry("force.effect", List.of("force.guide")),
          Map.entry("force.guide", List.of("force")),
          Map.entry("force.needle", List.of("force")),
          Map.entry("frame", List.of("carve", "device", "elastic", "force.guide")),
          Map.entry("fracture", List.of("volume.fracture")),
          Map.entry("fracture.fit", List.of("force.guide", "fracture")),
          Map.entry("geometry", List.of()),
          Map.entry(
              "host",
              List.of(
                  "device.jni",
                  "force.needle",
                  "io.table",
                  "loop",
                  "proxy.reference",
                  "proxy.smooth",
                  "recording",
                  "scene.window",
                  "volume.fracture")),
          Map.entry("host.placing", List.of("fracture.fit", "host", "io.scene")),
          Map.entry("igtl", List.of("geometry")),
          Map.entry("imagej", List.of("imagej.session")),
          Map.entry("imagej.annotation", List.of("imagej.stack", "io.table")),
          Map.entry("imagej.dialog", List.of("imagej.stack")),
          Map.entry(
              "imagej.session",
              List.of("host.placing", "imagej.annotation", "imagej.dialog", "realtime")),
          Map.entry("imagej.stack", List.of("host", "io")),
          Map.entry(
              "io",
              List.of(
                  "io.dicom",
                  "io.label",
                  "io.metaimage",
                  "io.nifti",
                  "io.nrrd",
                  "io.raw",
                  "io.tiff",
                  "volume.phantom")),
          Map.entry("io.codec", List.of()),
          Map.entry("io.dicom", List.of("io.codec", "io.format")),
          Map.entry("io.file", List.of()),
          Map.entry("io.format", List.of("io.volume")),
          Map.entry("io.label", List.of("io.format")),
          Map.entry("io.mesh", List.of("io.format", "rigid.tool")),
          Map.entry("io.metaimage", List.of("io.format")),
          Map.entry("io.nifti", List.of("io.format")),
          Map.entry("io.nrrd", List.of("io.codec", "io.format")),
          Map.entry("io.raw", List.of("io.format")),
          Map.entry("io.table", List.of("body", "edit", "elastic", "io.file")),
          Map.entry("io.resample", List.of("io")),
          Map.entry("io.scene", List.of("body", "io", "io.mesh", "io.table")),
          Map.entry("io.tiff", List.of("io.codec", "io.format")),
          Map.entry("io.volume", List.of("io.file", "volume")),
          Map.entry("loop", List.of("frame")),
          Map.entry("opencl", List.of("collision")),
          Map.entry("proxy", List.of("collision")),
          Map.entry("proxy.exact", List.of("proxy")),
          Map.entry("proxy.reference", List.of("proxy")),
          Map.entry("proxy.smooth", List.of("proxy.exact", "proxy.smooth.field")),
          Map.entry("proxy.smooth.field", List.of("collision")),
          Map.entry("raycast", List.of("statistics", "volume")),
          Map.entry("realtime", List.of("loop", "realtime.os")),
          Map.entry("realtime.os", List.of()),
          Map.entry("recording", List.of("frame")),
          Map.entry("reduction", List.of("device", "rigid")),
          Map.entry("rigid", List.of("body", "proxy.smooth.field", "rigid.skip", "rigid.tool")),
          Map.entry("rigid.skip", List.of("body", "rigid.tool")),
          Map.entry("rigid.tool", List.of("volume")),
          Map.entry("scene", List.of("elastic", "scene.surface", "sync")),
          Map.entry("scene.gl", List.of("scene")),
          Map.entry("scene.surface", List.of("volume")),
          Map.entry("scene.window", List.of("display", "scene.gl")),
          Map.entry("scijava", List.of("app")),
          Map.entry("statistics", List.of()),
          Map.entry("sync", List.of("geometry")),
          Map.entry("tool", List.of("io", "io.mesh", "rigid")),
          Map.entry("volume", List.of("geometry")),
          Map.entry("volume.fracture", List.of("volume")),
          Map.entry("volume.phantom", List.of("volume.fracture")));

  /**
   * Production classes that no other production class seems to use. Some are for embedding
   * programs. Some hold constants alone, which the compiler copies to where they are used. Some
   * belong to the benchmarks and stand in a production package to reach its factories.
   */
  private static final Set<String> USED_BY_OTHERS =
      new TreeSet<>(
          List.of(
              BASE + "device.jni.FrameLayout",
              BASE + "scene.Palette",
              BASE + "scene.gl.SceneRendererVariants",
              BASE + "scene.gl.Shaders",
              BASE + "scene.window.OffscreenRendererVariants"));

  /** Packages that stand on the path of a frame. */
  private static final String[] ON_FRAME_PATH = {
    BASE + "geometry..",
    BASE + "statistics",
    BASE + "raycast..",
    BASE + "collision..",
    BASE + "body..",
    BASE + "rigid..",
    BASE + "proxy..",
    BASE + "force..",
    BASE + "edit..",
    BASE + "elastic..",
    BASE + "carve..",
    BASE + "frame..",
    BASE + "sync..",
  };

  /** Packages with native methods: JNI in {@code device.jni}, bindings of JNA in the others. */
  private static final Set<String> HAVE_NATIVE_METHODS =
      Set.of("device.jni", "realtime.os", "display", "benchmarks.jitter.experiment");

  /** Classes of module benchmarks that open package-private factories to its benchmarks. */
  private static final Set<String> OPENERS_FOR_BENCHMARKS =
      Set.of(
          BASE + "collision.CollisionSceneVariants",
          BASE + "elastic.ElasticBodyVariants",
          BASE + "elastic.WindowVariants",
          BASE + "elastic.lattice.BeamVariants",
          BASE + "elastic.lattice.DiscVariants",
          BASE + "opencl.OpenClLegsVariants",
          BASE + "proxy.exact.GuardedSolverVariants",
          BASE + "raycast.ExactRayCasterVariants");

  private static final JavaClasses CLASSES =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .withImportOption(location -> !location.contains("-tests.jar"))
          .withImportOption(location -> !location.contains("/jmh_generated/"))
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

  /** Returns the package of a class without the common prefix; empty outside Palpate. */
  private static String house(JavaClass c) {
    String packageName = c.getPackageName();
    return packageName.startsWith(BASE) ? packageName.substring(BASE.length()) : "";
  }

  @Test
  void everyPackageIsInTheMap() {
    Set<String> packages = new TreeSet<>();
    CLASSES.forEach(c -> packages.add(house(c)));
    assertEquals(new TreeSet<>(MAY_USE.keySet()), packages);
  }

  @Test
  void noPackageHoldsMoreThanThirtyClasses() {
    Map<String, Long> counts =
        CLASSES.stream()
            .filter(c -> !c.isNestedClass() && !c.getSimpleName().equals("package-info"))
            .collect(groupingBy(ArchitectureTest::house, TreeMap::new, counting()));
    counts.values().removeIf(count -> count <= MAX_CLASSES_PER_PACKAGE);
    assertEquals(Map.of(), counts);
  }

  @Test
  void noProductionClassIsThereForABenchmarkOrATestAlone() {
    Set<String> unused = new TreeSet<>();
    for (JavaClass c : CLASSES) {
      if (isProduction(c) && !c.isNestedClass() && !isEntryPoint(c) && !isUsedInProduction(c)) {
        unused.add(c.getName());
      }
    }
    assertEquals(USED_BY_OTHERS, unused);
  }

  private static boolean isProduction(JavaClass c) {
    return !house(c).startsWith("benchmarks")
        && !OPENERS_FOR_BENCHMARKS.contains(c.getName())
        && !c.getSimpleName().equals("package-info");
  }

  /** Whether the JVM, ImageJ or SciJava starts the class by its name. */
  private static boolean isEntryPoint(JavaClass c) {
    return c.getName().equals("org.palpate.app.Main")
        || c.isAssignableTo("ij.plugin.PlugIn")
        || c.isAssignableTo("org.scijava.command.Command");
  }

  private static boolean isUsedInProduction(JavaClass c) {
    return withNested(c)
        .flatMap(part -> part.getDirectDependenciesToSelf().stream())
        .map(Dependency::getOriginClass)
        .anyMatch(origin -> isProduction(origin) && !outermost(origin).equals(c));
  }

  private static Stream<JavaClass> withNested(JavaClass c) {
    return CLASSES.stream().filter(part -> outermost(part).equals(c));
  }

  private static JavaClass outermost(JavaClass c) {
    JavaClass outer = c;
    while (outer.getEnclosingClass().isPresent()) {
      outer = outer.getEnclosingClass().get();
    }
    return outer;
  }

  @Test
  void packagesHaveNoCycles() {
    slices().matching("org.palpate.(**)").should().beFreeOfCycles().check(CLASSES);
  }

  @Test
  void coreKnowsTheJdkAndHdrHistogramAlone() {
    classes()
        .that(
            resideInAnyPackage(ON_FRAME_PATH)
                .or(
                    resideInAnyPackage(
                        BASE + "assess",
                        BASE + "device",
                        BASE + "fracture..",
                        BASE + "loop..",
                        BASE + "recording..",
                        BASE + "reduction..",
                        BASE + "volume..")))
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage("java..", "javax.management..", "org.HdrHistogram..", "org.palpate..")
        .check(CLASSES);
  }

  @Test
  void joglStandsOnlyInScene() {
    onlyIn("..scene..", "org.palpate.opencl..").accept("com.jogamp..", "jogamp..");
    onlyIn("..scene..")
        .accept("com.jogamp.opengl..", "com.jogamp.newt..", "com.jogamp.nativewindow..");
  }

  @Test
  void openClStandsOnlyInItsBackend() {
    onlyIn("org.palpate.opencl..").accept("com.jogamp.opencl..");
  }

  @Test
  void jnaStandsOnlyInRealtimeDisplayAndTheJitterLaboratory() {
    onlyIn("..realtime..", "..display..", "..benchmarks.jitter.experiment..")
        .accept("com.sun.jna..");
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
  void nativeMethodsStandOnlyWhereTheyAreBound() {
    methods()
        .that()
        .areDeclaredInClassesThat(
            describe(
                "are outside " + HAVE_NATIVE_METHODS,
                (JavaClass c) -> !HAVE_NATIVE_METHODS.contains(house(c))))
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
                            "..loop..",
                            "..elastic..",
                            "..recording..",
                            "..scene..",
                            "..host..",
                            "..igtl..",
                            "..app..",
                            "..benchmarks..")
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
        .that(resideInAnyPackage(ON_FRAME_PATH))
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(
            "java.util.concurrent.locks..", "java.util.logging..", "java.util.stream..")
        .because("they stand on the path of a frame")
        .check(CLASSES);
  }
}
