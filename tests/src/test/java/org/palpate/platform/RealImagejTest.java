package org.palpate.platform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeReader;

/**
 * The packed plug-in in the real ImageJ, in a process of its own: installed as people install it,
 * used by menu, dialog, recorder and macro.
 */
class RealImagejTest {
  private static final Path DEBIAN = Path.of("/usr/share/java/ij.jar");
  private static final Pattern STACK_TRACE = Pattern.compile("(?m)^\\s+at |Exception|Error:");

  /** Longer than any part takes on a busy machine, because the end of the hand ends the session. */
  private static final int STILL_MS = 300_000;

  private static XServer display;

  @TempDir Path folder;
  private long solid;

  @BeforeAll
  static void startDisplay() throws IOException {
    display = XServer.start();
  }

  @AfterAll
  static void stopDisplay() {
    if (display != null) {
      display.close();
    }
  }

  private void writeFiles() throws IOException {
    solid = ImagejFiles.writeBall(folder.resolve("ball.tif"));
    ImagejFiles.writeSlide(folder.resolve("slide.csv"));
    ImagejFiles.writeStill(folder.resolve("still.csv"), STILL_MS);
    ImagejFiles.writeStill(folder.resolve("short.csv"), 2_000);
  }

  @Test
  void theBundleWorksInPlainImagej() throws Exception {
    writeFiles();
    RealImagej.Seen seen =
        RealImagej.plain(folder)
            .with("probe.seconds", 2)
            .play(display, "menu", "dialog", "record", "touch");
    checkEnd(seen);
    assertEquals("1.54p", seen.of("version"));
    checkMenu(seen);
    checkDialog(seen);
    checkRecorder(seen);
    checkTouch(seen);
  }

  @Test
  void aVolumeOfAnotherFormatIsOpenedByHandAndByMacro() throws Exception {
    ImagejFiles.writeLabels(folder.resolve("two labels.nrrd"));
    RealImagej.Seen seen = RealImagej.plain(folder).play(display, "open");
    checkEnd(seen);
    String expected = "two labels.nrrd 8 0.5x0.8x2.0 mm at 10.0";
    assertEquals(expected, seen.of("opened by hand"));
    assertEquals(expected, seen.of("opened by macro"));
    assertTrue(
        seen.of("recorded opening")
            .contains("volume=[" + folder.resolve("two labels.nrrd") + "] time=[]"),
        seen.of("recorded opening"));
    assertEquals("lower jaw\t32\nupper jaw\t32", seen.of("opened segments").strip());
    assertEquals("", seen.of("moved"));
    assertEquals("No fragment lower jaw can move.", seen.of("not moved"));
    assertEquals("placed-" + expected, seen.of("placed"));
    assertEquals("32", seen.of("placed voxels"), "the other fragment has left the stack");
    VolumeReader saved = VolumeFiles.open(folder.resolve("saved.tif"), ReadOptions.defaults());
    VolumeReader labels =
        VolumeFiles.open(folder.resolve("two labels.nrrd"), ReadOptions.defaults());
    assertEquals(
        labels.header().grid().spacingMm().toString(),
        saved.header().grid().spacingMm().toString());
    assertEquals(values(labels), values(saved));
  }

  /** Takes two minutes of dialogs and needs an idle machine: -Dpalpate.realImagej=full. */
  @Test
  @EnabledIfSystemProperty(named = "palpate.realImagej", matches = "full")
  void everyCommandWorksAndManySessionsLeaveNothingBehind() throws Exception {
    writeFiles();
    RealImagej.Seen seen =
        RealImagej.plain(folder)
            .with("probe.seconds", 10)
            .with("probe.cycles", 12)
            .play(display, "others", "refuse", "latency", "cycles");
    checkEnd(seen);
    checkOthers(seen);
    checkRefusals(seen);
    checkCycles(seen);
    System.out.println("an edit is felt after ms: " + seen.of("felt ms"));
    System.out.println("an edit is seen after ms: " + seen.of("seen ms"));
  }

