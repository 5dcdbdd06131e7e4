package org.palpate.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.PalpateCommandLine;
import org.palpate.geometry.Vec3;
import org.palpate.platform.XServer;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/** Runs every example that the documents show, and checks what it prints. */
class ExamplesTest {
  /** The jars that module plugin marks as optional, by the start of their names. */
  private static final Pattern OPTIONAL =
      Pattern.compile("^(jocl|jogl|gluegen|ij|picocli|scijava|zstd-jni)-.*\\.jar$");

  private static final BitCube SPHERE =
      Phantom.parse("sphere:64").segments().segments().get(0).bits();
  private static final Pattern POSITION = Pattern.compile("\\(([^,]+), ([^,]+), ([^)]+)\\)");
  private static final Pattern FORCE = Pattern.compile("([0-9.Ee-]+) N$");

  private static final long PATIENCE_S = 300;

  @TempDir private Path folder;

  /** The main method of an example. */
  private interface Example {
    void run(String... arguments) throws Exception;
  }

  @Test
  void touchOfflinePrintsTheForceOfAPressOnAScan() throws Exception {
    Path scan = folder.resolve("head.nii.gz");
    int exitCode =
        new PalpateCommandLine(new PrintStream(OutputStream.nullOutputStream()), System.err)
            .run("info", "--phantom", "head:128:grey", "--export", scan.toString());
    assertEquals(0, exitCode);

    List<String> lines = linesOf(TouchOffline::main, scan.toString(), "bone=>=661");

    assertEquals(11, lines.size(), lines::toString);
    assertEquals(0, force(lines.get(2)));
    for (int n = 4; n < lines.size(); n++) {
      assertTrue(force(lines.get(n)) > force(lines.get(n - 1)), lines.get(n));
    }
    // README names this figure.
    assertEquals(19.5, force(lines.get(10)), 0.05, lines.get(10));
  }

  @Test
  void touchGreyValuesFollowsTheIsosurfaceOfAScan() throws Exception {
    Path scan = folder.resolve("ball.nrrd");
    int exitCode =
        new PalpateCommandLine(new PrintStream(OutputStream.nullOutputStream()), System.err)
            .run("info", "--phantom", "sphere:64:grey", "--export", scan.toString());
    assertEquals(0, exitCode);

    List<String> lines = linesOf(TouchGreyValues::main, scan.toString(), "500");

    assertEquals(11, lines.size(), lines::toString);
    assertEquals(0, force(lines.get(1)));
    assertTrue(force(lines.get(10)) > 1, lines.get(10));
    // The device is far inside, and the point stays within a voxel of the sphere, outside.
    double radius = position(lines.get(8)).sub(new Vec3(32, 32, 32), new Vec3()).length();
    assertTrue(radius > 64 / 3.0 && radius < 64 / 3.0 + 1, lines.get(8));
  }

  @Test
  void holdToolPressesAToolOntoARing() throws Exception {
    List<String> lines = linesOf(HoldTool::main, "box:9,5,2", "-0.5");

    assertEquals("218 points, gap -0.5 mm", lines.get(0));
    assertEquals(5, lines.size(), lines::toString);
    assertTrue(lines.get(1).startsWith("false "), lines.get(1));
    assertTrue(lines.get(4).startsWith("true "), lines.get(4));
    assertTrue(force(lines.get(4)) > 2 && force(lines.get(4)) < 4, lines.get(4));
  }

  @Test
  void filesAreTouchedWithoutTheOptionalLibraries() throws Exception {
    Path scan = folder.resolve("sphere.nrrd");
    int exitCode =
        new PalpateCommandLine(new PrintStream(OutputStream.nullOutputStream()), System.err)
            .run("info", "--phantom", "sphere:48:grey", "--export", scan.toString());
    assertEquals(0, exitCode);
    String classPath =
        Stream.of(System.getProperty("java.class.path").split(File.pathSeparator, -1))
            .filter(entry -> !OPTIONAL.matcher(Path.of(entry).getFileName().toString()).find())
            .collect(Collectors.joining(File.pathSeparator));
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    String example = TouchOffline.class.getName();

    Process process =
        new ProcessBuilder(java, "-cp", classPath, example, scan.toString(), "ball=>=500")
            .redirectErrorStream(true)
            .start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

    assertEquals(0, process.waitFor(), out);
    assertEquals(11, out.lines().count(), out);
    assertTrue(force(out.lines().toList().get(10)) > 1, out);
  }

