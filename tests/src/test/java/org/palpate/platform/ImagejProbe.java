package org.palpate.platform;

import static org.palpate.platform.ImagejProbeDialogs.awaitAny;
import static org.palpate.platform.ImagejProbeDialogs.awaitDialog;
import static org.palpate.platform.ImagejProbeDialogs.awaitRecorded;
import static org.palpate.platform.ImagejProbeDialogs.byHand;
import static org.palpate.platform.ImagejProbeDialogs.choose;
import static org.palpate.platform.ImagejProbeDialogs.number;
import static org.palpate.platform.ImagejProbeDialogs.press;
import static org.palpate.platform.ImagejProbeDialogs.saveAs;
import static org.palpate.platform.ImagejProbeDialogs.text;
import static org.palpate.platform.ImagejProbeDialogs.texts;
import static org.palpate.platform.ImagejProbeWatch.await;
import static org.palpate.platform.ImagejProbeWatch.awaitQuietThreads;
import static org.palpate.platform.ImagejProbeWatch.palpateThreads;
import static org.palpate.platform.ImagejProbeWatch.pause;
import static org.palpate.platform.ImagejProbeWatch.threads;
import static org.palpate.platform.ImagejProbeWatch.threadsMoreThan;
import static org.palpate.platform.ImagejProbeWatch.usedAfterCollection;

import ij.IJ;
import ij.ImagePlus;
import ij.Menus;
import ij.Prefs;
import ij.WindowManager;
import ij.gui.GenericDialog;
import ij.measure.ResultsTable;
import ij.plugin.PlugIn;
import ij.plugin.frame.Recorder;
import java.awt.Dialog;
import java.awt.Menu;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.imageio.ImageIO;

/**
 * A plug-in that acts as a user inside the real ImageJ, by menu, dialog and macro. It writes its
 * observations to {@code facts.txt}, one per line, for the test outside. It uses Palpate only
 * through its commands.
 */
public final class ImagejProbe implements PlugIn {
  private static final String TOUCH = "org.palpate.imagej.TouchVolume";

  private final Path folder = Path.of(System.getProperty("probe.dir"));
  private final List<String> facts = new ArrayList<>();

  @Override
  public void run(String argument) {
    new Thread(this::scenario, "probe").start();
  }

  private void scenario() {
    int exitCode = 0;
    try {
      for (String part : List.of(System.getProperty("probe.parts").split(",", -1))) {
        play(part);
      }
      fact("end", "reached");
    } catch (Exception | LinkageError e) {
      fact("failed", e + " at " + Arrays.toString(e.getStackTrace()));
      fact("failed beside", ImagejProbeWatch.desk());
      exitCode = 1;
    }
    System.exit(exitCode);
  }

  private void play(String part) throws Exception {
    switch (part) {
      case "menu" -> menu();
      case "dialog" -> dialog();
      case "record" -> record();
      case "others" -> others();
      case "refuse" -> refuse();
      case "touch" -> touch();
      case "latency" -> latency();
      case "cycles" -> cycles();
      case "counts" -> counts();
      case "picture" -> picture();
      case "open" -> new ImagejProbeOpening(folder, this::fact).play();
      default -> throw new IllegalArgumentException("no such part: " + part);
    }
  }