  @Test
  void theThinJarWorksOnAFlatClassPathLikeFijis() throws Exception {
    writeFiles();
    RealImagej.Seen seen =
        RealImagej.flat(folder).with("probe.seconds", 2).play(display, "menu", "record", "touch");
    checkEnd(seen);
    checkMenu(seen);
    checkRecorder(seen);
    checkTouch(seen);
  }

  @Test
  void theBundleWorksOnAnotherJdk() throws Exception {
    List<Path> others = OtherJdks.found();
    Assumptions.assumeTrue(!others.isEmpty(), "skipped: no JDK 25 or newer was found");
    writeFiles();
    RealImagej.Seen seen =
        RealImagej.plain(folder)
            .on(others.get(0))
            .with("probe.seconds", 2)
            .play(display, "menu", "record", "touch");
    checkEnd(seen);
    checkRecorder(seen);
    checkTouch(seen);
  }

  @Test
  void theBundleWorksInDebiansImagej() throws Exception {
    Assumptions.assumeTrue(Files.exists(DEBIAN), "skipped: Debian's imagej is not installed");
    writeFiles();
    RealImagej.Seen seen =
        RealImagej.plain(folder, DEBIAN)
            .with("probe.seconds", 2)
            .play(display, "menu", "record", "touch");
    checkEnd(seen);
    checkMenu(seen);
    checkRecorder(seen);
    checkTouch(seen);
  }

  private static List<Integer> values(VolumeReader volume) throws IOException {
    List<Integer> values = new ArrayList<>();
    volume.read((k, slice) -> Arrays.stream(slice.integers()).forEach(values::add));
    return values;
  }

  /** Checks that every part ran, and that the standard error has no stack trace. */
  static void checkEnd(RealImagej.Seen seen) {
    assertFalse(seen.facts().containsKey("failed"), () -> seen.facts().get("failed"));
    assertEquals("reached", seen.of("end"), seen::errors);
    assertFalse(STACK_TRACE.matcher(seen.errors()).find(), seen::errors);
  }

  private static void checkMenu(RealImagej.Seen seen) {
    assertEquals(
        "[Open Volume..., Touch Volume..., Place Fragments..., Stop Touching, Landmarks...,"
            + " Correct Segment..., -, Record Trajectory..., Replay Trajectory..., -, Palpate"
            + " Devices..., Measure Jitter..., About Palpate...]",
        seen.of("menu"));
  }

  private static void checkDialog(RealImagej.Seen seen) {
    String dialog = seen.of("dialog");
    for (String part :
        List.of("Segment name", "Lower threshold", "<smooth>", "N/mm", "[simulated]", "View in")) {
      assertTrue(dialog.contains(part), dialog);
    }
    assertEquals("false", seen.of("touching after cancel"));
  }

  private void checkRecorder(RealImagej.Seen seen) {
    assertEquals("ball\t" + solid, seen.of("segments").strip());
    long corrected = Long.parseLong(seen.of("corrected").strip().split("\t", -1)[1]);
    assertTrue(corrected > solid, seen.of("corrected"));
    List<String> recorded = seen.of("recorded").lines().filter(l -> l.startsWith("run")).toList();
    assertEquals(7, recorded.size(), recorded.toString());
    assertTrue(
        recorded.get(0).contains("segment=ball colour=bone lower=100 upper=255"), recorded.get(0));
    assertTrue(
        recorded.get(0).contains("materials=ball=stiffness:0.3,friction:0 "), recorded.get(0));
    assertTrue(recorded.get(1).contains("name=[tip A] save="), recorded.get(1));
    assertTrue(recorded.get(2).contains("action=add radius=4"), recorded.get(2));
    assertTrue(recorded.get(4).contains("action=redo"), recorded.get(4));
    assertTrue(recorded.get(5).contains("action=remove radius=4"), recorded.get(5));
    assertEquals("run(\"Stop Touching\");", recorded.get(6).strip());
    assertEquals("1", seen.of("landmarks again"));
    assertEquals("4", seen.of("overlay"));
    checkLandmarkFiles();
  }