  @Test
  void liveSessionTouchesASphereAndEndsAsAsked() throws Exception {
    List<String> lines = linesOf(LiveSession::main);

    List<String> ticks = lines.stream().filter(line -> line.endsWith(" N")).toList();
    assertTrue(ticks.size() > 10, lines::toString);
    // The first tick may come before the first frame.
    ticks.stream().filter(line -> !line.startsWith("(0.0, 0.0, 0.0)")).forEach(this::isOutside);
    assertTrue(ticks.stream().anyMatch(line -> force(line) > 0.5), ticks::toString);
    assertTrue(lines.contains("ended: STOPPED"), lines::toString);
    long contactFrames = Long.parseLong(lines.get(lines.size() - 1).replaceAll("[^0-9]", ""));
    assertTrue(contactFrames > 100, lines.get(lines.size() - 1));
  }

  @Test
  void customDeviceFeelsTheSphereAndEndsWithZeroForce() throws Exception {
    List<String> lines = linesOf(CustomDevice::main);

    double greatest =
        lines.stream()
            .filter(line -> line.contains("frames"))
            .mapToDouble(ExamplesTest::force)
            .max()
            .orElseThrow();
    assertTrue(greatest > 3 && greatest < 6, lines::toString);
    assertEquals("at the end: 0.0 N", lines.get(lines.size() - 1));
  }

  @Test
  void customSolverStopsBeforeTheSphere() throws Exception {
    List<String> lines = linesOf(CustomSolver::main);

    assertEquals(11, lines.size(), lines::toString);
    lines.forEach(this::isOutside);
    Vec3 end = position(lines.get(10));
    assertEquals(new Vec3(32, 32, 53).toString(), round(end).toString());
  }

  @Test
  void editWhileTouchingTakesTheForceAwayAndBringsItBack() throws Exception {
    List<String> lines = linesOf(EditWhileTouching::main);

    assertEquals(4, lines.size(), lines::toString);
    assertTrue(force(lines.get(0)) > 1 && force(lines.get(0)) < 2, lines.get(0));
    assertEquals("voxels removed: 0.0 N", lines.get(1));
    assertTrue(force(lines.get(2)) > 1, lines.get(2));
    assertEquals("set free: 1 time", lines.get(3));
  }

  /** Skips where there is no Xvfb. */
  @Test
  void embeddedViewDrawsPictures() throws Exception {
    Path printed = folder.resolve("printed.txt");
    try (XServer server = XServer.start()) {
      ProcessBuilder builder =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-cp",
                  System.getProperty("java.class.path"),
                  EmbeddedView.class.getName(),
                  "1")
              .redirectErrorStream(true)
              .redirectOutput(printed.toFile());
      builder.environment().put("DISPLAY", server.display());
      Process process = builder.start();
      boolean ended = process.waitFor(PATIENCE_S, TimeUnit.SECONDS);
      process.destroyForcibly();
      String out = Files.readString(printed);

      assertTrue(ended, () -> "no picture; printed: " + out);
      assertEquals(0, process.exitValue(), out);
      assertTrue(out.contains(" pictures; ended: STOPPED"), out);
      assertFalse(out.startsWith("0 pictures"), out);
    }
  }

  private static synchronized List<String> linesOf(Example example, String... arguments)
      throws Exception {
    PrintStream standard = System.out;
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    System.setOut(new PrintStream(bytes, true, StandardCharsets.UTF_8));
    try {
      example.run(arguments);
    } finally {
      System.setOut(standard);
    }
    return Arrays.asList(bytes.toString(StandardCharsets.UTF_8).split("\\R"));
  }

  private void isOutside(String line) {
    Vec3 p = position(line);
    boolean solid = SPHERE.get((int) Math.floor(p.x), (int) Math.floor(p.y), (int) Math.floor(p.z));
    assertFalse(solid, line);
  }

  private static Vec3 position(String line) {
    Matcher matcher = POSITION.matcher(line);
    assertTrue(matcher.find(), line);
    return new Vec3(
        Double.parseDouble(matcher.group(1)),
        Double.parseDouble(matcher.group(2)),
        Double.parseDouble(matcher.group(3)));
  }

  private static Vec3 round(Vec3 p) {
    return new Vec3(Math.rint(p.x), Math.rint(p.y), Math.rint(p.z));
  }

  private static double force(String line) {
    Matcher matcher = FORCE.matcher(line);
    assertTrue(matcher.find(), line);
    return Double.parseDouble(matcher.group(1));
  }
}