  private void fact(String name, Object value) {
    facts.add(name + "=" + String.valueOf(value).replace("\n", "\\n"));
    try {
      Files.write(folder.resolve("facts.txt"), facts);
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  // --- the parts ---------------------------------------------------------------------------------

  private void menu() {
    List<String> items = new ArrayList<>();
    Menu plugins = find(Menus.getMenuBar().getMenuCount(), n -> Menus.getMenuBar().getMenu(n));
    for (int n = 0; n < plugins.getItemCount(); n++) {
      if (plugins.getItem(n) instanceof Menu menu && menu.getLabel().equals("Palpate")) {
        for (int i = 0; i < menu.getItemCount(); i++) {
          items.add(menu.getItem(i).getLabel());
        }
      }
    }
    fact("menu", items);
    fact("version", IJ.getVersion());
  }

  private static Menu find(int count, java.util.function.IntFunction<Menu> menus) {
    for (int n = 0; n < count; n++) {
      if (menus.apply(n).getLabel().equals("Plugins")) {
        return menus.apply(n);
      }
    }
    throw new IllegalStateException("there is no menu Plugins");
  }

  private void dialog() {
    ImagePlus ball = open("ball.tif");
    IJ.doCommand("Touch Volume...");
    GenericDialog dialog = awaitDialog("Touch Volume");
    fact("dialog", texts(dialog));
    press(dialog, "Cancel");
    await("the dialog to close", () -> !dialog.isShowing());
    fact("touching after cancel", touching());
    close(ball);
  }

  /** Runs commands by hand while the recorder is on, then the recorded lines one by one. */
  private void record() {
    ImagePlus ball = open("ball.tif");
    Recorder recorder = new Recorder();
    recordedSteps(recorder);
    String recorded = recorder.getText();
    recorder.close();
    Recorder.record = false;
    fact("recorded", recorded);
    long rows = rows("Palpate Landmarks");
    recorded.lines().filter(line -> line.startsWith("run(\"")).forEach(this::runAgain);
    fact("landmarks again", rows("Palpate Landmarks") - rows);
    fact("overlay", ball.getOverlay() == null ? 0 : ball.getOverlay().size());
    close(ball);
  }

  private void recordedSteps(Recorder recorder) {
    byHand("Touch Volume...", "Touch Volume", this::fillTouch);
    awaitRecorded(recorder, "Touch Volume...", "segment=ball");
    await("force", () -> Long.parseLong(call("frames")) > 200);
    fact("segments", call("segments"));
    byHand(
        "Landmarks...",
        "Landmarks",
        dialog -> {
          text(dialog, 0, "tip A");
          text(dialog, 1, folder.toString());
        });
    awaitRecorded(recorder, "Landmarks...", "Landmarks...");
    byHand("Correct Segment...", "Correct Segment", dialog -> number(dialog, 0, "4"));
    awaitRecorded(recorder, "Correct Segment...", "action=add");
    await("its being felt", () -> !call("segments").equals(first("segments")));
    fact("corrected", call("segments"));
    byHand("Correct Segment...", "Correct Segment", dialog -> choose(dialog, "undo"));
    awaitRecorded(recorder, "Correct Segment...", "action=undo");
    await("its being felt", () -> call("segments").equals(first("segments")));
    byHand("Correct Segment...", "Correct Segment", dialog -> choose(dialog, "redo"));
    awaitRecorded(recorder, "Correct Segment...", "action=redo");
    await("its being felt", () -> call("segments").equals(first("corrected")));
    byHand("Correct Segment...", "Correct Segment", dialog -> choose(dialog, "remove"));
    awaitRecorded(recorder, "Correct Segment...", "action=remove");
    await("its being felt", () -> !call("segments").equals(first("corrected")));
    IJ.doCommand("Stop Touching");
    awaitRecorded(recorder, "Stop Touching", "Stop Touching");
    await("the end", () -> !isTouching());
  }

  private void runAgain(String line) {
    boolean stop = line.contains("Stop Touching");
    IJ.runMacro(line);
    fact("again " + line.replaceAll("\\W+", " ").strip(), touching());
    if (stop) {
      await("the end", () -> !isTouching());
    }
  }

  private void fillTouch(GenericDialog dialog) {
    text(dialog, 0, "ball");
    number(dialog, 0, "100");
    number(dialog, 1, "255");
    text(dialog, 1, "ball=stiffness:0.3,friction:0");
    text(dialog, 2, "replay:" + folder.resolve("slide.csv"));
  }

  private void others() {
    ImagePlus ball = open("ball.tif");
    recordReplayAndJitter();
    recordTheRest();
    run("Touch Volume...", TOUCH_BALL + device("still.csv") + "time=0");
    IJ.setKeyDown(KeyEvent.VK_ESCAPE); // a macro call would reset the key, so none checks the end
    await("the end by Escape", () -> palpateThreads().isEmpty());
    fact("touching after Escape", touching());
    close(ball);
  }

  /** Runs commands by hand while the recorder is on, then the recorded lines. */
  private void recordReplayAndJitter() {
    Recorder recorder = new Recorder();
    byHand("Measure Jitter...", "Measure Jitter", dialog -> number(dialog, 0, "1"));
    awaitRecorded(recorder, "Measure Jitter...", "Measure Jitter...");
    String file = folder.resolve("short.csv").toString();
    byHand("Replay Trajectory...", "Replay Trajectory", dialog -> text(dialog, 0, file));
    GenericDialog second = awaitDialog("Replay Trajectory");
    number(second, 0, "100");
    number(second, 1, "255");
    press(second, "OK");
    awaitRecorded(recorder, "Replay Trajectory...", "Replay Trajectory...");
    String recorded = recorder.getText();
    recorder.close();
    Recorder.record = false;
    fact("recorded others", recorded);
    WindowManager.getWindow("Palpate Frames").dispose();
    recorded.lines().filter(line -> line.startsWith("run(\"")).forEach(IJ::runMacro);
    fact("jitter rows", rows("Palpate Jitter"));
    fact("replay rows", rows("Palpate Frames"));
  }

  private void recordTheRest() {
    Recorder recorder = new Recorder();
    Path taped = folder.resolve("taped.csv");
    Prefs.useJFileChooser = true;
    byHand("Record Trajectory...", "Record Trajectory", this::fillRecord);
    saveAs(taped);
    awaitRecorded(recorder, "Record Trajectory...", "Record Trajectory...");
    await("the recording", () -> !isTouching() && Files.exists(taped));
    fact("taped by hand", lines(taped).size());
    IJ.doCommand("Palpate Devices...");
    awaitRecorded(recorder, "Palpate Devices...", "Palpate Devices...");
    IJ.doCommand("About Palpate...");
    Dialog about = awaitAny("About Palpate");
    fact("about", texts(about));
    press(about, "OK");
    awaitRecorded(recorder, "About Palpate...", "About Palpate...");
    String recorded = recorder.getText();
    recorder.close();
    Recorder.record = false;
    fact("recorded the rest", recorded);
    delete(taped);
    WindowManager.getWindow("Palpate Devices").dispose();
    recorded.lines().filter(line -> line.startsWith("run(\"")).forEach(this::runAndAnswer);
    await("the recording", () -> !isTouching() && Files.exists(taped));
    fact("devices", WindowManager.getWindow("Palpate Devices") != null);
  }

  private void fillRecord(GenericDialog dialog) {
    fillTouch(dialog);
    number(dialog, 5, "1");
  }

  /** Runs a line and presses the button of its message, for which a macro waits too. */
  private void runAndAnswer(String line) {
    Thread macro = new Thread(() -> IJ.runMacro(line), "probe macro");
    macro.start();
    if (line.contains("About")) {
      press(awaitAny("About Palpate"), "OK");
    }
    await(line, () -> !macro.isAlive());
  }

  private static void delete(Path file) {
    try {
      Files.delete(file);
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  private void refuse() {
    ImagePlus colour = IJ.createImage("colour", "RGB black", 16, 16, 4);
    colour.show();
    IJ.doCommand("Touch Volume...");
    Dialog refusal = awaitAny("Touch Volume");
    fact("refused", texts(refusal));
    press(refusal, "OK");
    close(colour);
    ImagePlus several = IJ.createHyperStack("several", 16, 16, 2, 4, 3, 8);
    several.show();
    IJ.doCommand("Touch Volume...");
    Dialog question = awaitAny("Palpate");
    fact("asked", texts(question));
    press(question, "Cancel");
    close(several);
    IJ.doCommand("Landmarks...");
    Dialog idle = awaitAny("Landmarks");
    fact("idle", texts(idle));
    press(idle, "OK");
  }

  /** Touches under a recorded hand, paints into the image meanwhile, then closes it. */
  private void touch() {
    ImagePlus ball = open("ball.tif");
    run("Touch Volume...", TOUCH_BALL + device("slide.csv") + "time=0 view");
    await("the window", () -> redraws() > 0);
    long end = System.nanoTime() + Long.getLong("probe.seconds") * 1_000_000_000L;
    int painted = 0;
    while (System.nanoTime() < end && isTouching()) {
      IJ.runMacro(
          "setSlice("
              + (painted % 20 + 1)
              + "); setColor(200); fillOval(2, 2, 6, 6); updateDisplay();");
      painted++;
      pause(50);
    }
    fact("still touching", touching());
    fact("frames", call("frames"));
    fact("redraws", redraws());
    fact("painted", call("segments"));
    close(ball);
    await("the end with the image", () -> !isTouching());
    fact("touching after close", touching());
  }

  /** Measures how long an edit takes to reach hand and eye; the test only prints it. */
  private void latency() {
    ImagePlus ball = open("ball.tif");
    run("Touch Volume...", TOUCH_BALL + device("still.csv") + "time=0 view");
    await("the window", () -> redraws() > 0);
    pause(3000);
    List<Double> felt = new ArrayList<>();
    List<Double> seen = new ArrayList<>();
    for (int n = 0; n < 20; n++) {
      String before = call("segments");
      long drawn = redraws();
      int k = n % 10 + 1;
      ball.getStack().getProcessor(k).set(3 + n, 3, n % 2 == 0 ? 200 : 201);
      long began = System.nanoTime();
      ball.updateAndDraw();
      await("the edit to be felt", () -> !call("segments").equals(before));
      felt.add((System.nanoTime() - began) / 1e6);
      await("the edit to be seen", () -> redraws() > drawn);
      seen.add((System.nanoTime() - began) / 1e6);
      pause(150);
    }
    fact("felt ms", summary(felt));
    fact("seen ms", summary(seen));
    run("Stop Touching", "");
    close(ball);
  }

  private static String summary(List<Double> values) {
    List<Double> sorted = values.stream().sorted().toList();
    return String.format(
        java.util.Locale.ROOT,
        "median %.0f, largest %.0f",
        sorted.get(sorted.size() / 2),
        sorted.get(sorted.size() - 1));
  }

  private void cycles() {
    int count = Integer.getInteger("probe.cycles");
    int settled = 3;
    Map<String, Long> early = new TreeMap<>();
    for (int n = 1; n <= count; n++) {
      ImagePlus ball = open("ball.tif");
      run("Touch Volume...", TOUCH_BALL + device("still.csv") + "time=0 view");
      await("the window", () -> redraws() > 0);
      run("Stop Touching", "");
      close(ball);
      if (n == settled) {
        awaitQuietThreads();
        early.putAll(threads());
        fact("heap early", usedAfterCollection());
      }
    }
    await("the threads that came later to end", () -> threadsMoreThan(early).isEmpty());
    fact("heap late", usedAfterCollection());
    fact("threads", threads());
    fact("palpate threads", palpateThreads());
  }

  private void counts() {
    for (String line : lines(folder.resolve("counts.txt"))) {
      String[] parts = line.split("\t", -1);
      ImagePlus image =
          parts[1].endsWith("/") ? ij.plugin.FolderOpener.open(parts[1]) : open(parts[1]);
      if (parts[1].endsWith("/")) {
        image.show();
      }
      run("Touch Volume...", parts[2] + " device=simulated time=0");
      await("the session", this::isTouching);
      fact("counts " + parts[0], call("segments"));
      run("Stop Touching", "");
      close(image);
    }
  }

  private static final int RIGHT = 1034; // right of the 3-D window

  /** Arranges the desk during a session and saves a screenshot. */
  private void picture() throws Exception {
    ImagePlus image = open(System.getProperty("probe.picture"));
    image.setSlice(image.getStackSize() / 2);
    run(
        "Touch Volume...",
        System.getProperty("probe.options") + device("picture.csv") + "time=0 view");
    await("the window", () -> redraws() > 0);
    pause(Long.getLong("probe.pause"));
    run("Landmarks...", "name=temple save=[]");
    IJ.getInstance().setLocation(RIGHT, 0);
    image.getWindow().setLocation(RIGHT, 90);
    IJ.run(image, "In [+]", "");
    image.setSlice(Integer.getInteger("probe.slice"));
    WindowManager.getWindow("Palpate Landmarks").setBounds(RIGHT, 680, 560, 88);
    pause(1500);
    Rectangle all = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
    File file = folder.resolve("screen.png").toFile();
    ImageIO.write(new Robot().createScreenCapture(all), "png", file);
    run("Stop Touching", "");
    close(image);
  }

  // --- the session ----------------------------------------------------------------------------

  private static final String TOUCH_BALL =
      "segment=ball lower=100 upper=255 solver=guarded stiffness=0 friction=0.20 ";

  private String device(String file) {
    return "device=[replay:" + folder.resolve(file) + "] ";
  }

  private ImagePlus open(String name) {
    IJ.open(folder.resolve(name).toString());
    return IJ.getImage();
  }

  private static void close(ImagePlus image) {
    image.changes = false;
    image.close();
  }

  private static void run(String command, String options) {
    IJ.runMacro("run(\"" + command + "\", \"" + options.strip() + "\");");
  }

  private static String call(String method) {
    return IJ.runMacro("return call(\"" + TOUCH + "." + method + "\");");
  }

  private String touching() {
    return call("isTouching");
  }

  private boolean isTouching() {
    return touching().equals("true");
  }

  private static long redraws() {
    return Long.parseLong(call("redraws"));
  }

  private static long rows(String table) {
    ResultsTable found = ResultsTable.getResultsTable(table);
    return found == null ? 0 : found.size();
  }

  private String first(String name) {
    return facts.stream()
        .filter(line -> line.startsWith(name + "="))
        .map(line -> line.substring(name.length() + 1).replace("\\n", "\n"))
        .findFirst()
        .orElseThrow();
  }

  private static List<String> lines(Path file) {
    try {
      return Files.readAllLines(file);
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }
}