  private void checkLandmarkFiles() {
    try {
      List<String> table = Files.readAllLines(folder.resolve("landmarks.csv"));
      assertEquals("name,x,y,z", table.get(0));
      assertTrue(table.get(1).startsWith("tip A,"), table.get(1));
      String[] row = table.get(1).split(",", -1);
      double middle = ImagejFiles.EDGE / 4.0;
      double x = Double.parseDouble(row[1]) - middle;
      double y = Double.parseDouble(row[2]) - middle;
      double distance = Math.sqrt(x * x + y * y);
      assertTrue(distance > 9.5 && distance < 20, "mm from the ball's middle: " + distance);
      List<String> slicer = Files.readAllLines(folder.resolve("landmarks.fcsv"));
      assertTrue(slicer.get(0).startsWith("# Markups fiducial file"), slicer.get(0));
      assertTrue(slicer.get(slicer.size() - 1).contains("tip A"), slicer.toString());
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private void checkOthers(RealImagej.Seen seen) throws IOException {
    assertEquals(2_000, seen.number("replay rows"));
    String recorded = seen.of("recorded others");
    assertTrue(recorded.contains("run(\"Measure Jitter...\", \"time=1\")"), recorded);
    assertTrue(recorded.contains("trajectory=" + folder.resolve("short.csv")), recorded);
    assertTrue(recorded.contains("lower=100 upper=255"), recorded);
    assertFalse(recorded.contains("device="), "a replay has no device: " + recorded);
    checkRest(seen.of("recorded the rest"));
    assertTrue(seen.number("taped by hand") > 100, seen.of("taped by hand"));
    assertEquals("true", seen.of("devices"));
    assertEquals("false", seen.of("touching after Escape"));
    assertEquals(4, seen.number("jitter rows"));
    assertTrue(seen.of("about").contains("Not a medical device"), seen.of("about"));
    assertTrue(seen.of("about").matches("(?s).*Palpate \\d+\\.\\d+.*"), seen.of("about"));
    List<String> taped = Files.readAllLines(folder.resolve("taped.csv"));
    assertTrue(taped.get(0).startsWith("t_ms,x,y,z"), taped.get(0));
    assertTrue(taped.size() > 100, "rows: " + taped.size());
  }

  private void checkRest(String recorded) {
    List<String> lines = recorded.lines().filter(line -> line.startsWith("run")).toList();
    assertEquals(3, lines.size(), recorded);
    assertTrue(lines.get(0).contains("workspace=fit scale=1.000 time=1"), lines.get(0));
    assertTrue(lines.get(0).contains("record=" + folder.resolve("taped.csv")), lines.get(0));
    assertEquals("run(\"Palpate Devices...\");", lines.get(1).strip());
    assertEquals("run(\"About Palpate...\");", lines.get(2).strip());
  }

  private static void checkRefusals(RealImagej.Seen seen) {
    assertTrue(seen.of("refused").contains("this is a colour image"), seen.of("refused"));
    assertTrue(seen.of("asked").contains("several channels or times"), seen.of("asked"));
    assertTrue(seen.of("idle").contains("No volume is being touched"), seen.of("idle"));
  }

  private void checkTouch(RealImagej.Seen seen) {
    assertEquals("true", seen.of("still touching"));
    assertTrue(seen.number("frames") > 0);
    assertTrue(seen.number("redraws") > 0);
    long painted = Long.parseLong(seen.of("painted").strip().split("\t", -1)[1]);
    assertTrue(painted > solid, seen.of("painted"));
    assertEquals("false", seen.of("touching after close"));
  }

  private static void checkCycles(RealImagej.Seen seen) {
    assertEquals("[]", seen.of("palpate threads"));
    long grown = seen.number("heap late") - seen.number("heap early");
    // Nine more sessions: a stack and its copy take half a megabyte each, a window's meshes more.
    assertTrue(grown < 2_000_000, "grown by " + grown + " bytes");
  }
}
