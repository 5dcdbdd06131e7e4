package org.palpate.imagej.session;

import ij.CommandListener;
import ij.ImagePlus;
import ij.WindowManager;
import ij.plugin.frame.Recorder;
import java.util.function.BooleanSupplier;

/**
 * Lets ImageJ's own Edit > Undo take back brush strokes. ImageJ itself remembers one slice at most,
 * and a stroke reaches through several. ImageJ calls it on the thread of the command.
 */
final class StrokeUndo implements CommandListener {
  private static final String UNDO = "Undo";

  private final ImagePlus image;
  private final BooleanSupplier undo;

  /**
   * Creates a listener for ImageJ's commands.
   *
   * @param image the touched stack
   * @param undo takes back the last stroke; returns false if that is ImageJ's turn
   */
  StrokeUndo(ImagePlus image, BooleanSupplier undo) {
    this.image = image;
    this.undo = undo;
  }

  @Override
  public String commandExecuting(String command) {
    boolean isUndone =
        UNDO.equals(command) && WindowManager.getCurrentImage() == image && undo.getAsBoolean();
    if (isUndone && Recorder.record) {
      Recorder.record("run", UNDO);
    }
    return isUndone ? null : command;
  }
}
