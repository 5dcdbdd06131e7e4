package org.palpate.platform;

import static org.palpate.platform.ImagejProbeDialogs.awaitRecorded;
import static org.palpate.platform.ImagejProbeDialogs.byHand;
import static org.palpate.platform.ImagejProbeDialogs.text;
import static org.palpate.platform.ImagejProbeWatch.await;

import ij.IJ;
import ij.ImagePlus;
import ij.WindowManager;
import ij.measure.Calibration;
import ij.plugin.frame.Recorder;
import java.nio.file.Path;
import java.util.function.BiConsumer;

/** Opens volumes inside the real ImageJ, by hand and by the recorded macro. */
final class ImagejProbeOpening {
  private final Path folder;
  private final BiConsumer<String, Object> facts;

  ImagejProbeOpening(Path folder, BiConsumer<String, Object> facts) {
    this.folder = folder;
    this.facts = facts;
  }

  /** Opens labels by hand, then again by the recorded line, touches them, and saves them. */
  void play() {
    String file = folder.resolve("two labels.nrrd").toString();
    Recorder recorder = new Recorder();
    byHand("Open Volume...", "Open Volume", dialog -> text(dialog, 0, file));
    awaitRecorded(recorder, "Open Volume...", "Open Volume...");
    await("the stack", () -> WindowManager.getCurrentImage() != null);
    String recorded = recorder.getText();
    recorder.close();
    Recorder.record = false;
    facts.accept("recorded opening", recorded);
    facts.accept("opened by hand", words(IJ.getImage()));
    IJ.getImage().close();
    recorded.lines().filter(line -> line.startsWith("run(\"")).forEach(IJ::runMacro);
    ImagePlus image = IJ.getImage();
    facts.accept("opened by macro", words(image));
    IJ.runMacro("run(\"Touch Volume...\", \"labels device=simulated time=0\");");
    await("the session", () -> call("isTouching").equals("true"));
    facts.accept("opened segments", call("segments"));
    IJ.runMacro("run(\"Stop Touching\");");
    await("the end", () -> call("isTouching").equals("false"));
    place();
    IJ.selectWindow(image.getTitle());
    IJ.saveAs(image, "Tiff", folder.resolve("saved.tif").toString());
    image.changes = false;
    image.close();
  }

  /** Places a label by macro lines, and reads the stack that the session leaves. */
  private void place() {
    IJ.runMacro("run(\"Place Fragments...\", \"fixed=0 device=simulated time=0\");");
    await("the placing", () -> call("isTouching").equals("true"));
    facts.accept("moved", placing("move\", \"upper jaw\", \"0,0,40,1,0,0,0"));
    facts.accept("not moved", placing("move\", \"lower jaw\", \"0,0,40,1,0,0,0"));
    await("the pose", () -> placing("pose\", \"upper jaw").startsWith("0.0,0.0,40.0,"));
    IJ.runMacro("run(\"Stop Touching\");");
    await("the end", () -> call("isTouching").equals("false"));
    ImagePlus placed = IJ.getImage();
    facts.accept("placed", words(placed));
    long voxels = 0;
    for (int k = 0; k < placed.getStackSize(); k++) {
      for (int v = 0; v < placed.getWidth() * placed.getHeight(); v++) {
        voxels += placed.getStack().getProcessor(k + 1).get(v) > 0 ? 1 : 0;
      }
    }
    facts.accept("placed voxels", voxels);
    placed.changes = false;
    placed.close();
  }

  private static String placing(String words) {
    return IJ.runMacro("return call(\"org.palpate.imagej.PlaceFragments." + words + "\");");
  }

  private static String call(String function) {
    return IJ.runMacro("return call(\"org.palpate.imagej.TouchVolume." + function + "\");");
  }

  private static String words(ImagePlus image) {
    Calibration calibration = image.getCalibration();
    return image.getTitle()
        + " "
        + image.getStackSize()
        + " "
        + calibration.pixelWidth
        + "x"
        + calibration.pixelHeight
        + "x"
        + calibration.pixelDepth
        + " "
        + calibration.getUnit()
        + " at "
        + calibration.getX(0.5);
  }
}
