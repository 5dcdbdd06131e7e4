package org.palpate.imagej;

import ij.IJ;
import ij.gui.GenericDialog;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.dialog.FilePaths;
import org.palpate.imagej.dialog.HelpText;
import org.palpate.imagej.session.CurrentSession;
import org.palpate.imagej.session.StackSession;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * "Landmarks...": adds a named landmark at the interaction point to the table "Palpate Landmarks"
 * and to the stack's overlay.
 *
 * <p>It saves all landmarks if the user gives a folder. In the 3-D window the key m does the same
 * without a dialog.
 */
public final class Landmarks extends PalpateCommand {
  /** Creates the command; ImageJ calls this. */
  public Landmarks() {
    super("Landmarks");
  }

  @Override
  void execute() throws TouchRefusedException {
    StackSession session = CurrentSession.current();
    Vec3 grid = session.touchedPointGrid();
    GenericDialog dialog = new GenericDialog("Landmarks");
    dialog.addStringField("Name", session.landmarks().nextName(), 16);
    dialog.addDirectoryField("Save in folder (or empty)", "", 24);
    HelpText.addTo(dialog);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return;
    }
    String name = dialog.getNextString();
    String folder = dialog.getNextString().strip();
    session.landmarks().add(name, grid);
    if (!folder.isEmpty()) {
      session.landmarks().save(FilePaths.of("folder", folder));
      IJ.showStatus("Palpate: landmarks saved in " + folder);
    }
  }
}
