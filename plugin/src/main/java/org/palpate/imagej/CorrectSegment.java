package org.palpate.imagej;

import ij.IJ;
import ij.gui.GenericDialog;
import org.palpate.imagej.annotation.StrokeHistory;
import org.palpate.imagej.dialog.HelpText;
import org.palpate.imagej.session.CurrentSession;
import org.palpate.imagej.session.StackSession;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * "Correct Segment...": adds or removes the voxels of a ball around the interaction point, or
 * undoes and redoes that.
 *
 * <p>The stack, the force and the 3-D window change together. Save the stack to keep the
 * correction. In the 3-D window the keys a, x, z and y do the same without a dialog.
 */
public final class CorrectSegment extends PalpateCommand {
  private static final String ADD = "add";
  private static final String REMOVE = "remove";
  private static final String UNDO = "undo";
  private static final String REDO = "redo";

  /** Creates the command; ImageJ calls this. */
  public CorrectSegment() {
    super("Correct Segment");
  }

  @Override
  void execute() throws TouchRefusedException {
    StackSession session = CurrentSession.current();
    GenericDialog dialog = new GenericDialog("Correct Segment");
    String[] actions = {ADD, REMOVE, UNDO, REDO};
    dialog.addChoice("Action", actions, ADD);
    dialog.addNumericField("Radius", StrokeHistory.lastRadiusMm(), 2, 8, "mm");
    HelpText.addTo(dialog);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return;
    }
    String action = dialog.getNextChoice();
    double radiusMm = dialog.getNextNumber();
    if (dialog.invalidNumber() || !(radiusMm > 0)) {
      throw new TouchRefusedException("The radius must be a positive number of mm.");
    }
    StrokeHistory.keepRadiusMm(radiusMm);
    int changed =
        switch (action) {
          case UNDO -> session.undo();
          case REDO -> session.redo();
          default -> session.paint(radiusMm, action.equals(ADD));
        };
    IJ.showStatus("Palpate: " + changed + " voxels changed");
  }
}
