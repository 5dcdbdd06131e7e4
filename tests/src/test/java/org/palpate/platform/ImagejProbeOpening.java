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
    IJ.saveAs(image, "Tiff", folder.resolve("saved.tif").toString());
    image.changes = false;
    image.close();
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
